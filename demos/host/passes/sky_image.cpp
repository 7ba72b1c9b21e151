#include "host/passes/sky_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <OpenImageIO/parallel.h>

#include "host/files/image_source.h"

namespace demos {
namespace {

constexpr double pi = std::numbers::pi;
constexpr uint32_t maxWidth = 16384;
constexpr uint32_t keptWidth = 4096;
/// Above a sun's in candela per square metre, 1.6e9.
constexpr float maxRadiance = 1e12f;
/// What infinity is taken for, as of half floats that a sun was too bright for.
constexpr float overflowed = 1e7f;
/// What a half float holds, with room for filtering.
constexpr float maxCubeRadiance = 60000.0f;

float luminance(const glm::vec3& c) {
    return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

glm::dvec3 directionAt(double u, double v) {
    const double azimuth = 2 * pi * u, polar = pi * v;
    return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

glm::dvec3 directionOfPixel(const SkyImage& image, uint32_t x, uint32_t y) {
    return directionAt((x + 0.5) / image.width, (y + 0.5) / image.height);
}

double solidAngleOfRow(const SkyImage& image, uint32_t y) {
    const double top = pi * y / image.height, bottom = pi * (y + 1) / image.height;
    return 2 * pi / image.width * (std::cos(top) - std::cos(bottom));
}

/// Replaces what is no radiance. `last` is the last good pixel of the row.
glm::vec3 cleaned(glm::vec3 pixel, const glm::vec3& last) {
    for (int i = 0; i < 3; ++i) {
        if (std::isinf(pixel[i])) pixel[i] = std::min(pixel[i], overflowed);
        pixel[i] = std::isnan(pixel[i]) ? last[i] : std::clamp(pixel[i], 0.0f, maxRadiance);
    }
    return pixel;
}

bool checkHeader(const ImageHeader& header, const std::string& name, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = name + ": " + what;
        return false;
    };
    const std::string size = std::to_string(header.width) + "x" + std::to_string(header.height);
    if (header.integer) return fail("has integer pixels, expected HDR or EXR");
    if (header.cubeMap) return fail("is a cube map, expected a lat-long sky");
    if (header.width < 4 || header.height < 2 || header.height > maxWidth / 2)
        return fail("is " + size + ", expected 4x2 to 16384x8192");
    if (std::abs(int64_t(header.width) - 2 * int64_t(header.height)) > 1)
        return fail("is " + size + ", expected twice as wide as high");
    if (std::abs(header.pixelAspect - 1) > 0.01)
        return fail("has pixels of an aspect of " + std::to_string(header.pixelAspect) + ", expected 1");
    const ImageWindow &data = header.data, &all = header.display;
    if (data.x > all.x || data.y > all.y || data.x + data.width < all.x + all.width ||
        data.y + data.height < all.y + all.height)
        return fail("its data window is " + toText(data) + ", expected to cover its display window, " +
                    toText(all));
    return true;
}

/// Averages the rows it is given into a smaller image, so that a 16k sky never lies in memory whole.
class RowAverager {
  public:
    RowAverager(uint32_t width, uint32_t height) : sourceWidth_(width), sourceHeight_(height) {
        image_.width = std::min(width, keptWidth);
        image_.height = std::min(height, keptWidth / 2);
        image_.radiance.assign(size_t(image_.width) * image_.height, glm::vec3(0));
        counts_.assign(image_.radiance.size(), 0);
    }
    void add(const ImageRow& row) {
        glm::vec3 last(0);
        auto x = static_cast<uint64_t>(row.x), y = static_cast<uint64_t>(row.y);
        for (const glm::vec4& pixel : row.rgba) {
            last = cleaned(glm::vec3(pixel), last);
            const size_t i = size_t(y * image_.height / sourceHeight_) * image_.width +
                             size_t(x * image_.width / sourceWidth_);
            image_.radiance[i] += last;
            ++counts_[i];
            x += static_cast<uint64_t>(row.stepX);
            y += static_cast<uint64_t>(row.stepY);
        }
    }
    SkyImage finish() {
        for (size_t i = 0; i < counts_.size(); ++i)
            image_.radiance[i] /= static_cast<float>(std::max(1u, counts_[i]));
        return std::move(image_);
    }

  private:
    uint32_t sourceWidth_, sourceHeight_;
    SkyImage image_;
    std::vector<uint32_t> counts_;
};

struct FacePoint {
    uint32_t face = 0;
    double s = 0, t = 0;
};

FacePoint facePoint(const glm::dvec3& d) {
    const glm::dvec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z)
        return d.x > 0 ? FacePoint{0, -d.z / a.x, -d.y / a.x} : FacePoint{1, d.z / a.x, -d.y / a.x};
    if (a.y >= a.z) return d.y > 0 ? FacePoint{2, d.x / a.y, d.z / a.y} : FacePoint{3, d.x / a.y, -d.z / a.y};
    return d.z > 0 ? FacePoint{4, d.x / a.z, -d.y / a.z} : FacePoint{5, -d.x / a.z, -d.y / a.z};
}

double texelCentre(int64_t i, uint32_t size) {
    return (2 * static_cast<double>(i) + 1) / size - 1;
}

/// Solid angle of a texel up to a factor that is the same for its whole level.
double texelWeight(double s, double t) {
    const double squared = 1 + s * s + t * t;
    return 1 / (squared * std::sqrt(squared));
}

/// A texel of one level; outside its face, the texel of the neighbour that lies there.
const glm::vec3& texelAcross(const std::vector<glm::vec3>& level, uint32_t size, uint32_t face, int64_t x,
                             int64_t y) {
    const auto inside = [&](int64_t i) { return i >= 0 && i < size; };
    if (!inside(x) || !inside(y)) {
        const FacePoint there = facePoint(faceDirection(face, texelCentre(x, size), texelCentre(y, size)));
        const auto index = [&](double c) {
            return std::clamp<int64_t>(static_cast<int64_t>((c + 1) / 2 * size), 0, size - 1);
        };
        face = there.face;
        x = index(there.s);
        y = index(there.t);
    }
    return level[(size_t(face) * size + static_cast<size_t>(y)) * size + static_cast<size_t>(x)];
}

/// Bilinear, u in turns from +X towards +Z, v from the zenith to the nadir.
glm::vec3 sampleAt(const SkyImage& image, double u, double v) {
    const double x = (u - std::floor(u)) * image.width - 0.5, y = v * image.height - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
    const size_t left = x0 < 0 ? image.width - 1 : static_cast<size_t>(x0);
    const size_t right = left + 1 < image.width ? left + 1 : 0;
    const auto row = [&](double r) {
        return &image.radiance[static_cast<size_t>(std::clamp(r, 0.0, image.height - 1.0)) * image.width];
    };
    const glm::vec3 *const above = row(y0), *const below = row(y0 + 1);
    return glm::mix(glm::mix(above[left], above[right], fx), glm::mix(below[left], below[right], fx), fy);
}

/// Where a row of a cube's largest level lies in a sky. Four faces stand around +Y and differ by quarter
/// turns alone, the upper and lower face by their sign, so that few angles want to be computed. Each texel
/// is sampled at 2x2 points.
class CubeRow {
  public:
    CubeRow(uint32_t size, uint32_t y) : points_(2 * size), upright_(2 * points_), lying_(2 * points_) {
        for (uint32_t j = 0; j < 2; ++j)
            for (uint32_t i = 0; i < points_; ++i) {
                const double s = texelCentre(i, points_), t = texelCentre(2 * int64_t(y) + j, points_);
                const size_t at = j * points_ + i, mirrored = j * points_ + (points_ - 1 - i);
                // The left half is the right one's mirror image.
                const bool isLeft = i < points_ / 2;
                const double across = std::sqrt(1 + s * s);
                upright_[at] = isLeft ? LatLong{-std::atan(s) / (2 * pi), std::atan2(across, -t) / pi}
                                      : LatLong{-upright_[mirrored].u, upright_[mirrored].v};
                lying_[at] = isLeft
                                 ? LatLong{std::atan2(t, s) / (2 * pi), std::atan2(std::hypot(s, t), 1) / pi}
                                 : LatLong{0.5 - lying_[mirrored].u, lying_[mirrored].v};
            }
    }

