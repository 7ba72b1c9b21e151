#include "host/host.h"

#include "host/host_impl.h"
#include "host/seaglass_view.h"
#include "host/vulkan/frame_recorder.h"

namespace demos {

namespace {

/// Where an output is drawn.
const Image& pictureOf(const FrameTargets& targets, Aov aov) {
    if (aov == Aov::depth) return targets.depth;
    if (needsExact(aov)) return targets.exact;
    return isOverlay(aov) ? targets.overlay : targets.color;
}

} // namespace

std::unique_ptr<Host> Host::create(const HostDesc& desc, Error& error) {
    if (desc.framesInFlight < 1 || desc.framesInFlight > 4) {
        error.text = "framesInFlight is " + std::to_string(desc.framesInFlight) + ", expected 1 to 4";
        return nullptr;
    }
    auto impl = std::make_unique<Impl>();
    impl->desc = desc;
    impl->recorder = std::make_unique<FrameRecorder>();
    impl->device = Device::create(desc, error);
    if (!impl->device || !impl->recorder->create(*impl->device, desc, error)) return nullptr;
    return std::unique_ptr<Host>(new Host(std::move(impl)));
}

Host::Host(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Host::~Host() {
    if (lost()) static_cast<void>(impl_.release());
}

DeviceInfo Host::device() const {
    return impl_->device->info();
}

PassClock Host::clock() const {
    return impl_->device->clock();
}

bool Host::lost() const {
    return impl_->device->lost();
}

double Host::resolvedShare() const {
    if (!impl_->scene || impl_->scene->surfaces.empty()) return 1;
    const auto* const water = std::get_if<WaterBody>(&impl_->scene->surfaces.front().body);
    const seaglass::Sea* const sea = water && *water ? seaglass::sea(water->get()) : nullptr;
    return sea ? seaglass::resolvedShare(*sea) : 1;
}

uint32_t Host::validationMessages() const {
    return impl_->device->validationMessages();
}

bool Host::load(const Scene& scene, Error& error) {
    auto loaded = std::make_unique<LoadedScene>();
    if (!impl_->recorder->load(scene, *loaded, error)) return false;
    impl_->scene = std::move(loaded);
    return true;
}

const std::vector<std::string>& Host::leftOut() const {
    static const std::vector<std::string> nothing;
    return impl_->scene ? impl_->scene->meshes.leftOut : nothing;
}

bool Host::addSurface(const SurfaceDesc& surface, Error& error) {
    return impl_->ready(error) && impl_->recorder->addSurface(surface, *impl_->scene, error);
}

bool Host::replaceSurface(uint32_t index, const SurfaceDesc& surface, Error& error) {
    if (!impl_->ready(error) || !impl_->recorder->hasSurface(index, *impl_->scene, error) ||
        !addSurface(surface, error))
        return false;
    std::vector<Surface>& surfaces = impl_->scene->surfaces;
    std::swap(surfaces[index], surfaces.back());
    surfaces.pop_back();
    return true;
}

void Host::keepSurfaces(uint32_t count) {
    if (!impl_->scene) return;
    std::vector<Surface>& surfaces = impl_->scene->surfaces;
    while (surfaces.size() > count) surfaces.pop_back();
}

std::optional<uint64_t> Host::reflectionBytes(const SurfaceDesc& surface, uint32_t width, uint32_t height,
                                              Error& error) {
    uint64_t bytes = 0;
    if (!impl_->recorder->estimateReflection(surface, {width, height}, bytes, error)) return std::nullopt;
    return bytes;
}

std::optional<Picture> Host::render(const FrameDesc& frame, Error& error) {
    Impl& impl = *impl_;
    const FrameTargets& targets = impl.recorder->targets();
    const bool drawn = impl.draw(
        frame, [&](VkCommandBuffer commands, const Image& picture) { targets.copyBack(commands, picture); },
        error);
    if (!drawn) return std::nullopt;
    if (frame.aov == Aov::depth) return readDepth(targets, impl.recorder->camera());
    return needsExact(frame.aov) ? readExact(targets) : readColor(targets);
}

bool Host::Impl::ready(Error& error) const {
    if (!scene) error.text = "no scene is loaded";
    return scene != nullptr;
}

bool Host::Impl::draw(const FrameDesc& frame, const AfterFrame& then, Error& error) {
    if (!ready(error) || !recorder->begin(*scene, frame, error)) return false;
    return device->run(
        [&](VkCommandBuffer commands, Error& problem) {
            if (!recorder->recordFrame(commands, Heard::always, problem)) return false;
            then(commands, pictureOf(recorder->targets(), frame.aov));
            return true;
        },
        error);
}

} // namespace demos
