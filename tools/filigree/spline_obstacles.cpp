// SPDX-License-Identifier: MIT
#include "spline_obstacles.h"

#include <algorithm>
#include <deque>
#include <filesystem>

#include "documents/failure.h"
#include "documents/json_place.h"

namespace flg::cli {
namespace {

constexpr float most = 1e30f;

void read_place(const JsonPlace& place, uint32_t dimension, double* out) {
    const std::vector<JsonPlace> items = place.items();
    if (items.size() != dimension)
        place.fail("has " + std::to_string(items.size()) + " numbers, must have " + std::to_string(dimension));
    for (uint32_t c = 0; c < dimension; ++c) out[c] = items[c].number(-most, most);
}

// What obstacles point to while they are made.
struct Sources {
    Session& session;
    Report& report;
    std::filesystem::path folder;
    std::deque<std::vector<double>> polygons;
    std::deque<MeshSurface> meshes;
};

void read_axes(const JsonPlace& place, uint32_t dimension, FlgObstacle& out) {
    const auto axes = place.find("axes");
    if (!axes) return;
    const std::vector<JsonPlace> rows = axes->items();
    if (rows.size() != dimension) axes->fail("must have as many rows as there are dimensions");
    for (uint32_t r = 0; r < dimension; ++r) read_place(rows[r], dimension, out.axes + size_t{3} * r);
}

void read_polygon(const JsonPlace& place, Sources& sources, FlgObstacle& out) {
    out.kind = FLG_OBSTACLE_KIND_POLYGON;
    std::vector<double>& points = sources.polygons.emplace_back();
    for (const JsonPlace& point : place.items()) {
        double xy[3] = {};
        read_place(point, 2, xy);
        points.insert(points.end(), {xy[0], xy[1]});
    }
    out.points = points.data();
    out.point_count = static_cast<uint32_t>(points.size() / 2);
}

FlgObstacle read_obstacle(const JsonPlace& place, uint32_t dimension, Sources& sources) {
    FlgObstacle out = flgObstacleDefaults();
    place.allow({"ball", "box", "capsule", "half_space", "mesh", "polygon", "prism"});
    if (const auto ball = place.find("ball")) {
        ball->allow({"centre", "radius"});
        out.kind = FLG_OBSTACLE_KIND_BALL;
        read_place(ball->at("centre"), dimension, out.centre);
        out.radius = ball->at("radius").number(0, most);
    } else if (const auto box = place.find("box")) {
        box->allow({"centre", "half", "axes"});
        out.kind = FLG_OBSTACLE_KIND_BOX;
        read_place(box->at("centre"), dimension, out.centre);
        read_place(box->at("half"), dimension, out.half);
        read_axes(*box, dimension, out);
    } else if (const auto capsule = place.find("capsule")) {
        capsule->allow({"from", "to", "radius"});
        out.kind = FLG_OBSTACLE_KIND_CAPSULE;
        read_place(capsule->at("from"), dimension, out.centre);
        read_place(capsule->at("to"), dimension, out.to);
        out.radius = capsule->at("radius").number(0, most);
    } else if (const auto polygon = place.find("polygon")) {
        if (dimension != 2) polygon->fail("is an obstacle of the plane; in space it is the base of a prism");
        read_polygon(*polygon, sources, out);
    } else if (const auto prism = place.find("prism")) {
        if (dimension != 3) prism->fail("is no obstacle of the plane");
        prism->allow({"base", "centre", "half_height", "axes"});
        read_polygon(prism->at("base"), sources, out);
        if (const auto centre = prism->find("centre")) read_place(*centre, dimension, out.centre);
        out.half[2] = prism->at("half_height").number(0, most);
        read_axes(*prism, dimension, out);
    } else if (const auto half_space = place.find("half_space")) {
        half_space->allow({"through", "outwards"});
        out.kind = FLG_OBSTACLE_KIND_HALF_SPACE;
        read_place(half_space->at("through"), dimension, out.centre);
        read_place(half_space->at("outwards"), dimension, out.to);
    } else if (const auto mesh = place.find("mesh")) {
        if (dimension != 3) mesh->fail("is no obstacle of the plane");
        const std::string file = (sources.folder / mesh->text()).string();
        const MeshSurface& read = sources.meshes.emplace_back(sources.session, file, 0.0f, sources.report);
        read.warn_of_repairs(sources.report);
        out.kind = FLG_OBSTACLE_KIND_MESH;
        out.surface = read.handle();
    } else {
        place.fail("must have one of ball, box, capsule, half_space, mesh, polygon, prism");
    }
    return out;
}

}  // namespace

SplineObstacles read_obstacles(Session& session, const std::string& file, uint32_t dimension, Report& report,
                               const FlgObstacle* border) {
    Sources sources{session, report, std::filesystem::path(file).parent_path(), {}, {}};
    std::vector<FlgObstacle> obstacles;
    SplineObstacles out;
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    if (!file.empty()) {
        const nlohmann::json json = JsonPlace::read(file);
        const JsonPlace root(json, file);
        root.allow({"clearance", "obstacles", "sides"});
        for (const JsonPlace& item : root.at("obstacles").items())
            obstacles.push_back(read_obstacle(item, dimension, sources));
        if (const auto sides = root.find("sides")) {
            for (const JsonPlace& item : sides->items()) {
                item.allow({"obstacle", "direction"});
                FlgObstacleSide side = {};
                if (obstacles.empty()) item.fail("there are no obstacles");
                side.obstacle = item.at("obstacle").count(0, static_cast<uint32_t>(obstacles.size()) - 1);
                read_place(item.at("direction"), dimension, side.direction);
                out.sides.push_back(side);
            }
        }
        if (const auto clearance = root.find("clearance")) desc.clearance = clearance->number(0, most);
    }
    const std::string name = file.empty() ? "the mesh's borders" : file;
    out.count = static_cast<uint32_t>(obstacles.size());
    if (border) obstacles.push_back(*border);
    desc.dimension = dimension;
    desc.obstacles = obstacles.data();
    desc.obstacle_count = static_cast<uint32_t>(obstacles.size());
    FlgJob job = {};
    check(flgObstaclesCreate(session.context(), &desc, &out.handle, &job), name);
    session.finish({{{job, name}}}, report);
    return out;
}

FlgObstacle border_of(const SplineManifold& manifold, double thickness) {
    if (!manifold.mesh) throw UsageError("--inside: SURFACE must be a mesh, not " + manifold.name);
    constexpr double cells_in_a_layer = 6;
    FlgObstacle border = flgObstacleDefaults();
    border.kind = thickness > 0 ? FLG_OBSTACLE_KIND_LAYER : FLG_OBSTACLE_KIND_BORDER;
    border.surface = manifold.mesh->handle();
    if (thickness > 0) {
        border.radius = thickness;
        border.cells =
            static_cast<uint32_t>(std::clamp(cells_in_a_layer * manifold.view.size / thickness, 16.0, 192.0));
    }
    return border;
}

}  // namespace flg::cli
