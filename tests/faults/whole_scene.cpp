#include "tests/faults/whole_scene.h"

#include "tests/unit/cameras.h"

namespace tests {

using namespace seaglass;

WholeScene::WholeScene(FailingDevice& device, ReflectionTechnique technique, VkSampleCountFlagBits samples,
                       const VkAllocationCallbacks* allocator)
    : device_(device), allocator_(allocator) {
    describeWater(technique);
    describeView(samples);
    // Which castCaustics() has none for.
    if (samples != VK_SAMPLE_COUNT_1_BIT) water_.desc.caustics = nullptr;
}

WholeScene::~WholeScene() {
    destroyReflector(reflector_);
    destroyBody(body_);
    destroyTarget(target_);
    destroyContext(context_);
}

void WholeScene::describeWater(ReflectionTechnique technique) {
    water_.addAll();
    water_.addShore();
    water_.sea.windSpeed = 7;
    water_.sea.samples = 16;
    water_.sea.cascades = 2;
    water_.refraction.scattering = 0.25f;
    water_.reflection.technique = technique;
    water_.reflection.temporal = 0.9f;
    water_.reflection.edgeStretch = 0.5f;
    water_.reflection.edgeReach = technique == ReflectionTechnique::planar ? 0 : 0.2f;
    water_.reflection.overhangSamples = 3;
    water_.desc.wavesOn = WavesOn::gpu;
    water_.desc.spray = nullptr; // wants more wind
    water_.desc.motion = true;
}

void WholeScene::describeView(VkSampleCountFlagBits samples) {
    Camera camera;
    camera.eye = {0, 0.02, 10}; // at the waterline, so that it is seen from within, too
    view_ = viewDesc(camera);
    const VkExtent2D extent = {64, 48};
    view_.sceneColor = image(VK_FORMAT_R16G16B16A16_SFLOAT, extent, samples);
    view_.sceneDepth = image(VK_FORMAT_D32_SFLOAT, extent, samples);
    lighting_.sunIrradiance[0] = lighting_.skyIrradiance[0] = 1;
    lighting_.skyCube = device_.hosts<VkImageView>();
    shadow_.map = image(VK_FORMAT_D32_SFLOAT, {64, 64}, VK_SAMPLE_COUNT_1_BIT);
    for (int i = 0; i < 4; ++i) shadow_.textureFromWorld[0][5 * i] = 1;
    lighting_.shadow = &shadow_;
    fog_.shape = FogShape::height;
    lighting_.fog = &fog_;
    overlay_.target = image(VK_FORMAT_R16G16B16A16_SFLOAT, {256, 256}, VK_SAMPLE_COUNT_1_BIT);
    overlay_.target.layout = VK_IMAGE_LAYOUT_GENERAL;
}

Image WholeScene::image(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples) {
    Image made;
    made.view = device_.hosts<VkImageView>();
    made.format = format;
    made.extent = extent;
    made.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    made.samples = samples;
    return made;
}

void WholeScene::setExtent(VkExtent2D extent) {
    view_.viewport.width = static_cast<float>(extent.width);
    view_.viewport.height = static_cast<float>(extent.height);
    view_.sceneColor.extent = view_.sceneDepth.extent = extent;
}

const ViewDesc& WholeScene::view(VkExtent2D extent) {
    setExtent(extent);
    return view_;
}

std::vector<Step> WholeScene::steps() {
    std::vector<Step> steps = {
        {"createContext",
         [this] {
             DeviceDesc desc = device_.desc();
             desc.allocator = allocator_;
             desc.message = {[](void* user, const char* text) {
                                 const tests::Fed fed;
                                 *static_cast<std::string*>(user) = text;
                             },
                             &message_};
             return createContext(&desc, &context_);
         },
         true},
        {"createTarget",
         [this] {
             TargetDesc desc;
             desc.colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
             desc.depthFormat = VK_FORMAT_D32_SFLOAT;
             return createTarget(context_, &desc, &target_);
         },
         true},
        {"createBody", [this] { return createBody(context_, &water_.desc, &body_); }, true},
        {"createReflector",
         [this] {
             ReflectorDesc desc;
             desc.reflection = water_.reflection;
             return createReflector(context_, &desc, &reflector_);
         },
         true},
        {"prepare", [this] { return prepare(target_, body_, &view_, &lighting_); }},
    };
    for (size_t i = 0; i < steps.size(); ++i) steps[i].again = i;
    addFrame(steps, 0, 1, {64, 48});
    addFrame(steps, 1, 1.1, {64, 48});
    addFrame(steps, 0, 1.2, {96, 64});
    addFrame(steps, 1, 1.3, {96, 64});
    return steps;
}

void WholeScene::addFrame(std::vector<Step>& steps, uint32_t slot, double time, VkExtent2D extent) {
    const auto add = [&, begins = steps.size()](const char* name, auto call) {
        steps.push_back({name, call, false, begins});
    };
    add("beginFrame", [this, slot, extent] {
        setExtent(extent);
        return beginFrame(context_, slot);
    });
    add("simulate", [this, time] { return simulate(device_.commands(), &body_, 1, time); });
    if (water_.reflection.technique == ReflectionTechnique::planar) {
        add("planarView", [this] {
            PlanarView drawn;
            return planarView(body_, &view_, &drawn);
        });
        add("planarView of a reflector", [this] {
            PlanarView drawn;
            return planarView(reflector_, &view_, &drawn);
        });
    }
    if (water_.desc.caustics) {
        add("castCaustics",
            [this] { return castCaustics(device_.commands(), &body_, 1, &view_, &lighting_); });
        add("drawCaustics",
            [this] { return drawCaustics(device_.commands(), target_, &body_, 1, &view_, &lighting_); });
    }
    add("bedView", [this] {
        PlanarView drawn;
        return bedView(body_, &view_, &drawn);
    });
    add("reflect", [this] { return reflect(device_.commands(), &body_, 1, &view_); });
    add("reflect of a reflector", [this] { return reflect(device_.commands(), &reflector_, 1, &view_); });
    add("shade", [this] { return shade(device_.commands(), &body_, 1, &view_, &lighting_); });
    add("shade of motion",
        [this] { return shade(device_.commands(), &body_, 1, &view_, &lighting_, SurfaceOutput::motion); });
    add("recordOverlay", [this] { return recordOverlay(device_.commands(), reflector_, &view_, &overlay_); });
    add("draw", [this] { return draw(device_.commands(), target_, &body_, 1, &view_, &lighting_); });
    add("draw of motion", [this] {
        return draw(device_.commands(), target_, &body_, 1, &view_, &lighting_, SurfaceOutput::motion);
    });
}

} // namespace tests
