#!/usr/bin/python3
"""Makes the skies of the demo scenes, NAME_sky.exr, and prints the suns that belong to them.

Lat-long, linear, 2:1. Row 0 looks straight up (+Y), the last row straight down; column x looks along azimuth
360 (x + 0.5) / width degrees, from +X towards +Z. The sun's disc is left out: the renderer adds it.

    make_skies.py [name ...]
"""
import pathlib
import sys
from dataclasses import dataclass, field

import numpy as np
import OpenImageIO as oiio

from sky.atmosphere import Atmosphere
from sky.clouds import CloudDesc, Clouds

WIDTH, HEIGHT = 2048, 1024
ROWS = 32  # worked on at once
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


@dataclass
class SkyDesc:
    sunAzimuthDeg: float
    sunElevationDeg: float
    haze: float  # 1 is clean air
    meanLuminance: float  # of the upper half: sets the scale of everything
    ground: tuple  # what lies below the haze of the horizon, as a share of the horizon's light
    clouds: CloudDesc = field(default_factory=CloudDesc)
    rain: float = 0.0  # optical depth, straight up, of rain and spray below the clouds
    overcast: float = 0.0  # share of all light that clouds have scattered until it is grey


SKIES = {
    "harbour": SkyDesc(
        sunAzimuthDeg=48,
        sunElevationDeg=14,
        haze=2.2,
        meanLuminance=0.33,
        ground=(0.16, 0.19, 0.20),
        clouds=CloudDesc(seed=5, coverage=0.58, offsetM=(36600, 23700), cirrus=0.32),
    ),
    "ocean": SkyDesc(
        sunAzimuthDeg=298,
        sunElevationDeg=7.5,
        haze=2.0,
        meanLuminance=0.30,
        ground=(0.12, 0.15, 0.17),
        clouds=CloudDesc(seed=9, coverage=0.62, baseM=1000, thicknessM=1300, offsetM=(19400, 12800), cirrus=0.4),
    ),
    "lake": SkyDesc(
        sunAzimuthDeg=42,
        sunElevationDeg=8,
        haze=1.8,
        meanLuminance=0.30,
        ground=(0.16, 0.19, 0.20),
        clouds=CloudDesc(seed=12, coverage=0.50, baseM=2300, thicknessM=700, offsetM=(30200, 9100), cirrus=0.7),
    ),
    "pool": SkyDesc(
        sunAzimuthDeg=38,
        sunElevationDeg=46,
        haze=1.4,
        meanLuminance=0.55,
        ground=(0.22, 0.24, 0.24),
        clouds=CloudDesc(seed=21, coverage=0.52, offsetM=(5200, 17700), cirrus=0.25),
    ),
    "storm": SkyDesc(
        sunAzimuthDeg=285,
        sunElevationDeg=16,
        haze=3.0,
        meanLuminance=0.16,
        ground=(0.20, 0.24, 0.26),
        clouds=CloudDesc(seed=31, coverage=0.94, baseM=800, thicknessM=1500, offsetM=(21000, 4000), cirrus=1.0),
        rain=0.16,
        overcast=0.75,
    ),
}


def directions(width, height):
    """Unit vectors [height, width, 3] of the picture's pixels."""
    elevation = np.pi / 2 - np.pi * (np.arange(height) + 0.5) / height
    azimuth = 2 * np.pi * (np.arange(width) + 0.5) / width
    e, a = np.meshgrid(elevation, azimuth, indexing="ij")
    return np.stack([np.cos(e) * np.cos(a), np.sin(e), np.cos(e) * np.sin(a)], -1)


def sunDirection(desc):
    e, a = np.radians(desc.sunElevationDeg), np.radians(desc.sunAzimuthDeg)
    return np.array([np.cos(e) * np.cos(a), np.sin(e), np.cos(e) * np.sin(a)])


def clearSky(air, desc, d):
    toSun = sunDirection(desc)
    away = np.cos(np.arctan2(d[..., 2], d[..., 0]) - np.radians(desc.sunAzimuthDeg))
    return air.sky(d[..., 1], away, np.clip(d @ toSun, -1, 1))


def upperHalf(air, desc, d):
    """Radiance of the rows above the horizon without and with clouds, for a sun of irradiance 1 outside the air."""
    toSun = sunDirection(desc)
    clouds = Clouds(desc.clouds)
    clear = clearSky(air, desc, d)
    skylight = irradiance(clear, d)
    sunlight = air.sunIrradiance(desc.clouds.baseM + desc.clouds.thicknessM / 2)
    groundlight = 0.12 * (skylight + air.sunIrradiance() * toSun[1])
    layer = np.empty(d.shape[:2] + (5,))
    behind = np.empty_like(clear)
    for row in range(0, d.shape[0], ROWS):
        part = slice(row, row + ROWS)
        rays = d[part].reshape(-1, 3)
        light, opacity, distance = clouds.cirrus(rays, toSun, air.sunIrradiance(desc.clouds.cirrusHeightM), skylight)
        behind[part] = through(air, clear[part], clear[part], *shaped(d[part], light, opacity, distance * 0.25))
        light, opacity, distance = clouds.march(
            rays, toSun, sunlight, skylight, groundlight, spread(d[part].shape, row)
        )
        layer[part] = np.concatenate(shaped(d[part], light, opacity[:, None], distance[:, None] * opacity[:, None]), -1)
    layer = soften(layer)
    distance = layer[..., 4] / np.maximum(layer[..., 3], 1e-4)
    sky = through(air, behind, clear, layer[..., :3], layer[..., 3], distance)
    return clear, greyed(rained(sky, desc.rain, d), desc.overcast)


