// SPDX-License-Identifier: MIT
// filigree skeleton: from contours to bones.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>

#include "choices.h"
#include "command.h"
#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/pull_script.h"
#include "documents/rig_quality.h"
#include "documents/text_file.h"
#include "filigree/filigree_io.h"
#include "mesh_model.h"
#include "mesh_outline_part.h"
#include "pulled_skin.h"
#include "rigged_skin.h"
#include "skin_looks.h"

namespace flg::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> contours;
    std::string mesh;  // instead of contours
    std::string output, bones, previous;
    std::optional<float> simplify, merge, prune, collapse, detail;
    std::string root;
    std::vector<std::string> apart, depths;
    uint32_t vertices = flgSkinDefaults().vertex_count;
    bool asks_vertices = false;
    std::vector<uint32_t> levels;
    double sharp_degrees = 0;
    PictureOptions picture;
    bool repair = false;
    std::array<float, 3> from = {0, 0, 1};
    RigOptions rig;
    std::string pull, pulled;  // a script; a mesh
    std::optional<double> pulled_at;
    std::optional<PullScript> script;
};

const std::map<std::string, FlgRigStandard> standards = {
    {"vrm", FLG_RIG_STANDARD_VRM}, {"unity", FLG_RIG_STANDARD_UNITY}, {"unreal", FLG_RIG_STANDARD_UNREAL}};
const std::map<std::string, SkinMotion> motions = {
    {"walk", SkinMotion::walk}, {"idle", SkinMotion::idle}, {"wave", SkinMotion::wave}, {"swing", SkinMotion::swing}};

// NAME,REST at the last comma: names may have some.
std::array<std::string, 2> at_comma(const std::string& text, const char* option, const char* form) {
    const size_t comma = text.rfind(',');
    if (comma == std::string::npos || comma == 0 || comma + 1 == text.size())
        throw UsageError(std::string(option) + ": must be " + form + ", not " + text);
    return {text.substr(0, comma), text.substr(comma + 1)};
}

void set_depths(const Options& options, ModelDrawing& drawing) {
    for (const std::string& text : options.apart) drawing.apart.push_back(at_comma(text, "--apart", "PART,PART"));
    for (const std::string& text : options.depths) {
        const auto [name, number] = at_comma(text, "--depth", "PART,NUMBER");
        const auto part = std::find_if(drawing.parts.begin(), drawing.parts.end(),
                                       [&name = name](const DrawnPart& drawn) { return drawn.name == name; });
        if (part == drawing.parts.end()) throw UsageError("--depth: there is no part " + name);
        char* end = nullptr;
        part->depth = std::strtof(number.c_str(), &end);
        if (*end != 0 || !std::isfinite(part->depth)) throw UsageError("--depth: " + number + " is not a number");
    }
}

void set_thresholds(const Options& options, FlgBoneThresholds& thresholds) {
    thresholds.simplify = options.simplify.value_or(thresholds.simplify);
    thresholds.merge = options.merge.value_or(thresholds.merge);
    thresholds.prune = options.prune.value_or(thresholds.prune);
    thresholds.collapse = options.collapse.value_or(thresholds.collapse);
    thresholds.detail = options.detail.value_or(thresholds.detail);
}

ModelDrawing read_drawing(const Options& options, Session& session, Report& report) {
    ModelDrawing drawing;
    if (options.contours.size() == 1 && options.contours[0].ends_with(".json")) {
        drawing = read_model_drawing(options.contours[0]);
    } else {
        for (const std::string& path : options.contours) {
            if (is_mesh_file(path)) {
                drawing.parts.push_back(read_mesh_part(session, path, options.from, report));
                continue;
            }
            std::vector<std::string> warnings;
            for (DrawnPart& part : read_contour_parts(path, warnings)) drawing.parts.push_back(std::move(part));
            for (const std::string& warning : warnings) report.warn(warning);
        }
    }
    drawing.repair = options.repair;
    if (!options.root.empty()) drawing.root = options.root;
    set_depths(options, drawing);
    set_thresholds(options, drawing.thresholds);
    for (DrawnPart& part : drawing.parts)
        if (part.thresholds) set_thresholds(options, *part.thresholds);
    return drawing;
}

const char* limb_name(FlgLimb limb) {
    static constexpr const char* names[] = {"trunk", "neck", "head", "arm", "leg", "tail", "other"};
    return names[limb];
}

