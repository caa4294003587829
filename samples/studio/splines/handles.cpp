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

float away(const SplineEditor& editor, const glm::dvec3& place, glm::vec2 px) {
    const auto at = editor.app.view.project(place);
    if (!at) return FLT_MAX;
    const float distance = glm::distance(*at, px);
    const bool near = distance < 2.0f * kReach * editor.app.scale;
    return near && editor.surfaces.hidden(place, kSlack * editor.size()) ? distance + kBehind * editor.app.scale
                                                                         : distance;
}

double clearance(const Obstacle& obstacle, const glm::dvec3& p) {
    if (obstacle.kind == FLG_OBSTACLE_KIND_BOX) {
        const glm::dvec3 beyond = glm::abs(p - obstacle.centre) - obstacle.half;
        return glm::length(glm::max(beyond, 0.0)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
    }
    glm::dvec3 middle = obstacle.centre;
    if (obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE) {
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

void offer_curve(const SplineEditor& editor, const Curve& curve, glm::vec2 px, Nearest& nearest) {
    const float scale = editor.app.scale;
    const bool chosen = curve.id == editor.curve;
    if (chosen) {
        for (size_t i = 0; i < curve.points.size(); ++i)
            nearest.offer({HandleKind::point, curve.id, static_cast<int>(i)},
                          away(editor, editor.surfaces.to_world(curve.ground, curve.points[i]), px), kReach * scale);
        for (const bool begin : {true, false}) {
            if (const auto tip = slope_tip(editor, curve, begin))
                nearest.offer({begin ? HandleKind::begin_slope : HandleKind::end_slope, curve.id, 0},
                              away(editor, *tip, px), kReach * scale);
        }
    }
    const LiveCurve* const live = editor.live_curve(curve.id);
    if (live == nullptr || nearest.handle.kind != HandleKind::none) return;
    const FoundCurve& found = live->found();
    const render::Placement placement = editor.surfaces.placement(curve.ground);
    const size_t count = found.nodes.size();
    for (size_t i = 0; i + (found.closed ? 0 : 1) < count; ++i) {
        const glm::vec3 from = placement.point(found.nodes[i]);
        const auto a = editor.app.view.project(from),
                   b = editor.app.view.project(placement.point(found.nodes[(i + 1) % count]));
        if (!a || !b) continue;
        const float distance = distance_to({*a, *b}, px);
        if (distance > kCurveReach * scale || editor.surfaces.hidden(from, kSlack * editor.size())) continue;
        const auto after = std::upper_bound(found.point_nodes.begin(), found.point_nodes.end(), i);
        const int span = static_cast<int>(after - found.point_nodes.begin()) - 1;
        nearest.offer({chosen ? HandleKind::span : HandleKind::curve, curve.id, chosen ? span : 0}, distance,
                      kCurveReach * scale);
    }
}

void offer_motion(const SplineEditor& editor, const Motion& motion, glm::vec2 px, Nearest& nearest) {
    const float scale = editor.app.scale;
    for (size_t i = 0; i < motion.keys.size(); ++i) {
        const auto at = editor.app.view.project(motion.keys[i].place);
        if (at)
            nearest.offer({HandleKind::key, motion.id, static_cast<int>(i)}, glm::distance(*at, px),
                          1.4f * kReach * scale);
    }
    if (nearest.handle.kind != HandleKind::none || editor.key < 0) return;
    const Key& key = motion.keys[static_cast<size_t>(editor.key)];
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<glm::dvec3> ring = ring_of(motion, key, axis);
        nearest.offer({HandleKind::ring, motion.id, axis}, distance_to(project(editor.app.view, ring), px),
                      kCurveReach * scale);
    }
}

// The first solid that is seen under the mouse.
Handle solid_under(const SplineEditor& editor, glm::vec2 px) {
    const Ray ray = editor.app.view.ray(px);
    Handle found;
    double least = DBL_MAX;
    for (const Obstacle& obstacle : editor.document.obstacles) {
        const auto way = meet(obstacle, ray);
        if (!way || *way >= least) continue;
        if (editor.surfaces.hidden(glm::dvec3(ray.origin) + *way * glm::dvec3(ray.direction), 1e-3 * editor.size()))
            continue;
        least = *way;
        found = {HandleKind::solid, obstacle.id, 0};
    }
    return found;
}

}  // namespace

double slope_length(const SplineEditor& editor) {
    return kSlope * editor.size();
}

std::optional<glm::dvec3> slope_tip(const SplineEditor& editor, const Curve& curve, bool begin) {
    const auto& slope = begin ? curve.begin_slope : curve.end_slope;
    if (!slope || curve.closed || curve.points.size() < 2) return std::nullopt;
    const glm::dvec3 from = editor.surfaces.to_world(curve.ground, begin ? curve.points.front() : curve.points.back());
    return from + slope_length(editor) * (glm::dquat(editor.surfaces.placement(curve.ground).turn) * *slope);
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
    if (obstacle.kind == FLG_OBSTACLE_KIND_BOX) return glm::length(obstacle.half);
    return obstacle.radius +
           (obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE ? glm::distance(obstacle.centre, obstacle.to) : 0.0);
}

glm::dvec3 size_handle(const SplineEditor& editor, const Obstacle& obstacle) {
    const render::Camera& camera = editor.app.view.orbit.camera;
    const glm::dvec3 right = glm::normalize(glm::cross(camera.target - camera.eye, camera.up));
    const double far = obstacle.kind == FLG_OBSTACLE_KIND_BOX ? reach_of(obstacle) : obstacle.radius;
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

Handle find_handle(const SplineEditor& editor, glm::vec2 px) {
    Nearest nearest;
    const float reach = kReach * editor.app.scale;
    if (const Obstacle* const obstacle = editor.chosen_obstacle(); obstacle && editor.tool == Tool::obstacles) {
        nearest.offer({HandleKind::solid_size, obstacle->id, 0}, away(editor, size_handle(editor, *obstacle), px),
                      reach);
        if (obstacle->kind == FLG_OBSTACLE_KIND_CAPSULE)
            nearest.offer({HandleKind::solid_end, obstacle->id, 0}, away(editor, obstacle->to, px), reach);
    }
    if (editor.tool == Tool::curves) {
        for (const bool chosen : {true, false}) {
            for (const Curve& curve : editor.document.curves) {
                if (curve.visible && editor.surfaces.is_seen(curve.ground) && (curve.id == editor.curve) == chosen &&
                    nearest.handle.kind == HandleKind::none)
                    offer_curve(editor, curve, px, nearest);
            }
        }
    }
    if (editor.tool == Tool::motions) {
        for (const Motion& motion : editor.document.motions) {
            if (motion.visible && motion.id == editor.motion) offer_motion(editor, motion, px, nearest);
        }
    }
    return nearest.handle.kind != HandleKind::none ? nearest.handle : solid_under(editor, px);
}

}  // namespace flg::studio::splines
