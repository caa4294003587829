// SPDX-License-Identifier: MIT
// A little writer of .tilt sketches, for tests.
#pragma once

#include <zlib.h>

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace flg::test {

template <class T>
void put(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct TiltPoint {
    float position[3] = {0, 0, 0};
    float orientation[4] = {0, 0, 0, 1};
    float pressure = 1;
    uint32_t time = 0;
};

struct TiltStroke {
    int32_t brush = 0;
    float color[4] = {1, 1, 1, 1};
    float size = 1;
    uint32_t stroke_mask = 0;
    uint32_t point_mask = 3;
    std::string extensions;
    std::vector<TiltPoint> points;
    std::string point_extra;  // bytes of unknown extensions, after each point
};

inline std::string tilt_sketch(const std::vector<TiltStroke>& strokes, int32_t version = 5) {
    std::string bytes;
    put<uint32_t>(bytes, 0xc576a5cd);
    put<int32_t>(bytes, version);
    put<int32_t>(bytes, 0);
    put<uint32_t>(bytes, 0);
    put<int32_t>(bytes, static_cast<int32_t>(strokes.size()));
    for (const TiltStroke& stroke : strokes) {
        put(bytes, stroke.brush);
        for (float channel : stroke.color) put(bytes, channel);
        put(bytes, stroke.size);
        put(bytes, stroke.stroke_mask);
        put(bytes, stroke.point_mask);
        bytes += stroke.extensions;
        put<int32_t>(bytes, static_cast<int32_t>(stroke.points.size()));
        for (const TiltPoint& point : stroke.points) {
            for (float value : point.position) put(bytes, value);
            for (float value : point.orientation) put(bytes, value);
            if (stroke.point_mask & 1) put(bytes, point.pressure);
            if (stroke.point_mask & 2) put(bytes, point.time);
            bytes += stroke.point_extra;
        }
    }
    return bytes;
}

inline std::string raw_deflate(std::string_view content) {
    z_stream stream = {};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

struct ZipMember {
    std::string name;
    std::string content;
    bool packed = false;
    uint32_t declared_size = 0;  // 0: the content's
};

// Offsets count from the zip's start, or, with `true_offsets` > 0, from so many bytes before it.
inline std::string zip(const std::vector<ZipMember>& members, uint32_t true_offsets = 0) {
    std::string bytes, directory;
    for (const ZipMember& member : members) {
        const std::string data = member.packed ? raw_deflate(member.content) : member.content;
        const uLong crc =
            crc32(0, reinterpret_cast<const Bytef*>(member.content.data()), static_cast<uInt>(member.content.size()));
        std::string common;
        put<uint16_t>(common, 20);
        put<uint16_t>(common, 0);
        put<uint16_t>(common, member.packed ? 8 : 0);
        put<uint32_t>(common, 0);
        put<uint32_t>(common, static_cast<uint32_t>(crc));
        put<uint32_t>(common, static_cast<uint32_t>(data.size()));
        put<uint32_t>(common,
                      member.declared_size ? member.declared_size : static_cast<uint32_t>(member.content.size()));
        put<uint16_t>(common, static_cast<uint16_t>(member.name.size()));
        put<uint16_t>(common, 0);
        const uint32_t offset = static_cast<uint32_t>(bytes.size()) + true_offsets;
        put<uint32_t>(bytes, 0x04034b50);
        bytes += common + member.name + data;
        put<uint32_t>(directory, 0x02014b50);
        put<uint16_t>(directory, 20);
        directory += common + std::string(10, '\0');
        put<uint32_t>(directory, offset);
        directory += member.name;
    }
    const uint32_t directory_offset = static_cast<uint32_t>(bytes.size()) + true_offsets;
    bytes += directory;
    put<uint32_t>(bytes, 0x06054b50);
    put<uint32_t>(bytes, 0);
    put<uint16_t>(bytes, static_cast<uint16_t>(members.size()));
    put<uint16_t>(bytes, static_cast<uint16_t>(members.size()));
    put<uint32_t>(bytes, static_cast<uint32_t>(directory.size()));
    put<uint32_t>(bytes, directory_offset);
    put<uint16_t>(bytes, 0);
    return bytes;
}

inline std::string tilt_header(uint16_t size = 16, uint16_t version = 1) {
    std::string bytes = "tilT";
    put(bytes, size);
    put(bytes, version);
    return bytes + std::string(size > 8 ? size - 8u : 0u, '\0');
}

constexpr const char* tilt_metadata =
    R"({"BrushIndex": ["c0012095-3ffd-4040-8ee1-fc180d346eaa", "01234567-0000-0000-0000-000000000000"]})";

inline std::string tilt_file(const std::string& sketch, bool packed = false) {
    return tilt_header() + zip({{"thumbnail.png", "no picture"},
                                {"data.sketch", sketch, packed},
                                {"metadata.json", tilt_metadata, packed}});
}

// A stroke of four points with everything in it.
inline TiltStroke sample_stroke() {
    TiltStroke stroke;
    stroke.size = 2;
    stroke.color[0] = 0.5f;
    stroke.stroke_mask = 0x7;
    put<uint32_t>(stroke.extensions, 2);   // flags
    put<float>(stroke.extensions, 0.5f);   // scale
    put<uint32_t>(stroke.extensions, 77);  // group
    for (uint32_t i = 0; i < 4; ++i) {
        TiltPoint point;
        point.position[0] = static_cast<float>(i);
        point.position[1] = 10;
        point.position[2] = static_cast<float>(i * i);
        point.pressure = 0.25f * static_cast<float>(i);
        point.time = 1000 + 250 * i;
        stroke.points.push_back(point);
    }
    return stroke;
}

}  // namespace flg::test
