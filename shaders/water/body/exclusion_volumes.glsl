// Convex hollows that the water stays out of: water/body/exclusion_volumes.h. Needs body.glsl and `exclusionVolumes`, a constant: CPU
// devices load what a loop that is unrolled names once, and else for each lane.

bool isDry(vec3 position) {
    bool dry = false;
    for (int room = 0; room < int(exclusionVolumes); ++room) {
        float outside = -1.0;
        for (int i = 0; i < exclusionVolumePlanes; ++i) {
            vec4 side = water.exclusionPlanes[room * exclusionVolumePlanes + i];
            outside = max(outside, dot(side.xyz, position) + side.w);
        }
        dry = dry || outside <= 0.0;
    }
    return dry;
}
