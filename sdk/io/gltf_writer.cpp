// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.6 accessors, 4 GLB). One node, one mesh. Lines: one LINE_STRIP or LINE_LOOP
// a curve, all in shared buffer views; a curve of one point is a strip of the indices 0 0. Surfaces: one primitive of
// triangles with 32-bit indices. Colours are clamped to 0..1, as COLOR_0 asks for.
#include "io/gltf_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "io/failure.h"
#include "io/limits.h"
#include "io/swept_mesh.h"

namespace flg::io {

namespace {

constexpr uint32_t component_float = 5126;
constexpr uint32_t component_unsigned = 5125;
constexpr uint32_t target_vertices = 34962;
constexpr uint32_t target_indices = 34963;
constexpr int mode_line_loop = 2;
constexpr int mode_line_strip = 3;
constexpr int mode_triangles = 4;
constexpr uint32_t glb_magic = 0x46546c67;
constexpr uint32_t glb_version = 2;
constexpr uint32_t glb_json = 0x4e4f534a;
constexpr uint32_t glb_binary = 0x004e4942;
constexpr size_t glb_alignment = 4;

// A float's shortest text as a double: JSON readers get exactly the float.
void append_exact(std::string& text, float value) {
    char buffer[32];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, double{value}).ptr);
}

class GlbBuilder {
public:
    // Values of `components` floats each; returns the buffer view's index.
    size_t add_view(std::span<const float> values, uint32_t components) {
        return add_bytes(values.data(), values.size_bytes(), target_vertices,
                         ",\"byteStride\":" + std::to_string(components * sizeof(float)));
    }
    size_t add_view(std::span<const uint32_t> indices) {
        return add_bytes(indices.data(), indices.size_bytes(), target_indices, "");
    }

    size_t add_accessor(size_t view, size_t byte_offset, size_t count, uint32_t component_type, const char* type,
                        const std::string& bounds = "") {
        separate(accessors_);
        accessors_ += "{\"bufferView\":" + std::to_string(view) + ",\"byteOffset\":" + std::to_string(byte_offset) +
                      ",\"componentType\":" + std::to_string(component_type) + ",\"count\":" + std::to_string(count) +
                      ",\"type\":\"" + type + "\"" + bounds + "}";
        return accessor_count_++;
    }

    // Points first .. first + count - 1 of a view of positions.
    size_t add_positions(size_t view, std::span<const float> positions, size_t first, size_t count) {
        constexpr size_t components = 3;
        float low[components], high[components];
        for (size_t k = 0; k < components; ++k) {
            low[k] = high[k] = positions[first * components + k];
            for (size_t i = first; i < first + count; ++i) {
                low[k] = std::min(low[k], positions[i * components + k]);
                high[k] = std::max(high[k], positions[i * components + k]);
            }
        }
        std::string bounds;
        for (const auto& [name, values] : {std::pair(",\"min\":[", low), std::pair(",\"max\":[", high)}) {
            bounds += name;
            for (size_t k = 0; k < components; ++k) {
                if (k != 0) bounds += ',';
                append_exact(bounds, values[k]);
            }
            bounds += ']';
        }
        return add_accessor(view, first * components * sizeof(float), count, component_float, "VEC3", bounds);
    }

    void add_primitive(const std::string& attributes, int mode, const std::string& rest) {
        separate(primitives_);
        primitives_ += "{\"attributes\":{" + attributes + "},\"mode\":" + std::to_string(mode) + rest + "}";
    }

    std::string finish(const std::string& materials) {
        std::string json =
            "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Filigree\"},\"scene\":0,"
            "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[" +
            primitives_ + "]}]," + materials + "\"accessors\":[" + accessors_ + "],\"bufferViews\":[" + views_ +
            "],\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + "}]}";
        json.resize((json.size() + glb_alignment - 1) / glb_alignment * glb_alignment, ' ');
        constexpr size_t headers = 7 * sizeof(uint32_t);
        const size_t total = headers + json.size() + binary_.size();
        if (total > max_bytes) fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", total);
        std::string glb;
        glb.reserve(total);
        const auto append = [&](size_t value) {
            const uint32_t word = static_cast<uint32_t>(value);
            glb.append(reinterpret_cast<const char*>(&word), sizeof word);
        };
        for (size_t value : {size_t{glb_magic}, size_t{glb_version}, total, json.size(), size_t{glb_json}})
            append(value);
        glb += json;
        append(binary_.size());
        append(glb_binary);
        glb += binary_;
        return glb;
    }

