// seaglass view: a scene in a window, frame after frame, by the host that renders it to files.
#pragma once

#include <memory>
#include <optional>

#include "view/panel.h"
#include "view/window.h"

namespace demos {

struct ViewerDesc {
    /// By which time passes from each frame to the next, whatever the clock says; none: by the clock.
    std::optional<double> stepS;
};

class Viewer {
  public:
    /// The window and the host, which was created with the window's extensions and has the scene loaded, live
    /// longer.
    static std::unique_ptr<Viewer> create(Window& window, Host& host, const ViewState& state,
                                          const ViewerDesc& desc, Error& error);
    ~Viewer();

    /// Hears what happened in the window, draws one frame and shows it.
    bool step(Error& error);
    const ViewState& state() const;
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
