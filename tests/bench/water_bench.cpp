// What a scene's water costs on this device, whole and by quality and with a part left out: multiples of a
// trivial pass (a full-screen triangle that copies the frame's colour) and of the floor (a compute copy of
// the frame's colour and depth). All take turns, medians over the rounds: of timestamps in whole frames, or
// on CPU devices of what this process had of the processors, over the same picture of the scene.
//
//   seaglass_bench_water SCENE [WIDTHxHEIGHT [ROUNDS [CAMERA [PATH=VALUE...]]]]
#include <cstdio>
#include <cstdlib>

#include "host/host.h"
#include "host/water/quality.h"
#include "scene/camera_choice.h"
#include "scene/offset.h"
#include "scene/without.h"

namespace {

using namespace demos;

[[noreturn]] void stop(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

struct Part {
    const char* name;
    void (*change)(WaterDesc&);
};

constexpr Part parts[] = {
    {"whole", [](WaterDesc&) {}},
    {"low", [](WaterDesc& water) { setQuality("low", water); }},
    {"medium", [](WaterDesc& water) { setQuality("medium", water); }},
    {"high", [](WaterDesc& water) { setQuality("high", water); }},
    {"highest", [](WaterDesc& water) { setQuality("highest", water); }},
    {"Schlick", [](WaterDesc& water) { water.shading.fresnel = seaglass::Fresnel::schlick; }},
    {"no shafts",
     [](WaterDesc& water) {
         if (water.underwater) water.underwater->shafts = 0;
     }},
    {"no shafts, no snow", takeUntraced},
    {"no spray", [](WaterDesc& water) { water.spray.reset(); }},
    {"no foam", [](WaterDesc& water) { water.foam.reset(), water.spray.reset(); }},
    {"no refraction", takeRefraction},
    {"sky alone", [](WaterDesc& water) { water.reflection.reset(); }},
    {"no caustics", [](WaterDesc& water) { water.caustics.reset(); }},
    {"still", takeWaves},
    {"still, opaque", [](WaterDesc& water) { takeRefraction(water), takeWaves(water); }},
    {"medium, still, opaque",
     [](WaterDesc& water) { setQuality("medium", water), takeRefraction(water), takeWaves(water); }},
    {"still, sky alone, opaque",
     [](WaterDesc& water) { takeRefraction(water), takeWaves(water), water.reflection.reset(); }},
};

void print(const char* name, const SurfaceTimes& times, const ComparedTimes& all) {
    const double sum = times.surfaceMs();
    std::string shares;
    for (const PassTime& pass : times.surfacePasses()) {
        char text[64];
        std::snprintf(text, sizeof text, "  %s %.2f", pass.name.c_str(), pass.ms / all.yardsticks.floor.ms);
        shares += text;
    }
    std::printf("%-26s %6.2f x trivial, %6.2f x floor:%s\n", name, sum / all.yardsticks.fullScreen.ms,
                sum / all.yardsticks.floor.ms, shares.c_str());
}

} // namespace

int main(int count, char** arguments) {
    if (count < 2) stop("expected SCENE [WIDTHxHEIGHT [ROUNDS [CAMERA [PATH=VALUE...]]]]");
    FrameDesc frame;
    if (count > 2 && std::sscanf(arguments[2], "%ux%u", &frame.width, &frame.height) != 2)
        stop("expected WIDTHxHEIGHT");
    const auto rounds = static_cast<uint32_t>(count > 3 ? std::atoi(arguments[3]) : 5);
    Error error;
    const std::vector<std::string> overrides(arguments + std::min(count, 5), arguments + count);
    std::optional<Scene> scene = loadScene(arguments[1], overrides, error);
    if (!scene) stop(error.text);
    if (!scene->water) stop("the scene has no water");
    std::optional<CameraDesc> camera = chooseCamera(*scene, count > 4 ? arguments[4] : "", error);
    if (!camera) stop(error.text);
    applyOffset(*scene, *camera);
    frame.camera = *camera;
    frame.timeS = scene->timeS;

    HostDesc desc;
    desc.clock = PassClock::processor;
    const std::unique_ptr<Host> host = Host::create(desc, error);
    if (!host || !host->load(*scene, error)) stop(error.text);
    for (const Part& part : parts) {
        WaterDesc water = *scene->water;
        part.change(water);
        if (&part != parts && !host->addSurface(water, error)) stop(error.text);
    }
    const std::optional<ComparedTimes> times = host->measureSurfaces(frame, rounds, {}, error);
    if (!times) stop(error.text);
    std::printf("%s, %s, %ux%u, by %s: floor %.3f ms, trivial pass %.3f\n", host->device().name.c_str(),
                frame.camera.name.c_str(), frame.width, frame.height, describe(host->clock()),
                times->yardsticks.floor.ms, times->yardsticks.fullScreen.ms);
    for (size_t i = 0; i < std::size(parts); ++i) print(parts[i].name, times->surfaces[i], *times);
    return 0;
}
