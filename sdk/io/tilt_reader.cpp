// SPDX-License-Identifier: MIT
// Source: the .tilt format as the painting program's own reader has it (googlevr/tilt-brush c5fb8671): a header, a zip
// archive, and in it metadata.json (brushes; tilt_brush_index.cpp) and data.sketch (strokes; tilt_strokes.cpp).
#include "io/tilt_reader.h"

#include "io/byte_reader.h"
#include "io/limits.h"
#include "io/tilt_brush_index.h"
#include "io/tilt_strokes.h"
#include "io/zip_reader.h"

namespace flg::io {

namespace {

constexpr uint32_t magic = 0x546c6974;  // "tilT"
constexpr uint16_t smallest_header = 16;
constexpr uint16_t known_version = 1;
constexpr uint32_t zip_start = 0x04034b50;  // "PK\3\4"
constexpr const char* strokes_name = "data.sketch";
constexpr const char* metadata_name = "metadata.json";
constexpr const char* old_metadata_name = "main.json";  // of pre-release files

CurveData read_directory(const std::filesystem::path& path) {
    const ByteBlock strokes = read_file(path / strokes_name, strokes_name);
    const char* name =
        std::filesystem::exists(path / metadata_name) || !std::filesystem::exists(path / old_metadata_name)
            ? metadata_name
            : old_metadata_name;
    const ByteBlock metadata = read_file(path / name, name, max_metadata_bytes);
    return read_tilt_strokes(strokes.bytes(), strokes_name, read_brush_index(metadata.bytes(), name));
}

CurveData read_archive(const std::filesystem::path& path) {
    const ByteBlock file = read_file(path, "");
    ByteReader header(file.bytes(), "");
    if (const auto found = header.read<uint32_t>("the header"); found != magic) {
        fail(FLG_ERROR_FORMAT, "@0", "is no .tilt sketch: starts with %08x, not with 'tilT'", found);
    }
    const auto header_size = header.read<uint16_t>("the header");
    if (header_size < smallest_header) {
        fail(FLG_ERROR_FORMAT, "@4", "declares a header of %u bytes; the smallest is %u", header_size, smallest_header);
    }
    if (const auto version = header.read<uint16_t>("the header"); version != known_version) {
        fail(FLG_ERROR_FORMAT, "@6", "has the header version %u; only %u is known", version, known_version);
    }
    header.take(header_size - header.position(), "the header");
    const std::string zip_place = header.place();
    if (header.read<uint32_t>("a zip archive") != zip_start) {
        fail(FLG_ERROR_FORMAT, zip_place, "holds no zip archive behind its header");
    }
    const ZipReader zip(file.bytes());
    const char* name = !zip.has(metadata_name) && zip.has(old_metadata_name) ? old_metadata_name : metadata_name;
    const ZipContent metadata = zip.read(name, max_metadata_bytes);
    const ZipContent strokes = zip.read(strokes_name);
    return read_tilt_strokes(strokes.bytes, strokes_name, read_brush_index(metadata.bytes, name));
}

}  // namespace

CurveData read_tilt(const std::filesystem::path& path) {
    return std::filesystem::is_directory(path) ? read_directory(path) : read_archive(path);
}

}  // namespace flg::io
