// SPDX-License-Identifier: MIT
// A glTF document: its JSON and its buffers, with every index, offset and count checked where it is followed.
#pragma once

#include <optional>

#include "io/base/files.h"
#include "io/base/json.h"
#include "io/base/memory.h"

namespace flg::io {

// The values of an accessor; all of them lie inside their buffers. Those that are sparse stand beside the others, which
// they replace, and are found by bisection: nothing is copied, whatever count a file claims.
struct GltfValues {
    const uint8_t* data = nullptr;
    uint64_t count = 0;
    uint64_t stride = 0;  // bytes; 0: all values are the first
    uint32_t components = 0;
    uint32_t component_type = 0;
    bool normalized = false;
    uint32_t sparse_type = 0;  // of the indices, which rise
    uint64_t sparse_count = 0;
    const uint8_t* sparse_indices = nullptr;
    const uint8_t* sparse_data = nullptr;
    String place;

    // As float; integers are mapped to 0..1 or -1..1 if they are normalized.
    float number(uint64_t element, uint32_t component) const;
    // Of unsigned integers.
    uint32_t index(uint64_t element) const;

    uint64_t element_size() const;  // bytes
    // The element that sparse value i replaces.
    uint32_t sparse_element(uint64_t i) const;

private:
    const uint8_t* at(uint64_t element) const;
};

constexpr uint32_t gltf_byte = 5120;
constexpr uint32_t gltf_unsigned_byte = 5121;
constexpr uint32_t gltf_short = 5122;
constexpr uint32_t gltf_unsigned_short = 5123;
constexpr uint32_t gltf_unsigned_int = 5125;
constexpr uint32_t gltf_float = 5126;

// Of unsigned integers.
bool is_index_type(uint32_t component_type);

class GltfDocument {
public:
    explicit GltfDocument(const Path& path);

    const Json& root() const { return json_->root(); }
    // Element `index` of one of the document's arrays ("nodes"); an object. `place` is who refers to it.
    const Json& element(const char* array, uint64_t index, const String& place) const;
    size_t size(const char* array) const;
    GltfValues accessor(uint64_t index, const String& place) const;
    // Of 4 x 4 floats each, column by column.
    GltfValues matrices(uint64_t index, const String& place) const;
    // Of those that `buffers` lists.
    Bytes buffer(uint64_t index) const { return buffers_[index]; }
    // The file that an image is; it is not decoded.
    ByteBlock image(uint64_t index, const String& place) const;

    // A bufferView.
    struct View {
        Bytes bytes;
        uint64_t stride = 0;  // bytes; 0: values without gaps
        String place;
    };

private:
    View view(uint64_t index, const String& referrer) const;
    GltfValues values_of(uint64_t index, const String& place, bool of_matrices) const;
    void read_sparse(const Json& sparse, GltfValues& values) const;
    Bytes split_glb(Bytes file, Bytes& binary) const;
    void load_buffers(Bytes binary);
    ByteBlock load_uri(std::string_view uri, const String& place) const;

    const Path path_;
    ByteBlock file_;
    std::optional<JsonDocument> json_;
    Vector<ByteBlock> loaded_;
    Vector<Bytes> buffers_;
};

// A member that must be a whole number >= 0; absent: `fallback`.
uint64_t gltf_unsigned(const Json& object, const char* key, uint64_t fallback, const String& place);
// The same, where it must be there.
uint64_t gltf_required(const Json& object, const char* key, const String& place);
// A member that must be an array; absent: null.
const Json* gltf_array(const Json& object, const char* key, const String& place);

}  // namespace flg::io
