// The tables of settings: what they say, and that the library holds to it.
#include "gpu/context.h"
#include "gpu/fields.h"
#include "gpu/interface/fields/fog.h"
#include "gpu/interface/fields/host.h"
#include "gpu/view/view.h"
#include "reflection/debug/overlay.h"
#include "reflection/interface/fields/reflection.h"
#include "tests/body_parts.h"
#include "tests/unit/cameras.h"
#include "water/body/body_desc.h"
#include "water/body/target.h"
#include "water/interface/checks.h"
#include "water/interface/fields/sea.h"
#include "water/interface/fields/water.h"
#include "water/light/lighting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace seaglass;

/// A description that can be spoiled, and who should refuse it then.
struct Held {
    const FieldTable* table;
    void* desc;
    std::function<std::string()> problem; ///< empty: none
    /// What it does not read may hold anything.
    std::function<bool(const Field&)> reads = [](const Field&) { return true; };
};

/// Nobody does more with it than look whether it is there.
template<typename Handle>
Handle someHandle() {
    return reinterpret_cast<Handle>(uintptr_t{1});
}

/// Everything that a body is made of, the light, and what they are seen by.
class Tables : public testing::Test {
  protected:
    Tables() {
        water.addAll();
        lighting.fog = &fog;
        basin.shape = ExtentShape::rectangle;
        basin.size[0] = basin.size[1] = 20;
        underCube.skyCube = someHandle<VkImageView>();
        shadow.map = {someHandle<VkImageView>(), VK_FORMAT_D32_SFLOAT, {16, 16}, VK_IMAGE_LAYOUT_GENERAL};
        shaded.shadow = &shadow;
        const VkExtent2D extent = {camera.width, camera.height};
        view = tests::viewDesc(camera);
        view.sceneColor = {someHandle<VkImageView>(), VK_FORMAT_R16G16B16A16_SFLOAT, extent,
                           VK_IMAGE_LAYOUT_GENERAL};
        view.sceneDepth = {someHandle<VkImageView>(), VK_FORMAT_D32_SFLOAT, extent, VK_IMAGE_LAYOUT_GENERAL};
        overlay.target = view.sceneColor;
        target.colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
        target.depthFormat = VK_FORMAT_D32_SFLOAT;
        device.instance = someHandle<VkInstance>();
        device.physicalDevice = someHandle<VkPhysicalDevice>();
        device.device = someHandle<VkDevice>();
        device.getInstanceProcAddr = [](VkInstance, const char*) -> PFN_vkVoidFunction { return nullptr; };
        water.addShore();
        water.sea.shore = nullptr; // but for ofShore()
        water.sea.samples = 16;
        water.sea.cascades = 1;
    }

    std::string ofBody() const { return badField(water.desc).text(); }
    std::string ofSea() const {
        SeaError error;
        destroySea(createSea(&water.sea, &error));
        return error.text;
    }
    std::string ofShore() {
        water.sea.shore = &water.shore;
        const std::string problem = ofSea();
        water.sea.shore = nullptr;
        return problem;
    }

    std::string ofView() {
        view.sceneDepth.samples = view.sceneColor.samples;
        ViewGeometry geometry;
        return readView(view, geometry).text();
    }

    std::vector<Held> seenBy() {
        const auto light = [](const LightingDesc& desc) {
            return [&desc] { return std::string(badField(desc).text()); };
        };
        const auto byCube = [](const Field& field) { return field.name == std::string("skyCubeMipLevels"); };
        const auto byColors = [](const Field& field) {
            return field.name == std::string("skyZenith") || field.name == std::string("skyHorizon") ||
                   field.name == std::string("skyGround");
        };
        return {{&lightingFields, &lighting, light(lighting), std::not_fn(byCube)},
                {&lightingFields, &underCube, light(underCube), std::not_fn(byColors)},
                {&sunShadowFields, &shadow, light(shaded)},
                {&fogFields, &fog, light(lighting)},
                {&viewFields, &view, [this] { return ofView(); }},
                {&imageFields, &view.sceneColor, [this] { return ofView(); }},
                {&overlayFields, &overlay, [this] { return std::string(badField(overlay, view).text()); }},
                {&targetFields, &target, [this] { return std::string(badField(target).text()); }},
                {&deviceFields, &device, [this] { return std::string(badField(device).text()); }}};
    }

    std::vector<Held> all() {
        std::vector<Held> held = partsOfBodies();
        for (const Held& by : seenBy()) held.push_back(by);
        return held;
    }

