#include "reference/world.h"

#include "host/passes/floor_texture.h"
#include "host/passes/fog.h"
#include "host/water/exclusion_volumes.h"
#include "host/water/extent.h"
#include "host/water/shore.h"
#include "host/water/waves.h"
#include "water/interface/checks.h"

namespace demos::reference {

bool loadWorld(const Scene& scene, World& out, Error& error) {
    std::optional<SkyImage> image = readSkyImage(scene.sky, error);
    if (!image || !makeLight(std::move(*image), scene.sky, scene.sun, out.light, error)) return false;
    if (scene.fog && !fogOf(*scene.fog, out.fog.emplace(), error)) return false;
    PlacedTriangles triangles;
    for (const MeshDesc& desc : scene.meshes) {
        auto known = out.models.find(desc.file);
        if (known == out.models.end()) {
            std::optional<Mesh> mesh = readMesh(desc.file, error);
            if (!mesh) return false;
            triangles.readFile(mesh->fileBytes);
            for (const std::string& line : mesh->leftOut)
                out.leftOut.push_back(desc.file.string() + ": " + line);
            known = out.models.emplace(desc.file, Model(std::move(*mesh))).first;
        }
        if (!triangles.place(known->second.mesh.indices.size() / 3, desc.file, error)) return false;
        Instance& instance = out.instances.emplace_back();
        instance.model = &known->second;
        const double levelM = scene.water ? scene.water->levelM : 0;
        if (!placedOf(desc, known->second.mesh, levelM, instance.placed, error)) return false;
    }
    return setFloor(scene.floor, out, error) && setWater(scene.water, out, error);
}

bool setFloor(const std::optional<FloorDesc>& desc, World& out, Error& error) {
    out.floor.reset();
    if (!desc) return true;
    const std::optional<MeshTexture> texture = readFloorTexture(*desc, error);
    if (texture) out.floor.emplace(Floor{*desc, floorPlane(*desc), Texture(*texture)});
    return texture.has_value();
}

namespace {

bool setOutline(const ExtentDesc& desc, World& out, Error& error) {
    SceneExtent extent;
    if (!extentOf(desc, extent, error)) return false;
    if (const seaglass::FieldError bad = seaglass::badField(extent.desc)) {
        error.text = std::string("water: ") + bad.text();
        return false;
    }
    out.outline = outlineOf(extent.desc);
    return true;
}

bool setExclusionVolumes(const std::vector<ExclusionVolumeDesc>& volumes, World& out, Error& error) {
    std::vector<seaglass::ExclusionVolume> read;
    if (!exclusionVolumesOf(volumes, "water.exclusion_volumes", read, error)) return false;
    if (const char* const bad = seaglass::badVolumes(read.data(), static_cast<uint32_t>(read.size()))) {
        error.text = std::string("water: ") + bad;
        return false;
    }
    for (const seaglass::ExclusionVolume& volume : read)
        out.excludedVolumes.push_back(excludedVolumeOf(volume, out.frame));
    return true;
}

void setPlane(const WaterDesc& water, World& out) {
    const auto [x, y, z, d] = waterPlane(water);
    out.frame = LevelAxes::of({x, y, z});
    out.levelM = -d;
    out.globe.curvature = water.planetRadiusM > 0 ? 1 / water.planetRadiusM : 0;
}

} // namespace

bool setWater(const std::optional<WaterDesc>& desc, World& out, Error& error) {
    out.water = desc;
    setPlane(desc.value_or(WaterDesc{}), out);
    out.light.axes = out.frame.worldFromBody;
    out.sea.reset();
    out.outline.reset();
    out.excludedVolumes.clear();
    if (desc && !setExclusionVolumes(desc->exclusionVolumes, out, error)) return false;
    if (desc && desc->extent && !setOutline(*desc->extent, out, error)) return false;
    if (!desc || !desc->waves) return true;
    SceneSea sea;
    if (!seaOf(*desc->waves, sea, error)) return false;
    SceneShore shore;
    if (desc->shore && !shoreOf(*desc->shore, waterPlane(*desc), shore, error)) return false;
    if (desc->shore) sea.desc.shore = &shore.desc;
    seaglass::SeaError problem;
    out.sea.reset(seaglass::createSea(&sea.desc, &problem));
    if (!out.sea) error.text = std::string("water: BodyDesc.waves: ") + problem.text;
    return out.sea != nullptr;
}

} // namespace demos::reference
