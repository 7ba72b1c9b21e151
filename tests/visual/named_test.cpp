// Faults planted in a stage of a golden picture, or in a sequence, and carried on to what is made of it: each
// is caught, and named for the stage where it lies.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "demos/host/files/image_file.h"
#include "tests/program/run.h"

namespace {

namespace fs = std::filesystem;
using demos::Picture;

constexpr int width = 128, height = 72;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// Pictures by their files' names.
using Pictures = std::map<std::string, Picture>;

Pictures goldens(const std::string& test) {
    Pictures all;
    for (const auto& entry :
         fs::directory_iterator(fs::path(SEAGLASS_SOURCE "/tests/visual/golden") / test)) {
        demos::Error error;
        std::optional<Picture> picture = demos::readPicture(entry.path(), error);
        if (!picture) throw std::runtime_error(error.text);
        all[entry.path().filename()] = std::move(*picture);
    }
    return all;
}

struct Box {
    int left = 0, top = 0, wide = width, high = height;
};

using Value = std::function<float(float value, int x, int y, int channel)>;

float at(const Picture& picture, int x, int y, int channel) {
    const int inX = std::clamp(x, 0, width - 1), inY = std::clamp(y, 0, height - 1);
    return picture.rgba[static_cast<size_t>(4 * (inY * width + inX) + channel)];
}

void change(Picture& picture, const Box& box, const Value& value) {
    const Picture before = picture;
    for (int y = box.top; y < box.top + box.high; ++y)
        for (int x = box.left; x < box.left + box.wide; ++x)
            for (int channel = 0; channel < 3; ++channel)
                picture.rgba[static_cast<size_t>(4 * (y * width + x) + channel)] =
                    value(at(before, x, y, channel), x, y, channel);
}

/// A box shows what is `dx`, `dy` from it.
void move(Picture& picture, int dx, int dy, const Box& box = {}) {
    const Picture before = picture;
    change(picture, box,
           [&](float, int x, int y, int channel) { return at(before, x + dx, y + dy, channel); });
}

void blur(Picture& picture, const Box& box = {}) {
    const Picture before = picture;
    change(picture, box, [&](float, int x, int y, int channel) {
        float sum = 0;
        for (int dx = -2; dx <= 2; ++dx) sum += at(before, x + dx, y, channel);
        return sum / 5;
    });
}

void turn(Picture& picture) {
    const Picture before = picture;
    change(picture, {}, [&](float, int x, int y, int c) { return at(before, x, height - 1 - y, c); });
}

void fill(Picture& picture, float with, const Box& box = {}) {
    change(picture, box, [with](float, int, int, int) { return with; });
}

void scale(Picture& picture, float by, const Box& box = {}) {
    change(picture, box, [by](float value, int, int, int) { return value * by; });
}

void raise(Picture& picture, float by, const Box& box = {}) {
    change(picture, box, [by](float value, int, int, int) { return value + by; });
}

void makeNoise(Picture& picture, float amplitude) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(-1, 1);
    change(picture, {}, [&](float value, int, int, int) { return value + amplitude * unit(random); });
}

struct Fault {
    const char* name;
    const char* of;    ///< which golden it is planted in
    const char* stage; ///< what it is to be named for
    std::function<void(Pictures&)> plant;
};

constexpr const char *harbour = "harbour_level_stages", *storm = "storm_near_stages",
                     *tour = "harbour_tour_frames";
/// In harbour_level_stages: a lighthouse and its mirror image, the water.
constexpr Box lighthouse{24, 15, 8, 20}, mirrored{24, 40, 10, 24}, water{0, 36, width, 36};

