// SPDX-License-Identifier: MIT
#include "pick/pick_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace flg::pick {

namespace {

// ---- The order in which many rays are best shot: by where they enter the scene, along a Morton curve, so that rays
// that follow each other read the same parts of a large structure while the processor still has them.

// Below this many the structure's parts that rays read have little in common, whatever the order.
constexpr uint32_t fewest_to_order = 10'000;

constexpr uint32_t cells = 128;  // a side of the box
constexpr uint32_t digit_bits = 11;
constexpr uint32_t digits = 2;  // hold the 21 bits of a cell's number

struct Entry {
    uint32_t cell, ray;
};

// Every third bit, beginning with the lowest.
uint32_t spread(uint32_t bits) {
    bits = (bits | bits << 8) & 0x0000f00f;
    bits = (bits | bits << 4) & 0x000c30c3;
    return (bits | bits << 2) & 0x00249249;
}

// Of the cell that the ray enters the box in; rays that miss the box enter somewhere at its side.
uint32_t entry_cell(const FlgRay& ray, const Vec3f& lower, const Vec3f& upper) {
    const Vec3f origin = load(ray.origin), direction = load(ray.direction);
    float entry = ray.nearest;
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) continue;
        entry = std::max(entry, ((direction[k] > 0 ? lower : upper)[k] - origin[k]) / direction[k]);
    }
    uint32_t number = 0;
    for (int k = 0; k < 3; ++k) {
        const float along = (origin[k] + entry * direction[k] - lower[k]) / (upper[k] - lower[k]) * cells;
        // (Written so that what is not a number is 0.)
        const float clamped = along > 0 ? std::min(along, cells - 1.0f) : 0.0f;
        number |= spread(static_cast<uint32_t>(clamped)) << k;
    }
    return number;
}

// Indices of the rays, each once. `lower` and `upper`: the scene's box, not empty. Memory: 20 bytes a ray.
std::pmr::vector<uint32_t> order_rays(const FlgRay* rays, uint32_t count, const Vec3f& lower, const Vec3f& upper,
                                      Memory* memory) {
    std::pmr::vector<Entry> entries(count, memory), sorted(count, memory);
    for (uint32_t i = 0; i < count; ++i) entries[i] = {entry_cell(rays[i], lower, upper), i};
    for (uint32_t digit = 0; digit < digits; ++digit) {
        constexpr uint32_t mask = (1u << digit_bits) - 1;
        std::array<uint32_t, mask + 2> places{};
        const auto value = [&](const Entry& entry) { return entry.cell >> digit * digit_bits & mask; };
        for (const Entry& entry : entries) ++places[value(entry) + 1];
        for (uint32_t i = 1; i < places.size(); ++i) places[i] += places[i - 1];
        for (const Entry& entry : entries) sorted[places[value(entry)]++] = entry;
        entries.swap(sorted);
    }
    std::pmr::vector<uint32_t> order(count, memory);
    for (uint32_t i = 0; i < count; ++i) order[i] = entries[i].ray;
    return order;
}

constexpr uint32_t packet = 8;  // rays that go through the scene together

constexpr FlgHit no_hit = {.object = FLG_NO_INDEX,
                           .element = FLG_NO_INDEX,
                           .u = 0,
                           .v = 0,
                           .position = {},
                           .distance = HUGE_VALF,
                           .normal = {},
                           .region = FLG_NO_INDEX};

bool ask_host(void* embree, ssize_t bytes, bool) {
    const EmbreeMemory& memory = *static_cast<const EmbreeMemory*>(embree);
    if (memory.ask(memory.user_data, bytes) != 0 || bytes <= 0) return true;
    memory.was_refused = true;
    return false;
}

Device make_device(uint32_t threads, const EmbreeMemory& embree) {
    char config[32];
    std::snprintf(config, sizeof config, "threads=%u", threads);
    Device device(rtcNewDevice(config));
    if (!device) check(nullptr, "start");
    if (embree.ask) rtcSetDeviceMemoryMonitorFunction(device.get(), ask_host, const_cast<EmbreeMemory*>(&embree));
    return device;
}