    std::vector<Held> partsOfBodies() {
        const auto body_ = [this] { return ofBody(); };
        const auto extent = [](ExtentDesc& desc) {
            return Held{&extentFields, &desc, [&desc] { return std::string(badField(desc).text()); },
                        [&desc](const Field& field) { return isRead(extentFields, field, &desc); }};
        };
        return {extent(water.desc.extent),
                extent(basin),
                {&bodyFields, &water.desc, body_},
                {&meshFields, &water.desc.mesh, body_},
                {&shadingFields, &water.desc.shading, body_},
                {&foamFields, &water.foam, body_},
                {&refractionFields, &water.refraction, body_},
                {&reflectionFields, &water.reflection, body_},
                {&underwaterFields, &water.underwater, body_},
                {&causticsFields, &water.caustics, body_},
                {&sprayFields, &water.spray, body_},
                {&bedFields, &water.bed, body_},
                {&seaFields, &water.sea, [this] { return ofSea(); }},
                {&swellFields, &water.sea.swells[0], [this] { return ofSea(); }},
                {&shoreFields, &water.shore, [this] { return ofShore(); }}};
    }

    tests::BodyParts water;
    FogDesc fog;
    ExtentDesc basin;
    LightingDesc lighting, underCube, shaded;
    SunShadow shadow;
    tests::Camera camera;
    ViewDesc view;
    OverlayDesc overlay;
    TargetDesc target;
    DeviceDesc device;
};

TEST_F(Tables, HoldDescriptionsAsNew) {
    for (const Held& held : all()) EXPECT_EQ(held.problem(), "") << held.table->desc;
}

TEST_F(Tables, NameEachFieldOnceAndSayWhatItIs) {
    for (const Held& held : all()) {
        std::set<std::string> names;
        for (const Field& field : *held.table) {
            SCOPED_TRACE(std::string(held.table->desc) + "." + field.name);
            EXPECT_TRUE(names.insert(field.name).second);
            EXPECT_EQ(std::string(field.about).back(), '.');
            EXPECT_LT(field.low, field.high);
            EXPECT_EQ(field.choices != nullptr, field.type == FieldType::choice);
        }
        EXPECT_FALSE(names.empty());
    }
}

TEST_F(Tables, AreHandedOutToHosts) {
    const auto same = [](const FieldTable& given, const FieldTable& own) {
        EXPECT_STREQ(given.desc, own.desc);
        EXPECT_EQ(given.fields, own.fields) << own.desc;
        EXPECT_EQ(given.count, own.count) << own.desc;
    };
    same(fieldsOf(DeviceDesc{}), deviceFields);
    same(fieldsOf(Image{}), imageFields);
    same(fieldsOf(ViewDesc{}), viewFields);
    same(fieldsOf(SunShadow{}), sunShadowFields);
    same(fieldsOf(LightingDesc{}), lightingFields);
    same(fieldsOf(FogDesc{}), fogFields);
    same(fieldsOf(SceneSamples{}), sceneSampleFields);
    same(fieldsOf(ReflectionDesc{}), reflectionFields);
    same(fieldsOf(OverlayDesc{}), overlayFields);
    same(fieldsOf(SeaDesc{}), seaFields);
    same(fieldsOf(SpectrumSample{}), spectrumSampleFields);
    same(fieldsOf(SwellDesc{}), swellFields);
    same(fieldsOf(ShoreDesc{}), shoreFields);
    same(fieldsOf(FoamDesc{}), foamFields);
    same(fieldsOf(BodyDesc{}), bodyFields);
    same(fieldsOf(ExtentDesc{}), extentFields);
    same(fieldsOf(MeshDesc{}), meshFields);
    same(fieldsOf(ShadingDesc{}), shadingFields);
    same(fieldsOf(RefractionDesc{}), refractionFields);
    same(fieldsOf(UnderwaterDesc{}), underwaterFields);
    same(fieldsOf(CausticsDesc{}), causticsFields);
    same(fieldsOf(SprayDesc{}), sprayFields);
    same(fieldsOf(BedDesc{}), bedFields);
    same(fieldsOf(TargetDesc{}), targetFields);
}

/// What a field's type holds beyond an end of its range.
std::vector<double> justBeyond(const Field& field) {
    if (field.type == FieldType::boolean) return {};
    if (field.type == FieldType::integer || field.type == FieldType::choice) {
        std::vector<double> values = {field.high + 1};
        if (field.low > 0 && field.rule != FieldRule::zeroOrWithin) values.push_back(field.low - 1);
        if (field.low > 1 && field.rule == FieldRule::zeroOrWithin) values.push_back(1);
        if (field.rule == FieldRule::powerOfTwo && field.high > 2) values.push_back(field.high - 1);
        return values;
    }
    std::vector<double> values = {std::numeric_limits<double>::quiet_NaN(), -HUGE_VAL};
    for (const double end : {field.low, field.high}) {
        if (std::isinf(end)) continue;
        const double outwards = end == field.low ? -HUGE_VAL : HUGE_VAL;
        values.push_back(field.type == FieldType::float32
                             ? double{std::nextafter(static_cast<float>(end), static_cast<float>(outwards))}
                             : std::nextafter(end, outwards));
    }
    return values;
}

