// Photons of parallel light that something has bent about, counted where their beams cross a level plane.
//
// A photon is kept by where the beam that nothing bent, through the place that it fell on, crosses the plane.
// In those places even light is even, whatever it falls on, so that photons around one tell how much of it
// there is at the edges of things and along walls too. What fell on something before the place that is asked
// about never came as far; what fell on something behind it did.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>

namespace demos::reference {

struct Photon {
    glm::dvec2 at{0}; ///< on the plane [m]
    float along = 0;  ///< from there down the beam [m]
    float area = 0;   ///< of the plane that brings as much in even light [m^2]
};

/// A square of the plane.
struct PhotonTile {
    glm::i64vec2 at{0}; ///< its corner, in sides
    double density = 0; ///< of the photons that cross it [1/m^2]
    bool known = false; ///< photons are followed from all about it, as far as light wanders
};

class PhotonMap {
  public:
    static constexpr double side = 0.5; ///< of a tile [m]
    static glm::i64vec2 tileAt(const glm::dvec2& at) { return glm::i64vec2(glm::floor(at / side)); }
    /// How far around a point of a tile photons count, at the least [m].
    static double radiusIn(const PhotonTile& tile);

    /// Keeps the photons that lie in the tiles, which no two share a place.
    void create(std::vector<PhotonTile> tiles, const std::vector<std::vector<Photon>>& photons);

    /// The light in the beam through a point of the plane, as a share of even light, where it meets a surface
    /// `along` metres down that drops `steepness` metres along the beam for each across the plane. Nothing
    /// where the tile is not known.
    std::optional<float> gainAt(const glm::dvec2& at, float along, float blur, float steepness) const;

  private:
    struct Kept {
        glm::vec2 at{0}; ///< from the tile's corner
        float along = 0, area = 0;
    };
    struct Cells {
        size_t first = 0;
        uint32_t across = 1;
    };
    std::optional<uint32_t> indexOf(const glm::i64vec2& tile) const;

    struct Hash {
        size_t operator()(const glm::i64vec2& at) const {
            return static_cast<size_t>(at.x) * 0x9e3779b97f4a7c15U ^ static_cast<size_t>(at.y);
        }
    };
    std::unordered_map<glm::i64vec2, uint32_t, Hash> indices_;
    std::vector<PhotonTile> tiles_;
    std::vector<Cells> cells_;   ///< by tile
    std::vector<size_t> starts_; ///< by cell, and the end
    std::vector<Kept> kept_;     ///< cell by cell
};

} // namespace demos::reference
