// SPDX-License-Identifier: MIT
// A scene that can be picked in: the host's objects by number, over one Embree scene of two levels, so that one
// object's change leaves the structures of the others.
//
// What lives in this room: surfaces and curves in Embree, rays and nearest points. What does not: contexts, jobs; it
// sees the public headers and core only.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <vector>

#include "pick/targets.h"

namespace flg::pick {

// The host's word on Embree's own memory.
struct EmbreeMemory {
    uint32_t (*ask)(void* user_data, int64_t bytes);  // null: all is granted
    void* user_data;
    mutable std::atomic<bool> was_refused{false};
};

class PickScene {
public:
    PickScene(uint32_t threads, const Origin& origin, const EmbreeMemory& embree, Memory* memory);

    void set_surface(uint32_t object, const FlgSurfaceView& surface, const uint32_t* changed, uint32_t changed_count);
    void set_curves(uint32_t object, const FlgCurveSetView& curves, float min_radius);
    void remove(uint32_t object);
    void commit();

    // [any thread] Between changes.
    void pick(const FlgRay* rays, uint32_t count, FlgHit* hits) const;
    FlgHit nearest(const Vec3f& point, float max_distance) const;

private:
    struct Object {
        std::shared_ptr<Target> target;
        SurfaceTarget* surface;  // the target, if it is one
    };
    // Whose geometry it is.
    struct Part {
        uint32_t object;
        uint32_t part;
        const Target* target;
    };
    using Parts = std::pmr::vector<Part>;  // by Embree's geometry id, as committed
    struct NearestSearch;
    static bool visit_nearest(RTCPointQueryFunctionArguments* arguments);
    void pick_eight(const FlgRay* rays, const uint32_t* which, uint32_t count, FlgHit* hits) const;

    Memory* const memory_;
    const Origin origin_;
    Device device_;
    Scene scene_;
    Scene boxes_;  // see Target::box_id
    std::pmr::map<uint32_t, Object> objects_;
    Parts parts_, box_parts_;
    Vec3f lower_{Vec3f::Zero()}, upper_{Vec3f::Zero()};  // of all geometry, as committed
};

}  // namespace flg::pick
