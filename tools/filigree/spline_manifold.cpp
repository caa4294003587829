// SPDX-License-Identifier: MIT
#include "spline_manifold.h"

#include <charconv>
#include <vector>

#include "documents/failure.h"
#include "documents/space_lines.h"
#include "filigree/filigree_io.h"

namespace flg::cli {
namespace {

// The numbers behind a name, `torus:2,0.5`.
std::vector<double> numbers_after(const std::string& text, size_t colon) {
    std::vector<double> numbers;
    size_t at = colon;
    while (at < text.size()) {
        const size_t begin = at + 1, end = std::min(text.find(',', begin), text.size());
        double value = 0;
        const auto read = std::from_chars(text.data() + begin, text.data() + end, value);
        if (read.ec != std::errc() || read.ptr != text.data() + end) {
            throw UsageError("SURFACE: '" + text.substr(begin, end - begin) + "' in " + text + " is not a number");
        }
        numbers.push_back(value);
        at = end;
    }
    return numbers;
}

std::string formula_names() {
    std::string names;
    for (uint32_t i = 0; flgFormulaGetName(i); ++i) names += std::string(i == 0 ? "" : ", ") + flgFormulaGetName(i);
    return names;
}

// Whether the text is a shape; then its description.
bool read_shape(const std::string& text, bool among_obstacles, FlgManifoldShapeDesc& desc, std::string& formula) {
    flgManifoldShapeDescInit(&desc, sizeof desc);
    const size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    const auto need = [&](size_t count, const char* form) {
        const std::vector<double> numbers =
            colon == std::string::npos ? std::vector<double>() : numbers_after(text, colon);
        if (numbers.size() != count) throw UsageError("SURFACE: " + text + " must be " + form);
        return numbers;
    };
    if (kind == "sphere") {
        desc.shape = FLG_MANIFOLD_SHAPE_SPHERE;
        desc.radius = need(1, "sphere:R")[0];
    } else if (kind == "torus") {
        desc.shape = FLG_MANIFOLD_SHAPE_TORUS;
        const std::vector<double> radii = need(2, "torus:R,r");
        desc.radius = radii[0];
        desc.tube_radius = radii[1];
    } else if (text == "plane") {
        desc.shape = among_obstacles ? FLG_MANIFOLD_SHAPE_SPACE : FLG_MANIFOLD_SHAPE_PLANE;
        if (among_obstacles) desc.ambient = 2;
    } else if (text == "space") {
        desc.shape = FLG_MANIFOLD_SHAPE_SPACE;
    } else if (kind == "implicit" && colon != std::string::npos) {
        desc.shape = FLG_MANIFOLD_SHAPE_FORMULA;
        formula = text.substr(colon + 1);
        bool known = false;
        for (uint32_t i = 0; flgFormulaGetName(i); ++i) known = known || formula == flgFormulaGetName(i);
        if (!known) throw UsageError("SURFACE: implicit:" + formula + " is none of " + formula_names());
        desc.name = formula.c_str();
    } else {
        return false;
    }
    return true;
}

// Files whose points have no triangles: .xyz, and .ply without faces.
bool is_cloud(const std::string& file) {
    return file.ends_with(".xyz") || file.ends_with(".XYZ");
}

void make_cloud(Session& session, const std::string& file, double smoothing_scale, SplineManifold& out,
                Report& report) {
    const SpaceLines lines = read_lines(file, report);
    FlgManifoldFromPointsDesc desc;
    flgManifoldFromPointsDescInit(&desc, sizeof desc);
    desc.points = lines.positions.data();
    std::copy(lines.origin.begin(), lines.origin.end(), desc.origin);
    desc.point_count = lines.offsets.back();
    desc.smoothing_scale = smoothing_scale;
    report.counts["cloud_points"] = desc.point_count;
    FlgJob job = {};
    check(flgManifoldCreateFromPoints(session.context(), &desc, &out.handle, &job), file);
    session.finish({{{job, file}}}, report);
}

void make_mesh(Session& session, const std::string& file, double smoothing_scale, SplineManifold& out, Report& report) {
    out.mesh = std::make_unique<MeshSurface>(session, file, 0.0f, report);
    out.mesh->warn_of_repairs(report);
    FlgManifoldFromSurfaceDesc desc;
    flgManifoldFromSurfaceDescInit(&desc, sizeof desc);
    desc.surface = out.mesh->handle();
    desc.smoothing_scale = smoothing_scale;
    FlgJob job = {};
    check(flgManifoldCreateFromSurface(session.context(), &desc, &out.handle, &job), file);
    session.finish({{{job, file}}}, report);
}

}  // namespace

SplineManifold make_spline_manifold(Session& session, const std::string& text, const SplineManifoldOptions& options,
                                    Report& report) {
    SplineManifold out;
    out.name = text;
    FlgManifoldShapeDesc shape;
    std::string formula;
    if (read_shape(text, options.among_obstacles, shape, formula)) {
        if (options.smoothing_scale > 0)
            throw UsageError("--smoothing-scale: SURFACE must be a mesh or a cloud, not " + text);
        out.is_space = shape.shape == FLG_MANIFOLD_SHAPE_SPACE;
        if (flgManifoldCreateShape(session.context(), &shape, &out.handle) != FLG_OK) {
            throw UsageError("SURFACE: " + text + ": " + flgErrorGetMessage());
        }
    } else if (is_cloud(text)) {
        make_cloud(session, text, options.smoothing_scale, out, report);
    } else {
        make_mesh(session, text, options.smoothing_scale, out, report);
    }
    if (options.feature > 0) {
        const FlgManifold base = out.handle;
        check(flgManifoldCreateImage(session.context(), base, options.feature, &out.handle), text + ": --feature");
    }
    flgManifoldViewInit(&out.view, sizeof out.view);
    check(flgManifoldGetView(session.context(), out.handle, &out.view), text);
    if (out.view.largest_deviation > 0) {
        report.quality["surface_deviation_max"] = out.view.largest_deviation;
        report.quality["surface_deviation_rms"] = out.view.mean_deviation;
    }
    return out;
}

}  // namespace flg::cli
