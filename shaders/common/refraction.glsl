// What shines through the surface from below it.

#ifdef REFRACTION
struct Behind {
    vec3 radiance;
    vec3 seen;     // where, relative to the eye
    bool nothing;  // but the far plane
};

// What the host's opaque scene shows at a pixel of the region.
Behind behindAt(vec2 pixel) {
    ivec2 p = clamp(ivec2(pixel + sceneShift), ivec2(0), region.zw - 1);
    float depth = texelFetch(sceneDepth, region.xy + p, 0).r;
    Behind b = Behind(vec3(0.0), vec3(0.0), depthSign * (depth - farDepth) <= 0.0);
    if (b.nothing) return b;
    vec4 q = relativeFromPixel * vec4(vec2(p) + 0.5, depth, 1.0);
    b.seen = q.xyz / q.w;
    b.radiance = texelFetch(sceneColor, region.xy + p, 0).rgb;
    return b;
}

// As much of a shift as the picture has room for: nearly all of a small one, and at most half the way to the border, so
// that what lies there is stretched no more than twice.
vec2 keptInside(vec2 from, vec2 shift) {
    vec2 room = max(mix(from, vec2(region.zw) - from, step(0.0, shift)), vec2(1e-3));
    vec2 share = 2.0 * shift / room;
    return shift * inversesqrt(1.0 + max(share.x * share.x, share.y * share.y));
}

// What shines through, along the ray that Snell's law bends: it is steeper than the line of sight, so the bed looks
// raised and little water lies before it. The bent ray's end is taken as deep as what was seen last, and looked up
// where it projects; what stands out of the water there is passed over.
vec3 refracted(vec3 normal, vec3 toEye) {
    const float shallowest = 0.1;
    vec2 here = gl_FragCoord.xy - vec2(region.xy);
    Behind found = behindAt(here);
    if (found.nothing) return waterGlow(vec3(1e6));
    vec3 bent = refract(-toEye, normal, 1.0 / waterIndex);
    float steepness = max(-bent.y, shallowest);
    float drop = max(position.y - found.seen.y, 0.0);
    for (int i = 0; i < 2; ++i) {
        vec4 target = pixelOf(position + bent * (drop / steepness));
        Behind b = behindAt(here + keptInside(here, (target.xy - here) * refractionDistortion));
        bool below = !b.nothing && target.w > 0.0 && b.seen.y < min(position.y, -plane.w);
        if (!below) continue;
        found = b;
        drop = position.y - b.seen.y;
    }
    float path = mix(length(found.seen - position), drop / steepness, refractionDistortion);
    float depth = max(-(found.seen.y + plane.w), 0.0);
    // The host lit what lies below as if in air: the way down dims it once more.
    vec3 through = exp(-(absorption.rgb + backscatter.rgb) * (path + depth));
    return found.radiance * through + waterGlow(vec3(path));
}
#else
vec3 refracted(vec3 normal, vec3 toEye) {
    return waterGlow(vec3(1e6));
}
#endif
