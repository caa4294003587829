// SPDX-License-Identifier: MIT
#include "splines/obstacles/triangle_solid.h"

#include <algorithm>
#include <cmath>

#include "surfaces/mesh/spatial_order.h"

namespace flg {

namespace {

constexpr double below_share = 1e-9;  // of the reach: a triangle that is so much above a plane is below it
constexpr uint32_t most_looks = 100;  // at eight triangles each, for a plane

}  // namespace

TriangleSolid::Nearest TriangleSolid::nearest(const double* x, double below) const {
    Nearest found{below, no_index, {}};
    double square = below * below;
    const Vec3 place(x);
    tree_.nearest(x, square, [&](uint32_t first, uint32_t end) {
        for (uint32_t t = first; t < end; ++t) {
            const TriangleFoot foot = triangle_foot(place, corner(t, 0), corner(t, 1), corner(t, 2));
            const double own = foot.to.squaredNorm();
            if (!(own < square)) continue;
            square = own;
            found = {0, t, foot};
        }
    });
    if (found.triangle != no_index) found.away = std::sqrt(square);
    return found;
}

bool TriangleSolid::holds(const double* x) const {
    const Vec3 place(x);
    uint32_t votes[2] = {};  // out, in
    for (uint32_t axis = 0; votes[0] < 2 && votes[1] < 2; ++axis) {
        const int along = static_cast<int>(axis);
        int turns = 0;
        tree_.along(x, axis, [&](uint32_t first, uint32_t end) {
            for (uint32_t t = first; t < end; ++t) {
                const Vec3 corners[] = {corner(t, 0), corner(t, 1), corner(t, 2)};
                double at = 0;
                const int own = crossing_of_line(corners, place, along, &at);
                if (own != 0 && at > place[along]) turns += own;
            }
        });
        ++votes[turns != 0];
    }
    return votes[1] == 2;
}

bool TriangleSolid::is_met(const double* a, const double* b) const {
    const Vec3 from(a), to(b), way = to - from, middle = 0.5 * (from + to);
    bool met = false;
    tree_.around(middle.data(), 0.5 * way.norm(), [&](uint32_t first, uint32_t end) {
        for (uint32_t t = first; t < end && !met; ++t) {
            const Vec3 corners[] = {corner(t, 0), corner(t, 1), corner(t, 2)};
            met = meets_triangle(from, to, corners, true);
        }
    });
    return met;
}

uint32_t TriangleSolid::part(const double* a, const double* b, double reach, std::span<Obstacle::Parting> out,
                             uint32_t before) const {
    const Vec3 from(a), to(b), low = from.cwiseMin(to), high = from.cwiseMax(to);
    const double slack = below_share * reach;
    uint32_t count = before;
    // Whether a plane has all below it of what is no higher along any direction than `height` says.
    const auto is_below = [&](const auto& height) {
        return std::any_of(out.begin(), out.begin() + count, [&](const Obstacle::Parting& plane) {
            return height(Vec3(plane.outwards.data())) <= plane.height + slack;
        });
    };
    while (count < out.size() && count == before) {
        uint32_t looks = 0;
        double square = reach * reach;
        Vec3 nearest = Vec3::Zero();
        uint32_t found = no_index;
        const auto square_to_box = [&](const PointTree::Box& box) {
            double sum = 0;
            for (uint32_t k = 0; k < 3; ++k) {
                const double away = std::max({box.lower[k] - high[k], low[k] - box.upper[k], 0.0});
                sum += away * away;
            }
            if (!(sum < square)) return sum;
            if (looks >= most_looks) return HUGE_VAL;
            const auto height = [&](const Vec3& u) {
                double most = 0;
                for (uint32_t k = 0; k < 3; ++k) most += std::max(u[k] * box.lower[k], u[k] * box.upper[k]);
                return most;
            };
            return is_below(height) ? HUGE_VAL : sum;
        };
        tree_.nearest_by(square_to_box, square, [&](uint32_t first, uint32_t end) {
            if (looks >= most_looks) return;
            ++looks;
            for (uint32_t t = first; t < end; ++t) {
                const Vec3 corners[] = {corner(t, 0), corner(t, 1), corner(t, 2)};
                const auto height = [&](const Vec3& u) {
                    return std::max({u.dot(corners[0]), u.dot(corners[1]), u.dot(corners[2])});
                };
                if (is_below(height)) continue;
                const Vec3 way = way_from_triangle(corners, from, to);
                const double own = way.squaredNorm();
                if (!(own < square)) continue;
                square = own;
                nearest = way;
                found = t;
            }
        });
        if (found == no_index) break;
        if (!(square > 0)) return Obstacle::no_parting;
        Obstacle::Parting& plane = out[count];
        plane.away = std::sqrt(square);
        const Vec3 outwards = nearest / plane.away;
        std::copy_n(outwards.data(), 3, plane.outwards.begin());
        plane.height =
            std::max({outwards.dot(corner(found, 0)), outwards.dot(corner(found, 1)), outwards.dot(corner(found, 2))});
        ++count;
    }
    return count;
}

Vec3 TriangleSolid::normal(uint32_t triangle) const {
    const Vec3 a = corner(triangle, 0);
    return (corner(triangle, 1) - a).cross(corner(triangle, 2) - a).normalized();
}

Vec3 TriangleSolid::way(uint32_t triangle, uint32_t k) const {
    return (corner(triangle, (k + 1) % 3) - corner(triangle, k)).normalized();
}

Task<TriangleSolid> triangle_solid(Pace& pace, const Mesh& mesh) {
    const uint32_t count = mesh.triangle_count();
    GrowingBuffer<Position> middles(count, pace.memory());
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t t) {
        const Triple& of = mesh.triangles[t];
        store_vec3((mesh.position(of[0]) + mesh.position(of[1]) + mesh.position(of[2])) / 3, middles[t].data());
    });
    const SpatialOrder order = co_await spatial_order(pace, middles);
    TriangleSolid out;
    out.corners_ = Buffer<float>(size_t{9} * count, pace.memory());
    float* const corners = out.corners_.data();
    co_await each(pace, count, Cost::tens_of_ns, [&, corners](uint32_t i) {
        const Triple& of = mesh.triangles[order.vertex_at(i)];
        for (uint32_t k = 0; k < 3; ++k) store_vec3(mesh.position(of[k]), corners + size_t{9} * i + 3 * k);
    });
    const auto ball = [corners](uint32_t i, double* centre, double& radius) {
        const float* const own = corners + size_t{9} * i;
        double square = 0;
        for (size_t c = 0; c < 3; ++c) {
            const auto [low, high] = std::minmax({double{own[c]}, double{own[3 + c]}, double{own[6 + c]}});
            centre[c] = 0.5 * (low + high);
            square += 0.25 * (high - low) * (high - low);
        }
        radius = std::sqrt(square);
    };
    PointTree tree = co_await point_tree(pace, count, ball);
    out.tree_ = std::move(tree);
    co_return out;
}

}  // namespace flg
