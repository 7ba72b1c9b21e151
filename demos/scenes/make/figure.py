"""A standing figure as a sculptor would rough it out: rounded limbs that flow into each other, taken from a distance
field by marching tetrahedra."""
import numpy as np

from . import shape
from .shape import Surface, rgb

# From, to, radius at each end [m]; feet at y = 0. One arm on the hip, the other raised: there are holes to see through.
LIMBS = (
    ((-0.10, 0.06, 0.02), (-0.10, 0.50, 0.00), 0.065, 0.075),
    ((-0.10, 0.50, 0.00), (-0.09, 0.95, -0.01), 0.075, 0.11),
    ((0.13, 0.06, 0.12), (0.11, 0.50, 0.06), 0.065, 0.075),
    ((0.11, 0.50, 0.06), (0.09, 0.95, 0.00), 0.075, 0.11),
    ((-0.10, 0.04, -0.02), (-0.11, 0.035, 0.16), 0.05, 0.035),
    ((0.13, 0.04, 0.08), (0.17, 0.035, 0.25), 0.05, 0.035),
    ((0.00, 0.98, 0.00), (0.01, 1.12, 0.00), 0.155, 0.125),
    ((0.01, 1.12, 0.00), (0.00, 1.38, 0.01), 0.125, 0.165),
    ((-0.15, 1.42, 0.00), (0.15, 1.44, 0.00), 0.075, 0.075),
    ((0.00, 1.45, 0.01), (0.01, 1.58, 0.03), 0.060, 0.050),
    ((0.01, 1.66, 0.04), (0.02, 1.72, 0.04), 0.098, 0.092),
    ((-0.20, 1.42, 0.00), (-0.40, 1.16, -0.05), 0.060, 0.048),
    ((-0.40, 1.16, -0.05), (-0.16, 1.02, 0.09), 0.046, 0.036),
    ((0.20, 1.44, 0.00), (0.38, 1.66, 0.02), 0.060, 0.048),
    ((0.38, 1.66, 0.02), (0.26, 1.94, 0.06), 0.045, 0.034),
)


def distance(p):
    """Smooth union of round cones, about; rounded drapery about the hips."""
    d = None
    for a, b, ra, rb in LIMBS:
        a, b = np.array(a), np.array(b)
        t = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        limb = np.linalg.norm(p - a - t[..., None] * (b - a), axis=-1) - (ra + (rb - ra) * t)
        if d is None:
            d = limb
        else:
            k = 0.055
            h = np.clip(0.5 + 0.5 * (limb - d) / k, 0, 1)
            d = limb * (1 - h) + d * h - k * h * (1 - h)
    turn = np.arctan2(p[..., 2], p[..., 0])
    flare = 0.215 + 0.10 * np.clip((1.02 - p[..., 1]) / 0.7, 0, 1) + 0.014 * np.sin(9 * turn + 5 * p[..., 1])
    away = np.hypot(p[..., 0] * 0.92, p[..., 2] * 1.15)
    skirt = np.maximum(away - flare, np.abs(p[..., 1] - 0.72) - 0.31)
    h = np.clip(0.5 + 0.5 * (skirt - d) / 0.03, 0, 1)
    return skirt * (1 - h) + d * h - 0.03 * h * (1 - h)


def surfaceOf(field, low, high, step):
    """Points and triangles where `field` is zero. Six tetrahedra about each cell's diagonal."""
    low = np.asarray(low, float)
    count = np.ceil((np.asarray(high) - low) / step).astype(int) + 1
    index = np.stack(np.meshgrid(*[np.arange(n) for n in count], indexing="ij"), -1)
    value = field(low + index * step)
    number = np.arange(count.prod()).reshape(count)
    corner = lambda i, j, k: number[
        i : count[0] - 1 + i, j : count[1] - 1 + j, k : count[2] - 1 + k
    ].ravel()
    tets = []
    for order in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
        at, path = [0, 0, 0], [corner(0, 0, 0)]
        for axis in order:
            at[axis] = 1
            path.append(corner(*at))
        tets.append(np.stack(path, 1))
    tets, flat = np.concatenate(tets), value.ravel()
    place = low + index.reshape(-1, 3) * step
    inside = flat[tets] < 0
    edges = []
    for pattern in range(1, 15):
        bits = [(pattern >> i) & 1 for i in range(4)]
        here = tets[(inside == np.array(bits, bool)).all(1)]
        within, without = [i for i in range(4) if bits[i]], [i for i in range(4) if not bits[i]]
        if not len(here):
            continue
        if len(within) == 2:
            a, b = within
            c, d = without
            faces = [((a, c), (a, d), (b, c)), ((b, c), (a, d), (b, d))]
        else:
            one, rest = (within[0], without) if len(within) == 1 else (without[0], within)
            faces = [tuple((one, r) for r in rest)]
        edges += [here[:, np.array(face)] for face in faces]
    ends = np.sort(np.concatenate(edges), axis=-1).reshape(-1, 2)
    unique, t = np.unique(ends, axis=0, return_inverse=True)
    a, b = flat[unique[:, 0]], flat[unique[:, 1]]
    share = np.clip(a / (a - b), 0.08, 0.92)[:, None]
    return place[unique[:, 0]] * (1 - share) + place[unique[:, 1]] * share, t.reshape(-1, 3)


def figure(step=0.043, color="#ded8cb"):
    p, t = surfaceOf(distance, (-0.55, -0.02, -0.38), (0.55, 2.05, 0.42), step)
    e = 0.004
    n = np.stack([distance(p + e * axis) - distance(p - e * axis) for axis in np.eye(3)], -1)
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    face = np.cross(p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]])
    back = (face * n[t].sum(1)).sum(1) < 0
    t[back] = t[back][:, ::-1]
    uv = np.stack([np.arctan2(p[:, 2], p[:, 0]) / np.pi, p[:, 1]], 1)
    uv[:, 0] = p[:, 0] + 0.6 * p[:, 2]
    return Surface(p, n, np.broadcast_to(rgb(color), p.shape).copy(), t, uv)
