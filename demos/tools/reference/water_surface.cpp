#include "reference/water_surface.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "host/water/waves.h"
#include "reference/shade/optics.h"
#include "reference/water/foam_history.h"

namespace demos::reference {
namespace {

std::vector<glm::vec4> halved(const std::vector<glm::vec4>& level, uint32_t size) {
    const uint32_t half = size / 2;
    std::vector<glm::vec4> next(size_t(half) * half);
    for (size_t y = 0; y < half; ++y)
        for (size_t x = 0; x < half; ++x) {
            const size_t at = 2 * y * size + 2 * x;
            next[y * half + x] =
                0.25f * ((level[at] + level[at + 1]) + (level[at + size] + level[at + size + 1]));
        }
    return next;
}

void addLevels(std::vector<std::vector<glm::vec4>>& map, uint32_t size) {
    for (; size > 1; size /= 2) map.push_back(halved(map.back(), size));
}

glm::dvec2 aside(const glm::dvec2& calm, const seaglass::WarpShift& warped) {
    return calm + glm::dvec2(warped.u, warped.v);
}

/// Derivatives along u and v of what is looked up there.
glm::vec2 along(const glm::vec2& derivatives, const seaglass::WarpShift& warped) {
    return derivatives + derivatives.x * glm::vec2(warped.uu, warped.uv) +
           derivatives.y * glm::vec2(warped.vu, warped.vv);
}

/// The azimuths that a camera sees of a plane, as a middle and half a width [rad].
struct Azimuths {
    double middle = 0, half = std::numbers::pi;
};

/// What the mesh is finest around: the eye's foot, or the middle of what parallel lines of sight see, from as
/// high as they see across.
struct MeshMiddle {
    glm::dvec2 at{0}; ///< from the eye [m]
    double height = 0;
};

MeshMiddle middleOf(const Camera& camera, double eyeHeight) {
    if (!camera.parallel()) return {glm::dvec2(0), std::max(std::abs(eyeHeight), 0.05)};
    const double sinks = std::max(-camera.forward.y * (eyeHeight < 0 ? -1 : 1), 1e-2);
    const double along = std::clamp(std::abs(eyeHeight) / sinks, camera.near, camera.far);
    return {along * glm::dvec2(camera.forward.x, camera.forward.z),
            glm::length(camera.half / glm::dvec2(1, std::max(sinks, 0.1)))};
}

Azimuths azimuthsOf(const Camera& camera) {
    if (camera.parallel()) return {};
    const glm::dvec2 ahead(camera.forward.x, camera.forward.z);
    if (glm::length(ahead) < 1e-3) return {};
    Azimuths seen{std::atan2(ahead.y, ahead.x), 0};
    const glm::dvec2 axis = glm::normalize(ahead);
    // Edges of the picture are straight lines, so that their ends see farthest round; straight down or up
    // sees all round.
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            const glm::dvec3 corner = camera.forward + camera.right * (x * camera.tanHalfFovX) +
                                      camera.up * (y * camera.tanHalfFovY);
            const double along = glm::dot(glm::dvec2(corner.x, corner.z), axis);
            const double across = std::abs(axis.x * corner.z - axis.y * corner.x);
            seen.half = std::max(seen.half, std::atan2(across, along));
        }
    if (seen.half > 0.45 * std::numbers::pi) return {};
    return seen;
}

std::vector<double> azimuthSteps(const Azimuths& seen, double fine) {
    constexpr double margin = 0.03;
    const double half = std::min(std::numbers::pi, seen.half + margin);
    const auto within = static_cast<size_t>(std::ceil(2 * half / fine));
    std::vector<double> angles;
    for (size_t i = 0; i <= within; ++i)
        angles.push_back(seen.middle - half +
                         2 * half * static_cast<double>(i) / static_cast<double>(within));
    constexpr double coarse = 0.03;
    const double rest = 2 * (std::numbers::pi - half);
    const auto outside = static_cast<size_t>(std::ceil(rest / coarse));
    for (size_t i = 1; i < outside; ++i)
        angles.push_back(seen.middle + half + rest * static_cast<double>(i) / static_cast<double>(outside));
    if (outside == 0) angles.pop_back(); // the first again
    return angles;
}

/// From a place to a corner of what an outline encloses [m].
double farthestOf(const Outline& outline, const glm::dvec2& foot) {
    return 1.1 * glm::length(glm::max(glm::abs(outline.low - foot), glm::abs(outline.high - foot)));
}

} // namespace

