// The scene's fields as widgets, by its table: names, ranges and words are its.
#pragma once

#include <string>
#include <string_view>

#include "scene/fields.h"

namespace demos {

/// A field's name in words, without its unit, which stands behind the number.
std::string labelOf(const Field& field);

/// Of a colour, a file and so on there are none.
bool hasWidget(const Target& target);

/// Where a slider runs: over all that the field may hold.
struct SliderRange {
    double least, most;
    bool logarithmic; ///< where its default would else be near an end
};

SliderRange sliderRangeOf(const Field& field, void* asNew);

/// What the slider's own range lets in and the field does not: 1 of "0, or 2 to 32".
double snapped(const Field& field, double value);

/// Whether the description that holds a field reads it, as it is: strides are of techniques that follow rays.
bool isRead(const Field& field, void* owner);

/// True once a change is complete: a slider is let go. `asNew` is such an owner as it is made.
bool layOutField(const Field& field, void* owner, void* asNew);

/// Those of a section that the library's tables describe, and that are read.
bool layOutFields(const Section& section, void* owner, void* asNew);

} // namespace demos
