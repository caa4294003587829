// SPDX-License-Identifier: MIT
// Curves for the tests of this room, and one call that resamples them.
#pragma once

#include <functional>
#include <vector>

#include "curves/arc_length.h"
#include "curves/resample.h"
#include "runtime/run_now.h"

namespace flg::test {

struct Points {
    std::vector<float> floats;
    bool closed = false;

    CurveView view() const { return {floats.data(), static_cast<uint32_t>(floats.size() / 3), closed}; }
    std::vector<Vec3> vectors() const {
        std::vector<Vec3> out;
        for (uint32_t i = 0; i < view().count; ++i) out.push_back(view().point(i));
        return out;
    }
};

inline Points points_of(const std::vector<Vec3>& vectors, bool closed = false) {
    Points points{{}, closed};
    for (const Vec3& v : vectors) {
        for (int k = 0; k < 3; ++k) points.floats.push_back(static_cast<float>(v[k]));
    }
    return points;
}

// count + 1 points at u from 0 to 1; closed: count points.
inline Points sampled(const std::function<Vec3(double)>& curve, int count, bool closed = false) {
    std::vector<Vec3> vectors;
    for (int i = 0; i < (closed ? count : count + 1); ++i) vectors.push_back(curve(static_cast<double>(i) / count));
    return points_of(vectors, closed);
}

inline CurveMeasure measure(const Points& points, bool haltingly = false) {
    return run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return measure_curve(pace, points.view()); }, haltingly);
}

struct Resampled {
    std::vector<float> positions, tangents, normals;

    size_t size() const { return positions.size() / 3; }
    Vec3 position(size_t i) const { return load_vec3(&positions[3 * i]); }
    Vec3 tangent(size_t i) const { return load_vec3(&tangents[3 * i]); }
    Vec3 normal(size_t i) const { return load_vec3(&normals[3 * i]); }
};

inline Resampled resample(const SamplingPlan& plan, bool haltingly = false, std::span<const ColumnPair> columns = {}) {
    Resampled out;
    out.positions.resize(3 * plan.sample_count());
    out.tangents.resize(3 * plan.sample_count());
    out.normals.resize(3 * plan.sample_count());
    const FrameColumns to{out.positions.data(), out.tangents.data(), out.normals.data()};
    run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return resample_curve(pace, plan, to, columns, 1); },
        haltingly);
    return out;
}

inline SamplingPlan plan_of(const Points& points, uint32_t steps,
                            FlgFrameMethod frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING) {
    SamplingPlan plan;
    plan.curve = points.view();
    plan.measure = measure(points);
    plan.steps = steps;
    plan.frame = frame;
    return plan;
}

inline Resampled resample(const Points& points, uint32_t steps,
                          FlgFrameMethod frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING, bool haltingly = false) {
    return resample(plan_of(points, steps, frame), haltingly);
}

constexpr double two_pi = 6.283185307179586;

inline Vec3 helix(double u) {
    return Vec3(2.0 * std::cos(3 * two_pi * u), 2.0 * std::sin(3 * two_pi * u), 4.0 * u);
}

// Neither planar nor symmetric.
inline Vec3 wild(double u) {
    return Vec3(std::sin(7 * u) + 2 * u, std::cos(5 * u + 1) * 0.8, 0.6 * std::sin(11 * u * u) + 0.3 * u);
}

}  // namespace flg::test
