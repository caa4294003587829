// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.5 scenes and nodes, 3.7.2 primitives).
// Each line primitive of each mesh that a node of the scene shows becomes curves, in the order of the nodes: a strip or
// loop one curve, single lines curves as far as one goes on where the one before it ended (the same index or the same
// position). Nodes' transforms are applied; radii (_RADIUS) grow by the cube root of the volume's change.
// A strip of the indices `a a` is a curve of one point (gltf_writer.cpp writes them so).
#include "io/gltf_reader.h"

#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "io/failure.h"
#include "io/gltf_document.h"
#include "io/limits.h"
#include "io/polylines.h"

namespace flg::io {

namespace {

constexpr uint64_t mode_lines = 1;
constexpr uint64_t mode_line_loop = 2;
constexpr uint64_t mode_line_strip = 3;
constexpr uint64_t mode_triangles = 4;  // the default
constexpr uint64_t mode_last = 6;
// Of positions, radii and colours together: what is made of a file is limited like the file.
constexpr uint64_t bytes_per_point = 8 * sizeof(float);

// An affine map: columns x, y, z and translation.
using Transform = std::array<double, 12>;
constexpr Transform identity = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

Transform operator*(const Transform& a, const Transform& b) {
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

template <size_t N>
std::array<double, N> read_numbers(const Json& node, const char* key, std::array<double, N> fallback,
                                   const std::string& place) {
    const Json* array = gltf_array(node, key, place);
    if (!array) return fallback;
    bool sound = array->size() == N;
    for (size_t i = 0; sound && i < N; ++i) {
        sound = (*array)[i].is_number();
        if (sound) fallback[i] = (*array)[i].get<double>();
    }
    if (!sound) fail(FLG_ERROR_FORMAT, place + "." + key, "must be %zu numbers", N);
    return fallback;
}

Transform local_transform(const Json& node, const std::string& place) {
    if (node.contains("matrix")) {
        const auto m = read_numbers<16>(node, "matrix", {}, place);
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
            fail(FLG_ERROR_FORMAT, place + ".matrix", "has a last row other than 0 0 0 1");
        }
        return {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10], m[12], m[13], m[14]};
    }
    const auto t = read_numbers<3>(node, "translation", {0, 0, 0}, place);
    const auto [x, y, z, w] = read_numbers<4>(node, "rotation", {0, 0, 0, 1}, place);
    const auto s = read_numbers<3>(node, "scale", {1, 1, 1}, place);
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

class GltfReader {
public:
    explicit GltfReader(const std::filesystem::path& path) : document_(path) {}

    CurveData read() {
        data_.format = "gltf";
        data_.units = "metres";
        if (document_.size("nodes") == 0) {
            for (uint64_t i = 0; i < document_.size("meshes"); ++i) read_mesh(i, identity, "meshes");
        } else {
            walk_nodes(root_nodes());
        }
        data_.warn(surfaces_, "primitive", "of points or triangles, left out: only lines are read");
        if (data_.curve_count() == 0) fail(FLG_ERROR_FORMAT, "meshes", "the file shows no lines");
        if (has_radius_) data_.warn(no_radius_, "curve", "no _RADIUS where others have one, set to 0.005 m");
        if (!has_radius_) data_.radii.clear();
        if (!has_color_) data_.colors.clear();
        return std::move(data_);
    }

private:
    struct Visit {
        uint64_t node;
        Transform parent;
    };

    std::vector<uint64_t> read_node_list(const Json& object, const char* key, const std::string& place) const {
        std::vector<uint64_t> nodes;
        const Json* array = gltf_array(object, key, place);
        for (size_t i = 0; array && i < array->size(); ++i) {
            const Json& index = (*array)[i];
            const std::string element = place + "." + key + "[" + std::to_string(i) + "]";
            if (!index.is_number_unsigned()) fail(FLG_ERROR_FORMAT, element, "is no whole number >= 0");
            nodes.push_back(index.get<uint64_t>());
        }
        return nodes;
    }

