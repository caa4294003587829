// SPDX-License-Identifier: MIT
// glTF documents as text, to be changed and broken.
#pragma once

#include "io/files.h"

namespace flg::test {

using Floats = std::vector<float>;

inline std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// A document of one buffer: four positions (bytes 0 to 48), then `more`.
struct Document {
    std::string more;
    std::string nodes = R"("scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],)";
    std::string primitive = R"({"attributes": {"POSITION": 0}, "mode": 3})";
    std::string positions = R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"})";
    std::string accessors;
    std::string views;
    std::string uri;
    size_t length = 0;
    Floats points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

    std::string text() const {
        const std::string data = bytes_of(points) + more;
        return R"({"asset": {"version": "2.0"}, )" + nodes + R"("meshes": [{"primitives": [)" + primitive +
               R"(]}], "accessors": [)" + positions + accessors +
               R"(], "bufferViews": [{"buffer": 0, "byteLength": 48})" + views + R"(], "buffers": [{"byteLength": )" +
               std::to_string(length ? length : data.size()) + R"(, "uri": ")" +
               (uri.empty() ? "data:application/octet-stream;base64," + base64(data) : uri) + R"("}]})";
    }
};

}  // namespace flg::test
