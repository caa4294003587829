// SPDX-License-Identifier: MIT
#include "reference/literal_frames.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::literal {

namespace {

constexpr int subdivisions = 24;  // of a segment

struct Cubic {
    Vec3 p0, p1, m0, m1;

    Vec3 position(double t) const {
        return (2 * t * t * t - 3 * t * t + 1) * p0 + (t * t * t - 2 * t * t + t) * m0 +
               (3 * t * t - 2 * t * t * t) * p1 + (t * t * t - t * t) * m1;
    }
    Vec3 derivative(double t) const {
        return (6 * t * t - 6 * t) * p0 + (3 * t * t - 4 * t + 1) * m0 + (6 * t - 6 * t * t) * p1 +
               (3 * t * t - 2 * t) * m1;
    }
    // Simpson's rule.
    double length(double t) const {
        double sum = 0;
        const double h = t / subdivisions;
        for (int k = 0; k < subdivisions; ++k) {
            sum += h / 6 *
                   (derivative(k * h).norm() + 4 * derivative((k + 0.5) * h).norm() + derivative((k + 1) * h).norm());
        }
        return sum;
    }
};

std::vector<Cubic> make_cubics(const std::vector<Vec3>& given, bool closed) {
    std::vector<Vec3> p;
    for (const Vec3& q : given) {
        if (p.empty() || q != p.back()) p.push_back(q);
    }
    while (closed && p.size() > 1 && p.front() == p.back()) p.pop_back();
    const int n = static_cast<int>(p.size());
    if (n < 2) return {};
    const auto at = [&](int i) { return p[(i + n) % n]; };
    const auto is_smooth = [&](int i) {
        if (!closed && (i % n == 0 || i % n == n - 1)) return false;
        const Vec3 e0 = (at(i) - at(i - 1)).normalized(), e1 = (at(i + 1) - at(i)).normalized();
        return e0.dot(e1) >= std::cos(50 * std::numbers::pi / 180);
    };
    // Of the circle through three points: the tangent weighs the edges by each other's length.
    const auto tangent = [&](int i) -> Vec3 {
        const Vec3 d0 = at(i) - at(i - 1), d1 = at(i + 1) - at(i);
        return (d0.normalized() * d1.norm() + d1.normalized() * d0.norm()).normalized();
    };
    std::vector<Cubic> cubics;
    for (int i = 0; i < (closed ? n : n - 1); ++i) {
        const Vec3 chord = at(i + 1) - at(i);
        const Vec3 u = chord.normalized();
        const auto mirrored = [&](const Vec3& v) -> Vec3 { return 2 * v.dot(u) * u - v; };
        Vec3 t0 = u, t1 = u;
        if (is_smooth(i)) t0 = tangent(i);
        if (is_smooth(i + 1)) t1 = tangent(i + 1);
        if (is_smooth(i) && !is_smooth(i + 1)) t1 = mirrored(t0);
        if (!is_smooth(i) && is_smooth(i + 1)) t0 = mirrored(t1);
        const double m = 2 * chord.norm() / (1 + (t0.dot(u) + t1.dot(u)) / 2);
        cubics.push_back({at(i), at(i + 1), m * t0, m * t1});
    }
    return cubics;
}

}  // namespace

Vec3 transport(const std::function<Vec3(double)>& tangent, double u0, double u1, int steps, Vec3 normal) {
    for (int k = 1; k <= steps; ++k) {
        // The smallest rotation from one tangent to the next.
        const Vec3 a = tangent(u0 + (u1 - u0) * (k - 1) / steps);
        const Vec3 b = tangent(u0 + (u1 - u0) * k / steps);
        normal = Eigen::Quaterniond::FromTwoVectors(a, b) * normal;
        normal = (normal - normal.dot(b) * b).normalized();
    }
    return normal;
}

double curve_length(const std::vector<Vec3>& points, bool closed) {
    double length = 0;
    for (const Cubic& cubic : make_cubics(points, closed)) length += cubic.length(1);
    return length;
}

std::vector<FramedPoint> resample(const std::vector<Vec3>& points, bool closed, int steps, const Vec3& first_normal) {
    const std::vector<Cubic> cubics = make_cubics(points, closed);
    std::vector<double> starts{0.0};
    for (const Cubic& cubic : cubics) starts.push_back(starts.back() + cubic.length(1));
    std::vector<FramedPoint> out;
    Vec3 normal = first_normal;
    Vec3 before = cubics[0].derivative(0).normalized();
    normal = (normal - normal.dot(before) * before).normalized();
    size_t k = 0;
    const auto find_t = [&](double s) {
        double low = 0, high = 1;
        for (int bisection = 0; bisection < 45; ++bisection) {
            const double middle = (low + high) / 2;
            (starts[k] + cubics[k].length(middle) < s ? low : high) = middle;
        }
        return (low + high) / 2;
    };
    double carried_t = 0;
    for (int i = 0; i <= steps; ++i) {
        const double s = i == steps ? starts.back() : starts.back() * i / steps;
        for (;;) {
            const bool here = s < starts[k + 1] || k + 1 == cubics.size();
            const double t = here ? (i == steps ? 1.0 : find_t(s)) : 1.0;
            for (int step = 1; step <= subdivisions; ++step) {
                const double u = carried_t + (t - carried_t) * step / subdivisions;
                const Vec3 tangent = cubics[k].derivative(u).normalized();
                normal = Eigen::Quaterniond::FromTwoVectors(before, tangent) * normal;
                before = tangent;
            }
            carried_t = t;
            if (here) break;
            ++k;
            carried_t = 0;
        }
        normal = (normal - normal.dot(before) * before).normalized();
        out.push_back({cubics[k].position(carried_t), before, normal});
    }
    return out;
}

std::vector<FramedPoint> resample_polyline(const std::vector<Vec3>& points, int steps, const Vec3& first_normal) {
    std::vector<double> lengths{0.0};
    for (size_t i = 1; i < points.size(); ++i) lengths.push_back(lengths.back() + (points[i] - points[i - 1]).norm());
    std::vector<Vec3> even;
    size_t k = 0;
    for (int i = 0; i <= steps; ++i) {
        const double s = lengths.back() * i / steps;
        while (k + 2 < points.size() && lengths[k + 1] < s) ++k;
        const double t = std::min(1.0, (s - lengths[k]) / (lengths[k + 1] - lengths[k]));
        even.push_back((1 - t) * points[k] + t * points[k + 1]);
    }
    std::vector<FramedPoint> out;
    for (size_t i = 0; i < even.size(); ++i) {
        const size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, even.size() - 1);
        const Vec3 tangent = (even[after] - even[before]).normalized();
        Vec3 normal = first_normal;
        if (i > 0) normal = Eigen::Quaterniond::FromTwoVectors(out.back().tangent, tangent) * out.back().normal;
        normal = (normal - normal.dot(tangent) * tangent).normalized();
        out.push_back({even[i], tangent, normal});
    }
    return out;
}

}  // namespace flg::literal
