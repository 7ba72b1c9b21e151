// Reflections in planes, for water, floors and mirrors, without the water library: from the picture, or drawn
// by the host with a mirrored camera. For each view a Reflector gives two images: `color`, the scene as the
// plane mirrors it, and `info`, what is known about it. The surface's shader samples them, bent by normals.
#pragma once

#include <math.h>

#include "seaglass/host.h"

namespace seaglass {

/// How what a plane mirrors is found; where it is not, the sky stands in.
enum class ReflectionTechnique : uint32_t {
    sky = 0,    ///< the environment cube alone; costs nothing
    sspr = 1,   ///< scene pixels scattered to where the plane mirrors them
    ssr = 2,    ///< each pixel's mirrored ray followed over the picture
    hybrid = 3, ///< sspr, and ssr where it knows nothing
    planar = 4, ///< the host draws its scene once more, as planarView() says
};
/// Its names, from 0 on.
inline constexpr const char* reflectionTechniques[] = {"sky", "sspr", "ssr", "hybrid", "planar"};

/// Samples a pixel of a view's scene, 1 to 16.
struct SceneSamples {
    VkSampleCountFlagBits depth = VK_SAMPLE_COUNT_1_BIT; ///< of ViewDesc::sceneDepth
    VkSampleCountFlagBits color = VK_SAMPLE_COUNT_1_BIT; ///< of ViewDesc::sceneColor
};

/// What the host draws its scene into once more, for planarView() and bedView(): as its main pass wants it.
struct DrawnDesc {
    VkFormat colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT; ///< one of those of ViewDesc::sceneColor
    VkFormat depthFormat = VK_FORMAT_D32_SFLOAT; ///< D16, X8_D24 or D32, each with stencil or without
    SceneSamples samples; ///< alike; or a colour of 1, into which the host resolves its own, cleared to black
};

/// How a plane mirrors.
struct ReflectionDesc {
    ReflectionTechnique technique = ReflectionTechnique::sspr; ///< how what is mirrored is found
    uint32_t downscale = 1; ///< pixels of the view to one of the reflection, each way: 1, 2, 4 or 8
    /// Its height [pixel], 8..16384: the nearest ratio of these is taken, of two the larger. 0: `downscale`.
    uint32_t height = 0;
    bool coarseKeys = false; ///< sspr: a key for 2 x 2 pixels, a quarter of the memory; finds less far down
    float edgeFade = 0.08f;  ///< share of the height over which borrowed pixels fade at the border, 0..0.5
    bool edgeFadeAround = false; ///< at the nearest border; else at that they are taken past. Not of `planar`
    /// How far beyond the border what reaches it goes on, such as a wall, if twice as long inside: a share of
    /// the height, 0..1. 0: strips of sky beside such walls; else two dispatches. Not of `planar`, nor of
    /// views with `surfaceNormals`.
    float edgeReach = 0;
    float undersideLight = 0.15f; ///< of an underside that is not seen, as a share of its top's, 0..1
    uint32_t overhangSamples = 0; ///< sspr, hybrid: for undersides that end unseen, 0..8, 6 for 1080p
    float distortion = 1.0f;      ///< share of the normal's tilt that is followed: 0, a flat mirror, to 1
    uint32_t blurLevels = 4;      ///< halvings kept for rough surfaces, 0..6; 0 costs nothing: all are sharp
    float clearDistance = 0;      ///< from the mirror, up to which `scatter` blurs nothing [m], 0..1e6
    float scatter = 0;            ///< how fast it widens beyond: the sine of a cone, 0..1. Wants blurLevels
    float skyFadeDistance = 0;    ///< from half of this on the sky takes over [m], 0..1e6; 0: nowhere
    /// Pixels beside the borders take what is mirrored farther inside: h [m] above the plane it is stretched
    /// by 1 + h x this [1/m] x steepness of the camera x nearness to the border (both 0..1). 0..100; 0 costs
    /// nothing, else one dispatch.
    float edgeStretch = 0;
    float edgeStretchBand = 0.15f; ///< share of the width, from either border, that it moves, 0.01..0.5
    /// Share of each pixel that is the view's last frame's, 0..0.95: averages about 1 / (1 - this) frames.
    /// Less shimmers, and what one frame does not know is kept. 0 costs nothing, 0.9 suits most.
    float temporal = 0;
    DrawnDesc drawn; ///< planar: what the host draws into

