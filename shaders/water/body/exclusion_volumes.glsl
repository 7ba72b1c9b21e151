// Convex hollows that the water stays out of: water/body/exclusion_volumes.h. Their
// number is a constant: CPU devices load what a loop that is unrolled names once, and else for each lane.
#ifndef EXCLUSION_VOLUMES_GLSL
#define EXCLUSION_VOLUMES_GLSL

#include "body.glsl"

bool isExcluded(vec3 position) {
    bool excluded = false;
    for (int volume = 0; volume < int(exclusionVolumes); ++volume) {
        float outside = -1.0;
        for (int i = 0; i < exclusionVolumePlanes; ++i) {
            vec4 side = water.exclusionPlanes[volume * exclusionVolumePlanes + i];
            outside = max(outside, dot(side.xyz, position) + side.w);
        }
        excluded = excluded || outside <= 0.0;
    }
    return excluded;
}

#endif
