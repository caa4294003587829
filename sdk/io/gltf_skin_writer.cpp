// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.3 skins, 3.11 animations).
// Nodes: 0 shows the mesh, at the scene's top, because a skinned mesh doesn't move with its node; 1 holds the roots and is the
// skin's skeleton; 2 + j is joint j, as far from its parent as at rest, not turned. What is of length 1, or of sum 1, within
// some bits of float keeps its bits; else it is brought there, as the format asks for more than our views do.
#include "io/gltf_skin_writer.h"

#include <cmath>
#include <map>

#include "io/glb_builder.h"
#include "io/gltf_materials.h"
#include "io/json_text.h"
#include "io/skin_data.h"
#include "io/vec3.h"

namespace flg::io {

namespace {

constexpr double off_by = 1e-6;  // nearer to 1 than this: as good as floats are
constexpr size_t first_joint_node = 2;

std::string number(size_t value) {
    return std::to_string(value);
}

void add_item(std::string& list, const std::string& item) {
    if (!list.empty()) list += ',';
    list += item;
}

template <size_t N>
void append_unit(const float* values, std::vector<float>& to) {
    double square = 0;
    for (size_t k = 0; k < N; ++k) square += double{values[k]} * values[k];
    const double size = std::sqrt(square);
    const bool keeps = std::abs(size - 1) <= off_by;
    for (size_t k = 0; k < N; ++k) to.push_back(keeps ? values[k] : static_cast<float>(values[k] / size));
}

class SkinWriter {
public:
    explicit SkinWriter(const CheckedSkin& checked) : checked_(checked), skin_(checked.skin()) {}

    std::string write() {
        const std::string attributes = add_vertices();
        add_primitives(attributes);
        for (const FlgSkinAnimation& animation : checked_.animations()) add_animation(animation);
        std::string joints, roots, nodes;
        std::vector<std::string> children(checked_.joint_count());
        for (size_t j = 0; j < checked_.joint_count(); ++j) {
            const uint32_t parent = skin_.joint_parents[j];
            add_item(joints, number(first_joint_node + j));
            add_item(parent == FLG_NO_INDEX ? roots : children[parent], number(first_joint_node + j));
        }
        const std::string name = checked_.name();
        add_item(nodes, "{\"name\":" + json_text(name) + ",\"mesh\":0,\"skin\":0}");
        add_item(nodes, "{\"name\":" + json_text(name + " skeleton") + ",\"children\":[" + roots + "]}");
        for (size_t j = 0; j < checked_.joint_count(); ++j) add_item(nodes, joint_node(j, children[j]));
        std::string top = "\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[" + nodes +
                          "],\"skins\":[{\"name\":" + json_text(name) +
                          ",\"inverseBindMatrices\":" + number(add_bind_matrices()) + ",\"skeleton\":1,\"joints\":[" +
                          joints + "]}],\"materials\":[" + materials_ + "],";
        if (!animations_.empty()) top += "\"animations\":[" + animations_ + "],";
        return glb_.finish_scene(top, name);
    }

private:
    std::string add_vertices() {
        const size_t count = checked_.vertex_count();
        const std::span<const float> positions(skin_.positions, 3 * count);
        std::vector<float> normals, weights, parts;
        std::vector<uint16_t> joints;
        for (size_t v = 0; v < count; ++v) {
            const float* n = skin_.normals + 3 * v;
            const float axis[] = {0, 0, 1};
            append_unit<3>(n[0] == 0 && n[1] == 0 && n[2] == 0 ? axis : n, normals);
            append_binding(v, joints, weights);
            parts.push_back(static_cast<float>(checked_.part(v)));
        }
        std::string attributes =
            "\"POSITION\":" + number(glb_.add_positions(glb_.add_view(positions, 3), positions, 0, count));
        const auto add = [&](const char* name, size_t view, uint32_t component, const char* type) {
            attributes +=
                ",\"" + std::string(name) + "\":" + number(glb_.add_accessor(view, 0, count, component, type));
        };
        add("NORMAL", glb_.add_view(normals, 3), glb_float, "VEC3");
        add("JOINTS_0", glb_.add_view(std::span<const uint16_t>(joints)), glb_unsigned_short, "VEC4");
        add("WEIGHTS_0", glb_.add_view(weights, 4), glb_float, "VEC4");
        if (skin_.vertex_parts) add("_PART", glb_.add_view(parts, 1), glb_float, "SCALAR");
        return attributes;
    }

