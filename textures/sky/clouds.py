"""Clouds: a layer of cumulus marched through as a volume, and a sheet of cirrus above it.

The volume follows the usual recipe of a weather map, a shape noise and a detail noise (Schneider and Vos 2015, "The
Real-time Volumetric Cloudscapes of Horizon: Zero Dawn"); light scattered many times is the sum of attenuated octaves of
Wrenninge 2013. The layer lies on the sphere of the Earth, so that it comes down to the horizon.
"""
from dataclasses import dataclass

import numpy as np

from . import noise
from .atmosphere import EARTH


@dataclass
class CloudDesc:
    seed: int = 1
    baseM: float = 1100
    thicknessM: float = 900
    coverage: float = 0.45  # share of the sky the weather map leaves to clouds, roughly
    extinctionPerM: float = 0.03
    weatherTileM: float = 38e3
    shapeTileM: float = 4200
    detailTileM: float = 760
    offsetM: tuple = (0.0, 0.0)  # moves the layer over the eye: choose the picture
    cirrus: float = 0.3  # optical depth of the thickest cirrus
    cirrusHeightM: float = 8500
    sunGain: float = 2.2
    skyGain: float = 1.2


def henyey(cosine, g):
    return (1 - g * g) / (4 * np.pi * (1 + g * g - 2 * g * cosine) ** 1.5)


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


