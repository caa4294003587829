// SPDX-License-Identifier: MIT
#include "splines/spline_rows.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr double least_around = 3;  // rows of a closed curve, its end beside

// A piece from node to node, by t in [0, 1].
struct HermitePiece {
    Vec3 a, b, m, n;  // the ends, and the derivatives by t there

    Vec3 place(double t) const {
        const double s = 1 - t;
        return s * s * (1 + 2 * t) * a + t * t * (1 + 2 * s) * b + s * t * (s * m - t * n);
    }
    Vec3 derivative(double t) const {
        const double s = 1 - t;
        return 6 * s * t * (b - a) + s * (1 - 3 * t) * m + t * (3 * t - 2) * n;
    }
    // From its beginning to t, by Gauss's rule of three points.
    double length(double t) const {
        constexpr double off = 0.3872983346207417, outer = 5.0 / 18, inner = 8.0 / 18;
        return t * (outer * (derivative(t * (0.5 - off)).norm() + derivative(t * (0.5 + off)).norm()) +
                    inner * derivative(0.5 * t).norm());
    }
};

class ChainPieces {
public:
    explicit ChainPieces(const Spline& spline)
        : spline_(spline),
          nodes_(static_cast<uint32_t>(spline.chain.nodes.size() / 3)),
          count_(spline.closed ? nodes_ : nodes_ - 1) {}

    uint32_t count() const { return count_; }
    HermitePiece operator[](uint32_t i) const {
        const double h = step(i);
        return {node(i), node(i + 1), h * slope(i, true), h * slope(i + 1, false)};
    }
    double time(uint32_t i, double t) const { return spline_.chain.parameters[i] + t * step(i); }
    Vec3 normal(uint32_t i, double t) const {
        if (spline_.normals.empty()) return Vec3::Zero();
        const Vec3 a = load_vec3(&spline_.normals[size_t{3} * i]),
                   b = load_vec3(&spline_.normals[size_t{3} * ((i + 1) % nodes_)]), between = (1 - t) * a + t * b;
        return between.norm() > 0.1 ? Vec3(between.normalized()) : a;
    }
    // A corner's two ways are one between them.
    Vec3 way(uint32_t i, double t) const {
        Vec3 way = (*this)[i].derivative(t);
        if (t == 0 && has_before(i) && is_break(i % nodes_)) way = way.normalized() + slope(i, false).normalized();
        const double length = way.norm();
        return length > 0 ? Vec3(way / length) : Vec3(node(i + 1) - node(i)).normalized();
    }

private:
    Vec3 node(uint32_t i) const { return Vec3(&spline_.chain.nodes[size_t{3} * (i % nodes_)]); }
    double step(uint32_t i) const {
        i %= count_;
        return spline_.chain.parameters[i + 1] - spline_.chain.parameters[i];
    }
    bool has_before(uint32_t i) const { return spline_.closed || i > 0; }
    bool has_after(uint32_t i) const { return spline_.closed || i < count_; }
    bool is_break(uint32_t i) const { return std::binary_search(spline_.breaks.begin(), spline_.breaks.end(), i); }
    Vec3 chord(uint32_t i) const { return (node(i + 1) - node(i)) / step(i); }
    // The derivative at a node, as the piece after it or before it sees it. Where the curve ends it does not bend.
    Vec3 slope(uint32_t i, bool after) const {
        const uint32_t before = (i + count_ - 1) % count_;
        const bool ends = is_break(i % nodes_) || !has_before(i) || !has_after(i);
        if (!ends) {
            const double h = step(before), k = step(i);
            return (k * chord(before) + h * chord(i % count_)) / (h + k);
        }
        const uint32_t other = after ? i + 1 : i + nodes_ - 1;
        const bool other_ends =
            is_break(other % nodes_) || (!spline_.closed && (other % nodes_ == 0 || other % nodes_ == count_));
        const Vec3 own = chord(after ? i % count_ : before);
        return other_ends ? own : Vec3(1.5 * own - 0.5 * slope(other % nodes_, after));
    }

    const Spline& spline_;
    uint32_t nodes_, count_;
};

}  // namespace

Task<SplineRows> rows_along(Pace& pace, const Spline& spline, double spacing) {
    const ChainPieces pieces(spline);
    const uint32_t count = pieces.count();
    Buffer<double> begins(size_t{count} + 1, pace.memory());
    begins[0] = 0;
    co_await each(pace, count, Cost::hundreds_of_ns,
                  [&](uint32_t i) { begins[i + 1] = begins[i] + pieces[i].length(1); });
    SplineRows out(pace.memory());
    out.length = begins[count];
    const double least = spline.closed ? least_around : 1;
    const double wanted = spacing > 0 ? std::max(std::round(out.length / spacing), least) : count;
    if (!(wanted < max_spline_rows))
        throw Failure(FLG_ERROR_LIMIT, "desc.spacing is %g, which makes %g rows of %g m, more than the limit of 2^20",
                      spacing, wanted, out.length);
    const auto steps = static_cast<uint32_t>(wanted);
    out.rows.reserve(size_t{steps} + 1);
    uint32_t piece = 0;
    co_await each(pace, size_t{steps} + 1, Cost::hundreds_of_ns, [&](uint32_t row) {
        double t = 0;
        if (spacing > 0) {
            const double length = out.length * (static_cast<double>(row) / steps);
            const double* const after = std::upper_bound(begins.begin() + piece + 1, begins.end(), length);
            piece = std::min(count, static_cast<uint32_t>(after - begins.begin())) - 1;
            const double own = begins[piece + 1] - begins[piece], target = length - begins[piece];
            const HermitePiece at = pieces[piece];
            t = own > 0 ? std::clamp(target / own, 0.0, 1.0) : 0;
            for (uint32_t round = 0; round < 3 && t > 0 && t < 1; ++round) {
                const double speed = at.derivative(t).norm();
                if (speed > 0) t = std::clamp(t - (at.length(t) - target) / speed, 0.0, 1.0);
            }
        } else if (row == count) {
            piece = count - 1;
            t = 1;
        } else {
            piece = row;
        }
        const double along = begins[piece] + pieces[piece].length(t);
        out.rows.push_back(
            {pieces[piece].place(t), pieces.way(piece, t), pieces.normal(piece, t), along, pieces.time(piece, t)});
    });
    if (spline.closed) out.rows.back().way = out.rows.front().way;
    co_return out;
}

}  // namespace flg