/// Of what is drawn before the water.
std::vector<Fault> sceneFaults() {
    return {
        {"a lighthouse is missing", harbour, "depth",
         [](Pictures& p) {
             for (const char* name : {"depth.exr", "color.png"}) move(p.at(name), 12, 0, lighthouse);
             for (const char* name : {"reflection.exr", "color.png"}) move(p.at(name), 14, 0, mirrored);
         }},
        {"all is a pixel to the left", harbour, "depth",
         [](Pictures& p) {
             for (auto& [name, picture] : p) move(picture, 1, 0);
         }},
        {"all is upside down", harbour, "depth",
         [](Pictures& p) {
             for (auto& [name, picture] : p) turn(picture);
         }},
        {"distances are 2 % off", harbour, "depth", [](Pictures& p) { scale(p.at("depth.exr"), 1.02f); }},
        {"a tile of depth is stale", harbour, "depth",
         [](Pictures& p) {
             for (const char* name : {"depth.exr", "color.png"}) move(p.at(name), 30, 12, {40, 24, 16, 16});
         }},
        {"one NaN in depth", harbour, "depth",
         [](Pictures& p) {
             fill(p.at("depth.exr"), nan, {60, 50, 1, 1});
             fill(p.at("color.png"), 0, {60, 50, 1, 1});
         }},
    };
}

/// Of waves and foam.
std::vector<Fault> waveFaults() {
    const auto both = [](Pictures& p, const auto& plant) {
        plant(p.at("height.exr"));
        plant(p.at("color.png"));
    };
    const auto foamed = [](Pictures& p, const auto& plant) {
        plant(p.at("foam.exr"));
        plant(p.at("color.png"));
    };
    return {
        {"no waves", storm, "height",
         [=](Pictures& p) { both(p, [](Picture& picture) { scale(picture, 0, water); }); }},
        {"waves 5 % too high", storm, "height",
         [](Pictures& p) {
             scale(p.at("height.exr"), 1.05f);
             move(p.at("color.png"), 0, 1, water);
         }},
        {"waves of another time", storm, "height",
         [=](Pictures& p) { both(p, [](Picture& picture) { move(picture, 6, 0, water); }); }},
        // These are lower than the 2 cm that heights may be off by.
        {"short waves are missing", storm, "color",
         [=](Pictures& p) {
             both(p, [](Picture& picture) {
                 for (int i = 0; i < 3; ++i) blur(picture, water);
             });
         }},
        {"one NaN in height", storm, "height",
         [](Pictures& p) {
             fill(p.at("height.exr"), nan, {64, 60, 1, 1});
             fill(p.at("color.png"), 0, {64, 60, 1, 1});
         }},
        {"waves end too near", storm, "height",
         [=](Pictures& p) { both(p, [](Picture& picture) {
                                scale(picture, 0, {0, 30, width, 14});
                            }); }},
        {"no foam", storm, "foam",
         [=](Pictures& p) { foamed(p, [](Picture& picture) { scale(picture, 0.4f, water); }); }},
        {"twice the foam", storm, "foam",
         [=](Pictures& p) { foamed(p, [](Picture& picture) { scale(picture, 2, water); }); }},
        {"foam elsewhere", storm, "foam",
         [=](Pictures& p) { foamed(p, [](Picture& picture) { move(picture, 9, 3, water); }); }},
        {"foam is smeared", storm, "foam",
         [=](Pictures& p) { foamed(p, [](Picture& picture) { blur(picture, water); }); }},
        {"foam everywhere", storm, "foam",
         [=](Pictures& p) { foamed(p, [](Picture& picture) { raise(picture, 0.1f, water); }); }},
    };
}

