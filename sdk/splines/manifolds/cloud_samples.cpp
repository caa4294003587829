// SPDX-License-Identifier: MIT
#include "splines/manifolds/cloud_samples.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/failure.h"
#include "splines/manifolds/quadric_fit.h"
#include "splines/manifolds/smoothed_samples.h"
#include "surfaces/mesh/spatial_order.h"

namespace flg {

namespace {

constexpr uint32_t min_neighbours = 6, max_neighbours = 32;
// How far apart k + 1 points are that fill a disc evenly, as a share of its radius times the root of k + 1.
constexpr double even_spacing = 1.9046;
// A sample reaches no farther than this times what its neighbours reach: what lies alone does not cover the others.
constexpr double max_reach = 1.5;
// Points that may be looked at for neighbours: where so many lie in one place, the nearest ones elsewhere don't matter.
constexpr uint32_t max_visited = 4096;
// A plane is there if the neighbours' second width is this share of the first.
constexpr double min_width = 1e-6;
// Bends are held below this over the distance of points.
constexpr double max_bent = 0.7;
constexpr uint32_t measured_points = 2048;

double dot(const Position& a, const Position& b) {
    return double{a[0]} * b[0] + double{a[1]} * b[1] + double{a[2]} * b[2];
}

// The points in the order of their tree, with what is found of each.
struct Cloud {
    Cloud(std::span<const Position> points, std::span<const Position> point_normals, uint32_t neighbours,
          Memory* memory)
        : given(points),
          given_normals(point_normals),
          count(static_cast<uint32_t>(points.size())),
          per_point(std::min(std::clamp(neighbours, min_neighbours, max_neighbours), count - 1)),
          places(count, memory),
          normals(count, memory),
          near(size_t{count} * per_point, memory),
          reaches(count, memory) {}

    // The nearest points that lie elsewhere; and the direction across which they are narrowest.
    void find_neighbours(uint32_t at) {
        const Vec3 place = load_vec3(places[at].data());
        double squares[max_neighbours], limit = std::numeric_limits<double>::infinity();
        uint32_t found[max_neighbours], found_count = 0, visited = 0;
        // Those beside it in the order are near, and the k-th neighbour is no farther than the farthest of k of them.
        const uint32_t begin = std::min(at - std::min(at, per_point / 2), count - 1 - per_point);
        double farthest = 0, closest = limit;
        for (uint32_t i = begin; i <= begin + per_point; ++i) {
            const double square = (load_vec3(places[i].data()) - place).squaredNorm();
            farthest = std::max(farthest, square);
            if (i != at) closest = std::min(closest, square);
        }
        if (closest > 0) limit = std::nextafter(farthest, limit);
        tree.nearest(place.data(), limit, [&](uint32_t first, uint32_t end) {
            for (uint32_t i = first; i < end; ++i) {
                const double square = (load_vec3(places[i].data()) - place).squaredNorm();
                if (!(square > 0) || !(square < limit)) continue;
                uint32_t slot = found_count < per_point ? found_count++ : per_point - 1;
                for (; slot > 0 && squares[slot - 1] > square; --slot) {
                    squares[slot] = squares[slot - 1];
                    found[slot] = found[slot - 1];
                }
                squares[slot] = square;
                found[slot] = i;
                if (found_count == per_point) limit = squares[per_point - 1];
            }
            visited += end - first;
            if (visited > max_visited) limit = 0;
        });
        std::fill_n(&near[size_t{at} * per_point], per_point, no_index);
        std::copy_n(found, found_count, &near[size_t{at} * per_point]);
        reaches[at] = found_count > 0 ? std::sqrt(squares[found_count - 1]) : 0;
        if (!given_normals.empty() || found_count < 2) return;

        Vec3 mean = place;
        for (uint32_t i = 0; i < found_count; ++i) mean += load_vec3(places[found[i]].data());
        mean /= found_count + 1;
        Eigen::Matrix3d spread = (place - mean) * (place - mean).transpose();
        for (uint32_t i = 0; i < found_count; ++i) {
            const Vec3 d = load_vec3(places[found[i]].data()) - mean;
            spread += d * d.transpose();
        }
        spread /= squares[found_count - 1];
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
        solver.computeDirect(spread);
        const Vec3 widths = solver.eigenvalues();
        if (!(widths[1] > min_width * widths[2])) return;
        const Vec3 normal = solver.eigenvectors().col(0);
        store_vec3(normal.normalized(), normals[at].data());
    }