double farthestMove(const seaglass::Sea& sea) {
    // Heights pass 5 standard deviations once in a million; choppiness moves points sideways about as far.
    const double height = 1.25 * seaglass::significantWaveHeight(sea);
    return height * std::max(1.0, double{seaglass::description(sea).choppiness}) +
           (sea.shore ? sea.shore->reach() : 0);
}

bool WaterSurface::create(const seaglass::Sea* sea, const seaglass::FoamDesc* foam, double timeS,
                          Error& error) {
    cascades_.clear();
    shore_.reset();
    roughness_ = glm::vec3(0);
    const uint32_t count = sea ? seaglass::cascadeCount(*sea) : 0;
    if (count == 0) return true;
    if (!wavesBackend()) {
        error.text = "water.waves: this program was built without waves on the CPU (SEAGLASS_FFTW)";
        return false;
    }
    const seaglass::WavesBackend& backend = *wavesBackend();
    const std::unique_ptr<void, void (*)(void*)> state(backend.create(*sea), backend.destroy);
    if (!state) {
        error.text = "water.waves: out of memory";
        return false;
    }
    const seaglass::SlopeCovariance rough = seaglass::roughness(*sea);
    roughness_ = glm::vec3(rough.uu, rough.vv, rough.uv);
    warp_ = sea->warp;
    for (uint32_t i = 0; i < count; ++i) {
        const seaglass::Cascade& from = seaglass::cascade(*sea, i);
        Cascade& to = cascades_.emplace_back();
        to.patch = from.patch;
        to.samples = from.samples;
        const size_t texels = size_t(from.samples) * from.samples;
        to.displacement.emplace_back(texels);
        to.derivatives.emplace_back(texels);
        to.moments.emplace_back(texels);
        backend.evaluate(state.get(), i, timeS,
                         {&to.displacement[0][0].x, &to.derivatives[0][0].x, &to.moments[0][0].x});
        for (auto* map : {&to.displacement, &to.derivatives, &to.moments}) addLevels(*map, from.samples);
    }
    if (sea->shore)
        shore_.emplace(*sea->shore, timeS, double{(foam ? *foam : seaglass::FoamDesc{}).decayTime});
    if (foam) addFoam(*sea, *foam, backend, state.get(), timeS);
    return true;
}

void WaterSurface::addFoam(const seaglass::Sea& sea, const seaglass::FoamDesc& foam,
                           const seaglass::WavesBackend& backend, void* state, double timeS) {
    const seaglass::SeaDesc& desc = seaglass::description(sea);
    lace_ = seaglass::foamLaceOf(desc, timeS, laceRepeatM);
    windrows_ = seaglass::foamWindrowsOf(desc, timeS, windrowTileM);
    breaking_ = seaglass::breakingOf(sea, foam);
    const std::vector<FoamLeft> left = foamLeft(sea, foam, backend, state, timeS);
    foamGate_ = seaglass::FoamGate(sea, timeS);
    for (size_t i = 0; i < left.size(); ++i) {
        Level& level = cascades_[i].foam.emplace_back();
        for (size_t t = 0; t < left[i].foam.size(); ++t)
            level.emplace_back(left[i].foam[t], left[i].plume[t], 0, 0);
        cascades_[i].drift =
            seaglass::foamDriftOf(desc, seaglass::cascade(sea, static_cast<uint32_t>(i)), timeS);
        addLevels(cascades_[i].foam, cascades_[i].samples);
    }
}

