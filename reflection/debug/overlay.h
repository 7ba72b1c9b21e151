// The debug overlay: what the library makes of its inputs, as a picture.
#pragma once

#include "gpu/pipeline/kernel.h"
#include "reflection/core/reflect_pass.h"

namespace seaglass {

struct OverlayKernel {
    gpu::Kernel kernel;
    Status create(Context& context);
};

/// What is wrong with the description for this view, if anything.
FieldError badField(const OverlayDesc& desc, const ViewDesc& view);

/// Whether a kind shows what reflect() has left, and not its inputs alone.
bool showsReflection(OverlayKind kind);

/// `images` may hold null handles where the kind does not show them.
Status recordOverlay(const ReflectPass& pass, const OverlayKernel& overlay, const ReflectionImages& images,
                     const OverlayDesc& desc);

} // namespace seaglass
