// SPDX-License-Identifier: MIT
#include "baked_maps.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "documents/failure.h"
#include "documents/text_file.h"
#include "filigree/filigree_bake.h"
#include "png_file.h"

namespace flg::cli {
namespace {

constexpr uint32_t outside = 65535;     // in maps of 16 bits
constexpr float steps = outside - 1;    // of the others
constexpr uint32_t padding_share = 16;  // of the size: mip levels down to so many texels meet no background
constexpr float width_share = 1.0f / 500;

// What a region shows, times how much of it is the script's: so that means of several are right.
enum Blend : uint32_t { red, green, blue, cover, roughness, metallic, blend_count };

std::vector<float> blends_of_regions(const TangleScript& script) {
    const TangleMaterials& materials = script.materials();
    const uint32_t regions = script.info().region_count;
    std::vector<float> values(size_t{blend_count} * regions);
    for (uint32_t r = 0; r < regions && !materials.table.empty(); ++r) {
        if (materials.of_region[r] >= materials.table.size()) continue;  // the mesh's own
        const FlgMeshMaterial& look = materials.table[materials.of_region[r]];
        float* const out = &values[size_t{blend_count} * r];
        std::copy_n(look.color, 3, out);
        out[cover] = 1;
        out[roughness] = look.roughness;
        out[metallic] = look.metallic;
    }
    return values;
}

uint8_t byte(float share) {
    return static_cast<uint8_t>(std::lround(255 * std::clamp(share, 0.0f, 1.0f)));
}

float to_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

// Path and bytes.
using Files = std::vector<std::pair<std::string, std::string>>;

// The maps of one material, as numbers and as files.
class MapSet {
public:
    MapSet(const BakeOptions& options, const std::string& prefix, Files& files)
        : options_(options), prefix_(prefix), files_(files) {
        const size_t texels = size_t{options.size} * options.size;
        if (wants("ids")) ids_.resize(texels);
        if (wants("distance")) distances_.resize(texels);
        if (wants("borders")) borders_.resize(texels);
        if (wants("height")) heights_.resize(texels);
        if (wants("normal")) normals_.resize(3 * texels);
        if (wants("color") || wants("material")) blends_.resize(blend_count * texels);
    }

    void point(FlgTangleBakeDesc& desc) {
        desc.ids = data(ids_);
        desc.distances = data(distances_);
        desc.borders = data(borders_);
        desc.heights = data(heights_);
        desc.normals = data(normals_);
        desc.blends = data(blends_);
    }
    // Returns what the files are.
    nlohmann::ordered_json encode() {
        if (wants("ids")) encode_ids();
        if (wants("distance")) encode_distances();
        if (wants("borders")) add_file<uint8_t>("borders", 1, borders_);
        if (wants("height")) encode_heights();
        if (wants("normal")) encode_normals();
        if (wants("color")) encode_colors();
        if (wants("material")) encode_materials();
        return std::move(said_);
    }

private:
    bool wants(const char* map) const {
        return std::find(options_.maps.begin(), options_.maps.end(), map) != options_.maps.end();
    }
    template <class T>
    static T* data(std::vector<T>& values) {
        return values.empty() ? nullptr : values.data();
    }
    template <class T>
    nlohmann::ordered_json& add_file(const std::string& map, uint32_t channels, const std::vector<T>& values) {
        const std::string path = prefix_ + "." + map + ".png";
        files_.emplace_back(path,
                            encode_png(path, {options_.size, options_.size, channels}, std::span<const T>(values)));
        nlohmann::ordered_json& said = said_[map];
        said["file"] = std::filesystem::path(path).filename().string();
        return said;
    }
    void encode_ids() {
        std::vector<uint16_t> values;
        values.reserve(ids_.size());
        for (const uint32_t id : ids_) values.push_back(static_cast<uint16_t>(std::min(id, outside)));
        add_file("ids", 1, values)["outside"] = outside;
    }
    // Values from `from` on, in steps of `scale`; what is not finite lies outside.
    void encode_lengths(const char* map, const std::vector<float>& lengths, float from, float to) {
        const float scale = to > from ? (to - from) / steps : 1;
        std::vector<uint16_t> values;
        values.reserve(lengths.size());
        for (const float length : lengths) {
            values.push_back(static_cast<uint16_t>(
                std::isfinite(length) ? std::lround(std::clamp((length - from) / scale, 0.0f, steps)) : outside));
        }
        nlohmann::ordered_json& said = add_file(map, 1, values);
        said["metres_at_0"] = from;
        said["metres_per_step"] = scale;
    }
    void encode_distances() {
        float most = 0;
        for (const float distance : distances_)
            if (std::isfinite(distance)) most = std::max(most, distance);
        encode_lengths("distance", distances_, 0, most);
        said_["distance"]["outside"] = outside;
    }
    void encode_heights() {
        const auto [least, most] = std::minmax_element(heights_.begin(), heights_.end());
        encode_lengths("height", heights_, *least, *most);
    }
    void encode_normals() {
        std::vector<uint8_t> values;
        values.reserve(normals_.size());
        for (const float part : normals_) values.push_back(static_cast<uint8_t>(128 + std::lround(127 * part)));
        add_file("normal", 3, values);
    }
    void encode_colors() {
        std::vector<uint8_t> values;
        values.reserve(blends_.size() / blend_count * 4);
        for (size_t i = 0; i < blends_.size(); i += blend_count) {
            const float covered = blends_[i + cover];
            for (const uint32_t c : {red, green, blue})
                values.push_back(covered > 0 ? byte(to_srgb(blends_[i + c] / covered)) : uint8_t{0});
            values.push_back(byte(covered));
        }
        add_file("color", 4, values);
    }
    void encode_materials() {
        std::vector<uint8_t> values;
        values.reserve(blends_.size() / blend_count * 3);
        for (size_t i = 0; i < blends_.size(); i += blend_count) {
            const float covered = blends_[i + cover];
            values.push_back(255);  // occlusion: none
            for (const uint32_t c : {roughness, metallic})
                values.push_back(covered > 0 ? byte(blends_[i + c] / covered) : uint8_t{0});
        }
        add_file("material", 3, values);
    }

