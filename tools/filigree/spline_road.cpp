// SPDX-License-Identifier: MIT
#include "spline_road.h"

#include <algorithm>

#include "choices.h"
#include "documents/failure.h"
#include "documents/mesh_surface.h"

namespace flg::cli {
namespace {

// Of all roads.
struct Joined {
    std::vector<std::vector<float>> values;  // by column
    std::vector<FlgColumn> columns;
    std::vector<uint32_t> triangles;
    FlgMeshView view = {};

    void add(const FlgMeshView& mesh) {
        const uint32_t first = view.vertex_count;
        if (columns.empty()) {
            view = mesh;
            view.vertex_count = 0;
            columns.assign(mesh.columns, mesh.columns + mesh.column_count);
            values.resize(columns.size());
        }
        for (size_t c = 0; c < columns.size(); ++c)
            values[c].insert(values[c].end(), mesh.columns[c].data,
                             mesh.columns[c].data + size_t{columns[c].components} * mesh.vertex_count);
        for (size_t i = 0; i < size_t{3} * mesh.triangle_count; ++i) triangles.push_back(first + mesh.triangles[i]);
        view.vertex_count += mesh.vertex_count;
    }
    const FlgMeshView& whole() {
        for (size_t c = 0; c < columns.size(); ++c) columns[c].data = values[c].data();
        view.columns = columns.data();
        view.triangles = triangles.data();
        view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        view.regions = nullptr;
        return view;
    }
};

}  // namespace

void add_road_options(CLI::App& app, RoadOptions& options) {
    app.add_option("--road", options.width,
                   "Also makes a road so wide (metres): a mesh along the curve, on a mesh over its triangles")
        ->check(above_zero());
    app.add_option("--road-output", options.output, "Where it is written: .obj, .ply, .off or .glb")->type_name("MESH");
    app.add_option("--road-columns", options.columns, "Quads across")
        ->check(CLI::Range(1u, 256u))
        ->needs("--road")
        ->capture_default_str();
    app.add_option("--road-spacing", options.spacing,
                   "From one row to the next (metres); 0: a row at each point of the curve")
        ->check(at_least_zero())
        ->needs("--road")
        ->capture_default_str();
    app.add_option("--road-height", options.height, "Lifts it along its normals (metres)")
        ->check(finite())
        ->needs("--road")
        ->capture_default_str();
    app.add_option("--road-up", options.up, "Makes rows straight, and level across this direction: 0,0,1")
        ->delimiter(',')
        ->expected(3)
        ->needs("--road")
        ->type_name("X,Y,Z");
    app.add_option("--road-bank", options.bank,
                   "Makes rows straight, and leans them into bends: the square of a speed over 9.81 (metres)")
        ->check(finite())
        ->needs("--road")
        ->capture_default_str();
    app.add_option("--road-texture", options.texture_length, "Length of a texture along it (metres); 0: its width")
        ->check(at_least_zero())
        ->needs("--road")
        ->capture_default_str();
}

void check_road_options(const RoadOptions& options) {
    if (options.is_wanted() != !options.output.empty()) throw UsageError("--road and --road-output go together");
    if (options.is_wanted()) require_mesh_output(options.output, Regions::kept);
}

void write_roads(Session& session, const RoadOptions& options, bool on_mesh, const std::vector<FlgSpline>& splines,
                 Report& report) {
    FlgSplineSweepDesc desc = flgSplineSweepDefaults();
    desc.columns = options.columns;
    desc.width = options.width;
    desc.spacing = options.spacing;
    desc.height = options.height;
    desc.bank = options.bank;
    desc.texture_length = options.texture_length;
    desc.conforms = on_mesh && options.up.empty() && options.bank == 0;
    std::copy(options.up.begin(), options.up.end(), desc.up);
    Joined joined;
    double narrowest = options.width;
    for (const FlgSpline spline : splines) {
        desc.spline = spline;
        FlgSurface road = {};
        FlgJob job = {};
        check(flgSplineSweep(session.context(), &desc, &road, &job), options.output);
        session.finish({{{job, options.output}}}, report);
        const FlgMeshView& mesh = *view_of(session.context(), road).mesh;
        const FlgColumn* const widths = flgMeshViewGetColumn(&mesh, FLG_ATTRIBUTE_WIDTH);
        narrowest = std::min(narrowest, double{*std::min_element(widths->data, widths->data + mesh.vertex_count)});
        joined.add(mesh);
        flgSurfaceRelease(session.context(), road);
    }
    const FlgMeshView& whole = joined.whole();
    report.counts["road_vertices"] = whole.vertex_count;
    report.counts["road_triangles"] = whole.triangle_count;
    report.quality["road_narrowest"] = narrowest;
    if (narrowest < 0.999 * options.width)
        report.warn("--road: " + std::to_string(narrowest) +
                    " m wide at its narrowest, where a bend is tighter, or "
                    "the mesh ends");
    write_mesh(options.output, whole);
}

}  // namespace flg::cli
