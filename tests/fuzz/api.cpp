// Descriptors of the API, of any values, on a device that does nothing: whatever they hold, a call returns a
// status, with a line when it fails, and keeps nothing of what it refused.
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "seaglass/water.h"
#include "tests/body_parts.h"
#include "tests/faults/failing_device.h"
#include "tests/fuzz/taken.h"

namespace fuzz {

namespace {

using namespace seaglass;

/// Most fields are as they are by default, and one in some bytes is anything: what is wrong in all would be
/// refused for the first.
class Spoilt {
  public:
    explicit Spoilt(Taken& from) : from_(from) {}
    template<typename T>
    void operator()(T& field) {
        if (from_.below(4) == 0) field = from_.value<T>();
    }
    /// Enums and flags whose values no host's compiler lets be others.
    void operator()(bool& field) {
        if (from_.below(4) == 0) field = from_.yes();
    }

  private:
    Taken& from_;
};

struct Water : ::tests::BodyParts {
    explicit Water(Taken& from) {
        Spoilt spoil(from);
        spoilSea(spoil, from);
        for (float* const field : {&foam.bias, &foam.decayTime, &foam.albedo}) spoil(*field);
        for (float& value : refraction.absorption) spoil(value);
        for (float& value : refraction.backscatter) spoil(value);
        spoil(refraction.distortion), spoil(refraction.scattering);
        spoilReflection(spoil);
        spoil(underwater.meniscus), spoil(caustics.strength), spoil(bed.margin);
        if (from.yes()) desc.waves = &sea;
        if (from.yes()) desc.foam = &foam;
        if (from.yes()) desc.refraction = &refraction;
        if (from.yes()) desc.reflection = &reflection;
        if (from.yes()) desc.underwater = &underwater;
        if (from.yes()) desc.caustics = &caustics;
        if (from.yes()) desc.bed = &bed;
        for (double& value : desc.plane) spoil(value);
        spoil(desc.motion);
        spoilExtent(spoil, from);
        spoil(desc.mesh.cellSize), spoil(desc.mesh.cellsPerLevel);
        for (uint32_t* const field :
             {&desc.shading.reflectionSamples, &desc.shading.refractionSamples, &desc.shading.bedDownscale,
              &desc.shading.causticStep, &desc.shading.slopeSamples, &desc.shading.waveShadowSteps})
            spoil(*field);
        spoil(desc.shading.parallax);
        desc.wavesOn = WavesOn::gpu;
    }

    void spoilSea(Spoilt& spoil, Taken& from) {
        sea.samples = 16;
        sea.cascades = 1;
        sea.spectrum = static_cast<SpectrumModel>(from.below(6));
        sea.spreading = static_cast<SpreadingModel>(from.below(5));
        for (float* const field :
             {&sea.windSpeed, &sea.windDirection, &sea.fetch, &sea.peakEnhancement, &sea.depth,
              &sea.spreadingShape, &sea.swell, &sea.amplitude, &sea.choppiness, &sea.largestPatch, &sea.warp})
            spoil(*field);
        spoil(sea.loopPeriod), spoil(sea.seed), spoil(sea.capFetch);
        // Large ones are no mistake, and take long.
        if (from.below(8) == 0) sea.samples = from.value<uint8_t>();
        if (from.below(8) == 0) sea.cascades = from.value<uint8_t>();
        for (SwellDesc& swell : sea.swells)
            for (float* const field :
                 {&swell.height, &swell.peakPeriod, &swell.direction, &swell.bandwidth, &swell.spreading})
                spoil(*field);
        for (SpectrumSample& sample : table) spoil(sample.frequency), spoil(sample.density);
        sea.spectrumTable = table;
        sea.spectrumTableCount = from.below(5);
        for (float& height : fourHeights) spoil(height);
        if (from.below(4) != 0) return;
        shore.bed = fourHeights;
        shore.samples[0] = shore.samples[1] = 2;
        spoil(shore.spacing);
        for (double& value : shore.origin) spoil(value);
        sea.shore = &shore;
    }

    void spoilReflection(Spoilt& spoil) {
        for (float* const field :
             {&reflection.edgeFade, &reflection.edgeReach, &reflection.undersideLight, &reflection.distortion,
              &reflection.clearDistance, &reflection.scatter, &reflection.skyFadeDistance,
              &reflection.edgeStretch, &reflection.edgeStretchBand, &reflection.temporal,
              &reflection.marchThickness, &reflection.marchDistance, &reflection.marchJitter})
            spoil(*field);
        for (uint32_t* const field : {&reflection.downscale, &reflection.height, &reflection.overhangSamples,
                                      &reflection.blurLevels, &reflection.marchSteps})
            spoil(*field);
        for (bool* const field : {&reflection.coarseKeys, &reflection.edgeFadeAround, &reflection.marchCells})
            spoil(*field);
    }

    void spoilExtent(Spoilt& spoil, Taken& from) {
        ExtentDesc& extent = desc.extent;
        extent.shape = static_cast<ExtentShape>(from.below(5));
        spoil(extent.planetRadius), spoil(extent.yaw);
        extent.size[0] = extent.size[1] = 20;
        for (double& value : extent.center) spoil(value);
        for (double& value : extent.size) spoil(value);
        for (double& value : points) spoil(value);
        for (uint32_t& value : indices) spoil(value);
        extent.points = points;
        extent.pointCount = from.below(6);
        extent.indices = indices;
        extent.indexCount = from.below(8);
    }