    // Of the scene to be shown; without scenes, all nodes that are no other's child.
    std::vector<uint64_t> root_nodes() const {
        if (document_.size("scenes") != 0) {
            const uint64_t scene = gltf_unsigned(document_.root(), "scene", 0, "");
            return read_node_list(document_.element("scenes", scene, "scene"), "nodes",
                                  "scenes[" + std::to_string(scene) + "]");
        }
        std::vector<bool> is_child(document_.size("nodes"));
        for (uint64_t i = 0; i < is_child.size(); ++i) {
            const std::string place = "nodes[" + std::to_string(i) + "]";
            for (uint64_t child : read_node_list(document_.element("nodes", i, place), "children", place)) {
                if (child < is_child.size()) is_child[child] = true;
            }
        }
        std::vector<uint64_t> roots;
        for (uint64_t i = 0; i < is_child.size(); ++i) {
            if (!is_child[i]) roots.push_back(i);
        }
        return roots;
    }

    void walk_nodes(const std::vector<uint64_t>& roots) {
        std::vector<bool> seen(document_.size("nodes"));
        std::vector<Visit> stack;
        for (size_t i = roots.size(); i-- > 0;) stack.push_back({roots[i], identity});
        while (!stack.empty()) {
            const Visit visit = stack.back();
            stack.pop_back();
            const std::string place = "nodes[" + std::to_string(visit.node) + "]";
            const Json& node = document_.element("nodes", visit.node, place);
            if (seen[visit.node]) fail(FLG_ERROR_FORMAT, place, "is shown twice: nodes must form trees");
            seen[visit.node] = true;
            const Transform transform = visit.parent * local_transform(node, place);
            if (node.contains("mesh")) read_mesh(gltf_required(node, "mesh", place), transform, place + ".mesh");
            const std::vector<uint64_t> children = read_node_list(node, "children", place);
            for (size_t i = children.size(); i-- > 0;) stack.push_back({children[i], transform});
        }
    }

    void read_mesh(uint64_t index, const Transform& transform, const std::string& referrer) {
        const Json& mesh = document_.element("meshes", index, referrer);
        const std::string place = "meshes[" + std::to_string(index) + "]";
        const Json* primitives = gltf_array(mesh, "primitives", place);
        for (size_t i = 0; primitives && i < primitives->size(); ++i) {
            const std::string primitive_place = place + ".primitives[" + std::to_string(i) + "]";
            if (!(*primitives)[i].is_object()) fail(FLG_ERROR_FORMAT, primitive_place, "is no object");
            read_primitive((*primitives)[i], i, transform, primitive_place);
        }
    }

    std::optional<GltfValues> attribute(const Json& attributes, const char* name, const std::string& place) const {
        if (!attributes.contains(name)) return {};
        return document_.accessor(gltf_required(attributes, name, place), place + "." + name);
    }

    void read_primitive(const Json& primitive, uint64_t index, const Transform& transform, const std::string& place) {
        const uint64_t mode = gltf_unsigned(primitive, "mode", mode_triangles, place);
        if (mode > mode_last) {
            fail(FLG_ERROR_FORMAT, place + ".mode", "is %llu, must be 0 to 6", static_cast<unsigned long long>(mode));
        }
        if (mode != mode_lines && mode != mode_line_loop && mode != mode_line_strip) {
            surfaces_.add(index);
            return;
        }
        const auto attributes = primitive.find("attributes");
        const std::string attributes_place = place + ".attributes";
        if (attributes == primitive.end() || !attributes->is_object() || !attributes->contains("POSITION")) {
            fail(FLG_ERROR_FORMAT, attributes_place, "has no POSITION");
        }
        const GltfValues positions = *attribute(*attributes, "POSITION", attributes_place);
        const std::optional<GltfValues> colors = attribute(*attributes, "COLOR_0", attributes_place);
        const std::optional<GltfValues> radii = attribute(*attributes, "_RADIUS", attributes_place);
        if (positions.component_type != gltf_float || positions.components != 3) {
            fail(FLG_ERROR_FORMAT, positions.place, "holds positions that are not three floats");
        }
        if (colors && (colors->components < 3 || colors->count != positions.count ||
                       (colors->component_type != gltf_float && !colors->normalized))) {
            fail(FLG_ERROR_FORMAT, colors->place, "holds no colours fit for %llu vertices",
                 static_cast<unsigned long long>(positions.count));
        }
        if (radii && (radii->components != 1 || radii->count != positions.count)) {
            fail(FLG_ERROR_FORMAT, radii->place, "holds no radii fit for %llu vertices",
                 static_cast<unsigned long long>(positions.count));
        }
        append(read_polylines(primitive, mode, positions, place), positions, colors, radii, transform);
    }

