// SPDX-License-Identifier: MIT
// The normals of curves: carried from point to point, or as given. Host only.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace flg::render {

// Rotation-minimizing frames by double reflection (Wang, Juettler, Zheng, Liu 2008). No two points in a row may be
// equal. Of a closed curve, whose last point is its first, the twist is spread evenly.
void carry_normals(const glm::vec3* positions, uint32_t count, bool closed, glm::vec3* out_normals);

// Given normals, of any length, made unit and perpendicular to the curve, on the side that keeps a ribbon from crossing
// over itself; carried along where they point along the curve.
void follow_normals(const glm::vec3* positions, uint32_t count, bool closed, glm::vec3* in_out_normals);

// follow_normals, bit for bit, of an open curve that grows at its end: what is known of a point stays but for the last
// one's, whose direction is halfway to the next. Where nothing is given (zero), normals are carried.
class GrowingNormals {
public:
    explicit GrowingNormals(uint32_t capacity);
    void push(glm::vec3 given) { given_.push_back(given); }
    // find() has to follow, from the last point left.
    void truncate(uint32_t count);
    // Finds the normals of points `from` to the last pushed; those before were found when `from` was the last. Returns
    // the first that may have changed: `from`, or 0 where the first given normal that says anything comes or goes, as
    // all those before it are carried back from there.
    uint32_t find(const glm::vec4* centers, uint32_t from);
    glm::vec3 operator[](uint32_t point) const { return normals_[point]; }
    const glm::vec3* from(uint32_t point) const { return &normals_[point]; }

private:
    static constexpr uint32_t none = ~0u;
    std::vector<glm::vec3> given_, normals_;
    uint32_t first_said_ = none;  // point whose given normal says something
};

}  // namespace flg::render
