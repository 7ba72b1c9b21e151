// Tiles of a surface, sorted by what their shading needs: that they show what all shaded alike do,
// to the bit, and by steps almost; that many need little; and that the lists hold each tile once, in the
// order of rows.
#include <algorithm>
#include <cstring>
#include <ostream>

#include "seaglass/waves_fftw.h"
#include "shaders/shared/found_tiles_block.h"
#include "tests/gpu/rig/water_rig.h"
#include "water/body/body.h"
#include "water/shading/shading_part.h"

namespace {

using namespace seaglass;
using namespace tests;

struct Place {
    const char* name;
    void (*change)(Camera&, BodyDesc&);
    size_t leastSpared;   ///< tiles that do without the bed or the reflection
    bool seesPost = true; ///< which some tiles need both for
};

void PrintTo(const Place& place, std::ostream* out) {
    *out << place.name;
}

/// A sea under a low sun, before a post that stands in it.
class SurfaceTilesTest : public WaterTest, public testing::WithParamInterface<Place> {
  protected:
    static constexpr uint32_t headerWords = sizeof(FoundTilesHeader) / 4;

    void SetUp() override {
        WaterTest::SetUp();
        body_.waves = &sea_;
        body_.wavesBackend = fftwWaves();
        body_.foam = &foam_;
        body_.refraction = &refraction_;
        body_.reflection = &reflection_;
        setQuality(Quality::medium, &body_, &reflection_);
        body_.shading.pixelsPerShading = 1; // tiles are counted, of 8 x 8 pixels each
        camera_.eye = {3, 4, 7};
        camera_.target = {3, 2, -13};
        camera_.width = 188;
        camera_.height = 108;
        shineFrom(glm::normalize(glm::dvec3(0.3, 0.15, -0.94)), 5);
        GetParam().change(camera_, body_);
    }

    SceneBehind post() const {
        return drawnOver(camera_, nothingBehind(camera_), 7.0f, [&](const glm::dvec3& ray) {
            const double t = ray.z < 0 ? -(camera_.eye.z + 20) / ray.z : -1.0;
            const glm::dvec3 at = camera_.eye + t * ray;
            return at.x > -3 && at.x < -2 && at.y > -2 && at.y < 3 ? t : -1.0;
        });
    }

    void shadeOneOf(uint32_t pixels) { body_.shading.pixelsPerShading = pixels; }
    void narrowByOne() { --camera_.width; }
    /// So low that a crest may pass the lens.
    void diveWhereWavesMay() {
        body_.underwater = &underwater_;
        camera_.eye.y = 0.2;
        camera_.target.y = 0;
    }

    WaterPicture shadedBy(bool sorted, bool bySteps = false) {
        shown_ = makeBody(body_);
        shown_->find<ShadingPart>()->sortedFromPixels = sorted ? 0 : UINT64_MAX;
        shown_->find<ShadingPart>()->bySteps = bySteps;
        return picture({shown_}, camera_, 5, SurfaceOutput::shaded, post());
    }

    const Camera& camera() const { return camera_; }
    const ShadedSurface& shaded() const { return shown_->find<ShadingPart>()->shaded(0); }
    uint32_t tileCount() const { return (camera_.width + 7) / 8 * ((camera_.height + 7) / 8); }

    /// Header and all, of what was shaded last.
    std::vector<uint32_t> words() const {
        return downloadWords(shaded().tiles.handle(), headerWords + size_t{foundLists + 1} * tileCount());
    }

