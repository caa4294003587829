// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.3 skins, 3.11 animations).
//
// Read: all nodes that show a mesh with the first
// skin that is met become one surface; their own transforms do not count, as the format says. Weights are sorted, so
// that the largest is the first, and brought to the sum 1.
//
// Written: node 0 shows the mesh, at the scene's top,
// because a skinned mesh doesn't move with its node; 1 holds the roots and is the skin's skeleton; 2 + j is joint j, as
// far from its parent as at rest, not turned. What is of length 1, or of sum 1, within some bits of float keeps its
// bits; else it is brought there, as the format asks for more than our views do.
#include "io/gltf/gltf_skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/base/json_text.h"
#include "io/base/pictures.h"
#include "io/base/vec3.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/gltf_animations.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_morph_writer.h"
#include "io/gltf/gltf_morphs.h"
#include "io/gltf/gltf_rig.h"
#include "io/gltf/gltf_textures.h"
#include "io/gltf/gltf_triangles.h"

namespace flg::io {

namespace {

constexpr double sum_tolerance = 0.01;             // of weights; bytes are no better
constexpr uint64_t max_parts = uint64_t{1} << 24;  // floats tell them apart
constexpr uint64_t no_material = UINT64_MAX;

class GltfSkinReader {
public:
    explicit GltfSkinReader(const Path& path)
        : document_(path), nodes_(document_), textures_(document_), morphs_(document_) {}

    std::optional<SkinData> read() {
        std::optional<uint64_t> skin;
        Tally others;
        for (uint64_t node = 0; node < nodes_.size(); ++node) {
            const Json& json = nodes_.json(node);
            if (!nodes_.is_shown(node) || !json.find("mesh")) continue;
            const uint64_t own = gltf_unsigned(json, "skin", no_node, GltfNodes::place(node));
            if (!skin && own != no_node) skin = own;
            if (own == no_node || own != skin.value_or(no_node)) {
                others.add(node);
            } else {
                shown_.push_back(node);
            }
        }
        if (!skin) return {};
        skeleton_.emplace(document_, nodes_, *skin);
        skeleton_->store(data_);
        for (const uint64_t node : shown_) read_mesh(node);
        if (data_.triangles.empty()) fail(FLG_ERROR_FORMAT, "meshes", "the skin moves no triangles");
        make_normals();
        finish_parts();
        warn(data_.warnings, others, "node", "with a mesh of no skin or of another, left out");
        warn(data_.warnings, lines_, "primitive", "of points or lines, left out");
        warn(data_.warnings, more_joints_, "primitive", "with more than four joints a vertex: the first four are read");
        if (!data_.corner_uvs.empty()) data_.corner_uvs.resize(6 * data_.triangle_count());
        if (!data_.colors.empty()) data_.colors.resize(4 * data_.vertex_count(), 1.0f);
        data_.textures = textures_.take(data_.warnings);
        lost_.warn(data_.warnings);
        morphs_.finish(data_);
        read_animations(document_, nodes_, *skeleton_, morphs_, size(), data_);
        return std::move(data_);
    }

private:
    void read_mesh(uint64_t node) {
        const String referrer = GltfNodes::place(node) + ".mesh";
        const uint64_t index = gltf_required(nodes_.json(node), "mesh", GltfNodes::place(node));
        const Json& mesh = document_.element("meshes", index, referrer);
        const String place = "meshes[" + to_text(index) + "]";
        const Json* primitives = gltf_array(mesh, "primitives", place);
        for (size_t i = 0; primitives && i < primitives->size(); ++i) {
            const Json& primitive = (*primitives)[i];
            const String here = place + ".primitives[" + to_text(i) + "]";
            if (!primitive.is_object()) fail(FLG_ERROR_FORMAT, here, "is no object");
            const uint64_t mode = gltf_unsigned(primitive, "mode", gltf_triangles, here);
            if (mode > gltf_triangle_fan)
                fail(FLG_ERROR_FORMAT, here + ".mode", "is %llu, must be 0 to 6",
                     static_cast<unsigned long long>(mode));
            if (mode < gltf_triangles) {
                lines_.add(i);
                continue;
            }
            read_primitive({primitive, node, index, i, node, mode, skeleton_->placement(), here});
        }
    }

