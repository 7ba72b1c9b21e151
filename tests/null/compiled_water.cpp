#include "tests/null/compiled_water.h"

#include <array>
#include <iterator>
#include <tuple>

#include "gpu/memory/mip_chain.h"
#include "gpu/view/single_sample.h"
#include "reflection/after/blur.h"
#include "reflection/after/edge_reach.h"
#include "reflection/after/stretch.h"
#include "reflection/after/temporal.h"
#include "reflection/core/technique.h"
#include "reflection/debug/overlay.h"
#include "reflection/march/cells.h"
#include "reflection/march/march.h"
#include "reflection/march/open_tiles.h"
#include "reflection/planar/planar.h"
#include "reflection/sspr/resolve.h"
#include "reflection/sspr/scatter.h"
#include "reflection/sspr/tiles.h"
#include "reflection/sspr/unseen_tiles.h"
#include "tests/body_parts.h"
#include "tests/null/built_shaders.h"
#include "water/below/caustics.h"
#include "water/body/body.h"
#include "water/foam/foam_gpu.h"
#include "water/shading/placed_samples.h"
#include "water/shading/shaded_surface.h"
#include "water/waves/waves_gpu.h"

namespace tests {

namespace {

using namespace seaglass;

/// A body of a choice's features.
struct Chosen : BodyParts {
    explicit Chosen(const SurfaceChoice& choice) {
        const auto has = [&](char letter) { return hasLetter(choice.letters, letter); };
        sea.windSpeed = 7;
        sea.samples = 64;
        refraction.scattering = 0.25f;
        if (has('w')) desc.waves = &sea;
        if (has('f')) desc.foam = &foam;
        if (has('s')) addShore();
        if (has('l')) desc.reflection = &reflection;
        if (has('r')) desc.refraction = &refraction;
        if (has('r')) desc.bed = &bed;
        if (has('o')) addOutline();
        if (choice.hostMesh) addMesh();
        desc.motion = has('w');
        setQuality(choice.quality, &desc, &reflection);
        // Which a shore's bed has none of.
        if (has('s')) desc.shading.parallax = false;
    }

  private:
    void addOutline() {
        desc.extent.shape = ExtentShape::rectangle;
        desc.extent.size[0] = desc.extent.size[1] = 60;
    }
    void addMesh() {
        desc.extent.shape = ExtentShape::mesh;
        desc.extent.points = corners_.data();
        desc.extent.pointCount = 3;
        desc.extent.indices = triangle_.data();
        desc.extent.indexCount = 3;
    }