  private:
    SeaDesc sea_ = breeze();
    FoamDesc foam_;
    RefractionDesc refraction_;
    ReflectionDesc reflection_;
    UnderwaterDesc underwater_;
    BodyDesc body_;
    Camera camera_;
    Body* shown_ = nullptr;
};

TEST_P(SurfaceTilesTest, SortedShowTheSame) {
    const WaterPicture alike = shadedBy(false);
    const std::vector<uint32_t> inOne = words();
    EXPECT_EQ(inOne[3] + inOne[7] + inOne[11], 0u);
    const WaterPicture sorted = shadedBy(true);
    EXPECT_EQ(std::memcmp(alike.color.data(), sorted.color.data(), alike.color.size() * sizeof(float)), 0);
    const std::vector<uint32_t> lists = words();
    EXPECT_EQ(lists[3] + lists[7] + lists[11] + lists[15], inOne[15]);
    EXPECT_GE(lists[3] + lists[7] + lists[11], GetParam().leastSpared);
    EXPECT_EQ(lists[15] > 0, GetParam().seesPost);
}

/// As halves hold what one step leaves for the next. Of one pixel of 2 the colour of the other holds it,
/// which the last of an odd row lacks; of each an image more.
TEST_P(SurfaceTilesTest, ByStepsShowTheSame) {
    const uint32_t of = GetParam().seesPost ? 2 : 1;
    shadeOneOf(of);
    narrowByOne();
    const WaterPicture atOnce = shadedBy(false), bySteps = shadedBy(false, true);
    EXPECT_EQ(shaded().mirrored.handle() != VK_NULL_HANDLE, of == 1);
    size_t covered = 0;
    for (size_t i = 0; i < atOnce.depth.size(); ++i) {
        ASSERT_EQ(atOnce.covered(i), bySteps.covered(i)) << i;
        covered += atOnce.covered(i);
        for (size_t c = 0; c < 3 && atOnce.covered(i); ++c)
            ASSERT_NEAR(bySteps.color[4 * i + c], atOnce.color[4 * i + c],
                        0.003f * atOnce.color[4 * i + c] + 1e-4f)
                << i;
    }
    EXPECT_GT(covered, atOnce.depth.size() / 8);
}

TEST_P(SurfaceTilesTest, HoldEachTileOnceInTheOrderOfRows) {
    shadedBy(true);
    const std::vector<uint32_t> held = words();
    const uint32_t count = tileCount();
    const uint32_t across = (camera().width + 7) / 8;
    std::vector<uint32_t> next(foundLists, 0);
    for (uint32_t tile = 0; tile < count; ++tile) {
        const uint32_t needs = held[headerWords + size_t{foundLists} * count + tile];
        ASSERT_LE(needs, foundLists);
        if (needs == 0) continue;
        const uint32_t list = needs - 1;
        EXPECT_EQ(held[headerWords + size_t{list} * count + next[list]++],
                  tile % across | tile / across << 16);
    }
    for (uint32_t list = 0; list < foundLists; ++list) {
        EXPECT_EQ(held[4 * list], next[list]);
        EXPECT_EQ(held[4 * list + 1], next[list] > 0 ? 1u : 0u);
        EXPECT_EQ(held[4 * list + 2], 1u);
        EXPECT_EQ(held[4 * list + 3], next[list]);
    }
}

class ViewsOfBothSides : public SurfaceTilesTest {};

/// Which the rest would shade in as many registers as one kernel for all: no image is made for steps.
TEST_P(ViewsOfBothSides, TakeNoSteps) {
    diveWhereWavesMay();
    const WaterPicture atOnce = shadedBy(true), bySteps = shadedBy(true, true);
    EXPECT_EQ(shaded().mirrored.handle(), VK_NULL_HANDLE);
    EXPECT_EQ(std::memcmp(atOnce.color.data(), bySteps.color.data(), atOnce.color.size() * sizeof(float)), 0);
}

const Place places[] = {
    {"Level", [](Camera&, BodyDesc&) {}, 60},
    {"Rolled", [](Camera& c, BodyDesc&) { c.rollDegrees = 30; }, 1},
    {"FromHighUp",
     [](Camera& c, BodyDesc&) {
         c.eye.y = 30;
         c.target = {0, 0, -15};
     },
     1},
    {"Parallel",
     [](Camera& c, BodyDesc&) {
         c.parallelHeight = 12;
         c.far = 200;
         c.target = {3, -2, -3};
     },
     60, false},
    {"Still", [](Camera&, BodyDesc& body) { body.waves = nullptr, body.foam = nullptr; }, 60},
};

INSTANTIATE_TEST_SUITE_P(Every, SurfaceTilesTest, testing::ValuesIn(places),
                         [](const auto& each) { return std::string(each.param.name); });
INSTANTIATE_TEST_SUITE_P(Every, ViewsOfBothSides, testing::Values(places[0]),
                         [](const auto& each) { return std::string(each.param.name); });

} // namespace
