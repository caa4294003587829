// SPDX-License-Identifier: MIT
#include "pick/targets.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/float_precision.h"

namespace flg::pick {

namespace {

// ---- Nearest points of triangles and segments (Ericson: Real-Time Collision Detection, 2005, sec. 5.1).

// How far along the segment from a to b, 0 to 1, its nearest point to p lies.
inline float nearest_on_segment(const Vec3f& p, const Vec3f& a, const Vec3f& b) {
    const Vec3f along = b - a;
    const float length_sq = along.squaredNorm();
    return length_sq > 0 ? std::clamp((p - a).dot(along) / length_sq, 0.0f, 1.0f) : 0.0f;
}

struct TrianglePoint {
    float u, v;  // weights of the second and the third corner
    Vec3f position;
};

// By the Voronoi regions of corners, edges and inside; for flat triangles the nearest edge.
inline TrianglePoint nearest_in_triangle(const Vec3f& p, const Vec3f (&corners)[3]) {
    const Vec3f& a = corners[0];
    const Vec3f ab = corners[1] - a, ac = corners[2] - a, ap = p - a;
    const float ab_sq = ab.squaredNorm(), ac_sq = ac.squaredNorm(), across = ab.dot(ac);
    const float det = ab_sq * ac_sq - across * across;
    if (det > 0) {
        const float u = (ac_sq * ap.dot(ab) - across * ap.dot(ac)) / det;
        const float v = (ab_sq * ap.dot(ac) - across * ap.dot(ab)) / det;
        if (u >= 0 && v >= 0 && u + v <= 1) return {u, v, a + u * ab + v * ac};
    }
    const float s = nearest_on_segment(p, corners[0], corners[1]);
    const float t = nearest_on_segment(p, corners[1], corners[2]);
    const float r = nearest_on_segment(p, corners[2], corners[0]);
    const TrianglePoint candidates[] = {{s, 0, a + s * ab},
                                        {1 - t, t, corners[1] + t * (corners[2] - corners[1])},
                                        {0, 1 - r, corners[2] + r * (a - corners[2])}};
    return *std::min_element(std::begin(candidates), std::end(candidates), [&](const auto& x, const auto& y) {
        return (x.position - p).squaredNorm() < (y.position - p).squaredNorm();
    });
}

// Beyond this share of the triangles the other parts cost more than a new base.
constexpr uint32_t delta_share = 4;

constexpr uint32_t no_level = UINT32_MAX;  // of the base
constexpr uint8_t no_part = UINT8_MAX;

// Room for what cuts add.
template <class T>
std::pmr::vector<T> with_slack(size_t size, Memory* memory) {
    std::pmr::vector<T> made(memory);
    made.reserve(size + size / delta_share);
    made.resize(size);
    return made;
}

void check_triangle(const FlgMeshView& mesh, const ScenePositions& positions, uint32_t triangle) {
    for (size_t i = size_t{3} * triangle; i < size_t{3} * triangle + 3; ++i) {
        if (mesh.triangles[i] >= mesh.vertex_count) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "surface.mesh.triangles[%zu] is %u, but there are %u vertices", i,
                          mesh.triangles[i], mesh.vertex_count);
        }
        positions.check(mesh.triangles[i]);
    }
}

const FlgColumn& position_column(const FlgMeshView& mesh) {
    const FlgColumn* column = mesh.columns;
    while (column->attribute != FLG_ATTRIBUTE_POSITION) ++column;
    return *column;
}

void check_precision(const FlgMeshView& mesh, const std::pmr::vector<float>& positions) {
    EdgePrecision precision;
    for (size_t t = 0; t < mesh.triangle_count; ++t) {
        const uint32_t* const corners = mesh.triangles + 3 * t;
        for (uint32_t k = 0; k < 3; ++k)
            precision.add(&positions[size_t{3} * corners[k]], &positions[size_t{3} * corners[(k + 1) % 3]]);
    }
    precision.check("surface, seen from the scene's origin,",
                    "pick it in a scene with an origin near it (FlgPickSceneDesc::origin)");
}

}  // namespace