    void read_primitive(const GltfPrimitive& primitive) {
        const GltfVertices vertices = read_vertices(document_, primitive);
        const uint64_t count = vertices.positions.count;
        const std::optional<GltfValues> index_values = read_index_values(document_, primitive);
        check_room(count, index_values ? index_values->count : count, primitive.place);
        const Vector<uint32_t> indices = read_indices(index_values, count);
        // Primitives that follow each other and have the same attributes share their vertices.
        const Json& attributes = *primitive.json.find("attributes");
        const Json* const targets = primitive.json.find("targets");
        const bool same_targets = targets && last_targets_ ? *targets == *last_targets_ : targets == last_targets_;
        const bool is_new = data_.positions.empty() || primitive.placement != last_node_ ||
                            !(attributes == *last_attributes_) || !same_targets;
        last_node_ = primitive.placement;
        last_attributes_ = &attributes;
        last_targets_ = targets;
        const uint64_t material = gltf_unsigned(primitive.json, "material", no_material, primitive.place);
        const uint32_t next = static_cast<uint32_t>(part_of_material_.size());
        const auto [found, is_first] = part_of_material_.try_emplace(material, next);
        if (is_first) materials_.push_back(material_of(material, primitive.place + ".material"));
        if (is_new) {
            append_vertices(primitive, vertices, found->second);
            morphs_.append(primitive, primitive.placement, count);
        }
        append_triangles(primitive, indices,
                         GltfUvs::read(document_, primitive, textures_.of_material(material), count));
        data_.triangle_parts.resize(data_.triangle_count(), found->second);
        file_materials_.resize(data_.triangle_count(), material);
    }

    // With its texture.
    GltfMaterial material_of(uint64_t index, const String& place) {
        GltfMaterial material = read_material(document_, index, place);
        material.data.texture = textures_.of_material(index).texture;
        material.says_color = material.says_color || material.data.texture != FLG_NO_INDEX;
        lost_.add(document_, index);
        return material;
    }

    void append_triangles(const GltfPrimitive& primitive, const Vector<uint32_t>& indices,
                          const std::optional<GltfUvs>& uvs) {
        const bool mirrored = determinant(primitive.transform) < 0;
        if (uvs) data_.corner_uvs.resize(6 * data_.triangle_count());
        visit_triangles(primitive.mode, indices, [&](uint32_t a, uint32_t b, uint32_t c) {
            if (mirrored) std::swap(b, c);
            for (const uint32_t vertex : {a, b, c}) {
                data_.triangles.push_back(first_vertex_ + vertex);
                if (!uvs) continue;
                const std::array<float, 2> uv = uvs->at(vertex);
                data_.corner_uvs.insert(data_.corner_uvs.end(), uv.begin(), uv.end());
            }
        });
    }

    void check_room(uint64_t more_vertices, uint64_t more_triangles, const String& place) const {
        // As if all vertices had colours, and all triangles texture coordinates.
        constexpr uint64_t vertex_bytes =
            2 * 3 * sizeof(float) + 4 * (2 * sizeof(float) + sizeof(uint16_t)) + sizeof(uint32_t);
        constexpr uint64_t triangle_bytes = 3 * sizeof(uint32_t) + 6 * sizeof(float);
        const uint64_t vertices = data_.vertex_count() + more_vertices;
        const uint64_t triangles = data_.triangle_count() + more_triangles;
        if (vertices > max_bytes || triangles > max_bytes ||
            vertices * vertex_bytes + triangles * triangle_bytes > max_bytes)
            fail(FLG_ERROR_LIMIT, place, "the skin takes more than the limit of 2 GiB");
    }

    GltfValues required(const GltfPrimitive& primitive, const char* name, uint64_t count) const {
        const std::optional<GltfValues> values = read_attribute(document_, primitive, name);
        if (!values) fail(FLG_ERROR_FORMAT, primitive.place + ".attributes", "has no %s", name);
        check_count(*values, count);
        return *values;
    }

    static void check_count(const GltfValues& values, uint64_t count) {
        if (values.count == count) return;
        fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, but there are %llu positions",
             static_cast<unsigned long long>(values.count), static_cast<unsigned long long>(count));
    }