glm::vec4 WaterSurface::bilinear(const Cascade& cascade, const std::vector<Level>& map, size_t mip,
                                 const glm::dvec2& calm) {
    const uint32_t size = cascade.samples >> mip;
    // Sample i of the sea lies at i / samples of the patch; a mip's texel at the middle of those it is the
    // mean of.
    const double scale = std::ldexp(1.0, -static_cast<int>(mip));
    const auto at = [&](double position) {
        const double texels =
            (position / cascade.patch - std::floor(position / cascade.patch)) * cascade.samples;
        return (texels + 0.5) * scale - 0.5;
    };
    const double x = at(calm.x), y = at(calm.y), x0 = std::floor(x), y0 = std::floor(y);
    const auto index = [&](double i) { return static_cast<size_t>(static_cast<int64_t>(i) + size) % size; };
    const size_t left = index(x0), right = index(x0 + 1), top = index(y0) * size,
                 bottom = index(y0 + 1) * size;
    const Level& level = map[mip];
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    return glm::mix(glm::mix(level[top + left], level[top + right], fx),
                    glm::mix(level[bottom + left], level[bottom + right], fx), fy);
}

glm::vec4 WaterSurface::trilinear(const Cascade& cascade, const std::vector<Level>& map, double mip,
                                  const glm::dvec2& calm) {
    const auto last = static_cast<double>(map.size() - 1);
    const double kept = std::clamp(mip, 0.0, last);
    const auto level = static_cast<size_t>(kept);
    const auto share = static_cast<float>(kept - static_cast<double>(level));
    const glm::vec4 fine = bilinear(cascade, map, level, calm);
    return share == 0 ? fine : glm::mix(fine, bilinear(cascade, map, level + 1, calm), share);
}

namespace {
/// How far wet sand has been left behind by the water's edge; 0: it is dry.
double wetnessOf(const ShoreWave& shore) {
    return std::clamp((shore.wetTo + shore.depth) / std::max(0.8 * shore.swash, 1e-3), 0.0, 1.0);
}

double mipOf(double footprint, double texel) {
    return footprint > texel ? std::log2(footprint / texel) : 0.0;
}
} // namespace

glm::vec3 WaterSurface::displacement(const glm::dvec2& calm, double footprint) const {
    return displacement(calm, footprint, shoreAt(calm, footprint));
}

glm::vec3 WaterSurface::displacement(const glm::dvec2& calm, double footprint, const ShoreWave& shore) const {
    glm::vec3 sum(0);
    const seaglass::WarpShift warped = seaglass::warpAt(warp_, calm.x, calm.y);
    for (size_t i = 0; i < cascades_.size(); ++i) {
        const Cascade& cascade = cascades_[i];
        const double mip = mipOf(footprint, cascade.texel());
        // The last mip is the tile's mean, which is zero.
        if (mip < static_cast<double>(cascade.displacement.size() - 1))
            sum += kept(shore, i) *
                   glm::vec3(trilinear(cascade, cascade.displacement, mip, aside(calm, warped)));
    }
    if (!shore_) return sum;
    sum += glm::vec3(shore.move.x, shore.height, shore.move.y);
    const double lift = 0.012 + 0.01 * footprint; // so that no grain of the sand hides it
    sum.y = static_cast<float>(shore.withFilm(static_cast<double>(sum.y), lift));
    return sum;
}

WaterSurface::Edge WaterSurface::edge(const glm::dvec2& calm, double footprint) const {
    return edge(shoreAt(calm, footprint));
}

WaterSurface::Edge WaterSurface::edge(const ShoreWave& shore) const {
    Edge edge;
    if (!shore_) return edge;
    const double thick = shore.height - shore.bed();
    edge.presence = std::max(glm::smoothstep(0.0, 0.025, thick), wetnessOf(shore));
    edge.onSand = 1 - glm::smoothstep(0.0, 0.04, thick);
    edge.advected = shore.advected;
    edge.bedSlope = shore.bedSlope;
    return edge;
}

