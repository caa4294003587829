// SPDX-License-Identifier: MIT
// The C ABI of filigree_io.h, translated onto this room. Memory is the C++ runtime's: there is no context here.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "filigree/filigree_io.h"
#include "io/atomic_file.h"
#include "io/curve_data.h"
#include "io/curve_measures.h"
#include "io/failure.h"
#include "io/file_bytes.h"
#include "io/gltf_reader.h"
#include "io/gltf_writer.h"
#include "io/limits.h"
#include "io/obj_lines.h"
#include "io/tilt_reader.h"
#include "io/xyz_format.h"

struct FlgCurveFileT {
    flg::io::CurveData data;
    flg::io::CurveMeasures measures;
    std::vector<FlgColumn> columns;
    std::vector<const char*> warnings;
};

namespace flg::io {

namespace {

constexpr uint32_t default_sides = 8;
constexpr uint32_t least_sides = 3;
constexpr uint32_t most_sides = 64;

// Long enough for the longest path that Linux knows, and a sentence.
thread_local char last_error[4096 + 1024] = "no error";

FlgResult set_last_error(FlgResult result, const char* file, const std::string& place, const char* reason) noexcept {
    const char* separator = *file != '\0' && !place.empty() ? ":" : "";
    std::snprintf(last_error, sizeof last_error, "%s%s%s: %s", file, separator, place.c_str(), reason);
    return result;
}

// Runs an entry point's body; `file` is what the sentence of a failure starts with.
template <class Body>
FlgResult guarded(const char* file, Body&& body) noexcept {
    try {
        body();
        return FLG_OK;
    } catch (const Failure& failure) {
        return set_last_error(failure.result(), file, failure.place(), failure.what());
    } catch (const std::bad_alloc&) {
        return set_last_error(FLG_ERROR_OUT_OF_MEMORY, file, {}, "no memory is left");
    } catch (const std::length_error&) {
        return set_last_error(FLG_ERROR_OUT_OF_MEMORY, file, {}, "no memory is left");
    } catch (const std::filesystem::filesystem_error& error) {
        return set_last_error(FLG_ERROR_FILE, file, {}, error.code().message().c_str());
    } catch (const std::exception& error) {
        return set_last_error(FLG_ERROR_INTERNAL, file, {}, error.what());
    } catch (...) {
        return set_last_error(FLG_ERROR_INTERNAL, file, {}, "unknown exception");
    }
}

void check_argument(const void* pointer, const char* name) {
    if (!pointer) fail(FLG_ERROR_INVALID_ARGUMENT, name, "is null");
}

// Fills a host's struct as far as the host knows it. All structs so far have their first version's size.
template <class Struct>
void hand_out(Struct value, Struct* out, uint32_t struct_size) {
    value.struct_size = struct_size;
    std::memcpy(out, &value, std::min<size_t>(struct_size, sizeof value));
}

template <class Struct>
void check_size(uint32_t struct_size, const char* name) {
    if (struct_size < sizeof(Struct)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, name, "has the struct_size %u, must be at least %zu", struct_size,
             sizeof(Struct));
    }
}

std::filesystem::path to_path(const char* utf8) {
    std::filesystem::path path{std::u8string(reinterpret_cast<const char8_t*>(utf8), std::strlen(utf8))};
    return path.has_filename() ? path : path.parent_path();
}

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

CurveData read_curves(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension == ".tilt") return read_tilt(path);
    if (extension == ".gltf" || extension == ".glb") return read_gltf(path);
    const bool obj = extension == ".obj";
    if (!obj && extension != ".xyz" && extension != ".txt") {
        fail(FLG_ERROR_FORMAT, "", "is of no known format: %s is none of .xyz .txt .obj .gltf .glb .tilt",
             cited(extension).c_str());
    }
    const ByteBlock file = read_file(path, "");
    return obj ? read_obj(as_text(file.bytes())) : read_xyz(as_text(file.bytes()));
}

void add_column(FlgCurveFileT& file, FlgAttribute attribute, uint32_t components, const std::vector<float>& values) {
    if (values.empty() && attribute != FLG_ATTRIBUTE_POSITION) return;
    file.columns.push_back({attribute, components, values.data(), 0, 0});
}

FlgCurveWriteDesc write_defaults() {
    FlgCurveWriteDesc desc = {};
    desc.struct_size = sizeof desc;
    desc.geometry = FLG_GEOMETRY_LINES;
    desc.default_radius = default_radius;
    desc.tube_sides = default_sides;
    return desc;
}

FlgCurveWriteDesc checked_desc(const FlgCurveWriteDesc* given) {
    if (!given) return write_defaults();
    check_size<FlgCurveWriteDesc>(given->struct_size, "desc");
    FlgCurveWriteDesc desc;
    std::memcpy(&desc, given, sizeof desc);
    if (desc.geometry < FLG_GEOMETRY_LINES || desc.geometry > FLG_GEOMETRY_TUBE) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.geometry", "is %d, must be 0 to 2", desc.geometry);
    }
    if (!(desc.default_radius > 0) || !(desc.default_radius <= max_coordinate)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.default_radius", "is %g, must be above 0 and at most 1e30",
             double{desc.default_radius});
    }
    if (desc.tube_sides < least_sides || desc.tube_sides > most_sides) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.tube_sides", "is %u, must be %u to %u", desc.tube_sides, least_sides,
             most_sides);
    }
    return desc;
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;

