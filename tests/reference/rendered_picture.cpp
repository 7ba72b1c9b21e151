#include "tests/reference/rendered_picture.h"

#include <gtest/gtest.h>

#include "host/passes/supersample.h"

namespace tests {

demos::Picture rendered(demos::Host& host, const demos::Scene& scene, uint32_t width, uint32_t height) {
    demos::Error error;
    constexpr uint32_t factor = 3;
    EXPECT_TRUE(host.load(scene, error)) << error.text;
    const std::optional<demos::Picture> large = host.render(
        {width * factor, height * factor, scene.cameras.front(), scene.timeS, demos::Aov::color}, error);
    EXPECT_TRUE(large) << error.text;
    return averaged(*large, factor);
}

} // namespace tests
