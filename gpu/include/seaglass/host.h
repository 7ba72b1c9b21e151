// What a host renderer hands to Seaglass: device, images, camera, light. Plain data: every struct is copied
// before the call that takes it returns.
//
// World: right-handed, +Y up, metres; world.h turns others. Matrices are column-major, for column vectors,
// and double: floats 100 km from the origin step by 8 mm. Colours are linear, HDR, in the host's own scale.
#pragma once

#include "seaglass/fog.h"
#include "seaglass/version.h"

#include <cstdint>
#include <vulkan/vulkan_core.h>

namespace seaglass {

/// Every call that can fail returns one of these, and DeviceDesc::message hears what exactly was wrong.
enum class [[nodiscard]] Status : int32_t{
    ok = 0,
    invalidArgument,   ///< a field is null, not finite or out of its stated range; nothing was done
    unsupported,       ///< the device lacks a feature, format or limit that the call needs
    outOfHostMemory,   ///< nothing was created
    outOfDeviceMemory, ///< nothing was created
    deviceLost,        ///< terminal: destroy everything
    vulkanError,       ///< another VkResult, named in the message
};

const char* toString(Status status); ///< its name, for logs; never null

/// Receives one line per error or warning, on the thread that calls Seaglass.
struct MessageCallback {
    void (*function)(void* user, const char* text) = nullptr; ///< null: nobody is told
    void* user = nullptr;                                     ///< handed back to it
};

/// Called before and after each GPU pass is recorded, for timestamps or labels.
struct PassCallback {
    /// `pass` is such as "sspr_scatter".
    void (*function)(void* user, VkCommandBuffer commands, const char* pass, bool begins) = nullptr;
    void* user = nullptr; ///< handed back to it
};

/// A piece of the host's device memory, for one buffer or image.
struct MemoryPiece {
    VkDeviceMemory memory = VK_NULL_HANDLE; ///< of which it is a piece
    VkDeviceSize offset = 0;                ///< [byte]
    void* mapped = nullptr; ///< of host-visible memory: where the piece begins, while it is held
    void* own = nullptr;    ///< the host's
};

/// Device memory from the host, such as VMA's, on the thread that calls Seaglass.
struct MemoryCallbacks {
    /// As `needs` says, of a type with all of `wanted`; `image`: of optimal tiling (bufferImageGranularity).
    VkResult (*allocate)(void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags wanted,
                         bool image, MemoryPiece* out) = nullptr;
    void (*release)(void* user, const MemoryPiece* piece) = nullptr; ///< what allocate() gave
    void* user = nullptr;                                            ///< handed back to both
};

/// The host's device. It must outlive the context.
struct DeviceDesc {
    uint32_t headerVersion = SEAGLASS_VERSION; ///< of the headers that the host is compiled with; leave it
    VkInstance instance = VK_NULL_HANDLE;      ///< that `physicalDevice` is of
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;        ///< that `device` was created on
    VkDevice device = VK_NULL_HANDLE;                        ///< created with what requirements() asks for
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr; ///< the loader's; no Vulkan symbol is linked
    uint32_t framesInFlight = 2;                      ///< 1 to 4: frame slots that may be pending at once
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;   ///< this and the rest are optional
    const VkAllocationCallbacks* allocator = nullptr; ///< copied
    MemoryCallbacks memory;                           ///< null: vkAllocateMemory for each buffer and image
    MessageCallback message;                          ///< hears what is wrong
    PassCallback pass;                                ///< around each pass
};

/// What the device must be created with: chain `features13` behind `features` for vkCreateDevice.
struct Requirements {
    uint32_t apiVersion = 0;                       ///< of instance and device, at least
    VkPhysicalDeviceFeatures features{};           ///< of Vulkan 1.0
    VkPhysicalDeviceVulkan13Features features13{}; ///< of Vulkan 1.3
};

Requirements requirements(); ///< before the device exists; any thread

/// Checks a device against requirements(), formats and limits. Any thread. `unsupported`: `message` names the
/// first thing that is missing.
Status checkSupport(VkInstance instance, VkPhysicalDevice physicalDevice,
                    PFN_vkGetInstanceProcAddr getInstanceProcAddr, MessageCallback message);

/// Pipelines, samplers and per-frame memory on one device. No state is global: several contexts may share a
/// device. One thread at a time uses a context and what was made of it, unless a call says "any thread".
struct Context;

/// `unsupported` without a message: the headers are of another version than the library.
Status createContext(const DeviceDesc* desc, Context** out);
/// After the device has finished all that was recorded through it. Null is ignored. While bodies, reflectors
/// or targets exist it says so and does nothing.
void destroyContext(Context* context);

/// Starts a frame in slot 0 .. framesInFlight-1, after the GPU has finished what was recorded in the slot
/// before. Memory and objects that were destroyed then are taken back now.
Status beginFrame(Context* context, uint32_t slot);

/// How an image or an attachment holds colour.
enum class Encoding : uint32_t {
    unspecified = 0, ///< linear, and a message where UNORM of 8 or 10 bits makes that unlikely
    linear,          ///< in proportion to light, as sampled and as written; an sRGB format's is, too
    srgb,            ///< by the sRGB curve (IEC 61966-2-1), which shaders apply, and not the format
};
inline constexpr const char* encodings[] = {"unspecified", "linear", "srgb"}; ///< its names, from 0 on

/// A view of one of the host's images: of VK_IMAGE_USAGE_SAMPLED_BIT, type 2D, without a swizzle, of
/// VK_IMAGE_ASPECT_COLOR_BIT or VK_IMAGE_ASPECT_DEPTH_BIT alone.
struct Image {
    VkImageView view = VK_NULL_HANDLE;     ///< of mip 0 and layer 0
    VkFormat format = VK_FORMAT_UNDEFINED; ///< the view's; an sRGB view decodes what a UNORM view would not
    VkExtent2D extent = {0, 0};            ///< [pixel]
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< when sampled, GENERAL or read-only: never changed
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT; ///< scene's: 1..16, at standard locations; else 1
    Encoding encoding = Encoding::unspecified;             ///< of sceneColor, planar and bed pictures
};

/// One camera in one frame.
struct ViewDesc {
    double view[16] = {}; ///< world to view: turns and moves, and may mirror
    /// View to clip; along the view's z either way, orthographic along -z. Its depth's direction, near and
    /// far, infinity too, are read from it.
    double projection[16] = {};
    VkViewport viewport = {}; ///< as set for drawing [pixel]; a negative height flips; depth range 0..1
    /// Opaque scene colour: RGBA16F, RGBA32F, B10G11R11_UFLOAT, or RGBA8, BGRA8 and packed A8B8G8R8 as UNORM
    /// or SRGB, whose alpha is not read. Null with `sceneDepth`: no scene, for water that needs none.
    Image sceneColor;
    /// Opaque scene depth of the same pixels: D16, X8_D24, D32, each with stencil or without, or a copy as
    /// R16_UNORM or R32_SFLOAT. What the format cannot tell apart from the plane counts as lying on it. Of
    /// multisampled images sample 0 is read; beside resolved colour, along edges, the next pixel of the same
    /// surface. Such a view holds 12 bytes a pixel more.
    Image sceneDepth;
    uint32_t viewIndex = 0; ///< 0..7: which view of this frame, so that each keeps its own images
    /// Optional, of ssr, which then follows each pixel's own ray: unit world normals of the surface (RGBA16F,
    /// RGBA32F or RGBA8_SNORM) at the same pixels, for compute shaders. 0 and not finite: the plane's.
    const Image* surfaceNormals = nullptr;
    double jitter[2] = {0, 0}; ///< of this frame's picture by `projection`, right and down [pixel], -16..16:
                               ///< `temporal` averages over it, SurfaceOutput::motion leaves it out
    bool cut = false;          ///< the camera or the scene jumped: those two begin anew
};

/// What something costs, known before it is made: images and buffers on this device, without pipelines,
/// uniform blocks, and what all bodies of a context share (with foam 0.7 MB).
struct Estimate {
    uint64_t bytes = 0;                   ///< device memory held once
    uint64_t bytesPerView = 0;            ///< and for each view index that is used
    uint32_t dispatchesPerView = 0;       ///< compute dispatches that reflect() records
    uint64_t bytesPerSharedView = 0;      ///< of a multisampled scene, for all of a context together
    uint32_t dispatchesPerSharedView = 0; ///< likewise, once in a call of reflect()
};

/// The host's shadow map of the sun: 1 to 4 cascades, finest first, each a layer of one image or part of it.
struct SunShadow {
    Image map;                  ///< depth as ViewDesc::sceneDepth has it, one sample; the view is a 2D_ARRAY
    uint32_t cascadeCount = 1;  ///< a point takes the first that holds it; beyond all it is lit
    bool reversedDepth = false; ///< what is nearer to the sun is greater
    double textureFromWorld[4][16] = {}; ///< of each cascade: to u and v of its layer, and depth
    float bounds[4][4] = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}}; ///< u, v; low, high
    uint32_t layers[4] = {0, 1, 2, 3}; ///< of the map, of each cascade
};

