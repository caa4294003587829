// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (sections 3.6, 4.4 and 5).
// Invariants: nothing is read outside the bytes that are there; files are read only below the document's folder; all
// buffers together hold at most 2 GiB, and JSON nests at most max_depth levels.
// Written here rather than on tinygltf: io's README says why.
#include "io/gltf/gltf_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/base/byte_reader.h"
#include "io/base/limits.h"
#include "io/gltf/glb_layout.h"

namespace flg::io {

namespace {

constexpr uint32_t max_depth = 128;
// Parsed JSON takes an order of magnitude more memory than its text.
constexpr uint64_t max_json = uint64_t{1} << 29;
constexpr uint64_t min_stride = 4;
constexpr uint64_t max_stride = 252;

String element_place(const char* array, uint64_t index) {
    return String(array) + "[" + to_text(index) + "]";
}

int base64_value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    if (c == '+') return 62;
    return c == '/' ? 63 : -1;
}

ByteBlock decode_base64(std::string_view text, const String& place) {
    while (text.ends_with('=')) text.remove_suffix(1);
    ByteBlock block(text.size() * 3 / 4);
    uint32_t bits = 0;
    size_t out = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        const int value = base64_value(text[i]);
        if (value < 0) fail(FLG_ERROR_FORMAT, place, "is no base64: %s", cited(text.substr(i, 1)).c_str());
        bits = bits << 6 | static_cast<uint32_t>(value);
        if (i % 4 != 0) block.data()[out++] = static_cast<uint8_t>(bits >> (6 - 2 * (i % 4)));
    }
    return block;
}

String decode_percent(std::string_view uri) {
    const auto hex = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    String result;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool coded = uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0;
        result += coded ? static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2])) : uri[i];
        if (coded) i += 2;
    }
    return result;
}

uint32_t component_size(uint32_t type) {
    switch (type) {
        case gltf_byte:
        case gltf_unsigned_byte: return 1;
        case gltf_short:
        case gltf_unsigned_short: return 2;
        case gltf_unsigned_int:
        case gltf_float: return 4;
        default: return 0;
    }
}

template <class T>
T load(const uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

uint32_t load_index(const uint8_t* at, uint32_t type) {
    if (type == gltf_unsigned_byte) return *at;
    return type == gltf_unsigned_short ? load<uint16_t>(at) : load<uint32_t>(at);
}

template <class T>
float normalized_number(const uint8_t* at, bool normalized) {
    const float value = static_cast<float>(load<T>(at));
    return normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f) : value;
}

// What accessors without a bufferView hold: a value of any type.
constexpr uint8_t zeros[16 * sizeof(float)] = {};

uint32_t component_type(const Json& json, const String& place) {
    const uint64_t type = gltf_required(json, "componentType", place);
    const uint32_t known = type <= gltf_float ? static_cast<uint32_t>(type) : 0;
    if (component_size(known) == 0) {
        fail(FLG_ERROR_FORMAT, place + ".componentType", "is %llu, which is none of glTF's",
             static_cast<unsigned long long>(type));
    }
    return known;
}

// The first of `count` values that begin at `offset`, all inside of the view.
const uint8_t* values_in(const GltfDocument::View& view, uint64_t offset, uint64_t count, uint64_t size,
                         uint64_t stride, const String& count_place) {
    const uint64_t room = offset <= view.bytes.size() ? view.bytes.size() - offset : 0;
    // The last value need not fill its stride.
    const uint64_t fitting = room >= size ? (room - size) / stride + 1 : 0;
    if (count == 0 || count > fitting) {
        fail(FLG_ERROR_FORMAT, count_place, "is %llu, but its bufferView holds %llu values",
             static_cast<unsigned long long>(count), static_cast<unsigned long long>(fitting));
    }
    return view.bytes.data() + offset;
}

// Extensions that keep vertices where this reader does not look: without them a mesh would be empty, or zeros.
constexpr std::string_view unknown_geometry[] = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                 "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};

void refuse_unknown_geometry(const Json& root) {
    const Json* required = gltf_array(root, "extensionsRequired", "");
    for (size_t i = 0; required && i < required->size(); ++i) {
        const Json& name = (*required)[i];
        for (std::string_view unknown : unknown_geometry) {
            if (!(name == unknown)) continue;
            fail(FLG_ERROR_FORMAT, "extensionsRequired[" + to_text(i) + "]", "is %s, which is not supported",
                 cited(unknown).c_str());
        }
    }
}

}  // namespace

bool is_index_type(uint32_t component_type) {
    return component_type == gltf_unsigned_byte || component_type == gltf_unsigned_short ||
           component_type == gltf_unsigned_int;
}