    /// The mean over a texel, of an image turned by so many turns.
    glm::vec3 mean(const SkyImage& image, uint32_t face, uint32_t x, double turn) const {
        glm::vec3 sum(0);
        for (uint32_t j = 0; j < 2; ++j)
            for (uint32_t i = 0; i < 2; ++i) {
                const LatLong at = point(face, size_t{j} * points_ + 2 * x + i);
                sum += sampleAt(image, at.u + turn, at.v);
            }
        return sum * 0.25f;
    }

  private:
    struct LatLong {
        double u = 0, v = 0;
    };

    LatLong point(uint32_t face, size_t at) const {
        constexpr double turns[6] = {0, 0.5, 0, 0, 0.25, 0.75}; // of +X, -X, +Z and -Z
        if (face == 2) return lying_[at];
        if (face == 3) return {-lying_[at].u, 1 - lying_[at].v};
        return {upright_[at].u + turns[face], upright_[at].v};
    }

    uint32_t points_;
    std::vector<LatLong> upright_, lying_;
};

std::vector<glm::vec3> largestLevel(const SkyImage& image, uint32_t size, double rotationDeg,
                                    float intensity) {
    std::vector<glm::vec3> level(size_t(6) * size * size);
    const double turn = -rotationDeg / 360;
    OIIO::parallel_for(int64_t(0), int64_t(size), [&](int64_t y) {
        const CubeRow row(size, static_cast<uint32_t>(y));
        for (uint32_t face = 0; face < 6; ++face)
            for (uint32_t x = 0; x < size; ++x)
                level[(size_t(face) * size + static_cast<size_t>(y)) * size + x] =
                    row.mean(image, face, x, turn) * intensity;
    });
    return level;
}

/// The next level: 4x4 texels under the weights 1 3 3 1, across the faces' edges.
std::vector<glm::vec3> nextLevel(const std::vector<glm::vec3>& level, uint32_t size) {
    constexpr double kernel[4] = {1, 3, 3, 1};
    const uint32_t half = size / 2;
    std::vector<glm::vec3> next(size_t(6) * half * half);
    OIIO::parallel_for(int64_t(0), int64_t(6 * half), [&](int64_t row) {
        const auto face = static_cast<uint32_t>(row / half);
        const int64_t y = row % half;
        for (int64_t x = 0; x < half; ++x) {
            glm::dvec3 sum(0);
            double total = 0;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) {
                    const int64_t tx = 2 * x - 1 + i, ty = 2 * y - 1 + j;
                    const double weight =
                        kernel[i] * kernel[j] * texelWeight(texelCentre(tx, size), texelCentre(ty, size));
                    sum += weight * glm::dvec3(texelAcross(level, size, face, tx, ty));
                    total += weight;
                }
            next[static_cast<size_t>(row * half + x)] = glm::vec3(sum / total);
        }
    });
    return next;
}

/// Irradiance by spherical harmonics of degree two (Ramamoorthi and Hanrahan 2001), as a polynomial of the
/// normal.
void integrate(const std::vector<glm::vec3>& level, uint32_t size, SkyLight& light) {
    std::array<glm::dvec3, 9> sh{};
    glm::dvec3 up(0);
    double total = 0;
    for (uint32_t face = 0; face < 6; ++face)
        for (uint32_t y = 0; y < size; ++y)
            for (uint32_t x = 0; x < size; ++x) {
                const double s = texelCentre(x, size), t = texelCentre(y, size), weight = texelWeight(s, t);
                const glm::dvec3 d = glm::normalize(faceDirection(face, s, t));
                const glm::dvec3 radiance = weight * glm::dvec3(level[(size_t(face) * size + y) * size + x]);
                const double basis[9] = {0.282095,
                                         0.488603 * d.y,
                                         0.488603 * d.z,
                                         0.488603 * d.x,
                                         1.092548 * d.x * d.y,
                                         1.092548 * d.y * d.z,
                                         0.315392 * (3 * d.z * d.z - 1),
                                         1.092548 * d.x * d.z,
                                         0.546274 * (d.x * d.x - d.y * d.y)};
                for (size_t i = 0; i < 9; ++i) sh[i] += basis[i] * radiance;
                up += std::max(0.0, d.y) * radiance;
                total += weight;
            }
    const double perTexel = 4 * pi / total;
    // Cosine lobe (pi, 2 pi/3, pi/4) times the basis' own factor.
    const double factor[9] = {pi * 0.282095,         2 * pi / 3 * 0.488603, 2 * pi / 3 * 0.488603,
                              2 * pi / 3 * 0.488603, pi / 4 * 1.092548,     pi / 4 * 1.092548,
                              pi / 4 * 0.315392,     pi / 4 * 1.092548,     pi / 4 * 0.546274};
    for (size_t i = 0; i < 9; ++i) light.irradianceSh[i] = glm::vec3(sh[i] * perTexel * factor[i]);
    light.irradianceUp = glm::vec3(up * perTexel);
}

/// As fine as the image near its horizon, or twice as fine.
uint32_t faceSizeFor(const SkyImage& image) {
    return image.width > 1024 ? 512 : std::clamp(std::bit_ceil(image.width / 2), 64u, 256u);
}

} // namespace