/// Where light comes from.
struct LightingDesc {
    double toSun[3] = {0, 1, 0};        ///< unit, world, from the surface towards the sun
    float sunIrradiance[3] = {0, 0, 0}; ///< on a plane facing the sun; each finite, 0 or more
    /// On the water's plane, without the sun. Zeros with a null `skyCube`: that of the colours below.
    float skyIrradiance[3] = {0, 0, 0};
    VkImageView skyCube = VK_NULL_HANDLE; ///< radiance without the sun: a cube, +Y up; null: colours below
    VkImageLayout skyCubeLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL; ///< when sampled
    uint32_t skyCubeMipLevels = 1;     ///< of skyCube, 1..16; no more are read than its view has
    const SunShadow* shadow = nullptr; ///< of what hides the sun from the water; null: nothing does
    /// Of a null `skyCube`: radiance straight up, each 0 or more. A unit direction that rises by y has the
    /// share |y| (2 - |y|) of the way from the horizon's to it, or to skyGround. By default a clear day.
    float skyZenith[3] = {0.08f, 0.16f, 0.32f};
    float skyHorizon[3] = {0.40f, 0.50f, 0.60f}; ///< likewise, at the horizon
    float skyGround[3] = {0.15f, 0.15f, 0.13f};  ///< likewise, straight down
    const FogDesc* fog = nullptr; ///< from the eye, or an orthographic near plane, to the water; null: none.
                                  ///< ViewDesc::sceneColor has the host's already, and gets no more
};

/// What a sky of colours sends from a unit direction, for hosts that draw it: light, whatever is asked. One
/// that is longer counts as straight up or down, and no number as level. Any thread.
void skyRadiance(const LightingDesc& lighting, const double (&direction)[3], float (&out)[3]);

} // namespace seaglass
