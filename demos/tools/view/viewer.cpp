#include "view/viewer.h"

#include <cmath>

#include "host/files/image_file.h"
#include "host/host_impl.h"
#include "host/lens/meter.h"
#include "host/lens/temporal.h"
#include "scene/save.h"
#include "view/clock.h"
#include "view/display.h"
#include "view/saved_view.h"
#include "view/swapchain.h"
#include "view/tracer.h"
#include "view/ui/panel.h"
#include "view/ui/ui.h"
#ifdef SEAGLASS_SHADER_RELOAD
#include "view/shader_reload.h"
#endif

namespace demos {

namespace {

constexpr uint32_t measuredRuns = 5;
constexpr double keptOfFrameMs = 0.9; ///< from one frame to the next
constexpr uint32_t framesATitle = 15;
/// After which a window that is given no image is heard again.
constexpr uint64_t momentNs = 100'000'000;

} // namespace

class Viewer::Impl {
  public:
    Impl(Window& window, Host& host, const ViewState& state, const ViewerDesc& desc)
        : window_(window), host_(host), state_(state), loaded_(state.scene), clock_(desc.stepS),
#ifdef SEAGLASS_SHADER_RELOAD
          shaders_(desc.shaders),
#endif
          referenceSamples_(desc.referenceSamples) {
        info_.device = host.device().name;
    }

    bool create(Error& error) {
        return swapchain_.create(device(), window_.handle(), error) && display_.create(device(), error) &&
               ui_.create(device(), window_.handle(), Display::format, error) && fitSplit(false, error);
    }

    bool step(Error& error) {
        window_.listen();
        const bool minimised = window_.width() == 0 || window_.height() == 0;
        bool acquired = false;
        if (!minimised && (!fit(error) || !acquire(acquired, error))) return false;
        const double seconds = clock_.passed();
        hear(seconds);
        return !acquired || drawNext(seconds, error);
    }

    uint32_t shown() const {
        return shown_;
    }

    const ViewState& state() const {
        return state_;
    }
    const PanelInfo& info() const {
        return info_;
    }

    bool change(const ViewState& state, const PanelWishes& wishes, Error& error) {
        state_ = state;
        savesPicture_ = wishes.savePicture;
        const bool reloads = wishes.light || wishes.surface || wishes.split;
        return (!reloads || reload(wishes, error)) && (!wishes.measure || measure(error)) &&
               (!wishes.meter || meter(error)) && (!wishes.saveScene || saveTheScene(error));
    }

    Display& display() {
        return display_;
    }

  private:
    Device& device() {
        return *host_.inside().device;
    }

