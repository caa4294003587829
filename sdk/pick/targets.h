// SPDX-License-Identifier: MIT
// Objects of a picking scene: each turns what Embree hits into what the host is told. Embree's own objects are
// released when they go out of scope, and its errors become ours.
//
// A surface in a picking scene: a geometry with all triangles as they were when it was built, the base, and beside it
// small ones, each with the triangles that one or several updates changed. Rays pass through old forms of changed
// triangles, so the large structure is built once and a cut costs what it changed.
//
// Invariant: a triangle counts in one part only, the last that took it. Parts come and go at the end: as soon as
// parts_a_level of one level follow each other they become one of the next, so with n updates there are up to 7
// log8(n), and each triangle was taken log8(n) times.
//
// Curves in a picking scene, as round tubes whose radius changes linearly along each segment. Embree answers rays for
// them, but no point queries: for these the segments' boxes are in a scene of their own.
#pragma once

#include <embree3/rtcore.h>
#include <array>
#include <memory>
#include <memory_resource>
#include <vector>

#include "core/failure.h"
#include "core/memory.h"
#include "core/origin.h"
#include "filigree/filigree_pick.h"

namespace flg::pick {

struct Releases {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, Releases>;
using Scene = std::unique_ptr<RTCSceneTy, Releases>;
using Geometry = std::unique_ptr<RTCGeometryTy, Releases>;

inline void check(RTCDevice device, const char* action) {
    switch (const RTCError error = rtcGetDeviceError(device)) {
        case RTC_ERROR_NONE: return;
        case RTC_ERROR_OUT_OF_MEMORY: throw Failure(FLG_ERROR_OUT_OF_MEMORY, "no memory is left to %s", action);
        default: throw Failure(FLG_ERROR_INTERNAL, "Embree can't %s: error %d", action, static_cast<int>(error));
    }
}

// A buffer of `geometry` to be filled in; Embree owns it.
template <class T>
T* make_buffer(RTCDevice device, const Geometry& geometry, RTCBufferType type, RTCFormat format, size_t count) {
    void* buffer = rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, sizeof(T), count);
    check(device, "take memory for a geometry");
    if (!buffer) throw Failure(FLG_ERROR_OUT_OF_MEMORY, "no memory is left for a geometry of %zu elements", count);
    return static_cast<T*>(buffer);
}

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

// Positions of the host as the scene has them, relative to its origin: with another of their own they are moved in
// doubles, and rounded to floats again.
class ScenePositions {
public:
    ScenePositions(const FlgColumn& column, const double (&origin)[3], const Origin& scene);

    // Throws for what Embree would leave out.
    void check(size_t vertex) const;
    void copy(size_t vertex, float* to) const;
    bool are_moved() const { return is_moved_; }

private:
    const float* data_;
    size_t stride_;
    Vec3 shift_;
    bool is_moved_;
};

class SurfaceTarget final : public Target {
public:
    SurfaceTarget(RTCDevice device, RTCScene scene, const Origin& scene_origin, const FlgSurfaceView& surface,
                  Memory* memory);
    ~SurfaceTarget() override;

    // Takes in what changed; triangles beyond those known count as changed. False if so much has that the whole is
    // better built anew (nothing was taken in then). After one that threw, too.
    bool update(const FlgSurfaceView& surface, const uint32_t* changed, uint32_t changed_count);

    uint32_t part_count() const override { return static_cast<uint32_t>(parts_.size()); }
    uint32_t geometry_id(uint32_t part) const override { return parts_[part]->id; }
    void describe(const Meeting& meeting, FlgHit& hit) const override;
    Nearest nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const override;

private:
    static constexpr uint32_t parts_a_level = 8;

    struct Part {
        const SurfaceTarget* target;
        uint8_t number;                        // its place among the parts
        uint32_t level;                        // of updates; of the base none
        std::pmr::vector<uint32_t> triangles;  // of the base none: it holds those there were, in their order
        uint32_t id = RTC_INVALID_GEOMETRY_ID;

        uint32_t triangle(uint32_t primitive) const { return number == 0 ? primitive : triangles[primitive]; }
    };
    // A triangle as the host has it now.
    struct Face {
        uint32_t triangle;
        Vec3f corners[3];
    };
    Face face(uint32_t triangle) const;
    std::shared_ptr<Part> make_part(size_t number, uint32_t level);
    std::shared_ptr<Part> join_last_parts();
    void attach_base(Part& part) const;
    void attach_changed(Part& part) const;
    void attach(Part& part, const Geometry& geometry) const;
    static void pass_changed(const RTCFilterFunctionNArguments* arguments);

    RTCDevice device_;
    RTCScene scene_;
    const Origin scene_origin_, origin_;             // of the scene; of the surface
    std::pmr::vector<float> positions_;              // 3 a vertex
    std::pmr::vector<uint32_t> triangles_;           // 3 a triangle
    std::pmr::vector<uint32_t> regions_;             // one a triangle
    std::pmr::vector<uint8_t> part_of_;              // one a triangle: the part that it counts in
    std::pmr::vector<std::shared_ptr<Part>> parts_;  // (shared only as unique_ptr knows no resource)
    uint32_t base_count_;                            // triangles of the base
    bool is_incomplete_ = false;                     // an update threw
};

class CurveTarget final : public Target {
public:
    CurveTarget(RTCDevice device, RTCScene scene, RTCScene boxes, const Origin& scene_origin,
                const FlgCurveSetView& curves, float min_radius, Memory* memory);
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
    std::pmr::vector<std::array<float, 4>> vertices_;  // position and radius; closed curves repeat their first point
    std::pmr::vector<Segment> segments_;
    uint32_t id_ = RTC_INVALID_GEOMETRY_ID;
    uint32_t box_id_ = RTC_INVALID_GEOMETRY_ID;
};

}  // namespace flg::pick