ScenePositions::ScenePositions(const FlgColumn& column, const double (&origin)[3], const Origin& scene)
    : data_(column.data),
      stride_(column.stride ? column.stride / sizeof(float) : 3),
      shift_(origin_shift({origin[0], origin[1], origin[2]}, scene)),
      is_moved_(!shift_.isZero(0)) {}

void ScenePositions::check(size_t vertex) const {
    float position[3];
    copy(vertex, position);
    for (const float value : position) {
        if (std::abs(value) <= largest_coordinate) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the position of vertex %zu holds %g, must be finite and at most 1e18 in size", vertex,
                      static_cast<double>(value));
    }
}

void ScenePositions::copy(size_t vertex, float* to) const {
    const float* const from = data_ + vertex * stride_;
    if (is_moved_) {
        store_vec3(load_vec3(from) + shift_, to);
    } else {
        std::memcpy(to, from, 3 * sizeof(float));
    }
}

SurfaceTarget::SurfaceTarget(RTCDevice device, RTCScene scene, const Origin& scene_origin,
                             const FlgSurfaceView& surface, Memory* memory)
    : device_(device),
      scene_(scene),
      scene_origin_(scene_origin),
      origin_{surface.mesh->origin[0], surface.mesh->origin[1], surface.mesh->origin[2]},
      positions_(with_slack<float>(size_t{3} * surface.mesh->vertex_count, memory)),
      triangles_(with_slack<uint32_t>(size_t{3} * surface.mesh->triangle_count, memory)),
      regions_(with_slack<uint32_t>(surface.mesh->triangle_count, memory)),
      part_of_(with_slack<uint8_t>(surface.mesh->triangle_count, memory)),
      parts_(memory),
      base_count_(surface.mesh->triangle_count) {
    const FlgMeshView& mesh = *surface.mesh;
    const ScenePositions positions(position_column(mesh), mesh.origin, scene_origin);
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) check_triangle(mesh, positions, t);
    for (size_t v = 0; v < mesh.vertex_count; ++v) positions.copy(v, &positions_[3 * v]);
    if (positions.are_moved()) check_precision(mesh, positions_);
    std::copy_n(mesh.triangles, triangles_.size(), triangles_.begin());
    if (mesh.regions) std::copy_n(mesh.regions, mesh.triangle_count, regions_.begin());
    parts_.push_back(make_part(0, no_level));
    attach_base(*parts_[0]);
}

SurfaceTarget::~SurfaceTarget() {
    for (const auto& part : parts_) {
        if (part->id != RTC_INVALID_GEOMETRY_ID) rtcDetachGeometry(scene_, part->id);
    }
}

void SurfaceTarget::attach_base(Part& part) const {
    const Geometry geometry(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices = make_buffer<std::array<float, 3>>(device_, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                                       positions_.size() / 3);
    auto* indices = make_buffer<std::array<uint32_t, 3>>(device_, geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                                         triangles_.size() / 3);
    std::memcpy(vertices, positions_.data(), positions_.size() * sizeof(float));
    std::memcpy(indices, triangles_.data(), triangles_.size() * sizeof(uint32_t));
    attach(part, geometry);
}

// With vertices of its own: a few thousand, not the whole surface's.
void SurfaceTarget::attach_changed(Part& part) const {
    const size_t count = part.triangles.size();
    const Geometry geometry(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices =
        make_buffer<std::array<float, 3>>(device_, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * count);
    auto* indices =
        make_buffer<std::array<uint32_t, 3>>(device_, geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, count);
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t k = 0; k < 3; ++k) {
            indices[i][k] = 3 * i + k;
            std::memcpy(&vertices[3 * i + k], &positions_[size_t{3} * triangles_[size_t{3} * part.triangles[i] + k]],
                        3 * sizeof(float));
        }
    }
    attach(part, geometry);
}

void SurfaceTarget::attach(Part& part, const Geometry& geometry) const {
    rtcSetGeometryUserData(geometry.get(), &part);
    rtcSetGeometryIntersectFilterFunction(geometry.get(), pass_changed);
    rtcCommitGeometry(geometry.get());
    check(device_, "build a surface");
    part.id = rtcAttachGeometry(scene_, geometry.get());
}