const uint8_t* GltfValues::at(uint64_t element) const {
    uint64_t first = 0, last = sparse_count;
    while (first < last) {
        const uint64_t middle = (first + last) / 2;
        if (sparse_element(middle) < element)
            first = middle + 1;
        else
            last = middle;
    }
    if (first < sparse_count && sparse_element(first) == element) return sparse_data + first * element_size();
    return data + element * stride;
}

uint64_t GltfValues::element_size() const {
    return uint64_t{components} * component_size(component_type);
}

uint32_t GltfValues::sparse_element(uint64_t i) const {
    return load_index(sparse_indices + i * component_size(sparse_type), sparse_type);
}

float GltfValues::number(uint64_t element, uint32_t component) const {
    const uint8_t* from = at(element) + component * component_size(component_type);
    switch (component_type) {
        case gltf_byte: return normalized_number<int8_t>(from, normalized);
        case gltf_unsigned_byte: return normalized_number<uint8_t>(from, normalized);
        case gltf_short: return normalized_number<int16_t>(from, normalized);
        case gltf_unsigned_short: return normalized_number<uint16_t>(from, normalized);
        case gltf_unsigned_int: return normalized_number<uint32_t>(from, normalized);
        default: return load<float>(from);
    }
}

uint32_t GltfValues::index(uint64_t element) const {
    return load_index(at(element), component_type);
}

uint64_t gltf_unsigned(const Json& object, const char* key, uint64_t fallback, const String& place) {
    const Json* const found = object.find(key);
    if (!found) return fallback;
    if (!found->is_count()) fail(FLG_ERROR_FORMAT, place + "." + key, "is no whole number >= 0");
    return found->count();
}

uint64_t gltf_required(const Json& object, const char* key, const String& place) {
    if (!object.find(key)) fail(FLG_ERROR_FORMAT, place, "has no %s", key);
    return gltf_unsigned(object, key, 0, place);
}

const Json* gltf_array(const Json& object, const char* key, const String& place) {
    const Json* const found = object.find(key);
    if (found && !found->is_array()) fail(FLG_ERROR_FORMAT, place.empty() ? key : place + "." + key, "is no array");
    return found;
}

GltfDocument::GltfDocument(const Path& path) : path_(path), file_(read_file(path, "")) {
    Bytes binary;
    Bytes text = file_.bytes();
    if (text.size() >= sizeof glb_magic && load<uint32_t>(text.data()) == glb_magic) text = split_glb(text, binary);
    if (text.size() > max_json) {
        fail(FLG_ERROR_LIMIT, "", "holds %zu bytes of JSON, more than the limit of 512 MiB", text.size());
    }
    json_.emplace(text, max_depth);
    const Json* const asset = root().find("asset");
    const Json* const version = asset ? asset->find("version") : nullptr;
    if (!version) fail(FLG_ERROR_FORMAT, "asset.version", "is missing: no glTF file");
    if (!version->string_or("").starts_with("2.")) {
        fail(FLG_ERROR_FORMAT, "asset.version", "is %s; only 2.x is known",
             cited(version->string_or("no text")).c_str());
    }
    refuse_unknown_geometry(root());
    load_buffers(binary);
}

Bytes GltfDocument::split_glb(Bytes file, Bytes& binary) const {
    ByteReader reader(file, "", sizeof glb_magic);
    if (const auto version = reader.read<uint32_t>("the header"); version != glb_version) {
        fail(FLG_ERROR_FORMAT, "@4", "has the GLB version %u; only %u is known", version, glb_version);
    }
    const auto length = reader.read<uint32_t>("the header");
    if (length > file.size()) {
        fail(FLG_ERROR_FORMAT, "@8", "declares %u bytes but has %zu: cut off?", length, file.size());
    }
    Bytes json;
    for (bool first = true; reader.position() + 2 * sizeof(uint32_t) <= length; first = false) {
        const String place = reader.place();
        const auto size = reader.read<uint32_t>("a chunk's header");
        const auto type = reader.read<uint32_t>("a chunk's header");
        if (size > length - reader.position()) {
            fail(FLG_ERROR_FORMAT, place, "declares a chunk of %u bytes, but %zu are left", size,
                 length - reader.position());
        }
        const Bytes chunk = reader.take(size, "a chunk");
        if (first != (type == glb_json)) fail(FLG_ERROR_FORMAT, place, "the first chunk, and only it, must be JSON");
        if (type == glb_json) json = chunk;
        if (type == glb_binary && binary.empty()) binary = chunk;
    }
    if (json.empty()) fail(FLG_ERROR_FORMAT, byte_place("", reader.position()), "has no JSON chunk");
    return json;
}