    void fit(uint32_t at, GrowingBuffer<OrientedSample>& samples) const {
        const Vec3 place = load_vec3(places[at].data()), normal = load_vec3(normals[at].data());
        const uint32_t* const own = &near[size_t{at} * per_point];
        double reach = reaches[at];
        if (!(reach > 0) || normal.isZero()) return;
        const double spacing = reach * even_spacing / std::sqrt(per_point + 1.0);
        QuadricFit quadric(place, normal.normalized(), spacing, QuadricKind::near);
        for (uint32_t i = 0; i < per_point && own[i] != no_index; ++i) {
            const Vec3 other = load_vec3(places[own[i]].data()), other_normal = load_vec3(normals[own[i]].data());
            reach = std::min(reach, max_reach * reaches[own[i]]);
            if (normal.dot(other_normal) < 0) continue;  // on the other side of a thin part
            quadric.add_point(other);
            if (!given_normals.empty() && !other_normal.isZero()) quadric.add_normal(other, other_normal.normalized());
        }
        BentNormal bent = quadric.solve();
        if (bent.curvature * spacing > max_bent) {
            for (double& b : bent.bend) b *= max_bent / (bent.curvature * spacing);
        }
        // Not farther than neighbours are: what lies off by more is no noise.
        const Vec3 on = place + std::clamp(bent.height, -spacing, spacing) * normal.normalized();
        const Vec3& n = bent.normal;
        samples.push_back({{on.x(), on.y(), on.z()}, {n.x(), n.y(), n.z()}, bent.bend, reach});
    }

    const std::span<const Position> given, given_normals;
    const uint32_t count;
    const uint32_t per_point;
    Buffer<Position> places, normals;
    PointTree tree;
    Buffer<uint32_t> near;   // per_point of each point, nearest first; no_index where there are fewer
    Buffer<double> reaches;  // metres, to the last of them
};

// The spanning tree that normals are turned along, while it grows.
struct SpanningTree {
    static constexpr uint32_t buckets = 64;  // by angle, from parallel to perpendicular
    struct Node {
        uint32_t next, previous;  // in its bucket's list
        uint32_t from;            // the neighbour to follow
        uint32_t bucket;          // `buckets`: in none; no_index: done
    };

    SpanningTree(const Buffer<Position>& at, Buffer<Position>& turned, Memory* memory)
        : places(at), normals(turned), nodes(at.size(), memory), order(at.size(), memory) {
        heads.fill(no_index);
    }

    void turn_over(uint32_t point) {
        for (float& n : normals[point]) n = -n;
    }

    // The neighbour whose normal turns least. False if there is none left.
    bool take_next() {
        while (lowest < buckets && heads[lowest] == no_index) ++lowest;
        if (lowest == buckets) return false;
        const uint32_t point = heads[lowest];
        unlink(point);
        if (dot(normals[point], normals[nodes[point].from]) < 0) {
            turn_over(point);
        }
        visit(point);
        return true;
    }

    void visit(uint32_t point) {
        if (visited == first || places[point][2] > places[top][2]) top = point;
        nodes[point].bucket = no_index;
        order[visited++] = point;
        current = point;
    }

    void relax(uint32_t point) {
        if (point == no_index) return;
        Node& node = nodes[point];
        if (node.bucket == no_index) return;
        const double cosine = std::min(1.0, std::abs(dot(normals[point], normals[current])));
        const auto bucket = std::min(buckets - 1, static_cast<uint32_t>(buckets * std::sqrt(1 - cosine)));
        if (bucket >= node.bucket) return;
        if (node.bucket < buckets) unlink(point);
        node = {heads[bucket], no_index, current, bucket};
        if (node.next != no_index) nodes[node.next].previous = point;
        heads[bucket] = point;
        lowest = std::min(lowest, bucket);
    }

    void unlink(uint32_t point) {
        const Node& node = nodes[point];
        if (node.previous == no_index) {
            heads[node.bucket] = node.next;
        } else {
            nodes[node.previous].next = node.next;
        }
        if (node.next != no_index) nodes[node.next].previous = node.previous;
    }

