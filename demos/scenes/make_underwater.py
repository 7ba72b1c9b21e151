#!/usr/bin/python3
"""Makes underwater.glb: a fishing boat that sank on a bed of sand, a reef with kelp beside it, fish, and a rowing boat at
anchor above.

In metres, +Y up, the water at y = 0 and 7 to 9 m deep. Composed for an eye at about (-1, -4.6, 7) looking towards -z.
"""
import pathlib

import numpy as np

import glb
from make import boats, land, moorings, occlusion, rocks, seabed, shape, texture
from make.shape import Asset, rgb

WRECK = np.array([-2.5, 0, -9.0])
BOAT = np.array([3.4, 0, -4.5])


class Underwater:
    def __init__(self):
        self.glb = glb.Glb()
        self.rng = np.random.default_rng(29)
        sand = self.glb.texture(texture.png(texture.ground()))
        stone = self.glb.texture(texture.png(texture.rock()))
        wood = self.glb.texture(texture.png(texture.wood()))
        self.materials = {
            "sand": self.glb.material("sand", texture=sand, roughness=1.0),
            "stone": self.glb.material("stone", texture=stone, roughness=0.95),
            "wood": self.glb.material("wood", texture=wood, roughness=0.9),
            "paint": self.glb.material("paint", roughness=0.8),
            "gloss": self.glb.material("gloss", roughness=0.7),
            "glass": self.glb.material("glass", rgb("#20282c"), roughness=0.4),
            "hull": self.glb.material("hull", rgb("#b8452f"), roughness=0.6),
            "leaf": self.glb.material("leaf", roughness=0.8, doubleSided=True),
            "fish": self.glb.material("fish", roughness=0.45),
        }

    def mesh(self, name, asset):
        return self.glb.mesh(name, [(s, self.materials.get(m, self.materials["paint"])) for m, s in asset.joined().items()])

    def sand(self):
        near_x, near_z = np.linspace(-9, 9, 76), np.linspace(-13, 8, 85)
        edge = lambda x, z: np.clip(np.minimum(9 - np.abs(x), np.minimum(8 - z, z + 13)) / 2, 0, 1)
        asset = Asset().add("sand", seabed.sheet(near_x, near_z, lambda x, z: seabed.ripples(x, z) * edge(x, z)))
        # A wider net around it, joined to it vertex by vertex.
        xs = land.spaced((-70, -28, 6), (-28, -9, 2.4), (-9, 9, 2.25), (9, 27, 1.5), (27, 70, 4.3))
        zs = land.spaced((-120, -40, 8), (-40, -13, 3), (-13, 8, 1.5), (8, 30, 4.4))
        left, right, back, front = xs[xs < -9][-1], xs[xs > 9][0], zs[zs < -13][-1], zs[zs > 8][0]
        between, beside = xs[(xs >= left) & (xs <= right)], zs[(zs >= -13) & (zs <= 8)]
        for x, z in (
            (xs[xs <= left], zs), (xs[xs >= right], zs), (between, zs[zs <= back]), (between, zs[zs >= front]),
            *((x, z) for x in ([left, -9], [9, right]) for z in ([back, -13], [8, front])),
        ):
            asset.add("sand", seabed.sheet(x, z))
        for rim, beyond in ((-9, left), (9, right)):
            asset.add("sand", seabed.seam(shape.row(rim, near_z), shape.row(beyond, beside), 1))
        for rim, beyond in ((-13, back), (8, front)):
            asset.add("sand", seabed.seam(shape.row(near_x, rim), shape.row(between[1:-1], beyond), 0))
        self.glb.node(self.mesh("bed", asset))

    def foot(self, x, z, sunk=0.0):
        return (x, float(seabed.height(np.array(x), np.array(z))) - sunk, z)

    def reef(self):
        grey, brown = rgb("#6f6a5e"), rgb("#7a6347")
        kinds = [self.mesh(f"rock {k}", Asset().add("stone", rocks.boulder(60 + k, (grey, brown)[k % 2], 3))) for k in range(4)]
        spots = [(self.rng.normal(12.5, 3.0), self.rng.uniform(-26, 6), self.rng.uniform(1.2, 3.6)) for _ in range(70)]
        spots += [(self.rng.uniform(-9, 9), self.rng.uniform(-20, 4), self.rng.uniform(0.25, 0.8)) for _ in range(26)]
        spots += [(-6.2, 1.0, 1.9), (-7.4, 0.2, 1.4), (-5.4, 0.3, 0.9), (5.2, 1.4, 1.5), (6.3, 2.2, 2.0)]
        for x, z, size in spots:
            turn = glb.yaw(self.rng.uniform(0, 360))
            self.glb.node(kinds[self.rng.integers(4)], self.foot(x, z, 0.12 * size), turn, size * np.array([1, 0.85, 1]))

    def plants(self):
        kelps = [self.mesh(f"kelp {k}", Asset().add("leaf", seabed.kelp(k))) for k in range(3)]
        tufts = [self.mesh(f"grass {k}", Asset().add("leaf", seabed.grass(k))) for k in range(3)]
        spots = [(-6.4, 0.4), (-7.3, -0.6), (-5.7, -0.4), (-6.9, 1.4), (5.6, 0.6), (6.4, 1.3), (6.9, 0.0)]
        spots += [(self.rng.normal(10.0, 2.2), self.rng.uniform(-24, 3)) for _ in range(34)]
        spots += [(self.rng.normal(-14.0, 2.5), self.rng.uniform(-24, -3)) for _ in range(22)]
        for x, z in spots:
            place = self.foot(x, z)
            size = min(self.rng.uniform(0.75, 1.25), (-0.3 - place[1]) / 4.6)
            self.glb.node(kelps[self.rng.integers(3)], place, glb.yaw(self.rng.uniform(0, 360)), size)
        for x, z in [(self.rng.normal(-4.5, 1.6), self.rng.normal(2.6, 1.3)) for _ in range(34)] + [
            (self.rng.uniform(-9, 8), self.rng.uniform(-16, 5)) for _ in range(46)
        ]:
            size = self.rng.uniform(0.8, 1.5)
            self.glb.node(tufts[self.rng.integers(3)], self.foot(x, z), glb.yaw(self.rng.uniform(0, 360)), size)

    def wreck(self):
        boat = occlusion.bake(boats.fishingBoat(), 0.08, 0.6)
        for surface in boat.joined().values():
            grown = np.clip(land.waves(surface.p[:, 0], surface.p[:, 2] + surface.p[:, 1], 91, 1.3, 3) + 0.55, 0, 1)
            surface.c[:] = surface.c * (0.55 - 0.25 * grown[:, None]) + rgb("#5b5f3c") * 0.55 * grown[:, None]
        heel = np.array([np.sin(np.radians(-26) / 2), 0, 0, np.cos(np.radians(-26) / 2)])
        pitch = np.array([0, 0, np.sin(np.radians(-7) / 2), np.cos(np.radians(-7) / 2)])
        place = self.foot(WRECK[0], WRECK[2], -0.35)
        self.glb.node(self.mesh("wreck", boat), place, glb.times(glb.yaw(-28), glb.times(pitch, heel)))

    def above(self):
        boat = occlusion.bake(boats.rowingBoat(), 0.05, 0.6)
        self.glb.node(self.mesh("rowing boat", boat), tuple(BOAT), glb.yaw(24))
        anchor = np.array(self.foot(6.0, -8.5))
        ropes = Asset().add("paint", moorings.rope((BOAT[0] + 1.9, 0.5, BOAT[2] - 0.9), tuple(anchor), 0.25))
        self.glb.node(self.mesh("rope", ropes))
        self.glb.node(self.mesh("buoy", moorings.ballBuoy()), (-7.5, 0, -6.0))

    def fish(self):
        body, fins = seabed.fish()
        small = self.mesh("herring", Asset().add("fish", body).add("leaf", fins))
        body, fins = seabed.fish("#6b4a2f", "#c98f4e", 0.42)
        large = self.mesh("wrasse", Asset().add("fish", body).add("leaf", fins))
        for _ in range(110):  # a shoal that turns round above the wreck
            turn = self.rng.uniform(-0.7, 2.2)
            r = 5.2 + self.rng.normal(scale=0.55)
            at = np.array([r * np.cos(turn) - 1.5, -3.6 + self.rng.normal(scale=0.5) + 0.5 * np.sin(turn), -7 - 0.9 * r * np.sin(turn)])
            heading = np.degrees(turn) + 90 + self.rng.normal(scale=9)
            self.glb.node(small, at, glb.yaw(heading), self.rng.uniform(0.75, 1.15))
        for x, y, z, heading in ((-4.3, -6.2, 1.2, 200), (-0.4, -6.3, -4.0, 20), (4.6, -5.6, 0.4, 150), (-6.0, -5.2, -3.6, -40), (1.8, -6.6, 2.4, 175)):
            self.glb.node(large, (x, y, z), glb.yaw(heading), self.rng.uniform(0.9, 1.3))


def main():
    made = Underwater()
    parts = (made.sand, made.reef, made.plants, made.wreck, made.above, made.fish)
    glb.build(made.glb, parts, pathlib.Path(__file__).parent / "underwater.glb")


if __name__ == "__main__":
    main()
