// Materials of glTF files as the host draws them, beside what they say and beside the reference.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "scene/scene.h"
#include "tests/gltf/plate.h"
#include "tests/program/run.h"
#include "tests/program/sample.h"
#include "tests/reference/rendered_picture.h"
#include "tests/reference/traced_picture.h"

namespace {

using demos::Picture;
using tests::Json;
using tests::Plate;

constexpr uint32_t width = 96, height = 72;

const std::vector<uint8_t> black = {0, 0, 0, 255}, white = {255, 255, 255, 255}, red = {255, 0, 0, 255},
                           green = {0, 255, 0, 255};
/// Normals of a map that lean to the right, the left, up and down the image, by 45 degrees.
const std::vector<uint8_t> right = {218, 128, 218, 255}, left = {38, 128, 218, 255},
                           up = {128, 218, 218, 255}, down = {128, 38, 218, 255};

/// Of the sky that lies behind the plate: half of it is below the horizon.
constexpr glm::vec3 behind((90 + 60) / 512.0f, (120 + 60) / 512.0f, 0);

/// Mean radiance of the plate's two halves, but for their edges.
struct Halves {
    glm::vec3 left{0}, right{0};
};

glm::vec3 meanOf(const Picture& picture, double fromX, double toX) {
    glm::dvec3 sum(0);
    double count = 0;
    // 4 m before it, 45 degrees of view.
    const double pixelsPerM = height / 2.0 / (4 * std::tan(std::atan(1) / 2));
    const auto column = [&](double x) { return static_cast<uint32_t>(width / 2.0 + x * pixelsPerM); };
    const auto row = [&](double y) { return static_cast<uint32_t>(height / 2.0 - (y - 1) * pixelsPerM); };
    for (uint32_t y = row(1.8); y < row(0.2); ++y)
        for (uint32_t x = column(fromX); x < column(toX); ++x, ++count)
            for (int c = 0; c < 3; ++c)
                sum[c] += double{picture.rgba[(size_t{y} * width + x) * 4 + static_cast<size_t>(c)]};
    return glm::vec3(sum / count);
}

Halves halvesOf(const Picture& picture) {
    return {meanOf(picture, -0.85, -0.1), meanOf(picture, 0.1, 0.85)};
}

struct Case {
    std::string name;
    std::function<void(Plate&)> change;
    /// Of the picture, and of that of a plain plate.
    std::function<void(const Halves&, const Halves&)> check;
    float fromTraced = 0.03f; ///< most, as a share
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

void expectNear(const glm::vec3& a, const glm::vec3& b, float share) {
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a[c], b[c], share * std::max(std::abs(a[c]), std::abs(b[c])) + 0.01f) << "channel " << c;
}

void unlit(Plate& plate, const std::vector<double>& color) {
    plate.material()["extensions"]["KHR_materials_unlit"] = Json::object();
    plate.material()["pbrMetallicRoughness"]["baseColorFactor"] = color;
}

Json turnedBack() {
    return {{"KHR_texture_transform", {{"scale", {-1, 1}}, {"offset", {1, 0}}}}};
}

std::vector<Case> light() {
    return {
        {"EmissiveTexture",
         [](Plate& p) {
             p.material()["emissiveFactor"] = {1, 1, 1};
             p.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 20}};
             p.texture("emissiveTexture", tests::halves(black, white));
         },
         [](const Halves& seen, const Halves& plain) {
             expectNear(seen.left, plain.left, 0.02f);
             expectNear(seen.right, plain.right + 20.0f, 0.02f);
         }},
        {"Unlit",
         [](Plate& p) {
             unlit(p, {0.25, 0.5, 1, 1});
         },
         [](const Halves& seen, const Halves&) {
             expectNear(seen.left, {0.25f, 0.5f, 1}, 0.001f);
         }},
        {"SpecularGlossiness",
         [](Plate& p) {
             p.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
                 {"diffuseFactor", {0.8, 0.05, 0.05, 1}},
                 {"glossinessFactor", 0.1},
                 {"specularFactor", {0, 0, 0}}};
         },
         [](const Halves& seen, const Halves& plain) {
             EXPECT_LT(seen.left.g, 0.1f * seen.left.r);
             EXPECT_NEAR(seen.left.r, 0.8f * plain.left.r, 0.1f * plain.left.r);
         }},
        {"SpecularTexture", // what mirrors much scatters little
         [](Plate& p) {
             p.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
                 {"specularGlossinessTexture", {{"index", p.addTexture(tests::halves(black, white))}}},
                 {"glossinessFactor", 0.2}};
         },
         [](const Halves& seen, const Halves&) { EXPECT_GT(seen.left.g, 1.3f * seen.right.g); }},
        {"NormalMapLeansAcross", // the sun stands to the right
         [](Plate& p) { p.texture("normalTexture", tests::halves(right, left)); },
         [](const Halves& seen, const Halves& plain) {
             EXPECT_GT(seen.left.g, 1.1f * plain.left.g);
             EXPECT_LT(seen.right.g, 0.8f * plain.right.g);
         }},
        {"NormalMapLeansUp", [](Plate& p) { p.texture("normalTexture", tests::halves(up, down)); },
         [](const Halves& seen, const Halves& plain) {
             EXPECT_GT(seen.left.g, 1.1f * plain.left.g);
             EXPECT_LT(seen.right.g, 0.8f * plain.right.g);
         }},
        {"NormalMapTurnedBack",
         [](Plate& p) {
             p.texture("normalTexture", tests::halves(left, left));
             p.material()["normalTexture"]["extensions"] = turnedBack();
         },
         [](const Halves& seen, const Halves& plain) { EXPECT_GT(seen.left.g, 1.1f * plain.left.g); }},
        {"OcclusionTexture",
         [](Plate& p) {
             p.texture("occlusionTexture", tests::halves(black, white));
             p.material()["occlusionTexture"]["strength"] = 0.9;
         },
         [](const Halves& seen, const Halves& plain) {
             EXPECT_LT(seen.left.b, 0.95f * plain.left.b);
             expectNear(seen.right, plain.right, 0.001f);
         }},
    };
}

