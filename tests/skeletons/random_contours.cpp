// SPDX-License-Identifier: MIT
#include "skeletons/random_contours.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/random.h"

namespace flg::test {
namespace {

constexpr double pi = std::numbers::pi;

bool is_between(const Point2& a, const Point2& b, const Point2& p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

bool touch(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const int ac = orientation(a, b, c), ad = orientation(a, b, d), ca = orientation(c, d, a),
              cb = orientation(c, d, b);
    if (ac * ad < 0 && ca * cb < 0) return true;
    return (ac == 0 && is_between(a, b, c)) || (ad == 0 && is_between(a, b, d)) || (ca == 0 && is_between(c, d, a)) ||
           (cb == 0 && is_between(c, d, b));
}

// Turns stretches of the way around until none of its edges cross: each turn makes it shorter.
void uncross(std::vector<Point2>& ring) {
    const size_t n = ring.size();
    const auto distance = [](const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); };
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t i = 0; i + 1 < n; ++i) {
            for (size_t j = i + 2; j < n; ++j) {
                const Point2 &a = ring[i], &b = ring[i + 1], &c = ring[j], &d = ring[(j + 1) % n];
                if (distance(a, c) + distance(b, d) >= (distance(a, b) + distance(c, d)) * (1 - 1e-12)) continue;
                std::reverse(ring.begin() + static_cast<ptrdiff_t>(i) + 1,
                             ring.begin() + static_cast<ptrdiff_t>(j) + 1);
                changed = true;
            }
        }
    }
}

}  // namespace

bool is_simple(const std::vector<Point2>& ring) {
    const size_t n = ring.size();
    for (size_t i = 0; i < n; ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % n], &c = ring[(i + 2) % n];
        if (a == b) return false;
        if (orientation(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) <= 0) return false;
        for (size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j + 1 == n) continue;
            if (touch(a, b, ring[j], ring[(j + 1) % n])) return false;
        }
    }
    return n >= 3;
}

Rings random_star(uint64_t seed, uint32_t n) {
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * pi * (i + 0.8 * random_unit(seed, i, 0)) / n, radius = 0.2 + random_unit(seed, i, 1);
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return {ring};
}

Rings random_tour(uint64_t seed, uint32_t n) {
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < n; ++i) ring.push_back({random_unit(seed, i, 0), random_unit(seed, i, 1)});
    uncross(ring);
    return {ring};
}

Rings grid_tour(uint64_t seed, uint32_t n, uint32_t cells) {
    std::set<std::pair<uint32_t, uint32_t>> places;
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < n; ++i) {
        const auto place = std::pair(random_below(seed, i, 0, cells), random_below(seed, i, 1, cells));
        if (places.insert(place).second) ring.push_back({double(place.first), double(place.second)});
    }
    uncross(ring);
    return {ring};
}

Rings pixel_shape(uint64_t seed, uint32_t width, bool points_at_all) {
    const auto w = static_cast<int>(width) + 2;
    std::vector<int> filled(static_cast<size_t>(w * w), 0);
    const auto at = [&](int x, int y) -> int& { return filled[static_cast<size_t>(y * w + x)]; };
    for (int y = 1; y + 1 < w; ++y) {
        for (int x = 1; x + 1 < w; ++x) at(x, y) = random_unit(seed, static_cast<uint64_t>(y * w + x), 0) < 0.62;
    }
    // No two pixels touch at a corner only.
    for (bool changed = true; changed;) {
        changed = false;
        for (int y = 1; y + 2 < w; ++y) {
            for (int x = 1; x + 2 < w; ++x) {
                if (at(x, y) != at(x + 1, y + 1) || at(x + 1, y) != at(x, y + 1) || at(x, y) == at(x + 1, y)) continue;
                at(x, y) = at(x + 1, y) = 1;
                changed = true;
            }
        }
    }
    // The largest connected part.
    int parts = 1, largest = 2, most = 0;
    for (int i = 0; i < w * w; ++i) {
        if (filled[static_cast<size_t>(i)] != 1) continue;
        ++parts;
        int count = 0;
        std::vector<int> stack = {i};
        filled[static_cast<size_t>(i)] = parts;
        while (!stack.empty()) {
            const int c = stack.back();
            stack.pop_back();
            ++count;
            for (const int to : {c - 1, c + 1, c - w, c + w}) {
                if (filled[static_cast<size_t>(to)] != 1) continue;
                filled[static_cast<size_t>(to)] = parts;
                stack.push_back(to);
            }
        }
        if (count > most) {
            most = count;
            largest = parts;
        }
    }
    using Place = std::pair<int, int>;
    std::map<Place, Place> following;
    for (int y = 1; y + 1 < w; ++y) {
        for (int x = 1; x + 1 < w; ++x) {
            if (at(x, y) != largest) continue;
            if (at(x, y - 1) != largest) following[{x, y}] = {x + 1, y};
            if (at(x + 1, y) != largest) following[{x + 1, y}] = {x + 1, y + 1};
            if (at(x, y + 1) != largest) following[{x + 1, y + 1}] = {x, y + 1};
            if (at(x - 1, y) != largest) following[{x, y + 1}] = {x, y};
        }
    }
    Rings rings;
    while (!following.empty()) {
        // The least place of all that are left first: that of the outer ring.
        std::vector<Point2> ring;
        Place place = following.begin()->first;
        for (auto next = following.find(place); next != following.end(); next = following.find(place)) {
            ring.push_back({double(place.first), double(place.second)});
            place = next->second;
            following.erase(next);
        }
        if (!points_at_all) {
            std::vector<Point2> corners;
            for (size_t i = 0; i < ring.size(); ++i) {
                if (orientation(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]) != 0)
                    corners.push_back(ring[i]);
            }
            ring = corners;
        }
        rings.push_back(ring);
    }
    return rings;
}

