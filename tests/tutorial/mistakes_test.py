"""mistakes_test.py AFTER OUT: makes each mistake of docs/faq.md in demos/tutorial with its water, and holds what comes of it
to what the page says: the library's own words where it sees the mistake, else what it does to the picture. Leaves the
pictures, cut to what matters, in OUT as PNG."""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import zlib

WIDTH, HEIGHT = 480, 270


class Mistake:
    def __init__(self, name, *edits, says=None, shows=None):
        self.name, self.edits, self.says, self.shows = name, edits, says, shows


# Boxes of the picture, (left, top, right, bottom) of 480x270.
NEAR = (120, 200, 360, 265)      # water over the bed, before the eye
MIRROR = (120, 170, 150, 230)    # where the lighthouse is mirrored
HORIZON = (0, 129, 24, 135)      # the open sea beyond the point


def mean(picture, box):
    left, top, right, bottom = box
    pixels = [picture[y][x] for y in range(top, bottom) for x in range(left, right)]
    return [sum(pixel[c] for pixel in pixels) / len(pixels) for c in range(3)]


def brightness(picture, box):
    return sum(mean(picture, box)) / 3


def share_changed(right, wrong, box=(0, 0, WIDTH, HEIGHT), by=8):
    left, top, right_edge, bottom = box
    changed = [max(abs(a - b) for a, b in zip(right[y][x], wrong[y][x])) > by
               for y in range(top, bottom) for x in range(left, right_edge)]
    return sum(changed) / len(changed)


LIGHT = "    const seaglass::LightingDesc light = seaglass::lightingDesc(toSun, 3.14159f * sunLight);\n"
CHANGED_LIGHT = LIGHT.replace("const ", "")
DEPTH_COPY = ("    check(seaglass::recordSceneCopy(context_, commands,\n"
              "                                    {depth_.image, depthCopy_.image,\n"
              "                                     VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, depthCopy_.aspect,\n"
              "                                     extent_}));\n")

# A host that writes colour as displays take it, into a UNORM swapchain.
ENCODED = (("engine.h", "VK_FORMAT_B8G8R8A8_SRGB", "VK_FORMAT_B8G8R8A8_UNORM"),
           ("mesh.frag", "outColor = vec4(light, 1);",
            "outColor = vec4(mix(12.92 * light, 1.055 * pow(light, vec3(1 / 2.4)) - 0.055,\n"
            "                        greaterThan(light, vec3(0.0031308))), 1);"),
           ("engine.cpp", "    clears[0].color = {{haze.r, haze.g, haze.b, 1}};",
            "    const glm::vec3 held = 1.055f * glm::pow(haze, glm::vec3(1 / 2.4f)) - 0.055f;\n"
            "    clears[0].color = {{held.r, held.g, held.b, 1}};"))

