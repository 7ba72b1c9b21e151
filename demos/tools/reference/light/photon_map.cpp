#include "reference/light/photon_map.h"

#include <algorithm>
#include <cmath>

namespace demos::reference {
namespace {

/// A cell of a row or column of a tile.
uint32_t cellAt(double inTile, uint32_t across) {
    const double cell = std::floor(inTile / PhotonMap::side * across);
    return static_cast<uint32_t>(std::clamp(cell, 0.0, static_cast<double>(across - 1)));
}

} // namespace

double PhotonMap::radiusIn(const PhotonTile& tile) {
    // About 78 photons of even light. Nothing is seen sharper than a centimetre.
    constexpr double spacings = 5, least = 0.01;
    return std::clamp(spacings / std::sqrt(tile.density), least, side);
}

std::optional<uint32_t> PhotonMap::indexOf(const glm::i64vec2& tile) const {
    const auto found = indices_.find(tile);
    if (found == indices_.end()) return std::nullopt;
    return found->second;
}

void PhotonMap::create(std::vector<PhotonTile> tiles, const std::vector<std::vector<Photon>>& photons) {
    tiles_ = std::move(tiles);
    indices_.clear();
    cells_.clear();
    size_t cells = 0;
    for (const PhotonTile& tile : tiles_) {
        indices_.emplace(tile.at, static_cast<uint32_t>(indices_.size()));
        const auto across = static_cast<uint32_t>(side / radiusIn(tile));
        cells_.push_back({cells, across});
        cells += size_t{across} * across;
    }
    const auto cellOf = [&](const Photon& photon) -> std::optional<size_t> {
        const std::optional<uint32_t> index = indexOf(tileAt(photon.at));
        if (!index) return std::nullopt;
        const glm::dvec2 inTile = photon.at - glm::dvec2(tiles_[*index].at) * side;
        const Cells& in = cells_[*index];
        return in.first + size_t{cellAt(inTile.y, in.across)} * in.across + cellAt(inTile.x, in.across);
    };
    // In the order that they came in, cell by cell.
    starts_.assign(cells + 1, 0);
    for (const std::vector<Photon>& some : photons)
        for (const Photon& photon : some)
            if (const std::optional<size_t> cell = cellOf(photon)) ++starts_[*cell + 1];
    for (size_t i = 0; i < cells; ++i) starts_[i + 1] += starts_[i];
    kept_.resize(starts_.back());
    std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
    for (const std::vector<Photon>& some : photons)
        for (const Photon& photon : some)
            if (const std::optional<size_t> cell = cellOf(photon))
                kept_[next[*cell]++] = {glm::vec2(photon.at - glm::dvec2(tileAt(photon.at)) * side),
                                        photon.along, photon.area};
}

std::optional<float> PhotonMap::gainAt(const glm::dvec2& at, float along, float blur, float steepness) const {
    const glm::i64vec2 home = tileAt(at);
    const std::optional<uint32_t> index = indexOf(home);
    if (!index || !tiles_[*index].known) return std::nullopt;
    const double radius = std::clamp(static_cast<double>(blur), radiusIn(tiles_[*index]), side);
    const auto squared = static_cast<float>(radius * radius);
    const float from = along - static_cast<float>(radius) * (0.5f + steepness);
    const glm::i64vec2 low = tileAt(at - radius), high = tileAt(at + radius);
    float sum = 0;
    for (int64_t y = low.y; y <= high.y; ++y)
        for (int64_t x = low.x; x <= high.x; ++x) {
            const std::optional<uint32_t> tile = indexOf({x, y});
            if (!tile) continue;
            const glm::dvec2 here = at - glm::dvec2(x, y) * side;
            const Cells& in = cells_[*tile];
            const uint32_t left = cellAt(here.x - radius, in.across),
                           right = cellAt(here.x + radius, in.across);
            const uint32_t bottom = cellAt(here.y + radius, in.across);
            for (uint32_t row = cellAt(here.y - radius, in.across); row <= bottom; ++row) {
                const size_t first = in.first + size_t{row} * in.across;
                for (size_t i = starts_[first + left]; i < starts_[first + right + 1]; ++i) {
                    const glm::vec2 apart = kept_[i].at - glm::vec2(here);
                    const float distance = glm::dot(apart, apart);
                    // Epanechnikov's kernel.
                    if (distance < squared && kept_[i].along >= from)
                        sum += kept_[i].area * (squared - distance);
                }
            }
        }
    constexpr float pi = 3.14159265f;
    return sum * 2 / (pi * squared * squared);
}

} // namespace demos::reference
