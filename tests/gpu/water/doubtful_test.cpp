// What a host may ask for but hardly means: it is shaded, and told of once.
#include <cmath>
#include <cstring>

#include <glm/matrix.hpp>

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace {

using namespace seaglass;
using namespace tests;

class Doubtful : public WaterTest {
  protected:
    Doubtful() {
        camera_.width = 32;
        camera_.height = 18;
    }

    /// What shade() gives, and says: nothing is empty.
    struct Answer {
        Status status = Status::ok;
        std::string text;
    };
    Answer shade(Body* body, const glm::dmat4& view) {
        Answer answer;
        beforeDrawing = [&](VkCommandBuffer commands, const ViewDesc& given) {
            ViewDesc told = given;
            copyMatrix(view, told.view);
            // What was said before is put away by what is said of this.
            EXPECT_EQ(simulate(commands, &body, 1, NAN), Status::invalidArgument);
            const std::string before = message();
            answer.status = seaglass::shade(commands, &body, 1, &told, &lighting);
            if (message() != before) answer.text = message();
            return Status::ok;
        };
        drawing = [](VkCommandBuffer, Target*, const ViewDesc&) { return Status::ok; };
        picture({body}, camera_);
        return answer;
    }

    Camera camera_;
};

bool contains(const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
}

TEST_F(Doubtful, AnEyeUnderABodyMadeToBeSeenFromAbove) {
    const RefractionDesc refraction;
    const UnderwaterDesc underwater;
    BodyDesc desc;
    desc.refraction = &refraction;
    Body* const body = makeBody(desc);
    desc.underwater = &underwater;
    Body* const dived = makeBody(desc);
    camera_.eye = {0, -2, 0};
    camera_.target = {0, -1, -10};
    const glm::dmat4 view = viewMatrix(camera_);
    EXPECT_EQ(shade(dived, view).text, "");
    const Answer first = shade(body, view);
    EXPECT_EQ(first.status, Status::ok);
    EXPECT_TRUE(contains(first.text, "the eye is 2 m under a body without BodyDesc.underwater"))
        << first.text;
    EXPECT_EQ(shade(body, view).text, ""); // once
    const ExclusionVolume hull = {
        {{1, 0, 0, -3}, {-1, 0, 0, -3}, {0, 0, 1, -3}, {0, 0, -1, -3}, {0, -1, 0, -3}}};
    Body* const boat = makeBody({});
    EXPECT_EQ(setExclusionVolumes(boat, &hull, 1), Status::ok) << message();
    EXPECT_EQ(shade(boat, view).text, "");
}

// Right views are never refused, whatever they look like.
TEST_F(Doubtful, ACamerasOwnMatrixInThePlaceOfItsInverse) {
    int above = 0;
    for (const double yaw : {20.0, 75.0, 200.0})
        for (const double x : {30.0, -30.0}) {
            const double pitch = x > 0 ? 10 : -60;
            Body* const body = makeBody({});
            const double y = radians(yaw), p = radians(pitch);
            camera_.eye = {x, 5, 12};
            camera_.target =
                camera_.eye + glm::dvec3(std::sin(y) * std::cos(p), std::sin(p), -std::cos(y) * std::cos(p));
            const glm::dmat4 view = viewMatrix(camera_);
            const Answer right = shade(body, view);
            EXPECT_EQ(right.status, Status::ok);
            EXPECT_EQ(right.text, "");
            const Answer wrong = shade(body, glm::inverse(view));
            const bool isUnder = (glm::inverse(glm::inverse(view)) * glm::dvec4(0, 0, 0, 1)).y < 0;
            EXPECT_EQ(wrong.status, isUnder ? Status::invalidArgument : Status::ok) << yaw << " " << pitch;
            EXPECT_TRUE(
                contains(wrong.text, isUnder ? "takes the camera to the world" : "is it world to view?"))
                << wrong.text;
            above += isUnder ? 0 : 1;
        }
    EXPECT_EQ(above, 2);
    // Who may dive is told as well, and once.
    const RefractionDesc refraction;
    const UnderwaterDesc underwater;
    BodyDesc desc;
    desc.refraction = &refraction;
    desc.underwater = &underwater;
    Body* const dived = makeBody(desc);
    const glm::dmat4 own = glm::inverse(viewMatrix(camera_));
    EXPECT_TRUE(contains(shade(dived, own).text, "is it world to view?"));
    EXPECT_EQ(shade(dived, own).text, "");
    // A diver who is rolled and looks level along +X looks like one.
    camera_.eye = {3, -2, 0};
    camera_.target = {13, -2, 0};
    camera_.rollDegrees = 20;
    EXPECT_EQ(shade(makeBody({}), viewMatrix(camera_)).status, Status::ok);
}

TEST_F(Doubtful, ShallowSeasThatNoBedLowers) {
    const auto said = [&](SpectrumModel spectrum, float depth) {
        SeaDesc sea = breeze();
        sea.spectrum = spectrum;
        sea.depth = depth;
        BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = fftwWaves();
        const BodyDesc refused = {.mesh = {.cellSize = -1}};
        Body* none = nullptr;
        EXPECT_EQ(createBody(context(), &refused, &none), Status::invalidArgument);
        const std::string before = message();
        makeBody(desc);
        return message() == before ? std::string() : message();
    };
    EXPECT_TRUE(contains(said(SpectrumModel::jonswap, 3), "SpectrumModel::tma"));
    EXPECT_TRUE(contains(said(SpectrumModel::piersonMoskowitz, 3), "SeaDesc.depth of 3 m"));
    EXPECT_EQ(said(SpectrumModel::tma, 3), "");
    EXPECT_EQ(said(SpectrumModel::jonswap, 300), "");
    EXPECT_EQ(said(SpectrumModel::jonswap, INFINITY), "");
}

} // namespace