    void append_vertices(const GltfPrimitive& primitive, const GltfVertices& vertices, uint32_t material_part) {
        const uint64_t count = vertices.positions.count;
        const GltfValues joints = required(primitive, "JOINTS_0", count);
        const GltfValues weights = required(primitive, "WEIGHTS_0", count);
        const std::optional<GltfValues> normals = read_attribute(document_, primitive, "NORMAL");
        const std::optional<GltfValues> parts = read_attribute(document_, primitive, "_PART");
        const bool is_byte = joints.component_type == gltf_unsigned_byte;
        if (joints.components != 4 || joints.normalized || (!is_byte && joints.component_type != gltf_unsigned_short))
            fail(FLG_ERROR_FORMAT, joints.place, "holds joints that are not four bytes or 16-bit numbers a vertex");
        if (weights.components != 4 || (weights.component_type != gltf_float && !weights.normalized))
            fail(FLG_ERROR_FORMAT, weights.place, "holds weights that are not four floats a vertex");
        if (normals) check_count(*normals, count);
        if (normals && (normals->components != 3 || normals->component_type != gltf_float))
            fail(FLG_ERROR_FORMAT, normals->place, "holds normals that are not three floats");
        if (parts) check_count(*parts, count);
        if (parts && parts->components != 1)
            fail(FLG_ERROR_FORMAT, parts->place, "holds parts that are not one number");
        const bool has_more = read_attribute(document_, primitive, "JOINTS_1").has_value();
        if (has_more) more_joints_.add(primitive.index);
        all_have_parts_ = all_have_parts_ && parts;

        first_vertex_ = static_cast<uint32_t>(data_.vertex_count());
        for (uint32_t v = 0; v < count; ++v) {
            for (const float value : vertices.position(v, primitive.transform)) data_.positions.push_back(value);
            append_normal(normals, v, primitive.transform);
            append_binding(joints, weights, v, has_more);
            data_.parts.push_back(parts ? part_at(*parts, v) : material_part);
        }
        if (!vertices.colors) return;
        // White, where primitives before this one have no colours.
        data_.colors.resize(4 * size_t{first_vertex_}, 1.0f);
        for (uint32_t v = 0; v < count; ++v)
            for (const float value : vertices.color(v)) data_.colors.push_back(std::clamp(value, 0.0f, 1.0f));
    }

    void append_normal(const std::optional<GltfValues>& normals, uint32_t vertex, const Transform& t) {
        Vec3 n;
        if (normals) n = {normals->number(vertex, 0), normals->number(vertex, 1), normals->number(vertex, 2)};
        for (const double value : {n.x, n.y, n.z})
            if (!std::isfinite(value)) refuse_value(*normals, vertex, static_cast<float>(value));
        if (t != identity_transform) {
            n = {t[0] * n.x + t[3] * n.y + t[6] * n.z, t[1] * n.x + t[4] * n.y + t[7] * n.z,
                 t[2] * n.x + t[5] * n.y + t[8] * n.z};
        }
        constexpr double off_by = 1e-6;  // nearer to length 1 than this it keeps its bits
        if (std::abs(length(n) - 1) > off_by) n = normalized(n);
        for (const double value : {n.x, n.y, n.z}) data_.normals.push_back(static_cast<float>(value));
    }

    struct Bound {
        uint16_t joint;
        uint16_t place;  // among those of its vertex
        float weight;
    };

    void append_binding(const GltfValues& joints, const GltfValues& weights, uint32_t vertex, bool has_more) {
        Bound bound[joints_a_vertex];
        double sum = 0;
        for (uint32_t k = 0; k < joints_a_vertex; ++k) {
            const uint32_t joint = static_cast<uint32_t>(joints.number(vertex, k));
            const float weight = weights.number(vertex, k);
            if (joint >= skeleton_->order().size())
                fail(FLG_ERROR_FORMAT, joints.place, "vertex %u names joint %u, but there are %zu", vertex, joint,
                     skeleton_->order().size());
            if (!(weight >= 0 && weight <= 1 + static_cast<float>(sum_tolerance)))
                fail(FLG_ERROR_FORMAT, weights.place, "vertex %u has the weight %g, must be 0 to 1", vertex,
                     double{weight});
            bound[k] = {skeleton_->order()[joint], static_cast<uint16_t>(k), weight};
            sum += weight;
        }
        if (has_more ? !(sum > 0) : !(std::abs(sum - 1) <= sum_tolerance))
            fail(FLG_ERROR_FORMAT, weights.place, "the weights of vertex %u sum up to %g, must be 1", vertex, sum);
        for (uint32_t k = 0; k < joints_a_vertex; ++k) {  // of what is named twice, the first takes all
            for (uint32_t i = 0; i < k; ++i) {
                if (bound[i].joint != bound[k].joint) continue;
                bound[i].weight += bound[k].weight;
                bound[k].weight = 0;
                break;
            }
        }
        std::sort(bound, bound + joints_a_vertex, [](const Bound& a, const Bound& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.place < b.place;
        });
        constexpr double off_by = 1e-6;  // nearer to 1 than this weights keep their bits
        const double scale = std::abs(sum - 1) > off_by ? 1 / sum : 1;
        for (const Bound& b : bound) {
            data_.joints.push_back(b.weight > 0 ? b.joint : uint16_t{0});
            data_.weights.push_back(static_cast<float>(b.weight * scale));
        }
    }

