"""A boat's hull as a lofted surface. The bow points to +x, the water is at y = 0."""
import numpy as np

from . import shape


class Hull:
    """Lofted between stern and bow: half breadth, sheer and keel by station, and the shape of a section."""

    def __init__(self, length, beam, sheer, keel, bow=0.35, transom=0.7, fullness=0.55, stations=15, rake=0.08):
        self.length, self.stations, self.rake = length, stations, rake
        s = np.linspace(0, 1, stations)
        self.s = s
        aft = transom + (1 - transom) * np.sin(np.pi / 2 * np.clip(s / 0.5, 0, 1))
        fore = np.clip((1 - s) / (1 - 0.5), 0, 1)
        self.half = beam / 2 * np.where(s < 0.5, aft, np.sin(np.pi / 2 * fore) ** 0.85)
        self.half = np.maximum(self.half, 0.012)
        low, stern, stem = sheer
        self.sheer = (
            low
            + (stern - low) * np.clip(1 - s / 0.45, 0, 1) ** 2
            + (stem - low) * np.clip((s - 0.35) / 0.65, 0, 1) ** 2
        )
        deep, sternKeel, stemKeel = keel
        self.keel = (
            deep
            + (sternKeel - deep) * np.clip(1 - s / 0.35, 0, 1) ** 2
            + (stemKeel - deep) * np.clip((s - 0.62) / 0.38, 0, 1) ** 2.2
        )
        self.fullness = fullness + (bow - fullness) * np.clip((s - 0.4) / 0.6, 0, 1)

    def point(self, station, t, inset=0.0, lift=0.0):
        """On the section, t from the keel (0) to the sheer (1), on the +z side; `inset` metres inside."""
        k = np.asarray(station)
        f, h = self.fullness[k], np.maximum(self.half[k] - inset, 0.0)
        angle = t * np.pi / 2
        breadth = np.sin(angle) ** (2 * (1 - f) + 0.10)
        rise = 1 - np.cos(angle) ** (0.75 + 0.8 * f)
        bottom = self.keel[k] + inset * 1.2 + lift
        y = bottom + (self.sheer[k] - bottom) * rise
        x = (self.s[k] - 0.5) * self.length
        x = x + self.rake * self.length * np.clip((self.s[k] - 0.72) / 0.28, 0, 1) ** 1.5 * (rise - 0.4)
        return np.stack(np.broadcast_arrays(x, y, h * breadth), -1)

    def skin(self, ts, color, inset=0.0, inside=False, crease=shape.SMOOTH, first=0, last=None, lift=0.0):
        """Both sides between the given t. `color` one, one a t, or one a station and t."""
        k = np.arange(self.stations)[first:last]
        p = self.point(k[:, None], np.asarray(ts)[None], inset, lift)
        color = np.broadcast_to(color, p.shape)
        starboard = shape.grid(p, color, None, crease, flip=inside)
        port = shape.grid(p * [1, 1, -1], color, None, crease, flip=not inside)
        return shape.join([starboard, port])

    def rim(self, inset, color, first=0, last=None, rise=0.0):
        """The flat between outer and inner skin along the sheer."""
        k = np.arange(self.stations)[first:last]
        outer, inner = self.point(k, 1.0), self.point(k, 1.0, inset)
        p = np.stack([outer, inner], 1) + [0, rise, 0]
        return shape.join(
            [shape.grid(p, color, None, shape.SMOOTH), shape.grid(p * [1, 1, -1], color, None, shape.SMOOTH, flip=True)]
        )

    def stem(self, ts, color):
        """Closes the narrow gap where the sides meet."""
        return self.end(ts, color, -1, 0.0, 1)

    def breadthAt(self, station, y, inset):
        """Whole breadth between the inner sides at a height."""
        side = self.point(station, np.linspace(0, 1, 25), inset)
        return 2 * np.interp(y, side[:, 1], side[:, 2])

    def deck(self, at, color, first=0, last=None, inset=0.0, camber=0.0, facing=1):
        """A level floor across the hull where the skin passes t = `at`."""
        k = np.arange(self.stations)[first:last]
        edge = self.point(k, at, inset)
        rows = []
        for share in (-1, -0.5, 0, 0.5, 1):
            arch = camber * (1 - share * share) * np.sin(np.pi * self.s[k]) ** 0.5
            rows.append(edge * [1, 1, share] + arch[:, None] * [0, 1, 0])
        return shape.grid(np.stack(rows, 1), color, None, 40, flip=facing > 0)

    def end(self, ts, color, station=0, inset=0.0, facing=-1, lift=0.0):
        """A flat bulkhead filling the section, `inset` forward of the station."""
        p = self.point(station, np.asarray(ts), inset, lift) + [inset, 0, 0]
        both = np.stack([p * [1, 1, -1], p], 0)
        color = np.broadcast_to(color, both.shape)
        return shape.grid(both, color, None, shape.FLAT, flip=facing > 0)
