// SPDX-License-Identifier: MIT
// Source: Meisters, Polygons have ears (1975). A polygon is seen along the axis that its normal (Newell's) is closest
// to; an ear is a convex corner whose triangle holds none of the corners that are reflex or flat. The next ear is
// looked for where the last one was cut, which spreads the triangles. Invariant: n corners give n - 2 triangles, so
// that each polygon stays where its fan was. Departures: polygons that have no ear left (they cross themselves) and
// those of more than max_corners keep a fan of what is left.
#include "io/text/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/base/vec3.h"

namespace flg::io {

namespace {

constexpr uint32_t max_corners = 1024;

using Point = std::array<double, 2>;
using Uv = std::array<float, 2>;

// Twice the area, positive if counter-clockwise.
double turn(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

class EarClipper {
public:
    explicit EarClipper(MeshData& data) : data_(data) {}

    void split(const PolygonFan& fan) {
        gather(fan);
        const Vec3 normal = newell_normal();
        // Lines and knots have no inside to respect.
        if (length(normal) == 0) return;
        project(normal);
        if (is_convex()) return;
        if (fan.corners > max_corners) {
            long_.add(fan.first);
            return;
        }
        clip(fan);
    }

    void report() {
        data_.warn(long_, "triangle", "start of a concave face of more than 1024 corners, split as a fan");
        data_.warn(crossed_, "triangle", "start of a face that crosses itself");
    }

private:
    void gather(const PolygonFan& fan) {
        corners_.clear();
        const uint32_t* triangle = &data_.triangles[3 * size_t{fan.first}];
        corners_.push_back(triangle[0]);
        for (uint32_t k = 0; k + 2 < fan.corners; ++k) corners_.push_back(triangle[3 * size_t{k} + 1]);
        corners_.push_back(triangle[3 * size_t{fan.corners - 3} + 2]);
        uvs_.clear();
        // The last triangles may have none.
        if (data_.corner_uvs.size() < 6 * (size_t{fan.first} + fan.corners - 2)) return;
        const auto* uvs = reinterpret_cast<const Uv*>(data_.corner_uvs.data()) + 3 * size_t{fan.first};
        uvs_.push_back(uvs[0]);
        for (uint32_t k = 0; k + 2 < fan.corners; ++k) uvs_.push_back(uvs[3 * size_t{k} + 1]);
        uvs_.push_back(uvs[3 * size_t{fan.corners - 3} + 2]);
    }

    Vec3 position(size_t corner) const {
        const float* p = &data_.positions[3 * size_t{corners_[corner]}];
        return {p[0], p[1], p[2]};
    }

    // Twice the area in each of the three planes; from the first corner, so that far polygons keep their digits.
    Vec3 newell_normal() const {
        const Vec3 origin = position(0);
        Vec3 sum;
        for (size_t k = 1; k + 1 < corners_.size(); ++k) {
            sum = sum + cross(position(k) - origin, position(k + 1) - origin);
        }
        return sum;
    }

    void project(const Vec3& n) {
        const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
        points_.clear();
        for (size_t k = 0; k < corners_.size(); ++k) {
            const Vec3 p = position(k);
            if (z >= x && z >= y)
                points_.push_back(n.z > 0 ? Point{p.x, p.y} : Point{p.y, p.x});
            else if (y >= x)
                points_.push_back(n.y > 0 ? Point{p.z, p.x} : Point{p.x, p.z});
            else
                points_.push_back(n.x > 0 ? Point{p.y, p.z} : Point{p.z, p.y});
        }
    }

    bool is_convex() const {
        const size_t n = points_.size();
        for (size_t k = 0; k < n; ++k) {
            if (turn(points_[k], points_[(k + 1) % n], points_[(k + 2) % n]) < 0) return false;
        }
        return true;
    }

    void clip(const PolygonFan& fan) {
        uint32_t* out = &data_.triangles[3 * size_t{fan.first}];
        float* uv_out = uvs_.empty() ? nullptr : &data_.corner_uvs[6 * size_t{fan.first}];
        const auto emit = [&](size_t a, size_t b, size_t c) {
            for (size_t corner : {a, b, c}) {
                *out++ = corners_[left_[corner]];
                if (uv_out) uv_out = std::copy_n(uvs_[left_[corner]].data(), 2, uv_out);
            }
        };
        left_.resize(corners_.size());
        for (uint32_t k = 0; k < left_.size(); ++k) left_[k] = k;
        size_t at = 0;
        while (left_.size() > 3) {
            const size_t n = left_.size();
            size_t tries = 0;
            while (tries < n && !is_ear(at % n)) ++at, ++tries;
            if (tries == n) break;
            const size_t ear = at % n;
            emit((ear + n - 1) % n, ear, (ear + 1) % n);
            left_.erase(left_.begin() + static_cast<ptrdiff_t>(ear));
            at = ear + 1;
        }
        if (left_.size() > 3) crossed_.add(fan.first);
        for (size_t k = 2; k < left_.size(); ++k) emit(0, k - 1, k);
    }

    bool is_ear(size_t k) const {
        const size_t n = left_.size();
        const Point &a = points_[left_[(k + n - 1) % n]], &b = points_[left_[k]], &c = points_[left_[(k + 1) % n]];
        if (turn(a, b, c) <= 0) return false;
        for (size_t i = 0; i < n; ++i) {
            const Point& p = points_[left_[i]];
            // Corners on one of the ear's own (as where a slit closes) do not stand in its way.
            if (p == a || p == b || p == c) continue;
            const bool convex = turn(points_[left_[(i + n - 1) % n]], p, points_[left_[(i + 1) % n]]) > 0;
            if (!convex && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    MeshData& data_;
    Vector<uint32_t> corners_;  // vertices
    Vector<Uv> uvs_;            // of the corners, or empty
    Vector<Point> points_;      // of the corners
    Vector<uint32_t> left_;     // corners that are not cut off
    Tally long_, crossed_;
};

}  // namespace

void split_concave_polygons(MeshData& data) {
    EarClipper clipper(data);
    for (const PolygonFan& fan : data.fans) clipper.split(fan);
    clipper.report();
}

}  // namespace flg::io
