// SPDX-License-Identifier: MIT
#include "io/gltf/glb_builder.h"

#include <algorithm>

#include "io/base/failure.h"
#include "io/base/json_text.h"
#include "io/base/limits.h"
#include "io/gltf/glb_layout.h"

namespace flg::io {

namespace {

constexpr uint32_t target_vertices = 34962;
constexpr uint32_t target_indices = 34963;
constexpr size_t glb_alignment = 4;

}  // namespace

size_t GlbBuilder::List::add(String text) {
    if (taken < free.size()) {
        texts[free[taken]] = std::move(text);
        return free[taken++];
    }
    texts.push_back(std::move(text));
    return texts.size() - 1;
}

void GlbBuilder::List::fill(const char* text) {
    for (; taken < free.size(); ++taken) texts[free[taken]] = text;
}

void GlbBuilder::fill_places() {
    views_.fill("{\"buffer\":0,\"byteLength\":1}");
    accessors_.fill("{\"componentType\":5121,\"count\":1,\"type\":\"SCALAR\"}");
}

String GlbBuilder::List::joined() const {
    String list;
    for (const String& text : texts) {
        separate(list);
        list += text;
    }
    return list;
}

size_t GlbBuilder::add_view(std::span<const float> values, uint32_t components) {
    return add_bytes(values.data(), values.size_bytes(), target_vertices,
                     ",\"byteStride\":" + to_text(components * sizeof(float)));
}

size_t GlbBuilder::add_view(std::span<const uint32_t> indices) {
    return add_bytes(indices.data(), indices.size_bytes(), target_indices, "");
}

size_t GlbBuilder::add_indices(std::span<const uint32_t> indices) {
    constexpr uint32_t restart = 65535;  // of 16 bits
    const uint32_t most = *std::max_element(indices.begin(), indices.end());
    if (most >= restart) return add_accessor(add_view(indices), 0, indices.size(), glb_unsigned, "SCALAR");
    const Vector<uint16_t> narrow(indices.begin(), indices.end());
    const size_t view = add_bytes(narrow.data(), narrow.size() * sizeof(uint16_t), target_indices, "");
    return add_accessor(view, 0, narrow.size(), glb_unsigned_short, "SCALAR");
}

size_t GlbBuilder::add_view(std::span<const uint16_t> fours) {
    return add_bytes(fours.data(), fours.size_bytes(), target_vertices, ",\"byteStride\":8");
}

size_t GlbBuilder::add_view(std::span<const uint8_t> fours) {
    return add_bytes(fours.data(), fours.size_bytes(), target_vertices, ",\"byteStride\":4");
}

size_t GlbBuilder::add_plain_view(std::span<const float> values) {
    return add_bytes(values.data(), values.size_bytes(), 0, "");
}

size_t GlbBuilder::add_file(std::span<const uint8_t> bytes) {
    return add_bytes(bytes.data(), bytes.size(), 0, "");
}

size_t GlbBuilder::add_colors(Vector<float> colors) {
    for (float& value : colors) value = std::clamp(value, 0.0f, 1.0f);
    return add_view(colors, 4);
}

size_t GlbBuilder::add_accessor(size_t view, size_t byte_offset, size_t count, uint32_t component_type,
                                const char* type, const String& bounds) {
    return accessors_.add("{\"bufferView\":" + to_text(view) + ",\"byteOffset\":" + to_text(byte_offset) +
                          ",\"componentType\":" + to_text(component_type) + ",\"count\":" + to_text(count) +
                          ",\"type\":\"" + type + "\"" + bounds + "}");
}

size_t GlbBuilder::add_times(std::span<const float> times) {
    const auto [low, high] = std::minmax_element(times.begin(), times.end());
    return add_accessor(add_plain_view(times), 0, times.size(), glb_float, "SCALAR",
                        ",\"min\":[" + json_number(*low) + "],\"max\":[" + json_number(*high) + "]");
}

namespace {

constexpr size_t components = 3;

// The least and largest of each coordinate, as JSON.
String bounds_of(std::span<const float> positions, size_t first, size_t count) {
    float low[components], high[components];
    for (size_t k = 0; k < components; ++k) {
        low[k] = high[k] = positions[first * components + k];
        for (size_t i = first; i < first + count; ++i) {
            low[k] = std::min(low[k], positions[i * components + k]);
            high[k] = std::max(high[k], positions[i * components + k]);
        }
    }
    String bounds;
    for (const auto& [name, values] : {std::pair(",\"min\":[", low), std::pair(",\"max\":[", high)}) {
        bounds += name;
        for (size_t k = 0; k < components; ++k) {
            if (k != 0) bounds += ',';
            bounds += json_number(values[k]);
        }
        bounds += ']';
    }
    return bounds;
}

}  // namespace

size_t GlbBuilder::add_positions(size_t view, std::span<const float> positions, size_t first, size_t count,
                                 const String& further) {
    return add_accessor(view, first * components * sizeof(float), count, glb_float, "VEC3",
                        bounds_of(positions, first, count) + further);
}

size_t GlbBuilder::add_moves(std::span<const float> moves, bool with_bounds) {
    const size_t count = moves.size() / components;
    const String bounds = with_bounds ? bounds_of(moves, 0, count) : "";
    Vector<uint32_t> moving;
    for (size_t v = 0; v < count; ++v) {
        const float* move = &moves[components * v];
        if (move[0] != 0 || move[1] != 0 || move[2] != 0) moving.push_back(static_cast<uint32_t>(v));
    }
    if (moving.size() * (components + 1) >= components * count)
        return add_accessor(add_view(moves, components), 0, count, glb_float, "VEC3", bounds);
    if (moving.empty()) moving.push_back(0);  // one must be there
    Vector<float> values;
    for (const uint32_t v : moving) values.insert(values.end(), &moves[components * v], &moves[components * v] + 3);
    const size_t indices = add_bytes(moving.data(), moving.size() * sizeof(uint32_t), 0, "");
    const size_t view = add_plain_view(values);
    return accessors_.add(
        "{\"componentType\":" + to_text(glb_float) + ",\"count\":" + to_text(count) + ",\"type\":\"VEC3\"" + bounds +
        ",\"sparse\":{\"count\":" + to_text(moving.size()) + ",\"indices\":{\"bufferView\":" + to_text(indices) +
        ",\"componentType\":" + to_text(glb_unsigned) + "},\"values\":{\"bufferView\":" + to_text(view) + "}}}");
}

void GlbBuilder::add_primitive(const String& attributes, int mode, const String& rest) {
    separate(primitives_);
    primitives_ += "{\"attributes\":{" + attributes + "},\"mode\":" + to_text(mode) + rest + "}";
}

size_t GlbBuilder::end_mesh(const String& rest) {
    separate(meshes_);
    meshes_ += "{\"primitives\":[" + primitives_ + "]" + rest + "}";
    primitives_.clear();
    return mesh_count_++;
}

String GlbBuilder::finish(const String& materials, const Origin& origin) const {
    return finish_scene("\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0" + json_translation(origin) +
                            "}]," + materials,
                        "");
}

String GlbBuilder::finish_scene(const String& top, const String& mesh_name) const {
    const String name = mesh_name.empty() ? "" : "\"name\":" + json_text(mesh_name) + ",";
    const String list = meshes_.empty() ? "{" + name + "\"primitives\":[" + primitives_ + "]}" : meshes_;
    String json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Filigree\"}," + top +
                  (primitives_.empty() && meshes_.empty() ? "" : "\"meshes\":[" + list + "],") + "\"accessors\":[" +
                  accessors_.joined() + "],\"bufferViews\":[" + views_.joined() +
                  "],\"buffers\":[{\"byteLength\":" + to_text(binary_.size()) + "}]}";
    return glb_file(std::move(json), binary_);
}

String glb_file(String json, const String& binary) {
    json.resize((json.size() + glb_alignment - 1) / glb_alignment * glb_alignment, ' ');
    constexpr size_t headers = 7 * sizeof(uint32_t);
    const size_t total = headers + json.size() + binary.size();
    if (total > max_bytes) fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", total);
    String glb;
    glb.reserve(total);
    const auto append = [&](size_t value) {
        const uint32_t word = static_cast<uint32_t>(value);
        glb.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    for (size_t value : {size_t{glb_magic}, size_t{glb_version}, total, json.size(), size_t{glb_json}}) append(value);
    glb += json;
    append(binary.size());
    append(glb_binary);
    glb += binary;
    return glb;
}

// Views begin at multiples of 4 bytes. Target 0: none.
size_t GlbBuilder::add_bytes(const void* data, size_t size, uint32_t target, const String& rest) {
    const size_t index =
        views_.add("{\"buffer\":0,\"byteOffset\":" + to_text(binary_.size()) + ",\"byteLength\":" + to_text(size) +
                   (target == 0 ? "" : ",\"target\":" + to_text(target)) + rest + "}");
    binary_.append(static_cast<const char*>(data), size);
    binary_.resize((binary_.size() + glb_alignment - 1) / glb_alignment * glb_alignment, '\0');
    return index;
}

}  // namespace flg::io
