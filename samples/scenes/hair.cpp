// SPDX-License-Identifier: MIT
// Hair: strands from evenly spread places on a scalp mesh, combed from a parting over the sides of the head, under
// gravity, none of them inside the head.
//
// The head is a surface of revolution, an egg that stands on its narrow end, so that the mesh, the collisions and
// the picture's tube are one and the same formula. It looks along +z.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "noise.h"
#include "scene_makers.h"
#include "vector.h"

namespace flg::scenes {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
// Metres.
constexpr double kHalfHeight = 0.125, kHalfWidth = 0.094;
constexpr uint32_t kStrandPoints = 100;

// Radius of the head at a height; 0 above and below it.
double radius_at(double y) {
    const double t = y / kHalfHeight;
    if (std::abs(t) >= 1.0) return 0.0;
    return kHalfWidth * std::sqrt(1.0 - t * t) * (1.0 + 0.16 * t - 0.05 * t * t);
}

Vector on_head(double y, double heading) {
    const double r = radius_at(y);
    return {r * std::sin(heading), y, r * std::cos(heading)};
}

Vector normal_at(double y, double heading) {
    constexpr double kStep = 1e-5;
    const double slope = (radius_at(y + kStep) - radius_at(y - kStep)) / (2.0 * kStep);
    return unit({std::sin(heading), -slope, std::cos(heading)});
}

// Hair begins above this height: low at the nape, high over the face.
double hairline(double heading) {
    const double front = 0.5 + 0.5 * std::cos(heading);
    return kHalfHeight * (-0.35 + 0.93 * smooth_step((front - 0.25) / 0.55));
}

// Which way the comb goes at a place: from the parting to the sides, away from the face, and down, along the head.
Vector comb(const Vector& p) {
    const double side = std::clamp(p.x / 0.012, -1.0, 1.0), above = smooth_step((p.y - 0.03) / 0.07);
    const double before_face = smooth_step((p.z - 0.02) / 0.05) * smooth_step((p.y + 0.03) / 0.05);
    const Vector wanted = {(0.9 * above + 0.9 * before_face) * side, -1.0, -0.45 * above - 0.8 * before_face};
    const double y = std::clamp(p.y, -0.97 * kHalfHeight, 0.97 * kHalfHeight);
    const Vector normal = normal_at(y, std::atan2(p.x, p.z));
    // Over the crown the head carries the hair.
    const double inwards = std::min(dot(wanted, normal), 0.0) * smooth_step((p.y + 0.02) / 0.04);
    return unit(wanted - inwards * normal);
}

// Moves a place out of the head's layer of thickness `layer`.
Vector outside(const Vector& p, double layer) {
    const double heading = std::atan2(p.x, p.z), flat = std::hypot(p.x, p.z);
    const double y = std::clamp(p.y, -0.97 * kHalfHeight, 0.97 * kHalfHeight);
    // Distance to the tangent plane at the same height; exact enough so near to the surface.
    const Vector normal = normal_at(y, heading);
    const double distance = dot(p - on_head(y, heading), normal);
    if (p.y < -0.6 * kHalfHeight && flat > radius_at(y)) return p;
    return distance < layer ? p + (layer - distance) * normal : p;
}

Curve strand(uint32_t index, const Vector& root, const Vector& normal) {
    const Noise hand(5000 + index);
    // Locks: neighbours share their bends.
    const Noise lock(77);
    const double place = 40.0 * root.x + 17.0 * root.z;
    const double length_m = 0.265 * (1.0 + 0.10 * hand(0.5)) * (1.0 + 0.08 * lock(place));
    const double layer = 0.004 + 0.010 * (0.5 + 0.5 * hand(1.5));
    const double step = length_m / (kStrandPoints - 1);
    Curve curve;
    Vector p = root, heading = unit(0.35 * normal + comb(root) + 0.12 * Vector{hand(2.5), 0.0, hand(3.5)});
    for (uint32_t i = 0; i < kStrandPoints; ++i) {
        const double u = static_cast<double>(i) / (kStrandPoints - 1);
        curve.points.push_back(to_point(p));
        curve.radii.push_back(static_cast<float>(0.00075 * (1.0 - 0.75 * u * u)));
        const Vector stray = {0.22 * lock(place + 3.0 * u) + 0.08 * hand(4.0 * u), 0.0,
                              0.22 * lock(place + 3.0 * u + 90.0) + 0.08 * hand(4.0 * u + 60.0)};
        constexpr double kObeys = 0.30;
        heading = unit((1.0 - kObeys) * heading + kObeys * (comb(p) + stray));
        // At the parting the root's own place decides about the side.
        if (std::abs(p.x) < 0.004) heading.x += root.x < 0.0 ? -0.05 : 0.05;
        const Vector next = outside(p + step * heading, layer * smooth_step(u / 0.10));
        heading = unit(next - p);
        p = p + step * heading;
    }
    const auto light = static_cast<float>(0.5 + 0.3 * hand(7.5) + 0.2 * lock(place + 5.0));
    curve.color = {0.11f + 0.22f * light, 0.032f + 0.085f * light, 0.010f + 0.022f * light, 1.0f};
    return curve;
}

Vector between(const std::array<Vector, 3>& corners, double v, double w) {
    return (1.0 - v - w) * corners[0] + v * corners[1] + w * corners[2];
}

}  // namespace

