// SPDX-License-Identifier: MIT
#include "skeletons/contour.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace flg::studio {
namespace {

constexpr double kEnds = 0.2;                // of the path, on either side, where its ends may overshoot each other
constexpr size_t kFewest = 24, kMost = 600;  // points of a ring
constexpr double kMinLength = 12.0, kMinHalfWidth = 0.75;  // spacings
constexpr size_t kMaxTried = 4000;                         // points that are tried for crossings, each with each

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Where two edges cross, touching ends left out.
std::optional<glm::dvec2> crossing(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    const glm::dvec2 ab = b - a, cd = d - c;
    const double turn = cross(ab, cd);
    if (turn == 0.0) return std::nullopt;
    const double s = cross(c - a, cd) / turn, t = cross(c - a, ab) / turn;
    if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return std::nullopt;
    return a + s * ab;
}

std::vector<double> lengths_along(std::span<const glm::dvec2> path) {
    std::vector<double> lengths(path.size(), 0.0);
    for (size_t i = 1; i < path.size(); ++i) lengths[i] = lengths[i - 1] + glm::distance(path[i - 1], path[i]);
    return lengths;
}

// Without what its ends overshoot each other by.
std::vector<glm::dvec2> without_overshoot(const std::vector<glm::dvec2>& path) {
    const std::vector<double> along = lengths_along(path);
    const double whole = along.back();
    double least = whole;
    std::vector<glm::dvec2> best = path;
    for (size_t i = 0; i + 1 < path.size() && along[i] < kEnds * whole; ++i) {
        for (size_t j = path.size() - 2; j > i + 1 && along[j + 1] > (1.0 - kEnds) * whole; --j) {
            const auto at = crossing(path[i], path[i + 1], path[j], path[j + 1]);
            const double cut = along[i] + whole - along[j];
            if (!at || cut >= least) continue;
            least = cut;
            best.assign(path.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        path.begin() + static_cast<std::ptrdiff_t>(j) + 1);
            best.push_back(*at);
        }
    }
    return best;
}

Ring resampled(std::vector<glm::dvec2> path, size_t count) {
    path.push_back(path.front());
    const std::vector<double> along = lengths_along(path);
    Ring ring;
    size_t edge = 0;
    for (size_t k = 0; k < count; ++k) {
        const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(count);
        while (along[edge + 1] < wanted) ++edge;
        const double length = along[edge + 1] - along[edge];
        ring.push_back(glm::mix(path[edge], path[edge + 1], length > 0.0 ? (wanted - along[edge]) / length : 0.0));
    }
    return ring;
}

Ring smoothed(const Ring& ring) {
    Ring out(ring.size());
    const size_t n = ring.size();
    for (size_t i = 0; i < n; ++i) out[i] = 0.25 * ring[(i + n - 1) % n] + 0.5 * ring[i] + 0.25 * ring[(i + 1) % n];
    return out;
}

// Across the direction that it is longest in; not of its area, which is 0 where loops turn both ways.
double half_width_of(const Ring& ring) {
    glm::dvec2 mean(0.0);
    for (const glm::dvec2& p : ring) mean += p / static_cast<double>(ring.size());
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const glm::dvec2& p : ring) {
        const glm::dvec2 d = (p - mean) / std::sqrt(static_cast<double>(ring.size()));
        xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
    }
    const double across = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
    return std::sqrt(std::max(across, 0.0));
}

}  // namespace

Ring ring_of_path(std::span<const glm::dvec2> path, double spacing) {
    std::vector<glm::dvec2> points;
    for (const glm::dvec2& p : path)
        if (points.empty() || glm::distance(p, points.back()) > 0.25 * spacing) points.push_back(p);
    if (points.size() < 3) return {};
    points = without_overshoot(points);
    const double length = length_of(points);
    if (points.size() < 3 || length < kMinLength * spacing) return {};
    const auto count = std::clamp(static_cast<size_t>(length / spacing), kFewest, kMost);
    Ring ring = smoothed(smoothed(resampled(points, count)));
    if (half_width_of(ring) < kMinHalfWidth * spacing) return {};
    return ring;
}

double area_of(const Ring& ring) {
    double sum = 0.0;
    for (size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]);
    return 0.5 * std::abs(sum);
}

double length_of(const Ring& ring) {
    double sum = 0.0;
    for (size_t i = 0; i < ring.size(); ++i) sum += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
    return sum;
}

glm::dvec2 centre_of(const Ring& ring) {
    if (ring.empty()) return {0.0, 0.0};
    glm::dvec2 sum(0.0), mean(0.0);
    double doubled = 0.0;
    for (size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
        sum += cross(a, b) * (a + b);
        doubled += cross(a, b);
        mean += a / static_cast<double>(ring.size());
    }
    const double length = length_of(ring);
    return ring[0] + (std::abs(doubled) > 1e-9 * length * length ? sum / (3.0 * doubled) : mean);
}

double radius_of(const Ring& ring) {
    const double length = length_of(ring);
    return length > 0.0 ? 1.3 * area_of(ring) / length : 0.0;
}

bool is_inside(const Ring& ring, const glm::dvec2& point) {
    bool inside = false;
    for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const glm::dvec2 &a = ring[i], &b = ring[j];
        if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

std::vector<glm::dvec2> crossings_of(const Contour& contour, size_t most) {
    struct Edge {
        glm::dvec2 a, b;
        size_t ring, number, count;
    };
    std::vector<Edge> edges;
    for (size_t r = 0; r < contour.rings.size(); ++r) {
        const Ring& ring = contour.rings[r];
        for (size_t i = 0; i < ring.size(); ++i)
            edges.push_back({ring[i], ring[(i + 1) % ring.size()], r, i, ring.size()});
    }
    std::vector<glm::dvec2> places;
    if (edges.size() > kMaxTried) return places;
    for (size_t i = 0; i < edges.size() && places.size() < most; ++i) {
        for (size_t j = i + 1; j < edges.size() && places.size() < most; ++j) {
            const Edge &e = edges[i], &f = edges[j];
            const bool are_neighbours =
                e.ring == f.ring && (f.number == e.number + 1 || (e.number == 0 && f.number + 1 == e.count));
            if (are_neighbours) continue;
            if (const auto at = crossing(e.a, e.b, f.a, f.b)) places.push_back(*at);
        }
    }
    return places;
}

}  // namespace flg::studio
