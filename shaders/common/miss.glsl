// What is known of a mirrored pixel that nothing on the screen was found for. Needs mirror.glsl, reflection_info.glsl and
// sceneDepth.

float depthAt(ivec2 pixel) {
    return texelFetch(sceneDepth, region.xy + pixel, 0).r;
}

// The mirrored ray's far end tells whether the sky it would reach is on the screen.
float infoOfMiss(vec2 q) {
    vec4 end = mirrored(vec3(q, infinityDepth));
    if (!(end.w > 0.0) || !insideRegion(end.xy)) return infoUnknown;
    return isFar(depthAt(ivec2(end.xy))) ? infoSky : infoUnknown;
}

bool planeAhead(vec2 q) {
    // Any depth serves to find the ray through this pixel; half way avoids both ends.
    return dot(plane.xyz, unprojected(vec3(q, 0.5))) < 0.0;
}
