// As textures/sky/atmosphere.py makes the skies in textures/. Lengths in metres; 680, 550 and 440 nm are
// taken as red, green and blue.
#include "host/passes/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <OpenImageIO/parallel.h>

namespace demos {

namespace {

using glm::dvec3;

constexpr double pi = std::numbers::pi;
constexpr double earth = 6360e3, top = 100e3, eyeHeight = 2;
constexpr double ordersTop = 60e3; ///< of the table of higher orders
constexpr double groundAlbedo = 0.15, mieAsymmetry = 0.78;
const dvec3 rayleighScattering = dvec3(5.802, 13.558, 33.1) * 1e-6;
const dvec3 ozoneAbsorption = dvec3(0.650, 1.881, 0.085) * 1e-6;
/// Five times those of Hillaire, whose air is cleaner than any sea's: an optical depth of 0.027, 0.05 of a
/// clear day.
constexpr double mieScattering = 5 * 3.996e-6, mieExtinction = 5 * 4.44e-6;
/// Of the sun outside the air, in the scale of the skies in textures/: their noon has a sun of 15.
constexpr double sunOutside = 17.5;
/// What lies below the haze of the horizon, as a share of its light.
const dvec3 ground(0.12, 0.15, 0.17);
constexpr uint32_t width = 1024, height = 512;

/// Of values over 0 to 1 in both directions; bilinear.
class Table {
  public:
    Table(size_t rows, size_t columns) : rows_(rows), columns_(columns), values_(rows * columns) {}
    size_t rows() const { return rows_; }
    size_t columns() const { return columns_; }
    double row(size_t i) const { return static_cast<double>(i) / static_cast<double>(rows_ - 1); }
    double column(size_t j) const { return static_cast<double>(j) / static_cast<double>(columns_ - 1); }
    dvec3& at(size_t i, size_t j) { return values_[i * columns_ + j]; }
    dvec3 look(double u, double v) const {
        const double x = std::clamp(u, 0.0, 1.0) * static_cast<double>(rows_ - 1);
        const double y = std::clamp(v, 0.0, 1.0) * static_cast<double>(columns_ - 1);
        const size_t i = std::min(static_cast<size_t>(x), rows_ - 2);
        const size_t j = std::min(static_cast<size_t>(y), columns_ - 2);
        const dvec3* const low = &values_[i * columns_ + j];
        const double across = y - static_cast<double>(j);
        return glm::mix(glm::mix(low[0], low[1], across), glm::mix(low[columns_], low[columns_ + 1], across),
                        x - static_cast<double>(i));
    }

  private:
    size_t rows_, columns_;
    std::vector<dvec3> values_;
};

/// What of the light is scattered and lost in a metre.
struct Medium {
    dvec3 rayleigh;
    double mie;
    dvec3 extinction;
    dvec3 scattering() const { return rayleigh + mie; }
};

/// Radiance without the phase functions of the first order.
struct Scattered {
    dvec3 rayleigh{0}, mie{0}, orders{0};
};

class Atmosphere {
  public:
    explicit Atmosphere(double haze) : haze_(haze) {
        tabulateTransmittance();
        tabulateOrders();
    }

    /// From a height to space, in a direction of that cosine to the vertical.
    dvec3 transmittance(double above, double cosine) const {
        return transmittance_.look(std::sqrt(std::max(above, 0.0) / top), (cosine + 0.25) / 1.25);
    }

