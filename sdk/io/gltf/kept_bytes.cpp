// SPDX-License-Identifier: MIT
#include "io/gltf/kept_bytes.h"

#include <algorithm>

#include "io/base/failure.h"
#include "io/base/json_text.h"

namespace flg::io {

namespace {

constexpr uint64_t alignment = 4;  // of ranges

}  // namespace

void KeptBytes::add(const GltfDocument& document, const Json& view, const String& place) {
    add_range(document, view, place);
    const Json* const extensions = view.find("extensions");
    if (!extensions) return;
    for (const JsonMember& extension : extensions->members()) {
        if (extension.value.find("buffer"))
            add_range(document, extension.value, place + ".extensions." + String(extension.name));
    }
}

void KeptBytes::add_range(const GltfDocument& document, const Json& view, const String& place) {
    const uint64_t buffer = gltf_required(view, "buffer", place), length = gltf_required(view, "byteLength", place);
    const uint64_t offset = gltf_unsigned(view, "byteOffset", 0, place);
    document.element("buffers", buffer, place + ".buffer");
    const uint64_t size = document.buffer(buffer).size();
    if (offset > size || length > size - offset)
        fail(FLG_ERROR_FORMAT, place, "covers bytes that its buffer does not have");
    ranges_.push_back({buffer, offset / alignment * alignment, offset + length});
}

String KeptBytes::merge(const GltfDocument& document) {
    std::sort(ranges_.begin(), ranges_.end(), [](const Range& a, const Range& b) {
        return std::pair(a.buffer, a.begin) < std::pair(b.buffer, b.begin);
    });
    Vector<Range> merged;
    for (const Range& range : ranges_) {
        if (!merged.empty() && merged.back().buffer == range.buffer && range.begin <= merged.back().end)
            merged.back().end = std::max(merged.back().end, range.end);
        else
            merged.push_back(range);
    }
    ranges_ = std::move(merged);
    String bytes;
    for (Range& range : ranges_) {
        range.at = bytes.size();
        bytes.append(as_text(document.buffer(range.buffer).subspan(range.begin, range.end - range.begin)));
        bytes.resize((bytes.size() + alignment - 1) / alignment * alignment, '\0');
    }
    return bytes;
}

uint64_t KeptBytes::place_of(uint64_t buffer, uint64_t offset) const {
    const auto behind = std::upper_bound(ranges_.begin(), ranges_.end(), std::pair(buffer, offset),
                                         [](const std::pair<uint64_t, uint64_t>& byte, const Range& range) {
                                             return byte < std::pair(range.buffer, range.begin);
                                         });
    const Range& range = *std::prev(behind);
    return range.at + offset - range.begin;
}

String KeptBytes::moved_view(const Json& view, const String& place) const {
    String text;
    for (const JsonMember& member : view.members()) {
        if (member.name == "buffer" || member.name == "byteOffset") continue;
        text += "," + json_text(member.name) + ":";
        if (member.name != "extensions" || !member.value.is_object()) {
            text += json_text(member.value);
            continue;
        }
        String extensions;
        for (const JsonMember& extension : member.value.members()) {
            separate(extensions);
            extensions +=
                json_text(extension.name) + ":" +
                (extension.value.find("buffer") ? moved_view(extension.value, place) : json_text(extension.value));
        }
        text += "{" + extensions + "}";
    }
    const uint64_t at = place_of(gltf_required(view, "buffer", place), gltf_unsigned(view, "byteOffset", 0, place));
    return "{\"buffer\":0,\"byteOffset\":" + to_text(at) + text + "}";
}

}  // namespace flg::io
