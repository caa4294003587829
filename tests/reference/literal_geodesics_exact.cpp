// SPDX-License-Identifier: MIT
// Windows: stretches of edges that are seen from a source along straight lines in a strip of unfolded triangles.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "reference/literal_geodesics.h"

namespace flg::literal {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-13;  // of the longest edge

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// The corner of a triangle above the edge from (0, 0) to (length, 0).
Vec2 third_corner(double length, double from_begin, double from_end) {
    const double x = (length * length + from_begin * from_begin - from_end * from_end) / (2 * length);
    return {x, std::sqrt(std::max(from_begin * from_begin - x * x, 0.0))};
}

// What is seen from one source. In the coordinates of the edge, which starts at (0, 0) and ends at (its length, 0); the
// triangle to enter is above.
struct Window {
    Corner edge;
    Vec2 source;    // unfolded; y <= 0
    double before;  // the distance from the true source to this one
    double begin, end;

    double at(double x) const { return before + std::hypot(x - source.x(), source.y()); }
    double least() const { return at(std::clamp(source.x(), begin, end)); }
};

// Begin, end, and the places between where both windows tell the same distance: at most two. (Of the roots of squared
// equations some may be no solutions, which does no harm.)
std::vector<double> ties(const Window& a, const Window& b, double begin, double end) {
    std::vector<double> places = {begin, end};
    const auto add = [&](double x) {
        if (x > begin && x < end) places.push_back(x);
    };
    // |x - a|^2 - |x - b|^2 - d^2 = 2 d |x - b|; the left side is linear in x.
    const double d = b.before - a.before;
    const double slope = 2 * (b.source.x() - a.source.x());
    const double constant = a.source.squaredNorm() - b.source.squaredNorm() - d * d;
    const double p = slope * slope - 4 * d * d;
    const double q = 2 * slope * constant + 8 * d * d * b.source.x();
    const double r = constant * constant - 4 * d * d * b.source.squaredNorm();
    const double root = std::sqrt(std::max(q * q - 4 * p * r, 0.0));
    // Each of the roots where it doesn't cancel.
    const double sum = -(q + std::copysign(root, q));
    if (p != 0) add(sum / (2 * p));
    if (sum != 0) add(2 * r / sum);
    std::sort(places.begin(), places.end());
    return places;
}

// Takes [begin, end] out of the windows.
void cut_out(std::vector<Window>& windows, double begin, double end) {
    std::vector<Window> left;
    for (const Window& window : windows) {
        Window before = window, after = window;
        before.end = std::min(window.end, begin);
        after.begin = std::max(window.begin, end);
        if (before.begin < before.end) left.push_back(before);
        if (after.begin < after.end) left.push_back(after);
    }
    windows = std::move(left);
}

class Propagation {
public:
    Propagation(const Mesh& mesh, uint32_t source)
        : mesh_(mesh), distances_(mesh.vertex_count(), infinity), bends_(mesh.vertex_count()) {
        const Corner corners = 3 * mesh.triangle_count();
        on_edge_.resize(corners);
        for (Corner edge = 0; edge < corners; ++edge) size_ = std::max(size_, length(edge));
        std::vector<double> angles(mesh.vertex_count(), 0.0);
        for (Corner corner = 0; corner < corners; ++corner) angles[mesh.vertex_at(corner)] += angle(corner);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            const bool on_border = mesh.turn_back(mesh.corner_of_vertex[v]) == no_index;
            bends_[v] = angles[v] > (on_border ? 1 : 2) * std::numbers::pi;
        }
        bends_[source] = true;
        reach(source, 0);
    }

    std::vector<double> run() {
        while (!events_.empty()) {
            const Event event = events_.top();
            events_.pop();
            if (event.vertex != no_index) {
                if (event.distance == distances_[event.vertex]) leave(event.vertex);
            } else {
                // What better windows have left of it.
                for (const Window& window : std::vector<Window>(seen_[event.seen])) cross_triangle(window);
            }
        }
        return distances_;
    }

private:
    struct Event {
        double distance;
        uint32_t vertex;  // no_index: a window
        size_t seen = 0;
        bool operator<(const Event& other) const { return distance > other.distance; }
    };

    double length(Corner edge) const {
        return (mesh_.position(mesh_.vertex_at(next_corner(edge))) - mesh_.position(mesh_.vertex_at(edge))).norm();
    }
    double angle(Corner corner) const {
        const Vec3 apex = mesh_.position(mesh_.vertex_at(corner));
        const Vec3 a = mesh_.position(mesh_.vertex_at(next_corner(corner))) - apex;
        const Vec3 b = mesh_.position(mesh_.vertex_at(previous_corner(corner))) - apex;
        return std::atan2(a.cross(b).norm(), a.dot(b));
    }

