// SPDX-License-Identifier: MIT
#include "splines/files.h"

#include <algorithm>
#include <filesystem>

#include "documents/failure.h"
#include "documents/json_place.h"
#include "documents/motion_file.h"
#include "filigree/filigree_io.h"
#include "splines/bodies.h"
#include "support/curve_source.h"

namespace flg::studio::splines {
namespace {

using cli::JsonPlace;

constexpr float kFar = 1e6f;

// ---- Obstacles

// Two numbers are a place of the plane, which lies flat.
glm::dvec3 place(const JsonPlace& list, bool* flat) {
    const std::vector<JsonPlace> items = list.items();
    if (items.size() != 2 && items.size() != 3) list.fail("must be 2 or 3 numbers");
    glm::dvec3 at(0.0);
    for (size_t c = 0; c < items.size(); ++c) at[static_cast<glm::length_t>(c)] = items[c].real(-kFar, kFar);
    if (items.size() == 3) return at;
    *flat = true;
    return to_world(at);
}

Obstacle read_obstacle(const JsonPlace& item, bool* flat) {
    Obstacle out;
    out.half = glm::dvec3(1.0);
    out.radius = 1.0;
    if (const auto ball = item.find("ball")) {
        out.kind = FLG_OBSTACLE_KIND_BALL;
        out.centre = out.to = place(ball->at("centre"), flat);
        out.radius = ball->at("radius").real(1e-9, kFar);
    } else if (const auto box = item.find("box")) {
        if (box->find("axes")) box->fail("is turned: here boxes stand straight");
        out.kind = FLG_OBSTACLE_KIND_BOX;
        out.centre = out.to = place(box->at("centre"), flat);
        out.half = glm::abs(place(box->at("half"), flat));
        if (*flat) out.half.y = 0.1;
    } else if (const auto capsule = item.find("capsule")) {
        out.kind = FLG_OBSTACLE_KIND_CAPSULE;
        out.centre = place(capsule->at("from"), flat);
        out.to = place(capsule->at("to"), flat);
        out.radius = capsule->at("radius").real(1e-9, kFar);
    } else {
        item.fail("must be a ball, a box or a capsule");
    }
    return out;
}

void read_obstacles(SplineEditor& editor, const JsonPlace& root) {
    std::vector<Obstacle> read;
    bool flat = false;
    for (const JsonPlace& item : root.at("obstacles").items()) read.push_back(read_obstacle(item, &flat));
    if (read.size() + editor.document.obstacles.size() > kMaxObstacles)
        root.fail("has more obstacles than there may be, " + std::to_string(kMaxObstacles));
    for (Obstacle& obstacle : read) {
        obstacle.id = ++editor.document.last_id;
        obstacle.name = next_name("Obstacle", static_cast<uint32_t>(editor.document.obstacles.size()) + 1);
        editor.obstacle = obstacle.id;
        editor.document.obstacles.push_back(std::move(obstacle));
    }
    if (flat) editor.ground = {"plane", 0};
    editor.tool = Tool::obstacles;
}

// ---- Keys

void read_keys(SplineEditor& editor, const std::string& path) {
    const cli::MotionFile file = cli::read_motion_file(path);
    Motion motion;
    for (size_t i = 0; i < file.times.size(); ++i) {
        const double* const m = file.poses.data() + 12 * i;
        const glm::dmat3 turn(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);
        motion.keys.push_back({file.times[i], {m[3], m[7], m[11]}, glm::normalize(glm::quat_cast(turn))});
        if (i > 0 && !(file.times[i] > file.times[i - 1]))
            throw StudioError(path + ": the times of its keys do not increase.");
    }
    if (motion.keys.size() < 2) throw StudioError(path + ": has fewer than two keys.");
    double reach = 0.0;
    for (size_t i = 0; i < file.body_points.size(); ++i) reach = std::max(reach, std::abs(file.body_points[i]));
    for (const double side : file.desc.body_box) reach = std::max(reach, file.body_points.empty() ? 0.5 * side : 0.0);
    motion.body = 1;
    motion.size = std::clamp(2.0 * reach, 1e-3, 1e3);
    motion.closed = file.desc.closed != 0;
    motion.energy = file.desc.energy;
    motion.tension = std::clamp(file.desc.tension, 1e-6, 1e12);
    motion.id = ++editor.document.last_id;
    motion.ground = {"space", 0};
    motion.name = std::filesystem::path(path).stem().string();
    editor.motion = motion.id;
    editor.key = -1;
    editor.tool = Tool::motions;
    editor.document.motions.push_back(std::move(motion));
}

// ---- Curves out

// All that is shown, in one set.
struct Gathered {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec4> colors;
    std::vector<float> radii;
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> flags;

