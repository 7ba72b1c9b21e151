#!/usr/bin/env python3
"""Makes the corpora that the fuzzers begin with: a few small files of each kind, whole and well.

  tests/fuzz/make_corpus.py            into tests/fuzz/corpus, where what fuzzers found stays as it is
  tests/fuzz/make_corpus.py --large FOLDER   files of under 1 MiB that ask for as much work as their kind may, for scripts/fuzz

Nothing is random: the same files come of each call.
"""
import base64
import json
import pathlib
import struct
import sys
import zlib

HERE = pathlib.Path(__file__).resolve().parent


def noise(count, seed=1):
    """Bytes that look like any."""
    state, out = seed, bytearray()
    for _ in range(count):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        out.append(state >> 56)
    return bytes(out)


def png_chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(width, height, rows, color, depth=8, more=b"", interlace=0):
    header = struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, interlace)
    return b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) + more + png_chunk(b"IDAT", zlib.compress(rows, 9)) + png_chunk(b"IEND", b"")


def small_png():
    return png(2, 2, b"\0" + bytes([255, 0, 0, 255] * 2) + b"\0" + bytes([0, 255, 0, 128] * 2), 6)


def jpeg_segment(marker, data):
    return bytes([0xff, marker]) + struct.pack(">H", len(data) + 2) + data


def jpeg(width, height, more=b""):
    """Progressive, of one scan, in which nothing is coded."""
    tables = jpeg_segment(0xdb, b"\0" + b"\1" * 64) + jpeg_segment(0xc4, b"\0" + b"\1" + b"\0" * 15 + b"\0")
    parts = b"".join(bytes([part, 0x11, 0]) for part in (1, 2, 3))
    frame = jpeg_segment(0xc2, b"\x08" + struct.pack(">HH", height, width) + b"\3" + parts)
    scan = jpeg_segment(0xda, b"\3" + bytes([1, 0, 2, 0, 3, 0]) + b"\0\0\0")
    return b"\xff\xd8" + more + tables + frame + scan + b"\0" * 8 + b"\xff\xd9"


def exr_attribute(name, kind, value):
    return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value


def exr(width, height, channels, names=b""):
    """Scan lines of floats, not compressed."""
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    listed = b"".join(name + b"\0" + struct.pack("<iBBBBii", 2, 0, 0, 0, 0, 1, 1) for name in channels) + b"\0"
    head = b"\x76\x2f\x31\x01" + struct.pack("<I", 2) + b"".join((
        exr_attribute(b"channels", b"chlist", listed), exr_attribute(b"compression", b"compression", b"\0"),
        exr_attribute(b"dataWindow", b"box2i", window), exr_attribute(b"displayWindow", b"box2i", window),
        exr_attribute(b"lineOrder", b"lineOrder", b"\0"), exr_attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
        exr_attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0)),
        exr_attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)), names)) + b"\0"
    row = struct.pack(f"<{width * len(channels)}f", *(0.25 * i for i in range(width * len(channels))))
    first = len(head) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * (8 + len(row))) for y in range(height))
    return head + offsets + b"".join(struct.pack("<ii", y, len(row)) + row for y in range(height))


def plate(**more):
    positions = struct.pack("<12f", -1, 0, 0, 1, 0, 0, 1, 2, 0, -1, 2, 0)
    uvs = struct.pack("<8f", 0, 1, 1, 1, 1, 0, 0, 0)
    data = positions + uvs + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    root = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0.25, 1]}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "buffers": [{"byteLength": len(data)}], **more}
    return root, data


def uri_of(data, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def gltf(root, data):
    root["buffers"][0]["uri"] = uri_of(data)
    return json.dumps(root, separators=(",", ":")).encode()


def glb(root, data):
    text = json.dumps(root, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def textured(image=None):
    root, data = plate(textures=[{"source": 0, "sampler": 0}], samplers=[{"wrapS": 33071, "minFilter": 9987}],
                       images=[{"uri": uri_of(image or small_png(), "image/png")}])
    root["materials"][0] = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": {
        "KHR_texture_transform": {"offset": [0.5, 0], "rotation": 0.1}}}}, "alphaMode": "BLEND", "normalTexture": {"index": 0}}
    return root, data


