// Places the vertices of a patch: glides them onto the next coarser lattice near the end of their level's range
// (Strugar 2009), then lets the waves displace them. Of a mesh of the host's own (HOST_MESH) they stand where it says.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "one_view.glsl"
#include "surface.glsl"

layout(location = 0) out vec2 calmPosition;   // (u, v) before displacement, relative to the eye
layout(location = 1) out vec3 position;   // over the plane, as if there were no globe
#ifdef OUTLINE
layout(location = 2) flat out uvec2 edgeRange;
#endif
#ifdef MOTION
layout(location = 3) out vec4 lastPixel;   // homogeneous
#endif

const int patchCells = 16;   // that vertices are numbered by; fewer may be drawn
// A patch may reach past its level's range by its parent's diagonal, 22.6 cells of the coarser level; gliding must end
// before the range does and begin after the coarser neighbour's patches can touch it.
const float glideBegins = 0.7;
const float glideEnds = 0.95;

#include "wave_displacement.glsl"
#include "globe.glsl"

#ifdef HOST_MESH
void main() {
#ifdef MULTIVIEW
    if (isOtherView()) {
        gl_Position = outOfSight;
        return;
    }
#endif
    loadSurface();
    HostVertex vertex = hostVertices[gl_VertexIndex];
    vec2 calm = extent.xy + vertex.calm;
    float cell = vertex.cell;
#else
void main() {
#ifdef MULTIVIEW
    if (isOtherView()) {
        gl_Position = outOfSight;
        return;
    }
#endif
    loadSurface();
    MeshPatch patch_ = patches[gl_InstanceIndex];
    ivec2 grid = ivec2(gl_VertexIndex % (patchCells + 1), gl_VertexIndex / (patchCells + 1));
    vec2 calm = patch_.corner + vec2(grid) * patch_.cell;
    float share = (sight.w * length(vec3(calm, plane.w)) + within.w) / abs(patch_.range);
    float glide = clamp((share - glideBegins) / (glideEnds - glideBegins), 0.0, 1.0);
    calm -= vec2(grid & 1) * patch_.cell * glide;
    // Drawn out at its end, so that no corners of patches show against the sky.
    if (patch_.range < 0.0) calm *= 1.0 + 10.0 * smoothstep(0.9, 1.0, share);
    float cell = patch_.cell * (1.0 + glide);
#endif
#ifdef OUTLINE
    calm = clamp(calm, outlineBox.xy, outlineBox.zw);
    edgeRange = patch_.edgeRange;
#endif

    vec3 relative = vec3(calm.x, -plane.w, calm.y);
#ifdef MOTION
    vec3 last = relative;
#endif
#ifdef WAVES
    float loose = 1.0;
#ifdef OUTLINE
    loose = looseness(calm, patch_.edgeRange);
#endif
#ifdef HOST_MESH
    loose = min(vertex.fromEdge * extent.z, 1.0);
#endif
    vec3 held = vec3(loose, 1.0, loose);
    relative += held * surfaceDisplacement(waveDisplacement, calm, cell);
#ifdef MOTION
#ifdef SHORE
    last += held * displacementOver(lastShoreWave(calm, cell), lastDisplacement, calm, cell);
#else
    last += held * waveDisplacementAt(lastDisplacement, calm, cell, vec4(1.0));
#endif
#endif
#endif
    calmPosition = calm;
    position = relative;
    float drop = globeDrop(calm);
    relative.y -= drop;
#ifdef MOTION
    last.y -= drop;
    lastPixel = lastPixelFromRelative * vec4(last, 1.0);
#endif
    gl_Position = clipFromRelative * vec4(relative, 1.0);
}