Rings star_with_holes(uint64_t seed, uint32_t n, uint32_t holes_wide, uint32_t hole_points) {
    Rings rings;
    std::vector<Point2> outer;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * pi * i / n, radius = 1 + 0.5 * random_unit(seed, i, 0);
        outer.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    rings.push_back(outer);
    const double cell = 1.2 / holes_wide;
    for (uint32_t h = 0; h < holes_wide * holes_wide; ++h) {
        const double x = -0.6 + cell * (h % holes_wide + 0.5), y = -0.6 + cell * (h / holes_wide + 0.5);
        std::vector<Point2> hole;
        for (uint32_t i = 0; i < hole_points; ++i) {
            const double angle = 2 * pi * (i + 0.5 * random_unit(seed, h * 1000 + i, 1)) / hole_points;
            const double radius = cell * (0.2 + 0.25 * random_unit(seed, h * 1000 + i, 2));
            hole.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
        }
        rings.push_back(hole);
    }
    return rings;
}

Rings comb(uint32_t teeth, double tilt) {
    std::vector<Point2> ring = {{0, 0}, {2.0 * teeth - 1, 0}};
    for (uint32_t i = teeth; i-- > 0;) {
        const double x = 2.0 * i, height = 5 + tilt * i;
        ring.push_back({x + 1, height});
        ring.push_back({x, height + tilt});
        if (i > 0) {
            ring.push_back({x, 1 + tilt});
            ring.push_back({x - 1, 1});
        }
    }
    return {ring};
}

Rings gear(uint32_t teeth) {
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < 4 * teeth; ++i) {
        const double angle = 2 * pi * i / (4 * teeth), radius = i % 4 < 2 ? 1 : 0.8;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return {ring};
}

Rings even_star(uint32_t tips, double inner) {
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < 2 * tips; ++i) {
        const double angle = pi * i / tips, radius = i % 2 == 0 ? 1 : inner;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return {ring};
}

Rings spiral(uint32_t n) {
    std::vector<Point2> ring, back;
    for (uint32_t i = 0; i < n / 2; ++i) {
        const double angle = 0.4 * i, radius = 1 + 0.3 * angle;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        back.push_back({(radius - 0.8) * std::cos(angle), (radius - 0.8) * std::sin(angle)});
    }
    ring.insert(ring.end(), back.rbegin(), back.rend());
    return {ring};
}

Rings staircase(uint32_t steps) {
    std::vector<Point2> ring = {{0, 0}, {double(steps), 0}};
    for (uint32_t i = 0; i < steps; ++i) {
        const double x = steps - i, y = i + 1;
        ring.push_back({x, y});
        ring.push_back({x - 1, y});
    }
    return {ring};
}

Rings rotated(Rings rings, double angle, double scale, Point2 move) {
    const double c = std::cos(angle) * scale, s = std::sin(angle) * scale;
    for (auto& ring : rings) {
        for (Point2& p : ring) p = {c * p.x - s * p.y + move.x, s * p.x + c * p.y + move.y};
    }
    return rings;
}

Rings jittered(Rings rings, uint64_t seed, double reach) {
    for (size_t r = 0; r < rings.size(); ++r) {
        for (size_t i = 0; i < rings[r].size(); ++i) {
            rings[r][i].x += reach * (2 * random_unit(seed, r * 100'000 + i, 7) - 1);
            rings[r][i].y += reach * (2 * random_unit(seed, r * 100'000 + i, 8) - 1);
        }
    }
    return rings;
}

}  // namespace flg::test