// Embree builds all of a scene anew when geometry of a kind comes that it did not have: from the beginning each scene
// has one of each, whose vertices are nowhere, so that it is never hit and has no bounds.
void attach_nowhere(RTCDevice device, RTCScene scene, RTCGeometryType type) {
    const bool is_curve = type == RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE;
    const Geometry geometry(rtcNewGeometry(device, type));
    if (is_curve) {
        auto* vertices =
            make_buffer<std::array<float, 4>>(device, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 2);
        vertices[0] = vertices[1] = {NAN, NAN, NAN, NAN};
        *make_buffer<uint32_t>(device, geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 1) = 0;
    } else {
        auto* vertices =
            make_buffer<std::array<float, 3>>(device, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3);
        vertices[0] = vertices[1] = vertices[2] = {NAN, NAN, NAN};
        *make_buffer<std::array<uint32_t, 3>>(device, geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 1) = {0, 1, 2};
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene, geometry.get());
}

// Embree squares directions: those whose size is out of hand are shot as others of about length 1, times 2 to this
// power.
int exponent_of(const Vec3f& direction) {
    const float size = direction.cwiseAbs().maxCoeff();
    return size > 1e-6f && size < 1e6f ? 0 : std::ilogb(size);
}

float scaled(float value, int exponent) {
    return exponent == 0 ? value : std::ldexp(value, exponent);
}

}  // namespace