Json bones_json(const FlgModelView& view, const ModelDrawing& drawing, const FlgRig* rig) {
    static constexpr const char* events[] = {"root", "bone_split", "joint_connect"};
    const auto number = [](uint32_t index) { return index == FLG_NO_INDEX ? Json(nullptr) : Json(index); };
    Json joints = Json::array(), parts = Json::array();
    for (size_t j = 0; j < view.joint_count; ++j) {
        std::array<double, 3> at;
        for (size_t k = 0; k < 3; ++k) at[k] = double{view.joint_positions[3 * j + k]} + view.origin[k];
        const double* place = view.joint_places + 3 * j;
        joints.push_back({{"name", view.joint_names[j]},
                          {"key", view.joint_keys[j]},
                          {"parent", number(view.joint_parents[j])},
                          {"part", view.joint_parts[j]},
                          {"position", at},
                          {"radius", view.joint_radii[j]},
                          {"place", {place[0], place[1], place[2]}},
                          {"pinned", view.joint_pinned[j] != 0}});
        if (!rig) continue;
        joints.back()["limb"] = limb_name(rig->joints[j].limb);
        joints.back()["side"] = rig->joints[j].side;
        joints.back()["pair"] = rig->joints[j].pair;
    }
    for (size_t p = 0; p < view.part_count; ++p) {
        parts.push_back({{"name", drawing.parts[view.part_sources[p]].name},
                         {"event", events[view.part_events[p]]},
                         {"parent", number(view.part_parents[p])},
                         {"joint", view.part_joints[p]},
                         {"source", view.part_sources[p]},
                         {"twin", number(view.part_twins[p])},
                         {"mirrored", view.part_mirrored[p] != 0}});
    }
    return {{"size", view.size}, {"joints", std::move(joints)}, {"parts", std::move(parts)}};
}

constexpr double kOffCount = 0.02;  // of the vertices asked for: what is said when it is more

constexpr double kStretched = 3;  // what is said when a surface stretches more

// `wanted`: 0 if nobody asked for a number.
FlgSkinView view_of(Session& session, FlgSkin skin, uint32_t wanted, const Options& options, Report& report) {
    FlgSkinView view = flgSkinViewDefaults();
    check(flgSkinGetView(session.context(), skin, &view), options.output);
    if (wanted != 0 && std::abs(static_cast<double>(view.vertex_count) / wanted - 1) > kOffCount)
        report.warn(options.output + ": a surface has " + std::to_string(view.vertex_count) + " vertices in place of " +
                    std::to_string(wanted) + ": its thin parts, borders, corners, holes and pieces need them");
    return view;
}

FlgSkin make_skin(const Options& options, Session& session, FlgModel model, Report& report) {
    constexpr double kDegree = 3.14159265358979323846 / 180;
    FlgSkinDesc desc = flgSkinDefaults();
    desc.model = model;
    desc.vertex_count = options.vertices;
    desc.corner_angle = static_cast<float>(options.sharp_degrees * kDegree);
    FlgSkin skin = {};
    FlgJob job = {};
    check(flgSkinCreate(session.context(), &desc, &skin, &job), options.output);
    session.finish({{{job, options.output}}}, report);
    return skin;
}

// All of the skin itself: so no level hands on what another lost.
std::vector<FlgSkinView> make_levels(const Options& options, Session& session, FlgSkin skin, Report& report) {
    std::vector<Session::Pending> jobs;
    std::vector<FlgSkin> levels;
    for (const uint32_t vertices : options.levels) {
        FlgSkinSimplifyDesc desc = flgSkinSimplifyDefaults();
        desc.skin = skin;
        desc.vertex_count = vertices;
        FlgJob job = {};
        check(flgSkinSimplify(session.context(), &desc, &levels.emplace_back(), &job), options.output);
        jobs.push_back({job, options.output});
    }
    if (!jobs.empty()) session.finish(jobs, report);
    std::vector<FlgSkinView> views;
    for (size_t i = 0; i < levels.size(); ++i)
        views.push_back(view_of(session, levels[i], options.levels[i], options, report));
    return views;
}

// A model with what its file has besides.
struct Made {
    FlgSkinView skin;
    std::vector<FlgSkinView> levels;
    SkinLooks looks;
};

