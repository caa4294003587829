// SPDX-License-Identifier: MIT
#include "surfaces/sampling/spaced_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"
#include "runtime/each.h"

namespace flg {

namespace {

// By distance; of those equally far by a number drawn for it.
struct Vertex {
    float distance;
    uint32_t index;
    uint64_t draw;
    std::array<float, 3> place;  // from the first vertex

    bool operator<(const Vertex& other) const {
        return distance != other.distance ? distance < other.distance : draw < other.draw;
    }
};

}  // namespace

Task<std::pmr::vector<uint32_t>> choose_spaced_points(Pace& pace, const Mesh& mesh,
                                                      const Buffer<SpacedCandidate>& candidates, float spacing,
                                                      uint32_t max_count, uint64_t seed) {
    std::pmr::vector<uint32_t> points(pace.memory());
    if (candidates.empty()) co_return points;
    const size_t most = std::min(max_count, max_spaced_points);
    points.reserve(most);
    const Vec3 origin = mesh.position(candidates[0].vertex);
    Buffer<Vertex> vertices(candidates.size(), pace.memory());
    co_await each(pace, vertices.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t vertex = candidates[i].vertex;
        const Vec3 place = mesh.position(vertex) - origin;
        vertices[i] = {candidates[i].distance,
                       vertex,
                       random_bits(seed, vertex, 0),
                       {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())}};
    });
    const auto furthest = [&](const Vertex* best, uint32_t i) {
        return best == nullptr || *best < vertices[i] ? &vertices[i] : best;
    };
    const Vertex* next = nullptr;
    co_await each(pace, vertices.size(), Cost::some_ns, [&](uint32_t i) { next = furthest(next, i); });
    while (points.size() < most && next->distance >= spacing) {
        points.push_back(next->index);
        const std::array<float, 3> point = next->place;
        next = nullptr;
        co_await each(pace, vertices.size(), Cost::some_ns, [&](uint32_t i) {
            float squared = 0;
            for (uint32_t k = 0; k < 3; ++k) {
                const float along = vertices[i].place[k] - point[k];
                squared += along * along;
            }
            vertices[i].distance = std::min(vertices[i].distance, std::sqrt(squared));
            next = furthest(next, i);
        });
    }
    co_return points;
}

}  // namespace flg