MISTAKES = [
    # What the library says itself.
    Mistake("row_major", ("engine.cpp", "viewDesc(camera_.view,", "viewDesc(glm::transpose(camera_.view),"),
            says="ViewDesc.view has a last row other than 0, 0, 0, 1, expected it column-major"),
    Mistake("depth_direction", ("engine.cpp", "/*reversedDepth=*/false", "/*reversedDepth=*/true"),
            says="expected TargetDesc.reversedDepth to be false"),
    Mistake("no_simulate", ("engine.cpp", "    check(seaglass::simulate(commands, &water_, 1, frameNumber_ / 60.0));\n", ""),
            says="simulate() was never called"),
    Mistake("sky_layout", ("engine.cpp", LIGHT, CHANGED_LIGHT + "    light.skyCube = colorCopy_.view, light.skyCubeLayout = VK_IMAGE_LAYOUT_UNDEFINED;\n"),
            says="LightingDesc.skyCubeLayout is none to sample from"),
    Mistake("view_projection", ("engine.cpp", "viewDesc(camera_.view, camera_.projection,",
                                "viewDesc(camera_.view, camera_.projection * camera_.view,"),
            says="ViewDesc.projection has its centre beside the eye"),
    Mistake("z_up", ("engine.cpp", "    body.waves = &sea;\n",
                     "    body.waves = &sea;\n    body.plane[1] = 0, body.plane[2] = 1;\n"),
            says="BodyDesc.plane does not face up"),
    Mistake("attachment_layout", ("engine.cpp", "view.sceneDepth = {depthCopy_.view, depthFormat, extent_, read};",
                                  "view.sceneDepth = {depthCopy_.view, depthFormat, extent_, "
                                  "VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};"),
            says="ViewDesc.sceneDepth.layout is none to sample from"),
    Mistake("long_sun", ("engine.cpp", "lightingDesc(toSun,", "lightingDesc(2.0f * toSun,"),
            says="LightingDesc.toSun is not a unit vector"),
    # What Vulkan's validation says.
    Mistake("depth_not_copied", ("engine.cpp", DEPTH_COPY, ""), says="current layout is VK_IMAGE_LAYOUT_UNDEFINED"),
    Mistake("not_sampled", ("engine.cpp", "VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;",
                            "VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;"), says="VUID"),
    Mistake("features_off", ("engine.cpp", "    deviceInfo.pNext = &needs.features13;\n", ""), says="VUID"),
    # What is no mistake.
    Mistake("scaled_plane", ("engine.cpp", "    body.waves = &sea;\n",
                             "    body.waves = &sea;\n    body.plane[1] = 2;\n"),
            shows=lambda right, wrong: right == wrong),
    Mistake("encoded_target_said", *ENCODED,
            ("engine.cpp", "    target.renderPass = waterPass_;\n",
             "    target.renderPass = waterPass_;\n    target.encoding = seaglass::Encoding::srgb;\n"),
            ("engine.cpp", "    view.sceneDepth =", "    view.sceneColor.encoding = seaglass::Encoding::srgb;\n    view.sceneDepth ="),
            shows=lambda right, wrong: share_changed(right, wrong, by=2) == 0),
    # What is said, and shows.
    Mistake("encoded_target", *ENCODED, says="TargetDesc.colorFormat is UNORM, and taken for linear",
            shows=lambda right, wrong: brightness(wrong, NEAR) < brightness(right, NEAR) * 0.7),
    # What shows alone.
    Mistake("y_not_flipped", ("engine.cpp", "    seaglass::ViewDesc view = seaglass::viewDesc(camera_.view, camera_.projection, extent_);\n",
                              "    glm::mat4 told = camera_.projection;\n    told[1][1] *= -1;\n"
                              "    seaglass::ViewDesc view = seaglass::viewDesc(camera_.view, told, extent_);\n"),
            shows=lambda right, wrong: share_changed(right, wrong) > 0.3),
    Mistake("srgb_twice", ("engine.cpp", "colorCopy_ = createImage(swapchainFormat,",
                           "colorCopy_ = createImage(VK_FORMAT_B8G8R8A8_UNORM,"),
            ("engine.cpp", "{colorCopy_.view, swapchainFormat,", "{colorCopy_.view, VK_FORMAT_B8G8R8A8_UNORM,"),
            says="ViewDesc.sceneColor.format is UNORM, and taken for linear",
            shows=lambda right, wrong: brightness(wrong, NEAR) > brightness(right, NEAR) * 1.2),
    Mistake("black_sky", ("engine.cpp", LIGHT, CHANGED_LIGHT + "    for (int i = 0; i < 3; ++i)\n"
                          "        light.skyZenith[i] = light.skyHorizon[i] = light.skyGround[i] = 0;\n"),
            shows=lambda right, wrong: brightness(wrong, HORIZON) < brightness(right, HORIZON) * 0.3),
    Mistake("no_reflect", ("engine.cpp", "    check(seaglass::reflect(commands, &water_, 1, &view));\n", ""),
            shows=lambda right, wrong: share_changed(right, wrong, MIRROR) > 0.5),
    Mistake("no_refraction", ("engine.cpp", "    body.refraction = &refraction;\n", ""),
            shows=lambda right, wrong: brightness(wrong, NEAR) < brightness(right, NEAR) * 0.8),
    Mistake("sky_not_far", ("engine.cpp", "clears[1].depthStencil.depth = 1;", "clears[1].depthStencil.depth = 0.999f;"),
            shows=lambda right, wrong: share_changed(right, wrong, HORIZON) > 0.5),
    Mistake("near_far_plane", ("scene.cpp", "0.1f, 500.0f)", "0.1f, 40.0f)"),
            shows=lambda right, wrong: share_changed(right, wrong, HORIZON) > 0.5),
    Mistake("eye_in_water", ("scene.cpp", "glm::vec3(-1, 2.2f, 6)", "glm::vec3(-1, -0.8f, 6)"),
            says="under a body without BodyDesc.underwater",
            shows=lambda right, wrong: share_changed(right, wrong) > 0.5),
    Mistake("wrong_wind", ("engine.cpp", "SpectrumModel::jonswap, 3, 0, 300}", "SpectrumModel::jonswap, 12, 0, 100e3f}"),
            shows=lambda right, wrong: share_changed(right, wrong) > 0.2),
]


