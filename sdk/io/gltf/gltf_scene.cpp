// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.5 scenes and nodes, 3.7.2 primitives).
// Invariant: nodes form trees, which are walked without recursion.
#include "io/gltf/gltf_scene.h"

#include <cmath>
#include <numeric>

#include "io/base/failure.h"
#include "io/base/limits.h"

namespace flg::io {

namespace {

constexpr uint64_t mode_last = 6;

template <size_t N>
std::array<double, N> read_numbers(const Json& node, const char* key, std::array<double, N> fallback,
                                   const String& place) {
    const Json* array = gltf_array(node, key, place);
    if (!array) return fallback;
    bool sound = array->size() == N;
    for (size_t i = 0; sound && i < N; ++i) {
        sound = (*array)[i].is_number();
        if (sound) fallback[i] = (*array)[i].number();
    }
    if (!sound) fail(FLG_ERROR_FORMAT, place + "." + key, "must be %zu numbers", N);
    return fallback;
}

struct Visit {
    uint64_t node;
    Transform parent;
};

class SceneWalk {
public:
    SceneWalk(const GltfDocument& document, const Origin& origin,
              const std::function<void(const GltfPrimitive&)>& visit)
        : document_(document), visit_(visit) {
        for (size_t k = 0; k < 3; ++k) world_[9 + k] -= origin[k];
    }

    void meshes() {
        for (uint64_t i = 0; i < document_.size("meshes"); ++i) mesh(i, no_node, world_, "meshes");
    }

    void nodes(const Vector<uint64_t>& roots) {
        Vector<bool> seen(document_.size("nodes"));
        Vector<Visit> stack;
        for (size_t i = roots.size(); i-- > 0;) stack.push_back({roots[i], world_});
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            const String place = "nodes[" + to_text(visit.node) + "]";
            const Json& node = document_.element("nodes", visit.node, place);
            if (seen[visit.node]) fail(FLG_ERROR_FORMAT, place, "is shown twice: nodes must form trees");
            seen[visit.node] = true;
            const Transform transform = compose(visit.parent, local_transform(node, place));
            // A skinned mesh moves with its joints alone.
            if (node.find("mesh"))
                mesh(gltf_required(node, "mesh", place), visit.node, node.find("skin") ? world_ : transform,
                     place + ".mesh");
            const Vector<uint64_t> children = read_node_list(node, "children", place);
            for (size_t i = children.size(); i-- > 0;) stack.push_back({children[i], transform});
        }
    }

private:
    void mesh(uint64_t index, uint64_t node, const Transform& transform, const String& referrer) {
        const Json& mesh = document_.element("meshes", index, referrer);
        const String mesh_place = "meshes[" + to_text(index) + "]";
        const Json* primitives = gltf_array(mesh, "primitives", mesh_place);
        for (size_t i = 0; primitives && i < primitives->size(); ++i) {
            const Json& primitive = (*primitives)[i];
            String place = mesh_place + ".primitives[" + to_text(i) + "]";
            if (!primitive.is_object()) fail(FLG_ERROR_FORMAT, place, "is no object");
            const uint64_t mode = gltf_unsigned(primitive, "mode", gltf_triangles, place);
            if (mode > mode_last) {
                fail(FLG_ERROR_FORMAT, place + ".mode", "is %llu, must be 0 to 6",
                     static_cast<unsigned long long>(mode));
            }
            visit_({primitive, node, index, i, placements_, mode, transform, std::move(place)});
        }
        ++placements_;
    }

    const GltfDocument& document_;
    const std::function<void(const GltfPrimitive&)>& visit_;
    Transform world_ = identity_transform;  // from the file's coordinates to those relative to the origin
    uint64_t placements_ = 0;
};

}  // namespace

Transform compose(const Transform& a, const Transform& b) {
    Transform result;
    for (size_t column = 0; column < 4; ++column) {
        for (size_t row = 0; row < 3; ++row) {
            double value = column == 3 ? a[9 + row] : 0;
            for (size_t k = 0; k < 3; ++k) value += a[3 * k + row] * b[3 * column + k];
            result[3 * column + row] = value;
        }
    }
    return result;
}

double determinant(const Transform& t) {
    return t[0] * (t[4] * t[8] - t[5] * t[7]) + t[1] * (t[5] * t[6] - t[3] * t[8]) + t[2] * (t[3] * t[7] - t[4] * t[6]);
}

Transform local_transform(const Json& node, const String& place) {
    if (node.find("matrix")) {
        const auto m = read_numbers<16>(node, "matrix", {}, place);
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
            fail(FLG_ERROR_FORMAT, place + ".matrix", "has a last row other than 0 0 0 1");
        }
        return {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10], m[12], m[13], m[14]};
    }
    return node_motion(node, place).transform();
}

NodeMotion node_motion(const Json& node, const String& place) {
    return {read_numbers<3>(node, "translation", {0, 0, 0}, place),
            read_numbers<4>(node, "rotation", {0, 0, 0, 1}, place), read_numbers<3>(node, "scale", {1, 1, 1}, place)};
}

Transform NodeMotion::transform() const {
    const auto& [x, y, z, w] = rotation;
    const auto& s = scale;
    const auto& t = translation;
    return {(1 - 2 * (y * y + z * z)) * s[0],
            2 * (x * y + z * w) * s[0],
            2 * (x * z - y * w) * s[0],
            2 * (x * y - z * w) * s[1],
            (1 - 2 * (x * x + z * z)) * s[1],
            2 * (y * z + x * w) * s[1],
            2 * (x * z + y * w) * s[2],
            2 * (y * z - x * w) * s[2],
            (1 - 2 * (x * x + y * y)) * s[2],
            t[0],
            t[1],
            t[2]};
}

