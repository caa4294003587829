// SPDX-License-Identifier: MIT
// The C ABI of curve files, translated onto this room.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "filigree/filigree_io.h"
#include "io/base/curve_data.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/base/limits.h"
#include "io/gltf/gltf_curves.h"
#include "io/svg/svg.h"
#include "io/text/obj.h"
#include "io/text/xyz.h"
#include "io/tilt/tilt.h"

namespace flg::io {

// What all formats' curves are asked: extent, length, and repeated points.
struct CurveMeasures {
    float box_min[3] = {0, 0, 0};
    float box_max[3] = {0, 0, 0};
    float total_length = 0;
};

}  // namespace flg::io

struct FlgCurveFileT {
    flg::io::CurveData data;
    flg::io::CurveMeasures measures;
    std::vector<FlgColumn> columns;
    std::vector<const char*> warnings;
};

namespace flg::io {

namespace {

// Adds warnings to `data` for what it finds odd.
CurveMeasures measure(CurveData& data) {
    CurveMeasures result;
    if (data.point_count() == 0) return result;
    const float* points = data.positions.data();
    std::copy_n(points, 3, result.box_min);
    std::copy_n(points, 3, result.box_max);
    for (size_t i = 0; i < data.positions.size(); ++i) {
        result.box_min[i % 3] = std::min(result.box_min[i % 3], points[i]);
        result.box_max[i % 3] = std::max(result.box_max[i % 3], points[i]);
    }

    const auto distance = [&](size_t a, size_t b) {
        const double x = double{points[3 * a]} - points[3 * b];
        const double y = double{points[3 * a + 1]} - points[3 * b + 1];
        const double z = double{points[3 * a + 2]} - points[3 * b + 2];
        return std::sqrt(x * x + y * y + z * z);
    };
    Tally repeated;
    Tally no_length;
    Tally lone;
    double total = 0;
    for (size_t c = 0; c < data.curve_count(); ++c) {
        const size_t begin = data.offsets[c];
        const size_t end = data.offsets[c + 1];
        double length = 0;
        bool repeats = false;
        for (size_t i = begin + 1; i < end; ++i) {
            const double step = distance(i - 1, i);
            repeats |= step == 0;
            length += step;
        }
        if (data.flags[c] & FLG_CURVE_CLOSED) length += distance(end - 1, begin);
        total += length;
        if (end - begin == 1)
            lone.add(c);
        else if (length == 0)
            no_length.add(c);
        else if (repeats)
            repeated.add(c);
    }
    result.total_length = static_cast<float>(total);
    data.warn(lone, "curve", "of a single point");
    data.warn(no_length, "curve", "of zero length");
    data.warn(repeated, "curve", "has points repeated in a row");
    return result;
}

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

// What hosts knew before there was more.
constexpr uint32_t first_version_size = offsetof(FlgCurveWriteDesc, tolerance);

void check_desc_size(uint32_t struct_size) {
    if (struct_size >= first_version_size) return;
    fail(FLG_ERROR_INVALID_ARGUMENT, "desc", "has the struct_size %u, must be at least %u", struct_size,
         first_version_size);
}

FlgCurveWriteDesc checked_desc(const FlgCurveWriteDesc* given, const CheckedView& curves) {
    if (!given) return write_defaults();
    check_desc_size(given->struct_size);
    FlgCurveWriteDesc desc = write_defaults();
    std::memcpy(&desc, given, std::min<size_t>(given->struct_size, sizeof desc));
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
    if (!(desc.tolerance >= 0) || !(desc.tolerance <= max_coordinate)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.tolerance", "is %g, must be 0 to 1e30", double{desc.tolerance});
    }
    for (uint32_t c = 0; desc.geometries && c < curves.curve_count(); ++c) {
        const uint8_t geometry = desc.geometries[c];
        if (geometry == FLG_GEOMETRY_RIBBON || geometry == FLG_GEOMETRY_TUBE) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.geometries[" + std::to_string(c) + "]",
             "is %u, must be FLG_GEOMETRY_RIBBON or FLG_GEOMETRY_TUBE", unsigned{geometry});
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
        check_desc_size(struct_size);
        std::memset(desc, 0, struct_size);
        hand_out(write_defaults(), desc, struct_size);
    });
}

FlgResult flgCurveFileWrite(const char* path, const FlgCurveSetView* view, const FlgCurveWriteDesc* desc) {
    return guarded(path ? path : "flgCurveFileWrite", [&] {
        check_argument(path, "path");
        const std::filesystem::path target = to_path(path);
        const std::string extension = extension_of(target);
        const CheckedView curves(view);
        const FlgCurveWriteDesc checked = checked_desc(desc, curves);
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
