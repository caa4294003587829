// SPDX-License-Identifier: MIT
#include "pick/surface_target.h"

#include <algorithm>
#include <cstring>

#include "pick/nearest_point.h"

namespace flg::pick {

namespace {

// Beyond this share of the triangles the delta costs more than a new base.
constexpr uint32_t delta_share = 4;

// The host's positions.
class Positions {
public:
    explicit Positions(const FlgMeshView& mesh) {
        const FlgColumn* column = mesh.columns;
        while (column->attribute != FLG_ATTRIBUTE_POSITION) ++column;
        data_ = column->data;
        stride_ = column->stride ? column->stride / sizeof(float) : 3;
    }
    void copy(size_t vertex, std::vector<float>& to) const {
        std::memcpy(&to[3 * vertex], data_ + vertex * stride_, 3 * sizeof(float));
    }

private:
    const float* data_;
    size_t stride_;
};

// Room for what cuts add.
template <class T>
std::vector<T> with_slack(size_t size) {
    std::vector<T> made;
    made.reserve(size + size / delta_share);
    made.resize(size);
    return made;
}

void check_triangle(const FlgMeshView& mesh, uint32_t triangle) {
    for (size_t i = size_t{3} * triangle; i < size_t{3} * triangle + 3; ++i) {
        if (mesh.triangles[i] >= mesh.vertex_count) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "surface.mesh.triangles[%zu] is %u, but there are %u vertices", i,
                          mesh.triangles[i], mesh.vertex_count);
        }
    }
}

}  // namespace

SurfaceTarget::SurfaceTarget(RTCDevice device, RTCScene scene, const FlgSurfaceView& surface)
    : device_(device),
      scene_(scene),
      positions_(with_slack<float>(size_t{3} * surface.mesh.vertex_count)),
      triangles_(with_slack<uint32_t>(size_t{3} * surface.mesh.triangle_count)),
      regions_(with_slack<uint32_t>(surface.mesh.triangle_count)),
      changed_(surface.mesh.triangle_count) {
    const FlgMeshView& mesh = surface.mesh;
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) check_triangle(mesh, t);
    const Positions positions(mesh);
    for (size_t v = 0; v < mesh.vertex_count; ++v) positions.copy(v, positions_);
    std::copy_n(mesh.triangles, triangles_.size(), triangles_.begin());
    if (mesh.regions) std::copy_n(mesh.regions, mesh.triangle_count, regions_.begin());
    base_id_ = attach(nullptr);
}

SurfaceTarget::~SurfaceTarget() {
    rtcDetachGeometry(scene_, base_id_);
    if (delta_id_ != RTC_INVALID_GEOMETRY_ID) rtcDetachGeometry(scene_, delta_id_);
}

// A geometry of all triangles, or only of some.
uint32_t SurfaceTarget::attach(const std::vector<uint32_t>* only) {
    const size_t count = only ? only->size() : triangles_.size() / 3;
    const Geometry geometry(rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* indices =
        make_buffer<std::array<uint32_t, 3>>(device_, geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, count);
    if (only) {
        // Vertices of its own: a few thousand, not the whole surface's.
        auto* vertices =
            make_buffer<std::array<float, 3>>(device_, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 3 * count);
        for (uint32_t i = 0; i < count; ++i) {
            for (uint32_t k = 0; k < 3; ++k) {
                indices[i][k] = 3 * i + k;
                std::memcpy(&vertices[3 * i + k], &positions_[size_t{3} * triangles_[size_t{3} * (*only)[i] + k]], 12);
            }
        }
    } else {
        auto* vertices = make_buffer<std::array<float, 3>>(device_, geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                                           positions_.size() / 3);
        std::memcpy(vertices, positions_.data(), positions_.size() * sizeof(float));
        std::memcpy(indices, triangles_.data(), triangles_.size() * sizeof(uint32_t));
        rtcSetGeometryUserData(geometry.get(), this);
        rtcSetGeometryIntersectFilterFunction(geometry.get(), pass_changed);
    }
    rtcCommitGeometry(geometry.get());
    check(device_, "build a surface");
    return rtcAttachGeometry(scene_, geometry.get());
}

// Embree's filter of the base: hits on the old forms of changed triangles don't count.
void SurfaceTarget::pass_changed(const RTCFilterFunctionNArguments* arguments) {
    const auto& self = *static_cast<const SurfaceTarget*>(arguments->geometryUserPtr);
    for (uint32_t i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == -1 && self.changed_[RTCHitN_primID(arguments->hit, arguments->N, i)]) {
            arguments->valid[i] = 0;
        }
    }
}

bool SurfaceTarget::update(const FlgSurfaceView& surface, const uint32_t* changed, uint32_t changed_count) {
    const FlgMeshView& mesh = surface.mesh;
    const auto known = static_cast<uint32_t>(triangles_.size() / 3);
    if (mesh.triangle_count < known || mesh.vertex_count < positions_.size() / 3) return false;
    if (delta_.size() + changed_count + (mesh.triangle_count - known) > changed_.size() / delta_share) return false;

    for (uint32_t i = 0; i < changed_count; ++i) check_triangle(mesh, changed[i]);
    for (uint32_t t = known; t < mesh.triangle_count; ++t) check_triangle(mesh, t);
    positions_.resize(size_t{3} * mesh.vertex_count);
    triangles_.resize(size_t{3} * mesh.triangle_count);
    regions_.resize(mesh.triangle_count);
    if (mesh.regions) std::copy_n(mesh.regions, mesh.triangle_count, regions_.begin());
    // Vertices that moved belong to changed triangles.
    const Positions positions(mesh);
    const auto take = [&](uint32_t triangle) {
        for (size_t i = size_t{3} * triangle; i < size_t{3} * triangle + 3; ++i) {
            triangles_[i] = mesh.triangles[i];
            positions.copy(triangles_[i], positions_);
        }
    };
    for (uint32_t i = 0; i < changed_count; ++i) {
        const uint32_t triangle = changed[i];
        take(triangle);
        if (triangle < changed_.size() && !changed_[triangle]) {
            changed_[triangle] = true;
            delta_.push_back(triangle);
        }
    }
    for (uint32_t triangle = known; triangle < mesh.triangle_count; ++triangle) {
        take(triangle);
        delta_.push_back(triangle);
    }
    if (delta_.empty()) return true;
    const uint32_t id = attach(&delta_);
    if (delta_id_ != RTC_INVALID_GEOMETRY_ID) rtcDetachGeometry(scene_, delta_id_);
    delta_id_ = id;
    return true;
}

SurfaceTarget::Face SurfaceTarget::face(uint32_t part, uint32_t primitive) const {
    Face face{.triangle = part == 0 ? primitive : delta_[primitive], .corners = {}};
    for (uint32_t k = 0; k < 3; ++k) {
        face.corners[k] = load(&positions_[size_t{3} * triangles_[size_t{3} * face.triangle + k]]);
    }
    return face;
}

void SurfaceTarget::describe(const Meeting& meeting, FlgHit& hit) const {
    const Face at = face(meeting.part, meeting.primitive);
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
    if (part == 0 && changed_[primitive]) return {.distance = HUGE_VALF, .meeting = {}};
    const Face at = face(part, primitive);
    const TrianglePoint found = nearest_in_triangle(point, at.corners);
    return {(found.position - point).norm(), {part, primitive, found.u, found.v, found.position, Vec3f::Zero()}};
}

}  // namespace flg::pick
