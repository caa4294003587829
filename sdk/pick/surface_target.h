// SPDX-License-Identifier: MIT
// A surface in a picking scene: a geometry with all triangles as they were when it was built, and beside it a small one with
// those that changed since. Rays pass through the old forms of changed triangles, so the large structure is built once and
// a cut costs what it changed.
#pragma once

#include <vector>

#include "pick/pick_target.h"

namespace flg::pick {

class SurfaceTarget final : public Target {
public:
    SurfaceTarget(RTCDevice device, RTCScene scene, const FlgSurfaceView& surface);
    ~SurfaceTarget() override;

    // Takes in what changed; triangles beyond those known count as changed. False if so much has that the whole is better
    // built anew (nothing was taken in then).
    bool update(const FlgSurfaceView& surface, const uint32_t* changed, uint32_t changed_count);

    uint32_t part_count() const override { return delta_id_ == RTC_INVALID_GEOMETRY_ID ? 1 : 2; }
    uint32_t geometry_id(uint32_t part) const override { return part == 0 ? base_id_ : delta_id_; }
    void describe(const Meeting& meeting, FlgHit& hit) const override;
    Nearest nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const override;

private:
    // A triangle as the host has it now.
    struct Face {
        uint32_t triangle;
        Vec3f corners[3];
    };
    Face face(uint32_t part, uint32_t primitive) const;
    uint32_t attach(const std::vector<uint32_t>* only);
    static void pass_changed(const RTCFilterFunctionNArguments* arguments);

    RTCDevice device_;
    RTCScene scene_;
    std::vector<float> positions_;     // 3 a vertex
    std::vector<uint32_t> triangles_;  // 3 a triangle
    std::vector<uint32_t> regions_;    // one a triangle
    std::vector<bool> changed_;        // one a triangle of the base: not where it was
    std::vector<uint32_t> delta_;      // the triangles that the delta holds
    uint32_t base_id_ = RTC_INVALID_GEOMETRY_ID;
    uint32_t delta_id_ = RTC_INVALID_GEOMETRY_ID;
};

}  // namespace flg::pick