/// Of what the water mirrors.
std::vector<Fault> mirrorFaults() {
    const auto of = [](const char* name, const char* stage, const std::function<void(Picture&)>& plant) {
        return Fault{name, harbour, stage, [=](Pictures& p) {
                         if (std::string("class") == stage) plant(p.at("class.exr"));
                         plant(p.at("reflection.exr"));
                         plant(p.at("color.png"));
                     }};
    };
    return {
        of("sky is mirrored in the place of boats", "class", [](Picture& p) { fill(p, 0.25f, mirrored); }),
        of("classes are two pixels off", "class", [](Picture& p) { move(p, 2, 0, water); }),
        of("a tile of classes is stale", "class",
           [](Picture& p) {
               move(p, 30, -12, {40, 40, 16, 16});
           }),
        of("a lighthouse's mirror image is missing", "reflection",
           [](Picture& p) { move(p, 14, 0, mirrored); }),
        of("mirror images are moved by a pixel", "reflection", [](Picture& p) { move(p, 1, 0, water); }),
        of("mirror images are moved down by two", "reflection", [](Picture& p) { move(p, 0, 2, water); }),
        of("a seam in the mirror", "reflection",
           [](Picture& p) {
               scale(p, 0.6f, {0, 50, width, 1});
           }),
        of("a black tile in the mirror", "reflection",
           [](Picture& p) {
               fill(p, 0, {64, 48, 8, 8});
           }),
        of("one NaN in the mirror", "reflection",
           [](Picture& p) {
               fill(p, nan, {64, 60, 1, 1});
           }),
        of("nothing is mirrored", "reflection", [](Picture& p) { fill(p, 0.05f, water); }),
        of("mirror images are 5 % too bright", "reflection", [](Picture& p) { scale(p, 1.05f, water); }),
        of("mirror images are blurred", "reflection", [](Picture& p) { blur(p, water); }),
    };
}

/// Of the picture itself.
std::vector<Fault> colorFaults() {
    const auto of = [](const char* name, const std::function<void(Picture&)>& plant) {
        return Fault{name, harbour, "color", [=](Pictures& p) { plant(p.at("color.png")); }};
    };
    const auto to = [&of](const char* name, const std::function<float(float)>& value) {
        return of(name, [=](Picture& p) {
            change(p, {}, [&value](float old, int, int, int) { return value(old); });
        });
    };
    return {
        to("gamma is 2 % off", [](float v) { return std::pow(v, 1.02f); }),
        to("3 % too dark", [](float v) { return 0.97f * v; }),
        to("a step of 255 too bright", [](float v) { return v + 1.0f / 255; }),
        to("four bits", [](float v) { return std::round(v * 15) / 15; }),
        to("a blank picture", [](float) { return 0.0f; }),
        of("red and blue are swapped",
           [](Picture& p) {
               const Picture before = p;
               change(p, {}, [&](float, int x, int y, int c) { return at(before, x, y, 2 - c); });
           }),
        of("the sun is elsewhere",
           [](Picture& p) {
               change(p, {}, [](float v, int x, int y, int) {
                   const float far = std::hypot(static_cast<float>(x - 90), static_cast<float>(y - 20)) / 18;
                   return v + 0.15f * std::exp(-far * far);
               });
           }),
        of("a logo is missing",
           [](Picture& p) {
               fill(p, 0.9f, {110, 62, 14, 6});
           }),
        of("a tiny logo is missing",
           [](Picture& p) {
               fill(p, 0.9f, {120, 64, 4, 4});
           }),
        of("one white pixel",
           [](Picture& p) {
               fill(p, 1, {100, 66, 1, 1});
           }),
        of("the last row is black",
           [](Picture& p) {
               fill(p, 0, {0, height - 1, width, 1});
           }),
        of("the upper half is black",
           [](Picture& p) {
               fill(p, 0, {0, 0, width, height / 2});
           }),
        of("noise", [](Picture& p) { makeNoise(p, 0.06f); }),
        of("dithering is another", [](Picture& p) { makeNoise(p, 2.0f / 255); }),
        of("blurred", [](Picture& p) { blur(p); }),
    };
}

/// Of sequences; named for the frame.
std::vector<Fault> frameFaults() {
    const auto name = [](int frame) { return "color_000" + std::to_string(frame) + ".png"; };
    return {
        {"a frame pops", tour, "color_0004.png", [=](Pictures& p) { scale(p.at(name(4)), 1.03f); }},
        {"a frame comes twice", tour, "color_0003.png", [=](Pictures& p) { p.at(name(3)) = p.at(name(2)); }},
    };
}