    SpectrumSample table[4] = {{0.05f, 0}, {0.1f, 1}, {0.2f, 0.5f}, {0.5f, 0}};
    float fourHeights[4] = {-5, -4, -3, -2};
    double points[10] = {0, 0, 10, 0, 10, 10, 0, 10, -5, 5};
    uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
};

struct Frame {
    Frame(Taken& from, ::tests::FailingDevice& device) {
        Spoilt spoil(from);
        for (int i = 0; i < 4; ++i) view.view[5 * i] = 1;
        view.view[13] = -2;
        view.projection[0] = 1.2, view.projection[5] = -2, view.projection[11] = -1,
        view.projection[14] = 0.1;
        view.viewport = {0, 0, 64, 48, 0, 1};
        for (double& value : view.view) spoil(value);
        for (double& value : view.projection) spoil(value);
        for (float* const field : {&view.viewport.x, &view.viewport.y, &view.viewport.minDepth})
            spoil(*field);
        // Large ones are no mistake either.
        view.viewport.width = static_cast<float>(from.value<uint8_t>() + 1);
        view.viewport.height = static_cast<float>(from.value<int8_t>());
        spoil(view.viewIndex), spoil(view.cut);
        for (double& value : view.jitter) spoil(value);
        view.sceneColor = imageOf(spoil, device, VK_FORMAT_R16G16B16A16_SFLOAT);
        view.sceneDepth = imageOf(spoil, device, VK_FORMAT_D32_SFLOAT);
        for (double& value : lighting.toSun) spoil(value);
        for (auto* const colors : {&lighting.sunIrradiance, &lighting.skyIrradiance, &lighting.skyZenith,
                                   &lighting.skyHorizon, &lighting.skyGround})
            for (float& value : *colors) spoil(value);
        for (float* const field : {&fog.density, &fog.start, &fog.end, &fog.falloff, &fog.fromSky, &fog.most})
            spoil(*field);
        spoil(fog.baseHeight);
        fog.shape = static_cast<FogShape>(from.below(6));
        if (from.yes()) lighting.fog = &fog;
        if (from.yes()) lighting.skyCube = device.hosts<VkImageView>();
        time = from.yes() ? from.value<double>() : 5;
    }

    static Image imageOf(Spoilt& spoil, ::tests::FailingDevice& device, VkFormat format) {
        Image image;
        image.view = device.hosts<VkImageView>();
        image.format = format;
        image.extent = {256, 256};
        image.layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        uint32_t as = static_cast<uint32_t>(image.format);
        spoil(as);
        image.format = static_cast<VkFormat>(as);
        spoil(image.extent.width), spoil(image.extent.height);
        return image;
    }

    FogDesc fog;
    LightingDesc lighting;
    ViewDesc view;
    double time = 0;
};

/// What a call says must fit: a line with each failure.
void said(Status status, std::string& message) {
    if (status != Status::ok && message.empty()) std::abort();
    message.clear();
}

/// A context, and a body that keeps what all bodies share, such as the pattern of foam: to make these anew
/// for each run takes most of the time.
class Host {
  public:
    Host() {
        DeviceDesc desc = device.desc();
        desc.message = {[](void* user, const char* text) { *static_cast<std::string*>(user) = text; },
                        &message};
        said(createContext(&desc, &context), message);
        TargetDesc targetDesc;
        targetDesc.colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
        targetDesc.depthFormat = VK_FORMAT_D32_SFLOAT;
        said(createTarget(context, &targetDesc, &target), message);
        ::tests::BodyParts parts;
        parts.desc.foam = &parts.foam;
        parts.desc.waves = &parts.sea;
        parts.sea.samples = 16;
        parts.desc.wavesOn = WavesOn::gpu;
        said(createBody(context, &parts.desc, &keeper_), message);
    }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    ~Host() {
        destroyBody(keeper_);
        destroyTarget(target);
        destroyContext(context);
        if (device.held() != 0) std::abort();
    }

    ::tests::FailingDevice device;
    std::string message;
    Context* context = nullptr;
    seaglass::Target* target = nullptr;

  private:
    Body* keeper_ = nullptr;
};

void callOn(Host& host, Bytes bytes) {
    Taken from(bytes);
    ::tests::FailingDevice& device = host.device;
    const Water water(from);
    const size_t held = device.held();
    Body* body = nullptr;
    const Status made = createBody(host.context, &water.desc, &body);
    said(made, host.message);
    if (made != Status::ok && (body || device.held() != held)) std::abort();
    if (body) {
        const Frame frame(from, device);
        said(beginFrame(host.context, 0), host.message);
        said(simulate(device.commands(), &body, 1, frame.time), host.message);
        said(reflect(device.commands(), &body, 1, &frame.view), host.message);
        said(castCaustics(device.commands(), &body, 1, &frame.view, &frame.lighting), host.message);
        said(shade(device.commands(), &body, 1, &frame.view, &frame.lighting), host.message);
        said(draw(device.commands(), host.target, &body, 1, &frame.view, &frame.lighting), host.message);
    }
    destroyBody(body);
    if (device.garbageDestroyed() || device.garbageUsed()) std::abort();
}

} // namespace

void callApi(Bytes bytes) {
    // What a run leaves is found when its host ends: a file alone leaks as it did among others.
    constexpr unsigned mostRuns = 256;
    static std::unique_ptr<Host> host;
    static unsigned runs = 0;
    if (runs++ % mostRuns == 0) host = std::make_unique<Host>();
    callOn(*host, bytes);
}

} // namespace fuzz
