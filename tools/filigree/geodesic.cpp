// SPDX-License-Identifier: MIT
// filigree geodesic: distances along a mesh.
#include <charconv>
#include <limits>
#include <memory>

#include "command.h"
#include "documents/failure.h"
#include "documents/text_file.h"
#include "geodesic_options.h"

namespace flg::cli {
namespace {

struct Options {
    GeodesicOptions distances;
    std::string output;
};

// One distance a vertex of the file, in its order.
std::string field_text(const MeshSurface& surface, const FlgFieldView& field) {
    std::string text;
    char number[32];
    for (uint32_t v = 0; v < surface.file().info().vertex_count; ++v) {
        const uint32_t vertex = surface.vertex_of_input(v);
        const float distance = vertex == FLG_NO_INDEX ? std::numeric_limits<float>::infinity() : field.values[vertex];
        const auto end = std::to_chars(number, number + sizeof number, distance, std::chars_format::general, 9).ptr;
        text.append(number, end).push_back('\n');
    }
    return text;
}

void run_geodesic(const Options& options, const CommonOptions& common) {
    require_writable(options.output);
    require_writable(common.report);
    Report report("geodesic", common);
    options.distances.describe(report);
    Session session(common);
    const MeshSurface surface(session, options.distances.mesh, 0.0f, report);
    surface.warn_of_repairs(report);
    const FlgField field = options.distances.solve(session, surface, report);
    write_text_file(options.output, field_text(surface, view_of(session.context(), field)));
    report.write();
}

}  // namespace

Command add_geodesic(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("geodesic", "Measures distances along a mesh");
    const auto o = std::make_shared<Options>();
    o->distances.add_to(*app);
    app->add_option("-o,--output", o->output,
                    "Result: one distance a line (metres) for each vertex of the file, inf where no way leads")
        ->required()
        ->type_name("FIELD.txt");
    return {app, [o, &common] { run_geodesic(*o, common); }};
}

}  // namespace flg::cli