glm::vec3 sampleSky(const SkyImage& image, const glm::dvec3& direction) {
    return sampleAt(image, std::atan2(direction.z, direction.x) / (2 * pi),
                    std::acos(std::clamp(direction.y, -1.0, 1.0)) / pi);
}

glm::vec3 sampleCube(const SkyCube& cube, const glm::dvec3& direction, float mip) {
    const FacePoint at = facePoint(direction);
    const auto fromLevel = [&](size_t index) {
        const std::vector<glm::vec3>& level = cube.mips[index];
        const uint32_t size = cube.faceSize >> index;
        const double x = (at.s + 1) / 2 * size - 0.5, y = (at.t + 1) / 2 * size - 0.5;
        const auto x0 = static_cast<int64_t>(std::floor(x)), y0 = static_cast<int64_t>(std::floor(y));
        const auto fx = static_cast<float>(x - std::floor(x)), fy = static_cast<float>(y - std::floor(y));
        const auto texel = [&](int64_t i, int64_t j) { return texelAcross(level, size, at.face, i, j); };
        return glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), fx),
                        glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), fx), fy);
    };
    const float kept = std::clamp(mip, 0.0f, static_cast<float>(cube.mips.size() - 1));
    const auto level = static_cast<size_t>(kept);
    const size_t next = std::min(level + 1, cube.mips.size() - 1);
    return glm::mix(fromLevel(level), fromLevel(next), kept - static_cast<float>(level));
}

