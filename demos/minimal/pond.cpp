// A triangle becomes a pond: all that a Vulkan renderer adds to have water.   pond OUT.ppm
//
// What was there before is in renderer.h; every call of Seaglass says what it is for.
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include <seaglass/water.h> // the one header for water: host.h, reflection.h and sea.h come along

#include "renderer.h"

namespace {

using namespace minimal;

// What is wrong comes as a line to this callback; calls return which kind of wrong it is.
void say(void*, const char* text) {
    std::fprintf(stderr, "pond: %s\n", text);
}

void check(seaglass::Status status, const char* what) {
    minimal::check(status == seaglass::Status::ok, what);
}

Gpu createGpuForWater() {
    const VkInstance instance = createInstance();
    VkPhysicalDevice devices[8], chosen = VK_NULL_HANDLE;
    uint32_t count = 8;
    vkEnumeratePhysicalDevices(instance, &count, devices);
    // Can a device do it? What the others lack is said.
    for (uint32_t i = 0; i < count && !chosen; ++i)
        if (seaglass::checkSupport(instance, devices[i], vkGetInstanceProcAddr, {say, nullptr}) ==
            seaglass::Status::ok)
            chosen = devices[i];
    minimal::check(chosen != VK_NULL_HANDLE, "finding a device");
    // The features that Seaglass needs switched on, and what the renderer needs itself.
    seaglass::Requirements needs = seaglass::requirements();
    needs.features13.dynamicRendering = VK_TRUE;
    return createGpu(instance, chosen,
                     {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &needs.features13, needs.features});
}

// The plane y = 0 under a breath of wind: it mirrors what the picture shows, and lets the rest shine
// through. What is not named, such as foam, costs nothing.
seaglass::Body* createPond(seaglass::Context* context) {
    seaglass::SeaDesc ripples;
    ripples.windSpeed = 2.5f;
    ripples.fetch = 100;
    const seaglass::ReflectionDesc reflection;
    const seaglass::RefractionDesc refraction;
    seaglass::BodyDesc desc;
    desc.waves = &ripples;
    desc.reflection = &reflection;
    desc.refraction = &refraction;
    seaglass::Body* pond = nullptr;
    check(seaglass::createBody(context, &desc, &pond), "createBody");
    return pond;
}

// The sky where the picture does not tell what is mirrored, and what lights the water from within: blue
// above, as pale as the picture's background at the horizon. A renderer with a sky's cube hands it over.
seaglass::LightingDesc skyLight() {
    constexpr float blue[3] = {0.15f, 0.3f, 0.6f}, pale[3] = {0.55f, 0.65f, 0.75f};
    seaglass::LightingDesc light;
    std::memcpy(light.skyZenith, blue, sizeof blue);
    std::memcpy(light.skyHorizon, pale, sizeof pale);
    return light;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: pond OUT.ppm\n");
        return 2;
    }
    const Gpu gpu = createGpuForWater();
    constexpr VkImageUsageFlags read = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    constexpr VkImageUsageFlags written = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    const Picture color = createPicture(gpu, colorFormat, size, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | read);
    const Picture depth =
        createPicture(gpu, depthFormat, size, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | read);
    // Water reads what lies behind and before it while it is drawn over it: from copies.
    const Picture colorCopy = createPicture(gpu, colorFormat, size, written);
    const Picture depthCopy = createPicture(gpu, depthFormat, size, written);
    const Triangle triangle = createTriangle(gpu);
    // The eye is 1.7 m up and 6 m back. An infinite far plane, reversed depth, y down as Vulkan has it.
    constexpr double tangent = 0.414, nearest = 0.1, aspect = 640.0 / 360;
    const Camera camera = {
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.7, -6, 1},
        {1 / (aspect * tangent), 0, 0, 0, 0, -1 / tangent, 0, 0, 0, 0, 0, -1, 0, 0, nearest, 0}};

    // One context for the device. It owns nothing of the renderer's, never submits and never waits.
    seaglass::DeviceDesc device;
    device.instance = gpu.instance;
    device.physicalDevice = gpu.physical;
    device.device = gpu.device;
    device.getInstanceProcAddr = vkGetInstanceProcAddr;
    device.message = {say, nullptr};
    seaglass::Context* context = nullptr;
    check(seaglass::createContext(&device, &context), "createContext");

    // The attachments that water is drawn into, for its pipelines.
    seaglass::TargetDesc attachments;
    attachments.colorFormat = colorFormat;
    attachments.depthFormat = depthFormat;
    seaglass::Target* target = nullptr;
    check(seaglass::createTarget(context, &attachments, &target), "createTarget");

    seaglass::Body* const pond = createPond(context);

    // The camera, and the copies as shaders see them.
    seaglass::ViewDesc view;
    std::memcpy(view.view, camera.view, sizeof camera.view);
    std::memcpy(view.projection, camera.projection, sizeof camera.projection);
    view.viewport = {0, 0, size.width, size.height, 0, 1};
    view.sceneColor = {colorCopy.view, colorFormat, size, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    view.sceneDepth = {depthCopy.view, depthFormat, size, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    const seaglass::LightingDesc light = skyLight();

    beginCommands(gpu);
    // This frame's slot, whose last use the GPU is done with; then the waves of this moment, in seconds.
    check(seaglass::beginFrame(context, 0), "beginFrame");
    check(seaglass::simulate(gpu.commands, &pond, 1, 12.5), "simulate");

    become(gpu, color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
    become(gpu, depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
    beginPass(gpu, color, depth, VK_ATTACHMENT_LOAD_OP_CLEAR);
    draw(gpu, triangle, camera);
    vkCmdEndRendering(gpu.commands);

    // Behind the opaque scene: what the pond mirrors of it, and how it looks, outside of any pass; then the
    // pond, over it.
    copy(gpu, color, colorCopy);
    copy(gpu, depth, depthCopy);
    check(seaglass::reflect(gpu.commands, &pond, 1, &view), "reflect");
    check(seaglass::shade(gpu.commands, &pond, 1, &view, &light), "shade");
    beginPass(gpu, color, depth, VK_ATTACHMENT_LOAD_OP_LOAD);
    check(seaglass::draw(gpu.commands, target, &pond, 1, &view, &light), "draw");
    vkCmdEndRendering(gpu.commands);
    finish(gpu, color, argv[1]);

    // Bodies and targets before their context, the context before the device.
    seaglass::destroyBody(pond);
    seaglass::destroyTarget(target);
    seaglass::destroyContext(context);
    destroyTriangle(gpu, triangle);
    for (const Picture& picture : {color, depth, colorCopy, depthCopy}) destroyPicture(gpu, picture);
    destroyGpu(gpu);
    return 0;
}
