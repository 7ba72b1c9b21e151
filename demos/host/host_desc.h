// What the host is told and tells: devices, frames and what they cost.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/surroundings.h"

namespace seaglass {
struct WavesBackend;
}

namespace demos {

struct DeviceInfo {
    std::string name;
    std::string driver; ///< driver name and version
    std::string type;   ///< discrete, integrated, virtual, cpu, other
    bool supported = false;
    std::string whyNot;       ///< when not supported: what is missing
    uint32_t longestSide = 0; ///< of a picture, in pixels
};

/// What times are taken by.
enum class PassClock {
    automatic,  ///< timestamps; on CPU devices, which take wrong ones around draws, fence
    timestamps, ///< the device's own, in frames that are recorded whole
    fence,      ///< each stage alone in its submission, until its fence; compute passes by timestamps
    processor,  ///< as fence, of what this process had of the processors; on devices that are no CPU
                ///< timestamps
};
const char* toString(PassClock clock);
/// In words, for people.
const char* describe(PassClock clock);

struct HostDesc {
    std::string device; ///< part of a device's name, case ignored; empty takes the best
    bool validation =
        false; ///< core and synchronisation validation; messages are counted and printed to stderr
    bool bestPractices = false; ///< with `validation`: what Vulkan allows and the layers advise against, too
    uint32_t framesInFlight = 2;
    const seaglass::WavesBackend* wavesBackend =
        nullptr; ///< of the CPU; null: what the program was built with
    PassClock clock = PassClock::automatic;
    /// What the surface of a window needs of the instance; the device then has VK_KHR_swapchain. Empty: none.
    std::vector<std::string> windowExtensions = {};
};

/// What a frame is to deliver. The names are the program's --aov.
enum class Aov {
    color,
    reflection,
    reflectionClass,
    height,
    normal,
    foam,
    depth,
    reflectionSource,
    scene,
    overlayDepth, ///< the first of the library's own overlays, as seaglass::OverlayKind numbers them
    overlayPlane,
    overlayClasses,
    overlayConfidence,
    overlayDistance,
};

/// What the host gets wrong on purpose, to show what that looks like.
enum class Mistake {
    none,
    flippedY,     ///< a projection for clip space with y up
    forwardDepth, ///< a projection whose depth runs the other way than what was drawn
};

/// Linear float RGBA pixels, top row first. Colour is before tone mapping; `depth` is metres along the view
/// axis, infinite where there is only sky, in the first channel. `scene` is the colour before any water or
/// floor. `reflectionSource` holds what seaglass::SurfaceOutput says of it, and four zeros where nothing that
/// mirrors is seen.
struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<float> rgba;
};

struct FrameDesc {
    uint32_t width = 1280, height = 720;
    CameraDesc camera;
    double timeS = 0;
    Aov aov = Aov::color;
    uint32_t surface = 0;            ///< of those that the scene was given; the first is its own
    Mistake mistake = Mistake::none; ///< in what the library is told of the camera
    /// The same surface was drawn just before, from nearby: reflections may reuse what that frame knew.
    bool follows = false;
    std::array<double, 2> jitterPx = {0, 0}; ///< moves the picture right and down, but for the sky
    /// Of colour alone, and not for measuring: light strays in the lens.
    bool bloom = false;
    /// Likewise: averaged with the frames before. Wants `follows`, and jitterOf() another index in each.
    bool temporal = false;
    /// Clouds are as ragged as SkyDesc::detail says; what is measured has the file's own.
    bool skyDetail = false;
};

struct PassTime {
    std::string name;
    double ms = 0;       ///< median
    double spreadMs = 0; ///< interquartile range
};

/// What costs are given as multiples of.
struct YardstickTimes {
    /// A compute copy of RGBA16F colour and R32F depth of the frame's size.
    PassTime floor;
    /// A triangle over the whole picture, whose pixels are read from a copy of it: what drawing can cost at
    /// least.
    PassTime fullScreen;
};

struct FrameTimes {
    PassClock clock = PassClock::fence;
    double frameMs = 0; ///< median of a whole frame, submit to fence
    std::optional<double>
        gpuFrameMs;           ///< from its first timestamp to its last, by PassClock::timestamps alone
    double cpuSimulateMs = 0; ///< median CPU time inside seaglass::simulate
    uint32_t runs = 0;
    YardstickTimes yardsticks;
    std::vector<PassTime> passes; ///< stages in order, each before its passes
};

/// What one surface takes of frames in which surfaces take turns.
struct SurfaceTimes {
    /// What the reflection's passes take together, and what the host draws for them alone; 0 where there are
    /// none.
    PassTime reflection;
    PassTime ofFloor; ///< the same over the floor of the same round: no milliseconds, but a ratio
    double cpuSimulateMs = 0;
    std::optional<double> gpuFrameMs; ///< as FrameTimes has it
    /// What the host itself holds on the device for the surface to mirror the scene: the copies of its colour
    /// and depth where those are read, and what draws it a second time. The images that a planar reflection
    /// is drawn into are the library's.
    uint64_t hostBytes = 0;
    std::vector<PassTime> passes; ///< of the whole frame, the scene's own among them

    /// Those that a frame has for the surface: its waves, its reflection, its drawing.
    std::vector<PassTime> surfacePasses() const;
    /// Of all of them, and of what the processor simulates.
    double surfaceMs() const;
};

struct ComparedTimes {
    YardstickTimes yardsticks;          ///< between the same frames; by timestamps in the same submissions
    std::vector<SurfaceTimes> surfaces; ///< none when it was stopped
};

} // namespace demos