glm::dvec3 faceDirection(uint32_t face, double s, double t) {
    switch (face) {
    case 0:
        return {1, -t, -s};
    case 1:
        return {-1, -t, s};
    case 2:
        return {s, 1, t};
    case 3:
        return {s, -1, -t};
    case 4:
        return {s, -t, 1};
    default:
        return {-s, -t, -1};
    }
}

std::optional<SkyImage> readSkyImage(const SkyDesc& sky, Error& error) {
    if (sky.clear) return SkyImage{};
    std::optional<ImageSource> source =
        ImageSource::open(sky.file, {sky.layer, "sky.layer"}, limits::skyPixels, error);
    if (!source || !checkHeader(source->header(), sky.file.string(), error)) return std::nullopt;
    RowAverager rows(source->header().width, source->header().height);
    if (!source->read([&rows](const ImageRow& row) { rows.add(row); }, error)) return std::nullopt;
    return rows.finish();
}

ImageSun takeOutSun(SkyImage& image) {
    // The upper half alone: what shines from below lights nothing as a sun, and stays in the image.
    const auto horizon =
        image.radiance.begin() + static_cast<std::ptrdiff_t>(size_t(image.height) / 2 * image.width);
    const auto brightest =
        std::max_element(image.radiance.begin(), horizon,
                         [](const glm::vec3& a, const glm::vec3& b) { return luminance(a) < luminance(b); });
    const auto index = static_cast<size_t>(brightest - image.radiance.begin());
    ImageSun sun;
    sun.direction = directionOfPixel(image, static_cast<uint32_t>(index % image.width),
                                     static_cast<uint32_t>(index / image.width));
    const glm::dvec3 peak = sun.direction;
    // The disc is 0.27 degrees in radius; filtering and glare in the image spread it over a few pixels.
    const double disc = std::min(0.5, std::max(glm::radians(1.2), 3 * 2 * pi / image.width));
    const double ring = 1.8 * disc;
    const auto forPixelsWithin = [&](double radius, const auto& visit) {
        const double polar = std::acos(std::clamp(peak.y, -1.0, 1.0));
        const auto rowOf = [&](double angle) {
            return static_cast<uint32_t>(std::clamp(angle / pi * image.height, 0.0, image.height - 1.0));
        };
        for (uint32_t y = rowOf(polar - radius); y <= rowOf(polar + radius); ++y)
            for (uint32_t x = 0; x < image.width; ++x) {
                const glm::dvec3 d = directionOfPixel(image, x, y);
                const double angle = 2 * std::asin(std::min(1.0, glm::length(d - peak) / 2));
                if (angle <= radius)
                    visit(image.radiance[size_t(y) * image.width + x], d, angle, solidAngleOfRow(image, y));
            }
    };
    float limit = 0;
    forPixelsWithin(ring, [&](const glm::vec3& pixel, const glm::dvec3&, double angle, double) {
        if (angle > disc) limit = std::max(limit, luminance(pixel));
    });
    glm::dvec3 weighted(0);
    forPixelsWithin(disc, [&](glm::vec3& pixel, const glm::dvec3& d, double, double solidAngle) {
        const float bright = luminance(pixel);
        if (bright <= limit || d.y <= 0) return;
        const glm::vec3 kept = pixel * (limit / bright);
        sun.irradiance += glm::dvec3(pixel - kept) * solidAngle;
        weighted += d * (static_cast<double>(bright - limit) * solidAngle);
        pixel = kept;
    });
    if (glm::length(weighted) > 0) sun.direction = glm::normalize(weighted);
    return sun;
}

SkyLight filterSky(const SkyImage& image, double rotationDeg, double intensity) {
    SkyLight light;
    light.cube.faceSize = faceSizeFor(image);
    light.cube.mips.push_back(
        largestLevel(image, light.cube.faceSize, rotationDeg, static_cast<float>(intensity)));
    for (uint32_t size = light.cube.faceSize; size > 1; size /= 2) {
        if (size == 64) integrate(light.cube.mips.back(), size, light);
        light.cube.mips.push_back(nextLevel(light.cube.mips.back(), size));
    }
    // Only now: irradiance and coarser levels have all the light of a sun that the sky keeps.
    for (std::vector<glm::vec3>& level : light.cube.mips)
        for (glm::vec3& texel : level) texel = glm::min(texel, maxCubeRadiance);
    return light;
}

} // namespace demos