    uint32_t part_at(const GltfValues& parts, uint32_t vertex) const {
        const double part = parts.number(vertex, 0);
        if (!(part >= 0 && part < max_parts && part == std::floor(part)))
            fail(FLG_ERROR_FORMAT, parts.place, "vertex %u is of part %g, must be a whole number of 0 to 2^24", vertex,
                 part);
        return static_cast<uint32_t>(part);
    }

    // Where there are none, those of the triangles around by area; an axis where there are no triangles either.
    void make_normals() {
        const auto at = [](const Vector<float>& values, size_t v) {
            return Vec3{values[3 * v], values[3 * v + 1], values[3 * v + 2]};
        };
        Vector<Vec3> sums;
        for (size_t v = 0; v < data_.vertex_count(); ++v) {
            if (length(at(data_.normals, v)) > 0) continue;
            if (sums.empty()) sums = triangle_normals();
            const Vec3 n = length(sums[v]) > 0 ? normalized(sums[v]) : Vec3{0, 0, 1};
            data_.normals[3 * v] = static_cast<float>(n.x);
            data_.normals[3 * v + 1] = static_cast<float>(n.y);
            data_.normals[3 * v + 2] = static_cast<float>(n.z);
        }
    }

    Vector<Vec3> triangle_normals() const {
        Vector<Vec3> sums(data_.vertex_count());
        const auto at = [&](uint32_t v) {
            return Vec3{data_.positions[3 * v], data_.positions[3 * v + 1], data_.positions[3 * v + 2]};
        };
        for (size_t i = 0; i < data_.triangles.size(); i += 3) {
            const uint32_t* c = &data_.triangles[i];
            const Vec3 n = cross(at(c[1]) - at(c[0]), at(c[2]) - at(c[0]));
            for (size_t k = 0; k < 3; ++k) sums[c[k]] = sums[c[k]] + n;
        }
        return sums;
    }

    // Materials by part: with _PART the document's in their order, as this library writes them.
    void finish_parts() {
        if (all_have_parts_) {
            const uint32_t highest = *std::max_element(data_.parts.begin(), data_.parts.end());
            const size_t count = document_.size("materials");
            const bool tells_parts =
                count > highest && count > 1 &&
                std::all_of(file_materials_.begin(), file_materials_.end(), [&](uint64_t m) { return m < count; });
            if (tells_parts)
                data_.triangle_parts.assign(file_materials_.begin(), file_materials_.end());
            else
                data_.triangle_parts.clear();
            if (count == 0 || (count > 1 && count <= highest)) return;
            materials_.clear();
            for (uint64_t i = 0; i < count; ++i) materials_.push_back(material_of(i, "materials"));
        }
        const bool says_color =
            std::any_of(materials_.begin(), materials_.end(), [](const GltfMaterial& m) { return m.says_color; });
        for (GltfMaterial& material : materials_)
            if (says_color) data_.materials.push_back(std::move(material.data));
    }

    double size() const {
        double square = 0;
        for (size_t k = 0; k < 3; ++k) {
            float low = data_.positions[k], high = low;
            for (const Vector<float>* points : {&data_.positions, &data_.joint_positions}) {
                for (size_t i = k; i < points->size(); i += 3) {
                    low = std::min(low, (*points)[i]);
                    high = std::max(high, (*points)[i]);
                }
            }
            square += (double{high} - low) * (double{high} - low);
        }
        return std::sqrt(square);
    }

    GltfDocument document_;
    GltfNodes nodes_;
    GltfTextures textures_;
    LostLooks lost_;
    GltfMorphReader morphs_;
    std::optional<GltfSkeleton> skeleton_;
    Vector<uint64_t> shown_;
    SkinData data_;
    uint64_t last_node_ = no_node;
    const Json *last_attributes_ = nullptr, *last_targets_ = nullptr;
    uint32_t first_vertex_ = 0;
    bool all_have_parts_ = true;
    Map<uint64_t, uint32_t> part_of_material_;
    Vector<uint64_t> file_materials_;  // by triangle
    Vector<GltfMaterial> materials_;
    Tally lines_, more_joints_;
};

}  // namespace

