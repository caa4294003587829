// SPDX-License-Identifier: MIT
// filigree motion: from keyframes to a smooth motion.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "command.h"
#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/mesh_file.h"
#include "documents/motion_file.h"
#include "documents/session.h"
#include "documents/text_file.h"
#include "filigree/filigree_io.h"
#include "spline_obstacles.h"

namespace flg::cli {
namespace {

struct Options {
    std::string keys, output, poses, mesh, obstacles;
    double camera_degrees = 0, near_plane = 0, aspect = 16.0 / 9;
};

constexpr const char* energies[] = {"e2", "e1", "et"};
constexpr const char* endings[] = {"running", "converged", "rounding", "rounds"};

// What shows the motion of a body that has no mesh: a box around its points.
struct Box {
    std::vector<float> positions;
    std::vector<uint32_t> triangles;
    FlgColumn column = {};
    FlgMeshView view = {};

    Box(const double* low, const double* high) {
        static constexpr uint32_t corners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
        for (const auto& side : corners) {
            const uint32_t first = static_cast<uint32_t>(positions.size() / 3);
            for (const uint32_t corner : side) {
                for (uint32_t k = 0; k < 3; ++k)
                    positions.push_back(static_cast<float>((corner >> k & 1) != 0 ? high[k] : low[k]));
            }
            for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) triangles.push_back(first + corner);
        }
        column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
        view.struct_size = sizeof view;
        view.vertex_count = static_cast<uint32_t>(positions.size() / 3);
        view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        view.triangles = triangles.data();
        view.columns = &column;
        view.column_count = 1;
    }
    Box(const Box&) = delete;
    Box& operator=(const Box&) = delete;
};

Box box_of(const MotionFile& file) {
    constexpr double min_share = 0.02;  // of its longest side: flat bodies are seen too
    double low[3], high[3], longest = 0;
    for (size_t k = 0; k < 3; ++k) {
        low[k] = -0.5 * file.desc.body_box[k];
        high[k] = 0.5 * file.desc.body_box[k];
        for (size_t i = k; i < file.body_points.size(); i += 3) {
            low[k] = i == k ? file.body_points[i] : std::min(low[k], file.body_points[i]);
            high[k] = i == k ? file.body_points[i] : std::max(high[k], file.body_points[i]);
        }
        longest = std::max(longest, high[k] - low[k]);
    }
    const double least = 0.5 * min_share * (longest > 0 ? longest : 1);
    for (size_t k = 0; k < 3; ++k) {
        if (high[k] - low[k] >= 2 * least) continue;
        const double middle = 0.5 * (low[k] + high[k]);
        low[k] = middle - least;
        high[k] = middle + least;
    }
    return Box(low, high);
}

// The vertices of the mesh are the body's points where the keys' file names no body.
void use_mesh(const MeshFile& mesh, MotionFile& file) {
    if (file.has_body) return;
    const FlgColumn& column = positions_of(mesh.view());
    const size_t stride = column.stride != 0 ? column.stride : 3 * sizeof(float);
    for (size_t i = 0; i < mesh.view().vertex_count; ++i) {
        const auto* p = reinterpret_cast<const float*>(reinterpret_cast<const char*>(column.data) + i * stride);
        file.body_points.insert(file.body_points.end(), p, p + 3);
    }
}

void write_poses(const std::string& path, const FlgMotionView& view) {
    std::string text;
    for (size_t i = 0; i < view.position_count; ++i) {
        for (size_t c = 0; c < 12; ++c) {
            char number[40];
            std::snprintf(number, sizeof number, c == 0 ? "%.17g" : " %.17g", view.poses[12 * i + c]);
            text += number;
        }
        text += '\n';
    }
    write_text_file(path, text);
}

void write_animation(const Options& options, const MotionFile& file, const MeshFile* mesh, const FlgMotionView& view) {
    FlgMotionFileWriteDesc desc = {};
    flgMotionFileWriteDescInit(&desc, sizeof desc);
    // Players begin at 0.
    std::vector<double> times;
    const size_t count = size_t{view.position_count} + (view.closed != 0 ? 1 : 0);
    for (size_t i = 0; i < count; ++i) times.push_back(view.times[i] - std::min(0.0, view.times[0]));
    desc.position_count = view.position_count;
    desc.times = times.data();
    desc.poses = view.poses;
    desc.end_time = view.closed != 0 ? times.back() : 0;
    desc.camera_fov_rad = static_cast<float>(options.camera_degrees * std::numbers::pi / 180);
    const Box box = box_of(file);
    if (!mesh && desc.camera_fov_rad == 0) desc.mesh = &box.view;
    std::vector<FlgMeshMaterial> materials;
    FlgMeshFileWriteDesc mesh_desc = {};
    flgMeshFileWriteDescInit(&mesh_desc, sizeof mesh_desc);
    if (mesh) {
        materials = mesh->materials();
        mesh_desc.split_regions = 1;
        mesh_desc.material_count = static_cast<uint32_t>(materials.size());
        mesh_desc.materials = materials.data();
        desc.mesh = &mesh->view();
        desc.mesh_desc = &mesh_desc;
    }
    if (flgMotionFileWrite(options.output.c_str(), &desc) != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

void describe(const MotionFile& file, const FlgMotionView& view, Report& report) {
    report.parameters["energy"] = energies[file.desc.energy];
    if (file.desc.energy == FLG_SPLINE_ENERGY_ET) report.parameters["tension"] = file.desc.tension;
    report.parameters["smoothing"] = file.desc.smoothing;
    report.parameters["closed"] = view.closed != 0;
    report.counts["keys"] = view.key_count;
    report.counts["positions"] = view.position_count;
    report.quality["iterations"] = view.rounds;
    report.quality["ending"] = endings[view.ending];
    report.quality["energy"] = view.energy;
    report.quality["barycentre_energy"] = view.barycentre_energy;
    report.quality["rotation_energy"] = view.rotation_energy;
    report.quality["residual"] = view.residual;
    report.quality["greatest_stretch"] = view.greatest_stretch;
    report.quality["body_radius"] = view.radius;
    report.quality["duration"] = view.times[view.position_count - (view.closed != 0 ? 0 : 1)] - view.times[0];
    report.quality["length"] = view.length;
    report.quality["greatest_speed"] = view.greatest_speed;
    report.quality["greatest_acceleration"] = view.greatest_acceleration;
    report.quality["greatest_turn"] = view.greatest_turn;
    report.quality["greatest_bank"] = view.greatest_bank;
    nlohmann::ordered_json times = nlohmann::ordered_json::array();
    for (uint32_t i = 0; i < view.key_count; ++i) times.push_back(view.times[view.key_positions[i]]);
    report.quality["key_times"] = times;
}

// How far a corner of the near plane is from the eye.
double near_radius(const Options& options) {
    const double up = std::tan(0.5 * options.camera_degrees * std::numbers::pi / 180);
    return options.near_plane * std::sqrt(1 + up * up * (1 + options.aspect * options.aspect));
}

void run_motion(const Options& options, const CommonOptions& common) {
    if (options.output.empty() && options.poses.empty()) throw UsageError("motion needs -o or --poses");
    if (!options.output.empty() && !ends_with_one_of(options.output, {".glb"}))
        throw UsageError("-o: " + options.output + " must end with .glb");
    require_writable(options.output);
    require_writable(options.poses);
    require_writable(common.report);
    Report report("motion", common);
    MotionFile file = read_motion_file(options.keys);
    std::optional<MeshFile> mesh;
    if (!options.mesh.empty()) {
        mesh.emplace(options.mesh);
        use_mesh(*mesh, file);
    }
    Session session(common);
    FlgMotionDesc desc = desc_of(file);
    desc.clearance += near_radius(options);
    SplineObstacles obstacles;
    if (!options.obstacles.empty()) {
        obstacles = read_obstacles(session, options.obstacles, 3, report);
        desc.obstacles = obstacles.handle;
        desc.sides = obstacles.sides.data();
        desc.side_count = static_cast<uint32_t>(obstacles.sides.size());
        report.counts["obstacles"] = obstacles.count;
    }
    FlgMotion motion = {};
    FlgJob job = {};
    check(flgMotionCreate(session.context(), &desc, &motion, &job), options.keys);
    session.finish({{{job, options.keys}}}, report);
    FlgMotionView view = flgMotionViewDefaults();
    check(flgMotionGetView(session.context(), motion, &view), options.keys);
    describe(file, view, report);
    if (view.ending == FLG_SPLINE_ENDING_ROUNDS) report.warn(options.keys + ": all rounds were used up");
    if (!options.poses.empty()) write_poses(options.poses, view);
    if (!options.output.empty()) {
        write_animation(options, file, mesh ? &*mesh : nullptr, view);
    }
    report.write();
}

}  // namespace

Command add_motion(CLI::App& program, const CommonOptions& common) {
    auto options = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand("motion", "Makes keyframes a smooth motion of a rigid body or a camera");
    command
        ->add_option("KEYS", options->keys,
                     "Times in seconds and poses, which body, which energy (e1, e2 or et), how many positions")
        ->type_name("KEYS.json")
        ->required();
    command->add_option("-o,--output", options->output, "The motion as an animation of a box around the body, or of")
        ->type_name("ANIM.glb");
    command->add_option("--mesh", options->mesh, "a mesh; it is the body too if KEYS.json names none")
        ->type_name("MESH");
    command
        ->add_option("--camera", options->camera_degrees,
                     "The body is a camera that looks along -z, with this field of view from bottom to top, degrees")
        ->check(CLI::Range(1.0, 179.0));
    command
        ->add_option("--near", options->near_plane,
                     "With --obstacles: the near plane's distance, metres; its corners keep out too")
        ->check(CLI::Range(0.0, 1e6));
    command->add_option("--aspect", options->aspect, "Of the picture, width over height")
        ->check(CLI::Range(0.01, 100.0))
        ->capture_default_str();
    command
        ->add_option(
            "--obstacles", options->obstacles,
            "What the barycentre keeps out of; the body too if their clearance is its radius, which the report tells")
        ->type_name("OBSTACLES.json");
    command->add_option("--poses", options->poses, "One position a line: 3 rows of 4 numbers, rotation and place")
        ->type_name("POSES.txt");
    return {command, [options, &common] { run_motion(*options, common); }};
}

}  // namespace flg::cli
