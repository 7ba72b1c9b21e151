// The ray-traced reference of what is seen, on a thread of its own: a coarse picture first, then the whole
// one, sample by sample.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "host/host.h"

namespace demos {

/// From where and when.
struct TracedView {
    uint32_t width = 0, height = 0;
    CameraDesc camera;
    double timeS = 0;

    bool operator==(const TracedView&) const = default;
};

struct TracedPicture {
    Picture picture;      ///< linear, of the view's size
    uint32_t samples = 0; ///< of each pixel; 0: the coarse one
};

class Tracer {
  public:
    /// So many samples of each pixel are all it takes; 1 is its centre.
    explicit Tracer(uint32_t samples);
    /// Waits for the row that is being traced, or for the scene that is being read.
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    /// Another scene, or another surface in the same light and among the same meshes.
    void setScene(const Scene& scene, bool surfaceAlone);
    /// What to trace from now on; none: nothing. What was traced of anything else is thrown away.
    void look(const std::optional<TracedView>& view);

    /// What has come since it was last asked; none where nothing has. False with `error` set where the scene
    /// or the view cannot be traced: once for each.
    bool take(std::optional<TracedPicture>& out, Error& error);
    /// Waits until all samples of the view are there, or until it cannot be traced.
    void wait();

  private:
    /// What the thread is about.
    struct Job {
        std::shared_ptr<const Scene> scene;
        bool surfaceAlone = true; ///< since the scene that it last read
        TracedView view;
        uint64_t number = 0;
    };
    struct Worker;

    void begin(const std::unique_lock<std::mutex>& lock);
    bool outdated(const Job& job) const { return number_ != job.number; }
    bool deliver(const Job& job, Picture picture, uint32_t samples);
    void fail(const Job& job, const Error& error);
    void run();

    const uint32_t samples_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::shared_ptr<const Scene> scene_;
    bool surfaceAlone_ = true;
    std::optional<TracedView> view_;
    std::atomic<uint64_t> number_ = 0; ///< of the scene and view that are wanted
    uint64_t ended_ = 0;               ///< of those that all is known of
    bool quits_ = false;
    std::optional<TracedPicture> come_;
    std::string problem_;
    std::thread thread_;
};

} // namespace demos