    /// Towards an elevation's sine; the sun's own, and its cosine to what is looked at.
    Scattered seen(double sine, double sunSine, double sunCosine) const {
        constexpr int steps = 40;
        const double r = earth + eyeHeight;
        const double reach = -r * sine + std::sqrt((earth + top) * (earth + top) - r * r * (1 - sine * sine));
        Scattered sum;
        dvec3 through(1);
        for (int i = 0; i < steps; ++i) {
            const double near = square(double(i) / steps), far = square((i + 1.0) / steps);
            const double t = reach * (near + far) / 2;
            const double rt = std::sqrt(r * r + t * t + 2 * r * sine * t);
            const double local = std::clamp((r * sunSine + t * sunCosine) / rt, -1.0, 1.0);
            const Medium air = mediumAt(rt - earth);
            const dvec3 step = glm::exp(-air.extinction * (reach * (far - near)));
            const dvec3 gained = through * (1.0 - step) / glm::max(air.extinction, 1e-12);
            const dvec3 lit = gained * transmittance(rt - earth, local);
            sum.rayleigh += lit * air.rayleigh;
            sum.mie += lit * air.mie;
            sum.orders += gained * air.scattering() * ordersAt(rt - earth, local);
            through *= step;
        }
        return sum;
    }

  private:
    static double square(double x) { return x * x; }

    Medium mediumAt(double above) const {
        const double h = std::max(above, 0.0);
        const double aerosols = haze_ * std::exp(-h / 1200);
        Medium air{std::exp(-h / 8000) * rayleighScattering, mieScattering * aerosols, {}};
        air.extinction = air.rayleigh + mieExtinction * aerosols +
                         std::max(0.0, 1 - std::abs(h - 25e3) / 15e3) * ozoneAbsorption;
        return air;
    }

    dvec3 ordersAt(double above, double sunSine) const {
        return orders_.look(std::sqrt(std::max(above, 0.0) / ordersTop), (sunSine + 0.2) / 1.2);
    }

    void tabulateTransmittance() {
        constexpr int steps = 48;
        for (size_t i = 0; i < transmittance_.rows(); ++i)
            for (size_t j = 0; j < transmittance_.columns(); ++j) {
                const double r = earth + top * square(transmittance_.row(i));
                const double mu = 1.25 * transmittance_.column(j) - 0.25;
                const double aside = r * r * (1 - mu * mu);
                if (mu < 0 && aside < earth * earth) continue; // the ground is in the way
                const double reach = -r * mu + std::sqrt(std::max(square(earth + top) - aside, 0.0));
                dvec3 depth(0);
                for (int k = 0; k < steps; ++k) {
                    const double near = std::pow(double(k) / steps, 1.6),
                                 far = std::pow((k + 1.0) / steps, 1.6);
                    const double t = reach * (near + far) / 2;
                    depth += mediumAt(std::sqrt(r * r + t * t + 2 * r * mu * t) - earth).extinction *
                             (reach * (far - near));
                }
                transmittance_.at(i, j) = glm::exp(-depth);
            }
    }

    /// What one direction sends, and how much of what is all around it would scatter on: of light that is
    /// scattered by no phase function.
    void addDirection(double r, double sunSine, double mu, double phi, dvec3& light, dvec3& again) const {
        constexpr int steps = 20;
        const double disc = earth * earth - r * r * (1 - mu * mu);
        const bool down = disc > 0 && mu < 0;
        const double reach = down ? -r * mu - std::sqrt(disc)
                                  : -r * mu + std::sqrt(square(earth + top) - r * r * (1 - mu * mu));
        const double sunward = mu * sunSine + std::sqrt(1 - mu * mu) *
                                                  std::sqrt(std::max(1 - sunSine * sunSine, 0.0)) *
                                                  std::cos(phi);
        dvec3 through(1);
        for (int k = 0; k < steps; ++k) {
            const double t = (k + 0.5) * reach / steps;
            const double rt = std::sqrt(r * r + t * t + 2 * r * mu * t);
            const Medium air = mediumAt(rt - earth);
            const dvec3 step = glm::exp(-air.extinction * (reach / steps));
            const dvec3 gained = through * (1.0 - step) / glm::max(air.extinction, 1e-12) * air.scattering();
            const double local = std::clamp((r * sunSine + t * sunward) / rt, -1.0, 1.0);
            light += gained * transmittance(rt - earth, local) / (4 * pi);
            again += gained;
            through *= step;
        }
        if (!down) return;
        const double local = std::clamp((r * sunSine + reach * sunward) / earth, -1.0, 1.0);
        light += through * transmittance(0, local) * (std::max(local, 0.0) * groundAlbedo / pi);
    }

