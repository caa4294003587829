// SPDX-License-Identifier: MIT
#include "splines/bodies.h"

#include <algorithm>
#include <array>

namespace flg::studio::splines {
namespace {

constexpr const char* kNames[] = {"paper plane", "hammer", "top", "oar"};

samples::Body of_length_1(samples::Body body) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::dvec3& p : body.positions) low = glm::min(low, p), high = glm::max(high, p);
    const glm::dvec3 sides = high - low;
    for (glm::dvec3& p : body.positions) p /= std::max({sides.x, sides.y, sides.z});
    return body;
}

}  // namespace

std::span<const char* const> body_names() {
    return kNames;
}

const samples::Body& unit_body(int index) {
    static const std::array<samples::Body, std::size(kNames)> bodies = {
        of_length_1(samples::glider()), of_length_1(samples::hammer()), of_length_1(samples::top()),
        of_length_1(samples::oar())};
    return bodies.at(static_cast<size_t>(index));
}

}  // namespace flg::studio::splines
