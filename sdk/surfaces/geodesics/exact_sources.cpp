// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/exact_sources.h"

#include <algorithm>
#include <limits>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr double rounding = 1e-12;  // of lengths: places that are nearer to each other are one

// The corners of a triangle in the coordinates of its first edge.
struct Layout {
    explicit Layout(const ExactFace& face)
        : corners{Vec2(0, 0), Vec2(face.lengths[0], 0), Vec2(face.along[0], face.above[0])} {}

    Vec2 operator()(const SurfacePoint& point) const {
        return double{point.u} * corners[1] + double{point.v} * corners[2];
    }
    // A place on the triangle's border that is given by another triangle.
    Vec2 operator()(const Mesh& mesh, uint32_t triangle, const Vec3& place) const {
        const Vec3 origin = mesh.position(mesh.triangles[triangle][0]), to = place - origin;
        const Vec3 edge = (mesh.position(mesh.triangles[triangle][1]) - origin).normalized();
        const double x = to.dot(edge);
        return {x, (to - x * edge).norm()};
    }

    std::array<Vec2, 3> corners;
};

// An edge as it is seen from the triangle across.
struct Seen {
    Seen(const Layout& layout, const ExactFace& face, uint32_t k)
        : start(layout.corners[(k + 1) % 3]), along((layout.corners[k] - start) / face.lengths[k]) {}
    // Of directions or of places relative to the start.
    Vec2 operator()(const Vec2& vector) const { return {along.dot(vector), cross(along, vector)}; }

    Vec2 start, along;
};

// Keeps the part of a window where a + b x >= 0.
void clip(Window& window, double a, double b) {
    if (b > 0)
        window.begin = std::max(window.begin, -a / b);
    else if (b < 0)
        window.end = std::min(window.end, -a / b);
    else if (a < 0)
        window.end = window.begin;
}

// From a corner, in the direction of its first edge's coordinates.
Vec2 direction_to(const Layout& layout, uint32_t k, const Vec2& place) {
    const Vec2 edge = layout.corners[(k + 1) % 3] - layout.corners[k], way = place - layout.corners[k];
    return Vec2(edge.dot(way), cross(edge, way)).normalized();
}

}  // namespace

Vec2 SidedSegment::foot_of(const Vec2& place) const {
    const Vec2 way = to - from;
    const double square = way.squaredNorm();
    return from + (square > 0 ? std::clamp((place - from).dot(way) / square, 0.0, 1.0) : 0) * way;
}

uint32_t SidedSegment::label_of(const Vec2& place) const {
    const Vec2 way = to - from;
    if (begins && (place - from).dot(way) < 0) return beyond_end;
    if (ends && (place - to).dot(way) > 0) return beyond_end;
    return 2 * piece + (cross(way, place - from) >= 0 ? 0 : 1);
}

void ExactSources::add_point(const SurfacePoint& point, uint32_t label) {
    if (!within_.contains(mesh_.regions[point.triangle])) return;
    const ExactFace& face = solver_.faces().faces[point.triangle];
    const Layout layout(face);
    const Vec2 place = layout(point);
    for (uint32_t k = 0; k < 3; ++k) {
        const double distance = (place - layout.corners[k]).norm();
        if (distance <= rounding * face.lengths[k]) return solver_.start_at(face.vertices[k], label);
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const double distance = (place - layout.corners[k]).norm();
        solver_.reach(3 * point.triangle + k, distance, direction_to(layout, k, place), label);
    }
    solver_.allow_sources_inside();
    shine_around(point.triangle, place, Vec2::Zero(), Vec2::Zero(), label);
}

void ExactSources::add_segment(const SurfacePoint& begin, const SurfacePoint& end, uint32_t label) {
    const uint32_t triangle = begin.triangle;
    if (!within_.contains(mesh_.regions[triangle])) return;
    const ExactFace& face = solver_.faces().faces[triangle];
    const Layout layout(face);
    const Vec2 from = layout(begin);
    const Vec2 to = end.triangle == triangle ? layout(end) : layout(mesh_, triangle, position_of(mesh_, end));
    const double length = (to - from).norm();
    if (!(length > 0)) return add_point(begin, label);
    const Vec2 along = (to - from) / length;
    for (uint32_t k = 0; k < 3; ++k) {
        const Vec2& corner = layout.corners[k];
        const Vec2 foot = from + std::clamp((corner - from).dot(along), 0.0, length) * along;
        const double distance = (corner - foot).norm();
        if (distance > rounding * length) {
            solver_.reach(3 * triangle + k, distance, direction_to(layout, k, foot), label);
        } else {
            solver_.start_at(face.vertices[k], label);
        }
    }
    solver_.allow_sources_inside();
    shine_straight(triangle, from, to, label);
    shine_straight(triangle, to, from, label);
    shine_around(triangle, from, -along, Vec2::Zero(), label);
    shine_around(triangle, to, along, Vec2::Zero(), label);
}

