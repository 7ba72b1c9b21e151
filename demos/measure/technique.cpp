#include "measure/technique.h"

namespace demos::measure {

std::span<const Technique> techniques() {
    static const Technique all[] = {
        {"none", "default", {}, Answers::sky, false},
        {"sky", "default", {"water.reflection.technique=sky"}, Answers::sky},
        {"sspr", "default", {"water.reflection.technique=sspr"}, Answers::classes},
    };
    return all;
}

std::optional<std::vector<Variant>> variantsOf(const std::filesystem::path& file, Error& error) {
    std::optional<Scene> plain = loadScene(file, {}, error);
    if (!plain) return std::nullopt;
    // An override of the water's reflection would give it some.
    if (!plain->water) {
        error.text = file.string() + ": has no water, expected [water]";
        return std::nullopt;
    }
    std::vector<Variant> variants;
    for (const Technique& technique : techniques()) {
        std::optional<Scene> scene = loadScene(file, technique.overrides, error);
        if (!scene) return std::nullopt;
        // No override takes a part away.
        if (!technique.part) scene->water->reflection.reset();
        variants.push_back({&technique, file.string(), std::move(*scene)});
    }
    return variants;
}

} // namespace demos::measure
