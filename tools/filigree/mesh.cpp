// SPDX-License-Identifier: MIT
// filigree mesh info, repair, refine: what a mesh is like as a surface, made so, made finer.
#include <iostream>
#include <memory>

#include "choices.h"
#include "command.h"
#include "documents/failure.h"
#include "documents/mesh_surface.h"
#include "documents/text_file.h"
#include "settled_mesh.h"

namespace flg::cli {
namespace {

constexpr uint32_t kMaxLevels = 8;

const std::map<std::string, FlgSubdivision> kSchemes = {{"midpoint", FLG_SUBDIVISION_MIDPOINT},
                                                        {"loop", FLG_SUBDIVISION_LOOP}};

struct Options {
    std::string mesh, output;
    float weld = 0.0f;
    uint32_t levels = 1;
    FlgSubdivision scheme = FLG_SUBDIVISION_MIDPOINT;
};

Report start_report(const std::string& command, const Options& options, const CommonOptions& common) {
    require_writable(common.report);
    Report report(command, common);
    report.parameters["mesh"] = options.mesh;
    report.parameters["weld"] = as_written(options.weld);
    return report;
}

// As the file has them: no labels where it has none, and other columns of its faces can't follow their triangles.
void write_as_stored(const std::string& output, const MeshFile& file, FlgMeshView mesh, Report& report) {
    if (file.view().regions == nullptr) mesh.regions = nullptr;
    for (const FlgMeshFaceColumn& column : file.face_columns()) {
        report.warn(file.name() + ": face property '" + column.name + "' is not carried over");
    }
    write_mesh(output, mesh);
}

void run_info(const Options& options, const CommonOptions& common) {
    Report report = start_report("mesh info", options, common);
    Session session(common);
    const MeshSurface surface(session, options.mesh, options.weld, report);
    const FlgMeshFileInfo& stored = surface.file().info();
    const FlgSurfaceReport& made = surface.report();
    const float *low = made.box_min, *high = made.box_max;
    const std::string defects = surface.defects();
    std::cout << options.mesh << ": " << stored.format << ", vertices " << stored.vertex_count << ", triangles "
              << stored.triangle_count << ", regions " << stored.region_count << "\n"
              << "repair: " << (defects.empty() ? "nothing to do" : defects) << "\n"
              << "surface: vertices " << made.vertex_count << ", triangles " << made.triangle_count
              << " (flat: " << made.flat_triangles << ")\n"
              << "components: " << made.component_count << ", borders: " << made.border_count << " ("
              << made.border_edges << " edges), Euler number: " << made.euler_number << ", genus: " << made.genus
              << "\n"
              << "area: " << made.area << " m2\n"
              << "box: " << low[0] << " " << low[1] << " " << low[2] << " to " << high[0] << " " << high[1] << " "
              << high[2] << " m\n";
    report.write();
}

void run_repair(const Options& options, const CommonOptions& common) {
    require_mesh_output(options.output, Regions::kept);
    Report report = start_report("mesh repair", options, common);
    Session session(common);
    const MeshSurface surface(session, options.mesh, options.weld, report);
    const SettledMesh settled(session, surface, report);
    write_as_stored(options.output, surface.file(), settled.view(), report);
    const std::string defects = surface.defects();
    const FlgSurfaceReport& made = surface.report();
    std::cout << options.mesh << ": " << (defects.empty() ? "nothing to repair" : defects) << "\n";
    if (settled.moved_vertices() > 0) {
        std::cout << "vertices moved apart: " << settled.moved_vertices() << ", by " << settled.farthest_move()
                  << " m at most\n";
    }
    std::cout << options.output << ": vertices " << settled.view().vertex_count << ", triangles "
              << settled.view().triangle_count << ", components " << made.component_count << ", borders "
              << made.border_count << "\n";
    report.write();
}

void run_refine(const Options& options, const CommonOptions& common) {
    require_mesh_output(options.output, Regions::kept);
    Report report = start_report("mesh refine", options, common);
    report.parameters["levels"] = options.levels;
    report.parameters["scheme"] = name_of(kSchemes, options.scheme);
    Session session(common);
    const MeshSurface surface(session, options.mesh, options.weld, report);
    surface.warn_of_repairs(report);

    FlgSurfaceRefineDesc desc;
    flgSurfaceRefineDescInit(&desc, sizeof desc);
    desc.surface = surface.handle();
    desc.levels = options.levels;
    desc.scheme = options.scheme;
    FlgSurface refined = {};
    FlgJob job = {};
    check(flgSurfaceRefine(session.context(), &desc, &refined, &job), options.mesh);
    session.finish({{{job, options.mesh}}}, report);

    FlgSurfaceReport made = {};
    made.struct_size = sizeof made;
    check(flgSurfaceGetReport(session.context(), refined, &made), options.mesh);
    report.counts["refined_vertices"] = made.vertex_count;
    report.counts["refined_triangles"] = made.triangle_count;
    report.quality["refined_area"] = made.area;
    write_as_stored(options.output, surface.file(), *view_of(session.context(), refined).mesh, report);
    report.write();
}

using Run = void (*)(const Options&, const CommonOptions&);

// A command with what all of them take.
Command add(CLI::App& app, const std::string& name, const std::string& description, Run run,
            const std::shared_ptr<Options>& o, const CommonOptions& common) {
    CLI::App* command = app.add_subcommand(name, description);
    command->add_option("MESH", o->mesh, "The mesh: .ply, .obj, .off, .gltf or .glb")->required();
    command
        ->add_option("--weld", o->weld,
                     "Vertices at most so far apart become one, metres; 0: those at the same place; below 0: none")
        ->type_name("D")
        ->capture_default_str()
        ->check(finite());
    return {command, [o, run, &common] { run(*o, common); }};
}

}  // namespace

std::vector<Command> add_mesh(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("mesh", "Inspects, repairs or refines a mesh");
    app->require_subcommand(1);
    const auto o = std::make_shared<Options>();
    std::vector<Command> commands = {
        add(*app, "info", "Shows components, borders, Euler number, and what a repair would do", run_info, o, common),
        add(*app, "repair",
            "Writes the mesh as a manifold surface that needs no further repair, and says what was wrong", run_repair,
            o, common),
        add(*app, "refine", "Splits each triangle into four, one or more times", run_refine, o, common)};
    for (size_t i = 1; i < commands.size(); ++i) {
        commands[i]
            .app->add_option("-o,--output", o->output, "Result: .ply, .obj, .off or .glb")
            ->required()
            ->type_name("OUT");
    }
    CLI::App* refine = commands.back().app;
    refine->add_option("--levels", o->levels, "Number of splits, 1 to 8")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1u, kMaxLevels).description(""));
    add_choice(*refine, "--scheme", o->scheme, kSchemes,
               "Places new vertices in the middle of their edges, or by Loop's scheme, which smoothes");
    return commands;
}

}  // namespace flg::cli
