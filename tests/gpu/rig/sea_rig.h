// Bodies of open water, and an eye over them.
#pragma once

#include "seaglass/waves_fftw.h"
#include "tests/gpu/rig/water_rig.h"

namespace tests {

inline Camera seaCamera() {
    Camera camera;
    camera.eye = {3, 4, 7};
    camera.target = {3, 3, -10};
    camera.width = 320;
    camera.height = 180;
    return camera;
}

class SeaTest : public WaterTest {
  protected:
    seaglass::Body* wavyBody(const seaglass::SeaDesc& sea) {
        seaglass::BodyDesc desc;
        desc.waves = &sea;
        desc.wavesBackend = seaglass::fftwWaves();
        return makeBody(desc);
    }
    seaglass::Body* flatBody() { return makeBody({}); }
    /// As described, with a breeze's waves that mirror the scene.
    seaglass::Body* mirroringBreeze(seaglass::BodyDesc desc,
                                    const seaglass::ReflectionDesc& reflection = {}) {
        const seaglass::SeaDesc sea = breeze();
        desc.waves = &sea;
        desc.reflection = &reflection;
        return makeBody(desc);
    }
};

} // namespace tests