std::vector<Fault> allFaults() {
    std::vector<Fault> all;
    for (auto* const some : {sceneFaults, waveFaults, mirrorFaults, colorFaults, frameFaults})
        for (Fault& fault : some()) all.push_back(std::move(fault));
    return all;
}

void write(const fs::path& folder, const Pictures& pictures) {
    fs::create_directories(folder);
    for (const auto& [name, picture] : pictures) {
        demos::Error error;
        if (name.ends_with(".exr")) {
            ASSERT_TRUE(demos::writeExr(folder / name, picture, error)) << error.text;
            continue;
        }
        std::vector<uint8_t> rgb;
        for (size_t i = 0; i < picture.rgba.size(); ++i) {
            const float value = std::isnan(picture.rgba[i]) ? 0 : std::clamp(picture.rgba[i], 0.0f, 1.0f);
            if (i % 4 != 3) rgb.push_back(static_cast<uint8_t>(value * 255 + 0.5f));
        }
        ASSERT_TRUE(demos::writePng(folder / name, width, height, rgb, error)) << error.text;
    }
}

/// What the program says of all of them, by folder.
std::map<std::string, std::string> saidOf(const std::vector<Fault>& faults) {
    const tests::TemporaryFolder folder;
    for (size_t i = 0; i < faults.size(); ++i) {
        Pictures pictures = goldens(faults[i].of);
        write(folder.path() / "ref" / std::to_string(i), pictures);
        faults[i].plant(pictures);
        write(folder.path() / "out" / std::to_string(i), pictures);
    }
    tests::run(SEAGLASS_PROGRAM,
               {{"compare", "ref", "out", "--tolerant", "--json", "compared.json"}, {}, folder.path()});
    const auto json = nlohmann::json::parse(tests::readAll(folder.path() / "compared.json"));
    std::map<std::string, std::string> said;
    for (const auto& picture : json.at("pictures")) {
        const fs::path name = picture.at("name").get<std::string>();
        if (picture.at("verdict") != "same")
            said[name.parent_path()] +=
                name.filename().string() + ": " + picture.at("why").get<std::string>() + "\n";
    }
    return said;
}

bool named(const Fault& fault, const std::string& said) {
    const std::string stage = fault.stage;
    return said.find(stage.ends_with(".png")
                         ? "the change to " + stage
                         : "the first stage that differs is " + stage) != std::string::npos;
}

/// Plants one of so many.
class EachFault : public testing::TestWithParam<size_t> {};
INSTANTIATE_TEST_SUITE_P(, EachFault, testing::Values(size_t{1}, size_t{4}),
                         [](const auto& info) { return info.param == 1 ? "All" : "EveryFourth"; });

TEST_P(EachFault, IsNamedForWhereItLies) {
    const std::vector<Fault> all = allFaults();
    std::vector<Fault> faults;
    for (size_t i = 0; i < all.size(); i += GetParam()) faults.push_back(all[i]);
    std::map<std::string, std::string> said = saidOf(faults);
    for (size_t i = 0; i < faults.size(); ++i) {
        const std::string& words = said[std::to_string(i)];
        EXPECT_TRUE(named(faults[i], words)) << faults[i].name << ", of " << faults[i].stage << ": " << words;
    }
    EXPECT_GE(all.size(), 40u);
}

// docs/screenshot-tests.md lists them all.
TEST(PlantedFaults, AreThoseOfTheDocument) {
    const std::string document = tests::readAll(SEAGLASS_SOURCE "/docs/screenshot-tests.md");
    for (const Fault& fault : allFaults()) {
        const std::string row = std::string("| ") + fault.name + " | " + fault.stage + " |\n";
        EXPECT_NE(document.find(row), std::string::npos) << row;
    }
}

} // namespace
