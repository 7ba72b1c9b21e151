#include "reference/light/caustics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "reference/light/water_light.h"
#include "reference/rows.h"
#include "reference/shade/facet.h"

namespace demos::reference {
namespace {

/// Of the calm water's beam that lights a point relative to the eye.
struct BeamPlace {
    glm::dvec2 at{0}; ///< where it comes in, on the level in the world
    float along = 0;  ///< from there [m]
};

BeamPlace beamPlaceOf(const Frame& frame, const glm::vec3& position, const glm::vec3& from) {
    const float along = -frame.heightOf(position) / from.y;
    const glm::vec3 in = position + from * along;
    return {glm::dvec2(frame.camera.eye.x, frame.camera.eye.z) + glm::dvec2(in.x, in.z), along};
}

/// The bed that the middle of a pixel shows, through the surface, mirrored by it from within, or in plain
/// sight. None where hardly any of its light arrives, nor where a pixel is wider than a tile.
std::optional<glm::vec3> bedSeenBy(const Frame& frame, uint32_t x, uint32_t y) {
    Ray ray = frame.rayThrough(glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f);
    ray.inWater = isInWater(frame, ray.origin + ray.direction * ray.nearest);
    Hit hit;
    if (!frame.geometry.trace(ray, Kind::everything, hit)) return std::nullopt;
    float before = 0, path = hit.distance; // in air and in water
    if (hit.kind == Kind::surface) {
        const Facet facet = meanFacet(frame, ray, hit);
        const bool mirrors = frame.world->water->underwater && !hit.frontFacing;
        const glm::vec3 direction = mirrors ? glm::reflect(ray.direction, facet.normal)
                                            : glm::refract(ray.direction, facet.normal, 1 / waterIndex);
        before = hit.distance;
        const Ray bent = bentRay(ray, hit, mirrors ? facet.up : -facet.up, glm::normalize(direction));
        if (!frame.geometry.trace(bent, Kind::opaque, hit)) return std::nullopt;
        path = hit.distance + (mirrors ? before : 0);
    } else if (!ray.inWater) {
        return std::nullopt;
    }
    constexpr float least = 0.01f;
    const glm::vec3 left =
        glm::exp(-waterLightOf(frame).extinction() * (path - frame.heightOf(hit.position)));
    if (std::max({left.x, left.y, left.z}) < least) return std::nullopt;
    const double width = static_cast<double>(frame.pixelAngle * (frame.apexM + before + hit.distance));
    return width > PhotonMap::side ? std::nullopt : std::optional(hit.position);
}

/// How far from its calm place on the level light may come to a beam's end.
class Wandering {
  public:
    Wandering(const Frame& frame, const glm::vec3& toSun, const glm::vec3& from) {
        // Four standard deviations of every wave there is.
        const glm::vec3 all = frame.surface.slopes(glm::dvec2(0), 1e9).covariance;
        const float most = 4 * std::sqrt(std::max(all.x, all.y));
        const glm::vec2 calm = strayOf(from);
        const glm::vec2 level(toSun.x, toSun.z);
        const glm::vec2 sun = glm::length(level) > 1e-3f ? glm::normalize(level) : glm::vec2(1, 0);
        for (const glm::vec2 slope : {sun, -sun, glm::vec2(sun.y, -sun.x)}) {
            const glm::vec3 normal = normalOf(most * slope);
            if (glm::dot(normal, toSun) <= 0) continue;
            perMetre_ = std::max(perMetre_,
                                 glm::length(strayOf(-glm::refract(-toSun, normal, 1 / waterIndex)) - calm));
        }
        const auto height = static_cast<float>(seaglass::significantWaveHeight(*frame.world->sea));
        always_ = height * glm::length(strayOf(toSun) - calm);
    }
    double at(float depth) const { return static_cast<double>(always_ + perMetre_ * std::max(depth, 0.0f)); }

