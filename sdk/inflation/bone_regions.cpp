// SPDX-License-Identifier: MIT
#include "inflation/bone_regions.h"

#include <algorithm>
#include <cmath>

#include "inflation/part_front.h"

namespace flg {
namespace {

constexpr uint32_t no_bone = PartFront::not_reached, no_triangle = UINT32_MAX;
constexpr double step_along = 0.5;    // from point to point of a bone, by the longest edge
constexpr uint32_t max_steps = 4096;  // along a bone
constexpr double outside = -1;        // barycentric: what is farther off a triangle is not at the part

double distance_to(const Point2& p, const Point2& from, const Point2& to) {
    const double x = to.x - from.x, y = to.y - from.y, length = x * x + y * y;
    const double share = length > 0 ? std::clamp(((p.x - from.x) * x + (p.y - from.y) * y) / length, 0.0, 1.0) : 0;
    return std::hypot(p.x - from.x - share * x, p.y - from.y - share * y);
}

}  // namespace

BoneRegions::BoneRegions(const PlacedPart& part) : part_(part.part) {
    const auto& m = part.placement;
    Eigen::Matrix3d matrix;
    matrix << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    to_local_ = matrix.inverse();
    origin_ = Vec3(m[3], m[7], m[11]);
}

Point2 BoneRegions::local(const Vec3& position) const {
    const Vec3 at = to_local_ * (position - origin_);
    return {at.x(), at.y()};
}

uint32_t BoneRegions::cell_of(const Point2& at) const {
    const auto place = [this](double from_low, uint32_t count) {
        return static_cast<uint32_t>(std::clamp(from_low / cell_, 0.0, count - 1.0));
    };
    return place(at.y - low_.y, rows_) * columns_ + place(at.x - low_.x, columns_);
}

// The triangle that a point is in, or that it is the least outside of.
uint32_t BoneRegions::find_triangle(const Point2& at, std::array<double, 3>& shares) const {
    uint32_t found = no_triangle;
    double best = outside;
    const uint32_t middle = cell_of(at), row = middle / columns_, column = middle % columns_;
    for (uint32_t y = row == 0 ? 0 : row - 1; y <= std::min(row + 1, rows_ - 1); ++y)
        for (uint32_t x = column == 0 ? 0 : column - 1; x <= std::min(column + 1, columns_ - 1); ++x)
            for (const uint32_t triangle : triangles_in_.of(y * columns_ + x)) {
                const TriangleVertices& t = part_->triangles[triangle];
                const Point2 &a = part_->points[t[0]], &b = part_->points[t[1]], &c = part_->points[t[2]];
                const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                const double of_b = ((at.x - a.x) * (c.y - a.y) - (at.y - a.y) * (c.x - a.x)) / twice;
                const double of_c = ((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / twice;
                const double least = std::min({1 - of_b - of_c, of_b, of_c});
                if (!(least > best)) continue;
                best = least;
                found = triangle;
                shares = {1 - of_b - of_c, of_b, of_c};
                if (least >= 0) return found;
            }
    return found;
}

BoneRegions::Found BoneRegions::at(const Vec3& position) const {
    Found out;
    std::array<double, 3> shares{};
    const uint32_t triangle = find_triangle(local(position), shares);
    if (triangle == no_triangle) return out;
    for (const uint32_t vertex : part_->triangles[triangle]) {
        const uint32_t bone = bone_of_[vertex];
        const auto end = out.bones.begin() + out.count;
        if (bone != no_bone && std::find(out.bones.begin(), end, bone) == end) out.bones[out.count++] = bone;
    }
    return out;
}

Task<BoneRegions> BoneRegions::make(Pace& pace, const PlacedPart& placed, std::span<const BoneSegment> bones,
                                    std::span<const uint32_t> own) {
    BoneRegions regions(placed);
    const InflatedPart& part = *placed.part;
    Memory* memory = pace.memory();
    const size_t vertices = part.points.size(), triangles = part.triangles.size();
    Point2 high = part.points[0];
    regions.low_ = high;
    co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t i) {
        for (uint32_t k = 0; k < 3; ++k) {
            const Point2 &p = part.points[part.triangles[i][k]], &q = part.points[part.triangles[i][(k + 1) % 3]];
            regions.cell_ = std::max(regions.cell_, distance(p, q));
            regions.low_ = {std::min(regions.low_.x, p.x), std::min(regions.low_.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    });
    // A long part across the plane has more cells than triangles: larger ones do as well.
    const double width = high.x - regions.low_.x, height = high.y - regions.low_.y;
    regions.cell_ = std::max(regions.cell_, std::sqrt(width * height / (4.0 * static_cast<double>(triangles))));
    regions.columns_ = static_cast<uint32_t>(width / regions.cell_) + 1;
    regions.rows_ = static_cast<uint32_t>(height / regions.cell_) + 1;
    regions.triangles_in_ =
        co_await group_by(pace, triangles, size_t{regions.columns_} * regions.rows_, [&](uint32_t i) {
            const TriangleVertices& t = part.triangles[i];
            const Point2 &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
            return regions.cell_of({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
        });
    const Groups corners = co_await corners_by_vertex(pace, part);
    regions.bone_of_ = Buffer<uint32_t>(vertices, memory);
    PartFront front(part, corners, regions.bone_of_, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) { front.clear(v); });
    Slice slice(Cost::hundreds_of_ns);
    for (const uint32_t number : own) {
        const Point2 from = regions.local(bones[number].from), to = regions.local(bones[number].to);
        const double count = std::ceil(distance(from, to) / (step_along * regions.cell_));
        const auto steps = static_cast<uint32_t>(std::clamp(count, 1.0, double{max_steps}));
        for (uint32_t i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            std::array<double, 3> inside{};
            const Point2 at = {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
            const uint32_t triangle = regions.find_triangle(at, inside);
            if (triangle != no_triangle && std::min({inside[0], inside[1], inside[2]}) >= 0)
                for (const uint32_t vertex : part.triangles[triangle])
                    front.offer(vertex, distance_to(part.points[vertex], from, to), number);
            if (slice.is_over()) co_await pace;
        }
    }
    while (const uint32_t work = front.advance())
        if (slice.is_over(work)) co_await pace;
    // Pairs of bones, by the first.
    std::pmr::vector<std::pair<uint32_t, uint32_t>> pairs(memory);
    regions.first_own_ = own.empty() ? 0 : own.front();
    const auto reaches = [&](const BoneSegment& bone, const Vec3& end) { return bone.from == end || bone.to == end; };
    for (const uint32_t a : own)
        for (const uint32_t b : own) {
            if (a != b && (reaches(bones[a], bones[b].from) || reaches(bones[a], bones[b].to)))
                pairs.emplace_back(a - regions.first_own_, b);
            if (slice.is_over()) co_await pace;
        }
    const size_t range = own.empty() ? 0 : own.back() - own.front() + size_t{1};
    regions.next_to_ = co_await group_by(pace, pairs.size(), range, [&](uint32_t i) { return pairs[i].first; });
    co_await each(pace, pairs.size(), Cost::some_ns,
                  [&](uint32_t i) { regions.next_to_.items[i] = pairs[regions.next_to_.items[i]].second; });
    co_return regions;
}

}  // namespace flg