extern "C" {

const char* flgIoLastError(void) {
    return last_error;
}

FlgResult flgCurveFileRead(const char* path, FlgCurveFile* out_file) {
    if (out_file) *out_file = nullptr;
    return guarded(path ? path : "flgCurveFileRead", [&] {
        check_argument(path, "path");
        check_argument(out_file, "out_file");
        auto file = std::make_unique<FlgCurveFileT>();
        file->data = read_curves(to_path(path));
        CurveData& data = file->data;
        file->measures = measure(data);
        add_column(*file, FLG_ATTRIBUTE_POSITION, 3, data.positions);
        add_column(*file, FLG_ATTRIBUTE_RADIUS, 1, data.radii);
        add_column(*file, FLG_ATTRIBUTE_COLOR, 4, data.colors);
        add_column(*file, FLG_ATTRIBUTE_TIME, 1, data.times);
        add_column(*file, FLG_ATTRIBUTE_PRESSURE, 1, data.pressures);
        add_column(*file, FLG_ATTRIBUTE_ORIENTATION, 4, data.orientations);
        for (const std::string& warning : data.warnings) file->warnings.push_back(warning.c_str());
        *out_file = file.release();
    });
}

FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view) {
    return guarded("flgCurveFileGetView", [&] {
        check_argument(out_view, "out_view");
        const uint32_t struct_size = out_view->struct_size;
        check_size<FlgCurveSetView>(struct_size, "out_view");
        hand_out(FlgCurveSetView{}, out_view, struct_size);
        check_argument(file, "file");
        FlgCurveSetView view = {};
        view.curve_count = static_cast<uint32_t>(file->data.curve_count());
        view.curve_offsets = file->data.offsets.data();
        view.curve_flags = file->data.flags.data();
        view.columns = file->columns.data();
        view.column_count = static_cast<uint32_t>(file->columns.size());
        hand_out(view, out_view, struct_size);
    });
}

FlgResult flgCurveFileGetInfo(FlgCurveFile file, FlgCurveFileInfo* out_info) {
    return guarded("flgCurveFileGetInfo", [&] {
        check_argument(out_info, "out_info");
        const uint32_t struct_size = out_info->struct_size;
        check_size<FlgCurveFileInfo>(struct_size, "out_info");
        hand_out(FlgCurveFileInfo{}, out_info, struct_size);
        check_argument(file, "file");
        const CurveData& data = file->data;
        FlgCurveFileInfo info = {};
        info.curve_count = static_cast<uint32_t>(data.curve_count());
        info.point_count = data.point_count();
        info.format = data.format;
        info.units = data.units;
        std::copy_n(file->measures.box_min, 3, info.box_min);
        std::copy_n(file->measures.box_max, 3, info.box_max);
        info.total_length = file->measures.total_length;
        info.warning_count = static_cast<uint32_t>(file->warnings.size());
        info.warnings = file->warnings.data();
        hand_out(info, out_info, struct_size);
    });
}

FlgResult flgCurveFileGetStrokes(FlgCurveFile file, const FlgStroke** out_strokes, uint32_t* out_count) {
    if (out_strokes) *out_strokes = nullptr;
    if (out_count) *out_count = 0;
    return guarded("flgCurveFileGetStrokes", [&] {
        check_argument(file, "file");
        check_argument(out_strokes, "out_strokes");
        check_argument(out_count, "out_count");
        if (file->data.strokes.empty()) return;
        *out_strokes = file->data.strokes.data();
        *out_count = static_cast<uint32_t>(file->data.strokes.size());
    });
}

void flgCurveFileRelease(FlgCurveFile file) {
    delete file;
}

FlgResult flgCurveWriteDescInit(FlgCurveWriteDesc* desc, uint32_t struct_size) {
    return guarded("flgCurveWriteDescInit", [&] {
        check_argument(desc, "desc");
        check_size<FlgCurveWriteDesc>(struct_size, "desc");
        std::memset(desc, 0, struct_size);
        hand_out(write_defaults(), desc, struct_size);
    });
}

FlgResult flgCurveFileWrite(const char* path, const FlgCurveSetView* view, const FlgCurveWriteDesc* desc) {
    return guarded(path ? path : "flgCurveFileWrite", [&] {
        check_argument(path, "path");
        const FlgCurveWriteDesc checked = checked_desc(desc);
        const std::filesystem::path target = to_path(path);
        const std::string extension = extension_of(target);
        const CheckedView curves(view);
        std::string content;
        if (extension == ".xyz" || extension == ".txt") {
            content = write_xyz(curves);
        } else if (extension == ".obj") {
            content = write_obj(curves);
        } else if (extension == ".glb") {
            content = write_glb(curves, checked);
        } else {
            fail(FLG_ERROR_FORMAT, "", "can't be written: %s is none of .xyz .txt .obj .glb", cited(extension).c_str());
        }
        if (content.size() > max_bytes) {
            fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", content.size());
        }
        write_file(target, content);
    });
}

}  // extern "C"
