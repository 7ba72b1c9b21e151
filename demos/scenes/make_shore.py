#!/usr/bin/python3
"""Makes shore.glb and shore_bed.glb: an island with a sandy bay, palms, dunes, rocks and a rowing boat, all but its water. The
second is what waves run up: sand and rocks.

In metres, +Y up, calm water at y = 0, the sea towards -z. Composed for an eye at about (-7, 2.2, 8) looking along the
water's edge towards +x and -z.
"""
import pathlib

import numpy as np

import glb
from make import beach, boats, land, occlusion, palms, rocks, shape, texture
from make.shape import Asset, rgb


class Scene:
    def __init__(self, seed):
        self.glb = glb.Glb()
        self.rng = np.random.default_rng(seed)

    def mesh(self, name, asset):
        return self.glb.mesh(name, [(s, self.materials[m]) for m, s in asset.joined().items()])

    def foot(self, x, z, sunk=0.0):
        return (x, float(beach.height(np.array(x), np.array(z))) - sunk, z)


class Bed(Scene):
    def __init__(self):
        super().__init__(31)
        sand = self.glb.texture(texture.png(beach.sand()))
        stone = self.glb.texture(texture.png(texture.rock()))
        self.materials = {
            "sand": self.glb.material("sand", texture=sand, roughness=1.0),
            "stone": self.glb.material("stone", texture=stone, roughness=0.9),
        }

    def sand(self):
        self.glb.node(self.mesh("sand", Asset().add("sand", beach.bed())))

    def stones(self):
        tones = (rgb("#7d756a"), rgb("#8c7f6c"), rgb("#655f58"))
        kinds = [self.mesh(f"rock {k}", Asset().add("stone", rocks.boulder(40 + k, tones[k % 3], 2))) for k in range(5)]
        spots = [(13.0, -11.5, 4.2), (16.2, -9.2, 3.0), (15.0, -14.5, 3.4), (10.6, -13.0, 1.8), (18.6, -12.2, 2.4)]
        spots += [(-21, -9.0, 3.6), (-24, -6.5, 2.6), (-19.0, -12.0, 2.2)]
        for side in (-1, 1):  # the headlands
            for _ in range(46):
                x = side * abs(self.rng.normal(84, 9))
                spots.append((x, beach.edge(x) + self.rng.normal(-4, 10), self.rng.uniform(2.5, 8.5)))
        for x, z, size in spots:
            turn = glb.yaw(self.rng.uniform(0, 360))
            self.glb.node(kinds[self.rng.integers(5)], self.foot(x, z, 0.10 * size), turn, size * np.array([1, 0.85, 1]))


class Land(Scene):
    def __init__(self):
        super().__init__(47)
        wood = self.glb.texture(texture.png(texture.wood()))
        self.materials = {
            "leaf": self.glb.material("leaf", roughness=0.7, doubleSided=True),
            "paint": self.glb.material("paint", roughness=0.8),
            "wood": self.glb.material("wood", texture=wood, roughness=0.85),
            "gloss": self.glb.material("gloss", roughness=0.6),
            "hull": self.glb.material("hull", rgb("#2f7f8f"), roughness=0.5),
        }

    def trees(self):
        kinds = [self.mesh(f"palm {k}", palms.palm(k + 3, 6.5 + 1.1 * k)) for k in range(3)]
        spots = [(22, 11.5, 160), (25.5, 14, 100), (29, 12, 205), (34, 15, 140), (19.5, 17.5, 190), (40, 9, 170), (46, 11, 120)]
        spots += [(12.5, 6.2, 110), (15.5, 8.6, 75), (14.0, 10.2, 150), (10.5, 18.0, 150), (-20, 19, 60), (-25, 16, 20), (-31, 20, 95), (55, 6, 150), (62, 2, 185), (68, 3, 130)]
        for _ in range(60):
            x = self.rng.uniform(-90, 95)
            spots.append((x, beach.edge(x) + self.rng.uniform(34, 62), self.rng.uniform(0, 360)))
        for x, z, turn in spots:
            size = self.rng.uniform(0.85, 1.2)
            self.glb.node(kinds[self.rng.integers(3)], self.foot(x, z, 0.1), glb.yaw(turn), size)

    def grass(self):
        kinds = [self.mesh(f"marram {k}", Asset().add("leaf", palms.tuft(k + 9))) for k in range(3)]
        for _ in range(620):
            x = self.rng.uniform(-60, 80)
            z = beach.edge(x) + 15 + abs(self.rng.normal(scale=13))
            thick = land.waves(np.array(x), np.array(z), 51, 9.0, 2)
            if float(thick) + self.rng.normal(scale=0.25) < -0.05:
                continue
            self.glb.node(kinds[self.rng.integers(3)], self.foot(x, z), glb.yaw(self.rng.uniform(0, 360)), self.rng.uniform(0.8, 1.7))

    def boat(self):
        mesh = self.mesh("rowing boat", occlusion.bake(boats.rowingBoat(), 0.05, 0.75))
        x, z = 5.6, 4.4
        heel = np.array([np.sin(np.radians(9) / 2), 0, 0, np.cos(np.radians(9) / 2)])
        self.glb.node(mesh, self.foot(x, z, -0.16), glb.times(glb.yaw(58), heel))


def main():
    folder = pathlib.Path(__file__).parent
    bed = Bed()
    glb.build(bed.glb, (bed.sand, bed.stones), folder / "shore_bed.glb")
    made = Land()
    glb.build(made.glb, (made.trees, made.grass, made.boat), folder / "shore.glb")


if __name__ == "__main__":
    main()
