// SPDX-License-Identifier: MIT
#include "skeletons/skeleton_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace flg::test {
namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

struct Edge {
    Point2 from;
    Real dx, dy;  // its direction; inwards is (-dy, dx)
};

class Checker {
public:
    Checker(const Contour& contour, const StraightSkeleton& skeleton, double tolerance)
        : contour_(contour), s_(skeleton), tolerance_(tolerance), n_(contour.size()) {}

    std::vector<std::string> run() {
        measure();
        if (!check_faces_begin()) return broken_;
        check_gluing();
        check_distances();
        for (uint32_t f = 0; f < n_; ++f) check_face(f);
        check_area();
        check_upright();
        check_front();
        return broken_;
    }

private:
    void fail(const std::string& text) {
        if (broken_.size() < 8) broken_.push_back(text);
    }
    bool is_contour(uint32_t node) const { return node < n_; }
    std::vector<uint32_t> ring(uint32_t face) const {
        return {s_.face_nodes.begin() + s_.face_offsets[face], s_.face_nodes.begin() + s_.face_offsets[face + 1]};
    }
    Real x(uint32_t node) const { return s_.nodes[node].at.x; }
    Real y(uint32_t node) const { return s_.nodes[node].at.y; }
    // Along and above the edge.
    Real along(uint32_t edge, uint32_t node) const {
        const Edge& e = edges_[edge];
        return (x(node) - e.from.x) * e.dx + (y(node) - e.from.y) * e.dy;
    }
    Real above(uint32_t edge, uint32_t node) const {
        const Edge& e = edges_[edge];
        return (y(node) - e.from.y) * e.dx - (x(node) - e.from.x) * e.dy;
    }

    void measure() {
        Point2 low = contour_.points[0], high = low;
        for (uint32_t i = 0; i < n_; ++i) {
            const Point2 &a = contour_.points[i], &b = contour_.points[contour_.next(i)];
            low = {std::min(low.x, a.x), std::min(low.y, a.y)};
            high = {std::max(high.x, a.x), std::max(high.y, a.y)};
            const Real dx = Real{b.x} - a.x, dy = Real{b.y} - a.y, length = std::sqrt(dx * dx + dy * dy);
            edges_.push_back({a, dx / length, dy / length});
        }
        size_ = std::hypot(high.x - low.x, high.y - low.y);
        bound_ = tolerance_ * size_;
        pinch_ = (tolerance_ > 1e-9 ? 1e-14L : 1e-12L) * size_;
    }

    bool check_faces_begin() {
        if (s_.face_offsets.size() != n_ + 1) fail("I1 there are not as many faces as edges");
        for (const SkeletonNode& node : s_.nodes) {
            if (!std::isfinite(node.at.x) || !std::isfinite(node.at.y) || !std::isfinite(node.time))
                fail("I1 not finite");
        }
        if (!broken_.empty()) return false;
        for (uint32_t i = 0; i < s_.nodes.size(); ++i) {
            if (is_contour(i) ? !(s_.nodes[i].at == contour_.points[i] && s_.nodes[i].time == 0)
                              : !(s_.nodes[i].time > 0))
                fail("I1 node " + std::to_string(i) + " has a wrong time or place");
        }
        for (uint32_t f = 0; f < n_; ++f) {
            const auto nodes = ring(f);
            if (nodes.size() < 3 || nodes[0] != f || nodes[1] != contour_.next(f)) {
                fail("I1 face " + std::to_string(f) + " does not begin with its edge");
                return false;
            }
            if (std::count_if(nodes.begin(), nodes.end(), [&](uint32_t node) { return is_contour(node); }) != 2)
                fail("I1 face " + std::to_string(f) + " has other contour points");
        }
        return true;
    }