WaterSurface::Slopes WaterSurface::slopes(const glm::dvec2& calm, double footprint) const {
    Slopes s;
    glm::vec2 height(0), movedU(0), movedV(0); // how they change along u and v
    glm::vec3 variance(0);
    const seaglass::WarpShift warped = seaglass::warpAt(warp_, calm.x, calm.y);
    const ShoreWave shore = shoreAt(calm, footprint);
    for (size_t i = 0; i < cascades_.size(); ++i) {
        const Cascade& cascade = cascades_[i];
        const double mip = mipOf(footprint, cascade.texel());
        const float share = kept(shore, i);
        const glm::dvec2 there = aside(calm, warped);
        const glm::vec4 d = share * trilinear(cascade, cascade.derivatives, mip, there);
        const float shear = share * trilinear(cascade, cascade.displacement, mip, there).w;
        height += along({d.x, d.y}, warped);
        movedU += along({d.z, shear}, warped);
        movedV += along({shear, d.w}, warped);
        variance += share * share * glm::vec3(trilinear(cascade, cascade.moments, mip, there)) -
                    glm::vec3(d.x * d.x, d.y * d.y, d.x * d.y);
    }
    height += glm::vec2(shore.slope[0], shore.slope[1]);
    movedU += glm::vec2(shore.stretch[0], shore.stretch[2]);
    movedV += glm::vec2(shore.stretch[2], shore.stretch[1]);
    variance.x = std::max(variance.x, 0.0f);
    variance.y = std::max(variance.y, 0.0f);
    // The tangents' cross product, as slopeOfWaves() of shaders/water/waves/wave_warp.glsl.
    const glm::vec2 diagonal(1 + movedU.x, 1 + movedV.y);
    const glm::vec2 bent(height.x * diagonal.y - height.y * movedV.x,
                         height.y * diagonal.x - height.x * movedU.y);
    s.mean = bent / std::max(diagonal.x * diagonal.y - movedU.y * movedV.x, 0.15f);
    s.covariance = variance + roughness_;
    if (!shore_) return s;
    const float ripples = kept(shore, cascades_.size() - 1);
    s.covariance = variance + ripples * ripples * roughness_;
    const Edge sand = edge(shore);
    s.mean = glm::mix(s.mean, glm::vec2(sand.bedSlope), static_cast<float>(sand.onSand));
    return s;
}

// The edge of the water, white where it rushes up, and what it lays down where it turns, in lobes by `bend`.
double WaterSurface::edgeFoam(const ShoreWave& shore, double bend) {
    const auto bell = [](double x) { return std::exp(-x * x); };
    const double thick = shore.height - shore.bed() + 0.012 * bend;
    const double rushes = glm::smoothstep(-0.02, 0.1, shore.rushes);
    const double wet = wetnessOf(shore) + 0.15 * bend;
    const double rim = glm::smoothstep(0.0, 0.12, wet) * (1 - glm::smoothstep(0.15, 0.45, wet));
    const double line =
        (0.35 + 0.65 * rushes) * bell((thick - 0.025) / 0.025) + 0.5 * rushes * bell(thick / 0.12);
    const double left = (thick > 0 ? line : 0.7 * rim) * glm::smoothstep(0.0, 0.02, shore.swash);
    return 1 - (1 - 0.95 * shore.surfFoam(bend)) * (1 - std::min(left, 0.9));
}

