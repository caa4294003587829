// SPDX-License-Identifier: MIT
// filigree info FILE: what is in a file.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <memory>

#include "command.h"
#include "documents/failure.h"
#include "documents/text_file.h"
#include "file_contents.h"
#include "info.h"

namespace flg::cli {

std::string attribute_name(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_POSITION: return "position";
        case FLG_ATTRIBUTE_RADIUS: return "radius";
        case FLG_ATTRIBUTE_COLOR: return "color";
        case FLG_ATTRIBUTE_TANGENT: return "tangent";
        case FLG_ATTRIBUTE_NORMAL: return "normal";
        case FLG_ATTRIBUTE_TIME: return "time";
        case FLG_ATTRIBUTE_PRESSURE: return "pressure";
        case FLG_ATTRIBUTE_ORIENTATION: return "orientation";
        case FLG_ATTRIBUTE_STYLE_INDEX: return "style_index";
        case FLG_ATTRIBUTE_RADII: return "radii";
        case FLG_ATTRIBUTE_ANGLE: return "angle";
        case FLG_ATTRIBUTE_WIDTH: return "width";
        case FLG_ATTRIBUTE_SPEED: return "speed";
        case FLG_ATTRIBUTE_DISPLACEMENT: return "displacement";
        default: return "user" + std::to_string(attribute - FLG_ATTRIBUTE_USER);
    }
}

namespace {

using samples::CurveSource;

struct Measures {
    uint32_t closed = 0, single_points = 0, without_length = 0;
    uint64_t repeated_points = 0, backwards = 0;
    uint32_t fewest_points = std::numeric_limits<uint32_t>::max(), max_points = 0;
    double total_length = 0.0;
    std::vector<double> lengths;
    float low[3], high[3];
};

Measures measure(const FlgCurveSetView& view) {
    Measures m;
    std::fill(m.low, m.low + 3, std::numeric_limits<float>::max());
    std::fill(m.high, m.high + 3, std::numeric_limits<float>::lowest());
    const FlgColumn& positions = *samples::find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* times = samples::find_column(view, FLG_ATTRIBUTE_TIME);
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        const uint32_t first = view.curve_offsets[c], end = view.curve_offsets[c + 1];
        m.fewest_points = std::min(m.fewest_points, end - first);
        m.max_points = std::max(m.max_points, end - first);
        m.closed += view.curve_flags != nullptr && (view.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        const double length = samples::curve_length(view, c);
        m.lengths.push_back(length);
        m.total_length += length;
        if (end - first == 1) {
            ++m.single_points;
        } else if (length == 0.0) {
            ++m.without_length;
        }
        for (uint32_t i = first; i < end; ++i) {
            const float* p = samples::value_at(positions, i);
            for (int k = 0; k < 3; ++k) {
                m.low[k] = std::min(m.low[k], p[k]);
                m.high[k] = std::max(m.high[k], p[k]);
            }
            if (i == first) continue;
            const float* before = samples::value_at(positions, i - 1);
            m.repeated_points += std::equal(p, p + 3, before);
            if (times != nullptr) m.backwards += *samples::value_at(*times, i) < *samples::value_at(*times, i - 1);
        }
    }
    return m;
}

void add_brushes(const CurveSource& source, Report& report) {
    std::map<std::string, uint32_t> brushes;
    FlgStroke stroke = flgStrokeDefaults();
    for (uint32_t i = 0; source.file() && flgCurveFileGetStroke(source.file(), i, &stroke) == FLG_OK; ++i) {
        ++brushes[stroke.brush];
    }
    if (brushes.empty()) return;
    std::cout << "brushes:";
    const char* separator = " ";
    for (const auto& [brush, uses] : brushes) {
        std::cout << separator << brush << " " << uses;
        separator = ", ";
        report.counts["brushes"][brush] = uses;
    }
    std::cout << "\n";
}

void describe_curves(const CurveSource& source, Report& report) {
    const FlgCurveSetView& view = source.view();
    Measures m = measure(view);

    FlgCurveFileInfo info = {};
    info.struct_size = sizeof info;
    info.format = "built in";
    info.units = "metres";
    if (source.file() != nullptr && flgCurveFileGetInfo(source.file(), &info) != FLG_OK)
        throw InputError(flgIoErrorGetMessage());

    std::sort(m.lengths.begin(), m.lengths.end());
    const double median = m.lengths[m.lengths.size() / 2];
    std::cout << source.name() << ": " << info.format << ", units " << info.units << "\n"
              << "curves: " << view.curve_count << " (" << m.closed << " closed), points: " << source.point_count()
              << " (" << m.fewest_points << " to " << m.max_points << " a curve)\n"
              << "length: " << m.total_length << " m; a curve: " << m.lengths.front() << " to " << m.lengths.back()
              << " m, median " << median << " m\n"
              << "box: " << m.low[0] << " " << m.low[1] << " " << m.low[2] << " to " << m.high[0] << " " << m.high[1]
              << " " << m.high[2] << " m\n";
    describe_origin(view.origin, report);
    std::cout << "columns:";
    nlohmann::ordered_json columns = nlohmann::ordered_json::array();
    for (uint32_t i = 0; i < view.column_count; ++i) {
        std::cout << " " << attribute_name(view.columns[i].attribute);
        columns.push_back(attribute_name(view.columns[i].attribute));
    }
    std::cout << "\n";
    add_brushes(source, report);

    for (const std::string& warning : source.warnings()) {
        std::cout << "odd: " << warning << "\n";
        report.note(source.name() + ": " + warning);
    }
    const auto odd = [&](uint64_t count, const char* what) {
        if (count == 0) return;
        std::cout << "odd: " << count << " " << what << "\n";
    };
    odd(m.single_points, "curves of one point");
    odd(m.without_length, "curves without length");
    odd(m.repeated_points, "points that repeat the one before");
    odd(m.backwards, "time stamps that run backwards");

    report.parameters["format"] = info.format;
    report.parameters["units"] = info.units;
    report.parameters["columns"] = columns;
    report.counts["curves"] = view.curve_count;
    report.counts["closed"] = m.closed;
    report.counts["points"] = source.point_count();
    report.counts["single_points"] = m.single_points;
    report.counts["without_length"] = m.without_length;
    report.counts["repeated_points"] = m.repeated_points;
    report.counts["backward_times"] = m.backwards;
    report.quality["total_length"] = m.total_length;
    report.quality["curve_length"] = {{"min", m.lengths.front()}, {"median", median}, {"max", m.lengths.back()}};
    report.quality["box"] = {{m.low[0], m.low[1], m.low[2]}, {m.high[0], m.high[1], m.high[2]}};
}

void run_info(const std::string& name, const CommonOptions& common) {
    require_writable(common.report);
    Report report("info", common);
    report.parameters["file"] = name;
    const FileContents contents = read_contents(name);
    if (contents.curves) describe_curves(*contents.curves, report);
    if (contents.mesh) describe_mesh(*contents.mesh, report);
    if (contents.skin) describe_skin(*contents.skin, report);
    if (!contents.why_no_skin.empty()) {
        std::cout << "odd: no skin is read: " << contents.why_no_skin << "\n";
        report.note("no skin is read: " + contents.why_no_skin);
    }
    report.write();
}

}  // namespace

Command add_info(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("info", "Shows what is in a file: counts, sizes, units, oddities");
    const auto file = std::make_shared<std::string>();
    app->add_option("FILE", *file, "Curves or a mesh: a file or builtin:NAME")->required();
    return {app, [file, &common] { run_info(*file, common); }};
}

}  // namespace flg::cli
