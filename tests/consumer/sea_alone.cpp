// A server: the sea and its heights, with neither Vulkan nor FFTW in the link.
#include <seaglass/sea.h>

int main() {
    const seaglass::SeaDesc desc;
    for (const seaglass::Field& field : seaglass::fieldsOf(desc))
        if (!seaglass::isInRange(field, field.get(&desc, 0))) return 1;
    seaglass::Sea* sea = seaglass::createSea(&desc, nullptr);
    if (!sea) return 1;
    const double point[] = {12, 34};
    seaglass::HeightSample exact, onGrid;
    seaglass::sampleHeights(*sea, 100, point, 1, &exact);
    seaglass::HeightGrid* grid = seaglass::createHeightGrid(*sea, 100);
    if (!grid) return 1;
    seaglass::sampleHeights(*grid, point, 1, &onGrid);
    seaglass::destroyHeightGrid(grid);
    const float off = exact.height - onGrid.height;
    const auto most = static_cast<float>(0.05 * seaglass::significantWaveHeight(*sea));
    seaglass::destroySea(sea);
    return off < most && off > -most ? 0 : 1;
}