WaterSurface::FoamCover WaterSurface::foamCover(const glm::dvec2& calm, const glm::dvec2& bend,
                                                double footprint) const {
    const glm::dvec2 under = aside(calm, seaglass::warpAt(warp_, calm.x, calm.y));
    const ShoreWave shore = shoreAt(calm, footprint);
    const float dark = shore_ ? 1 - static_cast<float>(edgeFoam(shore, bend.y)) : 1.0f;
    if (breaking_.count == 0) return {1 - dark, 1 - dark};
    const float gate = foamGate(under, footprint);
    const float now = gate * breakingNow(under, shore, footprint);
    glm::vec2 foamy(gate);
    for (size_t i = 0; i < cascades_.size(); ++i) {
        const Cascade& cascade = cascades_[i];
        if (cascade.foam.empty()) break;
        const glm::dvec2 place = under + bend * std::min(0.7 * cascade.texel(), 4.0) -
                                 cascade.patch * glm::dvec2(cascade.drift.u, cascade.drift.v);
        const float share = kept(shore, i);
        foamy *= share * share *
                 glm::vec2(trilinear(cascade, cascade.foam, mipOf(footprint, cascade.texel()), place));
    }
    const float white = 1 - (1 - foamy.x) * (1 - now) * dark;
    return {white, std::max(foamy.y, white)};
}

// Where water is compressed most, of all cascades that break: a Gaussian, of which a footprint hides a part.
float WaterSurface::breakingNow(const glm::dvec2& place, const ShoreWave& shore, double footprint) const {
    double compressed = 0, hidden = 0;
    for (size_t i = 0; i < cascades_.size(); ++i) {
        const auto counts = static_cast<double>(breaking_.counts[i]);
        const Cascade& cascade = cascades_[i];
        const double mip = mipOf(footprint, cascade.texel());
        const glm::vec4 d = kept(shore, i) * trilinear(cascade, cascade.derivatives, mip, place);
        const glm::vec4 squares =
            kept(shore, i) * kept(shore, i) * trilinear(cascade, cascade.moments, mip, place);
        const float shear = kept(shore, i) * trilinear(cascade, cascade.displacement, mip, place).w;
        compressed += counts * static_cast<double>(breaking_.compression(d.z, d.w, shear));
        hidden += counts * counts *
                  std::max(static_cast<double>(squares.x + squares.y - d.x * d.x - d.y * d.y), 0.0);
    }
    const double width = double{breaking_.nowWidth};
    const double blurred = double{breaking_.hidden} * hidden, variance = width * width + blurred;
    const double seen = std::max(1 - double{breaking_.narrower} * hidden, 0.0) *
                        glm::mix(1.0, double{seaglass::foamBreaksApart}, blurred / variance);
    return static_cast<float>(seen) *
           gaussianBelow(static_cast<float>((compressed - double{breaking_.now}) / std::sqrt(variance)));
}

float WaterSurface::foamGate(const glm::dvec2& place, double footprint) const {
    const Cascade& cascade = cascades_.front();
    const glm::dvec2 tiles = place / cascade.patch + 0.5 / cascade.samples;
    const float seen = foamGate_.at(tiles.x, tiles.y);
    const double blurred = glm::smoothstep(0.5, 2.0, footprint / cascade.patch * foamGate_.cells());
    return glm::mix(seen, foamGate_.mean(), static_cast<float>(blurred));
}

namespace {

/// How far from the eye's foot the mesh goes [m].
double meshRadius(const SurfaceMeshDesc& desc, const glm::dvec2& foot, double height) {
    // A flat sea comes within h/d radians of the horizon: as far as the renderer's own mesh.
    double radius = std::max(100e3, 4000 * height);
    if (!desc.globe.flat()) {
        constexpr double highestCrest = 30; // [m]
        radius =
            std::min(radius, 1.1 * (desc.globe.horizonFrom(height) + desc.globe.horizonFrom(highestCrest)));
    }
    return desc.outline ? std::min(radius, farthestOf(*desc.outline, foot)) : radius;
}

/// Rings of vertices around a foot, each as far apart as it is seen finely.
struct Rings {
    double radius = 0, height = 0; ///< [m]
    double fine = 0;               ///< a cell's edge, as a share of its distance from the eye
    std::vector<double> azimuths;

