#include "scene/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demos {

namespace {

constexpr double sameM = 1e-6, sameDeg = 1e-6;

/// Of a turn, -180 to 180 degrees.
double shortWay(double deg) {
    return std::remainder(deg, 360);
}

/// Places in a row, then an angle [degrees].
template<size_t count>
struct Pose {
    double timeS = 0;
    std::array<double, count> values = {};
};

template<size_t count>
using Track = std::vector<Pose<count>>;

Pose<7> poseOf(const auto& camera, double timeS) {
    const Vec3 &eye = camera.positionM, &target = camera.targetM;
    return {timeS, {eye[0], eye[1], eye[2], target[0], target[1], target[2], camera.rollDeg}};
}

Track<7> trackOf(const CameraDesc& camera) {
    Track<7> track = {poseOf(camera, 0)};
    for (const CameraKeyframe& keyframe : camera.keyframes) track.push_back(poseOf(keyframe, keyframe.timeS));
    return track;
}

Track<4> trackOf(const MeshDesc& mesh) {
    const auto pose = [](const auto& of, double timeS) -> Pose<4> {
        return {timeS, {of.positionM[0], of.positionM[1], of.positionM[2], of.yawDeg}};
    };
    Track<4> track = {pose(mesh, 0)};
    for (const MeshKeyframe& keyframe : mesh.keyframes) track.push_back(pose(keyframe, keyframe.timeS));
    return track;
}

template<size_t count>
bool isClosed(const Track<count>& track) {
    const auto &first = track.front().values, &last = track.back().values;
    for (size_t i = 0; i + 1 < count; ++i)
        if (std::abs(last[i] - first[i]) > sameM) return false;
    return std::abs(shortWay(last.back() - first.back())) <= sameDeg;
}

/// Turns angles on, so that none is over half a turn from that before.
template<size_t count>
void unwind(Track<count>& track) {
    for (size_t i = 1; i < track.size(); ++i) {
        const double before = track[i - 1].values.back();
        double& angle = track[i].values.back();
        angle = before + shortWay(angle - before);
    }
}

/// Of the parabola through a pose and its neighbours, at it: Catmull-Rom's where times are even.
double speedBetween(double before, double after, double slopeBefore, double slopeAfter) {
    return (after * slopeBefore + before * slopeAfter) / (before + after);
}

template<size_t count>
struct Spline {
    Track<count> track;
    bool loops;

    double slope(size_t from, size_t value) const {
        return (track[from + 1].values[value] - track[from].values[value]) / seconds(from);
    }
    double seconds(size_t from) const { return track[from + 1].timeS - track[from].timeS; }

    /// At rest at both ends, where nothing moves before and after.
    double speed(size_t at, size_t value) const {
        const size_t last = track.size() - 1;
        const bool end = at == 0 || at == last;
        if (end && !loops) return 0;
        const size_t before = end ? last - 1 : at - 1, after = end ? 0 : at;
        return speedBetween(seconds(before), seconds(after), slope(before, value), slope(after, value));
    }

    std::array<double, count> at(double timeS) const {
        const double length = track.back().timeS;
        const double time =
            loops ? timeS - length * std::floor(timeS / length) : std::clamp(timeS, 0.0, length);
        size_t from = 0;
        while (from + 2 < track.size() && track[from + 1].timeS <= time) ++from;
        const double s = seconds(from), t = (time - track[from].timeS) / s;
        const double rest = 1 - t, turned = t * t * (3 - 2 * t);
        std::array<double, count> values = track[from].values;
        for (size_t i = 0; i < count; ++i)
            values[i] += turned * (track[from + 1].values[i] - track[from].values[i]) +
                         s * t * rest * (rest * speed(from, i) - t * speed(from + 1, i));
        return values;
    }
};

template<size_t count>
std::array<double, count> poseAt(Track<count> track, bool loops, double timeS) {
    unwind(track);
    return Spline<count>{std::move(track), loops}.at(timeS);
}

} // namespace

CameraDesc cameraAt(const CameraDesc& camera, double timeS) {
    CameraDesc now = camera;
    if (camera.keyframes.empty()) return now;
    const std::array<double, 7> pose = poseAt(trackOf(camera), camera.loops, timeS);
    now.positionM = {pose[0], pose[1], pose[2]};
    now.targetM = {pose[3], pose[4], pose[5]};
    now.rollDeg = pose[6];
    now.loops = false;
    now.keyframes.clear();
    return now;
}

MeshDesc meshAt(const MeshDesc& mesh, double timeS) {
    MeshDesc now = mesh;
    if (mesh.keyframes.empty()) return now;
    const std::array<double, 4> pose = poseAt(trackOf(mesh), mesh.loops, timeS);
    now.positionM = {pose[0], pose[1], pose[2]};
    now.yawDeg = pose[3];
    now.loops = false;
    now.keyframes.clear();
    return now;
}

bool endsWhereItBegins(const CameraDesc& camera) {
    return isClosed(trackOf(camera));
}

bool endsWhereItBegins(const MeshDesc& mesh) {
    return isClosed(trackOf(mesh));
}

} // namespace demos