  private:
    static glm::vec2 strayOf(const glm::vec3& from) {
        return glm::vec2(from.x, from.z) / std::max(from.y, 0.1f);
    }
    float perMetre_ = 0, always_ = 0;
};

/// Deviation that chance alone, the sun's disc and slopes that no map resolves, brings to light a metre down.
float blurOf(const Frame& frame) {
    constexpr int places = 32;
    float variance = 0;
    for (int i = 0; i < places; ++i)
        for (int j = 0; j < places; ++j) {
            const glm::vec3 rough = frame.surface.slopes(glm::dvec2(0.37 * i, 0.41 * j), 0).covariance;
            variance += (rough.x + rough.y) / (2 * places * places);
        }
    constexpr float turns = 1 - 1 / waterIndex, disc = static_cast<float>(sunRadius) / 2 / waterIndex;
    return std::sqrt(turns * turns * variance + disc * disc);
}

struct Ordered {
    bool operator()(const glm::i64vec2& a, const glm::i64vec2& b) const {
        return a.y != b.y ? a.y < b.y : a.x < b.x;
    }
};

struct Asked {
    uint32_t pixels = 0;
    float deepest = 0;
};

/// The tiles that the picture's beds are lit through, in a fixed order, and those around from which light
/// wanders there.
std::vector<PhotonTile> tilesFor(const Frame& frame, const glm::vec3& toSun, const glm::vec3& from) {
    std::vector<std::vector<glm::vec3>> beds(frame.desc.height);
    forEachRow(frame.desc.height, frame.desc.threads,
               [&](uint32_t y) {
                   for (uint32_t x = 0; x < frame.desc.width; ++x)
                       if (const auto bed = bedSeenBy(frame, x, y)) beds[y].push_back(*bed);
               },
               {});
    std::map<glm::i64vec2, Asked, Ordered> asked;
    for (const std::vector<glm::vec3>& row : beds)
        for (const glm::vec3& bed : row) {
            Asked& tile = asked[PhotonMap::tileAt(beamPlaceOf(frame, bed, from).at)];
            ++tile.pixels;
            tile.deepest = std::max(tile.deepest, -frame.heightOf(bed));
        }

    constexpr uint32_t fewest = 4, most = 16;
    constexpr double sparsest = 100, densest = 250000;
    const double photonsAPixel = std::clamp(frame.desc.samples, fewest, most);
    const Wandering wandering(frame, toSun, from);
    std::map<glm::i64vec2, PhotonTile, Ordered> tiles;
    for (const auto& [at, tile] : asked) {
        const double density =
            std::clamp(photonsAPixel * tile.pixels / (PhotonMap::side * PhotonMap::side), sparsest, densest);
        const auto around = static_cast<int64_t>(1 + wandering.at(tile.deepest) / PhotonMap::side);
        for (int64_t y = -around; y <= around; ++y)
            for (int64_t x = -around; x <= around; ++x) {
                PhotonTile& near = tiles[at + glm::i64vec2(x, y)];
                near.density = std::max(near.density, density);
            }
    }
    const double mostInAll = photonsAPixel * frame.desc.width * frame.desc.height;
    double all = 0;
    for (const auto& [at, tile] : tiles) all += tile.density * PhotonMap::side * PhotonMap::side;
    std::vector<PhotonTile> sorted;
    for (const auto& [at, tile] : tiles)
        sorted.push_back({at, tile.density * std::min(1.0, mostInAll / all), asked.contains(at)});
    return sorted;
}

class Source {
  public:
    Source(const Frame& frame, const glm::vec3& toSun, const Beam& calm)
        : frame_(frame), from_(calm.from), entering_(1 - fresnelWater(toSun.y)),
          highest_(static_cast<float>(farthestMove(*frame.world->sea))) {}

