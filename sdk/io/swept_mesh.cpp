// SPDX-License-Identifier: MIT
// Ribbons: two vertices a point, at the radius on both sides along tangent x normal, facing the normal. Tubes: a ring of
// vertices a point, with normals that follow the change of the radius, and flat caps with vertices of their own at open
// ends of a radius above 0. Triangles are counter-clockwise seen from outside (from the normal's side).
// Rings stand across the tangent, so tubes get thinner in sharp corners.
#include "io/swept_mesh.h"

#include <cmath>
#include <numbers>

#include "io/failure.h"
#include "io/limits.h"
#include "io/swept_frames.h"

namespace flg::io {

namespace {

class Sweeper {
public:
    Sweeper(const CheckedView& view, const FlgCurveWriteDesc& desc) : view_(view), desc_(desc) {
        for (uint32_t k = 0; k < desc.tube_sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / desc.tube_sides;
            circle_.push_back({std::cos(angle), std::sin(angle), 0});
        }
    }

    SweptMesh sweep() {
        const bool tube = desc_.geometry == FLG_GEOMETRY_TUBE;
        for (uint32_t c = 0; c < view_.curve_count(); ++c) {
            const std::vector<SweptFrame> frames = swept_frames(view_, c, tube ? Normals::carried : Normals::followed);
            if (frames.empty()) continue;
            check_room(frames.size() * (tube ? desc_.tube_sides : 2));
            if (tube)
                add_tube(frames, view_.closed(c));
            else
                add_ribbon(frames, view_.closed(c));
        }
        return std::move(mesh_);
    }

private:
    // A vertex takes 40 bytes, its share of the triangles 24: refused before the memory is taken.
    void check_room(size_t vertices) const {
        constexpr uint64_t bytes_per_vertex = 64;
        if ((mesh_.positions.size() / 3 + vertices) * bytes_per_vertex > max_bytes) {
            fail(FLG_ERROR_LIMIT, "", "the surface takes more than the limit of 2 GiB");
        }
    }

    double radius(const SweptFrame& frame) const {
        return view_.radius ? double{*view_.radius.at(frame.point)} : double{desc_.default_radius};
    }

    uint32_t vertex_count() const { return static_cast<uint32_t>(mesh_.positions.size() / 3); }

    void add_vertex(const Vec3& position, const Vec3& normal, const SweptFrame& frame) {
        for (double value : {position.x, position.y, position.z}) mesh_.positions.push_back(static_cast<float>(value));
        for (double value : {normal.x, normal.y, normal.z}) mesh_.normals.push_back(static_cast<float>(value));
        if (!view_.color) return;
        const float* color = view_.color.at(frame.point);
        mesh_.colors.insert(mesh_.colors.end(), color, color + 4);
    }

    void add_triangle(uint32_t a, uint32_t b, uint32_t c) { mesh_.indices.insert(mesh_.indices.end(), {a, b, c}); }

    void add_ribbon(const std::vector<SweptFrame>& frames, bool closed) {
        const uint32_t first = vertex_count();
        const uint32_t count = static_cast<uint32_t>(frames.size());
        for (const SweptFrame& frame : frames) {
            const Vec3 half = radius(frame) * cross(frame.tangent, frame.normal);
            add_vertex(frame.position - half, frame.normal, frame);
            add_vertex(frame.position + half, frame.normal, frame);
        }
        for (uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
            const uint32_t a = first + 2 * i;
            const uint32_t b = first + 2 * ((i + 1) % count);
            add_triangle(a, b + 1, b);
            add_triangle(a, a + 1, b + 1);
        }
    }

    // How the radius changes along the curve.
    double slope(const std::vector<SweptFrame>& frames, size_t i, bool closed) const {
        const size_t count = frames.size();
        const size_t before = i > 0 ? i - 1 : (closed ? count - 1 : 0);
        const size_t after = i + 1 < count ? i + 1 : (closed ? 0 : count - 1);
        const double step =
            length(frames[i].position - frames[before].position) + length(frames[after].position - frames[i].position);
        return step > 0 ? (radius(frames[after]) - radius(frames[before])) / step : 0;
    }

    void add_tube(const std::vector<SweptFrame>& frames, bool closed) {
        const uint32_t first = vertex_count();
        const uint32_t sides = desc_.tube_sides;
        const uint32_t count = static_cast<uint32_t>(frames.size());
        for (uint32_t i = 0; i < count; ++i) add_ring(frames[i], slope(frames, i, closed));
        for (uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
            const uint32_t a = first + sides * i;
            const uint32_t b = first + sides * ((i + 1) % count);
            for (uint32_t k = 0; k < sides; ++k) {
                const uint32_t next = (k + 1) % sides;
                add_triangle(a + k, a + next, b + next);
                add_triangle(a + k, b + next, b + k);
            }
        }
        if (closed) return;
        add_cap(frames.front(), -1);
        add_cap(frames.back(), 1);
    }

    Vec3 across(const SweptFrame& frame, uint32_t k) const {
        return circle_[k].x * frame.normal + circle_[k].y * cross(frame.tangent, frame.normal);
    }

    void add_ring(const SweptFrame& frame, double slope) {
        for (uint32_t k = 0; k < desc_.tube_sides; ++k) {
            const Vec3 out = across(frame, k);
            add_vertex(frame.position + radius(frame) * out, normalized(out - slope * frame.tangent), frame);
        }
    }

    // `side`: -1 at the start, 1 at the end.
    void add_cap(const SweptFrame& frame, int side) {
        if (radius(frame) == 0) return;
        const uint32_t centre = vertex_count();
        const Vec3 normal = static_cast<double>(side) * frame.tangent;
        add_vertex(frame.position, normal, frame);
        for (uint32_t k = 0; k < desc_.tube_sides; ++k) {
            add_vertex(frame.position + radius(frame) * across(frame, k), normal, frame);
        }
        for (uint32_t k = 0; k < desc_.tube_sides; ++k) {
            const uint32_t a = centre + 1 + k;
            const uint32_t b = centre + 1 + (k + 1) % desc_.tube_sides;
            if (side > 0)
                add_triangle(centre, a, b);
            else
                add_triangle(centre, b, a);
        }
    }

    const CheckedView& view_;
    const FlgCurveWriteDesc& desc_;
    std::vector<Vec3> circle_;
    SweptMesh mesh_;
};

}  // namespace

SweptMesh sweep(const CheckedView& view, const FlgCurveWriteDesc& desc) {
    return Sweeper(view, desc).sweep();
}

}  // namespace flg::io