// Embree's filter: hits on old forms of triangles that count in another part don't count.
void SurfaceTarget::pass_changed(const RTCFilterFunctionNArguments* arguments) {
    const Part& part = *static_cast<const Part*>(arguments->geometryUserPtr);
    for (uint32_t i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) continue;
        const uint32_t triangle = part.triangle(RTCHitN_primID(arguments->hit, arguments->N, i));
        if (part.target->part_of_[triangle] != part.number) arguments->valid[i] = 0;
    }
}

std::shared_ptr<SurfaceTarget::Part> SurfaceTarget::make_part(size_t number, uint32_t level) {
    std::pmr::memory_resource* const memory = positions_.get_allocator().resource();
    return std::allocate_shared<Part>(std::pmr::polymorphic_allocator<Part>(memory),
                                      Part{.target = this,
                                           .number = static_cast<uint8_t>(number),
                                           .level = level,
                                           .triangles = std::pmr::vector<uint32_t>(memory)});
}

// What becomes one with the changes that come now: the last parts, if they are as many of a level, and so on.
std::shared_ptr<SurfaceTarget::Part> SurfaceTarget::join_last_parts() {
    size_t kept = parts_.size();
    uint32_t level = 0;
    constexpr size_t others = parts_a_level - 1;
    for (; kept > others && parts_[kept - others]->level == level; ++level) kept -= others;
    const std::shared_ptr<Part> joined = make_part(kept, level);
    for (size_t p = kept; p < parts_.size(); ++p) {
        for (const uint32_t triangle : parts_[p]->triangles) {
            if (part_of_[triangle] != p) continue;
            part_of_[triangle] = joined->number;
            joined->triangles.push_back(triangle);
        }
    }
    return joined;
}

bool SurfaceTarget::update(const FlgSurfaceView& surface, const uint32_t* changed, uint32_t changed_count) {
    const FlgMeshView& mesh = *surface.mesh;
    const auto known = static_cast<uint32_t>(triangles_.size() / 3);
    if (is_incomplete_ || mesh.triangle_count < known || mesh.vertex_count < positions_.size() / 3) return false;
    if (!std::equal(origin_.begin(), origin_.end(), mesh.origin)) return false;
    size_t beside = changed_count + (mesh.triangle_count - known);
    if (beside == 0) {
        if (mesh.regions) std::copy_n(mesh.regions, mesh.triangle_count, regions_.begin());
        return true;
    }
    for (const auto& part : parts_) beside += part->triangles.size();
    if (beside > base_count_ / delta_share) return false;

    const ScenePositions positions(position_column(mesh), mesh.origin, scene_origin_);
    for (uint32_t i = 0; i < changed_count; ++i) check_triangle(mesh, positions, changed[i]);
    for (uint32_t t = known; t < mesh.triangle_count; ++t) check_triangle(mesh, positions, t);
    is_incomplete_ = true;
    positions_.resize(size_t{3} * mesh.vertex_count);
    triangles_.resize(size_t{3} * mesh.triangle_count);
    regions_.resize(mesh.triangle_count);
    part_of_.resize(mesh.triangle_count, no_part);
    if (mesh.regions) std::copy_n(mesh.regions, mesh.triangle_count, regions_.begin());
    std::shared_ptr<Part> part = join_last_parts();
    // Vertices that moved belong to changed triangles.
    const auto take = [&](uint32_t triangle) {
        for (size_t i = size_t{3} * triangle; i < size_t{3} * triangle + 3; ++i) {
            triangles_[i] = mesh.triangles[i];
            positions.copy(triangles_[i], &positions_[size_t{3} * triangles_[i]]);
        }
        if (part_of_[triangle] == part->number) return;
        part_of_[triangle] = part->number;
        part->triangles.push_back(triangle);
    };
    for (uint32_t i = 0; i < changed_count; ++i) take(changed[i]);
    for (uint32_t triangle = known; triangle < mesh.triangle_count; ++triangle) take(triangle);
    for (size_t p = part->number; p < parts_.size(); ++p) rtcDetachGeometry(scene_, parts_[p]->id);
    parts_.resize(part->number);
    parts_.push_back(std::move(part));
    attach_changed(*parts_.back());
    is_incomplete_ = false;
    return true;
}

