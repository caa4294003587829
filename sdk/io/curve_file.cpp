// SPDX-License-Identifier: MIT
// The C ABI of curve files, translated onto this room.
#include <algorithm>
#include <memory>
#include <string>

#include "filigree/filigree_io.h"
#include "io/atomic_file.h"
#include "io/curve_data.h"
#include "io/curve_measures.h"
#include "io/entry_point.h"
#include "io/file_bytes.h"
#include "io/gltf_reader.h"
#include "io/gltf_writer.h"
#include "io/limits.h"
#include "io/obj_lines.h"
#include "io/svg_reader.h"
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

CurveData read_curves(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension == ".tilt") return read_tilt(path);
    if (extension == ".gltf" || extension == ".glb") return read_gltf(path);
    const bool obj = extension == ".obj", svg = extension == ".svg";
    if (!obj && !svg && extension != ".xyz" && extension != ".txt") {
        fail(FLG_ERROR_FORMAT, "", "is of no known format: %s is none of .xyz .txt .obj .svg .gltf .glb .tilt",
             cited(extension).c_str());
    }
    const ByteBlock file = read_file(path, "");
    if (svg) return read_svg(as_text(file.bytes()));
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
        for (const VertexColumn& column : data.columns) {
            add_column(*file, column.attribute, column.components, column.values);
        }
        for (const std::string& warning : data.warnings) file->warnings.push_back(warning.c_str());
        *out_file = file.release();
    });
}

FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view) {
    return guarded("flgCurveFileGetView", [&] {
        const uint32_t struct_size = open_out(out_view, "out_view");
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
        const uint32_t struct_size = open_out(out_info, "out_info");
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
            content = write_xyz(curves, checked);
        } else if (extension == ".obj") {
            content = write_obj(curves);
        } else if (extension == ".glb") {
            content = write_glb(curves, checked);
        } else {
            fail(FLG_ERROR_FORMAT, "", "can't be written: %s is none of .xyz .txt .obj .glb", cited(extension).c_str());
        }
        write_file(target, content);
    });
}

}  // extern "C"