std::optional<SkinData> read_gltf_skin(const Path& path) {
    return GltfSkinReader(path).read();
}

namespace {

constexpr double off_by = 1e-6;  // nearer to 1 than this: as good as floats are
constexpr size_t first_joint_node = 2;

String number(size_t value) {
    return to_text(value);
}

void add_item(String& list, const String& item) {
    if (!list.empty()) list += ',';
    list += item;
}

template <size_t N>
void append_unit(const float* values, Vector<float>& to) {
    double square = 0;
    for (size_t k = 0; k < N; ++k) square += double{values[k]} * values[k];
    const double size = std::sqrt(square);
    const bool keeps = std::abs(size - 1) <= off_by;
    for (size_t k = 0; k < N; ++k) to.push_back(keeps ? values[k] : static_cast<float>(values[k] / size));
}

// The vertices of a mesh with texture coordinates: those whose corners differ in them are there several times, a vertex
// of the skin first as what it is there.
struct TexturedVertices {
    explicit TexturedVertices(const FlgSkinView& mesh) {
        constexpr uint32_t none = 0xffffffffu;
        const size_t corners = 3 * size_t{mesh.triangle_count};
        sources.resize(mesh.vertex_count);
        std::iota(sources.begin(), sources.end(), 0u);
        corner_vertices.assign(mesh.triangles, mesh.triangles + corners);
        if (!mesh.corner_uvs) return;
        uvs.resize(2 * sources.size());
        Vector<uint32_t> next(sources.size(), none);  // of a vertex, where it is once more
        Vector<bool> has_uv(sources.size());
        for (size_t c = 0; c < corners; ++c) {
            const float* uv = mesh.corner_uvs + 2 * c;
            const auto fits = [&](uint32_t v) {
                return uvs[2 * size_t{v}] == uv[0] && uvs[2 * size_t{v} + 1] == uv[1];
            };
            uint32_t vertex = mesh.triangles[c];
            if (has_uv[vertex]) {
                while (!fits(vertex) && next[vertex] != none) vertex = next[vertex];
                if (!fits(vertex)) {
                    next[vertex] = static_cast<uint32_t>(sources.size());
                    vertex = next[vertex];
                    sources.push_back(mesh.triangles[c]);
                    next.push_back(none);
                    uvs.insert(uvs.end(), {uv[0], uv[1]});
                }
            } else {
                has_uv[vertex] = true;
                std::copy_n(uv, 2, uvs.begin() + static_cast<ptrdiff_t>(2 * size_t{vertex}));
            }
            corner_vertices[c] = vertex;
        }
    }

    Vector<uint32_t> sources, corner_vertices;
    Vector<float> uvs;  // none without a picture
};

class SkinWriter {
public:
    explicit SkinWriter(const CheckedSkin& checked) : checked_(checked), skin_(checked.skin()) {}