    Polylines read_polylines(const Json& primitive, uint64_t mode, const GltfValues& positions,
                             const std::string& place) const {
        std::vector<uint32_t> indices;
        if (primitive.contains("indices")) {
            const GltfValues values =
                document_.accessor(gltf_required(primitive, "indices", place), place + ".indices");
            if (values.components != 1 || values.component_type == gltf_float || values.component_type == gltf_byte ||
                values.component_type == gltf_short) {
                fail(FLG_ERROR_FORMAT, values.place, "holds indices that are no unsigned integers");
            }
            check_room(values.count, place);
            indices.resize(values.count);
            for (uint64_t i = 0; i < values.count; ++i) {
                indices[i] = values.index(i);
                if (indices[i] < positions.count) continue;
                fail(FLG_ERROR_FORMAT, values.place, "holds the index %u at %llu, but there are %llu vertices",
                     indices[i], static_cast<unsigned long long>(i), static_cast<unsigned long long>(positions.count));
            }
        } else {
            check_room(positions.count, place);
            indices.resize(positions.count);
            std::iota(indices.begin(), indices.end(), 0u);
        }

        Polylines lines;
        if (mode != mode_lines) {
            lines.indices = std::move(indices);
            lines.end(mode == mode_line_loop);
            return lines;
        }
        if (indices.size() % 2 != 0) fail(FLG_ERROR_FORMAT, place, "has %zu ends of lines, not pairs", indices.size());
        const auto same = [&](uint32_t a, uint32_t b) {
            return a == b || (positions.number(a, 0) == positions.number(b, 0) &&
                              positions.number(a, 1) == positions.number(b, 1) &&
                              positions.number(a, 2) == positions.number(b, 2));
        };
        join_edges(
            indices.size() / 2, [&](size_t e) { return std::pair(indices[2 * e], indices[2 * e + 1]); }, same, lines);
        return lines;
    }

    // Meshes may be shown many times, and primitives share vertices: a small file could ask for very much.
    void check_room(uint64_t points, const std::string& place) const {
        if ((data_.point_count() + points) * bytes_per_point > max_bytes) {
            fail(FLG_ERROR_LIMIT, place, "the file's curves take more than the limit of 2 GiB");
        }
    }

    void append(const Polylines& lines, const GltfValues& positions, const std::optional<GltfValues>& colors,
                const std::optional<GltfValues>& radii, const Transform& transform) {
        const float radius_scale = static_cast<float>(std::cbrt(std::abs(determinant(transform))));
        has_color_ |= colors.has_value();
        has_radius_ |= radii.has_value();
        for (size_t c = 0; c < lines.count(); ++c) {
            if (!radii) no_radius_.add(data_.curve_count());
            for (size_t i = lines.offsets[c]; i < lines.offsets[c + 1]; ++i) {
                const uint32_t vertex = lines.indices[i];
                append_position(positions, vertex, transform);
                for (uint32_t k = 0; k < 4; ++k) {
                    const float value = colors && k < colors->components ? colors->number(vertex, k) : 1.0f;
                    if (!std::isfinite(value)) refuse(*colors, vertex, value);
                    data_.colors.push_back(value);
                }
                const float radius = radii ? radii->number(vertex, 0) * radius_scale : default_radius;
                if (!(radius >= 0 && radius <= max_coordinate)) refuse(*radii, vertex, radius);
                data_.radii.push_back(radius);
            }
            data_.end_curve(lines.closed[c]);
        }
    }

    void append_position(const GltfValues& positions, uint32_t vertex, const Transform& t) {
        const float p[3] = {positions.number(vertex, 0), positions.number(vertex, 1), positions.number(vertex, 2)};
        for (size_t row = 0; row < 3; ++row) {
            // Left alone by the identity, bit for bit.
            const float value = static_cast<float>(t[row] * p[0] + t[3 + row] * p[1] + t[6 + row] * p[2] + t[9 + row]);
            if (!(std::abs(value) <= max_coordinate)) refuse(positions, vertex, value);
            data_.positions.push_back(value);
        }
    }

    [[noreturn]] static void refuse(const GltfValues& values, uint32_t vertex, float value) {
        fail(FLG_ERROR_FORMAT, values.place, "vertex %u gives %g: must be finite, at most 1e30 in size, radii >= 0",
             vertex, double{value});
    }

    GltfDocument document_;
    CurveData data_;
    bool has_color_ = false;
    bool has_radius_ = false;
    Tally surfaces_;
    Tally no_radius_;
};

}  // namespace

CurveData read_gltf(const std::filesystem::path& path) {
    return GltfReader(path).read();
}

}  // namespace flg::io