def skinned():
    root, data = plate(skins=[{"joints": [1, 2], "inverseBindMatrices": 5}])
    root["nodes"] = [{"mesh": 0, "skin": 0}, {"children": [2], "translation": [0, 1, 0]}, {"rotation": [0, 0, 0, 1]}]
    root["scenes"][0]["nodes"] = [0, 1]
    views, accessors = root["bufferViews"], root["accessors"]
    for content, component, kind, count in ((bytes([0, 1, 0, 0] * 4), 5121, "VEC4", 4),
                                            (struct.pack("<16f", *[0.5, 0.5, 0, 0] * 4), 5126, "VEC4", 4),
                                            (struct.pack("<32f", *([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] * 2)), 5126, "MAT4", 2)):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": count, "type": kind})
        data += content
    root["meshes"][0]["primitives"][0]["attributes"].update(JOINTS_0=3, WEIGHTS_0=4)
    root["buffers"][0]["byteLength"] = len(data)
    return root, data


# A scene's files have to be there, and loading it looks no further: one that always is.
SCENE = """title = "Sea"
time_s = 1.5

[sky]
file = "/proc/self/exe"
clear = true
haze = 3

[sun]
azimuth_deg = 40
elevation_deg = 40

[fog]
shape = "height"
density_per_m = 0.01

[[mesh]]
file = "/proc/self/exe"
scale = 2

[water]
level_m = 0.0

[water.extent]
shape = "polygon"
points_m = [[-50, -50], [50, -50], [0, 60]]

[water.waves]
wind_m_s = 7.0
samples = 16
cascades = 1
seed = 3

[[water.waves.swells]]
height_m = 0.5
period_s = 9

[water.foam]
bias = 0.1

[water.refraction]
type = "coastal"

[water.reflection]
technique = "hybrid"

[[water.exclusion_volumes]]
points_m = [[0, 0], [1, 0], [0, 1]]

[[camera]]
name = "low"
position_m = [0, 2, 10]
target_m = [0, 1, 0]
near_m = 0.1

[[camera.keyframes]]
time_s = 4
position_m = [0, 3, 10]
target_m = [0, 1, 0]
roll_deg = 5
"""

FLOOR = """[sky]
file = "/proc/self/exe"
[floor]
normal = [0, 1, 0.1]
width_m = 10
[floor.reflection]
technique = "sspr"
[[camera]]
name = "a"
position_m = [0, 2, 10]
target_m = [0, 0, 0]
"""


def interlaced():
    """3x3 pixels of 16 bits, by Adam7."""
    passes = ((1, 1), (1, 1), (2, 1), (1, 2), (3, 1))   # of such a size those that hold anything
    rows = b"".join((b"\0" + noise(6 * width)) * height for width, height in passes)
    return png(3, 3, rows, 2, 16, interlace=1)


def palette():
    return png(2, 2, b"\0\0\1\0\2\1", 3, 8, png_chunk(b"PLTE", noise(9)) + png_chunk(b"tRNS", b"\xff\x80"))


def exr_of_tiles():
    """2x2 texels in a tile of 2x2."""
    tiles = exr_attribute(b"tiles", b"tiledesc", struct.pack("<IIB", 2, 2, 0))
    head = exr(2, 2, (b"B", b"G", b"R"), tiles)
    head = head[:4] + struct.pack("<I", 0x202) + head[8:len(head) - 2 * (8 + 8 + 24)]
    data = struct.pack("<12f", *(0.25 * i for i in range(12)))
    return head + struct.pack("<Q", len(head) + 8) + struct.pack("<iiiii", 0, 0, 0, 0, len(data)) + data


def exr_by(compression):
    """As exr(), of 16 bits and in blocks that did not become smaller."""
    whole = exr(2, 1, (b"B", b"G", b"R"))
    return whole.replace(b"compression\0\1\0\0\0\0", b"compression\0\1\0\0\0" + bytes([compression]))