void GltfDocument::load_buffers(Bytes binary) {
    uint64_t total = 0;
    for (uint64_t i = 0; i < size("buffers"); ++i) {
        const String place = element_place("buffers", i);
        const Json& buffer = element("buffers", i, place);
        const uint64_t length = gltf_required(buffer, "byteLength", place);
        const Json* const uri = buffer.find("uri");
        Bytes bytes = binary;
        if (uri) {
            if (!uri->is_string()) fail(FLG_ERROR_FORMAT, place + ".uri", "is no string");
            loaded_.push_back(load_uri(uri->string(), place + ".uri"));
            bytes = loaded_.back().bytes();
            total += bytes.size();
        } else if (i != 0 || binary.data() == nullptr) {
            fail(FLG_ERROR_FORMAT, place, "has no uri, and the file no binary chunk for it");
        }
        if (length > bytes.size()) {
            fail(FLG_ERROR_FORMAT, place + ".byteLength", "is %llu, but %zu bytes are there",
                 static_cast<unsigned long long>(length), bytes.size());
        }
        if (total > max_bytes) fail(FLG_ERROR_LIMIT, place, "all buffers hold more than the limit of 2 GiB");
        buffers_.push_back(bytes.first(length));
    }
}

ByteBlock GltfDocument::load_uri(std::string_view uri, const String& place) const {
    if (uri.starts_with("data:")) {
        constexpr std::string_view marker = ";base64,";
        const size_t at = uri.find(marker);
        if (at == uri.npos) fail(FLG_ERROR_FORMAT, place, "is a data URI, but not of base64");
        return decode_base64(uri.substr(at + marker.size()), place);
    }
    // Only plain names below the document's folder: no schemes, drives, roots, parents, nor links that lead out.
    const String name = decode_percent(uri);
    const bool parent = ("/" + name + "/").find("/../") != name.npos;
    if (name.empty() || name.find_first_of(std::string_view(":\\\0", 3)) != name.npos || name.starts_with('/') ||
        parent) {
        fail(FLG_ERROR_FORMAT, place, "must be a relative path below the file's folder: %s", cited(name).c_str());
    }
    const Path target = path_.beside(name);
    if (!target.host() && !file_exists(target))
        fail(FLG_ERROR_FILE, place, "can't be opened: %s is not there", cited(name).c_str());
    if (!stays_beside(target, path_)) {
        fail(FLG_ERROR_FORMAT, place, "leads out of the file's folder: %s", cited(name).c_str());
    }
    return read_file(target, place);
}

size_t GltfDocument::size(const char* array) const {
    const Json* found = gltf_array(root(), array, "");
    return found ? found->size() : 0;
}

const Json& GltfDocument::element(const char* array, uint64_t index, const String& place) const {
    if (index >= size(array)) {
        fail(FLG_ERROR_FORMAT, place, "refers to %s %llu of %zu", array, static_cast<unsigned long long>(index),
             size(array));
    }
    const Json& found = (*root().find(array))[index];
    if (!found.is_object()) fail(FLG_ERROR_FORMAT, element_place(array, index), "is no object");
    return found;
}

GltfValues GltfDocument::accessor(uint64_t index, const String& place) const {
    return values_of(index, place, false);
}

GltfValues GltfDocument::matrices(uint64_t index, const String& place) const {
    const GltfValues values = values_of(index, place, true);
    if (values.component_type != gltf_float) fail(FLG_ERROR_FORMAT, values.place, "holds matrices that are no floats");
    return values;
}

ByteBlock GltfDocument::image(uint64_t index, const String& place) const {
    const Json& json = element("images", index, place);
    const String here = element_place("images", index);
    if (const Json* const uri = json.find("uri")) {
        if (!uri->is_string()) fail(FLG_ERROR_FORMAT, here + ".uri", "is no string");
        return load_uri(uri->string(), here + ".uri");
    }
    const View bytes = view(gltf_required(json, "bufferView", here), here + ".bufferView");
    ByteBlock copy(bytes.bytes.size());
    std::copy(bytes.bytes.begin(), bytes.bytes.end(), copy.data());
    return copy;
}

GltfDocument::View GltfDocument::view(uint64_t index, const String& referrer) const {
    const Json& json = element("bufferViews", index, referrer);
    View view;
    view.place = element_place("bufferViews", index);
    const uint64_t buffer_index = gltf_required(json, "buffer", view.place);
    element("buffers", buffer_index, view.place + ".buffer");
    const Bytes buffer = buffers_[buffer_index];
    const uint64_t offset = gltf_unsigned(json, "byteOffset", 0, view.place);
    const uint64_t length = gltf_required(json, "byteLength", view.place);
    if (offset > buffer.size() || length > buffer.size() - offset) {
        fail(FLG_ERROR_FORMAT, view.place, "covers %llu bytes from %llu, but its buffer has %zu",
             static_cast<unsigned long long>(length), static_cast<unsigned long long>(offset), buffer.size());
    }
    view.bytes = buffer.subspan(offset, length);
    view.stride = gltf_unsigned(json, "byteStride", 0, view.place);
    return view;
}

