// A body that can be seen from within.
#pragma once

#include "water/below/view_pass.h"
#include "water/body/part.h"

namespace seaglass {

struct UnderwaterPart {
    UnderwaterDesc desc;

    static FieldError validate(const BodyDesc& desc);
    static bool wanted(const BodyDesc& desc, const Sea*) { return desc.underwater; }
    Status create(Body& body, const BodyDesc& of);
    void fill(const Body& body, const BodyView& view, BodyBlock& block) const;
    /// Of an eye in the water; records nothing for other eyes.
    Status draw(Body& body, const DrawCall& call, DrawMoment moment) const;
    Status prepare(const Body& body, const PrepareCall& call) const;

  private:
    /// Whether the body has such a pass at all.
    bool draws(const Body& body, ViewPass pass) const;
    void fillSnow(const Body& body, const BodyView& view, BodyBlock& block) const;
    Status record(Body& body, const DrawCall& call, ViewPass pass) const;
};

} // namespace seaglass
