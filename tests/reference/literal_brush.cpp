// SPDX-License-Identifier: MIT
#include "reference/literal_brush.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace flg::literal {
namespace {

Vec3 segment(const std::vector<Vec3>& points, size_t i) {
    return (points[i + 1] - points[i]).normalized();
}

// Where `arm`, across the tangent at point i, meets the tube of a segment that touches the point.
Vec3 slid(const std::vector<Vec3>& points, const BrushFrames& frames, size_t i, const Vec3& arm) {
    if (i == 0 || i + 1 == points.size()) return arm;
    const Vec3 along = segment(points, i - 1), tangent = frames.tangents[i];
    const Vec3 across = Eigen::Quaterniond::FromTwoVectors(tangent, along) * arm;
    return across - across.dot(tangent) / along.dot(tangent) * along;
}

}  // namespace

Vec3 first_normal(const Vec3& tangent) {
    Vec3 axis = Vec3::Zero();
    int least = 0;
    for (int k = 1; k < 3; ++k) {
        if (std::abs(tangent[k]) < std::abs(tangent[least])) least = k;
    }
    axis[least] = 1;
    return (axis - axis.dot(tangent) * tangent).normalized();
}

BrushFrames brush_frames(const std::vector<Vec3>& points, const Vec3& first_normal) {
    BrushFrames frames;
    for (size_t i = 0; i < points.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        if (i > 0) sum += segment(points, i - 1);
        if (i + 1 < points.size()) sum += segment(points, i);
        frames.tangents.push_back(sum.normalized());
    }
    frames.normals = {first_normal};
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec3 v1 = points[i + 1] - points[i];
        const double c1 = v1.dot(v1);
        const Vec3 r = frames.normals[i] - 2 / c1 * v1.dot(frames.normals[i]) * v1;
        const Vec3 t = frames.tangents[i] - 2 / c1 * v1.dot(frames.tangents[i]) * v1;
        const Vec3 v2 = frames.tangents[i + 1] - t;
        frames.normals.push_back(r - 2 / v2.dot(v2) * v2.dot(r) * v2);
    }
    return frames;
}

BrushMesh tube(const std::vector<Vec3>& points, const std::vector<double>& radii, uint32_t sides) {
    const Vec3 start = segment(points, 0);
    const BrushFrames frames = brush_frames(points, first_normal(start));
    BrushMesh mesh;
    for (size_t i = 0; i < points.size(); ++i) {
        for (uint32_t k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            const Vec3 arm = Eigen::AngleAxisd(angle, frames.tangents[i]) * frames.normals[i] * radii[i];
            mesh.positions.push_back(points[i] + slid(points, frames, i, arm));
        }
    }
    for (uint32_t i = 0; i + 1 < points.size(); ++i) {
        for (uint32_t k = 0; k < sides; ++k) {
            const uint32_t a = i * sides + k, b = i * sides + (k + 1) % sides;
            mesh.triangles.push_back({a, b, b + sides});
            mesh.triangles.push_back({a, b + sides, a + sides});
        }
    }
    return mesh;
}

BrushMesh ribbon(const std::vector<Vec3>& points, const std::vector<double>& radii) {
    const Vec3 start = segment(points, 0);
    const BrushFrames frames = brush_frames(points, first_normal(start));
    BrushMesh mesh;
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec3 arm = frames.tangents[i].cross(frames.normals[i]) * radii[i];
        for (const double side : {-1.0, 1.0}) mesh.positions.push_back(points[i] + slid(points, frames, i, side * arm));
    }
    for (uint32_t i = 0; i + 1 < points.size(); ++i) {
        mesh.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
        mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
    return mesh;
}

}  // namespace flg::literal
