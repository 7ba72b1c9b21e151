#include "view/tracer.h"

#include <algorithm>
#include <utility>

#include "reference/progressive.h"
#include "reference/reference.h"

namespace demos {

namespace {

constexpr uint32_t coarse = 4; ///< pixels to one of the first picture, each way

/// One is left to whoever draws.
uint32_t threadsToTake() {
    return std::max(2u, std::thread::hardware_concurrency()) - 1;
}

Picture enlarged(const Picture& small, uint32_t width, uint32_t height) {
    Picture out{width, height, std::vector<float>(size_t(width) * height * 4)};
    for (size_t i = 0; i < out.rgba.size(); i += 4) {
        const size_t x = i / 4 % width, y = i / 4 / width;
        const size_t from = y * small.height / height * small.width + x * small.width / width;
        std::copy_n(&small.rgba[4 * from], 4, &out.rgba[i]);
    }
    return out;
}

reference::FrameDesc frameOf(const TracedView& view, uint32_t shrink, uint32_t samples) {
    reference::FrameDesc desc;
    desc.width = std::max(1u, view.width / shrink);
    desc.height = std::max(1u, view.height / shrink);
    desc.camera = view.camera;
    desc.timeS = view.timeS;
    desc.samples = samples;
    desc.threads = threadsToTake();
    return desc;
}

} // namespace

/// The thread's own.
struct Tracer::Worker {
    reference::World world;
    std::shared_ptr<const Scene> read;

    bool readScene(const Job& job, Error& error) {
        if (read == job.scene) return true;
        const bool all = !read || !job.surfaceAlone;
        read = nullptr;
        if (all) {
            world = {};
            if (!reference::loadWorld(*job.scene, world, error)) return false;
        } else if (!reference::setFloor(job.scene->floor, world, error) ||
                   !reference::setWater(job.scene->water, world, error)) {
            return false;
        }
        read = job.scene;
        return true;
    }

    /// False where it was stopped, or with `error` set.
    bool trace(Tracer& tracer, const Job& job, Error& error) const {
        const auto goOn = [&](uint32_t, uint32_t) { return !tracer.outdated(job); };
        {
            reference::Frame frame;
            if (!reference::prepareFrame(world, frameOf(job.view, coarse, 1), frame, error)) return false;
            const Picture small = reference::renderReference(frame, false, goOn).color;
            if (!tracer.deliver(job, enlarged(small, job.view.width, job.view.height), 0)) return false;
        }
        reference::Frame frame;
        if (!reference::prepareFrame(world, frameOf(job.view, 1, tracer.samples_), frame, error))
            return false;
        reference::Progressive picture(frame);
        while (!picture.done())
            if (!picture.add(goOn) || !tracer.deliver(job, picture.mean(), picture.samples())) return false;
        return true;
    }
};

Tracer::Tracer(uint32_t samples) : samples_(samples), thread_([this] { run(); }) {}

Tracer::~Tracer() {
    {
        const std::scoped_lock lock(mutex_);
        quits_ = true;
        ++number_;
    }
    changed_.notify_all();
    thread_.join();
}

void Tracer::setScene(const Scene& scene, bool surfaceAlone) {
    const std::unique_lock lock(mutex_);
    scene_ = std::make_shared<const Scene>(scene);
    surfaceAlone_ = surfaceAlone_ && surfaceAlone;
    begin(lock);
}

void Tracer::look(const std::optional<TracedView>& view) {
    const std::unique_lock lock(mutex_);
    if (view == view_) return;
    view_ = view;
    begin(lock);
}

void Tracer::begin(const std::unique_lock<std::mutex>&) {
    ++number_;
    come_.reset();
    problem_.clear();
    changed_.notify_all();
}

bool Tracer::take(std::optional<TracedPicture>& out, Error& error) {
    const std::unique_lock lock(mutex_);
    out = std::exchange(come_, std::nullopt);
    if (problem_.empty()) return true;
    error.text = std::exchange(problem_, {});
    return false;
}

void Tracer::wait() {
    std::unique_lock lock(mutex_);
    if (view_) changed_.wait(lock, [&] { return ended_ == number_; });
}

bool Tracer::deliver(const Job& job, Picture picture, uint32_t samples) {
    const std::unique_lock lock(mutex_);
    if (outdated(job)) return false;
    come_ = TracedPicture{std::move(picture), samples};
    return true;
}

void Tracer::fail(const Job& job, const Error& error) {
    const std::unique_lock lock(mutex_);
    if (!outdated(job)) problem_ = error.text;
}

void Tracer::run() {
    Worker worker;
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return quits_ || (scene_ && view_ && ended_ != number_); });
        if (quits_) return;
        const Job job{scene_, surfaceAlone_, *view_, number_};
        surfaceAlone_ = true;
        lock.unlock();
        Error error;
        if (!(worker.readScene(job, error) && worker.trace(*this, job, error)) && !error.text.empty())
            fail(job, error);
        lock.lock();
        ended_ = job.number;
        changed_.notify_all();
    }
}

} // namespace demos
