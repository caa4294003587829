// SPDX-License-Identifier: MIT
#include "splines/handles.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>

namespace flg::studio::splines {
namespace {

constexpr double kSlope = 0.16, kSlack = 0.02;  // of the scene's size
constexpr double kRing = 0.62;                  // of the body's length
// What lies behind a surface is farther from the mouse by this, so that the front is taken first.
constexpr float kBehind = 4.0f;

struct Nearest {
    Handle handle;
    float distance = FLT_MAX;

    void offer(const Handle& other, float away, float reach) {
        if (away <= reach && away < distance) handle = other, distance = away;
    }
};

float away(const Stage& stage, const glm::dvec3& place, glm::vec2 px) {
    const auto at = stage.desk.view.project(place);
    if (!at) return FLT_MAX;
    const float distance = glm::distance(*at, px);
    const bool near = distance < 2.0f * kReach * stage.desk.scale;
    return near && stage.grounds.hidden(place, kSlack * stage.size()) ? distance + kBehind * stage.desk.scale
                                                                      : distance;
}

double clearance(const Obstacle& obstacle, const glm::dvec3& p) {
    if (obstacle.kind == FLG_OBSTACLE_BOX) {
        const glm::dvec3 beyond = glm::abs(p - obstacle.centre) - obstacle.half;
        return glm::length(glm::max(beyond, 0.0)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
    }
    glm::dvec3 middle = obstacle.centre;
    if (obstacle.kind == FLG_OBSTACLE_CAPSULE) {
        const glm::dvec3 axis = obstacle.to - obstacle.centre;
        const double square = glm::dot(axis, axis);
        if (square > 0.0) middle += std::clamp(glm::dot(p - middle, axis) / square, 0.0, 1.0) * axis;
    }
    return glm::distance(p, middle) - obstacle.radius;
}

// How far along a ray a solid begins.
std::optional<double> meet(const Obstacle& obstacle, const Ray& ray) {
    const glm::dvec3 from = ray.origin, along = ray.direction;
    const double end = glm::distance(from, obstacle.centre) + reach_of(obstacle);
    double way = 0.0;
    for (int i = 0; i < 200 && way < end; ++i) {
        const double free = clearance(obstacle, from + way * along);
        if (free < 1e-4 * reach_of(obstacle)) return way;
        way += free;
    }
    return std::nullopt;
}

void offer_curve(const Stage& stage, const Curve& curve, glm::vec2 px, Nearest& nearest) {
    const float scale = stage.desk.scale;
    const bool chosen = curve.id == stage.curve;
    if (chosen) {
        for (size_t i = 0; i < curve.points.size(); ++i)
            nearest.offer({Grip::point, curve.id, static_cast<int>(i)}, away(stage, curve.points[i], px),
                          kReach * scale);
        for (const bool begin : {true, false}) {
            if (const auto tip = slope_tip(stage, curve, begin))
                nearest.offer({begin ? Grip::begin_slope : Grip::end_slope, curve.id, 0}, away(stage, *tip, px),
                              kReach * scale);
        }
    }
    const LiveCurve* const live = stage.live_curve(curve.id);
    if (live == nullptr || nearest.handle.grip != Grip::none) return;
    const FoundCurve& found = live->found();
    const size_t count = found.nodes.size();
    for (size_t i = 0; i + (found.closed ? 0 : 1) < count; ++i) {
        const auto a = stage.desk.view.project(found.nodes[i]),
                   b = stage.desk.view.project(found.nodes[(i + 1) % count]);
        if (!a || !b) continue;
        const float distance = distance_to({*a, *b}, px);
        if (distance > kCurveReach * scale || stage.grounds.hidden(found.nodes[i], kSlack * stage.size())) continue;
        const auto after = std::upper_bound(found.point_nodes.begin(), found.point_nodes.end(), i);
        const int span = static_cast<int>(after - found.point_nodes.begin()) - 1;
        nearest.offer({chosen ? Grip::span : Grip::curve, curve.id, chosen ? span : 0}, distance, kCurveReach * scale);
    }
}

void offer_motion(const Stage& stage, const Motion& motion, glm::vec2 px, Nearest& nearest) {
    const float scale = stage.desk.scale;
    for (size_t i = 0; i < motion.keys.size(); ++i) {
        const auto at = stage.desk.view.project(motion.keys[i].place);
        if (at)
            nearest.offer({Grip::key, motion.id, static_cast<int>(i)}, glm::distance(*at, px), 1.4f * kReach * scale);
    }
    if (nearest.handle.grip != Grip::none || stage.key < 0) return;
    const Key& key = motion.keys[static_cast<size_t>(stage.key)];
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<glm::dvec3> ring = ring_of(motion, key, axis);
        nearest.offer({Grip::ring, motion.id, axis}, distance_to(project(stage.desk.view, ring), px),
                      kCurveReach * scale);
    }
}

// The first solid that is seen under the mouse.
Handle solid_under(const Stage& stage, glm::vec2 px) {
    const Ray ray = stage.desk.view.ray(px);
    Handle found;
    double least = DBL_MAX;
    for (const Obstacle& obstacle : stage.document.obstacles) {
        const auto way = meet(obstacle, ray);
        if (!way || *way >= least) continue;
        if (stage.grounds.hidden(glm::dvec3(ray.origin) + *way * glm::dvec3(ray.direction), 1e-3 * stage.size()))
            continue;
        least = *way;
        found = {Grip::solid, obstacle.id, 0};
    }
    return found;
}

}  // namespace

double slope_length(const Stage& stage) {
    return kSlope * stage.size();
}

std::optional<glm::dvec3> slope_tip(const Stage& stage, const Curve& curve, bool begin) {
    const auto& slope = begin ? curve.begin_slope : curve.end_slope;
    if (!slope || curve.closed || curve.points.size() < 2) return std::nullopt;
    return (begin ? curve.points.front() : curve.points.back()) + slope_length(stage) * *slope;
}

std::vector<glm::dvec3> ring_of(const Motion& motion, const Key& key, int axis) {
    constexpr int kPieces = 64;
    const glm::dmat3 axes = glm::mat3_cast(key.turn);
    const glm::dvec3 u = axes[(axis + 1) % 3], v = axes[(axis + 2) % 3];
    std::vector<glm::dvec3> ring;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPieces;
        ring.push_back(key.place + kRing * motion.size * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return ring;
}

double reach_of(const Obstacle& obstacle) {
    if (obstacle.kind == FLG_OBSTACLE_BOX) return glm::length(obstacle.half);
    return obstacle.radius +
           (obstacle.kind == FLG_OBSTACLE_CAPSULE ? glm::distance(obstacle.centre, obstacle.to) : 0.0);
}

glm::dvec3 size_handle(const Stage& stage, const Obstacle& obstacle) {
    const render::Camera& camera = stage.desk.view.orbit.camera;
    const glm::dvec3 right = glm::normalize(glm::cross(camera.target - camera.eye, camera.up));
    const double far = obstacle.kind == FLG_OBSTACLE_BOX ? reach_of(obstacle) : obstacle.radius;
    return obstacle.centre + far * right;
}

std::vector<glm::vec2> project(const View& view, std::span<const glm::dvec3> places) {
    std::vector<glm::vec2> out;
    for (const glm::dvec3& place : places) {
        if (const auto at = view.project(place)) out.push_back(*at);
    }
    return out;
}

float distance_to(const std::vector<glm::vec2>& chain, glm::vec2 px) {
    float least = FLT_MAX;
    for (size_t i = 1; i < chain.size(); ++i) {
        const glm::vec2 way = chain[i] - chain[i - 1];
        const float square = glm::dot(way, way);
        const float share = square > 0.0f ? std::clamp(glm::dot(px - chain[i - 1], way) / square, 0.0f, 1.0f) : 0.0f;
        least = std::min(least, glm::distance(px, chain[i - 1] + share * way));
    }
    return least;
}

Handle find_handle(const Stage& stage, glm::vec2 px) {
    Nearest nearest;
    const float reach = kReach * stage.desk.scale;
    if (const Obstacle* const obstacle = stage.chosen_obstacle(); obstacle && stage.tool == Tool::obstacles) {
        nearest.offer({Grip::solid_size, obstacle->id, 0}, away(stage, size_handle(stage, *obstacle), px), reach);
        if (obstacle->kind == FLG_OBSTACLE_CAPSULE)
            nearest.offer({Grip::solid_end, obstacle->id, 0}, away(stage, obstacle->to, px), reach);
    }
    if (stage.tool == Tool::curves) {
        for (const bool chosen : {true, false}) {
            for (const Curve& curve : stage.document.curves) {
                if (curve.visible && (curve.id == stage.curve) == chosen && nearest.handle.grip == Grip::none)
                    offer_curve(stage, curve, px, nearest);
            }
        }
    }
    if (stage.tool == Tool::motions) {
        for (const Motion& motion : stage.document.motions) {
            if (motion.visible && motion.id == stage.motion) offer_motion(stage, motion, px, nearest);
        }
    }
    return nearest.handle.grip != Grip::none ? nearest.handle : solid_under(stage, px);
}

}  // namespace flg::studio::splines