class Clouds:
    def __init__(self, desc):
        self.desc = desc
        s = desc.seed * 100
        weather = noise.fractal(noise.gradient, 512, 7, 5, s, 2, 0.55)
        patches = noise.fractal(noise.gradient, 512, 3, 3, s + 20, 2)
        self.weather = np.clip(0.5 + 0.75 * weather + 0.35 * patches, 0, 1).astype(np.float32)
        billow = (
            0.52 * noise.cellular(96, 5, s + 31)
            + 0.30 * noise.cellular(96, 11, s + 32)
            + 0.18 * noise.cellular(96, 23, s + 33)
        )
        rolling = noise.fractal(noise.gradient, 96, 4, 3, s + 34, 3)
        self.shape = np.clip(0.12 + 0.95 * billow + 0.35 * rolling, 0, 1).astype(np.float32)
        self.detail = (
            0.45 * noise.cellular(48, 4, s + 41)
            + 0.33 * noise.cellular(48, 8, s + 42)
            + 0.22 * noise.cellular(48, 16, s + 43)
        ).astype(np.float32)
        self.streaks = noise.fractal(noise.gradient, 512, 6, 6, s + 51, 2, 0.6).astype(np.float32)

    # --- where the water is -----------------------------------------------------------------------------------------

    def _cover(self, x, z):
        d = self.desc
        c, s = np.cos(0.51), np.sin(0.51)
        u = (c * x - s * z + d.offsetM[0]) / d.weatherTileM
        v = (s * x + c * z + d.offsetM[1]) / d.weatherTileM
        return smoothstep(0, 0.55, noise.sample2(self.weather, u, v) - (1 - d.coverage))

    def _density(self, x, h, z, cover, fine):
        """Relative density 0..1 where the layer covers; `h` is the height in the layer, 0..1."""
        d = self.desc
        c, s = np.cos(1.13), np.sin(1.13)
        xr, zr = c * x - s * z, s * x + c * z
        y = h * d.thicknessM
        shape = noise.sample3(self.shape, xr / d.shapeTileM, y / d.shapeTileM, zr / d.shapeTileM)
        top = 0.25 + 0.75 * cover
        profile = smoothstep(0, 0.09, h) * (1 - smoothstep(0.35 * top, top, h))
        base = shape - (1 - cover * profile * 0.86)
        if fine:
            wisp = noise.sample3(self.detail, xr / d.detailTileM, y / d.detailTileM, zr / d.detailTileM)
            base = base - (1 - wisp) * 0.46 * (1 - np.clip(base * 1.4, 0, 1))
        return smoothstep(0, 0.17, base)

    # --- light ------------------------------------------------------------------------------------------------------

    def march(self, direction, toSun, sunlight, skylight, groundlight, start, steps=52):
        """For rays [n,3] up from the eye: radiance scattered to it [n,3], opacity [n], mean distance [n] in metres.
        `start` [n], 0..1, is where in its first step each begins."""
        d = self.desc
        mu = direction[:, 1]
        level = np.hypot(direction[:, 0], direction[:, 2])
        near = shell(mu, d.baseM)
        far = np.minimum(shell(mu, d.baseM + d.thicknessM), near + 10e3)
        ds = (far - near) / steps
        n = len(mu)
        light, through = np.zeros((n, 3)), np.ones(n)
        reach, weight = np.zeros(n), np.full(n, 1e-6)
        cosine = direction @ toSun
        phases = [0.72 * henyey(cosine, 0.82 * c) + 0.28 * henyey(cosine, -0.25 * c) for c in (1, 0.55, 0.25)]
        for k in range(steps):
            t = near + (k + start) * ds
            x, z = t * direction[:, 0], t * direction[:, 2]
            h = (t * mu + (t * level) ** 2 / (2 * EARTH) - d.baseM) / d.thicknessM
            cover = self._cover(x, z)
            live = np.flatnonzero((cover > 0.02) & (through > 0.01) & (h > 0) & (h < 1))
            if not len(live):
                continue
            density = self._density(x[live], h[live], z[live], cover[live], True)
            keep = density > 0.002
            live, density = live[keep], density[keep]
            if not len(live):
                continue
            sigma = density * d.extinctionPerM
            depth = self._sunDepth(x[live], h[live], z[live], toSun)
            source = np.zeros(len(live))
            for i, p in enumerate(phases):
                source += (0.62**i) * p[live] * np.exp(-depth * 0.38**i)
            powder = 1 - 0.55 * np.exp(-2.2 * sigma * 130)
            high = h[live]
            ambient = (skylight * (0.35 + 0.65 * high[:, None]) + groundlight * (1 - high[:, None]) * 0.5) * d.skyGain
            glow = source[:, None] * d.sunGain * powder[:, None] * sunlight + ambient / (4 * np.pi) * 3.0
            step = np.exp(-sigma * ds[live])
            absorbed = through[live] * (1 - step)
            light[live] += absorbed[:, None] * glow
            reach[live] += absorbed * t[live]
            weight[live] += absorbed
            through[live] *= step
        return light, 1 - through, reach / weight

    def _sunDepth(self, x, h, z, toSun):
        d = self.desc
        depth = np.zeros(len(x))
        before = 0.0
        for distance in (45.0, 130.0, 300.0, 650.0):
            middle = (before + distance) / 2
            hs = h + middle * toSun[1] / d.thicknessM
            xs, zs = x + middle * toSun[0], z + middle * toSun[2]
            inside = hs < 1
            density = np.zeros(len(x))
            at = np.flatnonzero(inside)
            if len(at):
                density[at] = self._density(xs[at], hs[at], zs[at], self._cover(xs[at], zs[at]), False)
            depth += density * d.extinctionPerM * (distance - before)
            before = distance
        return depth

    def cirrus(self, direction, toSun, sunlight, skylight):
        """Radiance [n,3] and opacity [n] of the sheet of ice above."""
        d = self.desc
        t = shell(direction[:, 1], d.cirrusHeightM)
        x, z = t * direction[:, 0] / 52e3, t * direction[:, 2] / 52e3
        c, s = np.cos(2.3), np.sin(2.3)
        u, v = c * x - s * z, s * x + c * z
        bend = noise.sample2(self.streaks, u * 0.6 + 0.3, v * 0.6) * 0.10
        fibre = noise.sample2(self.streaks, u * 0.55 + bend, v * 2.6 + bend * 2)
        patch = noise.sample2(self.streaks, u * 0.4 + 0.7, v * 0.4 + 0.2)
        amount = smoothstep(0.05, 0.75, 0.5 * fibre + patch + 0.15) * np.clip(0.6 + fibre, 0, 1)
        slant = 1 / np.maximum(direction[:, 1] + 0.12, 0.12)
        opacity = 1 - np.exp(-d.cirrus * amount * np.minimum(slant, 4))
        cosine = direction @ toSun
        phase = 0.55 * henyey(cosine, 0.75) + 0.45 * henyey(cosine, 0.05)
        light = opacity[:, None] * (phase[:, None] * 2.2 * sunlight + 0.25 * skylight / np.pi)
        return light, opacity, t


def shell(mu, height):
    """Distance from the ground to a sphere at this height, along rays with this sine of elevation."""
    return -EARTH * mu + np.sqrt((EARTH * mu) ** 2 + 2 * EARTH * height + height * height)
