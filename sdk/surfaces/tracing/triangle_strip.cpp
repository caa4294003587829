// SPDX-License-Identifier: MIT
#include "surfaces/tracing/triangle_strip.h"

#include <algorithm>
#include <deque>
#include <queue>

#include "runtime/each.h"

namespace flg {

namespace {

struct Visit {
    double way = HUGE_VAL;  // metres from the start
    uint32_t before = no_index;
    bool is_settled = false;
};

// One a triangle, in pages that are made when one of theirs is asked for.
class Visits {
public:
    Visits(uint32_t triangles, Memory* memory)
        : memory_(memory), pages_(triangles / page_size + 1, std::pmr::polymorphic_allocator<>(memory)) {}

    Visit& operator[](uint32_t triangle) {
        std::pmr::vector<Visit>& page = pages_[triangle / page_size];
        if (page.empty()) page = std::pmr::vector<Visit>(page_size, memory_);
        return page[triangle % page_size];
    }

private:
    static constexpr uint32_t page_size = 512;  // 12 kB

    Memory* memory_;
    std::pmr::vector<std::pmr::vector<Visit>> pages_;
};

struct Candidate {
    double bound;  // metres, of the whole way over this triangle
    uint32_t triangle;

    friend bool operator<(const Candidate& a, const Candidate& b) {  // the least one is first in a queue
        return a.bound > b.bound || (a.bound == b.bound && a.triangle > b.triangle);
    }
};

Vec3 centroid(const Mesh& mesh, uint32_t triangle) {
    const Triple& t = mesh.triangles[triangle];
    return (mesh.position(t[0]) + mesh.position(t[1]) + mesh.position(t[2])) / 3;
}

// The triangles that a place belongs to.
template <class Visitor>
void for_triangles_around(const Mesh& mesh, const SurfacePlace& place, Visitor visit) {
    if (place.on == SurfacePlace::On::triangle) return visit(place.index);
    if (place.on == SurfacePlace::On::edge) {
        visit(triangle_of(place.index));
        if (mesh.neighbour_at(place.index) != no_index) visit(mesh.neighbour_at(place.index));
        return;
    }
    const Corner first = mesh.corner_of_vertex[place.index];
    Corner corner = first;
    do {
        visit(triangle_of(corner));
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
}

Vec3 position_of_place(const Mesh& mesh, const SurfacePlace& place) {
    Vec3 position = Vec3::Zero();
    bool known = false;
    for_triangles_around(mesh, place, [&](uint32_t triangle) {
        SurfacePoint point{};
        if (known || !find_in(mesh, place, triangle, point)) return;
        position = position_of(mesh, point);
        known = true;
    });
    return position;
}

}  // namespace

Task<std::pmr::vector<uint32_t>> find_strip(Pace& pace, const Mesh& mesh, const RegionSet& regions, SurfacePlace from,
                                            SurfacePlace to) {
    std::pmr::vector<uint32_t> strip(pace.memory());
    Visits visits(mesh.triangle_count(), pace.memory());
    std::priority_queue<Candidate, std::pmr::deque<Candidate>> queue(std::less<Candidate>(),
                                                                     std::pmr::deque<Candidate>(pace.memory()));
    const Vec3 start = position_of_place(mesh, from), end = position_of_place(mesh, to);
    const auto reach = [&](uint32_t triangle, uint32_t before, double way, const Vec3& at) {
        Visit& visit = visits[triangle];
        if (way >= visit.way) return;
        visit.way = way;
        visit.before = before;
        queue.push({way + (end - at).norm(), triangle});
    };
    for_triangles_around(mesh, from, [&](uint32_t triangle) {
        if (!regions.contains(mesh.regions[triangle])) return;
        const Vec3 at = centroid(mesh, triangle);
        reach(triangle, no_index, (at - start).norm(), at);
    });
    Slice slice(Cost::hundreds_of_ns);
    uint32_t last = no_index;
    while (!queue.empty()) {
        const uint32_t triangle = queue.top().triangle;
        queue.pop();
        if (slice.is_over()) co_await pace;
        Visit& visit = visits[triangle];
        if (std::exchange(visit.is_settled, true)) continue;
        SurfacePoint unused{};
        if (find_in(mesh, to, triangle, unused)) {
            last = triangle;
            break;
        }
        const Vec3 at = centroid(mesh, triangle);
        for (const uint32_t next : mesh.neighbours[triangle]) {
            if (next == no_index || !regions.contains(mesh.regions[next])) continue;
            const Vec3 there = centroid(mesh, next);
            reach(next, triangle, visit.way + (there - at).norm(), there);
        }
    }
    for (; last != no_index; last = visits[last].before) {
        strip.push_back(last);
        if (slice.is_over()) co_await pace;
    }
    std::reverse(strip.begin(), strip.end());
    co_return strip;
}

}  // namespace flg