    void check_gluing() {
        for (uint32_t f = 0; f < n_; ++f) {
            const auto nodes = ring(f);
            for (size_t k = 0; k < nodes.size(); ++k) {
                if (!halves_.emplace(std::pair(nodes[k], nodes[(k + 1) % nodes.size()]), f).second)
                    fail("I2 a way is used twice, by face " + std::to_string(f));
            }
        }
        std::vector<uint32_t> parent(s_.nodes.size()), degree(s_.nodes.size());
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](uint32_t i) {
            while (parent[i] != i) i = parent[i];
            return i;
        };
        size_t open = 0, arcs = 0, components = s_.nodes.size();
        for (const auto& [way, face] : halves_) {
            const auto [a, b] = way;
            const auto back = halves_.find({b, a});
            if (back == halves_.end()) {
                ++open;
                if (!is_contour(a) || !is_contour(b)) fail("I2 an arc of one face only");
                continue;
            }
            if (back->second == face) fail("I2 face " + std::to_string(face) + " is on both sides of an arc");
            ++degree[a];
            if (a > b) continue;
            ++arcs;
            if (root(a) != root(b)) {
                parent[root(a)] = root(b);
                --components;
            }
        }
        if (open != n_) fail("I2 " + std::to_string(open) + " open sides");
        if (components != 1) fail("I3 the arcs have " + std::to_string(components) + " parts");
        if (arcs + 2 != s_.nodes.size() + contour_.ring_count()) fail("I3 there are " + std::to_string(arcs) + " arcs");
        if (s_.arcs.size() != arcs) fail("I2 the arcs are not those of the faces");
        for (const SkeletonArc& arc : s_.arcs) {
            const auto left = halves_.find({arc.a, arc.b}), right = halves_.find({arc.b, arc.a});
            if (left == halves_.end() || right == halves_.end() || left->second != arc.left ||
                right->second != arc.right)
                fail("I2 an arc is not of the faces it names");
            if (s_.nodes[arc.a].time > s_.nodes[arc.b].time + static_cast<double>(bound_))
                fail("I2 an arc goes back in time");
        }
        for (uint32_t i = 0; i < degree.size(); ++i) {
            if (is_contour(i) ? degree[i] != 1 : degree[i] < 2)
                fail("I3 node " + std::to_string(i) + " has " + std::to_string(degree[i]) + " arcs");
        }
    }

    void check_distances() {
        for (uint32_t f = 0; f < n_; ++f) {
            for (const uint32_t node : ring(f))
                worst_ = std::max(worst_, std::fabs(above(f, node) - s_.nodes[node].time));
        }
        if (worst_ > bound_)
            fail("I4 a node is off by " + std::to_string(static_cast<double>(worst_ / size_) * 1e9) + "e-9 L");
        // What the result says of itself holds; rounding when it is scaled back is of the coordinates.
        Real reach = 0;
        for (const Point2& p : contour_.points) reach = std::max({reach, std::fabs(Real{p.x}), std::fabs(Real{p.y})});
        if (worst_ > Real{s_.residual} * size_ * 1.01L + 1e-15L * size_ + 4e-16L * reach)
            fail("I4 the residual is understated");
    }

    void check_face(uint32_t f) {
        const auto nodes = ring(f);
        const size_t count = nodes.size();
        std::vector<Real> s(count), t(count);
        Real area = 0;
        for (size_t i = 0; i < count; ++i) {
            s[i] = along(f, nodes[i]);
            t[i] = above(f, nodes[i]);
        }
        for (size_t i = 0; i < count; ++i) area += s[i] * t[(i + 1) % count] - s[(i + 1) % count] * t[i];
        area_ += std::fabs(area) / 2;
        if (!(area > 0)) fail("I5 face " + std::to_string(f) + " has no area");
        const auto lowest = static_cast<size_t>(std::min_element(s.begin(), s.end()) - s.begin());
        const auto highest = static_cast<size_t>(std::max_element(s.begin(), s.end()) - s.begin());
        Real back = 0, reached = s[lowest];
        for (size_t i = lowest; i != highest; i = (i + 1) % count) {
            reached = std::max(reached, s[i]);
            back = std::max(back, reached - s[(i + 1) % count]);
        }
        reached = s[highest];
        for (size_t i = highest; i != lowest; i = (i + 1) % count) {
            reached = std::min(reached, s[i]);
            back = std::max(back, s[(i + 1) % count] - reached);
        }
        if (back > 10 * bound_) fail("I5 face " + std::to_string(f) + " is not monotone");
        check_simple(f, s, t);
        for (size_t i = 0; i < count; ++i) check_pinched(f, nodes, s, t, i);
    }

    void check_simple(uint32_t f, const std::vector<Real>& s, const std::vector<Real>& t) {
        const size_t count = s.size();
        const auto off = [&](size_t a, size_t b, size_t c) {
            const Real length = std::hypot(s[b] - s[a], t[b] - t[a]);
            return length > 0 ? ((s[b] - s[a]) * (t[c] - t[a]) - (t[b] - t[a]) * (s[c] - s[a])) / length : 0;
        };
        const auto parted = [&](Real a, Real b) { return (a > bound_ && b < -bound_) || (a < -bound_ && b > bound_); };
        for (size_t i = 0; i < count; ++i) {
            for (size_t j = i + 2; j < count; ++j) {
                if (i == 0 && j + 1 == count) continue;
                const size_t i2 = i + 1, j2 = (j + 1) % count;
                if (parted(off(i, i2, j), off(i, i2, j2)) && parted(off(j, j2, i), off(j, j2, i2))) {
                    fail("I5 face " + std::to_string(f) + " is not simple");
                    return;
                }
            }
        }
    }

    void check_pinched(uint32_t f, const std::vector<uint32_t>& nodes, const std::vector<Real>& s,
                       const std::vector<Real>& t, size_t i) {
        if (is_contour(nodes[i])) return;
        const size_t count = nodes.size();
        for (size_t j = 0; j < count; ++j) {
            const size_t k = (j + 1) % count;
            if (j == i || k == i) continue;
            const Real ds = s[k] - s[j], dt = t[k] - t[j], length = std::hypot(ds, dt);
            if (length == 0) continue;
            const Real at = ((s[i] - s[j]) * ds + (t[i] - t[j]) * dt) / length;
            if (at < 1e-6L * size_ || length - at < 1e-6L * size_) continue;
            if (std::fabs((s[i] - s[j]) * dt - (t[i] - t[j]) * ds) / length < pinch_)
                fail("I9 face " + std::to_string(f) + " is pinched");
        }
    }

    void check_area() {
        Real area = 0;
        for (uint32_t i = 0; i < n_; ++i) {
            const Point2 &o = contour_.points[0], &a = contour_.points[i], &b = contour_.points[contour_.next(i)];
            area += ((Real{a.x} - o.x) * (Real{b.y} - o.y) - (Real{a.y} - o.y) * (Real{b.x} - o.x)) / 2;
        }
        if (std::fabs(area_ - area) > 10 * Real{tolerance_} * area) fail("I6 the areas do not add up");
    }

    void check_upright() {
        for (const auto& [way, face] : halves_) {
            const auto [a, b] = way;
            const auto back = halves_.find({b, a});
            if (a > b || back == halves_.end()) continue;
            const Edge &e = edges_[face], &other = edges_[back->second];
            const Real sine = std::fabs(e.dx * other.dy - e.dy * other.dx);
            if (sine >= 1e-5L || e.dx * other.dx + e.dy * other.dy <= 0) continue;
            const Real slant = std::fabs(along(face, b) - along(face, a)),
                       rise = std::fabs(above(face, b) - above(face, a));
            if (slant - 2 * sine * rise > 100 * bound_) fail("I8 an arc between edges on one line is not upright");
        }
    }

    // At each corner of a face, with arcs shorter than 1e-7 L contracted, from arc b counter-clockwise to arc a: of
    // two rising arcs with less than a half turn between them something unswept would be left; so would be of two
    // that do not rise with more.
    void check_front() {
        const Real shortest = std::max(1e-7L * size_, 10 * bound_);
        std::vector<uint32_t> parent(s_.nodes.size());
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](uint32_t i) {
            while (parent[i] != i) i = parent[i];
            return i;
        };
        for (const SkeletonArc& arc : s_.arcs) {
            if (is_contour(arc.a) || std::hypot(x(arc.a) - x(arc.b), y(arc.a) - y(arc.b)) >= shortest) continue;
            if (root(arc.a) != root(arc.b)) parent[root(arc.a)] = root(arc.b);
        }
        for (uint32_t f = 0; f < n_; ++f) {
            std::vector<uint32_t> nodes;
            for (const uint32_t node : ring(f)) {
                if (nodes.empty() || nodes.back() != root(node)) nodes.push_back(root(node));
            }
            while (nodes.size() > 1 && nodes.front() == nodes.back()) nodes.pop_back();
            if (nodes.size() < 3) continue;
            for (size_t i = 0; i < nodes.size(); ++i)
                check_corner(f, nodes[i], nodes[(i + 1) % nodes.size()], nodes[(i + nodes.size() - 1) % nodes.size()],
                             shortest);
        }
    }

    void check_corner(uint32_t f, uint32_t at, uint32_t b, uint32_t a, Real shortest) {
        if (is_contour(at) || a == b) return;
        const Edge& e = edges_[f];
        const Real bx = x(b) - x(at), by = y(b) - y(at), ax = x(a) - x(at), ay = y(a) - y(at);
        const Real b_length = std::hypot(bx, by), a_length = std::hypot(ax, ay);
        const Real b_rise = (by * e.dx - bx * e.dy) / b_length, a_rise = (ay * e.dx - ax * e.dy) / a_length;
        Real angle = std::atan2(bx * ay - by * ax, bx * ax + by * ay);
        if (angle < 0) angle += 2 * pi;
        if (angle > 2 * pi - 1e-3L) angle = 0;
        const Real level = 1e-6L + 2 * shortest / std::min(a_length, b_length);
        if (std::fabs(b_rise) <= level && !is_contour(b) && (bx * e.dx + by * e.dy) / b_length > 0.5L)
            fail("I7 a level arc runs along the edge of face " + std::to_string(f));
        if (std::fabs(b_rise) <= level || std::fabs(a_rise) <= level) return;
        const bool b_rises = b_rise > 0, a_rises = a_rise > 0;
        if (a_rises && b_rises && angle < pi - level) fail("I7 two arcs rise in face " + std::to_string(f));
        if (!a_rises && !b_rises && angle > pi + level) fail("I7 no arc rises in face " + std::to_string(f));
    }

    const Contour& contour_;
    const StraightSkeleton& s_;
    double tolerance_;
    uint32_t n_;
    std::vector<Edge> edges_;
    Real size_ = 0, bound_ = 0, pinch_ = 0, area_ = 0, worst_ = 0;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> halves_;
    std::vector<std::string> broken_;
};

}  // namespace

std::vector<std::string> broken_invariants(const Contour& contour, const StraightSkeleton& skeleton, double tolerance) {
    return Checker(contour, skeleton, tolerance).run();
}

}  // namespace flg::test
