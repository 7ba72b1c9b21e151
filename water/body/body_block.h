// What a body's shaders are told about one view of it.
#pragma once

#include "water/body/part.h"

namespace seaglass {

BodyBlock bodyBlock(const Body& body, const BodyView& view);

/// All that some shader of the body reads in a view: `block`, and what its parts have.
Status bindBody(Body& body, const BodyView& view, const BodyBlock& block, Resources& out);
/// The same with the view's own block.
Status bindBody(Body& body, const BodyView& view, Resources& out);

} // namespace seaglass
