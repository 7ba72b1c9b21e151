// The sample host: a small headless Vulkan 1.3 renderer of the kind a game has, which takes its water from
// Seaglass through the public headers alone.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/host_desc.h"
#include "scene/scene.h"

namespace demos {

/// Every Vulkan device here, best first (discrete, integrated, virtual, CPU). Empty with `error` set when
/// there is no loader or no driver.
std::vector<DeviceInfo> listDevices(Error& error);

/// Rounds done, and of how many; false stops.
using RoundFunction = std::function<bool(uint32_t, uint32_t)>;

class Host {
  public:
    /// Makes instance and device. Null with `error` set on failure.
    static std::unique_ptr<Host> create(const HostDesc& desc, Error& error);
    ~Host();

    DeviceInfo device() const;
    /// What times are taken by: what HostDesc::clock comes to on the device.
    PassClock clock() const;
    /// Whether the device was lost or hung. Nothing of it is destroyed or waited for then.
    bool lost() const;
    /// Loads the sky and the meshes of a scene and creates its surface; replaces the scene before it, or
    /// leaves it as it was on an error.
    bool load(const Scene& scene, Error& error);
    /// What the scene's meshes hold and their pictures do not show: Mesh::leftOut, behind the file's name.
    const std::vector<std::string>& leftOut() const;
    /// Another surface for the scene that is loaded: FrameDesc::surface counts them in this order.
    bool addSurface(const SurfaceDesc& surface, Error& error);
    /// Another surface in the place of one, which stays on an error.
    bool replaceSurface(uint32_t index, const SurfaceDesc& surface, Error& error);
    /// Drops the surfaces beyond so many.
    void keepSurfaces(uint32_t count);
    /// Bytes on the device that a surface's reflection takes for one view of this size, as the library
    /// estimates them.
    std::optional<uint64_t> reflectionBytes(const SurfaceDesc& surface, uint32_t width, uint32_t height,
                                            Error& error);
    /// Draws one frame and waits for it.
    std::optional<Picture> render(const FrameDesc& frame, Error& error);
    /// What a frame takes by clock(), whole, the median of `runs`, where one like it has been drawn already.
    std::optional<double> frameMs(const FrameDesc& frame, uint32_t runs, Error& error);
    /// Draws the frame `runs` times after a warm-up and gives medians by pass.
    std::optional<FrameTimes> measure(const FrameDesc& frame, uint32_t runs, Error& error);
    /// Draws the frame with all of the scene's surfaces in turn, `rounds` times after a warm-up, each over
    /// the same picture of the opaque scene, and gives medians. FrameDesc::surface does not matter.
    std::optional<ComparedTimes> measureSurfaces(const FrameDesc& frame, uint32_t rounds,
                                                 const RoundFunction& goOn, Error& error);
    /// seaglass::resolvedShare() of the scene's own surface; 1 where nothing waves.
    double resolvedShare() const;
    /// Validation messages seen so far.
    uint32_t validationMessages() const;

    struct Impl;
    /// For who draws frames without bringing them to the CPU, with host/host_impl.h.
    Impl& inside() { return *impl_; }

  private:
    explicit Host(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Linear HDR to display-referred sRGB bytes (RGB), the same curve as the golden pictures.
std::vector<uint8_t> toneMap(const Picture& picture, double exposureEv);

} // namespace demos