    std::vector<Photon> photonsOf(const PhotonTile& tile) const {
        constexpr double area = PhotonMap::side * PhotonMap::side;
        // As many as fill the tile evenly.
        const uint32_t count = std::bit_ceil(static_cast<uint32_t>(std::ceil(tile.density * area)));
        const uint32_t number =
            hash(static_cast<uint32_t>(tile.at.x) + hash(static_cast<uint32_t>(tile.at.y)));
        std::vector<Photon> photons;
        photons.reserve(count);
        for (uint32_t i = 0; i < count; ++i) {
            Random random(number, i, frame_.desc.seed);
            const glm::dvec2 at = (glm::dvec2(tile.at) + glm::dvec2(random.inPixel())) * PhotonMap::side;
            Photon photon;
            photon.area = static_cast<float>(area / count);
            if (follow(at, random, photon)) photons.push_back(photon);
        }
        return photons;
    }

  private:
    /// To where it falls.
    bool follow(const glm::dvec2& at, Random& random, Photon& photon) const {
        const glm::vec3 toSun = frame_.world->light.towardsSun(random.next2());
        if (toSun.y <= 0) return false;
        const glm::dvec2 fromEye = at - glm::dvec2(frame_.camera.eye.x, frame_.camera.eye.z);
        const auto level = static_cast<float>(frame_.world->levelM - frame_.camera.eye.y);
        Ray ray;
        ray.origin = glm::vec3(fromEye.x, level, fromEye.y) + toSun * (highest_ / toSun.y);
        ray.direction = -toSun;
        Hit hit;
        if (!frame_.geometry.trace(ray, Kind::surface, hit) || !hit.frontFacing) return false;
        const Facet facet = randomFacet(frame_, ray, hit, 0.01f, random);
        if (frame_.geometry.occluded(hit.position + facet.up * clearanceAt(hit.position), toSun, Kind::opaque,
                                     {}))
            return false;
        Ray below;
        below.origin = hit.position - facet.up * clearanceAt(hit.position);
        below.direction = glm::normalize(glm::refract(ray.direction, facet.normal, 1 / waterIndex));
        Hit bed;
        if (!frame_.geometry.traceLight(below, Kind::opaque, bed)) return false;
        const BeamPlace place = beamPlaceOf(frame_, bed.position, from_);
        photon.at = place.at;
        photon.along = place.along;
        photon.area *= facet.weight * (1 - fresnelWater(glm::dot(toSun, facet.normal))) / entering_;
        return true;
    }

    const Frame& frame_;
    glm::vec3 from_;
    float entering_, highest_;
};

} // namespace

void Caustics::create(const Frame& frame) {
    photons_ = {};
    const Light& light = frame.world->light;
    const glm::vec3 toSun = light.toSun();
    if (frame.surface.flat() || !frame.world->water->refraction || toSun.y <= 0 ||
        light.sunIrradiance() == glm::vec3(0))
        return;
    const Beam calm = enteringBeam(toSun, light.sunIrradiance());
    std::vector<PhotonTile> tiles = tilesFor(frame, toSun, calm.from);
    // Makes the blur wider by an eighth.
    blur_ = 1.25f * blurOf(frame);
    const Source source(frame, toSun, calm);
    std::vector<std::vector<Photon>> photons(tiles.size());
    forEachRow(static_cast<uint32_t>(tiles.size()), frame.desc.threads,
               [&](uint32_t i) { photons[i] = source.photonsOf(tiles[i]); }, {});
    photons_.create(std::move(tiles), photons);
}

std::optional<float> Caustics::gainAt(const Frame& frame, const glm::vec3& position, const glm::vec3& normal,
                                      const glm::vec3& from) const {
    const BeamPlace place = beamPlaceOf(frame, position, from);
    const float facing = std::max(std::abs(glm::dot(normal, from)), 0.05f);
    return photons_.gainAt(place.at, place.along, blur_ * place.along,
                           glm::length(glm::vec2(normal.x, normal.z)) / facing);
}

} // namespace demos::reference
