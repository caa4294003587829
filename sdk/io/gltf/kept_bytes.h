// SPDX-License-Identifier: MIT
// The bytes of an asset's buffers that go into another file, in one buffer: those that views name, each once.
#pragma once

#include "io/gltf/gltf_document.h"

namespace flg::io {

class KeptBytes {
public:
    // What a view covers, and what its extensions say in its place. Refuses bytes that the buffer does not have.
    void add(const GltfDocument& document, const Json& view, const String& place);
    // All of them, when no more are added.
    String merge(const GltfDocument& document);
    // A view that was added, in the one buffer.
    String moved_view(const Json& view, const String& place) const;

private:
    struct Range {
        uint64_t buffer, begin, end;
        uint64_t at = 0;  // in the one buffer
    };

    void add_range(const GltfDocument& document, const Json& view, const String& place);
    uint64_t place_of(uint64_t buffer, uint64_t offset) const;

    Vector<Range> ranges_;
};

}  // namespace flg::io
