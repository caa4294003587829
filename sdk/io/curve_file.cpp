// SPDX-License-Identifier: MIT
// The C ABI of curve files, translated onto this room.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

#include "filigree/filigree_io.h"
#include "io/base/box.h"
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
    Box box;
    float total_length = 0;
};

}  // namespace flg::io

struct FlgCurveFileT : flg::io::HostFile {
    flg::io::CurveData data;
    flg::io::CurveMeasures measures;
    flg::io::Vector<FlgColumn> columns;
    flg::io::Vector<const char*> warnings;
};

namespace flg::io {

namespace {

// Adds warnings to `data` for what it finds odd.
CurveMeasures measure(CurveData& data) {
    CurveMeasures result;
    if (data.point_count() == 0) return result;
    result.box = box_of(data.positions);
    const float* points = data.positions.data();
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
constexpr uint32_t min_sides = 3;
constexpr uint32_t max_sides = 64;

CurveData read_from(const Path& path, const Origin& origin) {
    const String extension = path.extension();
    const auto in_floats = [](CurveData data) {
        data.placing.stored = Origin{};
        return data;
    };
    if (extension == ".tilt") return in_floats(read_tilt(path));
    if (extension == ".gltf" || extension == ".glb") return read_gltf(path, origin);
    const bool obj = extension == ".obj", svg = extension == ".svg";
    if (!obj && !svg && extension != ".xyz" && extension != ".txt") {
        fail(FLG_ERROR_FORMAT, "", "is of no known format: %s is none of .xyz .txt .obj .svg .gltf .glb .tilt",
             cited(extension).c_str());
    }
    const ByteBlock file = read_file(path, "");
    if (svg) return in_floats(read_svg(as_text(file.bytes())));
    return obj ? read_obj(as_text(file.bytes()), origin) : read_xyz(as_text(file.bytes()), origin);
}

CurveData read_curves(const Path& path) {
    const auto visit_edges = [](const CurveData& data, const auto& visit) {
        for (size_t c = 0; c < data.curve_count(); ++c) {
            for (size_t i = data.offsets[c] + size_t{1}; i < data.offsets[c + 1]; ++i) visit(i - 1, i);
        }
    };
    return read_placed([&](const Origin& origin) { return read_from(path, origin); }, visit_edges);
}

void add_column(FlgCurveFileT& file, FlgAttribute attribute, uint32_t components, const Vector<float>& values) {
    if (values.empty() && attribute != FLG_ATTRIBUTE_POSITION) return;
    file.columns.push_back({attribute, components, values.data(), 0, 0});
}

FlgCurveFileWriteDesc write_defaults() {
    auto desc = sized<FlgCurveFileWriteDesc>();
    desc.geometry = FLG_CURVE_GEOMETRY_LINES;
    desc.default_radius = default_radius;
    desc.tube_sides = default_sides;
    return desc;
}

FlgCurveFileWriteDesc checked_desc(const FlgCurveFileWriteDesc* given, const CheckedView& curves) {
    if (!given) return write_defaults();
    const FlgCurveFileWriteDesc desc = read_struct<Longer::cut>(given, write_defaults(), "desc");
    if (desc.geometry < FLG_CURVE_GEOMETRY_LINES || desc.geometry > FLG_CURVE_GEOMETRY_TUBE) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.geometry", "is %d, must be 0 to 2", desc.geometry);
    }
    if (!(desc.default_radius > 0) || !(desc.default_radius <= max_coordinate)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.default_radius", "is %g, must be above 0 and at most 1e30",
             double{desc.default_radius});
    }
    if (desc.tube_sides < min_sides || desc.tube_sides > max_sides) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.tube_sides", "is %u, must be %u to %u", desc.tube_sides, min_sides,
             max_sides);
    }
    if (!(desc.tolerance >= 0) || !(desc.tolerance <= max_coordinate)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.tolerance", "is %g, must be 0 to 1e30", double{desc.tolerance});
    }
    for (uint32_t c = 0; desc.geometries && c < curves.curve_count(); ++c) {
        const uint8_t geometry = desc.geometries[c];
        if (geometry == FLG_CURVE_GEOMETRY_RIBBON || geometry == FLG_CURVE_GEOMETRY_TUBE) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.geometries[" + to_text(c) + "]",
             "is %u, must be FLG_CURVE_GEOMETRY_RIBBON or FLG_CURVE_GEOMETRY_TUBE", unsigned{geometry});
    }
    return desc;
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;
using flg::sized;
using flg::write_origin;

