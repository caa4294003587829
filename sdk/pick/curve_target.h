// SPDX-License-Identifier: MIT
// Curves in a picking scene, as round tubes whose radius changes linearly along each segment. Embree answers rays for them,
// but no point queries: for these the segments' boxes are in a scene of their own.
#pragma once

#include <array>
#include <vector>

#include "pick/pick_target.h"

namespace flg::pick {

class CurveTarget final : public Target {
public:
    CurveTarget(RTCDevice device, RTCScene scene, RTCScene boxes, const FlgCurveSetView& curves, float least_radius);
    ~CurveTarget() override;

    uint32_t part_count() const override { return 1; }
    uint32_t geometry_id(uint32_t) const override { return id_; }
    uint32_t box_id() const override { return box_id_; }
    void describe(const Meeting& meeting, FlgHit& hit) const override;
    // Away from the segment's core by the radius there: exact for segments of even radius.
    Nearest nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const override;

private:
    struct Segment {
        uint32_t vertex;  // of vertices_, where it begins
        uint32_t point;   // of the host's curve set
        uint32_t curve;
    };

    static void bound(const RTCBoundsFunctionArguments* arguments);

    RTCScene scene_, boxes_;
    std::vector<std::array<float, 4>> vertices_;  // position and radius; closed curves repeat their first point
    std::vector<Segment> segments_;
    uint32_t id_ = RTC_INVALID_GEOMETRY_ID;
    uint32_t box_id_ = RTC_INVALID_GEOMETRY_ID;
};

}  // namespace flg::pick
