// A scene's polished floor as plain data.
#pragma once

#include <optional>

#include "scene/surroundings.h"
#include "seaglass/reflection.h"

namespace demos {

/// A polished floor, or a mirror: a rectangle of a plane, seen from its front alone.
struct FloorDesc {
    Vec3 pointM = {0, 0, 0};       ///< its middle
    Vec3 normal = {0, 1, 0};       ///< towards its front, of any length
    double widthM = 20;            ///< along +X if it is level, else along the horizontal
    double lengthM = 20;           ///< across that
    Vec3 color = {0.5, 0.5, 0.5};  ///< diffuse reflectance; scales the texture's
    std::filesystem::path texture; ///< PNG, absolute, or empty; its alpha says how polished each spot is
    double textureM = 2;           ///< what one repeat of the texture covers
    double reflectance = 0.04;     ///< of the mirror, seen straight on: Schlick's F0
    double roughness = 0;          ///< square root of GGX's alpha; 0: a mirror
    std::optional<seaglass::ReflectionDesc> reflection;
    std::string where = {}; ///< of `texture` in the scene, for errors: "floor.toml:21: floor.texture"
};

} // namespace demos
