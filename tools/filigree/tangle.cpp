// SPDX-License-Identifier: MIT
// filigree tangle: decorates a mesh by a script.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "baked_maps.h"
#include "command.h"
#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/tangle_script.h"
#include "documents/text_file.h"
#include "filigree/filigree_bake.h"
#include "path_curves.h"
#include "tangle_document.h"

namespace flg::cli {
namespace {

struct Options {
    std::string mesh, script, output, document, masks, curves;
    std::optional<uint32_t> first;  // operations of the script
    BakeOptions bake;

    // With maps alone the output is the prefix of their files.
    bool writes_mesh() const { return bake.size == 0 || ends_with_one_of(output, {".glb", ".ply", ".obj"}); }
};

// What each leaf is shown as: a group, one number after the other.
struct Groups {
    std::vector<uint32_t> of_triangle;
    uint32_t count = 0;
};

Groups visible_groups(const TangleScript& script, const FlgMeshView& mesh) {
    std::map<uint32_t, uint32_t> numbers;
    std::vector<uint32_t> of_leaf(script.info().region_count, FLG_NO_INDEX);
    Groups groups;
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        uint32_t& group = of_leaf[mesh.regions[t]];
        if (group == FLG_NO_INDEX) {
            const uint32_t visible = script.region(mesh.regions[t]).visible_group;
            group = numbers.emplace(visible, static_cast<uint32_t>(numbers.size())).first->second;
        }
        groups.of_triangle.push_back(group);
    }
    groups.count = static_cast<uint32_t>(numbers.size());
    return groups;
}

// Whether the result is the asset that the mesh is, ornamented.
bool is_of_asset(const Options& options) {
    return ends_with_one_of(options.mesh, {".gltf", ".glb"}) && ends_with_one_of(options.output, {".glb"});
}

// The asset with its triangles cut, by the script's materials, or its own.
void write_ornamented(const Options& options, const MeshSurface& surface, const TangleScript& script, Report& report) {
    const TangleMaterials& materials = script.materials();
    if (materials.table.empty())
        report.warn(options.script + ": has no materials, so all regions have those of " + options.mesh);
    const FlgMeshView& mesh = *surface.view().mesh;
    const auto own = static_cast<uint32_t>(materials.table.size());
    std::vector<uint32_t> labels(mesh.triangle_count, own);
    for (uint32_t t = 0; !materials.table.empty() && t < mesh.triangle_count; ++t)
        labels[t] = std::min(materials.of_region[mesh.regions[t]], own);
    write_asset(options.output, surface, labels, materials.table);
}

// The cut mesh, by the script's materials, or by groups where it has none.
void write_result(const Options& options, const MeshSurface& surface, const TangleScript& script, const Groups& groups,
                  Report& report) {
    if (is_of_asset(options)) return write_ornamented(options, surface, script, report);
    FlgMeshView mesh = *surface.view().mesh;
    const TangleMaterials& materials = script.materials();
    if (materials.table.empty()) {
        mesh.regions = groups.of_triangle.data();
        write_mesh(options.output, mesh);
        return;
    }
    std::vector<uint32_t> of_triangle;
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        of_triangle.push_back(materials.of_region[mesh.regions[t]]);
    }
    mesh.regions = of_triangle.data();
    write_mesh(options.output, mesh, materials.table);
}

void write_masks(const Options& options, const FlgMeshView& mesh, const Groups& groups) {
    FlgMeshFaceColumn column = flgMeshFaceColumnDefaults();
    column.name = "group";
    column.values = groups.of_triangle.data();
    FlgMeshFileWriteDesc desc;
    flgMeshFileWriteDescInit(&desc, sizeof desc);
    desc.face_columns = &column;
    desc.face_column_count = 1;
    check(flgMeshFileWrite(options.masks.c_str(), &mesh, &desc), options.masks);
}

// Whether a selection names one of these.
bool selects_any(const nlohmann::json& selection, const std::set<std::string>& names) {
    if (selection.is_string()) {
        const std::string text = selection;
        return names.contains(text.substr(0, text.find('.')));
    }
    return selection.is_structured() &&
           std::any_of(selection.begin(), selection.end(),
                       [&](const nlohmann::json& part) { return selects_any(part, names); });
}

