// SPDX-License-Identifier: MIT
// One object of a picking scene: it turns what Embree hits into what the host is told.
#pragma once

#include "core/vec.h"
#include "filigree/filigree_pick.h"
#include "pick/embree.h"

namespace flg::pick {

using Vec3f = Eigen::Vector3f;

inline Vec3f load(const float* p) {
    return {p[0], p[1], p[2]};
}

inline void store(const Vec3f& v, float* p) {
    p[0] = v.x();
    p[1] = v.y();
    p[2] = v.z();
}

// Embree takes no coordinates beyond about 2^60; metres.
constexpr float largest_coordinate = 1e18f;

// Where a ray met a primitive, in Embree's terms.
struct Meeting {
    uint32_t part;       // which of the target's geometries
    uint32_t primitive;  // in it
    float u, v;
    Vec3f position;
    Vec3f normal;  // Embree's, of any length
};

// The point of a primitive that is nearest to another point.
struct Nearest {
    float distance;  // infinite if the primitive doesn't count
    Meeting meeting;
};

class Target {
public:
    virtual ~Target() = default;

    // The geometries of this target, attached to the scene they were made for; a part's number is its place.
    virtual uint32_t part_count() const = 0;
    virtual uint32_t geometry_id(uint32_t part) const = 0;
    // Its geometry in the scene of boxes, where point queries are answered that Embree's own geometry doesn't take.
    virtual uint32_t box_id() const { return RTC_INVALID_GEOMETRY_ID; }

    // [any thread] element, u, v, position, normal and region of a hit.
    virtual void describe(const Meeting& meeting, FlgHit& hit) const = 0;
    virtual Nearest nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const = 0;
};

}  // namespace flg::pick