GltfValues GltfDocument::values_of(uint64_t index, const String& place, bool of_matrices) const {
    const Json& accessor = element("accessors", index, place);
    GltfValues values;
    values.place = element_place("accessors", index);
    const Json* const type = accessor.find("type");
    const auto is_type = [&](const char* name) { return type && *type == name; };
    if (is_type("SCALAR")) values.components = 1;
    if (is_type("VEC2")) values.components = 2;
    if (is_type("VEC3")) values.components = 3;
    if (is_type("VEC4")) values.components = 4;
    if (of_matrices) values.components = is_type("MAT4") ? 16 : 0;
    if (of_matrices && values.components == 0) fail(FLG_ERROR_FORMAT, values.place + ".type", "is not MAT4");
    if (values.components == 0)
        fail(FLG_ERROR_FORMAT, values.place + ".type", "is none of SCALAR, VEC2, VEC3 and VEC4");
    values.component_type = component_type(accessor, values.place);
    const uint64_t element_size = values.element_size();
    const Json* const normalized = accessor.find("normalized");
    values.normalized = normalized && normalized->is_boolean() && normalized->boolean();
    values.count = gltf_required(accessor, "count", values.place);

    if (accessor.find("bufferView")) {
        const View view = this->view(gltf_required(accessor, "bufferView", values.place), values.place + ".bufferView");
        if (view.stride != 0 && (view.stride < std::max(min_stride, element_size) || view.stride > max_stride)) {
            fail(FLG_ERROR_FORMAT, view.place + ".byteStride", "is %llu for values of %llu bytes",
                 static_cast<unsigned long long>(view.stride), static_cast<unsigned long long>(element_size));
        }
        values.stride = view.stride != 0 ? view.stride : element_size;
        values.data = values_in(view, gltf_unsigned(accessor, "byteOffset", 0, values.place), values.count,
                                element_size, values.stride, values.place + ".count");
    } else if (values.count == 0 || values.count > max_bytes) {
        fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, must be from 1 to %llu",
             static_cast<unsigned long long>(values.count), static_cast<unsigned long long>(max_bytes));
    } else {
        values.data = zeros;  // of any count, as the stride is 0
    }
    if (const Json* const sparse = accessor.find("sparse")) read_sparse(*sparse, values);
    return values;
}

void GltfDocument::read_sparse(const Json& sparse, GltfValues& values) const {
    const String place = values.place + ".sparse";
    if (!sparse.is_object()) fail(FLG_ERROR_FORMAT, place, "is no object");
    const auto part = [&](const char* key) -> const Json& {
        const Json* const found = sparse.find(key);
        if (!found || !found->is_object()) fail(FLG_ERROR_FORMAT, place, "has no object %s", key);
        return *found;
    };
    const auto bytes_of = [&](const Json& json, const String& here, uint64_t count, uint64_t size) {
        const View view = this->view(gltf_required(json, "bufferView", here), here + ".bufferView");
        if (view.stride != 0) fail(FLG_ERROR_FORMAT, view.place + ".byteStride", "is set, but the values are sparse");
        return values_in(view, gltf_unsigned(json, "byteOffset", 0, here), count, size, size, place + ".count");
    };
    const uint64_t count = gltf_required(sparse, "count", place);
    const Json& indices = part("indices");
    const String indices_place = place + ".indices";
    values.sparse_type = component_type(indices, indices_place);
    if (!is_index_type(values.sparse_type)) fail(FLG_ERROR_FORMAT, indices_place, "are no unsigned integers");
    values.sparse_indices = bytes_of(indices, indices_place, count, component_size(values.sparse_type));
    values.sparse_data = bytes_of(part("values"), place + ".values", count, values.element_size());
    values.sparse_count = count;
    for (uint64_t i = 0; i < count; ++i) {
        const uint32_t element = values.sparse_element(i);
        if (element < values.count && (i == 0 || element > values.sparse_element(i - 1))) continue;
        fail(FLG_ERROR_FORMAT, indices_place, "index %u at %llu: must rise, and be below %llu", element,
             static_cast<unsigned long long>(i), static_cast<unsigned long long>(values.count));
    }
}

}  // namespace flg::io
