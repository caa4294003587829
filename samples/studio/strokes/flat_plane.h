// SPDX-License-Identifier: MIT
// The plane that a curve lies in, as nearly as it does: for pictures of it in the panel.
#pragma once

#include <Eigen/Eigenvalues>
#include <glm/glm.hpp>
#include <vector>

namespace flg::studio {

class FlatPlane {
public:
    // Through the mean of the points, along the two directions in which they spread most. At least one point.
    explicit FlatPlane(const std::vector<glm::vec3>& points) {
        for (const glm::vec3& p : points) mean_ += vector(p) / static_cast<float>(points.size());
        Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
        for (const glm::vec3& p : points) {
            const Eigen::Vector3f d = vector(p) - mean_;
            spread += d * d.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(spread);
        along_ = solver.eigenvectors().col(2);
        across_ = solver.eigenvectors().col(1);
        if (along_[0] < 0.0f) along_ = -along_;  // from left to right, as it was drawn
        if (across_[1] < 0.0f) across_ = -across_;
    }
    // Right and down, as pixels go; metres.
    glm::vec2 flat(const glm::vec3& p) const {
        const Eigen::Vector3f d = vector(p) - mean_;
        return {along_.dot(d), -across_.dot(d)};
    }

private:
    static Eigen::Vector3f vector(const glm::vec3& p) { return {p.x, p.y, p.z}; }

    Eigen::Vector3f mean_ = Eigen::Vector3f::Zero(), along_, across_;
};

}  // namespace flg::studio
