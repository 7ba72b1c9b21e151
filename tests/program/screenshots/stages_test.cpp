// Intermediates beside a picture: the first that differs is named.
#include <cmath>

#include <OpenImageIO/imageio.h>

#include "tests/program/screenshots/folders.h"

namespace {

using tests::expectSays;

class StagesOfPictures : public tests::Folders {
  protected:
    StagesOfPictures() {
        for (const std::string name : {"color.png", "depth.exr", "foam.exr", "height.exr", "reflection.exr"})
            writeBoth("harbour/" + name, square(4));
    }
};

TEST_F(StagesOfPictures, TheFirstThatDiffersIsNamed) {
    write("out/harbour/color.png", square(20));
    write("out/harbour/reflection.exr", square(20));
    const tests::Outcome two = compare({"--tolerant"});
    expectSays(two, 1, {"harbour/color.png: ", "the first stage that differs is reflection"});
    write("out/harbour/height.exr", square(20));
    expectSays(compare({"--tolerant"}), 1, {"the first stage that differs is height"});
    write("out/harbour/depth.exr", square(20));
    expectSays(compare({"--tolerant", "--report", "report"}), 1, {"the first stage that differs is depth"});
    EXPECT_NE(tests::readAll(at("report/index.html")).find("the first stage that differs is depth"),
              std::string::npos);
}

TEST_F(StagesOfPictures, OnesOfOtherPicturesDoNotCount) {
    write("out/harbour/color.png", square(20));
    writeBoth("ocean/depth.exr", square(4));
    write("out/ocean/depth.exr", square(20));
    const tests::Outcome outcome = compare({"--tolerant"});
    expectSays(outcome, 1, {"the first stage that differs is color"});
    EXPECT_EQ(outcome.out.find("differs is depth"), std::string::npos) << outcome.out;
}

TEST_F(StagesOfPictures, WithoutAReferenceAreNotTheFirstThatDiffers) {
    write("out/harbour/color.png", square(20));
    std::filesystem::remove(at("ref/harbour/depth.exr"));
    const tests::Outcome outcome = compare({"--tolerant"});
    expectSays(outcome, 1, {"harbour/depth.exr: no reference", "harbour/color.png: "});
    EXPECT_EQ(outcome.out.find("the first stage"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err.find("lie together"), std::string::npos) << "one reason of each: " << outcome.err;
}

TEST_F(StagesOfPictures, MayHaveNamesOfTheHosts) {
    for (const std::string name : {"menu.shadow_0001.png", "menu.lit_0001.png", "menu.shadow_0002.png"})
        writeBoth(name, square(4));
    write("out/menu.shadow_0001.png", square(20));
    write("out/menu.lit_0001.png", square(20));
    write("out/menu.shadow_0002.png", square(20));
    expectSays(compare({"--tolerant", "--stages", "shadow,lit"}), 1,
               {"menu.lit_0001.png: ", "the first stage that differs is shadow"});
}

TEST_F(StagesOfPictures, OfNoLightAreComparedByTheirValues) {
    demos::Picture sky = square(4);
    sky.rgba[0] = sky.rgba[1] = sky.rgba[2] = HUGE_VALF;
    for (size_t i = 4; i < sky.rgba.size(); ++i) sky.rgba[i] *= 400; // metres
    writeBoth("harbour/depth.exr", sky);
    std::filesystem::remove(at("ref/harbour/depth.exr"));
    EXPECT_EQ(bless({"--yes", "--driver", "one"}).code, 0) << "no sky is broken";
    demos::Picture shifted = sky;
    for (size_t i = 4; i < sky.rgba.size(); ++i) shifted.rgba[i] += 0.01f;
    write("out/harbour/depth.exr", shifted);
    expectSays(compare({"--tolerant", "--max-flip", "0"}), 0, {"same: harbour/depth.exr"});
    for (size_t i = 4; i < sky.rgba.size(); ++i) shifted.rgba[i] += 0.1f;
    write("out/harbour/depth.exr", shifted);
    expectSays(compare({"--tolerant"}), 1, {"depth.exr: share of pixels off by more than 0.02"});
    expectSays(compare({"--tolerant", "--max-diff", "0.5"}), 1, {"share of pixels off by more than 0.02"});
    expectSays(compare({"--tolerant", "--max-data", "0.2"}), 0, {"same: harbour/depth.exr"});
    expectSays(compare({"--tolerant", "--max-diff", "0.2", "--max-share", "0.01"}), 0, {"same: "});
    shifted = sky;
    shifted.rgba[0] = shifted.rgba[1] = shifted.rgba[2] = 5;
    write("out/harbour/depth.exr", shifted);
    expectSays(compare({"--tolerant"}), 1, {"depth.exr: NaN or infinity in 1 pixels of the reference"});
}

// As renderers write depth: one channel, of any name.
TEST_F(StagesOfPictures, MayHaveOneChannel) {
    for (const auto& [folder, by] : {std::pair("ref/", 0.0f), std::pair("out/", 0.1f)}) {
        OIIO::ImageSpec spec(width, height, 1, OIIO::TypeDesc::FLOAT);
        spec.channelnames = {"Z"};
        const std::vector<float> metres(width * height, 30 + by);
        const std::string file = at(folder + std::string("z/depth.exr")).string();
        std::filesystem::create_directories(at(folder + std::string("z")));
        const auto output = OIIO::ImageOutput::create(file);
        ASSERT_TRUE(output && output->open(file, spec) &&
                    output->write_image(OIIO::TypeDesc::FLOAT, metres.data()) && output->close());
    }
    expectSays(compare({"--tolerant"}), 1,
               {"different: z/depth.exr: share of pixels off by more than 0.02 is 1"});
    expectSays(bless({"--yes", "--driver", "x"}), 0, {"renewed: ref/z/depth.exr"});
}

} // namespace
