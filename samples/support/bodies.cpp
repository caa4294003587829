// SPDX-License-Identifier: MIT
#include "support/bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace flg::samples {
namespace {

constexpr glm::vec3 kWood = {0.52f, 0.27f, 0.10f}, kSteel = {0.10f, 0.12f, 0.16f}, kPaint = {0.60f, 0.06f, 0.04f};

// Turned about an axis through `from`: radii at distances along it, closed at both ends. Across the axis it is so much
// narrower along `flat`.
void add_turned(Body& body, glm::dvec3 from, glm::dvec3 axis, std::span<const glm::dvec2> profile, glm::vec3 color,
                double narrower = 1.0, glm::dvec3 flat = {0.0, 0.0, 1.0}) {
    constexpr uint32_t kColumns = 28;
    axis = glm::normalize(axis);
    if (std::abs(glm::dot(axis, flat)) > 0.9) flat = {1.0, 0.0, 0.0};
    const glm::dvec3 side = glm::normalize(glm::cross(flat, axis)), thin = glm::cross(axis, side);
    const auto first = static_cast<uint32_t>(body.positions.size());
    for (const glm::dvec2& p : profile) {
        for (uint32_t i = 0; i < kColumns; ++i) {
            const double a = 2.0 * std::numbers::pi * i / kColumns;
            body.positions.push_back(from + p.y * axis + p.x * std::cos(a) * side +
                                     narrower * p.x * std::sin(a) * thin);
            body.colors.push_back(color);
        }
    }
    for (uint32_t row = 0; row + 1 < profile.size(); ++row) {
        for (uint32_t i = 0; i < kColumns; ++i) {
            const uint32_t a = first + row * kColumns + i, b = first + row * kColumns + (i + 1) % kColumns;
            body.triangles.insert(body.triangles.end(), {a, b, b + kColumns, a, b + kColumns, a + kColumns});
        }
    }
}

// Half a period of a sine's square root: an egg's radii.
std::vector<glm::dvec2> round_profile(double length, double radius) {
    std::vector<glm::dvec2> profile;
    constexpr int kRows = 20;
    for (int i = 0; i <= kRows; ++i) {
        const double a = std::numbers::pi * i / kRows;
        profile.emplace_back(std::max(1e-4, radius * std::sin(a)), 0.5 * length * (1.0 - std::cos(a)));
    }
    return profile;
}

// With straight sides and ends bevelled a little.
std::vector<glm::dvec2> rod_profile(double length, double radius) {
    const double bevel = std::min(0.3 * radius, 0.2 * length);
    return {{1e-4, 0.0},
            {radius - bevel, 0.0},
            {radius - bevel, 0.0},
            {radius, bevel},
            {radius, bevel},
            {radius, length - bevel},
            {radius, length - bevel},
            {radius - bevel, length},
            {radius - bevel, length},
            {1e-4, length}};
}

// A triangle of its own: flat, with an edge around.
void add_flat(Body& body, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::vec3 color) {
    for (const glm::dvec3& p : {a, b, c}) {
        body.triangles.push_back(static_cast<uint32_t>(body.positions.size()));
        body.positions.push_back(p);
        body.colors.push_back(color);
    }
}

Body centred(Body body) {
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& p : body.positions) sum += p;
    for (glm::dvec3& p : body.positions) p -= sum / static_cast<double>(body.positions.size());
    return body;
}

}  // namespace

double Body::radius() const {
    double farthest = 0.0;
    for (const glm::dvec3& p : positions) farthest = std::max(farthest, glm::length(p));
    return farthest;
}

Body oar() {
    Body body;
    const glm::dvec3 x(1.0, 0.0, 0.0);
    add_turned(body, {-1.3, 0.0, 0.0}, x, rod_profile(0.25, 0.055), kSteel);
    add_turned(body, {-1.05, 0.0, 0.0}, x, rod_profile(1.6, 0.038), kWood);
    add_turned(body, {0.35, 0.0, 0.0}, x, round_profile(0.8, 0.17), kPaint, 0.16);
    return centred(body);
}

Body hammer() {
    Body body;
    add_turned(body, {0.0, -0.75, 0.0}, {0.0, 1.0, 0.0}, rod_profile(0.95, 0.045), kWood);
    add_turned(body, {-0.24, 0.22, 0.0}, {1.0, 0.0, 0.0}, rod_profile(0.42, 0.12), kSteel);
    add_turned(body, {0.18, 0.22, 0.0}, {1.0, 0.0, 0.0}, rod_profile(0.10, 0.145), kPaint);
    return centred(body);
}

Body glider() {
    Body body;
    const glm::dvec3 nose(0.6, 0.0, 0.0), tail(-0.4, 0.0, 0.0), keel(-0.4, -0.2, 0.0);
    const glm::vec3 paper(0.10f, 0.34f, 0.36f);
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 fold(-0.4, 0.04, side * 0.03), tip(-0.4, 0.12, side * 0.42);
        add_flat(body, nose, fold, tip, paper);
        add_flat(body, nose, fold, keel, kPaint);
    }
    add_flat(body, nose, tail, keel, kPaint);
    return centred(body);
}

Body top() {
    Body body;
    const glm::dvec3 y(0.0, 1.0, 0.0);
    add_turned(body, {0.0, 0.02, 0.0}, y, rod_profile(0.30, 0.035), kWood);
    add_turned(body, {0.0, -0.13, 0.0}, y, round_profile(0.20, 0.27), kPaint);
    const glm::dvec2 cone[] = {{1e-4, 0.0}, {0.02, 0.01}, {0.15, 0.16}, {0.15, 0.16}, {1e-4, 0.17}};
    add_turned(body, {0.0, -0.26, 0.0}, y, cone, kSteel);
    return centred(body);
}

glm::dvec3 moved_by(const double* pose, const glm::dvec3& p) {
    const auto row = [&](int r) {
        const double* const m = pose + 4 * r;
        return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
    };
    return {row(0), row(1), row(2)};
}

void Copies::add(const Body& body, const double* pose, glm::vec3 faded, float fade) {
    const auto first = static_cast<uint32_t>(positions_.size());
    for (size_t i = 0; i < body.positions.size(); ++i) {
        positions_.emplace_back(moved_by(pose, body.positions[i]));
        colors_.emplace_back(glm::mix(body.colors[i], faded, fade), 1.0f);
    }
    for (const uint32_t v : body.triangles) triangles_.push_back(first + v);
}

FlgMeshView Copies::view() {
    columns_[0] = {FLG_ATTRIBUTE_POSITION, 3, &positions_[0].x, 0, 0};
    columns_[1] = {FLG_ATTRIBUTE_COLOR, 4, &colors_[0].x, 0, 0};
    FlgMeshView view = flgMeshViewDefaults();
    view.vertex_count = static_cast<uint32_t>(positions_.size());
    view.triangle_count = static_cast<uint32_t>(triangles_.size() / 3);
    view.column_count = 2;
    view.columns = columns_;
    view.triangles = triangles_.data();
    return view;
}

}  // namespace flg::samples
