#include "host/gltf/materials.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/input_limits.h"

namespace demos::gltf {
namespace {

constexpr const char* specularGlossiness = "KHR_materials_pbrSpecularGlossiness";

float factor(double value) {
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

/// Extensions of materials that change nothing while each of these members is this, or missing.
struct Neutral {
    const char *extension, *member;
    double value;
};
constexpr Neutral neutrals[] = {
    {"KHR_materials_anisotropy", "anisotropyStrength", 0},
    {"KHR_materials_clearcoat", "clearcoatFactor", 0},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionFactor", 0},
    {"KHR_materials_dispersion", "dispersion", 0},
    {"KHR_materials_ior", "ior", 1.5},
    {"KHR_materials_iridescence", "iridescenceFactor", 0},
    {"KHR_materials_sheen", "sheenColorFactor", 0},
    {"KHR_materials_specular", "specularFactor", 1},
    {"KHR_materials_specular", "specularColorFactor", 1},
    {"KHR_materials_transmission", "transmissionFactor", 0},
    {"KHR_materials_volume", "thicknessFactor", 0},
};

bool isAll(const Json& value, double number) {
    if (value.is_number()) return value.get<double>() == number;
    return value.is_null() ||
           (value.is_array() && std::all_of(value.begin(), value.end(), [&](const Json& v) {
                return v.is_number() && v.get<double>() == number;
            }));
}

bool isNeutral(const std::string& name, const Json& value) {
    bool known = false;
    for (const Neutral& neutral : neutrals) {
        if (name != neutral.extension) continue;
        known = true;
        if (!isAll(member(value, neutral.member), neutral.value)) return false;
    }
    return known && member(value, "specularTexture").is_null() &&
           member(value, "specularColorTexture").is_null();
}

constexpr size_t repeat = 10497, clampToEdge = 33071, mirroredRepeat = 33648;

Wrap wrapOf(size_t mode) {
    return mode == clampToEdge ? Wrap::clamp : mode == mirroredRepeat ? Wrap::mirror : Wrap::repeat;
}

} // namespace

struct Materials::Source {
    const Json& json;
    std::string where;
    UvMappings& mappings;
};

bool Materials::create(const Document& document, Buffers& buffers, Notes& notes, Mesh& mesh, Error& error) {
    document_ = &document;
    buffers_ = &buffers;
    notes_ = &notes;
    mesh_ = &mesh;
    const size_t count = document.count("materials");
    if (count > limits::gltfMaterials) {
        error.text = "has over 1024 materials";
        return false;
    }
    mesh.materials.resize(count + 1);
    mappings_.resize(count + 1);
    read_.resize(count, false);
    return true;
}

bool Materials::use(std::optional<size_t> material, uint32_t& out, Error& error) {
    out = static_cast<uint32_t>(material.value_or(read_.size()));
    if (!material || read_[*material]) return true;
    read_[*material] = true;
    return read(*material, error);
}

bool Materials::read(size_t index, Error& error) {
    const Json& json = document_->at("materials", index);
    const Source source{json, placeOf("materials", index, json), mappings_[index]};
    MeshMaterial material;
    material.doubleSided = isTrue(json, "doubleSided");
    material.unlit = !extension(json, "KHR_materials_unlit").is_null();
    const bool glossy = !material.unlit && !extension(json, specularGlossiness).is_null();
    if (!(glossy ? readSpecularGlossiness(source, material, error)
                 : readMetallicRoughness(source, material, error)) ||
        !(material.unlit || readLight(source, material, error)) || !readAlpha(source, material, error))
        return false;
    noteExtensions(source);

    const auto& textures = material.textures;
    const auto first = std::find_if(textures.begin(), textures.end(), [](const auto& t) { return t; });
    if (first != textures.end()) {
        const UvMapping usual = source.mappings[static_cast<size_t>(first - textures.begin())];
        for (size_t slot = 0; slot < textureSlots; ++slot) {
            if (!textures[slot]) source.mappings[slot] = usual;
            material.otherUvs = material.otherUvs || source.mappings[slot] != usual;
        }
    }
    mesh_->materials[index] = material;
    return true;
}

bool Materials::readMetallicRoughness(const Source& source, MeshMaterial& material, Error& error) {
    const Json& pbr = member(source.json, "pbrMetallicRoughness");
    double base[4] = {1, 1, 1, 1}, metallic = 1, roughness = 1;
    if (!readNumbers(pbr, "baseColorFactor", source.where, base, error) ||
        !readNumbers(pbr, "metallicFactor", source.where, {&metallic, 1}, error) ||
        !readNumbers(pbr, "roughnessFactor", source.where, {&roughness, 1}, error))
        return false;
    for (int i = 0; i < 4; ++i) material.baseColor[i] = factor(base[i]);
    material.metallic = factor(metallic);
    material.roughness = factor(roughness);
    return readSlot(source, pbr, "baseColorTexture", baseSlot, true, material, error) &&
           (material.unlit ||
            readSlot(source, pbr, "metallicRoughnessTexture", surfaceSlot, false, material, error));
}

bool Materials::readSpecularGlossiness(const Source& source, MeshMaterial& material, Error& error) {
    const Json& pbr = extension(source.json, specularGlossiness);
    double diffuse[4] = {1, 1, 1, 1}, specular[3] = {1, 1, 1}, glossiness = 1;
    if (!readNumbers(pbr, "diffuseFactor", source.where, diffuse, error) ||
        !readNumbers(pbr, "specularFactor", source.where, specular, error) ||
        !readNumbers(pbr, "glossinessFactor", source.where, {&glossiness, 1}, error))
        return false;
    for (int i = 0; i < 4; ++i) material.baseColor[i] = factor(diffuse[i]);
    material.specular = glm::vec3(factor(specular[0]), factor(specular[1]), factor(specular[2]));
    material.metallic = 0;
    material.roughness = 1 - factor(glossiness);
    return readSlot(source, pbr, "diffuseTexture", baseSlot, true, material, error) &&
           readSlot(source, pbr, "specularGlossinessTexture", surfaceSlot, true, material, error);
}

bool Materials::readLight(const Source& source, MeshMaterial& material, Error& error) {
    double emissive[3] = {0, 0, 0}, strength = 1, normalScale = 1, occlusion = 1;
    const Json &normal = member(source.json, "normalTexture"),
               &occluded = member(source.json, "occlusionTexture");
    if (!readNumbers(source.json, "emissiveFactor", source.where, emissive, error) ||
        !readNumbers(extension(source.json, "KHR_materials_emissive_strength"), "emissiveStrength",
                     source.where, {&strength, 1}, error) ||
        !readNumbers(normal, "scale", source.where + ".normalTexture", {&normalScale, 1}, error) ||
        !readNumbers(occluded, "strength", source.where + ".occlusionTexture", {&occlusion, 1}, error))
        return false;
    for (int i = 0; i < 3; ++i)
        material.emissive[i] = factor(emissive[i]) * static_cast<float>(std::clamp(strength, 0.0, 1e6));
    material.normalScale = static_cast<float>(std::clamp(normalScale, -100.0, 100.0));
    material.occlusion = factor(occlusion);
    const bool shines = material.emissive != glm::vec3(0);
    return (!shines ||
            readSlot(source, source.json, "emissiveTexture", emissiveSlot, true, material, error)) &&
           readSlot(source, source.json, "normalTexture", normalSlot, false, material, error) &&
           readSlot(source, source.json, "occlusionTexture", occlusionSlot, false, material, error);
}

bool Materials::readAlpha(const Source& source, MeshMaterial& material, Error& error) {
    const Json& stated = member(source.json, "alphaMode");
    const std::string& mode = textOf(source.json, "alphaMode");
    double cutoff = 0.5;
    if (!stated.is_null() && mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        notes_->add(source.where, "its alphaMode is " + (mode.empty() ? "no text" : quoted(mode)) +
                                      ", expected OPAQUE, MASK or BLEND: it is drawn opaque");
    if (!readNumbers(source.json, "alphaCutoff", source.where, {&cutoff, 1}, error)) return false;
    if (mode == "MASK") material.alphaCutoff = static_cast<float>(std::clamp(cutoff, 1e-3, 1e3));
    material.blends = mode == "BLEND";
    return true;
}

bool Materials::readSlot(const Source& source, const Json& parent, const char* key, TextureSlot slot,
                         bool srgb, MeshMaterial& material, Error& error) {
    const Json& info = member(parent, key);
    if (info.is_null()) return true;
    const std::string where = source.where + "." + key;
    std::optional<size_t> index;
    if (!readIndex(info, "index", document_->count("textures"), where, index, error) ||
        !readMapping(info, where, source.mappings[slot], error))
        return false;
    notes_->addExtensions(where, info, {"KHR_texture_transform"});
    return !index || readTexture(*index, srgb, where, material.textures[slot], error);
}

bool Materials::readMapping(const Json& info, const std::string& where, UvMapping& out, Error& error) {
    const Json& transform = extension(info, "KHR_texture_transform");
    double offset[2] = {0, 0}, scale[2] = {1, 1}, rotation = 0;
    if (!readCount(info, "texCoord", where, out.set, error) ||
        !readCount(transform, "texCoord", where, out.set, error) ||
        !readNumbers(transform, "offset", where, offset, error) ||
        !readNumbers(transform, "scale", where, scale, error) ||
        !readNumbers(transform, "rotation", where, {&rotation, 1}, error))
        return false;
    const double c = std::cos(rotation), s = std::sin(rotation);
    // Counter-clockwise as a person sees an image whose v runs down.
    out.turn = glm::dmat2(glm::dvec2(c, -s) * scale[0], glm::dvec2(s, c) * scale[1]);
    out.offset = {offset[0], offset[1]};
    return true;
}

bool Materials::readTexture(size_t index, bool srgb, const std::string& where, std::optional<uint32_t>& out,
                            Error& error) {
    const auto [known, fresh] = textures_.try_emplace({index, srgb});
    if (!fresh) {
        out = known->second;
        return true;
    }
    const Json& texture = document_->at("textures", index);
    Pixels pixels;
    size_t image = 0;
    std::string problem;
    if (!decode(texture, where, pixels, image, problem, error)) return false;
    notes_->addExtensions(placeOf("textures", index, texture), texture,
                          {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"});
    if (!problem.empty()) {
        notes_->add(where, "is left out: " + problem);
        return true;
    }
    if (mesh_->textures.size() >= limits::gltfTextures) {
        error.text = "has over 256 textures";
        return false;
    }
    MeshTexture made;
    made.width = pixels.width;
    made.height = pixels.height;
    made.rgba = std::move(pixels.rgba);
    made.srgb = srgb;
    std::optional<size_t> sampler;
    if (!readIndex(texture, "sampler", document_->count("samplers"), placeOf("textures", index, texture),
                   sampler, error))
        return false;
    if (sampler) readSampler(*sampler, made);
    known->second = out = static_cast<uint32_t>(mesh_->textures.size());
    decoded_.emplace(image, *out);
    mesh_->textures.push_back(std::move(made));
    return true;
}

/// The first of a texture's images that can be read, `from`. False on indices that lead nowhere; a `problem`
/// where none can.
bool Materials::decode(const Json& texture, const std::string& where, Pixels& out, size_t& from,
                       std::string& problem, Error& error) {
    const Json* const sources[] = {
        &texture, &extension(texture, "EXT_texture_webp"), &extension(texture, "KHR_texture_basisu"),
        &extension(texture, "EXT_texture_avif"), &extension(texture, "MSFT_texture_dds")};
    problem.clear();
    bool any = false;
    for (const Json* const source : sources) {
        std::optional<size_t> image;
        if (!readIndex(*source, "source", document_->count("images"), where, image, error)) return false;
        if (!image) continue;
        any = true;
        const std::string place = placeOf("images", *image, document_->at("images", *image));
        std::string& why = broken_[*image];
        if (why.empty() && !readImage(*image, place, out, why, error)) return false;
        if (why.empty()) {
            from = *image;
            problem.clear();
            return true;
        }
        if (problem.empty()) problem = place + " " + why;
    }
    if (!any) problem = "its texture has no image";
    return true;
}

/// A `problem` is the image's alone; false where the file is refused.
bool Materials::readImage(size_t index, const std::string& place, Pixels& out, std::string& problem,
                          Error& error) {
    const uint64_t allowed = buffers_->allowed(limits::gltfTexels);
    out = {};
    if (const auto before = decoded_.find(index); before != decoded_.end()) {
        const MeshTexture& texture = mesh_->textures[before->second];
        out.width = texture.width;
        out.height = texture.height;
        // Counted before it is copied.
        if (pixels_ + uint64_t{out.width} * out.height <= allowed) out.rgba = texture.rgba;
    } else {
        std::span<const uint8_t> bytes;
        std::shared_ptr<const std::vector<uint8_t>> held;
        if (!imageBytes(index, bytes, held, problem)) return true;
        if (decodeImage(bytes, allowed - std::min(allowed, pixels_), out, problem)) problem.clear();
    }
    // Broken ones cost as much as whole ones.
    pixels_ += uint64_t{out.width} * out.height;
    if (pixels_ <= allowed) return true;
    error.text = place + " brings the textures over " + std::to_string(allowed) +
                 " pixels: the most for so many bytes";
    return false;
}

bool Materials::imageBytes(size_t index, std::span<const uint8_t>& out,
                           std::shared_ptr<const std::vector<uint8_t>>& held, std::string& problem) {
    const Json& image = document_->at("images", index);
    std::optional<size_t> view;
    size_t stride = 0;
    Error error;
    if (!readIndex(image, "bufferView", document_->count("bufferViews"), "", view, error) ||
        (view && !buffers_->view(*view, out, stride, error))) {
        problem = error.text;
        return false;
    }
    if (view) return true;
    problem = "has neither a uri nor bytes";
    if (!member(image, "uri").is_string()) return false;
    held = buffers_->uris().read(textOf(image, "uri"), limits::gltfImageBytes, problem);
    if (held) out = *held;
    return held != nullptr;
}

/// One of glTF's numbers for a way to sample; 0 where it is missing, or is none and named.
size_t Materials::readWay(size_t sampler, const char* key, std::initializer_list<size_t> known) {
    const Json& json = document_->at("samplers", sampler);
    const Json& stated = member(json, key);
    size_t way = 0;
    Error error;
    if (stated.is_null()) return 0;
    if (readCount(json, key, "", way, error) && std::find(known.begin(), known.end(), way) != known.end())
        return way;
    notes_->add(placeOf("samplers", sampler, json) + "." + key, "is unknown, and as if it were missing");
    return 0;
}

void Materials::readSampler(size_t sampler, MeshTexture& out) {
    constexpr size_t nearest = 9728, linear = 9729, nearestMipNearest = 9984, linearMipNearest = 9985,
                     nearestMipLinear = 9986, linearMipLinear = 9987;
    const size_t wrapU = readWay(sampler, "wrapS", {repeat, clampToEdge, mirroredRepeat});
    const size_t wrapV = readWay(sampler, "wrapT", {repeat, clampToEdge, mirroredRepeat});
    const size_t larger = readWay(sampler, "magFilter", {nearest, linear});
    const size_t smaller =
        readWay(sampler, "minFilter",
                {nearest, linear, nearestMipNearest, linearMipNearest, nearestMipLinear, linearMipLinear});
    out.wrapU = wrapOf(wrapU);
    out.wrapV = wrapOf(wrapV);
    if (larger == nearest) out.larger = Filter::nearest;
    if (smaller == nearest || smaller == nearestMipNearest || smaller == nearestMipLinear)
        out.smaller = Filter::nearest;
    if (smaller == nearest || smaller == linear) out.mips = Mips::none;
    if (smaller == nearestMipNearest || smaller == linearMipNearest) out.mips = Mips::nearest;
}

void Materials::noteExtensions(const Source& source) {
    const bool unlit = !extension(source.json, "KHR_materials_unlit").is_null();
    for (const auto& [name, value] : member(source.json, "extensions").items()) {
        if (name == "KHR_materials_unlit" || name == "KHR_materials_emissive_strength" ||
            name == specularGlossiness || isHarmless(name))
            continue;
        const bool ofLight = name.starts_with("KHR_materials_");
        if (!isNeutral(name, value) && !(unlit && ofLight))
            notes_->add(source.where, quoted(name) + " is left out");
    }
}

void Materials::finish(const std::vector<bool>& clearVertices) {
    for (size_t i = 0; i < read_.size(); ++i) {
        MeshMaterial& material = mesh_->materials[i];
        if (!read_[i] || !material.blends) continue;
        bool clear = material.baseColor.a < 1 || clearVertices[i];
        if (const std::optional<uint32_t>& base = material.textures[baseSlot]) {
            const std::vector<uint8_t>& rgba = mesh_->textures[*base].rgba;
            for (size_t p = 3; p < rgba.size() && !clear; p += 4) clear = rgba[p] < 255;
        }
        material.blends = clear;
        if (clear)
            notes_->add(placeOf("materials", i, document_->at("materials", i)),
                        "its alpha is not blended but dithered: that share of its pixels is drawn");
    }
}

} // namespace demos::gltf
