// SPDX-License-Identifier: MIT
#include "tangles/region_specks.h"

#include <algorithm>
#include <array>

#include "runtime/each.h"

namespace flg {

namespace {

// A component, while it is looked at: its triangles, from the first one on.
class Speck {
public:
    explicit Speck(const RegionPartition& partition) : partition_(partition) {}

    // False if it turns out to be none.
    bool gather(uint32_t component, double least_area) {
        component_ = component;
        count_ = 0;
        double area = 0;
        for (uint32_t next = partition_.components[component].first_triangle, i = 0;;) {
            triangles_[count_++] = next;
            area += area_of(next);
            if (!(area < least_area)) return false;
            next = no_index;
            for (; i < count_ && next == no_index; i += next == no_index ? 1 : 0) next = one_more_beside(triangles_[i]);
            if (next == no_index) return true;
            if (count_ == triangles_.size()) return false;
        }
    }

    // Where the one beside it goes that it has the longest border with, of its leaf and of those that go somewhere;
    // no_index if there is none.
    uint32_t widest_beside(const Buffer<uint32_t>& leaf_of, const Buffer<uint32_t>& goes_to) const {
        struct Beside {
            uint32_t component;
            double border;  // metres
        };
        std::array<Beside, 3 * most_triangles> beside;
        auto end = beside.begin();
        for (uint32_t i = 0; i < 3 * count_; ++i) {
            const Corner edge = 3 * triangles_[i / 3] + i % 3;
            const uint32_t across = partition_.mesh.neighbour_at(edge);
            if (across == no_index || !partition_.is_within(across) || is_own(across)) continue;
            const uint32_t other = partition_.component_of(across), to = goes_to[other];
            if (leaf_of[other] != leaf_of[component_] || to == no_index) continue;
            const auto known = std::find_if(beside.begin(), end, [&](const Beside& b) { return b.component == to; });
            if (known == end) *end++ = {to, 0};
            known->border += length_of(edge);
        }
        const auto widest =
            std::max_element(beside.begin(), end, [](const Beside& a, const Beside& b) { return a.border < b.border; });
        return widest == end ? no_index : widest->component;
    }

private:
    static constexpr uint32_t most_triangles = 256;

    bool is_own(uint32_t triangle) const {
        return partition_.is_within(triangle) && partition_.component_of(triangle) == component_;
    }
    uint32_t one_more_beside(uint32_t triangle) const {
        const auto end = triangles_.begin() + count_;
        for (const uint32_t other : partition_.mesh.neighbours[triangle])
            if (other != no_index && is_own(other) && std::find(triangles_.begin(), end, other) == end) return other;
        return no_index;
    }
    double area_of(uint32_t triangle) const {
        const Mesh& mesh = partition_.mesh;
        const Triple& t = mesh.triangles[triangle];
        const Vec3 at = mesh.position(t[0]);
        return (mesh.position(t[1]) - at).cross(mesh.position(t[2]) - at).norm() / 2;
    }
    double length_of(Corner edge) const {
        const Mesh& mesh = partition_.mesh;
        return (mesh.position(mesh.vertex_at(next_corner(edge))) - mesh.position(mesh.vertex_at(edge))).norm();
    }

    const RegionPartition& partition_;
    uint32_t component_ = 0, count_ = 0;
    std::array<uint32_t, most_triangles> triangles_{};
};

}  // namespace

Task<Buffer<uint32_t>> merge_specks(Pace& pace, const RegionPartition& partition, const Buffer<uint32_t>& leaf_of,
                                    double least_area) {
    Buffer<uint32_t> goes_to(partition.components.size(), pace.memory());
    std::pmr::deque<uint32_t> specks(pace.memory());
    Speck speck(partition);
    co_await each(pace, goes_to.size(), Cost::tens_of_ns, [&](uint32_t c) {
        const bool is_speck = speck.gather(c, least_area);
        goes_to[c] = is_speck ? no_index : c;
        if (is_speck) specks.push_back(c);
    });
    // What lies among specks alone goes where one beside it has gone.
    for (bool again = !specks.empty(); again;) {
        again = false;
        for (const uint32_t c : specks) {
            if (goes_to[c] != no_index) continue;
            speck.gather(c, least_area);
            goes_to[c] = speck.widest_beside(leaf_of, goes_to);
            again |= goes_to[c] != no_index;
            co_await pace;
        }
    }
    co_await each(pace, specks.size(), Cost::some_ns, [&](uint32_t i) {
        if (goes_to[specks[i]] == no_index) goes_to[specks[i]] = specks[i];
    });
    co_return goes_to;
}

}  // namespace flg
