// SPDX-License-Identifier: MIT
// How a crossed triangle is split, once its edges have their points.
#include <cmath>
#include <limits>

#include "surfaces/cut_isolines.h"

namespace flg {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

}  // namespace

// Of what lies in a crossed triangle with all its values between two levels.
uint32_t IsolineCutter::label_of(uint32_t triangle, const Triple& vertices) const {
    const RegionLevels* listed = levels_.find(mesh_.regions[triangle]);
    if (listed == nullptr) return mesh_.regions[triangle];
    float low = infinite, high = -infinite;
    for (uint32_t vertex : vertices) {
        if (!std::isfinite(value(vertex))) return listed->label_above(levels_.count());
        low = std::min(low, value(vertex));
        high = std::max(high, value(vertex));
    }
    return listed->label_above(levels_.interval(low, high));
}

// Appends the corner `to` and the points on the way to it from the corner `from`.
void IsolineCutter::climb(const CutTriangle& slot, uint32_t from, uint32_t to,
                          std::pmr::vector<Strip::Point>& chain) const {
    const uint32_t k = to == (from + 1) % 3 ? from : to;
    const CutTriangle::Edge& edge = slot.edges[k];
    for (uint32_t i = 0; i < edge.points; ++i)
        chain.push_back({edge.first_vertex + i, k, value(edge.first_vertex + i)});
    const uint32_t end = mesh_.triangles[slot.triangle][to];
    chain.push_back({end, k, value(end)});
}

// From the lowest corner to the highest, one chain straight, the other through the third corner.
void IsolineCutter::strip_between_levels(const CutTriangle& slot) {
    const Triple& vertices = mesh_.triangles[slot.triangle];
    std::array<uint32_t, 3> corner{0, 1, 2};
    std::sort(corner.begin(), corner.end(), [&](uint32_t a, uint32_t b) {
        return value(vertices[a]) != value(vertices[b]) ? value(vertices[a]) < value(vertices[b]) : a < b;
    });
    const auto [low, middle, high] = corner;
    const bool middle_right = middle == (low + 1) % 3;
    auto& straight = middle_right ? strip_.left : strip_.right;
    auto& bent = middle_right ? strip_.right : strip_.left;
    const auto edge_between = [](uint32_t a, uint32_t b) { return b == (a + 1) % 3 ? a : b; };
    strip_.first_edge = edge_between(low, middle);
    strip_.last_edge = edge_between(middle, high);

    straight.push_back({vertices[low], 0, value(vertices[low])});
    climb(slot, low, high, straight);
    if (value(vertices[low]) == value(vertices[middle])) {
        bent.push_back({vertices[middle], 0, value(vertices[middle])});
    } else {
        bent.push_back(straight.front());
        climb(slot, low, middle, bent);
    }
    if (value(vertices[middle]) != value(vertices[high])) climb(slot, middle, high, bent);
    strip_.triangulate(mesh_, 0, pieces_);
    for (uint32_t i = 0; i < pieces_.size(); ++i) {
        pieces_.regions[i] = label_of(slot.triangle, pieces_.triangles[i]);
    }
}

// A triangle that is not cut, but some of its edges are: from a corner along both edges there, then to the third.
void IsolineCutter::strip_beside_cuts(const CutTriangle& slot) {
    const Triple& vertices = mesh_.triangles[slot.triangle];
    // Points by how far they are from the corner.
    const auto leave = [&](uint32_t to, uint32_t k, std::pmr::vector<Strip::Point>& chain) {
        const float from = value(vertices[0]);
        const CutTriangle::Edge& edge = slot.edges[k];
        const bool rising = from < value(vertices[to]);
        chain.push_back({vertices[0], 0, 0});
        for (uint32_t i = 0; i < edge.points; ++i) {
            const uint32_t vertex = edge.first_vertex + (rising ? i : edge.points - 1 - i);
            chain.push_back({vertex, k, (value(vertex) - from) / (value(vertices[to]) - from)});
        }
        chain.push_back({vertices[to], k, 1});
    };
    leave(1, 0, strip_.right);
    leave(2, 2, strip_.left);
    strip_.first_edge = no_index;
    strip_.last_edge = 1;
    strip_.triangulate(mesh_, label_of(slot.triangle, vertices), pieces_);
    const CutTriangle::Edge& far = slot.edges[1];
    const bool rising = value(vertices[1]) < value(vertices[2]);
    fan_last_piece(pieces_, 1, rising ? far.first_vertex : far.first_vertex + far.points - 1, far.points,
                   rising ? 1 : -1);
}

void IsolineCutter::split(CutTriangle& slot) {
    if (slot.edges[0].points + slot.edges[1].points + slot.edges[2].points == 0) {
        edit_.set_region(mesh_, slot.triangle, label_of(slot.triangle, mesh_.triangles[slot.triangle]));
        return;
    }
    strip_.left.clear();
    strip_.right.clear();
    pieces_.clear();
    may_cut(slot.triangle) ? strip_between_levels(slot) : strip_beside_cuts(slot);
    writer_.write(slot, pieces_);
}

}  // namespace flg
