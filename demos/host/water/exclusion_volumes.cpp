#include "host/water/exclusion_volumes.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

namespace demos {

namespace {

constexpr size_t mostWalls = std::size(seaglass::ExclusionVolume{}.planes) - 1; ///< and a bottom

double across(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
}

/// 1 or -1 by the way round, 0 where corners turn both ways or not at all.
int turningOf(const std::vector<Vec2>& points) {
    const size_t count = points.size();
    int turning = 0;
    for (size_t i = 0; i < count; ++i) {
        const double turn = across(points[i], points[(i + 1) % count], points[(i + 2) % count]);
        const int here = turn > 0 ? 1 : -1;
        if (turn == 0 || (turning != 0 && here != turning)) return 0;
        turning = here;
    }
    return turning;
}

seaglass::ExclusionVolume roomOf(const ExclusionVolumeDesc& desc, int turning) {
    seaglass::ExclusionVolume volume;
    // A turn about +Y takes +X towards -Z.
    const double yaw = -desc.yawDeg * std::numbers::pi / 180, c = std::cos(yaw), s = std::sin(yaw);
    const auto place = [&](const Vec2& point) {
        return Vec2{desc.positionM[0] + c * point[0] - s * point[1],
                    desc.positionM[2] + s * point[0] + c * point[1]};
    };
    const size_t count = desc.pointsM.size();
    for (size_t i = 0; i < count; ++i) {
        const Vec2 from = place(desc.pointsM[i]), to = place(desc.pointsM[(i + 1) % count]);
        const double x = turning * (to[1] - from[1]), z = -turning * (to[0] - from[0]);
        const double y = -std::hypot(x, z) * std::tan(desc.flareDeg * std::numbers::pi / 180);
        double(&wall)[4] = volume.planes[i];
        wall[0] = x;
        wall[1] = y;
        wall[2] = z;
        wall[3] = -x * from[0] - y * desc.positionM[1] - z * from[1];
    }
    double(&bottom)[4] = volume.planes[mostWalls];
    bottom[1] = -1;
    bottom[3] = desc.positionM[1] + desc.bottomM;
    return volume;
}

} // namespace

bool exclusionVolumesOf(const std::vector<ExclusionVolumeDesc>& volumes, const std::string& path,
                        std::vector<seaglass::ExclusionVolume>& out, Error& error) {
    out.clear();
    for (const ExclusionVolumeDesc& desc : volumes) {
        const size_t corners = desc.pointsM.size();
        const std::string name = path + "." + std::to_string(out.size()) + ".points_m ";
        if (corners < 3 || corners > mostWalls) {
            error.text =
                name + "are " + std::to_string(corners) + ", expected 3 to " + std::to_string(mostWalls);
            return false;
        }
        const int turning = turningOf(desc.pointsM);
        if (turning == 0) {
            error.text = name + "are no convex outline";
            return false;
        }
        out.push_back(roomOf(desc, turning));
    }
    return true;
}

void addCarried(const MeshDesc& mesh, const glm::dmat4& worldFromMesh,
                std::vector<seaglass::ExclusionVolume>& out) {
    const glm::dmat4 planes = glm::transpose(glm::inverse(worldFromMesh));
    for (const ExclusionVolumeDesc& desc : mesh.exclusionVolumes) {
        seaglass::ExclusionVolume& volume = out.emplace_back(roomOf(desc, turningOf(desc.pointsM)));
        for (double(&plane)[4] : volume.planes) {
            const glm::dvec4 moved = planes * glm::dvec4(plane[0], plane[1], plane[2], plane[3]);
            for (glm::length_t i = 0; i < 4; ++i) plane[i] = moved[i];
        }
    }
}

} // namespace demos