def exr_of_parts(named):
    """Of each its name, and attributes."""
    parts = []
    for name, attributes in named:
        more = attributes + b"".join((exr_attribute(b"name", b"string", name), exr_attribute(b"type", b"string", b"scanlineimage"),
                                      exr_attribute(b"chunkCount", b"int", struct.pack("<i", 1))))
        whole = exr(1, 1, (b"B", b"G", b"R"), more)
        parts.append((whole[8:-28], whole[-20:]))
    heads = b"\x76\x2f\x31\x01" + struct.pack("<I", 0x1002) + b"".join(head for head, _ in parts) + b"\0"
    chunks = [struct.pack("<i", i) + chunk for i, (_, chunk) in enumerate(parts)]
    first = len(heads) + 8 * len(chunks)
    return heads + b"".join(struct.pack("<Q", first + i * len(chunks[0])) for i in range(len(chunks))) + b"".join(chunks)


def with_view(root, data, content, component, kind, count):
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
    root["accessors"].append({"bufferView": len(root["bufferViews"]) - 1, "componentType": component, "count": count, "type": kind})
    root["buffers"][0]["byteLength"] = len(data) + len(content)
    return data + content


def instanced():
    root, data = plate(extensionsUsed=["EXT_mesh_gpu_instancing"])
    data = with_view(root, data, struct.pack("<6f", 0, 0, 0, 3, 0, 0), 5126, "VEC3", 2)
    root["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 3}}}
    return root, data


def morphed():
    root, data = plate()
    data = with_view(root, data, struct.pack("<12f", *[0.5] * 12), 5126, "VEC3", 4)
    root["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 3}]
    root["meshes"][0]["weights"] = [0.5]
    return root, data


def sparse():
    root, data = plate()
    data = with_view(root, data, struct.pack("<2H", 1, 3), 5123, "SCALAR", 2)
    data = with_view(root, data, struct.pack("<6f", *[2] * 6), 5126, "VEC3", 2)
    root["accessors"][0]["sparse"] = {"count": 2, "indices": {"bufferView": 3, "componentType": 5123}, "values": {"bufferView": 4}}
    return root, data


def corpora():
    yield "png", "rgba", small_png()
    yield "png", "grey16_with_gamma", png(3, 1, b"\0" + noise(6), 0, 16, png_chunk(b"gAMA", struct.pack(">I", 45455)))
    yield "png", "with_text", png(1, 1, b"\0\1\2\3", 2, 8, png_chunk(b"zTXt", b"a\0\0" + zlib.compress(b"text")) +
                                  png_chunk(b"sRGB", b"\0"))
    yield "png", "interlaced16", interlaced()
    yield "png", "jpeg", jpeg(8, 8, jpeg_segment(0xe1, b"Exif\0\0" + exif([(0x112, 6)])) + jpeg_segment(0xfe, b"text"))
    yield "png", "jpeg_of_65500", jpeg(65500, 65500)
    yield "png", "jpeg_behind_a_marker_without_length", jpeg(65500, 65500, b"\xff\x01")
    yield "png", "palette", palette()
    yield "hdr", "runs_of_old", b"#?RGBE\n\n-Y 1 +X 6\n" + bytes([9, 9, 9, 129, 1, 1, 1, 5])
    yield "exr", "tiles", exr_of_tiles()
    yield "exr", "parts", exr_of_parts([(b"depth", b""), (b"beauty", b"")])
    for compression in range(1, 10):
        yield "exr", f"compressed{compression}", exr_by(compression)
    for name, (root, data) in (("instanced", instanced()), ("morphed", morphed()), ("sparse", sparse())):
        yield "gltf", f"{name}.gltf", gltf(root, data)
    yield "hdr", "flat", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y 2 +X 2\n" + bytes([128, 64, 32, 129] * 4)
    yield "hdr", "turned", (b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nPRIMARIES=.64 .33 .3 .6 .15 .06 .3127 .329\n\n+X 8 -Y 1\n" +
                            bytes([2, 2, 0, 8] + [136, 5] * 4))
    yield "exr", "rgb", exr(2, 2, (b"B", b"G", b"R"))
    yield "exr", "layers", exr(1, 2, (b"A", b"ao.Y", b"beauty.B", b"beauty.G", b"beauty.R"))
    yield "csv", "table", b"hertz,density\n0.05,0.1\n0.1,2\n0.2,0.5\n"
    yield "csv", "comments", b"# of a buoy\n\n0.04,0\n0.08,1e1\n"
    yield "gltf", "plate.gltf", gltf(*plate())
    yield "gltf", "plate.glb", glb(*plate())
    yield "gltf", "textured.gltf", gltf(*textured())
    yield "gltf", "skinned.gltf", gltf(*skinned())
    yield "scene", "sea.toml", SCENE.encode()
    yield "scene", "floor.toml", FLOOR.encode()
    for name, line in (("render", "render a.toml -o a.png --size 64x48 --set water.level_m=1 --time 5"),
                       ("compare", "compare a.png b.png --max-flip 0.1 --max-diff 0.1 --max-share 0.01 --layer left --ignore 4x4+1+2"),
                       ("sea", "sea --wind 10 --samples 64 --json"), ("measure", "measure a.toml -o out --rounds 2 --technique sspr --quick"),
                       ("reference", "reference a.toml -o a.exr --spp 4 --seed 7"), ("help", "render --help"),
                       ("bless", "bless shots out a.png --yes --driver auto"), ("view", "view a.toml --frames 3 --dt 0.1 --screenshot a.png")):
        yield "command", name, line.replace(" ", "\n").encode()
    yield "compare", "equal", bytes([0, 3, 3]) + struct.pack("<128f", *([0.5] * 128))
    yield "compare", "unlike", bytes([1, 3, 3]) + struct.pack("<128f", *(i / 32 for i in range(128)))
    for seed in range(1, 9):
        yield "api", f"any{seed}", noise(600, seed)
    yield "api", "all_as_new", bytes([1] * 600)


def repeated_notes():
    root, data = plate()
    root["meshes"][0]["primitives"][0]["extensions"] = {f"EXT_{i:x}": {} for i in range(40000)}
    root["nodes"] = [{"mesh": 0}] * 20000
    root["scenes"][0]["nodes"] = list(range(20000))
    return gltf(root, data)


def many_joints():
    root, data = skinned()
    root["skins"][0] = {"joints": [1] * 200000}
    root["nodes"] += [{"mesh": 0, "skin": 0}] * 5
    root["scenes"][0]["nodes"] = [0, 1, *range(3, 8)]
    return gltf(root, data)


def one_image_often():
    image = png(1, 1, b"\0\1\2\3", 2, 8, png_chunk(b"tEXt", b"a\0" + noise(500000).replace(b"\0", b"a")))
    root, data = textured(image)
    root["textures"] = [{"source": 0}] * 1024
    root["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(256)]
    root["meshes"][0]["primitives"] = [{**root["meshes"][0]["primitives"][0], "material": i} for i in range(256)]
    return gltf(root, data)


def long_name():
    root, data = plate()
    root["meshes"][0]["name"] = "a" * 500000
    root["nodes"] = [{"mesh": 0}] * 20000
    root["scenes"][0]["nodes"] = list(range(20000))
    return gltf(root, data)


def attributes(parts, each):
    """EXRs look up each attribute among all before it."""
    many = b"".join(exr_attribute(b"a%x" % i, b"int", b"\0\1\2\3") for i in range(each))
    if parts == 1:
        return exr(1, 1, (b"B", b"G", b"R"), many)
    return exr_of_parts([(b"%d" % i, many) for i in range(parts)])


def xmp(levels):
    """OpenImageIO descends into these by calling itself."""
    return b"<rdf:RDF><rdf:Description>" + b"<a>" * levels + b"1" + b"</a>" * levels + b"</rdf:Description></rdf:RDF>"


def exif(tags):
    """Short numbers: (tag, value)."""
    return b"II*\0" + struct.pack("<IH", 8, len(tags)) + b"".join(struct.pack("<HHII", tag, 3, 1, v) for tag, v in tags) + b"\0" * 4


def exif_within_exif(levels):
    return b"II*\0" + struct.pack("<I", 8) + b"".join(struct.pack("<HHHIII", 1, 0x8769, 4, 1, 26 + 18 * i, 0) for i in range(levels))


def png_with(name, data):
    return png(1, 1, b"\0\1\2\3", 2, 8, png_chunk(name, data))


def keywords(segments):
    """Each is put behind all before it, of this and of the other segments."""
    words = b"\x1c\x02\x19\0\x01k" * 10000
    return jpeg_segment(0xed, b"Photoshop 3.0\0" + b"8BIM\x04\x04\0\0" + struct.pack(">I", len(words)) + words) * segments


def sparse_colors():
    """A few vertices, of which each colour is replaced 80,000 times, in each of 6,000 primitives."""
    root, data = plate()
    size = 240000
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": size})
    replaced = {"count": size // 3, "indices": {"bufferView": 3, "componentType": 5121}, "values": {"bufferView": 3}}
    root["accessors"].append({"componentType": 5121, "count": 4, "type": "VEC3", "sparse": replaced})
    root["buffers"][0]["byteLength"] = len(data) + size
    root["meshes"][0]["primitives"] = [{"attributes": {"POSITION": 0, "COLOR_0": 3}, "indices": 2}] * 6000
    return gltf(root, data + b"\0" * size)


def many_targets():
    root, data = plate()
    root["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 0}] * 20000
    root["meshes"][0]["weights"] = [1] * 20000
    root["nodes"] = [{"mesh": 0}] * 300
    root["scenes"][0]["nodes"] = list(range(300))
    return gltf(root, data)


def flat(width, height):
    return png(width, height, (b"\0" + b"\0" * width) * height, 0)


def large():
    yield "gltf", "notes", repeated_notes()
    yield "gltf", "joints", many_joints()
    yield "gltf", "data_uri_image", one_image_often()
    yield "gltf", "long_name", long_name()
    yield "gltf", "nested", b"[" * 500000
    yield "gltf", "sparse_colors", sparse_colors()
    yield "gltf", "targets", many_targets()
    yield "gltf", "image_of_xmp", gltf(*textured(png_with(b"iTXt", b"XML:com.adobe.xmp\0\0\0\0\0" + xmp(50000))))
    yield "gltf", "image_of_65500", gltf(*textured(jpeg(65500, 65500)))
    yield "png", "xmp", png_with(b"tEXt", b"XML:com.adobe.xmp\0" + xmp(120000))
    yield "png", "exif_within_exif", png_with(b"eXIf", exif_within_exif(50000))
    yield "png", "jpeg_of_65500", jpeg(65500, 65500)
    yield "png", "jpeg_of_keywords", jpeg(8, 8, keywords(14))
    yield "png", "jpeg_of_comments", jpeg(8, 8, b"".join(jpeg_segment(0xfe, b"k%d:v" % i) for i in range(60000)))
    yield "exr", "layers", exr(1, 1, [b"%05x.R" % i for i in range(30000)])
    yield "png", "flat", flat(16384, 128)
    yield "exr", "attributes", attributes(1, 45000)
    yield "exr", "attributes_of_parts", attributes(40, 1000)
    yield "csv", "lines", b"0.1,1\n" * 170000
    yield "scene", "tables", SCENE.encode() + b'[[mesh]]\nfile = "a"\n' * 40000
    yield "scene", "keys", b".".join([b"a"] * 500000) + b" = 1\n"
    yield "command", "words", b"render\n" + b"--set\na=1\n" * 30


def main():
    to_large = sys.argv[1:2] == ["--large"]
    if len(sys.argv) != (3 if to_large else 1):
        sys.exit(__doc__)
    folder, files = (pathlib.Path(sys.argv[2]), large()) if to_large else (HERE / "corpus", corpora())
    for target, name, content in files:
        assert not to_large or len(content) < 2**20, f"{name} is of {len(content)} bytes"
        (folder / target).mkdir(parents=True, exist_ok=True)
        (folder / target / name).write_bytes(content)


if __name__ == "__main__":
    main()
