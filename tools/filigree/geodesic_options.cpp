// SPDX-License-Identifier: MIT
#include "geodesic_options.h"

#include <algorithm>
#include <cmath>

#include "choices.h"
#include "documents/failure.h"

namespace flg::cli {
namespace {

const std::map<std::string, FlgAccuracy>& accuracy_names() {
    static const std::map<std::string, FlgAccuracy> names = {{"exact", FLG_ACCURACY_EXACT},
                                                             {"refined", FLG_ACCURACY_REFINED}};
    return names;
}

}  // namespace

void GeodesicOptions::add_to(CLI::App& app) {
    app.add_option("MESH", mesh, "The mesh: .ply, .obj, .off, .gltf or .glb")->required();
    add_places(app, "--source", sources,
               "Where distances are 0: vertices of the file, counted from 0, or points (metres), each snapped to "
               "the surface")
        ->required();
    add_choice(app, "--accuracy", accuracy, accuracy_names(),
               "refined: below 0.2 % of error. exact: the shortest ways over the triangles, by windows; for up to some "
               "300,000 triangles");
    app.add_option("--max-distance", max_distance, "Distances beyond this are left out, metres, > 0; default: none")
        ->type_name("D")
        ->check(above_zero());
}

void GeodesicOptions::describe(Report& report) const {
    report.parameters["mesh"] = mesh;
    report.parameters["source"] = nlohmann::ordered_json::array();
    for (const Place& source : sources) report.parameters["source"].push_back(source.text);
    report.parameters["accuracy"] = name_of(accuracy_names(), accuracy);
    if (std::isfinite(max_distance)) report.parameters["max_distance"] = as_written(max_distance);
}

FlgField GeodesicOptions::solve(Session& session, const MeshSurface& surface, Report& report) const {
    std::vector<uint32_t> vertices;
    std::vector<FlgSurfacePoint> points;
    PlaceFinder finder(surface, "--source");
    for (const Place& source : sources) {
        if (source.vertex) {
            vertices.push_back(finder.vertex(source));
        } else {
            points.push_back(finder.point(source));
        }
    }
    FlgFieldGeodesicDesc desc;
    flgFieldGeodesicDescInit(&desc, sizeof desc);
    desc.surface = surface.handle();
    desc.vertices = vertices.data();
    desc.vertex_count = static_cast<uint32_t>(vertices.size());
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size());
    desc.max_distance = max_distance;
    desc.accuracy = accuracy;
    FlgField field = {};
    FlgJob job = {};
    check(flgFieldCreateGeodesic(session.context(), &desc, &field, &job), mesh);
    session.finish({{{job, mesh}}}, report);

    const FlgFieldView view = view_of(session.context(), field);
    uint32_t reached = 0;
    float furthest = 0.0f;
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        if (!std::isfinite(view.values[v])) continue;
        ++reached;
        furthest = std::max(furthest, view.values[v]);
    }
    report.counts["sources"] = sources.size();
    report.counts["reached_vertices"] = reached;
    report.quality["furthest"] = furthest;
    if (!points.empty()) report.quality["source_gap"] = finder.gap();
    return field;
}

FlgFieldView view_of(FlgContext context, FlgField field) {
    FlgFieldView view;
    flgFieldViewInit(&view, sizeof view);
    check(flgFieldGetView(context, field, &view), "field");
    return view;
}

}  // namespace flg::cli