    /// By fixed steps no frame is left out.
    bool acquire(bool& acquired, Error& error) {
        using Acquired = Swapchain::Acquired;
        Acquired got = Acquired::none;
        const uint64_t waitNs = clock_.fixed() ? device().patienceNs() : momentNs;
        if (!swapchain_.acquire(waitNs, got, error)) return false;
        acquired = got == Acquired::image;
        if (got == Acquired::stale) fitted_ = false;
        if (got != Acquired::none || !clock_.fixed()) return true;
        error.text =
            "the display took no frame of the window for " + std::to_string(waitNs / 1'000'000'000) + " s";
        return false;
    }

    bool drawNext(double seconds, Error& error) {
#ifdef SEAGLASS_SHADER_RELOAD
        reloadShaders();
#endif
        bool stale = false;
        if (!layOut(seconds, error) || !draw(error) || !finish(error) || !swapchain_.present(stale, error))
            return false;
        fitted_ = !stale;
        ++shown_;
        return true;
    }

    void hear(double seconds) {
        const bool typing = ui_.keysTaken();
        heard_ = window_.takeWishes();
        if (heard_.pause && !typing) state_.paused = !state_.paused;
        if (heard_.hidePanel && !typing) state_.panel = !state_.panel;
        advance(state_, window_.flyInput(typing, ui_.mouseTaken()), seconds);
    }

    /// Images as large as the window.
    bool fit(Error& error) {
        const VkExtent2D now = {window_.width(), window_.height()}, had = swapchain_.extent();
        if (fitted_ && now.width == had.width && now.height == had.height) return true;
        fitted_ = true;
        follows_ = false;
        return swapchain_.resize(now, error) && display_.resize(swapchain_.extent(), error);
    }

    bool layOut(double seconds, Error& error) {
        info_.width = swapchain_.extent().width;
        info_.height = swapchain_.extent().height;
        if (!clock_.fixed() && seconds > 0) sayFrameTime(1000 * seconds);
        ui_.begin(swapchain_.extent(), seconds);
        PanelWishes wishes;
        if (state_.panel) wishes = layOutPanel(state_, info_);
        if (!ui_.end(error)) return false;
        wishes.savePicture |= heard_.savePicture;
        wishes.saveScene |= heard_.saveScene;
        // What cannot be done is said in the panel.
        Error problem;
        if (!change(ViewState(state_), wishes, problem)) info_.message = problem.text;
        return true;
    }

    /// In the window's title, where it stays when the panel is hidden and is in no picture.
    void sayFrameTime(double ms) {
        // Single frames could not be read.
        info_.frameMs = std::lerp(ms, info_.frameMs.value_or(ms), keptOfFrameMs);
        if (shown_ % framesATitle == 1) window_.say(frameText(info_));
    }

    bool reload(const PanelWishes& wishes, Error& problem) {
        follows_ = false;
        bool loaded = true;
        if (wishes.light)
            loaded = host_.load(state_.scene, problem);
        else if (wishes.surface)
            loaded = host_.replaceSurface(0, *surfaceOf(state_.scene), problem);
        if (loaded) {
            loaded_ = state_.scene;
            info_.message.clear();
        } else {
            state_.scene = loaded_;
        }
        return loaded && fitSplit(!wishes.light, problem);
    }

    /// The surface of the right half, or what traces it, if there is one.
    bool fitSplit(bool surfaceAlone, Error& problem) {
        host_.keepSurfaces(1);
        forgetReference();
        if (!state_.split || !state_.split->reference) tracer_.reset();
        if (!state_.split) return true;
        if (state_.split->reference) {
            if (!tracer_) tracer_.emplace(referenceSamples_);
            tracer_->setScene(state_.scene, surfaceAlone);
            return true;
        }
        const std::optional<SurfaceDesc> other = otherSurface(state_.scene, *state_.split);
        if (other && host_.addSurface(*other, problem)) return true;
        state_.split.reset();
        return false;
    }

#ifdef SEAGLASS_SHADER_RELOAD
    void reloadShaders() {
        Error problem{shaders_.takeProblem()};
        if (shaders_.changed() && shaders_.renew(host_, loaded_, frame(0), problem)) {
            follows_ = false;
            info_.message = "shaders reloaded";
            if (state_.split && !tracer_) fitSplit(false, problem);
        }
        if (!problem.text.empty()) info_.message = problem.text;
    }
#endif

    bool measure(Error& problem) {
        FrameDesc bare = frame(0);
        bare.bloom = bare.temporal = bare.skyDetail = false;
        bare.jitterPx = {};
        info_.costs = host_.measure(bare, measuredRuns, problem);
        return info_.costs.has_value();
    }

    /// What is seen, in colour.
    bool meter(Error& problem) {
        FrameDesc seen = frame(0);
        seen.aov = Aov::color;
        seen.follows = seen.temporal = false;
        const std::optional<Picture> picture = host_.render(seen, problem);
        if (picture) state_.scene.exposureEv = meteredEv(*picture);
        follows_ = false;
        return picture.has_value();
    }

    std::filesystem::path nameFor(const char* extension) const {
        return freeName(std::filesystem::current_path(), state_.scene.file.stem().string(), extension);
    }

    bool saveTheScene(Error& problem) {
        const std::filesystem::path file = nameFor(".toml");
        if (!saveScene(savedScene(state_), file, problem)) return false;
        info_.message = "saved " + file.filename().string();
        return true;
    }

    void savePicture() {
        const std::filesystem::path file = nameFor(".png");
        std::vector<uint8_t> rgb;
        Error problem;
        const VkExtent2D extent = display_.image().extent;
        const bool saved =
            display_.read(rgb, problem) && writePng(file, extent.width, extent.height, rgb, problem);
        info_.message = saved ? "saved " + file.filename().string() : problem.text;
    }

    FrameDesc frame(uint32_t surface) const {
        const VkExtent2D extent = swapchain_.extent();
        FrameDesc frame{extent.width, extent.height, state_.camera, state_.timeS, state_.aov, surface};
        frame.follows = follows_;
        // Halves are compared.
        frame.bloom = frame.temporal = frame.skyDetail =
            state_.lens && state_.aov == Aov::color && !state_.split;
        if (frame.temporal) frame.jitterPx = jitterOf(shown_);
        return frame;
    }

    void forgetReference() {
        traced_ = {};
        tracedSamples_.reset();
        info_.reference.clear();
    }

    /// Brings here what the ray tracer has of what is seen in this frame.
    bool followReference(Error& error) {
        if (!tracer_) return true;
        const VkExtent2D extent = swapchain_.extent();
        const TracedView now{extent.width, extent.height, state_.camera, state_.timeS};
        const bool moved = now != traces_;
        if (moved) forgetReference();
        traces_ = now;
        // What moves on is not worth beginning with.
        const bool wanted = state_.aov == Aov::color && (!moved || clock_.fixed());
        tracer_->look(wanted ? std::optional(now) : std::nullopt);
        if (clock_.fixed()) tracer_->wait();
        std::optional<TracedPicture> come;
        Error problem;
        if (!tracer_->take(come, problem)) {
            info_.message = problem.text;
            if (clock_.fixed()) error = problem;
        }
        if (come && !bring(*come, error)) return false;
        info_.reference = saidOfReference(wanted);
        return error.text.empty();
    }

    bool bring(const TracedPicture& come, Error& error) {
        ImageDesc desc;
        desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
        desc.extent = {come.picture.width, come.picture.height};
        const std::span<const std::byte> texels = std::as_bytes(std::span(come.picture.rgba));
        if (!createSampledImage(device(), desc, {&texels, 1}, traced_, error)) return false;
        tracedSamples_ = come.samples;
        return true;
    }

    std::string saidOfReference(bool wanted) const {
        if (state_.aov != Aov::color) return "reference: of color alone";
        if (!wanted) return "reference: waits until nothing moves (space pauses)";
        if (!tracedSamples_) return "reference: begun";
        if (*tracedSamples_ == 0) return "reference: coarse";
        return "reference: " + std::to_string(*tracedSamples_) + " of " + std::to_string(referenceSamples_) +
               " samples";
    }

    bool draw(Error& error) {
        if (!followReference(error)) return false;
        const VkExtent2D extent = swapchain_.extent();
        const uint32_t left = state_.split ? leftColumns(*state_.split, extent.width) : extent.width;
        const VkRect2D rest = {{static_cast<int32_t>(left), 0}, {extent.width - left, extent.height}};
        const bool traced = tracedSamples_ && state_.aov == Aov::color;
        // Until there is a reference the scene goes on as it is on the left.
        const bool drawn = drawPart(0, {{0, 0}, {left, extent.height}}, error) &&
                           (traced ? drawReference(rest, error) : drawPart(tracer_ ? 0 : 1, rest, error));
        follows_ = drawn;
        return drawn;
    }

    /// The scene with one of its surfaces, in a part of the picture that may be empty.
    bool drawPart(uint32_t surface, const VkRect2D& part, Error& error) {
        if (part.extent.width == 0) return true;
        const Look look = lookOf(state_.aov, state_.scene.exposureEv, state_.whiteHeightM);
        return host_.inside().draw(
            frame(surface),
            [&](VkCommandBuffer commands, const Image& picture) {
                display_.show(commands, picture, look, part);
            },
            error);
    }

    bool drawReference(const VkRect2D& part, Error& error) {
        const Look look = lookOf(Aov::color, state_.scene.exposureEv, 0);
        return device().run(
            [&](VkCommandBuffer commands, Error&) {
                display_.showTexture(commands, traced_, look, part);
                return true;
            },
            error);
    }

    /// The panel, which a saved picture is without, and the way to the window.
    bool finish(Error& error) {
        const bool finished = device().run(
            [&](VkCommandBuffer commands, Error&) {
                if (!savesPicture_) ui_.record(commands, display_.image());
                display_.finish(commands);
                swapchain_.record(commands, display_.image());
                return true;
            },
            error);
        if (finished && savesPicture_) savePicture();
        return finished;
    }

    Window& window_;
    Host& host_;
    ViewState state_;
    Scene loaded_; ///< what the host draws
    Clock clock_;
    WindowWishes heard_; ///< since the last frame
    PanelInfo info_;
    Swapchain swapchain_;
    Display display_;
    Ui ui_;
#ifdef SEAGLASS_SHADER_RELOAD
    ShaderReload shaders_;
#endif
    const uint32_t referenceSamples_;
    std::optional<Tracer> tracer_; ///< while the right half is the reference
    TracedView traces_;            ///< what was seen in the last frame
    Image traced_;
    std::optional<uint32_t> tracedSamples_; ///< of each pixel of `traced_`, if there is one
    uint32_t shown_ = 0;                    ///< frames
    bool fitted_ = false;
    bool follows_ = false; ///< a frame of this size and scene before the next
    bool savesPicture_ = false;
};

std::unique_ptr<Viewer> Viewer::create(Window& window, Host& host, const ViewState& state,
                                       const ViewerDesc& desc, Error& error) {
    auto impl = std::make_unique<Impl>(window, host, state, desc);
    if (!impl->create(error)) return nullptr;
    return std::unique_ptr<Viewer>(new Viewer(std::move(impl)));
}

Viewer::Viewer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Viewer::~Viewer() = default;

bool Viewer::step(Error& error) {
    return impl_->step(error);
}

uint32_t Viewer::shown() const {
    return impl_->shown();
}

bool Viewer::change(const ViewState& state, const PanelWishes& wishes, Error& error) {
    return impl_->change(state, wishes, error);
}

const ViewState& Viewer::state() const {
    return impl_->state();
}

const PanelInfo& Viewer::info() const {
    return impl_->info();
}

bool Viewer::read(uint32_t& width, uint32_t& height, std::vector<uint8_t>& rgb, Error& error) {
    const VkExtent2D extent = impl_->display().image().extent;
    width = extent.width;
    height = extent.height;
    return impl_->display().read(rgb, error);
}

} // namespace demos