    std::array<double, 6> corners_ = {-30, -30, 30, -30, 0, 30};
    std::array<uint32_t, 3> triangle_ = {0, 1, 2};
};

TargetDesc targetDesc(bool multiview) {
    TargetDesc desc;
    desc.colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
    desc.depthFormat = VK_FORMAT_D32_SFLOAT;
    desc.viewMask = multiview ? 3 : 0;
    return desc;
}

SurfaceVariant variantOf(const Body& body, const SurfaceChoice& choice) {
    const SunShadow shadow;
    LightingDesc lighting;
    lighting.skyCube = reinterpret_cast<VkImageView>(uintptr_t{1});
    if (hasLetter(choice.letters, 'h')) lighting.shadow = &shadow;
    return body.surfaceVariant(
        {.output = choice.output, .sides = choice.sides, .isAhead = true, .lighting = &lighting});
}

/// What is made anew for each is compiled anew.
template<typename... Kernels>
void shareEach(Context& context) {
    std::tuple<std::shared_ptr<Kernels>...> kernels;
    std::apply([&](auto&... each) { (void)std::array{context.share(each)...}; }, kernels);
}

/// Of one target, without the cache of those that it has.
template<typename Variant>
void build(const gpu::Device& device, const TargetDesc& target, const Variant& variant) {
    DrawPipeline pipeline;
    (void)buildPipeline(device, target, variant, pipeline);
    device.vk().DestroyPipeline(device.handle(), pipeline.handle, device.allocator());
}

} // namespace

bool hasLetter(const std::string& letters, char letter) {
    return letters.find(letter) != std::string::npos;
}

std::vector<std::string> surfaceLetters() {
    std::vector<std::string> all;
    for (const char* const waves : {"", "w", "wf", "ws", "wfs"})
        for (const char* const sees : {"", "l", "r", "lr"})
            for (const char* const outline : {"", "o"})
                for (const char* const shadow : {"", "h"})
                    all.push_back(std::string(waves) + sees + outline + shadow);
    return all;
}

std::unique_ptr<CompiledWater> CompiledWater::create(std::string& whyNot) {
    std::unique_ptr<CompiledWater> made(new CompiledWater);
    demos::Error error;
    made->device_ = demos::Device::create({}, error);
    if (!made->device_) {
        whyNot = error.text;
        return nullptr;
    }
    made->null_ = NullDevice::create(whyNot);
    if (!made->null_) return nullptr;
    compileTwice(made->null_.get());
    DeviceDesc desc;
    desc.instance = made->device_->instance();
    desc.physicalDevice = made->device_->physical();
    desc.device = made->device_->handle();
    desc.getInstanceProcAddr = compiledTwiceGetInstanceProcAddr;
    desc.message = {[](void* user, const char* text) { *static_cast<std::string*>(user) = text; },
                    &made->message_};
    if (createContext(&desc, &made->context_) != Status::ok) {
        whyNot = made->message_;
        return nullptr;
    }
    return made;
}

CompiledWater::~CompiledWater() {
    destroyContext(context_);
    compileTwice(nullptr);
}

std::vector<CompiledPipeline> CompiledWater::kernels() {
    compiledPipelines().clear();
    makeKernels();
    makeTilesKernels();
    return std::move(compiledPipelines());
}

Status CompiledWater::estimated(const BodyDesc& desc, VkExtent2D extent, Estimate& out) const {
    return estimate(context_, &desc, extent, &out);
}

void CompiledWater::makeTilesKernels() {
    SurfaceTilesKernels tiles;
    (void)tiles.create(*context_);
    const TilesKernels* steps = nullptr;
    (void)tiles.get({.hasReflection = true, .hasRefraction = true, .mirrors = true, .bed = true}, steps);
    CompletingKernels completing;
    (void)completing.create(*context_);
    for (const uint32_t pixels : {2u, 4u}) {
        const gpu::Kernel* kernel = nullptr;
        (void)completing.get(pixels, kernel);
    }
}

void CompiledWater::makeKernels() {
    // Those of each technique, held so that the others of its kind share what both have.
    std::array<std::shared_ptr<void>, std::size(reflectionTechniques)> held;
    for (uint32_t which = 0; which < held.size(); ++which) {
        const Technique& technique = techniqueOf(static_cast<ReflectionTechnique>(which));
        if (technique.createKernels) (void)technique.createKernels(*context_, {}, held[which]);
    }
    shareEach<ScatterKernel, CoarseScatterKernel, TilesKernel, OverhangsTilesKernel, ResolveKernel,
              OverhangsResolveKernel, CellsKernel, SeenTilesKernel, SeenColumnsKernel, OpenTilesKernel,
              BlurKernel, StretchKernel, EdgeReachKernel, TemporalKernel, OverlayKernel,
              PlanarKernelOf<PlanarForm::inPlace>, PlanarKernelOf<PlanarForm::apart>,
              PlanarKernelOf<PlanarForm::resolved>, PlanarKernelOf<PlanarForm::multisampled>,
              DepthSampleKernel, ColorSampleKernel, ResolvedColorKernel, FoamKernel, CastKernel,
              CastOnShoreKernel, GatherKernel, CausticBlurKernel, ShadowedCausticBlurKernel,
              UnseenTilesKernel>(*context_);
    for (const VkFormat format :
         {VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R16G16_SFLOAT}) {
        gpu::MipChain chain;
        (void)chain.create(*context_, format);
    }
    for (const bool cells : {false, true})
        for (const bool open : {false, true}) {
            std::shared_ptr<MarchKernel> march;
            (void)shareMarch(*context_, cells, open, march);
        }
    WaveKernels waves;
    (void)waves.create(*context_);
    for (uint32_t samples = 16; samples <= 2048; samples *= 2) {
        const WavePair* pair = nullptr;
        (void)waves.get(samples, pair);
    }
}

template<typename Make>
std::vector<CompiledPipeline> CompiledWater::madeOf(const SurfaceChoice& choice, Make&& make) {
    // Takes back what the bodies before held.
    (void)beginFrame(context_, slot_ ^= 1);
    const Chosen chosen(choice);
    Body* body = nullptr;
    if (createBody(context_, &chosen.desc, &body) != Status::ok) return {};
    compiledPipelines().clear();
    make(variantOf(*body, choice));
    destroyBody(body);
    return std::move(compiledPipelines());
}

std::vector<CompiledPipeline> CompiledWater::surface(const SurfaceChoice& choice) {
    return madeOf(choice, [&](const SurfaceVariant& variant) {
        const gpu::Device& device = context_->device;
        TargetDesc found = targetDesc(false);
        found.colorFormat = variant.forMotion ? VK_FORMAT_R32G32_SFLOAT : VK_FORMAT_R32_UINT;
        build(device, found, foundVariant(variant));
        TargetDesc sampled = targetDesc(choice.multiview);
        sampled.samples = VK_SAMPLE_COUNT_4_BIT;
        build(device, sampled, placedSamplesVariant(variant));
        if (variant.forMotion) return;
        ShadingKernels kernels;
        (void)kernels.create(*context_);
        SteppedKernels made;
        const TileSorting sorting{.hasReflection = variant.hasReflection,
                                  .hasRefraction = variant.hasRefraction};
        (void)getListed(kernels, variant, sorting, true, made);
    });
}

std::vector<CompiledPipeline> CompiledWater::overView(const ViewPassVariant& variant, bool multiview) {
    compiledPipelines().clear();
    build(context_->device, targetDesc(multiview), variant);
    return std::move(compiledPipelines());
}

std::vector<CompiledPipeline> CompiledWater::spray(const SprayVariant& variant, bool multiview) {
    compiledPipelines().clear();
    build(context_->device, targetDesc(multiview), variant);
    return std::move(compiledPipelines());
}

} // namespace tests