SurfaceTarget::Face SurfaceTarget::face(uint32_t triangle) const {
    Face face{.triangle = triangle, .corners = {}};
    for (uint32_t k = 0; k < 3; ++k) {
        face.corners[k] = load(&positions_[size_t{3} * triangles_[size_t{3} * triangle + k]]);
    }
    return face;
}

void SurfaceTarget::describe(const Meeting& meeting, FlgHit& hit) const {
    const Face at = face(parts_[meeting.part]->triangle(meeting.primitive));
    hit.element = at.triangle;
    hit.u = meeting.u;
    hit.v = meeting.v;
    hit.region = regions_[at.triangle];
    const float w = 1 - meeting.u - meeting.v;
    store(w * at.corners[0] + meeting.u * at.corners[1] + meeting.v * at.corners[2], hit.position);
    const Vec3f normal = (at.corners[1] - at.corners[0]).cross(at.corners[2] - at.corners[0]);
    const float length = normal.norm();
    store(length > 0 ? Vec3f(normal / length) : Vec3f::Zero(), hit.normal);
}

Nearest SurfaceTarget::nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const {
    const uint32_t triangle = parts_[part]->triangle(primitive);
    if (part_of_[triangle] != part) return {.distance = HUGE_VALF, .meeting = {}};
    const TrianglePoint found = nearest_in_triangle(point, face(triangle).corners);
    return {(found.position - point).norm(), {part, primitive, found.u, found.v, found.position, Vec3f::Zero()}};
}

namespace {

struct Reader {
    const float* data = nullptr;
    size_t stride = 0;
    float factor = 1;
    const float* at(size_t point) const { return data + point * stride; }
};

const FlgColumn& position_column(const FlgCurveSetView& curves) {
    const FlgColumn* column = curves.columns;
    while (column->attribute != FLG_ATTRIBUTE_POSITION) ++column;
    return *column;
}

// Refuses a point of curves with another origin where floats are farther apart than tubes are thick.
void check_place(const float* place, float min_radius) {
    for (int k = 0; k < 3; ++k) {
        if (float_step(std::abs(place[k])) <= min_radius) continue;
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "curves, seen from the scene's origin, has a coordinate of %g m, where floats are %g m apart, more "
            "than min_radius; pick them in a scene with an origin near them (FlgPickSceneDesc::origin)",
            double{place[k]}, double{float_step(std::abs(place[k]))});
    }
}

Reader reader_of(const FlgCurveSetView& curves, FlgAttribute attribute, float factor = 1) {
    for (uint32_t i = 0; i < curves.column_count; ++i) {
        const FlgColumn& column = curves.columns[i];
        if (column.attribute != attribute) continue;
        return {column.data, column.stride ? column.stride / sizeof(float) : column.components, factor};
    }
    return {};
}

}  // namespace