    String write() {
        for (const FlgSkinView& mesh : checked_.meshes()) add_mesh(mesh);
        add_materials();
        for (size_t i = 0; i < checked_.animations().size(); ++i) add_animation(i);
        for (const FlgMorphAnimation& animation : checked_.morphs().animations()) {
            if (animation.animation != FLG_NO_INDEX) continue;
            MorphWriter writer(glb_, checked_.morphs().targets(), skin_, {});
            add_item(animations_, "{\"name\":" + json_text(animation.name ? animation.name : "morph") +
                                      ",\"channels\":[" + morph_channels(0) + "],\"samplers\":[" +
                                      writer.add_sampler(animation) + "]}");
        }
        const size_t levels = checked_.meshes().size() - 1;
        String joints, roots, nodes, level_nodes, extensions;
        Vector<String> children(checked_.joint_count());
        for (size_t j = 0; j < checked_.joint_count(); ++j) {
            const uint32_t parent = skin_.joint_parents[j];
            add_item(joints, number(first_joint_node + j));
            add_item(parent == FLG_NO_INDEX ? roots : children[parent], number(first_joint_node + j));
        }
        const String name = checked_.name();
        for (size_t i = 0; i < levels; ++i) add_item(level_nodes, number(first_level_node() + i));
        add_item(nodes, "{\"name\":" + json_text(levels == 0 ? name : name + "_LOD0") + ",\"mesh\":0,\"skin\":0" +
                            (levels == 0 ? "" : ",\"extensions\":{\"MSFT_lod\":{\"ids\":[" + level_nodes + "]}}") +
                            "}");
        add_item(nodes, "{\"name\":" + json_text(name + " skeleton") + json_translation(checked_.origin()) +
                            ",\"children\":[" + roots + "]}");
        for (size_t j = 0; j < checked_.joint_count(); ++j) add_item(nodes, joint_node(j, children[j]));
        for (size_t i = 1; i <= levels; ++i)
            add_item(nodes,
                     "{\"name\":" + json_text(name + "_LOD" + number(i)) + ",\"mesh\":" + number(i) + ",\"skin\":0}");
        String top = "\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[" + nodes +
                     "],\"skins\":[{\"name\":" + json_text(name) +
                     ",\"inverseBindMatrices\":" + number(add_bind_matrices()) + ",\"skeleton\":1,\"joints\":[" +
                     joints + "]}],\"materials\":[" + materials_ + "],";
        if (!animations_.empty()) top += "\"animations\":[" + animations_ + "],";
        if (!checked_.textures().empty()) top += json_textures();
        if (levels != 0) add_item(extensions, "\"MSFT_lod\"");
        if (checked_.vrm()) add_item(extensions, "\"VRMC_vrm\"");
        if (!extensions.empty()) top += "\"extensionsUsed\":[" + extensions + "],";
        if (checked_.vrm()) top += json_vrm(*checked_.vrm(), name, checked_.joint_count(), first_joint_node) + ",";
        return glb_.finish_scene(top, name);
    }

private:
    void add_mesh(const FlgSkinView& mesh) {
        const TexturedVertices vertices(mesh);
        const auto level = static_cast<size_t>(&mesh - checked_.meshes().data());
        const bool is_skin = level == 0;
        const String attributes = add_vertices(mesh, vertices, is_skin ? checked_.vertex_colors() : nullptr);
        MorphWriter morphs(glb_, checked_.morphs().targets(level), mesh, vertices.sources);
        add_primitives(mesh, vertices, attributes, morphs.add_targets());
        const String members = morphs.mesh_members(checked_.morphs().targets());
        if (checked_.meshes().size() > 1)
            glb_.end_mesh(members);
        else if (!members.empty())
            glb_.end_mesh(",\"name\":" + json_text(checked_.name()) + members);
    }

    size_t first_level_node() const { return first_joint_node + checked_.joint_count(); }

    // Of the nodes that show the skin and its levels with shapes.
    String morph_channels(size_t sampler) const {
        String channels;
        for (size_t level = 0; level < checked_.meshes().size(); ++level) {
            if (checked_.morphs().targets(level).empty()) continue;
            const size_t node = level == 0 ? 0 : first_level_node() + level - 1;
            add_item(channels, "{\"sampler\":" + number(sampler) + ",\"target\":{\"node\":" + number(node) +
                                   ",\"path\":\"weights\"}}");
        }
        return channels;
    }

    String add_vertices(const FlgSkinView& mesh, const TexturedVertices& vertices, const float* colors) {
        const size_t count = vertices.sources.size();
        Vector<float> positions, normals, weights, parts;
        Vector<uint16_t> joints;
        for (const uint32_t v : vertices.sources) {
            positions.insert(positions.end(), mesh.positions + 3 * size_t{v}, mesh.positions + 3 * size_t{v} + 3);
            const float* n = mesh.normals + 3 * size_t{v};
            const float axis[] = {0, 0, 1};
            append_unit<3>(n[0] == 0 && n[1] == 0 && n[2] == 0 ? axis : n, normals);
            append_binding(mesh, v, joints, weights);
            parts.push_back(static_cast<float>(part_of_vertex(mesh, v)));
        }
        String attributes =
            "\"POSITION\":" + number(glb_.add_positions(glb_.add_view(positions, 3), positions, 0, count));
        const auto add = [&](const char* name, size_t view, uint32_t component, const char* type) {
            attributes += ",\"" + String(name) + "\":" + number(glb_.add_accessor(view, 0, count, component, type));
        };
        add("NORMAL", glb_.add_view(normals, 3), glb_float, "VEC3");
        if (!vertices.uvs.empty()) add("TEXCOORD_0", glb_.add_view(vertices.uvs, 2), glb_float, "VEC2");
        if (colors) {
            Vector<float> rgba;
            for (const uint32_t v : vertices.sources)
                rgba.insert(rgba.end(), colors + 4 * size_t{v}, colors + 4 * size_t{v} + 4);
            add("COLOR_0", glb_.add_colors(std::move(rgba)), glb_float, "VEC4");
        }
        add("JOINTS_0", glb_.add_view(std::span<const uint16_t>(joints)), glb_unsigned_short, "VEC4");
        add("WEIGHTS_0", glb_.add_view(weights, 4), glb_float, "VEC4");
        if (mesh.vertex_parts) add("_PART", glb_.add_view(parts, 1), glb_float, "SCALAR");
        return attributes;
    }

