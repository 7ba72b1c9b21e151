// What the panel lays out of the table of fields: ranges are those of the table, whatever it is.
#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>

#include "view/field_widgets.h"

namespace {

using namespace demos;

const Field& fieldOf(const char* section, std::string_view key) {
    return *std::ranges::find(sectionOf(section).fields, key, &Field::key);
}

TEST(FieldWidgets, SlideOverAllThatAFieldMayHold) {
    seaglass::ReflectionDesc asNew;
    for (const Field& field : sectionOf("water.reflection").fields) {
        const SliderRange range = sliderRangeOf(field, &asNew);
        EXPECT_EQ(range.least, field.rule == Rule::zeroOrRange ? 0 : field.row->low) << field.key;
        EXPECT_EQ(range.most, field.row->high) << field.key;
    }
    WavesDesc waves;
    EXPECT_EQ(sliderRangeOf(fieldOf("water.waves", "choppiness"), &waves).most, 10);
}

TEST(FieldWidgets, AreLogarithmicWhereTheDefaultIsNearAnEnd) {
    seaglass::ReflectionDesc reflection;
    WavesDesc waves;
    for (const char* key :
         {"march_thickness_m", "march_distance_m", "edge_stretch_per_m", "clear_distance_m"})
        EXPECT_TRUE(sliderRangeOf(fieldOf("water.reflection", key), &reflection).logarithmic) << key;
    EXPECT_TRUE(sliderRangeOf(fieldOf("water.waves", "fetch_m"), &waves).logarithmic);
    for (const char* key : {"edge_fade", "temporal", "overhang_samples", "march_steps"})
        EXPECT_FALSE(sliderRangeOf(fieldOf("water.reflection", key), &reflection).logarithmic) << key;
    EXPECT_FALSE(sliderRangeOf(fieldOf("water.waves", "wind_m_s"), &waves).logarithmic);
    SunDesc sun;
    EXPECT_FALSE(sliderRangeOf(fieldOf("sun", "azimuth_deg"), &sun).logarithmic);
}

TEST(FieldWidgets, LeaveOutWhatIsBetweenZeroAndARange) {
    const Field& steps = fieldOf("water", "wave_shadow_steps"); // 0, or 2 to 32
    EXPECT_EQ(snapped(steps, 0), 0);
    EXPECT_EQ(snapped(steps, 1), 2);
    EXPECT_EQ(snapped(steps, 7), 7);
    const Field& height = fieldOf("water.reflection", "height_px"); // 0, or 8 to 16384
    EXPECT_EQ(snapped(height, 3), 0);
    EXPECT_EQ(snapped(height, 5), 8);
}

TEST(FieldWidgets, AreOfWhatTheTechniqueReads) {
    seaglass::ReflectionDesc desc;
    const auto isShown = [&](const char* key) { return isRead(fieldOf("water.reflection", key), &desc); };
    desc.technique = techniqueNamed("sspr");
    EXPECT_TRUE(isShown("coarse_keys") && isShown("overhang_samples") && isShown("edge_fade"));
    EXPECT_FALSE(isShown("march_steps"));
    desc.technique = techniqueNamed("ssr");
    EXPECT_TRUE(isShown("march_steps") && isShown("edge_fade"));
    EXPECT_FALSE(isShown("coarse_keys") || isShown("overhang_samples"));
}

} // namespace