def read_ppm(path):
    data = path.read_bytes()
    header = f"P6 {WIDTH} {HEIGHT} 255\n".encode()
    assert data.startswith(header), data[:32]
    pixels = data[len(header):]
    return [[pixels[3 * (y * WIDTH + x):3 * (y * WIDTH + x) + 3] for x in range(WIDTH)] for y in range(HEIGHT)]


def write_png(path, picture):
    rows = b"".join(b"\0" + b"".join(row) for row in picture)
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def draw(program, ppm):
    """What the program says under validation, and its picture if it left one."""
    ppm.unlink(missing_ok=True)
    environment = dict(os.environ, VK_INSTANCE_LAYERS="VK_LAYER_KHRONOS_validation")
    done = subprocess.run([program, ppm, str(WIDTH), str(HEIGHT)], capture_output=True, text=True, env=environment)
    return done.stdout + done.stderr, read_ppm(ppm) if ppm.exists() else None


def build_and_draw(folder):
    done = subprocess.run(["cmake", "--build", folder / "build"], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(done.stdout + done.stderr)
    return draw(folder / "build/tutorial", folder / "picture.ppm")


def make(mistake, folder, sources):
    for name, text in sources.items():
        (folder / name).write_text(text)
    for name, before, after in mistake.edits:
        text = (folder / name).read_text()
        if text.count(before) != 1:
            return f"{name} no longer has '{before}' once"
        (folder / name).write_text(text.replace(before, after))
    return None


def judge(mistake, said, picture, right):
    if mistake.says is not None and mistake.says not in said:
        return f"expected it to say '{mistake.says}', it says: {said[:2000]}"
    if mistake.shows is None:
        return None
    if (said and mistake.says is None) or picture is None:
        return f"expected a picture and no word, it says: {said[:2000]}"
    return None if mistake.shows(right, picture) else "the picture is not what the page says"


def main():
    after, out = map(pathlib.Path, sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    folder = out / "tree"
    if folder.exists():
        shutil.rmtree(folder)
    shutil.copytree(after, folder, ignore=shutil.ignore_patterns("build"))
    subprocess.run(["cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", "-D", "CMAKE_BUILD_TYPE=Debug",
                    "-D", f"CMAKE_PREFIX_PATH={after.parent / 'prefix'}"], check=True, capture_output=True)
    sources = {path.name: path.read_text() for path in after.glob("*.*") if path.is_file()}
    said, right = build_and_draw(folder)
    if said or right is None:
        raise SystemExit(f"without any mistake: {said}")
    write_png(out / "right.png", right)
    for state in ("before", "water", "cove", "mirrors", "foam", "dive"):
        said, picture = draw(after.parent / state / "build/tutorial", out / f"{state}.ppm")
        if said or picture is None:
            raise SystemExit(f"{state}: {said}")
        write_png(out / f"{state}.png", picture)
    problems = []
    for mistake in MISTAKES:
        problem = make(mistake, folder, sources)
        if not problem:
            said, picture = build_and_draw(folder)
            if picture:
                write_png(out / f"{mistake.name}.png", picture)
            problem = judge(mistake, said, picture, right)
        print(f"{mistake.name}: {problem or 'as the page says'}", flush=True)
        if problem:
            problems.append(mistake.name)
    return 1 if problems else 0


sys.exit(main())
