// SPDX-License-Identifier: MIT
#include "pick/curve_target.h"

#include <cstring>

#include "pick/nearest_point.h"

namespace flg::pick {

namespace {

struct Reader {
    const float* data = nullptr;
    size_t stride = 0;
    float factor = 1;
    const float* at(size_t point) const { return data + point * stride; }
};

Reader reader_of(const FlgCurveSetView& curves, FlgAttribute attribute, float factor = 1) {
    for (uint32_t i = 0; i < curves.column_count; ++i) {
        const FlgColumn& column = curves.columns[i];
        if (column.attribute != attribute) continue;
        return {column.data, column.stride ? column.stride / sizeof(float) : column.components, factor};
    }
    return {};
}

}  // namespace

CurveTarget::CurveTarget(RTCDevice device, RTCScene scene, RTCScene boxes, const FlgCurveSetView& curves,
                         float least_radius)
    : scene_(scene), boxes_(boxes) {
    const Reader positions = reader_of(curves, FLG_ATTRIBUTE_POSITION);
    Reader radii = reader_of(curves, FLG_ATTRIBUTE_RADIUS);
    if (!radii.data) radii = reader_of(curves, FLG_ATTRIBUTE_WIDTH, 0.5f);
    const auto add = [&](uint32_t point) {
        const float* p = positions.at(point);
        const float radius = radii.data ? std::max(least_radius, *radii.at(point) * radii.factor) : least_radius;
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
