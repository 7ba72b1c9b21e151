// A multiview pass runs each draw for all of its views; one of them is meant, and in the others nothing shows.
#ifndef ONE_VIEW_GLSL
#define ONE_VIEW_GLSL

#extension GL_EXT_multiview : require
#include "body_constants.glsl"
#include "one_view_block.h"

layout(push_constant) uniform Pushed {
    OneViewBlock pushed;
};

bool isOtherView() {
    return inViews && gl_ViewIndex != int(pushed.drawnView);
}

// Beyond the far plane, whichever that is.
const vec4 outOfSight = vec4(0.0, 0.0, 2.0, 1.0);

#endif
