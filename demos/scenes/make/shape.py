"""Surfaces and the few solids everything is put together from. Metres, +Y up, front faces counter-clockwise.

Colours are linear; `rgb("#c0392b")` reads them as they are picked.
"""
from dataclasses import dataclass
from typing import Optional

import numpy as np

SMOOTH, ROUNDED, FLAT = 180.0, 50.0, 0.0  # crease angles


@dataclass
class Surface:
    p: np.ndarray  # [n,3] positions
    n: np.ndarray  # [n,3] normals
    c: np.ndarray  # [n,3] colours
    t: np.ndarray  # [m,3] triangles
    uv: Optional[np.ndarray] = None  # [n,2]


def rgb(text):
    value = np.array([int(text[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def fromTriangles(p, c, uv=None, crease=FLAT):
    """From corners [m,3,3]: normals are shared where faces meet at less than the crease angle, equal corners merged."""
    p = np.asarray(p, float)
    normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    area = np.linalg.norm(normal, axis=1)
    keep = area > 1e-10
    p, normal, area = p[keep], normal[keep], area[keep]
    c = np.broadcast_to(c, (len(keep), 3, 3))[keep].reshape(-1, 3)
    uv = None if uv is None else np.asarray(uv)[keep].reshape(-1, 2)
    face = np.repeat(normal / area[:, None], 3, 0)
    weighted = np.repeat(normal, 3, 0)
    corner = p.reshape(-1, 3)
    total = weighted.copy()
    if crease > 0:
        place = np.unique(np.round(corner, 4), axis=0, return_inverse=True)[1].ravel()
        order = np.argsort(place, kind="stable")
        sortedPlace, limit = place[order], np.cos(np.radians(min(crease, 179.9)))
        gap = 1
        while gap < len(order):
            i = np.flatnonzero(sortedPlace[gap:] == sortedPlace[:-gap])
            if not len(i):
                break
            a, b = order[i], order[i + gap]
            near = (face[a] * face[b]).sum(1) > limit
            a, b = a[near], b[near]
            np.add.at(total, a, weighted[b])
            np.add.at(total, b, weighted[a])
            gap += 1
    length = np.linalg.norm(total, axis=1, keepdims=True)
    n = np.where(length > 1e-9, total / np.maximum(length, 1e-9), face)
    key = [np.round(corner, 4), np.round(n, 2), np.round(c * 255)] + ([] if uv is None else [np.round(uv, 4)])
    _, first, index = np.unique(np.concatenate(key, 1) + 0.0, axis=0, return_index=True, return_inverse=True)
    return Surface(corner[first], n[first], c[first].copy(), index.reshape(-1, 3), None if uv is None else uv[first])


def polygons(points, faces, color, crease=FLAT, uv=None):
    """Convex polygons over shared points, fanned. `color` one, or one a point; `uv` one a point."""
    points = np.asarray(points, float)
    color = np.broadcast_to(color, points.shape)
    index = np.array([(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)])
    return fromTriangles(points[index], color[index], None if uv is None else np.asarray(uv)[index], crease)


def grid(points, color, uv=None, crease=SMOOTH, flip=False):
    """Over points [u,v,3]; the front is where d/du x d/dv points. A closed ring repeats its first row."""
    points = np.asarray(points, float)
    rows, columns = points.shape[:2]
    color = np.broadcast_to(color, points.shape).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (i * columns + j).ravel()
    b, c, d = a + columns, a + columns + 1, a + 1
    flat = points.reshape(-1, 3)
    shorter = np.linalg.norm(flat[a] - flat[c], axis=1) <= np.linalg.norm(flat[b] - flat[d], axis=1) + 1e-6
    first = np.where(shorter[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(shorter[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    index = np.concatenate([first, second])
    if flip:
        index = index[:, ::-1]
    return fromTriangles(
        flat[index], color[index], None if uv is None else np.asarray(uv).reshape(-1, 2)[index], crease
    )


def row(xs, zs):
    return np.stack(np.broadcast_arrays(xs, zs), -1).astype(float)


def seam(fine, coarse, along):
    """Triangles' x and z [m,3], fronts above, between two rows of places [n,2] that rise along one axis and end side by side: sheets
    that share every vertex leave no crack."""
    i = j = 0
    corners = []
    while i + 1 < len(fine) or j + 1 < len(coarse):
        onFine = j + 1 == len(coarse) or (i + 1 < len(fine) and fine[i + 1][along] <= coarse[j + 1][along])
        corners += [fine[i], coarse[j], fine[i + 1] if onFine else coarse[j + 1]]
        i, j = (i + 1, j) if onFine else (i, j + 1)
    xz = np.array(corners).reshape(-1, 3, 2)
    first, second = xz[:, 1] - xz[:, 0], xz[:, 2] - xz[:, 0]
    below = first[:, 0] * second[:, 1] > second[:, 0] * first[:, 1]
    xz[below] = xz[below][:, ::-1]
    return xz[..., 0], xz[..., 1]


def box(size, center=(0, 0, 0), color=(1, 1, 1), texture=None, top=None, cuts=1):
    """`texture`: tiles a metre, or None; the grain (v) runs along the longest side. `top`: scale of the upper face.
    `cuts`: quads along each side, for colours that vary over it."""
    size = np.asarray(size, float)
    parts = []
    longest = int(np.argmax(size))
    for axis in range(3):
        u, v = [a for a in range(3) if a != axis]
        if v != longest and u == longest:
            u, v = v, u
        for sign in (-1, 1):
            nu, nv = (cuts if size[a] > 0.5 else 1 for a in (u, v))
            s, t = np.meshgrid(np.linspace(-0.5, 0.5, nu + 1), np.linspace(-0.5, 0.5, nv + 1), indexing="ij")
            p = np.zeros(s.shape + (3,))
            p[..., u], p[..., v], p[..., axis] = s * size[u], t * size[v], sign * size[axis] / 2
            uv = None
            if texture is not None:
                shift = np.array([0.37, 0.61]) * (axis + 1)
                uv = np.stack([s * size[u], t * size[v]], -1) * texture + shift
            right = np.cross(np.eye(3)[u], np.eye(3)[v])[axis] * sign > 0
            if top is not None:
                scale = np.where(p[..., 1:2] > 0, np.asarray(top, float), 1.0)
                p[..., 0] *= scale[..., 0]
                p[..., 2] *= scale[..., -1]
            parts.append(grid(p, color, uv, FLAT, flip=not right))
    return move(join(parts), center)


def lathe(profile, segments, color, crease=ROUNDED, uv=None):
    """Turns a profile of (radius, height), from bottom to top, about +Y. `color` one, or one a ring."""
    profile = np.asarray(profile, float)
    angle = np.linspace(0, 2 * np.pi, segments + 1)
    p = np.stack(
        [profile[:, :1] * np.cos(angle), np.repeat(profile[:, 1:], segments + 1, 1), profile[:, :1] * np.sin(angle)], -1
    )
    p[:, -1] = p[:, 0]
    color = np.broadcast_to(color, (len(profile), 3))[:, None] * np.ones((1, segments + 1, 1))
    if uv is not None:
        v = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
        uv = np.stack(np.broadcast_arrays(angle[None] / (2 * np.pi) * uv[0], v[:, None] * uv[1]), -1)
    return grid(p, color, uv, crease)


def tube(path, radius, color, sides=5, caps=True):
    """A round bar along points [k,3]; radius one, or one a point."""
    path = np.asarray(path, float)
    radius = np.broadcast_to(radius, len(path))
    tangent = np.gradient(path, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    along = tangent.mean(0)
    reference = np.eye(3)[int(np.argmin(np.abs(along)))]
    side = np.cross(tangent, reference)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    other = np.cross(tangent, side)
    angle = np.linspace(0, 2 * np.pi, sides + 1)
    ring = np.cos(angle)[None, :, None] * side[:, None] + np.sin(angle)[None, :, None] * other[:, None]
    p = path[:, None] + ring * radius[:, None, None]
    p[:, -1] = p[:, 0]
    color = np.asarray(color, float)
    shade = np.broadcast_to(color[:, None] if color.ndim == 2 else color, p.shape)
    parts = [grid(p, shade, None, SMOOTH, flip=True)]
    if caps:
        for end, order in ((0, 1), (-1, -1)):
            if radius[end] > 1e-3:
                parts.append(polygons(p[end, :-1][::-order], [list(range(sides))], shade[end, 0]))
    return join(parts)


def torus(radius, thickness, color, segments=14, sides=6):
    """About +Y. `color` one, or one a segment."""
    a = np.linspace(0, 2 * np.pi, segments + 1)
    b = np.linspace(0, 2 * np.pi, sides + 1)
    reach = radius + thickness * np.cos(b)[None]
    p = np.stack(
        [
            reach * np.cos(a)[:, None],
            np.broadcast_to(thickness * np.sin(b), (segments + 1, sides + 1)),
            reach * np.sin(a)[:, None],
        ],
        -1,
    )
    color = np.asarray(color, float)
    if color.ndim == 2:
        color = np.concatenate([color, color[:1]])[:, None]
    return grid(p, np.broadcast_to(color, p.shape), None, SMOOTH, flip=True)


# --- putting together ------------------------------------------------------------------------------------------------


def join(parts):
    parts = list(parts)
    start = np.concatenate([[0], np.cumsum([len(s.p) for s in parts])])
    textured = any(s.uv is not None for s in parts)
    uv = (
        np.concatenate([s.uv if s.uv is not None else np.full((len(s.p), 2), 0.5) for s in parts]) if textured else None
    )
    return Surface(
        np.concatenate([s.p for s in parts]),
        np.concatenate([s.n for s in parts]),
        np.concatenate([s.c for s in parts]),
        np.concatenate([s.t + o for s, o in zip(parts, start)]),
        uv,
    )


def move(s, by):
    return Surface(s.p + np.asarray(by, float), s.n, s.c, s.t, s.uv)


def turn(s, matrix):
    matrix = np.asarray(matrix, float)
    return Surface(s.p @ matrix.T, s.n @ matrix.T, s.c, s.t, s.uv)


def yawed(s, degrees):
    return turn(s, about("y", degrees))


def about(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    if axis == "x":
        return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    if axis == "y":
        return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def between(a, b, size, color, texture=None):
    """A beam of cross-section `size` (across, upwards) from a to b."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    z = (b - a) / np.linalg.norm(b - a)
    x = np.cross([0, 1, 0], z) if abs(z[1]) < 0.99 else np.cross([0, 0, 1], z)
    x /= np.linalg.norm(x)
    beam = box((size[0], size[1], np.linalg.norm(b - a)), (0, 0, 0), color, texture)
    return move(turn(beam, np.stack([x, np.cross(z, x), z], 1)), (a + b) / 2)


class Asset:
    """Surfaces by material name."""

    def __init__(self):
        self.parts = {}

    def add(self, material, *surfaces):
        self.parts.setdefault(material, []).extend(surfaces)
        return self

    def include(self, other, place=lambda s: s):
        for material, surfaces in other.parts.items():
            self.add(material, *[place(s) for s in surfaces])
        return self

    def joined(self):
        return {material: join(surfaces) for material, surfaces in self.parts.items()}
