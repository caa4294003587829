// SPDX-License-Identifier: MIT
// Source: Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, 2008 (double reflection, section 4).
// Tangents halve the turn between the segments that meet: a TANGENT column may be that of another curve (results of
// flgStylize carry their target's frame), and a cross section placed by it would be squashed. Normals that are asked for
// are made perpendicular, on the side that keeps the surface from crossing over itself, and carried along where they point
// along the curve. All others are carried along by double reflection, on closed curves with the twist that is left spread
// evenly over the length.
#include "io/swept_frames.h"

#include <algorithm>
#include <cmath>

namespace flg::io {

namespace {

// Below it, what is left of a vector across the tangent is rounding.
constexpr double least_across = 1e-6;
// Sine of the angle to the tangent below which a given normal says too little: beside such a point it turns about the
// curve at once.
constexpr double least_said = 0.1;

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

Vec3 any_across(const Vec3& tangent) {
    // The axis least along the tangent.
    const double x = std::abs(tangent.x), y = std::abs(tangent.y), z = std::abs(tangent.z);
    const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : (y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1});
    return normalized(axis - dot(axis, tangent) * tangent);
}

Vec3 make_across(const Vec3& normal, const Vec3& tangent) {
    const Vec3 across = normal - dot(normal, tangent) * tangent;
    return length(across) > least_across ? normalized(across) : any_across(tangent);
}

// v mirrored in the plane across `axis`.
Vec3 reflect(const Vec3& v, const Vec3& axis) {
    const double size_sq = dot(axis, axis);
    return size_sq > 0 ? v - (2 * dot(axis, v) / size_sq) * axis : v;
}

Vec3 carry(const SweptFrame& from, const SweptFrame& to) {
    const Vec3 chord = to.position - from.position;
    const Vec3 normal = reflect(from.normal, chord);
    const Vec3 tangent = reflect(from.tangent, chord);
    return make_across(reflect(normal, to.tangent - tangent), to.tangent);
}

void carry_normals(std::vector<SweptFrame>& frames, bool closed) {
    frames[0].normal = any_across(frames[0].tangent);
    for (size_t i = 1; i < frames.size(); ++i) frames[i].normal = carry(frames[i - 1], frames[i]);
    if (!closed) return;
    const SweptFrame& first = frames.front();
    const Vec3 arrived = carry(frames.back(), first);
    const double twist = std::atan2(dot(cross(arrived, first.normal), first.tangent), dot(arrived, first.normal));
    const double around = frames.back().along + length(first.position - frames.back().position);
    for (SweptFrame& frame : frames) {
        const double angle = twist * frame.along / around;
        frame.normal = std::cos(angle) * frame.normal + std::sin(angle) * cross(frame.tangent, frame.normal);
    }
}

// The frame's given normal across its tangent; zero where it points along it.
Vec3 said_normal(const CheckedView& view, const SweptFrame& frame) {
    const Vec3 given = normalized(load(view.normal.at(frame.point)));
    const Vec3 across = given - dot(given, frame.tangent) * frame.tangent;
    return length(across) > least_said ? normalized(across) : Vec3{};
}

void follow_normals(const CheckedView& view, std::vector<SweptFrame>& frames, bool closed) {
    for (SweptFrame& frame : frames) frame.normal = said_normal(view, frame);
    const auto says = [](const SweptFrame& frame) { return dot(frame.normal, frame.normal) > 0; };
    const auto first = static_cast<size_t>(std::find_if(frames.begin(), frames.end(), says) - frames.begin());
    if (first == frames.size()) return carry_normals(frames, closed);
    for (size_t i = first; i-- > 0;) frames[i].normal = carry(frames[i + 1], frames[i]);
    for (size_t i = first + 1; i < frames.size(); ++i) {
        const Vec3 carried = carry(frames[i - 1], frames[i]);
        const double side = dot(frames[i].normal, carried);
        if (!says(frames[i])) {
            frames[i].normal = carried;
        } else if (side < 0) {
            frames[i].normal = -1 * frames[i].normal;
        }
    }
}

}  // namespace

std::vector<SweptFrame> swept_frames(const CheckedView& view, uint32_t curve, Normals normals) {
    std::vector<SweptFrame> frames;
    for (size_t i = view.begin(curve); i < view.end(curve); ++i) {
        const Vec3 position = load(view.position.at(i));
        const double step = frames.empty() ? 0 : length(position - frames.back().position);
        if (!frames.empty() && step == 0) continue;
        frames.push_back({position, {}, {}, frames.empty() ? 0 : frames.back().along + step, i});
    }
    const bool closed = view.closed(curve);
    while (closed && frames.size() > 1 && length(frames.back().position - frames.front().position) == 0) {
        frames.pop_back();
    }
    if (frames.size() < 2) return {};

    const size_t count = frames.size();
    for (size_t i = 0; i < count; ++i) {
        SweptFrame& frame = frames[i];
        const bool has_before = i > 0 || closed;
        const bool has_after = i + 1 < count || closed;
        const Vec3 before = has_before ? normalized(frame.position - frames[(i + count - 1) % count].position) : Vec3{};
        const Vec3 after = has_after ? normalized(frames[(i + 1) % count].position - frame.position) : Vec3{};
        frame.tangent = normalized(before + after);
        // The curve turns back on itself: it still arrives somehow.
        if (dot(frame.tangent, frame.tangent) == 0) frame.tangent = before;
    }
    if (view.normal && normals == Normals::followed) {
        follow_normals(view, frames, closed);
    } else {
        carry_normals(frames, closed);
    }
    return frames;
}

}  // namespace flg::io
