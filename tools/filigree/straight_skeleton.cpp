// SPDX-License-Identifier: MIT
// filigree straight-skeleton: the straight skeleton of a drawn shape.
#include <memory>

#include "command.h"
#include "documents/contour_file.h"
#include "documents/failure.h"
#include "documents/session.h"
#include "documents/text_file.h"
#include "filigree/filigree_skeleton.h"

namespace flg::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string contour, output;
    std::vector<double> offsets;
    bool repair = false;
};

FlgStraightSkeleton make_skeleton(const Options& options, Session& session, const ContourArrays& contour,
                                  Report& report) {
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.repair = options.repair ? 1 : 0;
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = contour.points.data();
    drawn.point_count = static_cast<uint32_t>(contour.points.size() / 2);
    drawn.ring_offsets = contour.offsets.data();
    drawn.ring_count = static_cast<uint32_t>(contour.offsets.size()) - 1;
    desc.contour = &drawn;
    FlgStraightSkeleton skeleton = {};
    FlgJob job = {};
    check(flgStraightSkeletonCreate(session.context(), &desc, &skeleton, &job), options.contour);
    session.finish({{{job, options.contour}}}, report);
    return skeleton;
}

Json to_json(const FlgStraightSkeletonView& view) {
    Json nodes = Json::array(), arcs = Json::array(), faces = Json::array();
    for (size_t i = 0; i < view.node_count; ++i) {
        const double* n = view.nodes + 3 * i;
        nodes.push_back({n[0], n[1], n[2]});
    }
    for (size_t i = 0; i < view.arc_count; ++i) arcs.push_back({view.arcs[4 * i], view.arcs[4 * i + 1]});
    for (size_t f = 0; f < view.contour_count; ++f) {
        const std::vector<uint32_t> ring(view.face_nodes + view.face_offsets[f],
                                         view.face_nodes + view.face_offsets[f + 1]);
        faces.push_back({{"edge", f}, {"ring", ring}});
    }
    Json json;
    json["nodes"] = std::move(nodes);
    json["arcs"] = std::move(arcs);
    json["faces"] = std::move(faces);
    return json;
}

// {"distance": D, "rings": [[[x, y], ...], ...]}
Json offset_json(const Options& options, Session& session, FlgStraightSkeleton skeleton, double distance) {
    FlgOffsetPolygons polygons = flgOffsetPolygonsDefaults();
    check(flgStraightSkeletonOffset(session.context(), skeleton, distance, &polygons), options.contour);
    std::vector<double> points(2 * size_t{polygons.point_count});
    std::vector<uint32_t> offsets(polygons.ring_count + 1);
    polygons.points = points.data();
    polygons.ring_offsets = offsets.data();
    polygons.point_capacity = polygons.point_count;
    polygons.ring_capacity = polygons.ring_count;
    check(flgStraightSkeletonOffset(session.context(), skeleton, distance, &polygons), options.contour);
    Json rings = Json::array();
    for (size_t r = 0; r < polygons.ring_count; ++r) {
        Json ring = Json::array();
        for (size_t i = offsets[r]; i < offsets[r + 1]; ++i) ring.push_back({points[2 * i], points[2 * i + 1]});
        rings.push_back(std::move(ring));
    }
    return {{"distance", distance}, {"rings", std::move(rings)}};
}

void run_straight_skeleton(const Options& options, const CommonOptions& common) {
    require_writable(options.output);
    require_writable(common.report);
    Report report("straight-skeleton", common);
    const ContourArrays contour = read_contour_file(options.contour);
    Session session(common);
    const FlgStraightSkeleton skeleton = make_skeleton(options, session, contour, report);
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    check(flgStraightSkeletonGetView(session.context(), skeleton, &view), options.contour);
    report.parameters["repair"] = options.repair;
    report.counts["input_points"] = contour.points.size() / 2;
    report.counts["rings"] = contour.offsets.size() - 1;
    report.counts["contour_points"] = view.contour_count;
    report.counts["nodes"] = view.node_count;
    report.counts["arcs"] = view.arc_count;
    report.quality["residual"] = view.residual;
    report.quality["perturbation"] = view.perturbation;
    if (view.perturbation > 0) {
        report.warn(options.contour + ": changes at nearly one time could not be told apart; points were moved by " +
                    Json(view.perturbation).dump() + " of its size");
    }
    Json json = to_json(view);
    if (!options.offsets.empty()) json["offsets"] = Json::array();
    for (const double distance : options.offsets)
        json["offsets"].push_back(offset_json(options, session, skeleton, distance));
    write_text_file(options.output, json.dump() + "\n");
    report.write();
}

}  // namespace

Command add_straight_skeleton(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("straight-skeleton", "Computes the straight skeleton of a drawn shape");
    const auto o = std::make_shared<Options>();
    app->add_option("CONTOUR", o->contour, "Contour: .poly.txt (rings apart by empty lines), SketchPolyline*.txt, .svg")
        ->required()
        ->type_name("CONTOUR");
    app->add_option("-o,--output", o->output,
                    "Result: .json with nodes ([x, y, time]; the contour's come first), arcs ([from, to]) and faces")
        ->required()
        ->type_name("OUT.json");
    app->add_option(
           "--offset", o->offsets,
           "Also the contour moved inwards by D, in its unit, 0 or more: `offsets`, with rings of points; more "
           "than once if wanted")
        ->type_name("D")
        ->check(CLI::NonNegativeNumber);
    app->add_flag("--repair", o->repair, "The contour may cross itself: of what it goes around the largest part");
    return {app, [o, &common] { run_straight_skeleton(*o, common); }};
}

}  // namespace flg::cli