def rained(sky, depth, d):
    """Behind a grey veil as bright as the clouds are in the mean, thicker the lower one looks."""
    veil = 1 - np.exp(-depth / np.maximum(d[..., 1], 0.01))[..., None]
    grey = irradiance(sky, d) @ LUMINANCE / np.pi * np.array([0.62, 0.68, 0.72])
    return sky * (1 - veil) + grey * veil


def greyed(sky, share):
    """Drops scatter all colours alike: what went through many of them is as white as daylight, a little bluish."""
    return sky * (1 - share) + (sky @ LUMINANCE)[..., None] * np.array([0.96, 1.0, 1.06]) * share


def shaped(like, *values):
    return [v.reshape(like.shape[:2] + v.shape[1:]) for v in values]


def spread(shape, row):
    """Where in its first step each ray of a block starts, 0..1: neighbours differ as much as they can (R2 sequence)."""
    y, x = np.mgrid[row : row + shape[0], 0 : shape[1]]
    return ((0.7548776662 * x + 0.5698402910 * y) % 1).ravel()


def soften(layer):
    """A tent over 3 by 3 pixels: takes out the pattern that spread() leaves."""
    layer = (np.roll(layer, 1, 1) + 2 * layer + np.roll(layer, -1, 1)) / 4
    rows = np.concatenate([layer[:1], layer, layer[-1:]])
    return (rows[:-2] + 2 * rows[1:-1] + rows[2:]) / 4


def through(air, behind, clear, light, opacity, distance):
    """A cloud in front of what is behind it, with air as bright as the clear sky between it and the eye."""
    left = air.airlight(distance)
    return behind * (1 - opacity[..., None]) + left * light + (1 - left) * clear * opacity[..., None]


def irradiance(radiance, d):
    """On the level ground."""
    weight = np.sqrt(1 - d[..., 1] ** 2) * (np.pi / HEIGHT) * (2 * np.pi / WIDTH)
    return np.einsum("yxc,yx,yx->c", radiance, weight, d[..., 1])


def lowerHalf(horizon, d, ground):
    """The horizon's light fading downwards into haze and then water."""
    down = np.degrees(-np.arcsin(d[..., 1]))[..., None]
    kernel = np.hanning(129)
    wide = np.concatenate([horizon[-64:], horizon, horizon[:64]])
    soft = np.stack([np.convolve(wide[:, c], kernel / kernel.sum(), "valid") for c in range(3)], -1)
    mean = soft.mean(0)
    level = soft[None] + (mean - soft[None]) * (1 - np.exp(-down / 9))
    sharp = horizon[None] * np.exp(-down / 1.0) + level * (1 - np.exp(-down / 1.0))
    fade = np.exp(-down / 5)
    return sharp * (fade + (1 - fade) * np.array(ground))


def makeSky(name, desc, folder):
    air = Atmosphere(desc.haze, desc.sunElevationDeg)
    d = directions(WIDTH, HEIGHT)
    half = HEIGHT // 2
    clear, upper = upperHalf(air, desc, d[:half])
    area = np.sqrt(1 - d[:half, :, 1] ** 2)
    scale = desc.meanLuminance / ((upper @ LUMINANCE * area).sum() / area.sum())
    horizon = upper[-1] if desc.rain > 0 else clear[-1]
    picture = np.concatenate([upper, lowerHalf(horizon, d[half:], desc.ground)]) * scale
    assert np.isfinite(picture).all() and picture.min() >= 0
    path = folder / f"{name}_sky.exr"
    write(path, picture.astype(np.float32))
    sun = air.sunIrradiance() * scale
    sky = irradiance(upper, d[:half]) * scale
    print(f"{path.name}: {path.stat().st_size} bytes, greatest radiance {picture.max():.2f}")
    print(
        f"  [sun] azimuth_deg = {desc.sunAzimuthDeg}, elevation_deg = {desc.sunElevationDeg}, "
        f"irradiance = [{sun[0]:.3f}, {sun[1]:.3f}, {sun[2]:.3f}]"
    )
    print(f"  sky irradiance on the level ground [{sky[0]:.3f}, {sky[1]:.3f}, {sky[2]:.3f}]")


def write(path, picture):
    spec = oiio.ImageSpec(picture.shape[1], picture.shape[0], 3, oiio.HALF)
    spec.attribute("compression", "dwab:70")
    spec.attribute("DateTime", "")
    out = oiio.ImageOutput.create(str(path))
    if not out or not out.open(str(path), spec) or not out.write_image(picture):
        sys.exit(f"{path}: {oiio.geterror() or out.geterror()}")
    out.close()


def main():
    names = sys.argv[1:] or list(SKIES)
    for name in names:
        if name not in SKIES:
            sys.exit(f"make_skies.py: no sky called '{name}', expected one of {', '.join(SKIES)}")
        makeSky(name, SKIES[name], pathlib.Path(__file__).parent)


if __name__ == "__main__":
    main()