    void add(const FlgCurveSetView& view, const CurveLook& look) {
        const FlgColumn& column = *samples::find_column(view, FLG_ATTRIBUTE_POSITION);
        for (uint32_t c = 0; c < view.curve_count; ++c) {
            for (uint32_t i = view.curve_offsets[c]; i < view.curve_offsets[c + 1]; ++i) {
                const float* const p = samples::value_at(column, i);
                positions.emplace_back(p[0], p[1], p[2]);
                colors.emplace_back(look.color, 1.0f);
                radii.push_back(look.radius);
            }
            offsets.push_back(static_cast<uint32_t>(positions.size()));
            flags.push_back(view.curve_flags != nullptr ? view.curve_flags[c] : uint8_t{0});
        }
    }
};

}  // namespace

bool read_file(SplineEditor& editor, const std::string& path) {
    if (std::filesystem::path(path).extension() != ".json") return false;
    nlohmann::json json;
    try {
        json = JsonPlace::read(path);
    } catch (const cli::InputError&) {
        return false;  // no JSON: nobody's
    }
    if (!json.is_object() || (!json.contains("keys") && !json.contains("obstacles"))) return false;
    try {
        if (json.contains("keys"))
            read_keys(editor, path);
        else
            read_obstacles(editor, JsonPlace(json, path));
    } catch (const cli::InputError& error) {
        throw StudioError(error.what());
    }
    return true;
}

void write_curves(const SplineEditor& editor, const std::string& path) {
    Gathered all;
    for (const Curve& curve : editor.document.curves) {
        const LiveCurve* const live = editor.live_curve(curve.id);
        if (!curve.visible || live == nullptr || live->found().nodes.empty()) continue;
        if (!editor.surfaces.is_seen(curve.ground)) continue;
        const render::Placement placement = editor.surfaces.placement(curve.ground);
        CurveLook look = curve.look;
        look.radius *= placement.scale;
        live->with_view(curve, placement, [&](const FlgCurveSetView& view) { all.add(view, look); });
    }
    if (all.positions.empty()) throw StudioError("There are no curves to export. Click two points first.");
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &all.positions[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_COLOR, 4, &all.colors[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_RADIUS, 1, all.radii.data(), 0, 0}};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(all.flags.size());
    view.curve_offsets = all.offsets.data();
    view.curve_flags = all.flags.data();
    view.columns = columns;
    view.column_count = 3;
    FlgCurveFileWriteDesc desc = {};
    flgCurveFileWriteDescInit(&desc, sizeof desc);
    desc.geometry = FLG_CURVE_GEOMETRY_TUBE;
    if (flgCurveFileWrite(path.c_str(), &view, &desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
}

void write_motion(const SplineEditor& editor, const std::string& path) {
    const Motion* const motion = editor.chosen_motion();
    const LiveMotion* const live = motion != nullptr ? editor.live_motion(motion->id) : nullptr;
    if (live == nullptr || live->found().poses.empty())
        throw StudioError("There is no motion to export. Add two keys first.");
    const FoundMotion& found = live->found();
    samples::Copies body;
    body.add(unit_body(motion->body), rows_of(Pose{}, motion->size).data(), {}, 0.0f);
    const FlgMeshView mesh = body.view();
    // Players begin at 0.
    std::vector<double> times;
    for (const double time : found.times) times.push_back(time - found.begin());
    FlgMotionFileWriteDesc desc = {};
    flgMotionFileWriteDescInit(&desc, sizeof desc);
    desc.position_count = static_cast<uint32_t>(found.poses.size());
    desc.times = times.data();
    desc.poses = found.rows.data();
    desc.end_time = found.closed ? times.back() : 0.0;
    desc.mesh = &mesh;
    desc.name = motion->name.c_str();
    if (flgMotionFileWrite(path.c_str(), &desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
}

}  // namespace flg::studio::splines
