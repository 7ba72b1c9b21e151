"""Writes binary glTF 2.0 without extensions: float positions and normals, normalised 8-bit colours, 16-bit indices
where they reach, embedded PNG textures. Only what is used is written."""
import json
import struct

import numpy as np

FLOAT, BYTE, SHORT, INT = 5126, 5121, 5123, 5125
VERTICES, INDICES = 34962, 34963


class Glb:
    def __init__(self):
        self.json = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": []}],
            "nodes": [],
            "meshes": [],
            "materials": [],
            "accessors": [],
            "bufferViews": [],
            "buffers": [],
        }
        self.data = bytearray()
        self.known = {}
        self.arrays = {}  # bytes of accessors by (target, stride), a buffer view each

    def texture(self, png):
        self.json.setdefault("images", []).append({"bufferView": png, "mimeType": "image/png"})
        self.json.setdefault("samplers", [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}])
        self.json.setdefault("textures", []).append({"source": len(self.json["images"]) - 1, "sampler": 0})
        return len(self.json["textures"]) - 1

    def material(self, name, color=(1, 1, 1), texture=None, roughness=0.9, metallic=0.0, doubleSided=False):
        surface = {
            "baseColorFactor": [round(float(c), 4) for c in color] + [1],
            "roughnessFactor": roughness,
            "metallicFactor": metallic,
        }
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
        material = {"name": name, "pbrMetallicRoughness": surface}
        if doubleSided:
            material["doubleSided"] = True
        self.json["materials"].append(material)
        return len(self.json["materials"]) - 1

    def mesh(self, name, parts):
        """`parts`: pairs of a Surface and a material; a surface without `uv` gets none."""
        primitives = []
        for surface, material in parts:
            attributes = {
                "POSITION": self._accessor(surface.p.astype("<f4"), FLOAT, "VEC3", bounds=True),
                "NORMAL": self._accessor(surface.n.astype("<f4"), FLOAT, "VEC3"),
                "COLOR_0": self._accessor(colorBytes(surface.c), BYTE, "VEC4", normalized=True),
            }
            if surface.uv is not None:
                attributes["TEXCOORD_0"] = self._accessor(surface.uv.astype("<f4"), FLOAT, "VEC2")
            small = len(surface.p) < 65535
            indices = surface.t.ravel().astype("<u2" if small else "<u4")
            primitives.append(
                {
                    "attributes": attributes,
                    "material": material,
                    "indices": self._accessor(indices, SHORT if small else INT, "SCALAR", INDICES),
                }
            )
        self.json["meshes"].append({"name": name, "primitives": primitives})
        return len(self.json["meshes"]) - 1

    def node(self, mesh, position=(0, 0, 0), rotation=None, scale=None):
        """`rotation`: quaternion x, y, z, w."""
        node = {"mesh": mesh}
        if any(position):
            node["translation"] = brief(position, 3)
        if rotation is not None:
            node["rotation"] = brief(rotation, 4)
        if scale is not None:
            node["scale"] = brief(np.broadcast_to(scale, 3), 2)
        self.json["nodes"].append(node)
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def size(self):
        return sum(len(content) for _, content in self.arrays.values())

    def write(self, path):
        for (target, stride), (_, content) in self.arrays.items():
            self._view(content, target, stride)
        for image in self.json.get("images", []):
            image["bufferView"] = self._view(image["bufferView"])
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        body = bytes(self.data) + b"\0" * (-len(self.data) % 4)
        size = 12 + 8 + len(text) + 8 + len(body)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sIIII", b"glTF", 2, size, len(text), 0x4E4F534A) + text)
            file.write(struct.pack("<II", len(body), 0x004E4942) + body)

    def _view(self, content, target=None, stride=None):
        self.data += b"\0" * (-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)}
        if target:
            view["target"] = target
        if target == VERTICES:
            view["byteStride"] = stride
        self.data += content
        self.json["bufferViews"].append(view)
        return len(self.json["bufferViews"]) - 1

    def _accessor(self, array, component, kind, target=VERTICES, normalized=False, bounds=False):
        """Equal arrays are stored once: meshes that differ in material alone share them."""
        content = array.tobytes()
        key = (content, component, kind, target)
        if key in self.known:
            return self.known[key]
        stride = array.itemsize * (array.shape[1] if array.ndim > 1 else 1)
        view = self.arrays.setdefault((target, stride), [len(self.arrays), bytearray()])
        accessor = {
            "bufferView": view[0],
            "byteOffset": len(view[1]),
            "componentType": component,
            "count": len(array),
            "type": kind,
        }
        view[1].extend(content + b"\0" * (-len(content) % 4))
        if normalized:
            accessor["normalized"] = True
        if bounds:
            accessor["min"] = [float(str(v)) for v in array.min(0)]
            accessor["max"] = [float(str(v)) for v in array.max(0)]
        self.json["accessors"].append(accessor)
        self.known[key] = len(self.json["accessors"]) - 1
        return len(self.json["accessors"]) - 1


def build(glb, parts, path):
    """Adds the parts, functions of a scene, says how large each is, and writes the file."""
    for part in parts:
        before = glb.size()
        part()
        print(f"{part.__name__:10} {(glb.size() - before) / 1000:7.0f} kB")
    glb.write(path)
    print(f"{path.name}: {path.stat().st_size} bytes")


def brief(values, digits):
    """Rounded, whole numbers without a point: there are hundreds of nodes."""
    rounded = [round(float(v), digits) for v in values]
    return [int(v) if v == int(v) else v for v in rounded]


def colorBytes(color):
    rgba = np.full((len(color), 4), 255, np.uint8)
    rgba[:, :3] = np.clip(color * 255 + 0.5, 0, 255)
    return rgba


def yaw(degrees):
    """Quaternion of a turn about +Y; positive turns +Z towards +X."""
    half = np.radians(degrees) / 2
    return np.array([0, np.sin(half), 0, np.cos(half)])


def times(a, b):
    """Quaternion product: first b, then a."""
    x1, y1, z1, w1 = a
    x2, y2, z2, w2 = b
    return np.array(
        [
            w1 * x2 + x1 * w2 + y1 * z2 - z1 * y2,
            w1 * y2 - x1 * z2 + y1 * w2 + z1 * x2,
            w1 * z2 + x1 * y2 - y1 * x2 + z1 * w2,
            w1 * w2 - x1 * x2 - y1 * y2 - z1 * z2,
        ]
    )