CurveTarget::CurveTarget(RTCDevice device, RTCScene scene, RTCScene boxes, const Origin& scene_origin,
                         const FlgCurveSetView& curves, float min_radius, Memory* memory)
    : scene_(scene), boxes_(boxes), vertices_(memory), segments_(memory) {
    const ScenePositions positions(position_column(curves), curves.origin, scene_origin);
    Reader radii = reader_of(curves, FLG_ATTRIBUTE_RADIUS);
    if (!radii.data) radii = reader_of(curves, FLG_ATTRIBUTE_WIDTH, 0.5f);
    const auto add = [&](uint32_t point) {
        float p[3];
        positions.copy(point, p);
        if (positions.are_moved()) check_place(p, min_radius);
        const float radius = radii.data ? std::max(min_radius, *radii.at(point) * radii.factor) : min_radius;
        vertices_.push_back({p[0], p[1], p[2], radius});
    };
    for (uint32_t c = 0; c < curves.curve_count; ++c) {
        const uint32_t first = curves.curve_offsets[c], end = curves.curve_offsets[c + 1];
        const bool closed = curves.curve_flags && (curves.curve_flags[c] & FLG_CURVE_CLOSED) != 0 && end - first > 1;
        for (uint32_t p = first; p < end; ++p) {
            if (p + 1 < end || closed) segments_.push_back({static_cast<uint32_t>(vertices_.size()), p, c});
            add(p);
        }
        if (closed) add(first);
    }
    const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE));
    auto* vertices = make_buffer<std::array<float, 4>>(device, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                                       vertices_.size());
    std::copy(vertices_.begin(), vertices_.end(), vertices);
    auto* indices = make_buffer<uint32_t>(device, geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, segments_.size());
    // Segments that go on in a neighbour have no cap there.
    auto* flags = make_buffer<uint8_t>(device, geometry, RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, segments_.size());
    for (size_t s = 0; s < segments_.size(); ++s) {
        indices[s] = segments_[s].vertex;
        const bool follows = s > 0 && segments_[s - 1].curve == segments_[s].curve;
        const bool goes_on = s + 1 < segments_.size() && segments_[s + 1].curve == segments_[s].curve;
        flags[s] = static_cast<uint8_t>((follows ? RTC_CURVE_FLAG_NEIGHBOR_LEFT : 0) |
                                        (goes_on ? RTC_CURVE_FLAG_NEIGHBOR_RIGHT : 0));
    }
    rtcCommitGeometry(geometry.get());
    check(device, "build curves");
    const Geometry boxes_of_segments(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(boxes_of_segments.get(), static_cast<unsigned>(segments_.size()));
    rtcSetGeometryUserData(boxes_of_segments.get(), this);
    rtcSetGeometryBoundsFunction(boxes_of_segments.get(), bound, nullptr);
    rtcCommitGeometry(boxes_of_segments.get());
    check(device, "build curves");
    id_ = rtcAttachGeometry(scene_, geometry.get());
    box_id_ = rtcAttachGeometry(boxes_, boxes_of_segments.get());
}

CurveTarget::~CurveTarget() {
    rtcDetachGeometry(scene_, id_);
    rtcDetachGeometry(boxes_, box_id_);
}

void CurveTarget::bound(const RTCBoundsFunctionArguments* arguments) {
    const auto& self = *static_cast<const CurveTarget*>(arguments->geometryUserPtr);
    const std::array<float, 4>* ends = &self.vertices_[self.segments_[arguments->primID].vertex];
    float least[3], most[3];
    for (int k = 0; k < 3; ++k) {
        least[k] = std::min(ends[0][k] - ends[0][3], ends[1][k] - ends[1][3]);
        most[k] = std::max(ends[0][k] + ends[0][3], ends[1][k] + ends[1][3]);
    }
    *arguments->bounds_o = {least[0], least[1], least[2], 0, most[0], most[1], most[2], 0};
}

void CurveTarget::describe(const Meeting& meeting, FlgHit& hit) const {
    const Segment& segment = segments_[meeting.primitive];
    hit.element = segment.point;
    hit.u = meeting.u;
    hit.v = 0;
    hit.region = segment.curve;
    store(meeting.position, hit.position);
    const float length = meeting.normal.norm();
    store(length > 0 ? Vec3f(meeting.normal / length) : Vec3f::Zero(), hit.normal);
}

Nearest CurveTarget::nearest(uint32_t part, uint32_t primitive, const Vec3f& point) const {
    const std::array<float, 4>* ends = &vertices_[segments_[primitive].vertex];
    const Vec3f a = load(ends[0].data()), b = load(ends[1].data());
    const float t = nearest_on_segment(point, a, b);
    const float radius = ends[0][3] + t * (ends[1][3] - ends[0][3]);
    const Vec3f core = a + t * (b - a);
    const float from_core = (point - core).norm();
    const float distance = std::max(0.0f, from_core - radius);
    const Vec3f away = from_core > 0 ? Vec3f((point - core) / from_core) : Vec3f::Zero();
    return {distance, {part, primitive, t, 0, core + std::min(radius, from_core) * away, away}};
}

}  // namespace flg::pick