Vector<uint64_t> read_node_list(const Json& object, const char* key, const String& place) {
    Vector<uint64_t> nodes;
    const Json* array = gltf_array(object, key, place);
    for (size_t i = 0; array && i < array->size(); ++i) {
        const Json& index = (*array)[i];
        const String element = place + "." + key + "[" + to_text(i) + "]";
        if (!index.is_count()) fail(FLG_ERROR_FORMAT, element, "is no whole number >= 0");
        nodes.push_back(index.count());
    }
    return nodes;
}

Vector<uint64_t> root_nodes(const GltfDocument& document) {
    if (document.size("scenes") != 0) {
        const uint64_t scene = gltf_unsigned(document.root(), "scene", 0, "");
        return read_node_list(document.element("scenes", scene, "scene"), "nodes", "scenes[" + to_text(scene) + "]");
    }
    Vector<bool> is_child(document.size("nodes"));
    for (uint64_t i = 0; i < is_child.size(); ++i) {
        const String place = "nodes[" + to_text(i) + "]";
        for (uint64_t child : read_node_list(document.element("nodes", i, place), "children", place)) {
            if (child < is_child.size()) is_child[child] = true;
        }
    }
    Vector<uint64_t> roots;
    for (uint64_t i = 0; i < is_child.size(); ++i) {
        if (!is_child[i]) roots.push_back(i);
    }
    return roots;
}

void visit_primitives(const GltfDocument& document, const Origin& origin,
                      const std::function<void(const GltfPrimitive&)>& visit) {
    SceneWalk walk(document, origin, visit);
    if (document.size("nodes") == 0)
        walk.meshes();
    else
        walk.nodes(root_nodes(document));
}

std::optional<GltfValues> read_attribute(const GltfDocument& document, const GltfPrimitive& primitive,
                                         const char* name) {
    const String place = primitive.place + ".attributes";
    const Json* const attributes = primitive.json.find("attributes");
    if (!attributes || !attributes->find(name)) return {};
    return document.accessor(gltf_required(*attributes, name, place), place + "." + name);
}

GltfVertices read_vertices(const GltfDocument& document, const GltfPrimitive& primitive) {
    const std::optional<GltfValues> positions = read_attribute(document, primitive, "POSITION");
    if (!positions) fail(FLG_ERROR_FORMAT, primitive.place + ".attributes", "has no POSITION");
    // Whole numbers, of nodes that scale them: KHR_mesh_quantization.
    if (positions->components != 3 || positions->component_type == gltf_unsigned_int) {
        fail(FLG_ERROR_FORMAT, positions->place, "holds positions that are not three floats, nor 8 or 16 bits each");
    }
    const std::optional<GltfValues> colors = read_attribute(document, primitive, "COLOR_0");
    if (colors && (colors->components < 3 || colors->count != positions->count ||
                   (colors->component_type != gltf_float && !colors->normalized))) {
        fail(FLG_ERROR_FORMAT, colors->place, "holds no colours fit for %llu vertices",
             static_cast<unsigned long long>(positions->count));
    }
    return {*positions, colors};
}

std::array<float, 3> GltfVertices::position(uint32_t vertex, const Transform& t) const {
    const float p[3] = {positions.number(vertex, 0), positions.number(vertex, 1), positions.number(vertex, 2)};
    std::array<float, 3> placed;
    for (size_t row = 0; row < 3; ++row) {
        placed[row] = static_cast<float>(t[row] * p[0] + t[3 + row] * p[1] + t[6 + row] * p[2] + t[9 + row]);
        if (!(std::abs(placed[row]) <= max_coordinate)) refuse_value(positions, vertex, placed[row]);
    }
    return placed;
}

std::array<float, 4> GltfVertices::color(uint32_t vertex) const {
    std::array<float, 4> color = {1, 1, 1, 1};
    for (uint32_t k = 0; colors && k < colors->components; ++k) {
        color[k] = colors->number(vertex, k);
        if (!std::isfinite(color[k])) refuse_value(*colors, vertex, color[k]);
    }
    return color;
}

std::optional<GltfValues> read_index_values(const GltfDocument& document, const GltfPrimitive& primitive) {
    if (!primitive.json.find("indices")) return {};
    GltfValues values =
        document.accessor(gltf_required(primitive.json, "indices", primitive.place), primitive.place + ".indices");
    if (values.components != 1 || !is_index_type(values.component_type)) {
        fail(FLG_ERROR_FORMAT, values.place, "holds indices that are no unsigned integers");
    }
    return values;
}

Vector<uint32_t> read_indices(const std::optional<GltfValues>& values, uint64_t vertex_count) {
    Vector<uint32_t> indices(values ? values->count : vertex_count);
    if (!values) std::iota(indices.begin(), indices.end(), 0u);
    for (uint64_t i = 0; values && i < values->count; ++i) {
        indices[i] = values->index(i);
        if (indices[i] < vertex_count) continue;
        fail(FLG_ERROR_FORMAT, values->place, "holds the index %u at %llu, but there are %llu vertices", indices[i],
             static_cast<unsigned long long>(i), static_cast<unsigned long long>(vertex_count));
    }
    return indices;
}

void refuse_value(const GltfValues& values, uint32_t vertex, float value) {
    fail(FLG_ERROR_FORMAT, values.place, "vertex %u gives %g: must be finite, at most 1e30 in size, radii >= 0", vertex,
         double{value});
}

}  // namespace flg::io
