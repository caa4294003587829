// SPDX-License-Identifier: MIT
// filigree contour: cuts a mesh along the isolines of a distance.
#include <algorithm>
#include <cmath>
#include <memory>

#include "choices.h"
#include "command.h"
#include "documents/failure.h"
#include "documents/text_file.h"
#include "geodesic_options.h"
#include "path_curves.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

struct Options {
    GeodesicOptions distances;
    float every = 0.0f;
    std::string output, curves;
};

// Throws InputError if no isoline would be met.
void require_levels(const Options& options, double furthest) {
    if (furthest >= double{options.every}) return;
    throw InputError(options.distances.mesh + ": --every: the first line would be at " + std::to_string(options.every) +
                     " m, but the furthest vertex is at " + std::to_string(furthest) + " m");
}

FlgCurveSet trace(const Options& options, Session& session, FlgField field, Report& report) {
    FlgFieldTraceIsolinesDesc desc;
    flgFieldTraceIsolinesDescInit(&desc, sizeof desc);
    desc.field = field;
    desc.level_first = desc.level_every = options.every;
    FlgSurfaceCurves isolines = {};
    FlgJob job = {};
    const std::string& mesh = options.distances.mesh;
    check(flgFieldTraceIsolines(session.context(), &desc, &isolines, &job), mesh);
    session.finish({{{job, mesh}}}, report);
    report.counts["isolines"] = view_of(session.context(), isolines).curve_count;
    return lift(session, isolines, mesh, report);
}

void cut(const Options& options, Session& session, FlgField field, Report& report) {
    FlgSurfaceCutIsolinesDesc desc;
    flgSurfaceCutIsolinesDescInit(&desc, sizeof desc);
    desc.field = field;
    desc.level_first = desc.level_every = options.every;
    desc.first_label = 0;
    FlgJob job = {};
    check(flgSurfaceCutIsolines(session.context(), &desc, nullptr, &job), options.distances.mesh);
    session.finish({{{job, options.distances.mesh}}}, report);
}

double area_of(const FlgColumn& positions, const uint32_t* corners) {
    double sides[2][3];
    const float* apex = samples::value_at(positions, corners[0]);
    for (size_t k = 0; k < 2; ++k) {
        const float* end = samples::value_at(positions, corners[k + 1]);
        for (size_t i = 0; i < 3; ++i) sides[k][i] = double{end[i]} - double{apex[i]};
    }
    const double *u = sides[0], *v = sides[1];
    return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

void describe_regions(const FlgMeshView& mesh, Report& report) {
    const uint32_t last = *std::max_element(mesh.regions, mesh.regions + mesh.triangle_count);
    std::vector<double> areas(last + 1, 0.0);
    const FlgColumn& positions = positions_of(mesh);
    for (size_t t = 0; t < mesh.triangle_count; ++t) {
        areas[mesh.regions[t]] += area_of(positions, mesh.triangles + 3 * t);
    }
    report.counts["cut_regions"] = areas.size();
    report.counts["cut_vertices"] = mesh.vertex_count;
    report.counts["cut_triangles"] = mesh.triangle_count;
    report.quality["region_areas"] = areas;
}

void run_contour(const Options& options, const CommonOptions& common) {
    require_mesh_output(options.output, Regions::needed);
    if (!options.curves.empty()) require_curve_output(options.curves);
    require_writable(common.report);
    Report report("contour", common);
    options.distances.describe(report);
    report.parameters["every"] = as_written(options.every);
    Session session(common);
    const MeshSurface surface(session, options.distances.mesh, 0.0f, report);
    surface.warn_of_repairs(report);
    const FlgField field = options.distances.solve(session, surface, report);
    require_levels(options, report.quality["furthest"]);
    const FlgCurveSet lines = options.curves.empty() ? FlgCurveSet{} : trace(options, session, field, report);
    cut(options, session, field, report);
    const FlgMeshView& mesh = *surface.view().mesh;
    describe_regions(mesh, report);
    write_mesh(options.output, mesh);
    if (!options.curves.empty()) {
        report.counts["isoline_points"] = write_curves(session.context(), lines, options.curves);
    }
    report.write();
}

}  // namespace

Command add_contour(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("contour", "Cuts a mesh along lines of equal distance");
    const auto o = std::make_shared<Options>();
    o->distances.add_to(*app);
    app->add_option("--every", o->every,
                    "Between the lines, metres, > 0; the first is at this distance; at most 256 lines")
        ->required()
        ->type_name("D")
        ->check(above_zero());
    app->add_option("-o,--output", o->output,
                    "Result: .ply, .obj or .glb, where the region of a triangle is the number of lines between it and "
                    "the sources; what is out of reach lies beyond all")
        ->required()
        ->type_name("OUT");
    app->add_option("--curves", o->curves, "Write the lines: .xyz, .obj or .glb")->type_name("C.xyz");
    return {app, [o, &common] { run_contour(*o, common); }};
}

}  // namespace flg::cli
