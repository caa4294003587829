// SPDX-License-Identifier: MIT
// filigree straight-skeleton: the straight skeleton of a drawn shape.
#include <memory>

#include "command.h"
#include "contour_file.h"
#include "failure.h"
#include "filigree/filigree_skeleton.h"
#include "session.h"
#include "text_file.h"

namespace flg::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string contour, output;
};

FlgStraightSkeletonView make_skeleton(const Options& options, Session& session, const ContourArrays& contour,
                                      Report& report) {
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour.points = contour.points.data();
    desc.contour.point_count = static_cast<uint32_t>(contour.points.size() / 2);
    desc.contour.ring_offsets = contour.offsets.data();
    desc.contour.ring_count = static_cast<uint32_t>(contour.offsets.size()) - 1;
    FlgStraightSkeleton skeleton = {};
    FlgJob job = {};
    check(flgStraightSkeletonCreate(session.context(), &desc, &skeleton, &job), options.contour);
    session.finish({{{job, options.contour}}}, report);
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    check(flgStraightSkeletonGetView(session.context(), skeleton, &view), options.contour);
    return view;
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

void run_straight_skeleton(const Options& options, const CommonOptions& common) {
    require_writable(options.output);
    require_writable(common.report);
    Report report("straight-skeleton", common);
    const ContourArrays contour = read_contour_file(options.contour);
    Session session(common);
    const FlgStraightSkeletonView view = make_skeleton(options, session, contour, report);
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
    write_text_file(options.output, to_json(view).dump() + "\n");
    report.write();
}

}  // namespace

Command add_straight_skeleton(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("straight-skeleton", "The straight skeleton of a drawn shape");
    const auto o = std::make_shared<Options>();
    app->add_option("contour", o->contour, "Contour: .poly.txt (rings apart by empty lines), SketchPolyline*.txt")
        ->required()
        ->type_name("CONTOUR");
    app->add_option("-o,--output", o->output,
                    "Result: .json with nodes ([x, y, time]; the contour's come first), arcs ([from, to]) and faces")
        ->required()
        ->type_name("OUT.json");
    return {app, [o, &common] { run_straight_skeleton(*o, common); }};
}

}  // namespace flg::cli
