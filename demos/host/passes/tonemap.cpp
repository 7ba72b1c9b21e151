// AgX (Troy Sobotka), in the fit by Benjamin Wrensch ("Minimal AgX Implementation", 2023): bright colours go
// to white along their own hue, so that a sunset stays orange instead of turning yellow.
#include <algorithm>
#include <cmath>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

#include "host/host.h"

namespace demos {
namespace {

glm::vec3 agxCurve(const glm::vec3& x) {
    const glm::vec3 x2 = x * x, x4 = x2 * x2;
    return 15.5f * x4 * x2 - 40.14f * x4 * x + 31.96f * x4 - 6.868f * x2 * x + 0.4298f * x2 + 0.1191f * x -
           0.00232f;
}

/// Display-encoded, 0..1, from linear sRGB.
glm::vec3 agx(const glm::vec3& linear) {
    const glm::mat3 inset(0.842479062253094f, 0.0423282422610123f, 0.0423756549057051f, 0.0784335999999992f,
                          0.878468636469772f, 0.0784336f, 0.0792237451477643f, 0.0791661274605434f,
                          0.879142973793104f);
    const glm::mat3 outset(1.19687900512017f, -0.0528968517574562f, -0.0529716355144438f,
                           -0.0980208811401368f, 1.15190312990417f, -0.0980434501171241f,
                           -0.0990297440797205f, -0.0989611768448433f, 1.15107367264116f);
    constexpr float minEv = -12.47393f, maxEv = 4.026069f;
    const glm::vec3 ev = glm::log2(glm::max(inset * linear, glm::vec3(1e-10f)));
    const glm::vec3 curve = agxCurve(glm::clamp((ev - minEv) / (maxEv - minEv), 0.0f, 1.0f));
    // AgX leaves contrast and colour to a look: this one sits between its base and its "punchy".
    const glm::vec3 contrasted = glm::pow(glm::max(curve, glm::vec3(0)), glm::vec3(1.2f));
    const float grey = glm::dot(contrasted, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    const glm::vec3 coloured = glm::max(glm::mix(glm::vec3(grey), contrasted, 1.25f), glm::vec3(0));
    return glm::clamp(outset * coloured, 0.0f, 1.0f);
}

/// AgX is made for a display with a pure 2.2 curve; bytes are sRGB.
float encodeSrgb(float display) {
    const float linear = std::pow(display, 2.2f);
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

uint8_t toByte(float value) {
    return static_cast<uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

} // namespace

std::vector<uint8_t> toneMap(const Picture& picture, double exposureEv) {
    const auto scale = static_cast<float>(std::exp2(exposureEv));
    std::vector<uint8_t> bytes(size_t(picture.width) * picture.height * 3);
    for (size_t i = 0; i < bytes.size() / 3; ++i) {
        const glm::vec3 linear(picture.rgba[4 * i], picture.rgba[4 * i + 1], picture.rgba[4 * i + 2]);
        uint8_t* const out = &bytes[3 * i];
        if (!std::isfinite(linear.r) || !std::isfinite(linear.g) || !std::isfinite(linear.b)) {
            // Magenta, so that nobody overlooks it.
            out[0] = out[2] = 255;
            out[1] = 0;
            continue;
        }
        const glm::vec3 display = agx(glm::max(linear * scale, glm::vec3(0)));
        for (int c = 0; c < 3; ++c) out[c] = toByte(encodeSrgb(display[c]));
    }
    return bytes;
}

} // namespace demos