    // What has no weight is joint 0; the largest weight takes up what the sum is off.
    void append_binding(size_t vertex, std::vector<uint16_t>& joints, std::vector<float>& weights) const {
        const uint16_t* from_joints = skin_.vertex_joints + joints_a_vertex * vertex;
        const float* from = skin_.vertex_weights + joints_a_vertex * vertex;
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

    uint32_t part_of_triangle(size_t triangle) const {
        const uint32_t* c = skin_.triangles + 3 * triangle;
        const uint32_t a = checked_.part(c[0]), b = checked_.part(c[1]);
        return b == checked_.part(c[2]) ? b : a;
    }

    void add_primitives(const std::string& attributes) {
        const size_t material_count = checked_.materials().size();
        std::map<uint32_t, std::vector<uint32_t>> indices;  // by part
        for (size_t t = 0; t < skin_.triangle_count; ++t) {
            std::vector<uint32_t>& list = indices[material_count > 1 ? part_of_triangle(t) : 0];
            list.insert(list.end(), skin_.triangles + 3 * t, skin_.triangles + 3 * t + 3);
        }
        for (const auto& [part, list] : indices) {
            const size_t accessor = glb_.add_accessor(glb_.add_view(std::span<const uint32_t>(list)), 0, list.size(),
                                                      glb_unsigned, "SCALAR");
            glb_.add_primitive(attributes, glb_triangles,
                               ",\"indices\":" + number(accessor) + ",\"material\":" + number(part));
        }
        if (material_count == 0) materials_ = json_plain_material("surface");
        for (size_t i = 0; i < material_count; ++i)
            add_item(materials_, json_material(checked_.materials()[i], "part " + number(i)));
    }

    size_t add_bind_matrices() {
        std::vector<float> matrices;
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

    std::string joint_node(size_t joint, const std::string& children) const {
        const std::string name = skin_.joint_names ? skin_.joint_names[joint] : "joint " + number(joint);
        const Vec3 t = from_parent(joint);
        std::string json = "{\"name\":" + json_text(name) + ",\"translation\":[" +
                           json_number(static_cast<float>(t.x)) + "," + json_number(static_cast<float>(t.y)) + "," +
                           json_number(static_cast<float>(t.z)) + "]";
        if (!children.empty()) json += ",\"children\":[" + children + "]";
        return json + "}";
    }

    void add_animation(const FlgSkinAnimation& animation) {
        const size_t keys = animation.key_count, joint_count = checked_.joint_count();
        const size_t times = glb_.add_times({animation.times, keys});
        std::string channels, samplers;
        size_t sampler_count = 0;
        const auto add = [&](size_t joint, const char* path, const std::vector<float>& values, const char* type) {
            const size_t output = glb_.add_accessor(glb_.add_plain_view(values), 0, keys, glb_float, type);
            add_item(samplers, "{\"input\":" + number(times) + ",\"output\":" + number(output) + "}");
            add_item(channels, "{\"sampler\":" + number(sampler_count++) + ",\"target\":{\"node\":" +
                                   number(first_joint_node + joint) + ",\"path\":\"" + path + "\"}}");
        };
        std::vector<float> values;
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
        const std::string name = animation.name ? animation.name : "animation";
        add_item(animations_,
                 "{\"name\":" + json_text(name) + ",\"channels\":[" + channels + "],\"samplers\":[" + samplers + "]}");
    }

    const CheckedSkin& checked_;
    const FlgSkinView& skin_;
    GlbBuilder glb_;
    std::string materials_, animations_;
};

}  // namespace

std::string write_glb_skin(const CheckedSkin& skin) {
    return SkinWriter(skin).write();
}

}  // namespace flg::io