    void tabulateOrders() {
        constexpr int side = 8;
        OIIO::parallel_for(int64_t(0), int64_t(orders_.rows()), [&](int64_t row) {
            const auto i = static_cast<size_t>(row);
            for (size_t j = 0; j < orders_.columns(); ++j) {
                dvec3 light(0), again(0);
                for (int v = 0; v < side; ++v)
                    for (int u = 0; u < side; ++u)
                        addDirection(earth + ordersTop * square(orders_.row(i)) + 1,
                                     1.2 * orders_.column(j) - 0.2, 1 - 2 * (v + 0.5) / side,
                                     2 * pi * (u + 0.5) / side, light, again);
                orders_.at(i, j) = light / (double(side * side) - again);
            }
        });
    }

    double haze_;
    Table transmittance_{48, 256}, orders_{20, 28};
};

double rayleighPhase(double cosine) {
    return 3 / (16 * pi) * (1 + cosine * cosine);
}

/// Cornette and Shanks 1992.
double hazePhase(double cosine) {
    constexpr double g = mieAsymmetry;
    return 3 / (8 * pi) * (1 - g * g) * (1 + cosine * cosine) /
           ((2 + g * g) * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

/// Between the horizon and straight up, denser below; and from the sun around to the other side.
struct SkyTables {
    Table rayleigh{112, 40}, mie{112, 40}, orders{112, 40};

    SkyTables(const Atmosphere& air, double sunElevation) {
        const double sunSine = std::sin(sunElevation), sunLevel = std::cos(sunElevation);
        OIIO::parallel_for(int64_t(0), int64_t(rayleigh.rows()), [&](int64_t row) {
            const auto i = static_cast<size_t>(row);
            const double up = rayleigh.row(i), elevation = pi / 2 * up * up;
            for (size_t j = 0; j < rayleigh.columns(); ++j) {
                const double around = std::cos(pi * rayleigh.column(j));
                const double sine = std::sin(elevation);
                const Scattered light =
                    air.seen(sine, sunSine, sine * sunSine + std::cos(elevation) * sunLevel * around);
                rayleigh.at(i, j) = light.rayleigh;
                mie.at(i, j) = light.mie;
                orders.at(i, j) = light.orders;
            }
        });
    }

    dvec3 look(double elevation, double around, double sunCosine) const {
        const double up = std::sqrt(elevation / (pi / 2));
        const double aside = std::acos(std::clamp(around, -1.0, 1.0)) / pi;
        return rayleigh.look(up, aside) * rayleighPhase(sunCosine) +
               mie.look(up, aside) * hazePhase(sunCosine) + orders.look(up, aside);
    }
};

/// The horizon's light, which fades downwards into haze and then into what lies there.
dvec3 below(const dvec3& horizon, double down) {
    const double degrees = down * 180 / pi, fade = std::exp(-degrees / 5);
    return horizon * (fade + (1 - fade) * ground);
}

} // namespace

ClearSky clearSky(double sunAzimuth, double sunElevation, double haze) {
    const Atmosphere air(haze);
    const SkyTables tables(air, sunElevation);
    ClearSky sky;
    sky.sunIrradiance = sunOutside * air.transmittance(eyeHeight, std::sin(sunElevation));
    sky.image = {width, height, std::vector<glm::vec3>(size_t{width} * height)};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const double elevation = pi / 2 - pi * (y + 0.5) / height, up = std::max(elevation, 0.0);
            const double around = std::cos(2 * pi * (x + 0.5) / width - sunAzimuth);
            const double sunCosine =
                std::sin(up) * std::sin(sunElevation) + std::cos(up) * std::cos(sunElevation) * around;
            const dvec3 seen = sunOutside * tables.look(up, around, std::clamp(sunCosine, -1.0, 1.0));
            sky.image.radiance[size_t{y} * width + x] =
                glm::vec3(elevation < 0 ? below(seen, -elevation) : seen);
        }
    return sky;
}

} // namespace demos