/// Makes a fog one that reads a field, by its shape.
void readIt(const Held& held, const Field& field) {
    if (held.table != &fogFields) return;
    uint32_t kind = 0;
    while (field.readBy != 0 && (field.readBy >> kind & 1u) == 0) ++kind;
    if (kind > 0) held.table->fields[0].set(held.desc, 0, kind);
}

TEST_F(Tables, AreWhatTheLibraryHoldsTo) {
    for (const Held& held : all()) {
        for (const Field& field : *held.table) {
            readIt(held, field);
            for (uint32_t i = 0; i < field.count; ++i) {
                const double before = field.get(held.desc, i);
                for (const double beyond : justBeyond(field)) {
                    field.set(held.desc, i, beyond);
                    const std::string problem = held.problem();
                    if (!held.reads(field)) {
                        EXPECT_EQ(problem, "") << held.table->desc << "." << field.name;
                        continue;
                    }
                    EXPECT_NE(problem.find(std::string(".") + field.name), std::string::npos)
                        << held.table->desc << "." << field.name << " = " << beyond << ": " << problem;
                    EXPECT_NE(problem.find("expected "), std::string::npos) << problem;
                }
                field.set(held.desc, i, before);
                EXPECT_EQ(field.get(held.desc, i), before);
            }
        }
    }
}

TEST_F(Tables, LetAnythingIntoFogThatItsShapeDoesNotRead) {
    const Held held = {&fogFields, &fog, [this] { return std::string(badField(lighting).text()); }};
    uint32_t tried = 0;
    for (const FogShape shape :
         {FogShape::linear, FogShape::exponential, FogShape::exponentialSquared, FogShape::height})
        for (const Field& field : fogFields) {
            if (field.readBy == 0 || (field.readBy >> static_cast<uint32_t>(shape) & 1u) != 0) continue;
            for (const double beyond : justBeyond(field)) {
                fog = FogDesc{};
                fog.shape = shape;
                field.set(&fog, 0, beyond);
                EXPECT_EQ(held.problem(), "") << field.name << " = " << beyond;
                ++tried;
            }
        }
    EXPECT_GT(tried, 40u);
    fog = FogDesc{};
    fog.start = fog.end;
    EXPECT_EQ(held.problem(), "");
    fog.shape = FogShape::linear;
    EXPECT_NE(held.problem().find("FogDesc.start and end"), std::string::npos);
}

TEST_F(Tables, LetEndsIn) {
    // Together with others they may be none: a start at the end, a table without samples, waves without a
    // backend, a mesh without points.
    const std::set<std::string> apart = {"FogDesc.start",     "FogDesc.end",     "BodyDesc.wavesOn",
                                         "SeaDesc.spectrum",  "SeaDesc.samples", "SeaDesc.cascades",
                                         "ShoreDesc.samples", "ExtentDesc.shape"};
    for (const Held& held : all()) {
        for (const Field& field : *held.table) {
            if (apart.count(held.table->desc + std::string(".") + field.name) > 0) continue;
            readIt(held, field);
            const double before = field.get(held.desc, 0);
            for (const double end : {field.low, field.high}) {
                field.set(held.desc, 0, end);
                EXPECT_EQ(held.problem(), "") << held.table->desc << "." << field.name << " = " << end;
            }
            field.set(held.desc, 0, before);
        }
    }
}

std::string expected(const Field& field) {
    FieldError line;
    addExpected(line, field);
    return line.text();
}

TEST(Field, SaysWhatIsExpected) {
    EXPECT_EQ(expected(field<&ReflectionDesc::overhangSamples>("", 0, 8, "", "")), "0 to 8");
    EXPECT_EQ(expected(field<&ReflectionDesc::height>("", 8, 16384, "pixel", "").orZero()),
              "0 or 8 to 16384 pixel");
    EXPECT_EQ(expected(field<&ReflectionDesc::downscale>("", 1, 8, "", "").powersOfTwo()), "1, 2, 4 or 8");
    EXPECT_EQ(expected(field<&SeaDesc::samples>("", 16, 2048, "", "").powersOfTwo()),
              "a power of two, 16 to 2048");
    EXPECT_EQ(expected(field<&ShadingDesc::fresnel>("", fresnels, "")), "0 to 1: exact or schlick");
    EXPECT_EQ(expected(field<&FogDesc::shape>("", fogShapes, "", 1)),
              "1 to 4: linear, exponential, exponential-squared or height");
    EXPECT_EQ(expected(field<&SeaDesc::windDirection>("", -mostFinite, mostFinite, "rad", "")),
              "a finite number in rad");
}

} // namespace
