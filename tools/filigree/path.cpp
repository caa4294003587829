// SPDX-License-Identifier: MIT
// filigree path: a locally shortest path along a mesh.
#include <array>
#include <memory>
#include <string>
#include <utility>

#include "command.h"
#include "documents/failure.h"
#include "documents/mesh_places.h"
#include "documents/text_file.h"
#include "path_curves.h"

namespace flg::cli {
namespace {

struct Options {
    std::string mesh, output;
    Place from, to;
};

std::string named(const Place& place) {
    return place.vertex ? "vertex " + place.text : place.text;
}

// The SDK's sentence with its names of the ends replaced by the user's.
InputError in_users_words(std::string sentence, const Options& options) {
    const std::pair<std::string, std::string> names[] = {{"desc.points[0]", named(options.from)},
                                                         {"desc.points[1]", named(options.to)}};
    for (const auto& [name, word] : names) {
        if (const size_t at = sentence.find(name); at != std::string::npos) sentence.replace(at, name.size(), word);
    }
    return InputError(sentence);
}

void run_path(const Options& options, const CommonOptions& common) {
    require_curve_output(options.output);
    require_writable(common.report);
    Report report("path", common);
    report.parameters["mesh"] = options.mesh;
    report.parameters["from"] = options.from.text;
    report.parameters["to"] = options.to.text;
    Session session(common);
    const MeshSurface surface(session, options.mesh, 0.0f, report);
    surface.warn_of_repairs(report);
    PlaceFinder from(surface, "--from"), to(surface, "--to");
    const std::array ends = {from.point(options.from), to.point(options.to)};
    const std::array<uint32_t, 2> offsets = {0, 2};

    FlgFieldTracePathsDesc desc;
    flgFieldTracePathsDescInit(&desc, sizeof desc);
    desc.surface = surface.handle();
    desc.points = ends.data();
    desc.path_offsets = offsets.data();
    desc.path_count = 1;
    FlgSurfaceCurves path = {};
    FlgJob job = {};
    const std::string subject = options.mesh + ": --from " + options.from.text + " --to " + options.to.text;
    check(flgFieldTracePaths(session.context(), &desc, &path, &job), subject);
    try {
        session.finish({{{job, subject}}}, report);
    } catch (const InputError& error) {
        throw in_users_words(error.what(), options);
    }

    const FlgSurfaceCurvesView traced = view_of(session.context(), path);
    if (traced.curve_count == 0) throw InputError(subject + ": they are the same place, so there is no path");
    report.quality["length"] = traced.curve_values[0];
    if (!options.from.vertex) report.quality["from_gap"] = from.gap();
    if (!options.to.vertex) report.quality["to_gap"] = to.gap();
    const FlgCurveSet curve = lift(session, path, subject, report);
    report.counts["path_points"] = write_curves(session.context(), curve, options.output);
    report.write();
}

}  // namespace

Command add_path(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("path", "Finds a locally shortest path along a mesh");
    const auto o = std::make_shared<Options>();
    app->add_option("MESH", o->mesh, "The mesh: .ply, .obj, .off, .gltf or .glb")->required();
    const std::string what = ": a vertex of the file, counted from 0, or a point (metres), snapped to the surface";
    add_place(*app, "--from", o->from, "Its start" + what)->required();
    add_place(*app, "--to", o->to, "Its end" + what)->required();
    app->add_option("-o,--output", o->output, "Result: .xyz, .obj or .glb")->required()->type_name("CURVE");
    return {app, [o, &common] { run_path(*o, common); }};
}

}  // namespace flg::cli
