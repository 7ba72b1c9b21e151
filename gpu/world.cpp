#include "seaglass/world.h"

namespace seaglass {

void directionFrom(const World& world, const double (&host)[3], double (&out)[3]) {
    const double x = host[0], y = host[1], z = host[2];
    const double handed = world.leftHanded ? -1 : 1;
    const bool zIsUp = world.up == WorldUp::z;
    const double upwards = world.up == WorldUp::minusY ? -1 : 1;
    out[0] = x;
    out[1] = zIsUp ? z : upwards * y;
    out[2] = zIsUp ? -handed * y : upwards * handed * z;
}

void pointFrom(const World& world, const double (&host)[3], double (&out)[3]) {
    directionFrom(world, host, out);
    for (double& value : out) value /= world.unitsPerMetre;
}

void planeFrom(const World& world, const double (&host)[4], double (&out)[4]) {
    const double normal[3] = {host[0], host[1], host[2]};
    double turned[3];
    directionFrom(world, normal, turned);
    for (int i = 0; i < 3; ++i) out[i] = turned[i];
    out[3] = host[3] / world.unitsPerMetre;
}

namespace {

/// A matrix that takes the host's points, to one that takes Seaglass's.
void matrixFrom(const World& world, const double (&host)[16], double (&out)[16]) {
    double turned[16];
    for (int row = 0; row < 4; ++row) {
        // A row is a direction's coefficients, and turns as one does.
        const double linear[3] = {host[row], host[4 + row], host[8 + row]};
        double coefficients[3];
        directionFrom(world, linear, coefficients);
        for (int i = 0; i < 3; ++i) turned[4 * i + row] = world.unitsPerMetre * coefficients[i];
        turned[12 + row] = host[12 + row];
    }
    for (int i = 0; i < 16; ++i) out[i] = turned[i];
}

/// Of lengths `scale` times as long. w stays the distance ahead, or 1 by parallel sight.
void scaleProjection(double (&projection)[16], double scale) {
    const bool parallel = projection[3] == 0 && projection[7] == 0 && projection[11] == 0;
    for (int i = 0; i < 12; ++i) projection[i] *= parallel ? 1 / scale : 1;
    for (int i = 12; i < 16; ++i) projection[i] *= parallel ? 1 : scale;
}

} // namespace

void worldFrom(const World& world, ViewDesc* view) {
    double turned[16];
    matrixFrom(world, view->view, turned);
    // The view's space comes to metres too: what its matrix loses the projection gains.
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            view->view[4 * column + row] = turned[4 * column + row] / world.unitsPerMetre;
    scaleProjection(view->projection, 1 / world.unitsPerMetre);
    if (!world.sightAlongZ) return;
    for (int i = 2; i < 16; i += 4) view->view[i] *= -1;
    for (int i = 8; i < 12; ++i) view->projection[i] *= -1;
}

void worldFrom(const World& world, LightingDesc* lighting, SunShadow* shadow) {
    const double toSun[3] = {lighting->toSun[0], lighting->toSun[1], lighting->toSun[2]};
    directionFrom(world, toSun, lighting->toSun);
    if (!shadow) return;
    for (auto& cascade : shadow->textureFromWorld) {
        double host[16];
        for (int i = 0; i < 16; ++i) host[i] = cascade[i];
        matrixFrom(world, host, cascade);
    }
}

void pointTo(const World& world, const double (&point)[3], double (&host)[3]) {
    // Its axes are the columns of a matrix whose inverse is its transpose.
    for (int axis = 0; axis < 3; ++axis) {
        const double unit[3] = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
        double column[3];
        directionFrom(world, unit, column);
        host[axis] =
            world.unitsPerMetre * (column[0] * point[0] + column[1] * point[1] + column[2] * point[2]);
    }
}

void worldTo(const World& world, const double (&turnedView)[16], const double (&turnedProjection)[16],
             double (&view)[16], double (&projection)[16]) {
    for (int row = 0; row < 4; ++row) {
        const double linear[3] = {turnedView[row], turnedView[4 + row], turnedView[8 + row]};
        const World turnsOnly = {world.up, world.leftHanded, 1, false};
        double host[3];
        pointTo(turnsOnly, linear, host);
        for (int i = 0; i < 3; ++i) view[4 * i + row] = host[i];
        view[12 + row] = turnedView[12 + row] * (row < 3 ? world.unitsPerMetre : 1);
    }
    for (int i = 0; i < 16; ++i) projection[i] = turnedProjection[i];
    scaleProjection(projection, world.unitsPerMetre);
    if (!world.sightAlongZ) return;
    for (int i = 2; i < 16; i += 4) view[i] *= -1;
    for (int i = 8; i < 12; ++i) projection[i] *= -1;
}

} // namespace seaglass