PickScene::PickScene(uint32_t threads, const Origin& origin, const EmbreeMemory& embree, Memory* memory)
    : memory_(memory),
      origin_(origin),
      device_(make_device(threads, embree)),
      scene_(rtcNewScene(device_.get())),
      boxes_(rtcNewScene(device_.get())),
      objects_(memory),
      parts_(memory),
      box_parts_(memory) {
    check(device_.get(), "make a scene");
    // Low quality is Embree's name for scenes of two levels; each object's own structure is of the usual quality.
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
    attach_nowhere(device_.get(), scene_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    attach_nowhere(device_.get(), scene_.get(), RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    commit();
}

void PickScene::set_surface(uint32_t object, const FlgSurfaceView& surface, const uint32_t* changed,
                            uint32_t changed_count) {
    const auto there = objects_.find(object);
    if (changed && there != objects_.end() && there->second.surface &&
        there->second.surface->update(surface, changed, changed_count)) {
        return;
    }
    auto made = std::allocate_shared<SurfaceTarget>(std::pmr::polymorphic_allocator<SurfaceTarget>(memory_),
                                                    device_.get(), scene_.get(), origin_, surface, memory_);
    SurfaceTarget* const target = made.get();
    objects_[object] = {std::move(made), target};
}

void PickScene::set_curves(uint32_t object, const FlgCurveSetView& curves, float min_radius) {
    auto made = std::allocate_shared<CurveTarget>(std::pmr::polymorphic_allocator<CurveTarget>(memory_), device_.get(),
                                                  scene_.get(), boxes_.get(), origin_, curves, min_radius, memory_);
    objects_[object] = {std::move(made), nullptr};
}

void PickScene::remove(uint32_t object) {
    if (objects_.erase(object) == 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "object is %u, nothing in the scene", object);
}

void PickScene::commit() {
    parts_.clear();
    box_parts_.clear();
    const auto enter = [](Parts& parts, uint32_t id, const Part& part) {
        if (id == RTC_INVALID_GEOMETRY_ID) return;
        if (id >= parts.size()) parts.resize(id + 1);
        parts[id] = part;
    };
    for (const auto& [number, object] : objects_) {
        const Target& target = *object.target;
        for (uint32_t part = 0; part < target.part_count(); ++part) {
            enter(parts_, target.geometry_id(part), {number, part, &target});
        }
        enter(box_parts_, target.box_id(), {number, 0, &target});
    }
    rtcCommitScene(scene_.get());
    rtcCommitScene(boxes_.get());
    check(device_.get(), "build the scene");
    RTCBounds bounds;
    rtcGetSceneBounds(scene_.get(), &bounds);
    lower_ = {bounds.lower_x, bounds.lower_y, bounds.lower_z};
    upper_ = {bounds.upper_x, bounds.upper_y, bounds.upper_z};
}

void PickScene::pick(const FlgRay* rays, uint32_t count, FlgHit* hits) const {
    std::pmr::vector<uint32_t> order(memory_);
    if (count >= fewest_to_order) order = order_rays(rays, count, lower_, upper_, memory_);
    for (uint32_t first = 0; first < count; first += packet) {
        const uint32_t size = std::min(packet, count - first);
        uint32_t next[packet];
        for (uint32_t i = 0; i < size; ++i) next[i] = first + i;
        pick_eight(rays, order.empty() ? next : &order[first], size, hits);
    }
}

// The rays of these indices.
void PickScene::pick_eight(const FlgRay* rays, const uint32_t* which, uint32_t count, FlgHit* hits) const {
    alignas(32) RTCRayHit8 packet_of_rays{};
    alignas(32) int valid[packet] = {};
    int exponents[packet];
    RTCRay8& ray = packet_of_rays.ray;
    RTCHit8& hit = packet_of_rays.hit;
    for (uint32_t i = 0; i < count; ++i) {
        const FlgRay& given = rays[which[i]];
        const int exponent = exponents[i] = exponent_of(load(given.direction));
        valid[i] = -1;
        ray.org_x[i] = given.origin[0];
        ray.org_y[i] = given.origin[1];
        ray.org_z[i] = given.origin[2];
        ray.dir_x[i] = scaled(given.direction[0], -exponent);
        ray.dir_y[i] = scaled(given.direction[1], -exponent);
        ray.dir_z[i] = scaled(given.direction[2], -exponent);
        ray.tnear[i] = scaled(given.nearest, exponent);
        ray.tfar[i] = scaled(given.furthest, exponent);
        ray.mask[i] = UINT32_MAX;
        hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect8(valid, scene_.get(), &context, &packet_of_rays);
    for (uint32_t i = 0; i < count; ++i) {
        FlgHit& out = hits[which[i]];
        out = no_hit;
        if (hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
        const Part& part = parts_[hit.geomID[i]];
        out.object = part.object;
        out.distance = scaled(ray.tfar[i], -exponents[i]);
        const Vec3f direction(ray.dir_x[i], ray.dir_y[i], ray.dir_z[i]);
        const Vec3f position = load(rays[which[i]].origin) + ray.tfar[i] * direction;
        const Vec3f normal(hit.Ng_x[i], hit.Ng_y[i], hit.Ng_z[i]);
        part.target->describe({part.part, hit.primID[i], hit.u[i], hit.v[i], position, normal}, out);
    }
}

struct PickScene::NearestSearch {
    const Parts* parts;
    const Part* part = nullptr;
    Nearest best{HUGE_VALF, {}};
};

bool PickScene::visit_nearest(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<NearestSearch*>(arguments->userPtr);
    const Part& part = (*search.parts)[arguments->geomID];
    RTCPointQuery& query = *arguments->query;
    const Nearest found = part.target->nearest(part.part, arguments->primID, Vec3f(query.x, query.y, query.z));
    if (!(found.distance <= query.radius) || !(found.distance < search.best.distance)) return false;
    search.best = found;
    search.part = &part;
    query.radius = found.distance;
    return true;
}

FlgHit PickScene::nearest(const Vec3f& point, float max_distance) const {
    NearestSearch search{.parts = &parts_};
    RTCPointQuery query{point.x(), point.y(), point.z(), 0, max_distance};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &query, &context, visit_nearest, &search);
    search.parts = &box_parts_;
    rtcPointQuery(boxes_.get(), &query, &context, visit_nearest, &search);
    FlgHit hit = no_hit;
    if (!search.part) return hit;
    hit.object = search.part->object;
    hit.distance = search.best.distance;
    search.part->target->describe(search.best.meeting, hit);
    return hit;
}

}  // namespace flg::pick
