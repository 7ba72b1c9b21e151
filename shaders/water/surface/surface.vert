// Places the vertices of a patch: glides them onto the next coarser lattice near the end of their level's range
// (Strugar 2009), then lets the waves displace them. Of a mesh of the host's own they stand where it says.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "one_view.glsl"
#include "surface.glsl"

layout(location = 0) out vec2 calmPosition;   // (u, v) before displacement, relative to the eye
layout(location = 1) out vec3 position;   // over the plane, as if there were no globe
layout(location = 2) flat out uvec2 edgeRange;   // of an outline
layout(location = 3) out vec4 lastPixel;   // homogeneous; for motion

const int patchCells = 16;   // that vertices are numbered by; fewer may be drawn
// A patch may reach past its level's range by its parent's diagonal, 22.6 cells of the coarser level; gliding must end
// before the range does and begin after the coarser neighbour's patches can touch it.
const float glideBegins = 0.7;
const float glideEnds = 0.95;

#include "wave_displacement.glsl"
#include "globe.glsl"

struct Vertex {
    vec2 calm;
    float cell;
    float loose;   // of its way to the side, how much waves move it
};

Vertex hostVertex() {
    HostVertex vertex = hostVertices[gl_VertexIndex];
    return Vertex(water.meshOrigin + vertex.calm, vertex.cell, loosenessAt(vertex.fromEdge));
}

vec2 onLattice(vec2 cells) {
    return water.meshOrigin + cells * water.meshCell;
}

Vertex patchVertex(MeshPatch patch_) {
    ivec2 grid = ivec2(gl_VertexIndex % (patchCells + 1), gl_VertexIndex / (patchCells + 1));
    int cell = int(round(patch_.cell / water.meshCell));
    ivec2 at = patch_.corner + grid * cell;
    float share = distanceForDetail(onLattice(vec2(at))) / abs(patch_.range);
    float glide = clamp((share - glideBegins) / (glideEnds - glideBegins), 0.0, 1.0);
    // Where it has glided to the coarser lattice, from that point's whole numbers.
    ivec2 moves = (grid & 1) * cell;
    vec2 calm = onLattice(vec2(at - moves) + (1.0 - glide) * vec2(moves));
    // Drawn out at its end, so that no corners of patches show against the sky.
    if (patch_.range < 0.0) calm *= 1.0 + 10.0 * smoothstep(0.9, 1.0, share);
    return Vertex(calm, patch_.cell * (1.0 + glide), 1.0);
}

Vertex outlinedVertex(OutlinedPatch outlined) {
    Vertex vertex = patchVertex(outlined.patch_);
    vertex.calm = clamp(vertex.calm, outlineBox.xy, outlineBox.zw);
    if (hasWaves) vertex.loose = looseness(vertex.calm, outlined.edgeRange);
    return vertex;
}

Vertex vertexHere() {
    if (isHostMesh) return hostVertex();
    if (isOutlined) return outlinedVertex(outlinedPatches[gl_InstanceIndex]);
    return patchVertex(patches[gl_InstanceIndex]);
}

vec3 lastDisplacementOf(Vertex vertex) {
    if (hasShore) return displacementOver(lastShoreWave(vertex.calm, vertex.cell), lastDisplacement, vertex.calm, vertex.cell);
    return waveDisplacementAt(lastDisplacement, vertex.calm, vertex.cell, vec4(1.0));
}

void main() {
    if (isOtherView()) {
        gl_Position = outOfSight;
        return;
    }
    Vertex vertex = vertexHere();
    if (isOutlined) edgeRange = outlinedPatches[gl_InstanceIndex].edgeRange;
    vec3 relative = onCalmPlane(vertex.calm);
    vec3 last = relative;
    if (hasWaves) {
        vec3 held = vec3(vertex.loose, 1.0, vertex.loose);
        relative += held * surfaceDisplacement(waveDisplacement, vertex.calm, vertex.cell);
        if (forMotion) last += held * lastDisplacementOf(vertex);
    }
    calmPosition = vertex.calm;
    position = relative;
    float drop = globeDrop(vertex.calm);
    relative.y -= drop;
    if (forMotion) {
        last.y -= drop;
        lastPixel = homogeneousLastPixel(last);
    }
    gl_Position = clipOf(relative);
}
