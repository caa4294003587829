// SPDX-License-Identifier: MIT
#include "stylization/displacement.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "stylization/style_inputs.h"

namespace flg {
namespace {

TEST(Displacement, ComponentsInTheFrameGiveTheStyleBack) {
    std::vector<float> positions, tangents, normals;
    std::vector<Vec3> style;
    for (int i = 0; i < 100; ++i) {
        const Eigen::Quaterniond q =
            Eigen::Quaterniond(1 + 0.01 * i, 0.3 * std::sin(i), 0.02 * i, 0.5 * std::cos(i)).normalized();
        for (int k = 0; k < 3; ++k) {
            positions.push_back(static_cast<float>(0.3 * i + k));
            tangents.push_back(static_cast<float>((q * Vec3::UnitX())[k]));
            normals.push_back(static_cast<float>((q * Vec3::UnitY())[k]));
        }
        style.push_back(load_vec3(&positions[3 * i]) + Vec3(std::sin(0.3 * i), 0.5 * std::cos(0.2 * i), 0.1));
    }
    for (const bool haltingly : {false, true}) {
        const GuideAndStyle input{positions.data(), tangents.data(), normals.data(), style};
        Displacement d(100, test::memory());
        const double rms = run_now(
            test::memory(), [&](Pace& pace) { return displace(pace, input, d); }, haltingly);
        double sum_sq = 0;
        for (int i = 0; i < 100; ++i) {
            const Vec3 t = load_vec3(&tangents[3 * i]), n = load_vec3(&normals[3 * i]);
            const Vec3 back = load_vec3(&positions[3 * i]) + d.along_tangent[i] * t + d.along_normal[i] * n +
                              d.along_binormal[i] * t.cross(n);
            EXPECT_LT((back - style[i]).norm(), 1e-6);
            sum_sq += (style[i] - load_vec3(&positions[3 * i])).squaredNorm();
        }
        EXPECT_NEAR(rms, std::sqrt(sum_sq / 100), 1e-12);
    }
}

TEST(Displacement, SecondNormalIsTangentCrossNormal) {
    const float position[] = {0, 0, 0}, tangent[] = {1, 0, 0}, normal[] = {0, 1, 0};
    const std::vector<Vec3> style{Vec3(1, 2, 3)};
    Displacement d(1, test::memory());
    run_now(test::memory(), [&](Pace& pace) { return displace(pace, {position, tangent, normal, style}, d); });
    EXPECT_EQ(d.along_tangent[0], 1);
    EXPECT_EQ(d.along_normal[0], 2);
    EXPECT_EQ(d.along_binormal[0], 3);
}

}  // namespace
}  // namespace flg