    const BakeOptions& options_;
    std::string prefix_;
    Files& files_;
    std::vector<uint32_t> ids_;
    std::vector<float> distances_, heights_, normals_, blends_;
    std::vector<uint8_t> borders_;
    nlohmann::ordered_json said_;
};

std::set<uint32_t> labels_of(const FlgMeshView& mesh) {
    if (!mesh.regions) return {FLG_NO_INDEX};
    std::set<uint32_t> labels(mesh.regions, mesh.regions + mesh.triangle_count);
    return labels.size() == 1 ? std::set<uint32_t>{FLG_NO_INDEX} : labels;
}

float size_of(const FlgMeshFileInfo& info) {
    return std::hypot(info.box_max[0] - info.box_min[0], info.box_max[1] - info.box_min[1],
                      info.box_max[2] - info.box_min[2]);
}

}  // namespace

const std::vector<std::string>& map_names() {
    static const std::vector<std::string> names = {"ids",    "distance", "borders", "height",
                                                   "normal", "color",    "material"};
    return names;
}

void require_bakeable(const BakeOptions& options, const MeshSurface& surface) {
    if (!surface.file().info().corner_uvs) {
        throw InputError(surface.name() +
                         ": has no texture coordinates to bake into: unwrap it first (in Blender: UV, Smart UV "
                         "Project), or leave out --bake, which cuts the ornament into its triangles");
    }
    require_writable(options.prefix + ".json");
}

void bake_maps(Session& session, const BakeOptions& options, const MeshSurface& surface, const TangleScript& script,
               Report& report) {
    if (script.info().region_count > outside)
        throw InputError(surface.name() + ": has more regions than the 65535 that a map of ids can tell apart");
    const MeshFile& file = surface.file();
    const std::vector<FlgMeshMaterial> materials = file.materials();
    const std::vector<float> values = blends_of_regions(script);
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = options.size;
    desc.padding = std::min(FLG_BAKE_MAX_PADDING, options.size / padding_share);
    desc.tangle = script.tangle();
    desc.mesh = &file.view();
    desc.corner_uvs = file.info().corner_uvs;
    desc.border_width = options.border_width > 0 ? options.border_width : width_share * size_of(file.info());
    desc.component_count = blend_count;
    desc.blend_values = values.data();
    desc.region_count = script.info().region_count;
    nlohmann::ordered_json said;
    said["mesh"] = surface.name();
    said["size"] = options.size;
    said["padding"] = desc.padding;
    said["border_width"] = desc.border_width;
    Files files;
    for (const uint32_t label : labels_of(file.view())) {
        const bool is_all = label == FLG_NO_INDEX;
        MapSet maps(options, is_all ? options.prefix : options.prefix + "." + std::to_string(label), files);
        maps.point(desc);
        desc.mesh_region = label;
        FlgJob job = {};
        check(flgTangleBake(session.context(), &desc, &job), surface.name());
        session.finish({{{job, surface.name()}}}, report);
        nlohmann::ordered_json set;
        if (!is_all) set["region"] = label;
        const uint32_t material = is_all ? 0 : label;
        if (material < materials.size() && materials[material].name) set["material"] = materials[material].name;
        set["maps"] = maps.encode();
        said["sets"].push_back(std::move(set));
    }
    report.counts["baked_sets"] = said["sets"].size();
    files.emplace_back(options.prefix + ".json", said.dump(2) + "\n");
    for (const auto& [path, bytes] : files) write_text_file(path, bytes);
}

}  // namespace flg::cli
