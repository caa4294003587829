// SPDX-License-Identifier: MIT
#include "stylization/displacement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace flg {

bool DisplacementKernel::run(uint32_t n) {
    const uint32_t count = result_.size();
    const uint32_t end = done_ + std::min(n, count - done_);
    for (; done_ < end; ++done_) {
        const size_t at = 3 * static_cast<size_t>(done_);
        const Vec3 tangent = load_vec3(input_.tangents + at);
        const Vec3 normal = load_vec3(input_.normals + at);
        const Vec3 d = input_.matched[done_] - load_vec3(input_.positions + at);
        result_.along_tangent[done_] = d.dot(tangent);
        result_.along_normal[done_] = d.dot(normal);
        result_.along_binormal[done_] = d.dot(tangent.cross(normal));
        sum_sq_ += d.squaredNorm();
    }
    return done_ == count;
}

double DisplacementKernel::rms() const {
    return done_ == 0 ? 0.0 : std::sqrt(sum_sq_ / done_);
}

}  // namespace flg
