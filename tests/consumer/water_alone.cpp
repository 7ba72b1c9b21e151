// Water with waves, with no FFTW in the link: compute shaders make them.
#include <seaglass/water.h>

int main() {
    const seaglass::SeaDesc sea;
    seaglass::BodyDesc desc;
    desc.waves = &sea;
    if (seaglass::fieldsOf(desc.mesh).count == 0) return 1;
    seaglass::Body* body = nullptr;
    // No device, so no body; but everything that makes one is linked.
    return seaglass::createBody(nullptr, &desc, &body) == seaglass::Status::invalidArgument ? 0 : 1;
}
