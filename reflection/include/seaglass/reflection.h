// Reflections in planes, for water, floors and mirrors: screen-space (SSPR) or drawn by the host with a
// mirrored camera (planar). Usable without the water library.
//
// For each view a Reflector gives two images of the view's size, or of a fraction of it: `color`, the scene
// as the plane mirrors it at each pixel, and `info`, what is known about it. Whoever shades the surface looks
// them up (see shaders/water/surface/reflection_lookup.glsl) and bends the lookup by its own normals.
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

/// Samples a pixel of a view's scene; see ViewDesc::sceneDepth.
struct SceneSamples {
    VkSampleCountFlagBits depth = VK_SAMPLE_COUNT_1_BIT; ///< of ViewDesc::sceneDepth
    VkSampleCountFlagBits color = VK_SAMPLE_COUNT_1_BIT; ///< of ViewDesc::sceneColor
};

/// What the host draws its scene into once more, as planarView() and bedView() say: as the pipelines of its
/// main pass want it. What it draws is linear once sampled, as ViewDesc::sceneColor is.
struct DrawnDesc {
    VkFormat colorFormat = VK_FORMAT_R16G16B16A16_SFLOAT; ///< one of those of ViewDesc::sceneColor
    VkFormat depthFormat = VK_FORMAT_D32_SFLOAT; ///< D16, X8_D24 or D32, each with stencil or without
    /// Of the depth 1 to 16 a pixel. Of the colour as many; or 1, which the host resolves into from a
    /// multisampled image of its own, cleared to black.
    SceneSamples samples;
};

/// How a plane mirrors.
struct ReflectionDesc {
    ReflectionTechnique technique = ReflectionTechnique::sspr; ///< how what is mirrored is found
    uint32_t downscale = 1; ///< pixels of the view to one of the reflection, each way: 1, 2, 4 or 8
    /// Of the reflection [pixel], whatever the view's size, 8..16384: in the place of `downscale`, which is
    /// not read then, that of 1, 2, 4 and 8 which brings it nearest by ratio; the larger of two as near. The
    /// width follows. 0: by `downscale`.
    uint32_t height = 0;
    /// SSPR scatters one key for 2 x 2 pixels: a quarter of their memory. Looking steeply down it finds less.
    bool coarseKeys = false;
    float edgeFade = 0.08f; ///< share of the height over which borrowed pixels fade at the border, 0..0.5
    /// They fade at whichever of the four borders is nearest; else at the one towards which they are
    /// borrowed, which alone can cut a reflection off. Not of `planar`.
    bool edgeFadeAround = false;
    /// How far beyond the picture's border what reaches it is taken to go on, as a share of the height, 0..1:
    /// what is a plane for twice as long inside, as walls are. It fades out at the end of that instead. 0
    /// costs nothing, and shows strips of sky beside walls that the border cuts off; else two dispatches. Not
    /// of `planar`, nor of views with `surfaceNormals`.
    float edgeReach = 0;
    float undersideLight = 0.15f; ///< of an underside that is not seen, as a share of its top's, 0..1
    uint32_t overhangSamples = 0; ///< sspr, hybrid: for undersides that end unseen, 0..8, 6 for 1080p
    float distortion = 1.0f;      ///< share of the normal's tilt that is followed: 0, a flat mirror, to 1
    uint32_t blurLevels = 4;      ///< halvings kept for rough surfaces, 0..6; 0 costs nothing: all are sharp
    /// Reflections of what is no farther from the mirror than this are not blurred by `scatter` [m], 0..1e6.
    float clearDistance = 0;
    float scatter = 0; ///< how fast they widen beyond it: the sine of a cone, 0..1. Wants blurLevels
    /// How far from the mirror the sky has taken over, from half of that on [m], 0..1e6; 0: nowhere.
    float skyFadeDistance = 0;
    /// Pixels beside the picture's borders take what is mirrored farther inside, by 1 + height of that above
    /// the plane [m] x how steeply the camera looks down (0..1) x nearness to the border (0..1) x this [1/m],
    /// 0..100. 0 costs nothing; else one dispatch.
    float edgeStretch = 0;
    float edgeStretchBand = 0.15f; ///< share of the width, from either border, that it moves, 0.01..0.5
    /// Share of each pixel that is taken from the view's last frame, 0..0.95; 0 costs nothing. Reflections
    /// then shimmer less, and keep for a while what this frame alone does not know. About 1 / (1 - this)
    /// frames are averaged; 0.9 suits most. See ViewDesc::jitter and ViewDesc::cut.
    float temporal = 0;
    DrawnDesc drawn; ///< planar: what the host draws into

