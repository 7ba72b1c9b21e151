"""Clear sky of a spherical atmosphere: Rayleigh, Mie and ozone, single scattering integrated along the view ray and
the higher orders after Hillaire 2020, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique".

Lengths in metres, three wavelengths (680, 550, 440 nm) taken as red, green, blue. The sun outside the atmosphere has
irradiance 1 in each.
"""
import numpy as np

EARTH = 6360e3
TOP = 100e3
RAYLEIGH = np.array([5.802, 13.558, 33.1]) * 1e-6
OZONE = np.array([0.650, 1.881, 0.085]) * 1e-6
RAYLEIGH_HEIGHT = 8000.0
MIE_HEIGHT = 1200.0
GROUND_ALBEDO = 0.15


def rayleighPhase(cosine):
    return 3 / (16 * np.pi) * (1 + cosine**2)


def hazePhase(cosine, g):
    """Cornette-Shanks."""
    return 3 / (8 * np.pi) * (1 - g * g) * (1 + cosine**2) / ((2 + g * g) * (1 + g * g - 2 * g * cosine) ** 1.5)


class Atmosphere:
    def __init__(self, haze=1.0, sunElevationDeg=14.0, g=0.78):
        self.mieScattering = 3.996e-6 * haze
        self.mieExtinction = 4.44e-6 * haze
        self.g = g
        self.sunSine = np.sin(np.radians(sunElevationDeg))
        self._tabulateTransmittance()
        self._tabulateHigherOrders()

    # --- media ------------------------------------------------------------------------------------------------------

    def _density(self, height):
        """Rayleigh, Mie and ozone relative density at a height."""
        h = np.maximum(height, 0)
        return np.exp(-h / RAYLEIGH_HEIGHT), np.exp(-h / MIE_HEIGHT), np.maximum(0, 1 - np.abs(h - 25e3) / 15e3)

    def _extinction(self, height):
        rayleigh, mie, ozone = self._density(height)
        return rayleigh[..., None] * RAYLEIGH + mie[..., None] * self.mieExtinction + ozone[..., None] * OZONE

    # --- transmittance to space -------------------------------------------------------------------------------------

    def _tabulateTransmittance(self, heights=48, cosines=256, steps=48):
        self._heights = TOP * np.linspace(0, 1, heights) ** 2
        self._cosines = np.linspace(-0.25, 1, cosines)
        h, mu = np.meshgrid(self._heights, self._cosines, indexing="ij")
        r = EARTH + h
        below = r * r * (1 - mu * mu) < EARTH * EARTH
        blocked = below & (mu < 0)
        reach = -r * mu + np.sqrt(np.maximum((EARTH + TOP) ** 2 - r * r * (1 - mu * mu), 0))
        edges = np.linspace(0, 1, steps + 1) ** 1.6
        depth = np.zeros(h.shape + (3,))
        for near, far in zip(edges[:-1], edges[1:]):
            t = reach * (near + far) / 2
            height = np.sqrt(r * r + t * t + 2 * r * mu * t) - EARTH
            depth += self._extinction(height) * (reach * (far - near))[..., None]
        self._transmittance = np.exp(-depth) * ~blocked[..., None]

    def transmittance(self, height, cosine):
        """From a height towards space in a direction with this cosine to the vertical."""
        i = np.sqrt(np.clip(height / TOP, 0, 1)) * (len(self._heights) - 1)
        j = np.clip((cosine + 0.25) / 1.25, 0, 1) * (len(self._cosines) - 1)
        return bilinear(self._transmittance, i, j)

    # --- light scattered more than once -----------------------------------------------------------------------------

    def _tabulateHigherOrders(self, heights=20, suns=28, steps=20):
        self._orderHeights, self._orderSuns = heights, suns
        h, sun = np.meshgrid(TOP * 0.6 * np.linspace(0, 1, heights) ** 2, np.linspace(-0.2, 1, suns), indexing="ij")
        side = 8
        v, u = np.meshgrid((np.arange(side) + 0.5) / side, (np.arange(side) + 0.5) / side, indexing="ij")
        up = (1 - 2 * v).ravel()
        around = 2 * np.pi * u.ravel()
        total = np.zeros(h.shape + (3,))
        again = np.zeros(h.shape + (3,))
        for mu, phi in zip(up, around):
            r = EARTH + h + 1
            disc = EARTH**2 - r * r * (1 - mu * mu)
            ground = (disc > 0) & (mu < 0)
            reach = np.where(
                ground,
                -r * mu - np.sqrt(np.maximum(disc, 0)),
                -r * mu + np.sqrt((EARTH + TOP) ** 2 - r * r * (1 - mu * mu)),
            )
            through = np.ones(h.shape + (3,))
            ds = reach / steps
            sunward = mu * sun + np.sqrt(1 - mu * mu) * np.sqrt(np.maximum(1 - sun * sun, 0)) * np.cos(phi)
            for k in range(steps):
                t = (k + 0.5) * ds
                rt = np.sqrt(r * r + t * t + 2 * r * mu * t)
                rayleigh, mie, _ = self._density(rt - EARTH)
                scattering = rayleigh[..., None] * RAYLEIGH + mie[..., None] * self.mieScattering
                extinction = self._extinction(rt - EARTH)
                local = np.clip((r * sun + t * sunward) / rt, -1, 1)
                step = np.exp(-extinction * ds[..., None])
                gained = through * (1 - step) / np.maximum(extinction, 1e-12)
                total += gained * scattering * self.transmittance(rt - EARTH, local) / (4 * np.pi)
                again += gained * scattering
                through = through * step
            local = np.clip((r * sun + reach * sunward) / EARTH, -1, 1)
            lit = through * self.transmittance(np.zeros_like(h), local) * np.maximum(local, 0)[..., None]
            total += lit * GROUND_ALBEDO / np.pi * ground[..., None]
        n = side * side
        self._orders = (total / n) / (1 - again / n)

    def _higherOrders(self, height, sunCosine):
        i = np.sqrt(np.clip(height / (TOP * 0.6), 0, 1)) * (self._orderHeights - 1)
        j = np.clip((sunCosine + 0.2) / 1.2, 0, 1) * (self._orderSuns - 1)
        return bilinear(self._orders, i, j)

    # --- what is seen -----------------------------------------------------------------------------------------------

    def sky(self, sine, awayCosine, sunCosine, steps=40):
        """Radiance towards directions given by the sine of their elevation (>= 0), the cosine of their azimuth from
        the sun's, and their cosine to the sun. Arrays of one shape."""
        table = self._skyTable(steps)
        i = np.sqrt(np.arcsin(np.clip(sine, 0, 1)) / (np.pi / 2)) * (table.shape[0] - 1)
        j = np.arccos(np.clip(awayCosine, -1, 1)) / np.pi * (table.shape[1] - 1)
        parts = bilinear(table, i, j)
        return (
            parts[..., 0:3] * rayleighPhase(sunCosine)[..., None]
            + parts[..., 3:6] * hazePhase(sunCosine, self.g)[..., None]
            + parts[..., 6:9]
        )

    def _skyTable(self, steps, elevations=112, azimuths=40):
        """Rayleigh, Mie (both still without phase) and higher-order light by elevation and azimuth from the sun."""
        if hasattr(self, "_table"):
            return self._table
        elevation, azimuth = np.meshgrid(
            (np.pi / 2) * np.linspace(0, 1, elevations) ** 2, np.linspace(0, np.pi, azimuths), indexing="ij"
        )
        mu = np.sin(elevation)
        r = EARTH + 2.0
        toSun = mu * self.sunSine + np.cos(elevation) * np.sqrt(1 - self.sunSine**2) * np.cos(azimuth)
        reach = -r * mu + np.sqrt((EARTH + TOP) ** 2 - r * r * (1 - mu * mu))
        parts = np.zeros(mu.shape + (9,))
        through = np.ones(mu.shape + (3,))
        edges = np.linspace(0, 1, steps + 1) ** 2
        for near, far in zip(edges[:-1], edges[1:]):
            t, ds = reach * (near + far) / 2, reach * (far - near)
            rt = np.sqrt(r * r + t * t + 2 * r * mu * t)
            height = rt - EARTH
            local = np.clip((r * self.sunSine + t * toSun) / rt, -1, 1)
            rayleigh, mie, _ = self._density(height)
            extinction = self._extinction(height)
            step = np.exp(-extinction * ds[..., None])
            gained = through * (1 - step) / np.maximum(extinction, 1e-12)
            lit = gained * self.transmittance(height, local)
            parts[..., 0:3] += lit * rayleigh[..., None] * RAYLEIGH
            parts[..., 3:6] += lit * mie[..., None] * self.mieScattering
            parts[..., 6:9] += (
                gained
                * self._higherOrders(height, local)
                * (rayleigh[..., None] * RAYLEIGH + mie[..., None] * self.mieScattering)
            )
            through = through * step
        self._table = parts
        return parts

    def sunIrradiance(self, height=2.0):
        """On a plane facing the sun."""
        return self.transmittance(np.array(height), np.array(self.sunSine))

    def airlight(self, distance):
        """Transmittance of a level path near the ground."""
        beta = RAYLEIGH * 0.85 + self.mieExtinction * 0.5
        return np.exp(-distance[..., None] * beta)


def bilinear(table, i, j):
    i0 = np.clip(i.astype(int), 0, table.shape[0] - 2)
    j0 = np.clip(j.astype(int), 0, table.shape[1] - 2)
    fi, fj = (i - i0)[..., None], (j - j0)[..., None]
    return (table[i0, j0] * (1 - fj) + table[i0, j0 + 1] * fj) * (1 - fi) + (
        table[i0 + 1, j0] * (1 - fj) + table[i0 + 1, j0 + 1] * fj
    ) * fi
