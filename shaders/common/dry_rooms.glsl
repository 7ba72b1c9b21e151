// Convex hollows that the water stays out of: water/dry_rooms.h. Needs surface_uniforms.glsl and `dryRooms`, a constant: CPU
// devices load what a loop that is unrolled names once, and else for each lane.

bool isDry(vec3 position) {
    bool dry = false;
    for (uint room = 0u; room < dryRooms; ++room) {
        float outside = -1.0;
        for (uint i = 0u; i < dryRoomPlanes; ++i) {
            vec4 plane = stored.dryPlanes[room * dryRoomPlanes + i];
            outside = max(outside, dot(plane.xyz, position) + plane.w);
        }
        dry = dry || outside <= 0.0;
    }
    return dry;
}