    // What has no weight is joint 0; the largest weight takes up what the sum is off.
    static void append_binding(const FlgSkinView& mesh, size_t vertex, Vector<uint16_t>& joints,
                               Vector<float>& weights) {
        const uint16_t* from_joints = mesh.vertex_joints + joints_a_vertex * vertex;
        const float* from = mesh.vertex_weights + joints_a_vertex * vertex;
        double sum = 0;
        size_t largest = 0;
        for (size_t k = 0; k < joints_a_vertex; ++k) {
            sum += from[k];
            if (from[k] > from[largest]) largest = k;
        }
        const bool keeps = std::abs(sum - 1) <= 1e-7;
        double others = 0;
        for (size_t k = 0; k < joints_a_vertex; ++k) {
            joints.push_back(from[k] > 0 ? from_joints[k] : uint16_t{0});
            weights.push_back(keeps ? from[k] : static_cast<float>(from[k] / sum));
            if (k != largest) others += double{weights.back()};
        }
        if (!keeps) weights[weights.size() - joints_a_vertex + largest] = static_cast<float>(1 - others);
    }

    void add_primitives(const FlgSkinView& mesh, const TexturedVertices& vertices, const String& attributes,
                        const String& targets) {
        Map<uint32_t, Vector<uint32_t>> indices;  // by part
        for (size_t t = 0; t < mesh.triangle_count; ++t) {
            Vector<uint32_t>& list = indices[checked_.materials().size() > 1 ? part_of_triangle(mesh, t) : 0];
            const uint32_t* corners = &vertices.corner_vertices[3 * t];
            list.insert(list.end(), corners, corners + 3);
        }
        for (const auto& [part, list] : indices) {
            const size_t accessor = glb_.add_accessor(glb_.add_view(std::span<const uint32_t>(list)), 0, list.size(),
                                                      glb_unsigned, "SCALAR");
            glb_.add_primitive(attributes, glb_triangles,
                               ",\"indices\":" + number(accessor) + ",\"material\":" + number(part) + targets);
        }
    }

    void add_materials() {
        const size_t material_count = checked_.materials().size();
        if (material_count == 0) materials_ = json_plain_material("surface", checked_.texture_of(material_defaults()));
        for (size_t i = 0; i < material_count; ++i) {
            const FlgMeshMaterial& material = checked_.materials()[i];
            add_item(materials_, json_material(material, "part " + number(i), checked_.texture_of(material)));
        }
    }

    // One image and one sampler each.
    String json_textures() {
        constexpr const char* wraps[] = {"10497", "33071", "33648"};  // by FlgTextureWrap
        String images, samplers, textures;
        for (size_t i = 0; i < checked_.textures().size(); ++i) {
            const FlgTexture& texture = checked_.textures()[i];
            const Bytes picture{texture.picture, texture.picture_size};
            const size_t file = is_png(picture) ? glb_.add_file(plain_png(picture)) : glb_.add_file(picture);
            add_item(images, "{\"bufferView\":" + number(file) + ",\"mimeType\":\"image/" +
                                 (is_png(picture) ? "png" : "jpeg") + "\"}");
            add_item(samplers, String("{\"magFilter\":") + (texture.nearest ? "9728" : "9729") +
                                   ",\"minFilter\":" + (texture.nearest ? "9984" : "9987") +
                                   ",\"wrapS\":" + wraps[texture.wrap_u] + ",\"wrapT\":" + wraps[texture.wrap_v] + "}");
            const String name = texture.name ? "\"name\":" + json_text(texture.name) + "," : "";
            add_item(textures, "{" + name + "\"source\":" + number(i) + ",\"sampler\":" + number(i) + "}");
        }
        return "\"images\":[" + images + "],\"samplers\":[" + samplers + "],\"textures\":[" + textures + "],";
    }

