// SPDX-License-Identifier: MIT
// A surface in a picking scene: a geometry with all triangles as they were when it was built, the base, and beside it small
// ones, each with the triangles that one or several updates changed. Rays pass through old forms of changed triangles, so
// the large structure is built once and a cut costs what it changed.
//
// Invariant: a triangle counts in one part only, the last that took it. Parts come and go at the end: as soon as
// parts_a_level of one level follow each other they become one of the next, so with n updates there are up to 7 log8(n),
// and each triangle was taken log8(n) times.
#pragma once

#include <memory>
#include <vector>

#include "pick/pick_target.h"

namespace flg::pick {

class SurfaceTarget final : public Target {
public:
    SurfaceTarget(RTCDevice device, RTCScene scene, const FlgSurfaceView& surface);
    ~SurfaceTarget() override;

    // Takes in what changed; triangles beyond those known count as changed. False if so much has that the whole is better
    // built anew (nothing was taken in then). After one that threw, too.
    bool update(const FlgSurfaceView& surface, const uint32_t* changed, uint32_t changed_count);

    uint32_t part_count() const override { return static_cast<uint32_t>(parts_.size()); }
    uint32_t geometry_id(uint32_t part) const override { return parts_[part]->id; }
    void describe(const Meeting& meeting, FlgHit& hit) const override;
    Nearest nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const override;

private:
    static constexpr uint32_t parts_a_level = 8;

    struct Part {
        const SurfaceTarget* target;
        uint8_t number;                   // its place among the parts
        uint32_t level;                   // of updates; of the base none
        std::vector<uint32_t> triangles;  // of the base none: it holds those there were, in their order
        uint32_t id = RTC_INVALID_GEOMETRY_ID;

        uint32_t triangle(uint32_t primitive) const { return number == 0 ? primitive : triangles[primitive]; }
    };
    // A triangle as the host has it now.
    struct Face {
        uint32_t triangle;
        Vec3f corners[3];
    };
    Face face(uint32_t triangle) const;
    std::unique_ptr<Part> join_last_parts();
    void attach_base(Part& part) const;
    void attach_changed(Part& part) const;
    void attach(Part& part, const Geometry& geometry) const;
    static void pass_changed(const RTCFilterFunctionNArguments* arguments);

    RTCDevice device_;
    RTCScene scene_;
    std::vector<float> positions_;     // 3 a vertex
    std::vector<uint32_t> triangles_;  // 3 a triangle
    std::vector<uint32_t> regions_;    // one a triangle
    std::vector<uint8_t> part_of_;     // one a triangle: the part that it counts in
    std::vector<std::unique_ptr<Part>> parts_;
    uint32_t base_count_;         // triangles of the base
    bool is_incomplete_ = false;  // an update threw
};

}  // namespace flg::pick