Made make_drawn_skin(const Options& options, Session& session, FlgModel model, SkinLooks looks, Report& report) {
    const FlgSkin skin = make_skin(options, session, model, report);
    const uint32_t wanted = options.asks_vertices ? options.vertices : 0;
    return {view_of(session, skin, wanted, options, report), make_levels(options, session, skin, report),
            std::move(looks)};
}

// What a pulled mesh is like at one moment, in the colours of its parts.
void write_pulled(const Options& options, const FlgSkinView& skin, const SkinLooks& looks, const PulledSkin& pulled) {
    const std::vector<float> positions = pulled.positions_at(options.pulled_at.value_or(options.script->end()));
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    std::vector<uint32_t> parts;
    for (size_t t = 0; t < skin.triangle_count && looks.materials.size() > 1; ++t) {
        const uint32_t* c = skin.triangles + 3 * t;
        const uint32_t* const of = skin.vertex_parts;
        parts.push_back(skin.triangle_parts ? skin.triangle_parts[t] : of[c[1]] == of[c[2]] ? of[c[1]] : of[c[0]]);
    }
    FlgMeshView mesh = flgMeshViewDefaults();
    mesh.vertex_count = skin.vertex_count;
    mesh.triangle_count = skin.triangle_count;
    mesh.triangles = skin.triangles;
    mesh.columns = &column;
    mesh.column_count = 1;
    if (!parts.empty()) mesh.regions = parts.data();
    std::copy(std::begin(skin.origin), std::end(skin.origin), mesh.origin);
    FlgMeshFileWriteDesc file = flgMeshFileWriteDefaults();
    file.split_regions = 1;
    file.materials = looks.materials.data();
    file.material_count = static_cast<uint32_t>(looks.materials.size());
    if (flgMeshFileWrite(options.pulled.c_str(), &mesh, &file) != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

void write_skin(const Options& options, const std::string& subject, const ModelDrawing& drawing,
                const FlgModelView& bones, const Made& made, bool is_reported, Session& session, Report& report) {
    const FlgSkinView& view = made.skin;
    report.counts["vertices"] = view.vertex_count;
    report.counts["triangles"] = view.triangle_count;
    for (const FlgSkinView& level : made.levels) report.counts["level_vertices"].push_back(level.vertex_count);
    const RigQuality rig = measure_rig(view);
    if (options.mesh.empty() && rig.largest_stretch > kStretched) {
        char stretch[32];
        std::snprintf(stretch, sizeof stretch, "%.1f", rig.largest_stretch);
        report.warn(subject + ": where " + view.joint_names[rig.stretch_joint] +
                    " turns by 30 degrees the surface stretches " + stretch +
                    " times: limbs that lie nearer to each other than a triangle are one; --vertices asks for smaller "
                    "ones, --apart keeps parts from each other");
    }
    if (is_reported) {
        report.quality["largest_stretch"] = rig.largest_stretch;
        report.quality["stretched_by"] = view.joint_names[rig.stretch_joint];
        report.quality["largest_weight_jump"] = rig.largest_jump;
    }
    if (const uint32_t pieces = count_pieces(view); options.mesh.empty() && pieces > drawing.parts.size())
        report.warn(subject + ": the surface is in " + std::to_string(pieces) +
                    " pieces: what is thinner than its triangles falls apart; --vertices asks for smaller ones");
    const RiggedSkin rigged(options.rig, view, bones, drawing, subject);
    std::vector<FlgSkinAnimation> animations = rigged.animations();
    std::optional<PulledSkin> pulled;
    if (options.script) pulled.emplace(session, *options.script, rigged.skin(), animations, report);
    if (!options.pulled.empty()) write_pulled(options, rigged.skin(), made.looks, *pulled);
    if (options.output.empty()) return;
    RigOptions at_rest = options.rig;
    at_rest.motions.clear();
    std::deque<RiggedSkin> rigged_levels;
    std::vector<FlgSkinView> level_views;
    for (const FlgSkinView& level : made.levels)
        level_views.push_back(rigged_levels.emplace_back(at_rest, level, bones, drawing, subject).skin());
    FlgVrm vrm = flgVrmDefaults();
    std::vector<const char*> authors;
    for (const std::string& author : options.rig.authors) authors.push_back(author.c_str());
    vrm.authors = authors.data();
    vrm.author_count = static_cast<uint32_t>(authors.size());
    vrm.bones = rigged.bones().data();
    FlgSkinFileWriteDesc file = {};
    flgSkinFileWriteDescInit(&file, sizeof file);
    made.looks.describe(file);
    std::vector<FlgMorphTarget> targets, level_targets;
    FlgMorphAnimation shapes;
    if (pulled) {
        targets = pulled->targets();
        shapes = pulled->animation(static_cast<uint32_t>(animations.size()));
        if (pulled->bones()) animations.push_back(*pulled->bones());
        file.morphs = targets.data();
        file.morph_count = static_cast<uint32_t>(targets.size());
        level_targets = pulled->targets_of(level_views);
        if (!level_targets.empty()) file.level_morphs = level_targets.data();
        file.morph_animations = &shapes;
        file.morph_animation_count = 1;
    }
    file.skin = &rigged.skin();
    file.animations = animations.data();
    file.animation_count = static_cast<uint32_t>(animations.size());
    file.rig = rigged.rig();
    if (!authors.empty()) file.vrm = &vrm;
    file.levels = level_views.data();
    file.level_count = static_cast<uint32_t>(level_views.size());
    if (flgSkinFileWrite(options.output.c_str(), &file) != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

void write_bones(const Options& options, const std::string& subject, const ModelDrawing& drawing,
                 const FlgModelView& view, Report& report) {
    report.counts["parts"] = view.part_count;
    report.counts["joints"] = view.joint_count;
    std::string loose;
    for (uint32_t p = 1; p < view.part_count; ++p)
        if (view.part_parents[p] == FLG_NO_INDEX && p != view.joint_parts[0])
            loose += (loose.empty() ? "" : ", ") + drawing.parts[view.part_sources[p]].name;
    if (!loose.empty())
        report.warn(subject + ": hang on nothing: " + loose +
                    "; a `parent` in the drawing hangs them where they belong");
    if (options.bones.empty()) return;
    std::optional<ModelRig> rig;
    if (view.joint_count <= FLG_RIG_MAX_JOINTS) rig.emplace(view.joint_positions, view, left_of(drawing), subject);
    write_text_file(options.bones, bones_json(view, drawing, rig ? &rig->rig() : nullptr).dump(1) + "\n");
}

// An edit waits for its joint while somebody draws; in a file that is read once it is one of no joint.
void warn_of_vain_edits(const ModelDrawing& drawing, const FlgModelView& view, const std::string& subject,
                        Report& report) {
    for (const JointEdit& edit : drawing.joint_edits) {
        // What is merged away, and what takes its place, has no key of its own in the end.
        if (edit.kind == FLG_JOINT_EDIT_KIND_MERGE || edit.kind == FLG_JOINT_EDIT_KIND_SPLIT) continue;
        const bool is_there = std::any_of(view.joint_keys, view.joint_keys + view.joint_count,
                                          [&](const char* key) { return edit.joint == key; });
        if (is_there) continue;
        const bool was_there = drawing.previous && drawing.previous->has(edit.joint);
        report.warn(was_there ? subject + ": the joint " + edit.joint + " is gone, and what was set about it waits"
                              : subject + ": joints: the model has no joint " + edit.joint + "; its edit waits");
    }
}

FlgModel drawn_model(const Options& options, Session& session, const ModelDrawing& drawing, Report& report) {
    try {
        return make_drawn_model(session, drawing, options.contours[0], report);
    } catch (const InputError& error) {
        const std::string what = error.what();
        if (options.repair || what.find(" cross at ") == std::string::npos) throw;
        throw InputError(what + "; --repair takes the largest piece within");
    }
}

uint32_t where_they_meet(const FlgModelView& view, uint32_t a, uint32_t b) {
    while (a != b && std::max(a, b) != FLG_NO_INDEX) (a > b ? a : b) = view.joint_parents[std::max(a, b)];
    return std::max(a, b);
}

// Standards want the hips to be the root, where the legs meet; the middle of a trunk may be higher up, with a large
// head as high as the chest. Returns whether the drawing was changed; a root that it names stays.
bool begin_at_hips(const FlgModelView& view, const std::string& subject, ModelDrawing& drawing) {
    if (!drawing.root.empty() || !drawing.root_joint.empty() || view.joint_count > FLG_RIG_MAX_JOINTS) return false;
    const ModelRig rig(view.joint_positions, view, left_of(drawing), subject);
    const auto meeting = [&](FlgLimb limb) {
        uint32_t at = FLG_NO_INDEX;
        for (uint32_t j = 0; j < view.joint_count; ++j)
            if (rig.rig().joints[j].limb == limb && rig.rig().joints[j].index == 0)
                at = at == FLG_NO_INDEX ? j : where_they_meet(view, at, j);
        return at;
    };
    const uint32_t hips = meeting(FLG_LIMB_LEG), chest = meeting(FLG_LIMB_ARM);
    if (rig.rig().leg_count != 2 || chest == FLG_NO_INDEX || hips == FLG_NO_INDEX) return false;
    if (where_they_meet(view, hips, chest) == hips) return false;
    drawing.root = drawing.parts[view.part_sources[view.joint_parts[hips]]].name;
    drawing.root_joint = view.joint_keys[hips];
    return true;
}

bool has_all_bones(FlgRigStandard standard, const FlgModelView& view, const ModelDrawing& drawing,
                   const std::string& subject) {
    if (view.joint_count > FLG_RIG_MAX_JOINTS) return false;
    const ModelRig rig(view.joint_positions, view, left_of(drawing), subject);
    std::vector<const char*> names(view.joint_count);
    return flgRigGetNames(&rig.rig(), standard, names.data()) == FLG_OK;
}

// With --rig as standards want it: from the hips and, where --detail says nothing, in as much of it as has all joints.
FlgModel make_model(const Options& options, Session& session, ModelDrawing& drawing, FlgModelView& view,
                    Report& report) {
    const std::string& subject = options.contours[0];
    const auto make = [&] {
        const FlgModel model = drawn_model(options, session, drawing, report);
        check(flgModelGetView(session.context(), model, &view), subject);
        return model;
    };
    const auto make_from_hips = [&] {
        const FlgModel model = make();
        return options.rig.standard && begin_at_hips(view, subject, drawing) ? make() : model;
    };
    const ModelDrawing as_drawn = drawing;
    const FlgModel model = make_from_hips();
    if (!options.rig.standard || options.detail || has_all_bones(*options.rig.standard, view, drawing, subject))
        return model;
    for (const float detail : {1.5f, 2.0f}) {
        drawing = as_drawn;
        drawing.thresholds.detail = detail;
        const FlgModel finer = make_from_hips();
        if (!has_all_bones(*options.rig.standard, view, drawing, subject)) continue;
        report.warn("--rig: has all joints with --detail " + std::string(detail < 2 ? "1.5" : "2"));
        return finer;
    }
    drawing = as_drawn;
    return make_from_hips();
}

void run_skeleton(Options options, const CommonOptions& common) {
    const bool is_vrm = options.rig.standard == FLG_RIG_STANDARD_VRM;
    if (!options.rig.authors.empty() && !is_vrm) throw UsageError("--author: is asked for by --rig vrm alone");
    for (const std::string& author : options.rig.authors)
        if (author.empty()) throw UsageError("--author: must be a name");
    if (options.output.empty() && options.bones.empty() && options.pulled.empty())
        throw UsageError("skeleton needs -o, --bones or --pulled");
    if (options.pull.empty() && !options.pulled.empty()) throw UsageError("--pulled: needs --pull");
    if (options.pulled.empty() && options.pulled_at) throw UsageError("--pulled-at: needs --pulled");
    if (!options.pulled.empty() && !ends_with_one_of(options.pulled, {".ply", ".obj", ".off", ".glb"}))
        throw UsageError("--pulled: " + options.pulled + " must end with .ply, .obj, .off or .glb");
    if (options.mesh.empty() == options.contours.empty())
        throw UsageError("skeleton needs contours, or a mesh by --mesh, and not both");
    if (!options.output.empty() && !ends_with_one_of(options.output, {".glb"}))
        throw UsageError("-o: " + options.output + " must end with .glb");
    for (size_t i = 0; i < options.levels.size(); ++i)
        if (options.levels[i] >= (i == 0 ? options.vertices : options.levels[i - 1]))
            throw UsageError("--lod: " + std::to_string(options.levels[i]) + " is no fewer than the level before has");
    const std::vector<double>& box = options.picture.box;
    if (!box.empty() && !(box[0] < box[2] && box[1] < box[3]))
        throw UsageError("--texture-box: must be LEFT,BOTTOM,RIGHT,TOP");
    require_writable(options.output);
    require_writable(options.bones);
    require_writable(options.pulled);
    require_writable(common.report);
    Report report("skeleton", common);
    Session session(common);
    const bool is_reported = !common.report.empty();
    const bool has_skin = !options.output.empty() || !options.pulled.empty();
    if (!options.pull.empty()) options.script = read_pull_script(options.pull);
    if (!options.mesh.empty()) {
        if (!options.levels.empty() || options.sharp_degrees > 0 || !options.picture.file.empty() ||
            options.asks_vertices || !options.picture.box.empty())
            throw UsageError(
                "--vertices, --lod, --sharp, --texture: are of drawn models; --mesh keeps the mesh as it is");
        if (!options.depths.empty() || !options.apart.empty() || !options.root.empty() || options.repair ||
            !options.previous.empty())
            throw UsageError(
                "--depth, --apart, --root, --repair, --previous: are of drawn models; a mesh has no parts");
        FlgBoneThresholds thresholds;
        flgBoneThresholdsInit(&thresholds, sizeof thresholds);
        set_thresholds(options, thresholds);
        const MeshModel model(session, options.mesh, thresholds, report);
        write_bones(options, options.mesh, model.drawing(), model.bones(), report);
        if (has_skin)
            write_skin(options, options.mesh, model.drawing(), model.bones(), {model.skin(), {}, model.looks()},
                       is_reported, session, report);
    } else {
        const std::string& subject = options.contours[0];
        ModelDrawing drawing = read_drawing(options, session, report);
        if (options.picture.file.empty()) options.picture.file = drawing.texture;
        if (!options.picture.box.empty() && options.picture.file.empty())
            throw UsageError("--texture-box: needs a picture, by --texture or in the drawing");
        if (options.picture.box.empty() && ends_with_one_of(subject, {".svg", ".SVG"}))
            options.picture.box = page_of_svg(subject);
        if (!options.picture.file.empty()) place_picture(options.picture, drawing);
        if (!options.previous.empty()) {
            const nlohmann::json bones = JsonPlace::read(options.previous);
            drawing.previous =
                std::make_shared<KeptJoints>(JsonPlace(bones, options.previous + ": bones").at("joints"));
        }
        FlgModelView view = flgModelViewDefaults();
        const FlgModel model = make_model(options, session, drawing, view, report);
        warn_of_vain_edits(drawing, view, subject, report);
        write_bones(options, subject, drawing, view, report);
        if (has_skin) {
            const Made made =
                make_drawn_skin(options, session, model, looks_of(options.picture, drawing, view), report);
            write_skin(options, subject, drawing, view, made, is_reported, session, report);
        }
    }
    report.write();
}

}  // namespace

Command add_skeleton(CLI::App& program, const CommonOptions& common) {
    auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("skeleton", "Turns drawn outlines into a model with bones");
    command->add_option(
        "CONTOUR", options->contours,
        "Contours, a part each in the order they were drawn: .poly.txt, SketchPolyline*.txt; .svg, a "
        "part for each outline that is no hole of another; meshes, taken by their silhouettes; or one drawing (.json)");
    command
        ->add_option("--mesh", options->mesh,
                     "Instead of contours a mesh: it gets bones and weights, and keeps its vertices, triangles, "
                     "normals, colours, texture coordinates, materials and base colour textures. Warnings name what "
                     "is not kept")
        ->type_name("MESH");
    command->add_option("-o,--output", options->output, "The model: surface, joints, weights and a test animation")
        ->type_name("MODEL.glb");
    command->add_option("--vertices", options->vertices, "Vertex count of the surface, within 2 %")
        ->check(CLI::Range(100u, 200000u))
        ->capture_default_str();
    command
        ->add_option("--lod", options->levels,
                     "Levels of detail after it, by their vertex counts: meshes of the same bones in the file, linked "
                     "by MSFT_lod")
        ->delimiter(',')
        ->check(CLI::Range(4u, 200000u))
        ->expected(1, 16)
        ->type_name("N,...");
    command
        ->add_flag("--sharp{40}", options->sharp_degrees,
                   "Corners of outlines that turn by more than 40 degrees, or --sharp=DEGREES, stay corners")
        ->check(CLI::Range(1.0, 180.0));
    command
        ->add_option(
            "--texture", options->picture.file,
            "The picture that was drawn over, PNG or JPEG: it colours front and back, in place of colours of "
            "parts. It fills the page of an SVG, else the box of all outlines, as parts are placed but lying flat")
        ->type_name("PICTURE");
    command->add_option("--texture-box", options->picture.box, "Where the picture lies instead, in the drawing's units")
        ->delimiter(',')
        ->expected(4)
        ->type_name("LEFT,BOTTOM,RIGHT,TOP");
    command->add_flag("--repair", options->repair, "Contours may cross themselves: the largest piece within is taken");
    command
        ->add_option("--from", options->from, "From where meshes are looked at, for their silhouettes; default 0,0,1")
        ->delimiter(',')
        ->type_name("X,Y,Z");
    command->add_option("--bones", options->bones, "The joints, and how parts hang together")->type_name("BONES.json");
    command
        ->add_option("--previous", options->previous,
                     "The joints of an earlier run, as --bones wrote them: joints of parts of the same name that are "
                     "still there keep their names")
        ->type_name("BONES.json");
    const auto threshold = [&](const char* name, std::optional<float>& value, const char* text) {
        command->add_option(name, value, text)->check(CLI::Range(0.0f, 10.0f));
    };
    threshold("--simplify", options->simplify,
              "Joints keep axis and shape to within this; share of the size, default 0.01");
    threshold("--merge", options->merge, "Junctions nearer to each other become one; default 0.03");
    threshold("--prune", options->prune, "Branches to an end that are shorter are removed; default 0.03");
    threshold("--collapse", options->collapse, "Inner bones that are shorter vanish; default 0.01");
    command
        ->add_option("--detail", options->detail,
                     "Joints in all limbs: 2 is finer, 0.5 coarser; 0: only the four above count. Default 1")
        ->check(CLI::Range(0.05f, 20.0f) | CLI::IsMember({"0"}));
    command->add_option("--root", options->root, "The part that the hierarchy begins with; default: the largest")
        ->type_name("PART");
    command
        ->add_option_function<std::string>(
            "--rig", [options](const std::string& name) { options->rig.standard = standards.at(name); },
            "Joints get the names of a standard's humanoid; fails where the model is none")
        ->check(CLI::IsMember(standards).description(""))
        ->type_name("vrm|unity|unreal");
    command->add_option("--author", options->rig.authors,
                        "With --rig vrm: makes the file a VRM 1.0 avatar of this author; may be repeated");
    command->add_flag("--t-pose", options->rig.t_pose, "At rest the arms are level, the palms down");
    command
        ->add_option_function<std::vector<std::string>>(
            "--motion",
            [options](const std::vector<std::string>& names) {
                options->rig.motions.clear();
                for (const std::string& name : names) options->rig.motions.push_back(motions.at(name));
            },
            "Test animations of the model; swing turns every joint. Default swing")
        ->delimiter(',')
        ->check(CLI::IsMember(motions).description(""))
        ->type_name("walk|idle|wave|swing,...");
    command
        ->add_option("--depth", options->depths,
                     "Where parts cross, the one of greater depth passes in front, of equal depth the one drawn later; "
                     "default 0. Once a part")
        ->type_name("PART,NUMBER")
        ->allow_extra_args(false);
    command->add_option("--apart", options->apart, "Two parts that are not welded where they touch. Once a pair")
        ->type_name("PART,PART")
        ->allow_extra_args(false);
    command
        ->add_option("--pull", options->pull,
                     "Pulls the surface at points over time, as rigidly as possible: keys of handles, and pins. "
                     "Becomes morph targets with an animation of their weights")
        ->type_name("SCRIPT.json");
    command->add_option("--pulled", options->pulled, "The pulled surface by itself, as it is at")->type_name("MESH");
    command->add_option("--pulled-at", options->pulled_at, "seconds; default: the script's end")->type_name("T");
    return {command, [options, &common, command] {
                options->asks_vertices = command->count("--vertices") > 0;
                run_skeleton(*options, common);
            }};
}

}  // namespace flg::cli