// A script's first operations, and the materials that need no others.
nlohmann::json first_operations(nlohmann::json script, uint32_t count, const std::string& file) {
    if (!script.contains("operations") || !script["operations"].is_array()) return script;  // refused when it is run
    nlohmann::json& operations = script["operations"];
    if (count > operations.size())
        throw UsageError("--first: " + file + " has " + std::to_string(operations.size()) + " operations");
    std::set<std::string> missing;
    for (size_t i = count; i < operations.size(); ++i) missing.insert(operations[i].value("name", ""));
    operations.erase(operations.begin() + count, operations.end());
    for (const nlohmann::json& operation : operations) missing.erase(operation.value("name", ""));
    nlohmann::json kept = nlohmann::json::array();
    for (const nlohmann::json& material : script.value("materials", nlohmann::json::array())) {
        if (!material.contains("on") || !selects_any(material["on"], missing)) kept.push_back(material);
    }
    if (script.contains("materials")) script["materials"] = kept;
    return script;
}

// What is written must not take the place of what is read, or of something else that is written.
void require_distinct(const Options& options, const CommonOptions& common) {
    std::map<std::filesystem::path, const char*> files;
    const auto add = [&](const std::string& file, const char* what) {
        if (file.empty()) return;
        const auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(file));
        const auto [found, is_new] = files.emplace(place, what);
        if (!is_new) throw UsageError(file + ": is both the " + found->second + " and the " + what);
    };
    add(options.mesh, "mesh");
    add(options.script, "script");
    add(options.output, "output");
    add(options.document, "document");
    add(options.masks, "masks");
    add(options.curves, "curves");
    add(common.report, "report");
}

FlgCurveSet trace_borders(Session& session, const TangleScript& script, const Options& options, Report& report) {
    FlgSurfaceCurves borders = {};
    FlgJob job = {};
    check(flgTangleTraceBorders(session.context(), script.tangle(), nullptr, &borders, &job), options.mesh);
    session.finish({{{job, options.mesh}}}, report);
    if (view_of(session.context(), borders).curve_count == 0) {
        report.warn(options.curves + ": not written, no border is seen");
        return {};
    }
    return lift(session, borders, options.mesh, report);
}

// The mesh's path without its extension, or the prefix itself.
BakeOptions prefixed(const Options& options) {
    BakeOptions bake = options.bake;
    bake.prefix = options.output;
    if (options.writes_mesh()) bake.prefix.resize(options.output.rfind('.'));
    return bake;
}

void run_tangle(const Options& options, const CommonOptions& common) {
    require_distinct(options, common);
    const BakeOptions bake = prefixed(options);
    if (options.writes_mesh()) require_mesh_output(options.output, Regions::needed);
    if (!options.masks.empty()) require_mesh_output(options.masks, Regions::needed);
    if (!options.curves.empty()) require_curve_output(options.curves);
    if (!options.document.empty()) require_writable(options.document);
    require_writable(common.report);
    nlohmann::json script = JsonPlace::read(options.script);
    if (options.first && is_document(script)) throw UsageError("--first: is for scripts, and this is a document");
    if (options.first) script = first_operations(std::move(script), *options.first, options.script);
    Report report("tangle", common);
    report.parameters["mesh"] = options.mesh;
    report.parameters["script"] = options.script;
    if (options.first) report.parameters["first"] = *options.first;
    Session session(common);
    const bool bakes = bake.size > 0;
    if (bakes) report.parameters["bake"] = bake.size;
    const MeshSurface surface(session, options.mesh, 0.0f, report, is_of_asset(options) || bakes);
    if (bakes) require_bakeable(bake, surface);
    surface.warn_of_repairs(report);
    TangleScript tangle(session, surface, report);
    if (is_document(script)) {
        replay_document(session, tangle.tangle(), options.script, report);
    } else {
        tangle.run(script, options.script, is_of_asset(options) || bakes);
    }

    const FlgCurveSet borders =
        options.curves.empty() ? FlgCurveSet{} : trace_borders(session, tangle, options, report);
    const FlgMeshView& mesh = *surface.view().mesh;
    const FlgTangleInfo info = tangle.info();
    const Groups groups = visible_groups(tangle, mesh);
    report.counts["regions"] = info.region_count;
    report.counts["leaves"] = info.leaf_count;
    report.counts["groups"] = groups.count;
    report.counts["steps"] = info.undo_count;
    report.counts["depth"] = info.depth;
    report.counts["cut_vertices"] = mesh.vertex_count;
    report.counts["cut_triangles"] = mesh.triangle_count;
    report.counts["materials"] = tangle.materials().table.size();
    if (bakes) bake_maps(session, bake, surface, tangle, report);
    if (options.writes_mesh()) write_result(options, surface, tangle, groups, report);
    if (!options.masks.empty()) write_masks(options, mesh, groups);
    if (borders.id != 0) {
        report.counts["border_points"] = write_curves(session.context(), borders, options.curves);
    }
    if (!options.document.empty()) write_document(session, tangle.tangle(), options.document);
    report.write();
}

}  // namespace

