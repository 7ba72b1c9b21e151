"""Coconut palms and dune grass."""
import numpy as np

from . import shape
from .shape import rgb


def frond(rng, long):
    """Along +x from the crown: a spine that arches and droops, leaflets to both sides."""
    t = np.linspace(0, 1, 13)
    droop = rng.uniform(0.55, 1.0)
    rise = rng.uniform(0.25, 0.75)
    spine = np.stack([long * t * (1 - 0.18 * t), long * (rise * t - (rise + 0.25 + 0.45 * droop) * t**2.2), 0 * t], 1)
    corners, colors = [], []
    dark, light = rgb("#2f5a24"), rgb("#86a544")
    for side in (-1, 1):
        for s in np.linspace(0.10, 0.985, 26):
            at = np.array([np.interp(s, t, spine[:, i]) for i in range(3)])
            ahead = np.array([np.interp(min(s + 0.05, 1), t, spine[:, i]) for i in range(3)]) - at
            ahead /= np.linalg.norm(ahead) + 1e-9
            reach = long * 0.26 * np.sin(np.pi * (0.12 + 0.86 * s)) ** 0.7 * rng.uniform(0.85, 1.1)
            tip = at + reach * (0.75 * np.array([0, 0, side]) + 0.55 * ahead - np.array([0, 0.42 + 0.2 * s, 0]))
            middle = at + reach * 0.5 * (0.85 * np.array([0, 0, side]) + 0.5 * ahead - np.array([0, 0.10, 0]))
            wide = ahead * reach * 0.065
            tone = rng.uniform(0.8, 1.2)
            inner, outer = dark * tone, (dark + (light - dark) * (0.35 + 0.5 * s)) * tone
            corners += [[at, middle - wide, middle + wide], [middle + wide, middle - wide, tip]]
            colors += [[inner, outer, outer], [outer, outer, outer * 1.1]]
    leaf = shape.fromTriangles(np.array(corners), np.clip(np.array(colors), 0, 1), None, shape.FLAT)
    return shape.join([leaf, shape.tube(spine, 0.035 * (1.1 - t), rgb("#9a9a4e"), 4, False)])


def palm(seed, tall=7.5):
    """Foot at the origin; leans and bends towards +x."""
    rng = np.random.default_rng(seed)
    t = np.linspace(0, 1, 22)
    lean = rng.uniform(0.16, 0.42) * tall
    path = np.stack([lean * t**1.7, tall * t - 0.4 * (1 - t), 0.10 * tall * np.sin(2.6 * t + rng.uniform(0, 6)) * t], 1)
    ring = 1 + 0.10 * (np.arange(22) % 2)
    radius = (0.17 - 0.07 * t + 0.10 * np.exp(-t * 16)) * ring
    bark = rgb("#8d7a63")[None] * (0.75 + 0.25 * (np.arange(22) % 2))[:, None] * np.linspace(0.9, 1.1, 22)[:, None]
    trunk = shape.tube(path, radius, bark, 8, False)
    crown, leaves = path[-1], []
    count = 17
    for k in range(count):
        turned = shape.yawed(frond(rng, tall * rng.uniform(0.36, 0.46)), 360 * k / count + rng.uniform(-9, 9))
        leaves.append(shape.move(turned, crown + [0, rng.uniform(-0.1, 0.12), 0]))
    nuts = [
        shape.move(shape.lathe([(0.0, -0.16), (0.12, -0.08), (0.14, 0.0), (0.1, 0.1), (0.0, 0.15)], 7, rgb("#6f7a35")), crown + off)
        for off in ([0.2, -0.25, 0.05], [-0.12, -0.28, 0.18], [0.0, -0.27, -0.2])
    ]
    return shape.Asset().add("leaf", *leaves).add("paint", trunk, *nuts)


def tuft(seed, count=46, tall=0.75):
    """Marram: a clump of thin blades that the wind bends."""
    rng = np.random.default_rng(seed)
    blades = []
    for _ in range(count):
        foot = np.array([rng.normal(scale=0.16), -0.05, rng.normal(scale=0.16)])
        lean, long = rng.normal(0.6, 0.9), tall * rng.uniform(0.6, 1.25)
        s = np.linspace(0, 1, 5)
        bend = rng.uniform(0.3, 0.75)
        path = foot + np.stack([bend * long * s**2 * np.cos(lean), long * s * (1 - 0.25 * bend * s), bend * long * s**2 * np.sin(lean)], 1)
        across = np.array([-np.sin(lean), 0, np.cos(lean)]) * (0.011 * (1 - 0.9 * s))[:, None]
        tone = rng.uniform(0.75, 1.2) * np.linspace(0.7, 1.15, 5)[:, None, None]
        blades.append(shape.grid(np.stack([path - across, path + across], 1), rgb("#8c9a55") * tone * np.ones((5, 2, 3)), None, shape.SMOOTH))
    return shape.join(blades)
