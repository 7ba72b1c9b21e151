"""Noise that tiles: gradient and cellular, in two and three dimensions, from a fixed seed."""
import numpy as np


def cellular(size, cells, seed, dimensions=3):
    """Distance to the nearest of one jittered point a cell, 1 at the point falling to 0; float32 [size]*dimensions."""
    rng = np.random.default_rng(seed)
    jitter = rng.random([cells] * dimensions + [dimensions]).astype(np.float32)
    axis = ((np.arange(size) + 0.5) * cells / size).astype(np.float32)
    cell = axis.astype(int)
    best = np.full([size] * dimensions, 9.0, np.float32)
    for offset in np.ndindex(*[3] * dimensions):
        index = [((cell + o - 1) % cells) for o in offset]
        point = jitter[np.ix_(*index)]
        squared = np.zeros_like(best)
        for d in range(dimensions):
            shape = [1] * dimensions
            shape[d] = size
            away = (cell + offset[d] - 1 - axis).reshape(shape) + point[..., d]
            squared += away * away
        np.minimum(best, squared, out=best)
    return 1 - np.minimum(np.sqrt(best), 1)


def gradient(size, cells, seed, dimensions=3):
    """Perlin noise, about -1..1; float32 [size]*dimensions."""
    rng = np.random.default_rng(seed)
    vectors = rng.normal(size=[cells] * dimensions + [dimensions]).astype(np.float32)
    vectors /= np.linalg.norm(vectors, axis=-1, keepdims=True)
    axis = ((np.arange(size) + 0.5) * cells / size).astype(np.float32)
    cell = axis.astype(int)
    fraction = axis - cell
    fade = fraction**3 * (fraction * (fraction * 6 - 15) + 10)
    total = np.zeros([size] * dimensions, np.float32)
    for corner in np.ndindex(*[2] * dimensions):
        value = np.zeros_like(total)
        weight = np.ones_like(total)
        lattice = vectors[np.ix_(*[(cell + c) % cells for c in corner])]
        for d in range(dimensions):
            shape = [1] * dimensions
            shape[d] = size
            value += lattice[..., d] * (fraction - corner[d]).reshape(shape)
            weight *= (fade if corner[d] else 1 - fade).reshape(shape)
        total += value * weight
    return total * (1.5 if dimensions == 3 else 1.4)


def fractal(make, size, cells, octaves, seed, dimensions, gain=0.5):
    total, norm, amplitude = 0, 0, 1.0
    for octave in range(octaves):
        total = total + amplitude * make(size, cells << octave, seed + octave, dimensions)
        norm += amplitude
        amplitude *= gain
    return total / norm


def sample2(texture, x, y):
    """Bilinear, wrapping; x and y in tiles."""
    n = texture.shape[0]
    x, y = x * n - 0.5, y * n - 0.5
    x0, y0 = np.floor(x), np.floor(y)
    fx, fy = (x - x0).astype(np.float32), (y - y0).astype(np.float32)
    x0, y0 = x0.astype(np.int64) % n, y0.astype(np.int64) % n
    x1, y1 = (x0 + 1) % n, (y0 + 1) % n
    return (texture[y0, x0] * (1 - fx) + texture[y0, x1] * fx) * (1 - fy) + (
        texture[y1, x0] * (1 - fx) + texture[y1, x1] * fx
    ) * fy


def sample3(texture, x, y, z):
    """Trilinear, wrapping; coordinates in tiles."""
    n = texture.shape[0]
    flat = texture.ravel()
    x, y, z = x * n - 0.5, y * n - 0.5, z * n - 0.5
    x0, y0, z0 = np.floor(x), np.floor(y), np.floor(z)
    fx, fy, fz = ((a - b).astype(np.float32) for a, b in ((x, x0), (y, y0), (z, z0)))
    x0, y0, z0 = (a.astype(np.int64) % n for a in (x0, y0, z0))
    x1, y1, z1 = (x0 + 1) % n, (y0 + 1) % n, (z0 + 1) % n
    row = [z0 * n, z1 * n]
    planes = []
    for r in row:
        a, b = (r + y0) * n, (r + y1) * n
        low = flat[a + x0] * (1 - fx) + flat[a + x1] * fx
        high = flat[b + x0] * (1 - fx) + flat[b + x1] * fx
        planes.append(low * (1 - fy) + high * fy)
    return planes[0] * (1 - fz) + planes[1] * fz
