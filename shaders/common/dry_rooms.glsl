// Convex hollows that the water stays out of: water/dry_rooms.h. Needs surface_uniforms.glsl.

bool isDry(vec3 position) {
    for (uint room = 0u; room < stored.dryRooms; ++room) {
        float outside = -1.0;
        for (uint i = 0u; i < dryRoomPlanes; ++i) {
            vec4 plane = stored.dryPlanes[room * dryRoomPlanes + i];
            outside = max(outside, dot(plane.xyz, position) + plane.w);
        }
        if (outside <= 0.0) return true;
    }
    return false;
}
