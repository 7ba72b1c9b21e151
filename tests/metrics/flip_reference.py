#!/usr/bin/env python3
"""FLIP a second time: slow, plain and in double precision, from the papers and independent of demos/metrics.

Prints the constants of flip_test.cpp. Both sides paint the same pictures by whole numbers, so nothing is stored.
Every filter here is a dense two-dimensional kernel, which is what the papers define; the C++ side separates them.
Needs numpy:  python3 tests/metrics/flip_reference.py
"""
import numpy as np

PPD = 0.7 * 3840 / 0.7 * np.pi / 180
WIDTH, HEIGHT = 64, 48


def paint(test):
    """Bytes: a sawtooth of colour, a disc, stripes. The test lacks the disc, shifts the stripes, tints a corner."""
    y, x = np.mgrid[0:HEIGHT, 0:WIDTH]
    picture = np.empty((HEIGHT, WIDTH, 3), dtype=np.int64)
    for c in range(3):
        picture[..., c] = (3 * x + 2 * y + 60 * c) % 256
    if not test:
        picture[(x - 20) ** 2 + (y - 14) ** 2 < 49] = (230, 90, 30)
    stripes = (x >= 36) & (y < 20)
    on = (x + (1 if test else 0)) // 3 % 2 == 0
    picture[stripes] = np.where(on[..., None], (250, 240, 200), (20, 30, 60))[stripes]
    if test:
        corner = (x < 24) & (y >= 32)
        picture[..., 2][corner] = np.minimum(picture[..., 2][corner] + 12, 255)
    return picture


def light(test):
    """Linear, over some ten stops: the bytes squared, each column of eight twice as bright as the one before."""
    x = np.arange(WIDTH)[None, :, None]
    return (paint(test) / 255.0) ** 2 * 2.0 ** (x // 8 - 3)


# Colour: sRGB (IEC 61966-2-1), CIE XYZ, L*a*b*, and YCxCz, which is L*a*b* without the cube root.
XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = XYZ @ np.ones(3)


def decode(srgb):
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def opponent_axes(xyz):
    x, y, z = np.moveaxis(xyz, -1, 0)
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def to_opponent(rgb):
    return opponent_axes(rgb @ XYZ.T / WHITE)


def from_opponent(opponent):
    y = (opponent[..., 0] + 16) / 116
    xyz = np.stack([y + opponent[..., 1] / 500, y, y - opponent[..., 2] / 200], axis=-1)
    return (xyz * WHITE) @ np.linalg.inv(XYZ).T


def hunt_lab(rgb):
    xyz, edge = rgb @ XYZ.T / WHITE, 6 / 29
    lab = opponent_axes(np.where(xyz > edge ** 3, np.cbrt(xyz), xyz / (3 * edge ** 2) + 4 / 29))
    lab[..., 1:] *= 0.01 * lab[..., :1]
    return lab


def hyab(a, b):
    return np.abs(a[..., 0] - b[..., 0]) + np.hypot(a[..., 1] - b[..., 1], a[..., 2] - b[..., 2])


# Filters.
def dense(image, kernel):
    radius = kernel.shape[0] // 2
    padded = np.pad(image, radius, mode='edge')
    result = np.zeros(image.shape)
    for dy in range(kernel.shape[0]):
        for dx in range(kernel.shape[1]):
            result += kernel[dy, dx] * padded[dy:dy + image.shape[0], dx:dx + image.shape[1]]
    return result


def csf(gaussians):
    """The sum of a * sqrt(pi / b) * exp(-pi^2 r^2 / b) over (a, b), r in degrees; sums to 1."""
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * PPD))
    y, x = np.mgrid[-radius:radius + 1, -radius:radius + 1] / PPD
    kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * (x * x + y * y) / b) for a, b in gaussians)
    return kernel / kernel.sum()


CSF = [csf([(1, 0.0047)]), csf([(1, 0.0053)]), csf([(34.1, 0.04), (13.5, 0.025)])]


def detectors():
    deviation = 0.5 * 0.082 * PPD
    radius = int(np.ceil(3 * deviation))
    y, x = np.mgrid[-radius:radius + 1, -radius:radius + 1]
    bell = np.exp(-(x * x + y * y) / (2 * deviation ** 2))
    for kernel in (-x * bell, (x * x / deviation ** 2 - 1) * bell):
        yield np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), -kernel / kernel[kernel < 0].sum())


def strength(lightness, kernel):
    return np.hypot(dense(lightness, kernel), dense(lightness, kernel.T))


# The metric.
def flip(reference, test):
    """Of linear light, 0..1."""
    a, b = to_opponent(reference), to_opponent(test)

    def seen(opponent):
        filtered = np.stack([dense(opponent[..., c], CSF[c]) for c in range(3)], axis=-1)
        return hunt_lab(np.clip(from_opponent(filtered), 0, 1))

    greatest = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))) ** 0.7
    color, knee = hyab(seen(a), seen(b)) ** 0.7, 0.4 * greatest
    color = np.where(color < knee, 0.95 * color / knee, 0.95 + 0.05 * (color - knee) / (greatest - knee))
    lightness = [(p[..., 0] + 16) / 116 for p in (a, b)]
    feature = np.max([np.abs(strength(lightness[0], k) - strength(lightness[1], k)) for k in detectors()], axis=0)
    return color ** (1 - np.sqrt(feature / np.sqrt(2)))


def aces(x):
    x = 0.6 * x
    return np.clip(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0, 1)


def hdr_flip(reference, test):
    shown = max(np.roots([2.51 - 0.85 * 2.43, 0.03 - 0.85 * 0.59, -0.85 * 0.14])) / 0.6
    luminance = reference @ np.array([0.2126, 0.7152, 0.0722])
    start, stop = np.log2(shown / luminance.max()), np.log2(shown / np.median(luminance))
    count = max(2, int(np.ceil(stop - start)))
    maps = [flip(aces(2.0 ** ev * reference), aces(2.0 ** ev * test)) for ev in np.linspace(start, stop, count)]
    return np.max(maps, axis=0), start, stop, count


def report(name, error):
    print(f'{name}: mean {error.mean():.8f} max {error.max():.6f}')
    spots = [(0, 0), (20, 14), (27, 14), (45, 10), (36, 0), (12, 40), (24, 32), (63, 47)]
    print('  ' + ', '.join(f'{{{x}, {y}, {error[y, x]:.6f}}}' for x, y in spots))


if __name__ == '__main__':
    report('display', flip(decode(paint(False) / 255.0), decode(paint(True) / 255.0)))
    error, start, stop, count = hdr_flip(light(False), light(True))
    report('linear', error)
    print(f'  exposures {start:.6f} .. {stop:.6f}, {count}')
    white = flip(np.zeros((8, 8, 3)), np.ones((8, 8, 3)))
    print(f'black to white: {white[4, 4]:.6f}')