std::vector<Case> textures() {
    return {
        {"Nearest",
         [](Plate& p) {
             unlit(p, {1, 1, 1, 1});
             std::vector<uint8_t> both = red;
             both.insert(both.end(), green.begin(), green.end());
             p.texture("baseColorTexture", tests::png(2, 1, both));
             p.root["textures"][0]["sampler"] = 0;
             p.root["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9728}}};
         },
         [](const Halves& seen, const Halves&) {
             expectNear(seen.left, {1, 0, 0}, 0.001f);
             expectNear(seen.right, {0, 1, 0}, 0.001f);
         }},
        {"TwoUvSets",
         [](Plate& p) {
             unlit(p, {1, 1, 1, 1});
             p.material().erase("extensions");
             p.material()["emissiveFactor"] = {1, 1, 1};
             p.texture("baseColorTexture", tests::halves(black, black));
             p.texture("emissiveTexture", tests::halves(red, green));
             p.material()["emissiveTexture"]["texCoord"] = 1;
             p.primitive()["attributes"]["TEXCOORD_1"] = p.addFloats({1, 1, 0, 1, 0, 0, 1, 0}, "VEC2");
         },
         [](const Halves& seen, const Halves&) {
             EXPECT_GT(seen.left.g, seen.left.r + 0.9f);
             EXPECT_GT(seen.right.r, seen.right.g + 0.9f);
         }},
        {"Dithered",
         [](Plate& p) {
             unlit(p, {1, 0, 1, 0.3});
             p.material()["alphaMode"] = "BLEND";
         },
         [](const Halves& seen, const Halves&) {
             EXPECT_NEAR(seen.left.r, 0.3f + 0.7f * behind.r, 0.02f);
             EXPECT_NEAR(seen.left.g, 0.7f * behind.g, 0.02f);
         }},
        {"DitheredTwice",
         [](Plate& p) {
             unlit(p, {1, 0, 1, 0.3});
             p.material()["alphaMode"] = "BLEND";
             p.root["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, -0.1}}});
             p.root["scenes"][0]["nodes"] = {0, 1};
         },
         [](const Halves& seen, const Halves&) {
             // One pattern does not know enough of the other to leave out exactly its share.
             EXPECT_NEAR(seen.left.r, 0.51f + 0.49f * behind.r, 0.05f);
             EXPECT_NEAR(seen.left.g, 0.49f * behind.g, 0.03f);
         },
         0.07f},
    };
}

class Drawn : public testing::TestWithParam<Case> {
  protected:
    demos::Scene sceneOf(const Plate& plate) const {
        tests::writeAll(folder_.path() / "plate.gltf", plate.text());
        tests::writeAll(folder_.path() / "sky.hdr", tests::sampleSky());
        demos::Scene scene;
        scene.sky.file = folder_.path() / "sky.hdr";
        scene.sun.azimuthDeg = 45;
        scene.sun.elevationDeg = 40;
        demos::MeshDesc mesh;
        mesh.file = folder_.path() / "plate.gltf";
        scene.meshes.push_back(mesh);
        demos::CameraDesc camera;
        camera.positionM = {0, 1, 4};
        camera.targetM = {0, 1, 0};
        scene.cameras.push_back(camera);
        return scene;
    }

    tests::TemporaryFolder folder_;
};

TEST_P(Drawn, AsTheFileSaysAndAsTraced) {
    demos::Error error;
    demos::HostDesc desc;
    desc.validation = true;
    const std::unique_ptr<demos::Host> host = demos::Host::create(desc, error);
    ASSERT_TRUE(host) << error.text;
    const Halves plain = halvesOf(tests::rendered(*host, sceneOf(Plate()), width, height));
    Plate plate;
    GetParam().change(plate);
    const demos::Scene scene = sceneOf(plate);
    const Halves seen = halvesOf(tests::rendered(*host, scene, width, height));
    const Halves traced = halvesOf(tests::traced(scene, {width, height, scene.cameras[0], 0, 16}).color);
    GetParam().check(seen, plain);
    expectNear(seen.left, traced.left, GetParam().fromTraced);
    expectNear(seen.right, traced.right, GetParam().fromTraced);
    EXPECT_EQ(host->validationMessages(), 0u);
}

const auto nameOf = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Light, Drawn, testing::ValuesIn(light()), nameOf);
INSTANTIATE_TEST_SUITE_P(Textures, Drawn, testing::ValuesIn(textures()), nameOf);

} // namespace