    /// Of ssr and hybrid, like the rest: rays skip cells of 8 x 8 pixels in which nothing is as near, and
    /// test each pixel of the others, so they miss nothing thin. Without, they go in strides.
    bool marchCells = true;
    uint32_t marchSteps = 64;    ///< pixels that a ray tests at most, 8..512: strides are that long
    float marchThickness = 1;    ///< depth of things behind what is seen of them, at most [m], 0.001..100
    float marchDistance = 10000; ///< how far along a ray hits are looked for [m], 0.1..1e6
    float marchJitter = 0; ///< share of a stride that neighbours' rays start apart, 0..1: noise for bands
};

/// One plane that mirrors.
struct ReflectorDesc {
    double plane[4] = {0, 1, 0, 0}; ///< n.p + d = 0 in the world; any scale but zero
    ReflectionDesc reflection;      ///< how it does
    /// A box around all that mirrors, waves included [m, world]. Views that do not see it cost nothing,
    /// others only where it may show, if ReflectionDesc::distortion is 0.
    double boundsLow[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    double boundsHigh[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}; ///< likewise
};

constexpr uint32_t maxReflectors = 16; ///< of one call of reflect()

/// What a reflector costs for views of `extent` pixels, in images of that size. Creates nothing.
Status estimate(Context* context, const ReflectionDesc* desc, VkExtent2D extent, Estimate* out,
                SceneSamples samples = {});

struct Reflector;
/// All or nothing; allocates no image until the first reflect().
Status createReflector(Context* context, const ReflectorDesc* desc, Reflector** out);
/// At any time: memory goes back when its frame slot comes. Null is ignored.
void destroyReflector(Reflector* reflector);

/// What reflect() left for a view, to be asked for in each frame: two images in SHADER_READ_ONLY_OPTIMAL,
/// visible to fragment and compute shaders, valid until this view is reflected again.
struct ReflectionImages {
    VkImage colorImage = VK_NULL_HANDLE; ///< of `color`
    VkImageView color = VK_NULL_HANDLE;  ///< RGBA16F: radiance times confidence, confidence 0..1; with mips
    VkImage infoImage = VK_NULL_HANDLE;  ///< of `info`
    VkImageView info = VK_NULL_HANDLE; ///< R16F: from mirror to what it shows [m], signed: reflectionClass()
    VkExtent2D extent = {0, 0};        ///< of both images [pixel]
    bool bent = false;             ///< by ViewDesc::surfaceNormals: sample the own pixel. False: lookups bend
    uint32_t downscale = 1;        ///< pixels of the view to one of them, each way
    uint32_t age = 0;              ///< frames since this view was reflected; 0: in this one
    double clipFromWorld[16] = {}; ///< of the view then: sample where it puts the mirror's point
};

/// What is known of a pixel of the mirror.
enum class ReflectionClass : uint32_t {
    unknown = 0, ///< the plane is not seen here, or nothing on the screen tells what it mirrors
    sky = 1,     ///< proven to mirror the far plane: use the sky
    hit = 2,     ///< `color` holds what is mirrored
};

/// Of a value of ReflectionImages::info.
inline ReflectionClass reflectionClass(float info) {
    if (info > 0) return ReflectionClass::hit;
    return info < 0 ? ReflectionClass::sky : ReflectionClass::unknown;
}

/// What the host draws for technique `planar`, and where: its opaque scene from behind the mirror, without
/// the sky and what lies in the plane itself, linear once sampled. Alpha may hold anything. Depth runs as in
/// the host's projection: same compare, and same pipelines where DrawnDesc has their formats and samples.
///
/// The host takes mip 0 of both from VK_IMAGE_LAYOUT_UNDEFINED, after shaders that still sample them:
/// recordDrawnUse() does. It clears the depth, and the colour if it resolves into that. It leaves them in
/// COLOR_ATTACHMENT_OPTIMAL and DEPTH_STENCIL_ATTACHMENT_OPTIMAL, last written as attachments.
struct PlanarView {
    bool visible = true;        ///< false: the view does not see the reflector, and nothing else is said
    double view[16] = {};       ///< world to mirrored view: the host's view times the reflection in the plane
    double projection[16] = {}; ///< the host's, with the plane as near plane; x, y and w are as they were
    bool obliqueClip = false;   ///< false: the eye is too near the plane, or sees nothing of it
    bool windingFlipped = true; ///< always: front faces are wound the other way round
    VkViewport viewport = {};   ///< within the images below
    VkExtent2D extent = {0, 0}; ///< of both images [pixel]
    VkImage colorImage = VK_NULL_HANDLE;        ///< of `color`
    VkImageView color = VK_NULL_HANDLE;         ///< mip 0 alone; held as in ViewDesc::sceneColor
    VkFormat colorFormat = VK_FORMAT_UNDEFINED; ///< DrawnDesc's
    VkImage depthImage = VK_NULL_HANDLE;        ///< of `depth`
    VkImageView depth = VK_NULL_HANDLE;         ///< to be attached, for stencil too, cleared to clearDepth
    VkFormat depthFormat = VK_FORMAT_UNDEFINED; ///< DrawnDesc's
    VkImageAspectFlags depthAspects = 0;        ///< of barriers on depthImage
    SceneSamples samples;                       ///< DrawnDesc's
    float clearDepth = 0; ///< of the far plane: where nothing was drawn the sky is mirrored
};

/// Says what to draw before each reflect() of the same `view`, whose images it does not read. Records
/// nothing; allocates when a view's size changes. `invalidArgument`: the technique is not `planar`.
Status planarView(Reflector* reflector, const ViewDesc* view, PlanarView* out);

/// Records the reflection of `view` in each of at most maxReflectors, on any planes; of more,
/// chooseReflectors() says which. Those that the view does not see keep an earlier frame's images. Outside
/// any render pass. Compute shaders read the scene's images (VK_ACCESS_2_SHADER_SAMPLED_READ). Allocates when
/// a view's size changes. `sky` records nothing; `planar` reads what was drawn since planarView() instead, in
/// view.sceneColor's encoding.
Status reflect(VkCommandBuffer commands, Reflector* const* reflectors, uint32_t count, const ViewDesc* view);

/// Which of many reflectors to renew in this frame: up to `most` indices (1..maxReflectors) in rising order
/// go to `chosen`, their number to `chosenCount`. planarView() and reflect() are then called for those alone,
/// with the same view; others keep their images. Records nothing. The same calls choose the same: those
/// without images of this view's size, then those of most pixels of their box times frames since they were
/// reflected, of equals the lower index; never those that the view does not see, nor `sky`.
Status chooseReflectors(Reflector* const* reflectors, uint32_t count, const ViewDesc* view, uint32_t most,
                        uint32_t* chosen, uint32_t* chosenCount);

/// The images of a view index, null handles where it has not been reflected.
ReflectionImages reflectionImages(const Reflector* reflector, uint32_t viewIndex);

/// What recordOverlay() draws of a view. Distances [m] run from white at 0.1 over yellow at 1, teal at 10 and
/// violet at 100 to black at 1000. Their bands end at 1, 2, 5, 10, 20 ..., every other one darker. Light blue
/// is the far plane.
enum class OverlayKind : uint32_t {
    depth = 0,       ///< distance ahead of the eye; magenta: no depth
    plane = 1,       ///< blue, in bands of distance: it is seen. Green to white: above it, with contour lines
    classes = 2,     ///< of what is mirrored. Green: hit, blue: sky, red: unknown, near black: no plane seen
    confidence = 3,  ///< dark red: 0, white: 1, near black: no plane seen
    hitDistance = 4, ///< from the mirror. Light blue: sky, red: unknown, near black: no plane seen
};
/// Its names, from 0 on.
inline constexpr const char* overlayKinds[] = {"depth", "plane", "classes", "confidence", "hit-distance"};

/// Debugging: what the library makes of its inputs.
struct OverlayDesc {
    OverlayKind kind = OverlayKind::depth; ///< what is drawn
    /// An RGBA16F storage image in VK_IMAGE_LAYOUT_GENERAL, as large as the viewport or larger: colours of
    /// 0..1 there, alpha 1, written by compute shaders.
    Image target;
    float contourSpacing = 1; ///< between the contour lines of `plane` [m], 0.001..1e6
};

/// Draws how the library understands a view's camera, depth and plane, or what reflect() left: a wrong matrix
/// shows at once. Outside any render pass. Reads view.sceneDepth; `depth`, `plane` need no reflect() before.
Status recordOverlay(VkCommandBuffer commands, Reflector* reflector, const ViewDesc* view,
                     const OverlayDesc* desc);

} // namespace seaglass