    // Of techniques that follow rays over the picture.
    /// Rays pass at once over cells of 8 x 8 pixels in which nothing is as near as they are, and look at
    /// every pixel of the others: they miss nothing that is thin. Without, they go in strides.
    bool marchCells = true;
    uint32_t marchSteps = 64; ///< pixels a ray looks at at most, 8..512; strides are as long as that asks for
    float marchThickness = 1; ///< depth of things behind what is seen of them, at most [m], 0.001..100
    float marchDistance = 10000; ///< how far along a ray hits are looked for [m], 0.1..1e6
    /// Share of a stride by which each pixel's ray starts earlier or later than its neighbours', 0..1: trades
    /// banding for noise, the same in each frame. Without strides there are no bands, and it does nothing.
    float marchJitter = 0;
};

/// One plane that mirrors.
struct ReflectorDesc {
    double plane[4] = {0, 1, 0, 0}; ///< n.p + d = 0 in the world; any scale but zero
    ReflectionDesc reflection;      ///< how it does
    /// A box around all of the surface that mirrors, waves included [m, world]; all infinite: anywhere in the
    /// plane. Views that do not see it cost nothing, and others only where it may show, if
    /// ReflectionDesc::distortion is 0.
    double boundsLow[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    double boundsHigh[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}; ///< see boundsLow
};

constexpr uint32_t maxReflectors = 16; ///< of one call of reflect()

/// What such a reflector costs for views of `extent` pixels, in images of that size. Creates nothing.
Status estimate(Context* context, const ReflectionDesc* desc, VkExtent2D extent, Estimate* out,
                SceneSamples samples = {});

struct Reflector;

/// Transactional; allocates no image until the first reflect().
Status createReflector(Context* context, const ReflectorDesc* desc, Reflector** out);
/// May be called while the GPU still uses it: memory goes back when its frame slot comes. Null is ignored.
void destroyReflector(Reflector* reflector);

/// What reflect() left for a view, to be asked for anew in each frame. Both images are in
/// VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, visible to fragment and compute shaders, and valid until this
/// view is reflected again.
struct ReflectionImages {
    VkImage colorImage = VK_NULL_HANDLE; ///< of `color`
    VkImageView color = VK_NULL_HANDLE;  ///< RGBA16F: radiance times confidence, confidence 0..1; with mips
    VkImage infoImage = VK_NULL_HANDLE;  ///< of `info`
    /// R16F: positive, the distance from the mirror to what it shows [m]; 0, nothing is known; negative, it
    /// shows the sky. See ReflectionClass.
    VkImageView info = VK_NULL_HANDLE;
    VkExtent2D extent = {0, 0}; ///< of both images [pixel]
    /// True: the surface's normals have bent `color` and `info` already (ViewDesc::surfaceNormals), and a
    /// lookup takes its own pixel. False: they show a flat mirror, and lookups bend.
    bool bent = false;
    uint32_t downscale = 1; ///< pixels of the view to one of them, each way
    uint32_t age = 0;       ///< frames since this view was reflected: 0, in this one; see chooseReflectors()
    /// Of the view then. Where it has moved since, look up where this puts the mirror's point, not in its
    /// pixel.
    double clipFromWorld[16] = {};
};

/// What is known of a pixel of the mirror.
enum class ReflectionClass : uint32_t {
    unknown = 0, ///< the plane is not seen here, or nothing on the screen tells what it mirrors
    sky = 1,     ///< proven to mirror the far plane: use the sky
    hit = 2,     ///< `color` holds what is mirrored
};

/// What a value of `info` says.
inline ReflectionClass reflectionClass(float info) {
    if (info > 0) return ReflectionClass::hit;
    return info < 0 ? ReflectionClass::sky : ReflectionClass::unknown;
}

/// What the host draws, and where, for technique `planar`: its opaque scene from behind the mirror, without
/// the sky and without whatever lies in the plane itself.
///
/// Before drawing, the host takes mip 0 of the colour and the depth from VK_IMAGE_LAYOUT_UNDEFINED, waiting
/// for fragment and compute shaders that may still sample what was in them: recordDrawnUse() of record.h. It
/// clears the depth to `clearDepth` and need not clear the colour, unless it resolves into that. It leaves
/// them in VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL and VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
/// last written by attachment output and depth tests; reflect() does the rest. Alpha may hold anything. Depth
/// runs as in the host's own projection: same compare, and same pipelines where DrawnDesc has their formats
/// and samples.
struct PlanarView {
    /// False where the view does not see the reflector: nothing need be drawn, and nothing else is said.
    bool visible = true;
    double view[16] = {};       ///< world to mirrored view: the host's view times the reflection in the plane
    double projection[16] = {}; ///< the host's, with the plane as near plane; x, y and w are as they were
    /// False where the eye is so close to the plane that it cannot be a near plane, or sees nothing of it:
    /// the projection is then the host's own.
    bool obliqueClip = false;
    bool windingFlipped = true;                 ///< always: front faces are wound the other way round
    VkViewport viewport = {};                   ///< within the images below
    VkExtent2D extent = {0, 0};                 ///< of both images [pixel]
    VkImage colorImage = VK_NULL_HANDLE;        ///< of `color`
    VkImageView color = VK_NULL_HANDLE;         ///< mip 0 alone; held as in ViewDesc::sceneColor
    VkFormat colorFormat = VK_FORMAT_UNDEFINED; ///< DrawnDesc's
    VkImage depthImage = VK_NULL_HANDLE;        ///< of `depth`
    /// To be attached, of a format with stencil for that too, and cleared to clearDepth. Shaders sample its
    /// depth.
    VkImageView depth = VK_NULL_HANDLE;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED; ///< DrawnDesc's
    VkImageAspectFlags depthAspects = 0;        ///< of barriers on depthImage
    SceneSamples samples;                       ///< DrawnDesc's
    float clearDepth = 0; ///< of the far plane: where nothing was drawn the sky is mirrored
};

/// Says what to draw before reflect() is called with the same `view`, once for each such call. Records
/// nothing. Allocates when a view's size changes. The scene's images in `view` are not looked at. Fails with
/// `invalidArgument` when the reflector's technique is not `planar`.
Status planarView(Reflector* reflector, const ViewDesc* view, PlanarView* out);

/// Records the reflection of `view` for each of at most maxReflectors, whose planes may differ: what one
/// shows does not depend on the others. Of more, chooseReflectors() says which. Those that the view does not
/// see are passed over; what reflectionImages() has of them is of some frame before. Outside any render pass.
/// Reads view.sceneColor and view.sceneDepth in compute shaders: the host has made them visible there
/// (VK_ACCESS_2_SHADER_SAMPLED_READ). Allocates when a view's size changes. With technique `sky` nothing is
/// recorded; with `planar` the scene's images are not read, but what was drawn since planarView(), in
/// view.sceneColor's encoding.
Status reflect(VkCommandBuffer commands, Reflector* const* reflectors, uint32_t count, const ViewDesc* view);

/// Of many reflectors those to renew in this frame, `most` of them, 1..maxReflectors: their indices go to
/// `chosen`, which has room for that many, in rising order, and their number to `chosenCount`. Records
/// nothing. planarView() and reflect() are then called for those alone, with the same view; the others keep
/// the images that they have, as they are: nothing moves or fades them.
///
/// First come those that have none of this view's size, then those that cover most: pixels of the box around
/// the surface times the frames since it was reflected, so that each gets its turn, those that show most
/// nearly in each frame. Of equals the one of the lower index. Those that the view does not see, and those
/// whose technique is `sky`, are not chosen. No clock, nothing random: the same calls choose the same.
Status chooseReflectors(Reflector* const* reflectors, uint32_t count, const ViewDesc* view, uint32_t most,
                        uint32_t* chosen, uint32_t* chosenCount);

/// The images of a view index, null handles where it has not been reflected.
ReflectionImages reflectionImages(const Reflector* reflector, uint32_t viewIndex);

/// What recordOverlay() draws of a view. Distances [m] run from white at 0.1 over yellow at 1, teal at 10 and
/// violet at 100 to black at 1000, in bands that end at 1, 2, 5, 10, 20 ..., every other one darker.
enum class OverlayKind : uint32_t {
    /// Distance ahead of the eye, as depth and matrices tell it. Light blue: the far plane. Magenta: no
    /// depth.
    depth = 0,
    /// Blue, in bands of distance: the plane is seen there. Green to white: what stands above it, a black
    /// contour line every `contourSpacing`, white from the tenth on. Light blue: the far plane.
    plane = 1,
    classes = 2,    ///< of what is mirrored. Green: hit, blue: sky, red: unknown, near black: no plane seen
    confidence = 3, ///< dark red: 0, white: 1, near black: no plane seen
    /// From the mirror to what it shows. Light blue: sky, red: unknown, near black: no plane seen.
    hitDistance = 4,
};
/// Its names, from 0 on.
inline constexpr const char* overlayKinds[] = {"depth", "plane", "classes", "confidence", "hit-distance"};

/// Debugging: what the library makes of its inputs.
struct OverlayDesc {
    OverlayKind kind = OverlayKind::depth; ///< what is drawn
    /// An RGBA16F storage image in VK_IMAGE_LAYOUT_GENERAL, at least as large as the viewport, and drawn into
    /// there: colours of 0..1, alpha 1. The host has made it ready for writing in compute shaders
    /// (VK_ACCESS_2_SHADER_STORAGE_WRITE), and waits for that afterwards.
    Image target;
    float contourSpacing = 1; ///< heights between the contour lines of OverlayKind::plane [m], 0.001..1e6
};

/// Draws how the library understands a view's camera, depth and plane, or what reflect() has left for it: a
/// wrong matrix shows at once. Outside any render pass; reads view.sceneDepth like reflect(). `depth` and
/// `plane` need no reflect() before. The pipeline is made at the first call; a host that never calls pays
/// nothing.
Status recordOverlay(VkCommandBuffer commands, Reflector* reflector, const ViewDesc* view,
                     const OverlayDesc* desc);

} // namespace seaglass