    const Buffer<Position>& places;
    Buffer<Position>& normals;
    Buffer<Node> nodes;
    Buffer<uint32_t> order;  // points as they were visited
    std::array<uint32_t, buckets> heads;
    uint32_t current = no_index;      // whose neighbours are looked at
    uint32_t visited = 0, first = 0;  // the part began with order[first]
    uint32_t lowest = buckets, top = no_index;
};

// Turns normals, of unit length or 0, to one side of each connected part; returns how many parts there are.
Task<uint32_t> orient(Pace& pace, Cloud& cloud) {
    const uint32_t points = cloud.count, per_point = cloud.per_point;
    SpanningTree tree(cloud.places, cloud.normals, pace.memory());
    co_await each(pace, points, Cost::some_ns, [&](uint32_t i) {
        tree.nodes[i] = {no_index, no_index, no_index, SpanningTree::buckets};
    });
    // Places in `near` by which point is there: whose neighbour it is.
    static_assert(no_index == no_key);
    const uint32_t* const near = cloud.near.data();
    const Groups back = co_await group_by(pace, cloud.near.size(), points, [near](uint32_t i) { return near[i]; });
    uint32_t parts = 0;
    Slice slice(Cost::some_ns);
    for (uint32_t seed = 0; seed < points; ++seed) {
        if (slice.is_over()) co_await pace;
        if (tree.nodes[seed].bucket == no_index) continue;
        tree.first = tree.visited;
        tree.visit(seed);
        co_await repeat(pace, Cost::microseconds, [&] {
            const uint32_t at = tree.current;
            for (uint32_t k = 0; k < per_point; ++k) tree.relax(near[size_t{at} * per_point + k]);
            for (const uint32_t place : back.of(at)) tree.relax(place / per_point);
            return tree.take_next();
        });
        ++parts;
        if (!(cloud.normals[tree.top][2] < 0)) continue;
        co_await each(pace, tree.first, tree.visited, Cost::some_ns,
                      [&](uint32_t i) { tree.turn_over(tree.order[i]); });
    }
    co_return parts;
}

// The points in an order that keeps near ones together.
Task<void> place(Pace& pace, Cloud& cloud) {
    const uint32_t count = cloud.count;
    GrowingBuffer<Position> positions(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { positions[i] = cloud.given[i]; });
    const SpatialOrder order = co_await spatial_order(pace, positions);
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t from = order.vertex_at(i);
        cloud.places[i] = cloud.given[from];
        cloud.normals[i] = {};
        if (cloud.given_normals.empty()) return;
        store_vec3(load_vec3(cloud.given_normals[from].data()).stableNormalized(), cloud.normals[i].data());
    });
}

}  // namespace

Task<SampledSurface> sample_cloud(Pace& pace, std::span<const Position> points, std::span<const Position> normals,
                                  CloudOptions options) {
    const auto count = static_cast<uint32_t>(points.size());
    if (count < 4) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a surface needs 4 points, and there are %u", count);
    Cloud cloud(points, normals, options.neighbours, pace.memory());
    co_await place(pace, cloud);
    const Position* const places = cloud.places.data();
    const auto ball = [places](uint32_t i, double* centre, double& radius) {
        for (size_t k = 0; k < 3; ++k) centre[k] = places[i][k];
        radius = 0;
    };
    cloud.tree = co_await point_tree(pace, count, ball);
    co_await each(pace, count, Cost::microseconds, [&](uint32_t i) { cloud.find_neighbours(i); });
    uint32_t parts = 0;
    if (normals.empty()) parts = co_await orient(pace, cloud);
    GrowingBuffer<OrientedSample> samples(count, pace.memory());
    samples.resize(0);
    co_await each(pace, count, Cost::microseconds, [&](uint32_t i) { cloud.fit(i, samples); });
    cloud.near = {};
    co_await pace;
    cloud.normals = {};
    co_await pace;
    OrientedSamples surface = co_await oriented_samples(pace, samples);
    if (options.smoothing_scale > 0)
        surface = co_await smoothed_samples(pace, std::move(surface), options.smoothing_scale);
    SampledSurface out{.surface = std::move(surface), .deviation = {}, .parts = parts};
    const uint32_t measured = std::min(count, measured_points);
    co_await each(pace, measured, Cost::microseconds, [&](uint32_t i) {
        out.deviation.add(out.surface, load_vec3(places[uint64_t{i} * count / measured].data()));
    });
    co_return out;
}

}  // namespace flg