Mesh make_scalp() {
    constexpr uint32_t kRows = 24, kColumns = 48;
    Mesh mesh;
    for (uint32_t row = 0; row < kRows; ++row) {
        for (uint32_t column = 0; column < kColumns; ++column) {
            const double heading = kTau * column / kColumns;
            const double top = 0.999 * kHalfHeight, down = static_cast<double>(row) / (kRows - 1);
            const double y = hairline(heading) + (top - hairline(heading)) * std::sin(0.25 * kTau * (1.0 - down));
            mesh.vertices.push_back(to_point(on_head(y, heading)));
            mesh.normals.push_back(to_point(normal_at(y, heading)));
        }
    }
    for (uint32_t row = 0; row + 1 < kRows; ++row) {
        for (uint32_t column = 0; column < kColumns; ++column) {
            const uint32_t next = (column + 1) % kColumns, a = row * kColumns, b = a + kColumns;
            mesh.triangles.push_back({a + column, b + column, b + next});
            mesh.triangles.push_back({a + column, b + next, a + next});
        }
    }
    return mesh;
}

Curve make_head() {
    constexpr uint32_t kRings = 96;
    Curve head;
    for (uint32_t i = 0; i < kRings; ++i) {
        const double y = -0.9999 * kHalfHeight * std::cos(0.5 * kTau * i / (kRings - 1));
        head.points.push_back(to_point({0.0, y, 0.0}));
        head.radii.push_back(static_cast<float>(radius_at(y)));
    }
    head.color = {0.72f, 0.48f, 0.37f, 1.0f};
    return head;
}

std::vector<Curve> make_hair(uint32_t count) {
    const Mesh scalp = make_scalp();
    std::vector<double> areas;  // summed up
    double area = 0.0;
    const auto corner = [](const std::vector<Point>& values, const std::array<uint32_t, 3>& triangle) {
        return std::array{to_vector(values[triangle[0]]), to_vector(values[triangle[1]]),
                          to_vector(values[triangle[2]])};
    };
    for (const auto& triangle : scalp.triangles) {
        const auto p = corner(scalp.vertices, triangle);
        areas.push_back(area += length(cross(p[1] - p[0], p[2] - p[0])));
    }
    std::vector<Curve> strands;
    strands.reserve(count);
    // Roberts' R3 sequence: evenly spread however many there are.
    constexpr double kPlastic = 1.2207440846057596;
    for (uint32_t i = 0; i < count; ++i) {
        const auto fraction = [i](double power) { return std::fmod(0.5 + (i + 1.0) / power, 1.0); };
        const double pick = fraction(kPlastic) * area;
        const auto found = static_cast<size_t>(std::lower_bound(areas.begin(), areas.end(), pick) - areas.begin());
        const auto& triangle = scalp.triangles[std::min(found, areas.size() - 1)];
        double v = fraction(kPlastic * kPlastic), w = fraction(kPlastic * kPlastic * kPlastic);
        if (v + w > 1.0) v = 1.0 - v, w = 1.0 - w;
        strands.push_back(strand(i, between(corner(scalp.vertices, triangle), v, w),
                                 unit(between(corner(scalp.normals, triangle), v, w))));
    }
    return strands;
}

}  // namespace flg::scenes
