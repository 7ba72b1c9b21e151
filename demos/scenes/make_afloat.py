#!/usr/bin/python3
"""Makes what floats in the harbour and on the ocean, a file each: boats, buoys and marks, with their waterline at y = 0.

Metres, +Y up, bows towards +x.
"""
import pathlib

import numpy as np

import glb
from make import boats, moorings, occlusion, shape, texture
from make.shape import Asset, rgb

FOLDER = pathlib.Path(__file__).parent


class Afloat:
    """One thing, in a file of its own."""

    def __init__(self, hull="#2f6f8f"):
        self.glb = glb.Glb()
        self.hull = hull
        self.materials = {}

    def picture(self, image):
        return self.glb.texture(texture.png(image))

    def material(self, name):
        if name not in self.materials:
            make = {
                "wood": lambda: self.glb.material("wood", texture=self.picture(texture.wood()), roughness=0.85),
                "boards": lambda: self.glb.material("boards", texture=self.picture(texture.boards()), roughness=0.8),
                "paint": lambda: self.glb.material("paint", roughness=0.7),
                "gloss": lambda: self.glb.material("gloss", roughness=0.35),
                "leaves": lambda: self.glb.material("canvas", roughness=0.9, doubleSided=True),
                "glass": lambda: self.glb.material("glass", roughness=0.12),
                "hull": lambda: self.glb.material("hull", rgb(self.hull), roughness=0.45),
            }
            self.materials[name] = make[name]()
        return self.materials[name]

    def add(self, name, asset, position=(0, 0, 0), turn=None):
        mesh = self.glb.mesh(name, [(s, self.material(m)) for m, s in asset.joined().items()])
        self.glb.node(mesh, position, turn)
        return mesh

    def write(self, name):
        path = FOLDER / f"{name}.glb"
        self.glb.write(path)
        print(f"{path.name}: {path.stat().st_size} bytes")


def alone(name, asset, hull="#2f6f8f"):
    made = Afloat(hull)
    made.add(name.replace("_", " "), asset)
    made.write(name)


def fishingBoat():
    made = Afloat()
    made.add("fishing boat", occlusion.bake(boats.fishingBoat(), 0.09, 0.7))
    tyre = None
    for p in boats.fenders():
        if tyre is None:
            tyre = made.add("tyre", Asset().add("paint", moorings.tyre()), p)
        else:
            made.glb.node(tyre, p)
    made.add("life ring", Asset().add("gloss", moorings.lifeRing()), (-1.95, 1.15, 1.0))
    colors = ("#d8832f", "#3f78a8", "#d9c24a")
    places = ((-3.2, 0.48, -0.6), (-3.2, 0.48, 0.1), (-3.15, 0.78, -0.55), (-3.3, 0.48, 0.8), (2.7, 0.62, 0.3))
    crates = [
        made.add(f"crate {k}", Asset().add("paint", moorings.crate(c)), places[k], glb.yaw(9 * k))
        for k, c in enumerate(colors)
    ]
    for k in (3, 4):
        made.glb.node(crates[k % 3], places[k], glb.yaw(9 * k))
    made.write("fishing_boat")


def atAnchor(boat):
    """The sailing boat with its rode out, which leads down and ahead, and a ball in the fore rigging."""
    ball = shape.lathe([(0.001, -0.2), (0.14, -0.14), (0.2, 0), (0.14, 0.14), (0.001, 0.2)], 10, rgb("#22242a"), 60)
    out = Asset().include(boat)
    out.add("paint", moorings.rope((4.15, 1.1, 0.0), (11.0, -6.0, 0.0), 0.25, "#8f8a80", 0.02))
    return out.add("paint", shape.move(ball, (2.3, 4.2, 0.0)))


def main():
    rowing = occlusion.bake(boats.rowingBoat(), 0.05, 0.75)
    alone("rowing_boat", rowing)
    alone("dinghy", rowing, "#b5432f")
    sailing = occlusion.bake(boats.sailingBoat(), 0.08, 0.6)
    alone("sailing_boat", sailing)
    alone("sailing_boat_at_anchor", atAnchor(sailing))
    fishingBoat()
    alone("buoy", moorings.ballBuoy())
    alone("white_buoy", moorings.ballBuoy("#eeeae0", 0.3))
    alone("red_mark", moorings.sparBuoy())
    alone("green_mark", moorings.sparBuoy("#2d7a4a", "#2d7a4a"))


if __name__ == "__main__":
    main()