private:
    static void separate(std::string& list) {
        if (!list.empty()) list += ',';
    }

    // All values take 4 bytes, so that every view is aligned.
    size_t add_bytes(const void* data, size_t size, uint32_t target, const std::string& rest) {
        separate(views_);
        views_ += "{\"buffer\":0,\"byteOffset\":" + std::to_string(binary_.size()) +
                  ",\"byteLength\":" + std::to_string(size) + ",\"target\":" + std::to_string(target) + rest + "}";
        binary_.append(static_cast<const char*>(data), size);
        return view_count_++;
    }

    std::string binary_, views_, accessors_, primitives_;
    size_t view_count_ = 0, accessor_count_ = 0;
};

std::vector<float> packed(const CheckedView& view, const Column& column, uint32_t components) {
    std::vector<float> values;
    values.reserve(view.point_count() * components);
    for (size_t i = 0; i < view.point_count(); ++i)
        values.insert(values.end(), column.at(i), column.at(i) + components);
    return values;
}

void clamp_colors(std::vector<float>& colors) {
    for (float& value : colors) value = std::clamp(value, 0.0f, 1.0f);
}

std::string write_lines(const CheckedView& view) {
    GlbBuilder glb;
    const std::vector<float> positions = packed(view, view.position, 3);
    const size_t position_view = glb.add_view(positions, 3);
    size_t color_view = 0;
    size_t radius_view = 0;
    if (view.color) {
        std::vector<float> colors = packed(view, view.color, 4);
        clamp_colors(colors);
        color_view = glb.add_view(colors, 4);
    }
    if (view.radius) radius_view = glb.add_view(packed(view, view.radius, 1), 1);
    std::string lone_indices;  // of all curves of one point

    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        const size_t first = view.begin(c);
        const size_t count = view.end(c) - first;
        std::string attributes =
            "\"POSITION\":" + std::to_string(glb.add_positions(position_view, positions, first, count));
        if (view.color) {
            const size_t accessor =
                glb.add_accessor(color_view, first * 4 * sizeof(float), count, component_float, "VEC4");
            attributes += ",\"COLOR_0\":" + std::to_string(accessor);
        }
        if (view.radius) {
            const size_t accessor =
                glb.add_accessor(radius_view, first * sizeof(float), count, component_float, "SCALAR");
            attributes += ",\"_RADIUS\":" + std::to_string(accessor);
        }
        if (count == 1 && lone_indices.empty()) {
            const uint32_t zeros[] = {0, 0};
            const size_t accessor = glb.add_accessor(glb.add_view(zeros), 0, 2, component_unsigned, "SCALAR");
            lone_indices = ",\"indices\":" + std::to_string(accessor);
        }
        glb.add_primitive(attributes, view.closed(c) ? mode_line_loop : mode_line_strip,
                          count == 1 ? lone_indices : "");
    }
    return glb.finish("");
}

std::string write_surface(const CheckedView& view, const FlgCurveWriteDesc& desc) {
    SweptMesh mesh = sweep(view, desc);
    if (mesh.indices.empty()) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view", "has no curve with a length: there is no surface to write");
    }
    // A radius near the limit may carry a vertex beyond it.
    for (float value : mesh.positions) {
        if (!std::isfinite(value)) fail(FLG_ERROR_INVALID_ARGUMENT, "view", "has radii too large for its positions");
    }
    GlbBuilder glb;
    const size_t count = mesh.positions.size() / 3;
    const size_t positions = glb.add_positions(glb.add_view(mesh.positions, 3), mesh.positions, 0, count);
    const size_t normals = glb.add_accessor(glb.add_view(mesh.normals, 3), 0, count, component_float, "VEC3");
    std::string attributes = "\"POSITION\":" + std::to_string(positions) + ",\"NORMAL\":" + std::to_string(normals);
    if (!mesh.colors.empty()) {
        clamp_colors(mesh.colors);
        const size_t colors = glb.add_accessor(glb.add_view(mesh.colors, 4), 0, count, component_float, "VEC4");
        attributes += ",\"COLOR_0\":" + std::to_string(colors);
    }
    const size_t indices =
        glb.add_accessor(glb.add_view(mesh.indices), 0, mesh.indices.size(), component_unsigned, "SCALAR");
    glb.add_primitive(attributes, mode_triangles, ",\"indices\":" + std::to_string(indices) + ",\"material\":0");
    const char* sides = desc.geometry == FLG_GEOMETRY_RIBBON ? "true" : "false";
    return glb.finish(std::string("\"materials\":[{\"doubleSided\":") + sides +
                      ",\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.6}}],");
}

}  // namespace

std::string write_glb(const CheckedView& view, const FlgCurveWriteDesc& desc) {
    return desc.geometry == FLG_GEOMETRY_LINES ? write_lines(view) : write_surface(view, desc);
}

}  // namespace flg::io
