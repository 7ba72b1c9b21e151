// seaglass view: a scene in a window, frame after frame, by the host that renders it to files.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "view/ui/panel.h"
#include "view/window.h"

namespace demos {

struct ViewerDesc {
    /// By which time passes from each frame to the next, whatever the clock says; none: by the clock.
    std::optional<double> stepS;
    /// Of each pixel of the reference, which the right half of a split picture may be. By fixed steps each
    /// frame waits for all of them.
    uint32_t referenceSamples = 64;
#ifdef SEAGLASS_SHADER_RELOAD
    /// The library's shaders, as they were built in: when they change, what is drawn does.
    std::filesystem::path shaders = SEAGLASS_SHADER_FOLDER;
#endif
};

class Viewer {
  public:
    /// The window and the host, which was created with the window's extensions and has the scene loaded, live
    /// longer.
    static std::unique_ptr<Viewer> create(Window& window, Host& host, const ViewState& state,
                                          const ViewerDesc& desc, Error& error);
    ~Viewer();

    /// Hears what happened in the window, draws one frame and shows it. By the clock it draws none while the
    /// display takes none, as of a hidden window.
    bool step(Error& error);
    /// Frames so far.
    uint32_t shown() const;
    const ViewState& state() const;
    /// What the panel shows beside it.
    const PanelInfo& info() const;
    /// As if the panel had changed the state and wished for so much: false with `error` set where that cannot
    /// be done, and the scene then stays what it was.
    bool change(const ViewState& state, const PanelWishes& wishes, Error& error);
    /// What the window shows: RGB bytes, rows from the top, in `width` columns.
    bool read(uint32_t& width, uint32_t& height, std::vector<uint8_t>& rgb, Error& error);

  private:
    class Impl;
    explicit Viewer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace demos
