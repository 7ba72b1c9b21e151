// Water bodies: an FFT-displaced sea, its reflection, refraction and foam, in the host's command buffer.
//
// A frame:  beginFrame -> simulate -> (host draws its opaque scene) -> reflect -> shade -> (host begins its
// pass) -> draw. Caustics: castCaustics, drawCaustics after the opaque scene. A bed: bedView before reflect.
// All but draw() and drawCaustics() record outside any render pass. Calls allocate when a viewIndex sees its
// largest view, and make pipelines at first need: prepare().
#pragma once

#include "seaglass/reflection.h"
#include "seaglass/sea.h"

namespace seaglass {

/// Light that enters the water. Of a view without scene images the water is endlessly deep.
struct RefractionDesc {
    float absorption[3] = {0.345f, 0.0622f, 0.0253f};   ///< at 650, 550, 450 nm [1/m], 0..100: water_type.h
    float backscatter[3] = {0.0011f, 0.0016f, 0.0030f}; ///< likewise. Both: WaterType::clearOcean
    float distortion = 1.0f;                            ///< 0: straight through; 1: bent as Snell says
    float scattering = 0; ///< by particles [1/m], 0..100: light through crests. Ocean 0.035, coast 0.25
};

/// The body seen from within: where a view's near plane lies under the surface, draw() draws that from below,
/// and the water before the opaque scene, by RefractionDesc's coefficients.
struct UnderwaterDesc {
    float meniscus = 0.003f; ///< dark line where it leaves the water (capillary: 2.7 mm) [m], 0..0.1; 0: none
    float shafts = 0; ///< sunlight that waves gather, seen on its way down, 0..1: 1 as they say; 0: none
    float snow = 0;   ///< what drifts in the water, of all that may, 0..1; 0: none. Not before parallel lines
};

/// Sunlight that the waves gather on what lies below: drawCaustics(). By the curvature of waves that a depth
/// can bring to a focus; fades as the water scatters the beam (Petzold 1972, Morel 1974).
struct CausticsDesc {
    float strength = 1.0f; ///< of the contrast, 0..1: 1 as the waves say
};

/// Drops that wind tears off breaking crests, from 9 m/s on (Andreas 1998): a function of the sea and the
/// time. Of unbounded bodies. Drawn after the surfaces, and tested against depth that the target writes.
struct SprayDesc {
    float density = 1.0f;          ///< of the optical depth, 0..4: 1 by the wind; 0: none
    float shutterTime = 1.0f / 48; ///< along which drops streak [s], 0..0.1; 0: none. Half a film frame
};

/// What lies below in a picture of its own, drawn as bedView() says: refraction then finds what the view's
/// picture ends before, or hides behind a pool's edge. For an eye above the water.
struct BedDesc {
    float margin = 0.1f; ///< by which it is larger on each side, as a share of the view's size, 0..1
    DrawnDesc drawn;     ///< what the host draws it into
};

/// How finely the surface is meshed; by parallel lines of sight as from where 45 degrees see as much.
struct MeshDesc {
    float cellSize = 0.25f;       ///< edge of the finest cells [m], 0.01..100; waves nearer than 64 get finer
    uint32_t cellsPerLevel = 128; ///< cells until a twice coarser level takes over, 128..1024
};

/// What share of light is mirrored: exact (Born and Wolf 1999, 1.5.2), or as Schlick approximates it (1994).
enum class Fresnel : uint32_t { exact = 0, schlick };
inline constexpr const char* fresnels[] = {"exact", "schlick"}; ///< its names, from 0 on

/// How the surface is shaded: mostly, samples a pixel. docs/tradeoffs.md has what each costs.
struct ShadingDesc {
    uint32_t reflectionSamples = 2;   ///< for what the slopes within a pixel mirror: 1, 2 or 4
    uint32_t refractionSamples = 6;   ///< for where the bent ray ends, 1 (straight through) .. 16
    uint32_t bedDownscale = 1;        ///< pixels of the view to one of `BodyDesc::bed`, each way, 1..8
    uint32_t causticStep = 1;         ///< pixels from one ray of the sun to the next, each way, 1..8
    uint32_t slopeSamples = 1;        ///< along a pixel's longer side, at waves, foam, shadow: 1, 2 or 4
    uint32_t waveShadowSteps = 0;     ///< for waves that hide low sun and sky, 2..32; 0: a mean (Smith)
    uint32_t sprayParticles = 131072; ///< of spray in a view, at most, 1024..262144
    bool parallax = false; ///< shades waves too short for the mesh at their own height; not on a shore
    float glitter = 0;     ///< of slopes within a pixel, the share by which facets flash, 0..0.95; 0: a mean
    float gusts = 0;       ///< cat's paws, dull patches that run with the wind, 0..1: as rough as open sea
    Fresnel fresnel = Fresnel::exact; ///< of what the eye sees; light for the bed enters by exact's share
    uint32_t pixelsPerShading = 1;    ///< to one that is shaded, 1, 2 or 4: others are as those beside them
};

/// What a body covers of its plane.
enum class ExtentShape : uint32_t {
    unbounded = 0, ///< all of it, to the horizon; costs nothing
    rectangle,     ///< a pool or a canal
    polygon,       ///< a lake by its shore line
    mesh,          ///< triangles of the host's own, drawn as they are
};
/// Its names, from 0 on.
inline constexpr const char* extentShapes[] = {"unbounded", "rectangle", "polygon", "mesh"};

/// Points are (u, v), as in sea.h [m]. Within 2.5 significant wave heights (times a choppiness over 1) of the
/// outline waves move water less to the side, and at it only up and down. Height queries know of none.
struct ExtentDesc {
    ExtentShape shape = ExtentShape::unbounded; ///< says which fields below are read
    /// Of `unbounded`: a ball's radius R [m], 1e6..1e9, Earth's 6.371e6; 0: flat. It touches `plane` below
    /// each view's eye: d metres from there all lies d^2 / (R + sqrt(R^2 - d^2)) lower, the host's land too.
    double planetRadius = 0;
    double center[2] = {0, 0}; ///< of `rectangle`: its middle
    double size[2] = {0, 0};   ///< likewise, along its own u and v [m], each 0.01..1e6
    double yaw = 0;            ///< likewise, of its own u, from +u towards +v [rad]
    /// Of `polygon`: corners, either way round; no edge crosses or touches another. Cut by pixels: lay it
    /// under the bank. Of `mesh`: vertices. Waves shorter than a triangle's edge show in its light alone.
    const double* points = nullptr;    ///< u and v of each in turn
    uint32_t pointCount = 0;           ///< pairs: 3..1024 corners, 3..2^24 vertices
    const uint32_t* indices = nullptr; ///< of `mesh`: three to a triangle, either way round
    uint32_t indexCount = 0;           ///< a multiple of 3
};

/// Where a body's waves are computed; the sea is the same.
enum class WavesOn : uint32_t {
    automatic = 0, ///< the GPU; or, on a device that is a CPU itself, `wavesBackend` if there is one
    gpu,           ///< compute shaders, on any device; nothing is kept or done on the CPU
    cpu,           ///< `wavesBackend`, in simulate(), and uploaded
};
inline constexpr const char* wavesOn[] = {"automatic", "gpu", "cpu"}; ///< its names, from 0 on

/// One water body. A null feature costs no memory, pipeline or dispatch. Copied, pointees included.
struct BodyDesc {
    double plane[4] = {0, 1, 0, 0};             ///< the calm surface, n.p + d = 0; n.y > 0, of any scale
    ExtentDesc extent;                          ///< to the horizon unless it says otherwise
    const SeaDesc* waves = nullptr;             ///< null: flat as glass
    WavesOn wavesOn = WavesOn::automatic;       ///< the GPU, or `wavesBackend`
    const WavesBackend* wavesBackend = nullptr; ///< of the CPU, e.g. fftwWaves(); null: the GPU alone
    const FoamDesc* foam = nullptr;             ///< needs `waves`
    const RefractionDesc* refraction = nullptr; ///< null: opaque, draw() reads no scene images
    /// Null: the sky cube alone. Without waves and `scatter` nothing blurs it, and it has no `blurLevels`.
    const ReflectionDesc* reflection = nullptr;
    const UnderwaterDesc* underwater = nullptr; ///< needs `refraction`; null: seen from above alone
    const CausticsDesc* caustics = nullptr;     ///< needs `waves` and `refraction`; null: even light
    const SprayDesc* spray = nullptr;           ///< needs `foam`; null: none
    const BedDesc* bed = nullptr; ///< needs `refraction`; null: bent rays see what the view's picture shows
    bool motion = false; ///< with `waves`, keeps those of the last simulate() for SurfaceOutput::motion
    MeshDesc mesh;       ///< how finely it is drawn
    ShadingDesc shading; ///< how finely it is shaded
};

/// Presets by measure; docs/tradeoffs.md has what each costs and how wrong it is.
enum class Quality : uint32_t { low = 0, medium, high, highest };

/// Sets what `body`'s mesh and shading and `reflection` cost, and drops the bed at low; either may be null.
/// What is modelled stays: parts, the sea, a reflection of the sky or planar.
void setQuality(Quality quality, BodyDesc* body, ReflectionDesc* reflection);

/// What a body costs for views and images of `extent` pixels. Creates nothing on the device, but lays waves
/// out on the CPU, for some milliseconds.
Status estimate(Context* context, const BodyDesc* desc, VkExtent2D extent, Estimate* out,
                SceneSamples samples = {});

struct Body;

Status createBody(Context* context, const BodyDesc* desc, Body** out); ///< on failure `*out` is null
void destroyBody(Body* body); ///< at any time: memory goes back when the GPU is done with it; null is ignored

/// A convex hollow that water stays out of, such as a boat's inside: n.p + d <= 0 for all planes but zeros.
struct ExclusionVolume {
    double planes[8][4] = {}; ///< in the world, of any scale
};
/// From here on, 8 at most: no surface in them, no caustics and, for an eye in one, no fog.
Status setExclusionVolumes(Body* body, const ExclusionVolume* volumes, uint32_t count);

/// The attachments that water is drawn into. Pipelines are made for one of these.
struct TargetDesc {
    VkFormat colorFormat = VK_FORMAT_UNDEFINED;            ///< any that can be drawn to
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;            ///< with stencil or without
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT; ///< of both
    bool reversedDepth = true; ///< nearer is greater: how the host's depth test runs
    bool depthWrite = true;    ///< false leaves depth alone: water goes far to near, by patches of its mesh
    VkRenderPass renderPass = VK_NULL_HANDLE;     ///< null: dynamic rendering
    uint32_t subpass = 0;                         ///< of renderPass
    VkFormat stencilFormat = VK_FORMAT_UNDEFINED; ///< of dynamic rendering with a stencil attachment: its own
    uint32_t viewMask = 0; ///< of a multiview pass: each draw() draws its one view ViewDesc::viewIndex
    Encoding encoding = Encoding::unspecified; ///< of colours, which blend as they are held: docs/contract.md
};

struct Target;
Status createTarget(Context* context, const TargetDesc* desc, Target** out); ///< makes no pipeline yet
void destroyTarget(Target* target); ///< at any time: pipelines go when the GPU is done; null is ignored

/// Sets the bodies' surfaces to `time`, once a frame; a CPU backend works here. Foam takes the sea up to 4
/// more times a second: on the first frame, backwards and after a gap, over three decay times before. A call
/// more than 2 s ahead of one that had to catch up by more takes it at 8 even times.
Status simulate(VkCommandBuffer commands, Body* const* bodies, uint32_t count, double time);

/// As for a Reflector: what to draw for a body whose reflection is `planar`.
Status planarView(Body* body, const ViewDesc* view, PlanarView* out);
/// Likewise for a body with `bed`: the opaque scene under the calm surface, from where its rays seem to come.
/// Caustics may follow, by a ViewDesc of these.
Status bedView(Body* body, const ViewDesc* view, PlanarView* out);
/// As for reflectors; of a multisampled scene also the samples that refraction reads, whether a body has a
/// reflection or not.
Status reflect(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view);
/// As for a Reflector; of a reflection that is the sky alone there is nothing to see.
Status recordOverlay(VkCommandBuffer commands, Body* body, const ViewDesc* view, const OverlayDesc* desc);
ReflectionImages reflectionImages(const Body* body, uint32_t viewIndex); ///< null handles: it has none
const Sea* sea(const Body* body); ///< for height queries, as long as the body lives; null: it has no waves

/// What draw() writes. Everything but `shaded` is for looking at and measuring the inputs.
enum class SurfaceOutput : uint32_t {
    shaded = 0,
    reflection,      ///< radiance that the surface mirrors, before Fresnel
    reflectionClass, ///< red: unknown, blue: sky, green: hit
    height,          ///< height above the calm plane [m], in red
    normal,          ///< unit world normal
    foam,            ///< coverage 0..1, in red
    /// Where the scene is sampled for what is mirrored: x and y [pixel] of the view's region, -1: nowhere;
    /// its distance from the surface [m]; its ReflectionClass. Wants float: halves hold no pixel's place.
    reflectionSource,
    slopes, ///< over the pixel: means along +u and +v, then the variances about them, roughness included
    /// Pixels right and down from where the same water was at the last such draw of this view index; 0 at
    /// first and after ViewDesc::cut. Once a frame; wants BodyDesc::motion where there are waves.
    motion,
};

/// Finds the surfaces in `view` and shades each of their pixels once, for a draw() with the same view,
/// lighting and output later in this frame. In a primary command buffer, after reflect(). Reads the view's
/// scene, the sky cube and the shadow map in compute shaders, and sceneDepth in fragment shaders. The scene's
/// images may be null unless a body has `underwater` or `bed`. Holds images for each output that is used.
Status shade(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view,
             const LightingDesc* lighting, SurfaceOutput output = SurfaceOutput::shaded);

/// Places what shade() made of the bodies in the pass that the host has begun: a colour attachment and a
/// depth attachment with test and write, of the target's formats. Leaves pipeline, descriptor sets, push
/// constants and index buffer bound to its own; the viewport and scissor are set from the view.
///
/// For an eye in a body with `underwater`, or a near plane of parallel lines of sight, it reads the scene's
/// images in fragment shaders: colour must be a copy, depth a copy or a read-only attachment. Pixels whose
/// line of sight begins in the water become sceneColor as seen through it; then come surfaces, then the
/// waterline. So all bodies of a view belong in one call, or that one comes first. The host's transparent
/// things under water come after it, and fade by themselves.
Status draw(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
            const ViewDesc* view, const LightingDesc* lighting, SurfaceOutput output = SurfaceOutput::shaded);

/// Makes the pipelines that draw(), drawCaustics() and castCaustics() of this body and target would make at
/// first need, for every place of the eye. Of `view` and `lighting` only what images they have counts. Null:
/// a scene of one sample that is encoded as the target, a sky cube and no shadow map. On any thread, which
/// hears its messages, beside all calls but those that change or destroy context, target or body, such as
/// setExclusionVolumes(). draw() of what is in the making waits.
Status prepare(Target* target, Body* body, const ViewDesc* view = nullptr,
               const LightingDesc* lighting = nullptr, SurfaceOutput output = SurfaceOutput::shaded);

/// Casts the sun's rays through the waves of bodies with `caustics` on what `view` shows below, for the next
/// drawCaustics() of its index. After the opaque scene: reads view.sceneDepth, of one sample (else
/// `unsupported`), and LightingDesc::shadow in compute shaders.
Status castCaustics(VkCommandBuffer commands, Body* const* bodies, uint32_t count, const ViewDesc* view,
                    const LightingDesc* lighting);

/// Multiplies the colour of what lies below, and its alpha, which should be 1, by the sunlight that waves
/// gather there, 1 in the mean. In a pass over the opaque scene, before its colour is copied: a colour
/// attachment, floating-point or of a target whose `encoding` is srgb, and a depth attachment (neither tested
/// nor written) of the target's formats. Reads view.sceneDepth, which must not be written, in fragment
/// shaders. Leaves bound what draw() does.
Status drawCaustics(VkCommandBuffer commands, Target* target, Body* const* bodies, uint32_t count,
                    const ViewDesc* view, const LightingDesc* lighting);

} // namespace seaglass