extern "C" {

FlgResult flgCurveFileReadDescInit(FlgCurveFileReadDesc* desc, uint32_t struct_size) {
    return init("flgCurveFileReadDescInit", desc, struct_size, sized<FlgCurveFileReadDesc>());
}

FlgResult flgCurveFileRead(const char* path, const FlgCurveFileReadDesc* desc, FlgCurveFile* out_file) {
    return read_into(out_file, "flgCurveFileRead", path, desc, [](const Path& source) {
        auto file = make_owned<FlgCurveFileT>();
        file->data = read_curves(source);
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
        for (const String& warning : data.warnings) file->warnings.push_back(warning.c_str());
        return file;
    });
}

FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view) {
    return show("flgCurveFileGetView", file, out_view, "out_view", [](const FlgCurveFileT& shown) {
        auto view = sized<FlgCurveSetView>();
        view.curve_count = static_cast<uint32_t>(shown.data.curve_count());
        view.curve_offsets = shown.data.offsets.data();
        view.curve_flags = shown.data.flags.data();
        view.columns = shown.columns.data();
        view.column_count = static_cast<uint32_t>(shown.columns.size());
        write_origin(shown.data.placing.origin, view.origin);
        return view;
    });
}

FlgResult flgCurveFileGetInfo(FlgCurveFile file, FlgCurveFileInfo* out_info) {
    return show("flgCurveFileGetInfo", file, out_info, "out_info", [](const FlgCurveFileT& shown) {
        const CurveData& data = shown.data;
        auto info = sized<FlgCurveFileInfo>();
        info.curve_count = static_cast<uint32_t>(data.curve_count());
        info.point_count = data.point_count();
        info.format = data.format;
        info.units = data.units;
        shown.measures.box.show(info);
        info.total_length = shown.measures.total_length;
        info.warning_count = static_cast<uint32_t>(shown.warnings.size());
        info.warnings = shown.warnings.data();
        info.stroke_count = static_cast<uint32_t>(data.strokes.size());
        return info;
    });
}

FlgResult flgStrokeInit(FlgStroke* stroke, uint32_t struct_size) {
    return init("flgStrokeInit", stroke, struct_size, sized<FlgStroke>(), "stroke");
}

FlgResult flgCurveFileGetStroke(FlgCurveFile file, uint32_t curve, FlgStroke* out_stroke) {
    const auto strokes = [](const FlgCurveFileT& shown) -> auto& {
        return shown.data.strokes;
    };
    return show_one("flgCurveFileGetStroke", file, strokes, curve, "curve", out_stroke, "out_stroke");
}

void flgCurveFileRelease(FlgCurveFile file) {
    release(file);
}

FlgResult flgCurveFileWriteDescInit(FlgCurveFileWriteDesc* desc, uint32_t struct_size) {
    return init("flgCurveFileWriteDescInit", desc, struct_size, write_defaults());
}

FlgResult flgCurveFileInfoInit(FlgCurveFileInfo* info, uint32_t struct_size) {
    return init("flgCurveFileInfoInit", info, struct_size, sized<FlgCurveFileInfo>(), "info");
}

FlgResult flgCurveFileWrite(const char* path, const FlgCurveSetView* view, const FlgCurveFileWriteDesc* desc) {
    return write_to("flgCurveFileWrite", path, desc, [&](const Path& target) {
        const String extension = target.extension();
        const CheckedView curves(view);
        const FlgCurveFileWriteDesc checked = checked_desc(desc, curves);
        if (extension == ".glb") return write_file(target, write_glb(curves, checked));
        const bool obj = extension == ".obj";
        if (!obj && extension != ".xyz" && extension != ".txt")
            fail(FLG_ERROR_FORMAT, "", "can't be written: %s is none of .xyz .txt .obj .glb", cited(extension).c_str());
        FileWriter file(target);
        obj ? write_obj(curves, file) : write_xyz(curves, checked, file);
        file.finish();
    });
}

}  // extern "C"