SidedSegment ExactSources::add_sided(const SurfacePoint& begin, const SurfacePoint& end, SidedSegment labels) {
    constexpr double inwards = 1e-9;  // of the way to the triangle's middle
    SidedSegment out = labels;
    const uint32_t triangle = out.triangle = begin.triangle;
    const ExactFace& face = solver_.faces().faces[triangle];
    const Layout layout(face);
    const Vec2 middle = (layout.corners[0] + layout.corners[1] + layout.corners[2]) / 3;
    const Vec2 to = end.triangle == triangle ? layout(end) : layout(mesh_, triangle, position_of(mesh_, end));
    out.from = layout(begin) + inwards * (middle - layout(begin));
    out.to = to + inwards * (middle - to);
    for (uint32_t k = 0; k < 3; ++k) {
        const Vec2& corner = layout.corners[k];
        const Vec2 foot = out.foot_of(corner);
        const double distance = (corner - foot).norm();
        const bool is_on = distance <= 2 * inwards * (middle - corner).norm();
        solver_.reach(3 * triangle + k, distance, direction_to(layout, k, foot),
                      is_on ? SidedSegment::no_side : out.label_of(corner));
    }
    solver_.allow_sources_inside();
    const Vec2 way = out.to - out.from;
    const double length = way.norm();
    if (!(length > 0)) return out;
    const Vec2 along = way / length, left(-along.y(), along.x());
    const uint32_t on_left = 2 * out.piece, on_right = on_left + 1;
    shine_straight(triangle, out.from, out.to, on_left);
    shine_straight(triangle, out.to, out.from, on_right);
    shine_around(triangle, out.from, -along, left, out.begins ? SidedSegment::beyond_end : on_left);
    shine_around(triangle, out.from, -along, -left, out.begins ? SidedSegment::beyond_end : on_right);
    shine_around(triangle, out.to, along, left, out.ends ? SidedSegment::beyond_end : on_left);
    shine_around(triangle, out.to, along, -left, out.ends ? SidedSegment::beyond_end : on_right);
    return out;
}

void ExactSources::add_edge(Corner corner, uint32_t label) {
    const Corner across = mesh_.opposite(corner);
    for (const Corner edge : {corner, across}) {
        if (edge == no_index || !within_.contains(mesh_.regions[triangle_of(edge)])) continue;
        const ExactFace& face = solver_.faces().faces[triangle_of(edge)];
        const uint32_t k = edge % 3;
        solver_.start_at(face.vertices[k], label);
        solver_.start_at(face.vertices[(k + 1) % 3], label);
        solver_.allow_sources_inside();
        if (!(face.lengths[k] > 0)) continue;
        solver_.send({.x = 0,
                      .y = 1,
                      .before = 0,
                      .begin = 0,
                      .end = face.lengths[k],
                      .edge = edge,
                      .label = label,
                      .narrow_run = 0});
    }
}

// To the left of a line.
void ExactSources::shine_straight(uint32_t triangle, const Vec2& begin, const Vec2& end, uint32_t label) {
    constexpr double least_slope = 1e-9;  // of rays
    const ExactFace& face = solver_.faces().faces[triangle];
    const Layout layout(face);
    const double length = (end - begin).norm();
    const Vec2 along = (end - begin) / length, ray(-along.y(), along.x());
    for (uint32_t k = 0; k < 3; ++k) {
        if (face.across[k] == no_index || !(face.lengths[k] > 0)) continue;
        const Seen seen(layout, face, k);
        const Vec2 direction = seen(ray), start = seen.start - begin;
        if (!(direction.y() > least_slope)) continue;
        Window window{.x = direction.x(),
                      .y = direction.y(),
                      .before = ray.dot(start),
                      .begin = 0,
                      .end = face.lengths[k],
                      .edge = face.across[k],
                      .label = label,
                      .narrow_run = 0};
        clip(window, ray.dot(start) + rounding * length, direction.x());
        clip(window, along.dot(start), along.dot(seen.along));
        clip(window, length - along.dot(start), -along.dot(seen.along));
        solver_.send(window);
    }
}

// From a place in the triangle, to what lies `beyond` and `beside` it; no direction: all around.
void ExactSources::shine_around(uint32_t triangle, const Vec2& place, const Vec2& beyond, const Vec2& beside,
                                uint32_t label) {
    const ExactFace& face = solver_.faces().faces[triangle];
    const Layout layout(face);
    for (uint32_t k = 0; k < 3; ++k) {
        if (face.across[k] == no_index || !(face.lengths[k] > 0)) continue;
        const Seen seen(layout, face, k);
        const Vec2 source = seen(place - seen.start);
        const bool on_edge = source.y() > -rounding * face.lengths[k];
        Window window{.x = source.x(),
                      .y = on_edge ? 0 : source.y(),
                      .before = 0,
                      .begin = 0,
                      .end = face.lengths[k],
                      .edge = face.across[k],
                      .label = label,
                      .narrow_run = 0};
        if (!on_edge) {
            clip(window, beyond.dot(seen.start - place), beyond.dot(seen.along));
            clip(window, beside.dot(seen.start - place), beside.dot(seen.along));
        }
        solver_.send(window);
    }
}

Task<void> add_curve(Pace& pace, const SurfaceCurves& curves, uint32_t curve, uint32_t label, ExactSources& sources) {
    const uint32_t first = curves.offsets[curve], end = curves.offsets[curve + 1], last = end - 1;
    co_await each(pace, first, curves.closed[curve] ? end : last, Cost::microseconds, [&](uint32_t i) {
        sources.add_segment(curves.points[i], curves.points[i == last ? first : i + 1], label);
    });
}

Task<void> add_border(Pace& pace, const Mesh& mesh, const RegionSet& regions, uint32_t label, ExactSources& sources) {
    co_await each_by_work(pace, mesh.triangle_count(), Cost::some_ns, [&](uint32_t t) {
        uint32_t work = 1;
        if (!regions.contains(mesh.regions[t])) return work;
        for (Corner corner = 3 * t; corner < 3 * t + 3; ++corner) {
            const Corner across = mesh.opposite(corner);
            work += 2;
            if (across != no_index && regions.contains(mesh.regions[triangle_of(across)])) continue;
            sources.add_edge(corner, label);
            work += 50;
        }
        return work;
    });
}

}  // namespace flg