    double cellAt(double r) const {
        constexpr double finestCell = 0.005; // [m]
        return std::max(fine * std::hypot(r, height), finestCell);
    }
};

/// No more vertices than are wanted.
Rings ringsOf(const WaterSurface& surface, const Camera& camera, const SurfaceMeshDesc& desc, double radius,
              double height) {
    Rings rings{radius, height};
    const Azimuths seen = azimuthsOf(camera);
    // Flat water needs no more than a horizon that looks round.
    const double across = 2 * (camera.parallel() ? camera.half.y / height : camera.tanHalfFovY);
    rings.fine = std::clamp(surface.flat() ? 0.1 : desc.pixelsACell * across / desc.height, 1e-4, 0.1);
    const auto vertices = [&] {
        return std::log(2 * radius / height) / rings.fine *
               static_cast<double>(azimuthSteps(seen, rings.fine).size());
    };
    while (vertices() > desc.mostVertices) rings.fine *= 1.1;
    rings.azimuths = azimuthSteps(seen, rings.fine);
    return rings;
}

/// The first vertex is amid `rings` times `around` others.
void joinRings(uint32_t rings, uint32_t around, SurfaceMesh& mesh) {
    const auto vertex = [&](uint32_t ring, uint32_t i) { return 1 + ring * around + i % around; };
    mesh.triangles.reserve(size_t(2) * rings * around);
    // Upwards is from +x towards -z, against the azimuths.
    for (uint32_t i = 0; i < around; ++i) mesh.triangles.emplace_back(0, vertex(0, i + 1), vertex(0, i));
    for (uint32_t ring = 0; ring + 1 < rings; ++ring)
        for (uint32_t i = 0; i < around; ++i) {
            const uint32_t a = vertex(ring, i), b = vertex(ring, i + 1);
            const uint32_t c = vertex(ring + 1, i), d = vertex(ring + 1, i + 1);
            mesh.triangles.emplace_back(a, b, c);
            mesh.triangles.emplace_back(b, d, c);
        }
}

} // namespace

SurfaceMesh meshOf(const WaterSurface& surface, const Camera& camera, const SurfaceMeshDesc& desc) {
    const double eyeHeight = camera.eye.y - desc.levelM;
    const MeshMiddle middle = middleOf(camera, eyeHeight);
    const glm::dvec2 foot = glm::dvec2(camera.eye.x, camera.eye.z) + middle.at;
    const Rings rings = ringsOf(surface, camera, desc, meshRadius(desc, foot, middle.height), middle.height);

    SurfaceMesh mesh;
    const auto add = [&](const glm::dvec2& fromFoot, double cell) {
        const glm::dvec2 calm = fromFoot + foot, fromEye = fromFoot + middle.at;
        glm::vec3 moved = surface.displacement(calm, cell);
        if (desc.outline && desc.pinned > 0) {
            const auto loose =
                static_cast<float>(std::min(desc.outline->distanceTo(calm) / desc.pinned, 1.0));
            moved *= glm::vec3(loose, 1, loose);
        }
        const double drop = desc.globe.dropAt(glm::dot(fromEye, fromEye));
        mesh.calm.emplace_back(fromEye);
        mesh.positions.emplace_back(static_cast<float>(fromEye.x + moved.x),
                                    static_cast<float>(double{moved.y} - eyeHeight - drop),
                                    static_cast<float>(fromEye.y + moved.z));
    };
    add(glm::dvec2(0), rings.cellAt(0));
    uint32_t count = 0;
    for (double r = rings.cellAt(0); r < rings.radius; r += rings.cellAt(r), ++count)
        for (const double azimuth : rings.azimuths)
            add(r * glm::dvec2(std::cos(azimuth), std::sin(azimuth)), rings.cellAt(r));
    joinRings(count, static_cast<uint32_t>(rings.azimuths.size()), mesh);
    return mesh;
}

} // namespace demos::reference