    void reach(uint32_t vertex, double distance) {
        if (distance >= distances_[vertex]) return;
        distances_[vertex] = distance;
        events_.push({distance, vertex});
    }

    // Along the edges, and, where paths may bend, across the triangles.
    void leave(uint32_t vertex) {
        const double distance = distances_[vertex];
        const Corner first = mesh_.corner_of_vertex[vertex];
        Corner corner = first;
        do {
            const Corner after = next_corner(corner), before = previous_corner(corner);
            reach(mesh_.vertex_at(after), distance + length(corner));
            reach(mesh_.vertex_at(before), distance + length(before));
            // Seen from the neighbour the edge runs from `before` to `after`.
            const Corner edge = mesh_.opposite(after);
            if (bends_[vertex] && edge != no_index) {
                const Vec2 apex = third_corner(length(edge), length(before), length(corner));
                add({edge, {apex.x(), -apex.y()}, distance, 0, length(edge)});
            }
            corner = mesh_.turn(corner);
        } while (corner != first && corner != no_index);
    }

    void cross_triangle(const Window& window) {
        const Corner after = next_corner(window.edge), before = previous_corner(window.edge);
        const Vec2 start(0, 0), end(length(window.edge), 0);
        const Vec2 top = third_corner(end.x(), length(before), length(after));
        const Vec2 left = Vec2(window.begin, 0) - window.source, right = Vec2(window.end, 0) - window.source;
        const Vec2 up = top - window.source;
        const double tolerance = rounding * size_ * up.norm();
        const bool left_of_top = cross(up, left) >= -tolerance, right_of_top = cross(right, up) >= -tolerance;
        if (left_of_top && right_of_top) reach(mesh_.vertex_at(before), window.before + up.norm());
        // Seen from the neighbours these edges run from the start to the top and from there to the end.
        if (left_of_top) pass(window, mesh_.opposite(before), start, top, &left, right_of_top ? nullptr : &right);
        if (right_of_top) pass(window, mesh_.opposite(after), top, end, left_of_top ? nullptr : &left, &right);
    }

    // On to the edge from a to b, between the rays; none: up to the edge's end.
    void pass(const Window& window, Corner edge, const Vec2& a, const Vec2& b, const Vec2* left, const Vec2* right) {
        if (edge == no_index) return;
        const double size = (b - a).norm();
        const Vec2 along = (b - a) / size, source = window.source - a;
        const auto hit = [&](const Vec2& ray) {
            const double x = cross(ray, source) / cross(ray, along);
            return std::isfinite(x) ? std::clamp(x, 0.0, size) : 0.0;
        };
        add({edge,
             {source.dot(along), std::min(cross(along, source), 0.0)},
             window.before,
             left ? hit(*left) : 0,
             right ? hit(*right) : size});
    }

    // Keeps the parts where no other window on the edge is as good, and no way over one of the edge's ends is better.
    void add(const Window& window) {
        const double tolerance = rounding * size_;
        if (window.end - window.begin <= tolerance) return;
        const double at_start = distances_[mesh_.vertex_at(window.edge)];
        const double at_end = distances_[mesh_.vertex_at(next_corner(window.edge))];
        if (window.at(window.end) > at_start + window.end + tolerance) return;
        if (window.at(window.begin) > at_end + length(window.edge) - window.begin + tolerance) return;
        std::vector<Window> parts = {window};
        for (size_t other : on_edge_[window.edge]) {
            for (const Window& old : std::vector<Window>(seen_[other])) {
                const double begin = std::max(old.begin, window.begin), end = std::min(old.end, window.end);
                if (begin >= end) continue;
                const std::vector<double> places = ties(window, old, begin, end);
                for (size_t i = 0; i + 1 < places.size(); ++i) {
                    const double middle = (places[i] + places[i + 1]) / 2;
                    const bool is_better = window.at(middle) < old.at(middle) - tolerance;
                    cut_out(is_better ? seen_[other] : parts, places[i], places[i + 1]);
                }
            }
        }
        if (parts.empty()) return;
        double least = infinity;
        for (const Window& part : parts) least = std::min(least, part.least());
        on_edge_[window.edge].push_back(seen_.size());
        events_.push({least, no_index, seen_.size()});
        seen_.push_back(std::move(parts));
    }

    const Mesh& mesh_;
    double size_ = 0;  // of the longest edge
    std::vector<double> distances_;
    std::vector<bool> bends_;                // vertices where a shortest path may turn: saddles and concave borders
    std::vector<std::vector<Window>> seen_;  // the parts that are left of each window
    std::vector<std::vector<size_t>> on_edge_;
    std::priority_queue<Event> events_;
};

}  // namespace

std::vector<double> exact_distances(const Mesh& mesh, uint32_t source) {
    return Propagation(mesh, source).run();
}

}  // namespace flg::literal