Command add_tangle(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("tangle", "Cuts recursive ornament into a mesh, by a script");
    const auto o = std::make_shared<Options>();
    app->add_option("MESH", o->mesh, "Mesh: .obj, .ply, .off, .gltf, .glb or builtin:NAME")->required();
    app->add_option(
           "SCRIPT", o->script,
           "Operations, JSON; sdk/tangles/README.md describes them. Or a document, to be made again on this mesh")
        ->required()
        ->type_name("SCRIPT.json");
    app->add_option(
           "-o,--output", o->output,
           "Result: .glb with a primitive a material, or a group where the script has no materials; .ply or .obj. A "
           ".gltf or .glb MESH goes into OUT.glb with all that it has: textures, skins, animations")
        ->required()
        ->type_name("OUT");
    app->add_option("--first", o->first, "Run only the first N operations; materials of the others are left out")
        ->type_name("N");
    app->add_option("--document", o->document, "Write all steps, to be made again on this mesh or on a finer one")
        ->type_name("D");
    app->add_option("--masks", o->masks, "Write the cut mesh with the face properties `region` and `group`")
        ->type_name("M.ply");
    app->add_option("--curves", o->curves, "Write the borders that are seen: .xyz, .obj or .glb")->type_name("C.xyz");
    CLI::Option* const bake =
        app->add_option("--bake", o->bake.size,
                        "Also draws the ornament into the mesh's own texture coordinates, for those who can't change "
                        "its triangles: square maps of so many texels a side, 1 to 16384, as PREFIX.MAP.png, where "
                        "PREFIX is OUT without its extension, and PREFIX.json with their scales; where the mesh has "
                        "several materials, PREFIX.MATERIAL.MAP.png by their numbers. An OUT without extension is the "
                        "PREFIX alone, and no mesh is written")
            ->check(CLI::Range(1u, FLG_BAKE_MAX_SIZE))
            ->type_name("SIZE");
    o->bake.maps = map_names();
    app->add_option("--maps", o->bake.maps,
                    "Which: ids (16 bits, the region; 65535 outside), distance (16 bits, to the border), borders (8 "
                    "bits, lines), height (16 bits, of displacement), normal (tangent space, y up), color (sRGB; "
                    "alpha: how much is the script's material and not the mesh's), material (green roughness, blue "
                    "metallic)")
        ->delimiter(',')
        ->check(CLI::IsMember(map_names()))
        ->needs(bake)
        ->capture_default_str();
    app->add_option("--border-width", o->bake.border_width,
                    "Of the lines in the map `borders`, metres. Default: 1/500 of the mesh's diagonal")
        ->check(CLI::PositiveNumber)
        ->needs(bake)
        ->type_name("W");
    return {app, [o, &common] { run_tangle(*o, common); }};
}

}  // namespace flg::cli
