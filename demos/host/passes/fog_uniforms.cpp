#include "host/passes/fog_uniforms.h"

namespace demos {

void setFogUniforms(const seaglass::FogDesc& fog, const Camera& camera, const BentSun* water,
                    FrameUniforms& uniforms) {
    uniforms.fog = seaglass::fogBlock(fog, camera.eye.y);
    uniforms.fogEye = {0, 0, 0, camera.near};
    uniforms.fogSight = uniforms.sight;
    uniforms.fogWater =
        water ? glm::vec4(glm::dvec4(water->normal, -water->depthOf(camera.eye))) : glm::vec4(0, 0, 0, 1);
}

void moveFogUniforms(const glm::dvec3& step, FrameUniforms& uniforms) {
    uniforms.fogEye -= glm::vec4(glm::vec3(step), 0);
}

} // namespace demos
