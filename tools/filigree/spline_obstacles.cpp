// SPDX-License-Identifier: MIT
#include "spline_obstacles.h"

#include <algorithm>
#include <deque>

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

FlgObstacle read_obstacle(const JsonPlace& place, uint32_t dimension, std::deque<std::vector<double>>& polygons) {
    FlgObstacle out = flgObstacleDefaults();
    place.allow({"ball", "box", "capsule", "polygon"});
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
        if (const auto axes = box->find("axes")) {
            const std::vector<JsonPlace> rows = axes->items();
            if (rows.size() != dimension) axes->fail("must have as many rows as there are dimensions");
            for (uint32_t r = 0; r < dimension; ++r) read_place(rows[r], dimension, out.axes + size_t{3} * r);
        }
    } else if (const auto capsule = place.find("capsule")) {
        capsule->allow({"from", "to", "radius"});
        out.kind = FLG_OBSTACLE_KIND_CAPSULE;
        read_place(capsule->at("from"), dimension, out.centre);
        read_place(capsule->at("to"), dimension, out.to);
        out.radius = capsule->at("radius").number(0, most);
    } else if (const auto polygon = place.find("polygon")) {
        out.kind = FLG_OBSTACLE_KIND_POLYGON;
        std::vector<double>& points = polygons.emplace_back();
        for (const JsonPlace& point : polygon->items()) {
            double xy[3] = {};
            read_place(point, 2, xy);
            points.insert(points.end(), {xy[0], xy[1]});
        }
        out.points = points.data();
        out.point_count = static_cast<uint32_t>(points.size() / 2);
    } else {
        place.fail("must have one of ball, box, capsule, polygon");
    }
    return out;
}

}  // namespace

SplineObstacles read_obstacles(const Session& session, const std::string& file, uint32_t dimension) {
    const nlohmann::json json = JsonPlace::read(file);
    const JsonPlace root(json, file);
    root.allow({"clearance", "obstacles", "sides"});
    std::vector<FlgObstacle> obstacles;
    std::deque<std::vector<double>> polygons;
    for (const JsonPlace& item : root.at("obstacles").items())
        obstacles.push_back(read_obstacle(item, dimension, polygons));
    SplineObstacles out;
    out.count = static_cast<uint32_t>(obstacles.size());
    if (const auto sides = root.find("sides")) {
        for (const JsonPlace& item : sides->items()) {
            item.allow({"obstacle", "direction"});
            FlgObstacleSide side = {};
            if (out.count == 0) item.fail("there are no obstacles");
            side.obstacle = item.at("obstacle").count(0, out.count - 1);
            read_place(item.at("direction"), dimension, side.direction);
            out.sides.push_back(side);
        }
    }
    FlgObstaclesDesc desc;
    flgObstaclesDescInit(&desc, sizeof desc);
    desc.dimension = dimension;
    desc.obstacles = obstacles.data();
    desc.obstacle_count = out.count;
    if (const auto clearance = root.find("clearance")) desc.clearance = clearance->number(0, most);
    check(flgObstaclesCreate(session.context(), &desc, &out.handle, nullptr), file);
    return out;
}

SplineObstacles keep_inside(Session& session, const SplineManifold& manifold, double thickness, Report& report) {
    if (!manifold.mesh) throw UsageError("--inside: SURFACE must be a mesh, not " + manifold.name);
    constexpr double cells_in_a_layer = 6;
    FlgObstacle layer = flgObstacleDefaults();
    layer.kind = thickness > 0 ? FLG_OBSTACLE_KIND_LAYER : FLG_OBSTACLE_KIND_BORDER;
    layer.surface = manifold.mesh->handle();
    if (thickness > 0) {
        layer.radius = thickness;
        layer.cells = static_cast<uint32_t>(std::clamp(cells_in_a_layer * manifold.view.size / thickness, 16.0, 192.0));
    }
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.obstacles = &layer;
    desc.obstacle_count = 1;
    SplineObstacles out;
    out.count = 1;
    FlgJob job = {};
    check(flgObstaclesCreate(session.context(), &desc, &out.handle, &job), manifold.name + ": its borders");
    session.finish({{{job, manifold.name + ": its borders"}}}, report);
    return out;
}

}  // namespace flg::cli
