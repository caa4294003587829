// SPDX-License-Identifier: MIT
#include "stylization/displacement.h"

#include <Eigen/Geometry>
#include <cmath>

#include "runtime/each.h"

namespace flg {

Task<double> displace(Pace& pace, GuideAndStyle input, Displacement& out) {
    double sum_sq = 0;
    co_await each(pace, out.size(), Cost::some_ns, [&](uint32_t i) {
        const size_t at = 3 * size_t{i};
        const Vec3 tangent = load_vec3(input.tangents + at);
        const Vec3 normal = load_vec3(input.normals + at);
        const Vec3 d = input.matched[i] - load_vec3(input.positions + at);
        out.along_tangent[i] = d.dot(tangent);
        out.along_normal[i] = d.dot(normal);
        out.along_binormal[i] = d.dot(tangent.cross(normal));
        sum_sq += d.squaredNorm();
    });
    co_return out.size() == 0 ? 0.0 : std::sqrt(sum_sq / out.size());
}

}  // namespace flg