    size_t add_bind_matrices() {
        Vector<float> matrices;
        for (size_t j = 0; j < checked_.joint_count(); ++j) {
            const float* p = skin_.joint_positions + 3 * j;
            matrices.insert(matrices.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0 - p[0], 0 - p[1], 0 - p[2], 1});
        }
        return glb_.add_accessor(glb_.add_plain_view(matrices), 0, checked_.joint_count(), glb_float, "MAT4");
    }

    Vec3 from_parent(size_t joint) const {
        const float* p = skin_.joint_positions + 3 * joint;
        const Vec3 at{p[0], p[1], p[2]};
        const uint32_t parent = skin_.joint_parents[joint];
        if (parent == FLG_NO_INDEX) return at;
        const float* q = skin_.joint_positions + 3 * size_t{parent};
        return at - Vec3{q[0], q[1], q[2]};
    }

    String joint_node(size_t joint, const String& children) const {
        const String name = skin_.joint_names ? skin_.joint_names[joint] : "joint " + number(joint);
        const Vec3 t = from_parent(joint);
        String json = "{\"name\":" + json_text(name) + ",\"translation\":[" + json_number(static_cast<float>(t.x)) +
                      "," + json_number(static_cast<float>(t.y)) + "," + json_number(static_cast<float>(t.z)) + "]";
        if (!children.empty()) json += ",\"children\":[" + children + "]";
        if (checked_.rig())
            json += ",\"extras\":" + json_rig_joint(checked_.rig()->joints[joint], skin_.joint_positions + 3 * joint);
        return json + "}";
    }

    void add_animation(size_t index) {
        const FlgSkinAnimation& animation = checked_.animations()[index];
        const size_t keys = animation.key_count, joint_count = checked_.joint_count();
        const size_t times = glb_.add_times({animation.times, keys});
        String channels, samplers;
        size_t sampler_count = 0;
        const auto add = [&](size_t joint, const char* path, const Vector<float>& values, const char* type) {
            const size_t output = glb_.add_accessor(glb_.add_plain_view(values), 0, keys, glb_float, type);
            add_item(samplers, "{\"input\":" + number(times) + ",\"output\":" + number(output) + "}");
            add_item(channels, "{\"sampler\":" + number(sampler_count++) + ",\"target\":{\"node\":" +
                                   number(first_joint_node + joint) + ",\"path\":\"" + path + "\"}}");
        };
        Vector<float> values;
        for (size_t j = 0; j < joint_count; ++j) {
            values.clear();
            bool turns = j == 0;  // an animation needs a channel
            for (size_t key = 0; key < keys; ++key) {
                const float* q = animation.rotations + 4 * (key * joint_count + j);
                turns = turns || q[0] != 0 || q[1] != 0 || q[2] != 0;
                append_unit<4>(q, values);
            }
            if (turns) add(j, "rotation", values, "VEC4");
        }
        for (size_t j = 0; animation.translations && j < joint_count; ++j) {
            if (skin_.joint_parents[j] != FLG_NO_INDEX) continue;
            values.clear();
            const Vec3 rest = from_parent(j);
            for (size_t key = 0; key < keys; ++key) {
                const float* t = animation.translations + 3 * key;
                for (const double value : {rest.x + t[0], rest.y + t[1], rest.z + t[2]})
                    values.push_back(static_cast<float>(value));
            }
            add(j, "translation", values, "VEC3");
        }
        for (const FlgMorphAnimation& morph : checked_.morphs().animations()) {
            if (morph.animation != index) continue;
            add_item(samplers, MorphWriter(glb_, checked_.morphs().targets(), skin_, {}).add_sampler(morph));
            add_item(channels, morph_channels(sampler_count));
        }
        const String name = animation.name ? animation.name : "animation";
        add_item(animations_,
                 "{\"name\":" + json_text(name) + ",\"channels\":[" + channels + "],\"samplers\":[" + samplers + "]}");
    }

    const CheckedSkin& checked_;
    const FlgSkinView& skin_;
    GlbBuilder glb_;
    String materials_, animations_;
};

}  // namespace

String write_glb_skin(const CheckedSkin& skin) {
    return SkinWriter(skin).write();
}

}  // namespace flg::io
