// SPDX-License-Identifier: MIT
#include "splines/surface_way.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>

#include "core/failure.h"
#include "core/vec.h"
#include "splines/manifolds/manifold_walk.h"
#include "splines/obstacles/clearance.h"

namespace flg {

namespace {

constexpr uint32_t first_cells = 32, grids = 3;  // along the surface's size; how often cells are halved
constexpr double near_middle = 0.87;             // of a cell: so far from its middle the surface may pass
constexpr double max_hop = 3;                    // cells, between points of neighbours
constexpr uint32_t max_cells = 1u << 16;         // that a search looks at
constexpr uint32_t project_work = 4;             // of Cost::microseconds
constexpr uint32_t cell_work = 8;                // evaluations

constexpr double wall_steps = 64;       // along the surface's size
constexpr double wall_half = 1.0 / 32;  // of that: so high it stands to both sides of the surface
constexpr uint32_t wall_work = 4;       // of Cost::microseconds: a step
constexpr uint32_t seek_rounds = 32;    // of a place of the surface that is inside
constexpr double least_along = 1e-3;    // of a direction: less is across the surface

using Cell = std::array<int32_t, 3>;

// The surface's point of a cell.
struct Place {
    Vec3 at, normal;
    Cell cell;
    double passed;  // metres, from the beginning
    uint32_t from;
    bool is_passed;  // by the surface
    bool is_done;
};

// The places that were looked at, by cell. Of one size, so that nothing moves as it grows.
class Places {
public:
    static Task<void> clear(Pace& pace, Places& all) {
        co_await each(pace, slots, Cost::some_ns, [&all](uint32_t i) { all.first_[i] = none; });
    }
    explicit Places(Memory* memory) : first_(slots, memory), places_(max_cells, memory) {}

    // Where a cell's place is listed, or `none`, to be set by add().
    uint32_t& find(const Cell& c) {
        uint32_t at = uint32_t(c[0]) * 73856093u ^ uint32_t(c[1]) * 19349663u ^ uint32_t(c[2]) * 83492791u;
        for (at %= slots; first_[at] != none && places_[first_[at]].cell != c;) at = (at + 1) % slots;
        return first_[at];
    }
    void add(uint32_t& where, const Place& place) {
        where = count_;
        std::construct_at(&places_[count_++], place);
    }
    Place& operator[](uint32_t i) { return places_[i]; }
    uint32_t count() const { return count_; }
    bool is_full() const { return count_ + 27 > max_cells; }

    static constexpr uint32_t none = UINT32_MAX;

private:
    static constexpr uint32_t slots = 2 * max_cells;
    Buffer<uint32_t> first_;
    Buffer<Place> places_;
    uint32_t count_ = 0;
};

// Between the pairs of a row of places, one of each pair below the surface, the other above.
struct Wall {
    explicit Wall(Memory* memory) : below(memory), above(memory) {}

    // By the signs of volumes: whether the way from a to b meets a triangle.
    static bool meets(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
        const Vec3 way = b - a, u = p - a, v = q - a, w = r - a, normal = (q - p).cross(r - p);
        const double begin = -normal.dot(u), end = normal.dot(way - u);
        if ((begin > 0) == (end > 0)) return false;
        const double uv = way.dot(u.cross(v)), vw = way.dot(v.cross(w)), wu = way.dot(w.cross(u));
        return (uv >= 0 && vw >= 0 && wu >= 0) || (uv <= 0 && vw <= 0 && wu <= 0);
    }
    bool is_crossed(const Vec3& a, const Vec3& b) const {
        const Vec3 low = a.cwiseMin(b), high = a.cwiseMax(b);
        for (size_t i = 0; i + 1 < below.size(); ++i) {
            const Vec3 &p = below[i], &q = above[i], &r = below[i + 1], &s = above[i + 1];
            const Vec3 lower = p.cwiseMin(q).cwiseMin(r.cwiseMin(s)), upper = p.cwiseMax(q).cwiseMax(r.cwiseMax(s));
            if ((lower.array() > high.array()).any() || (upper.array() < low.array()).any()) continue;
            if (meets(a, b, p, q, r) || meets(a, b, q, s, r)) return true;
        }
        return false;
    }

    std::pmr::vector<Vec3> below, above;
};

class Ground {
public:
    Ground(const Hypersurface& surface, const ObstacleSet& obstacles, double margin, Memory* memory)
        : surface_(surface),
          obstacles_(obstacles),
          margin_(margin),
          hint_(surface.hint_size(), 0.0, memory),
          walls_(memory) {}

    // The side of an obstacle, the `number`-th.
    static Task<void> build_wall(Pace& pace, Ground& of, ObstacleSide side, uint32_t number) {
        const Hypersurface& surface = of.surface_;
        Vec3 direction(side.direction.data());
        if (side.obstacle >= of.obstacles_.count() || !of.obstacles_[side.obstacle].bounded())
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "sides[%u] is of obstacle %u, which %s", number, side.obstacle,
                          side.obstacle >= of.obstacles_.count() ? "there is not" : "has no other side");
        if (!(direction.squaredNorm() > 0))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "sides[%u] has a direction without length", number);
        direction.stableNormalize();
        const auto away = [&](const Vec3& x, Vec3* outwards) {
            return of.obstacles_.evaluate(side.obstacle, x.data(), outwards ? outwards->data() : nullptr, nullptr);
        };
        // From its middle onto the surface and back into it, to and fro.
        Vec3 place(of.obstacles_[side.obstacle].core().data()), normal, outwards;
        const double depth = 0.5 * of.obstacles_[side.obstacle].core_depth();
        bool is_inside = false;
        for (uint32_t round = 0; round < seek_rounds && !is_inside; ++round) {
            if (!of.project(place, normal)) break;
            const double out = away(place, &outwards);
            is_inside = out < 0;
            if (!is_inside) place -= (out + depth) * outwards;
            co_await pace;
        }
        if (!is_inside)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "sides[%u] is of obstacle %u, which does not cut the surface near its middle", number,
                          side.obstacle);
        if (!((direction - direction.dot(normal) * normal).norm() > least_along))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "sides[%u] has a direction across the surface at obstacle %u, along it there is none", number,
                          side.obstacle);
        Wall wall(pace.memory());
        const double half = wall_half * surface.size(), step = surface.size() / wall_steps;
        ManifoldWalk walk(surface, pace.memory());
        Slice slice(Cost::microseconds);
        bool has_left = false, goes = walk.begin(place, -direction);
        for (uint32_t i = 0; goes; ++i) {
            wall.below.push_back(walk.place() - half * walk.up());
            wall.above.push_back(walk.place() + half * walk.up());
            const bool inside = away(walk.place(), nullptr) < 0;
            if (has_left && inside) {
                wall.below.resize(wall.below.size() / 2);
                wall.above.resize(wall.below.size());
                break;
            }
            has_left = has_left || !inside;
            goes = i < static_cast<uint32_t>(wall_steps) && walk.step(step);
            if (slice.is_over(wall_work)) co_await pace;
        }
        of.walls_.push_back(std::move(wall));
    }

    bool project(Vec3& at, Vec3& normal) {
        std::fill(hint_.begin(), hint_.end(), 0.0);
        double value = 0;
        if (!surface_.project(at.data(), hint_.data())) return false;
        if (!surface_.evaluate(at.data(), hint_.data(), &value, normal.data(), nullptr)) return false;
        normal.normalize();
        return true;
    }
    // Of a chord from a given point that is nearer to an obstacle than that, the other half.
    static Task<bool> is_clear(Pace& pace, const Ground& of, Vec3 a, Vec3 b) {
        Slice slice(Cost::microseconds);
        for (const Wall& wall : of.walls_) {
            if (wall.is_crossed(a, b)) co_return false;
            if (slice.is_over()) co_await pace;
        }
        const Vec3 middle = 0.5 * (a + b);
        const Vec3 begin = of.obstacles_.distance(a.data()) < of.margin_ ? middle : a,
                   end = of.obstacles_.distance(b.data()) < of.margin_ ? middle : b;
        co_return co_await flg::is_clear(pace, of.obstacles_, {begin.x(), begin.y(), begin.z()},
                                         {end.x(), end.y(), end.z()}, of.margin_);
    }

private:
    const Hypersurface& surface_;
    const ObstacleSet& obstacles_;
    double margin_;
    std::pmr::vector<double> hint_;
    std::pmr::vector<Wall> walls_;
};

struct Goal {
    double estimate;
    uint32_t place;
    bool operator<(const Goal& other) const {
        return estimate != other.estimate ? estimate > other.estimate : place > other.place;
    }
};

// From a to b over cells of this size: all places in between, or none.
Task<std::pmr::vector<Vec3>> search(Pace& pace, Ground& ground, Vec3 a, Vec3 b, double cell, Evaluations& evaluations) {
    Places places(pace.memory());
    co_await Places::clear(pace, places);
    std::priority_queue<Goal, std::pmr::vector<Goal>> open{std::less<Goal>(), std::pmr::vector<Goal>(pace.memory())};
    std::pmr::vector<Vec3> way(pace.memory());
    const auto cell_of = [&](const Vec3& at) {
        Cell c;
        for (uint32_t k = 0; k < 3; ++k) c[k] = static_cast<int32_t>(std::floor((at[k] - a[k]) / cell + 0.5));
        return c;
    };
    Vec3 normal, target_normal, target = b;
    Vec3 start = a;
    if (!ground.project(start, normal) || !ground.project(target, target_normal)) co_return way;
    places.add(places.find(cell_of(a)), {a, normal, cell_of(a), 0, Places::none, true, false});
    open.push({(b - a).norm(), 0});
    Slice slice(Cost::microseconds);
    uint32_t counted = 0;
    while (!open.empty() && !places.is_full() && !evaluations.are_spent()) {
        evaluations.spend(uint64_t{cell_work} * (places.count() - counted));
        counted = places.count();
        const uint32_t here = open.top().place;
        open.pop();
        if (places[here].is_done) continue;
        places[here].is_done = true;
        const Place at = places[here];
        bool reaches = (b - at.at).norm() <= max_hop * cell && at.normal.dot(target_normal) > 0;
        if (reaches) reaches = co_await Ground::is_clear(pace, ground, at.at, b);
        if (reaches) {
            way.push_back(b);
            for (uint32_t p = here; p != Places::none; p = places[p].from) way.push_back(places[p].at);
            std::reverse(way.begin(), way.end());
            co_return way;
        }
        for (uint32_t offset = 0; offset < 27; ++offset) {
            const Cell by = {static_cast<int32_t>(offset % 3) - 1, static_cast<int32_t>(offset / 3 % 3) - 1,
                             static_cast<int32_t>(offset / 9) - 1};
            const Cell next = {at.cell[0] + by[0], at.cell[1] + by[1], at.cell[2] + by[2]};
            uint32_t& number = places.find(next);
            if (number == Places::none) {
                const Vec3 middle = a + cell * Vec3(next[0], next[1], next[2]);
                Vec3 point = middle;
                const bool is_passed = ground.project(point, normal) && (point - middle).norm() <= near_middle * cell;
                places.add(number, {point, normal, next, HUGE_VAL, Places::none, is_passed, false});
                if (slice.is_over(project_work)) co_await pace;
            }
            Place& reached = places[number];
            if (!reached.is_passed) continue;
            const double hop = (reached.at - at.at).norm();
            if (reached.is_done || at.passed + hop >= reached.passed || hop > max_hop * cell) continue;
            if (at.normal.dot(reached.normal) <= 0) continue;
            const bool clear = co_await Ground::is_clear(pace, ground, at.at, reached.at);
            if (!clear) continue;
            reached.passed = at.passed + hop;
            reached.from = here;
            open.push({reached.passed + (b - reached.at).norm(), number});
        }
    }
    co_return way;
}

// The chord from a to b, put onto the surface in steps of a cell: its places after a, up to b. None where it is not
// clear, or leaves the surface.
Task<std::pmr::vector<Vec3>> straight_way(Pace& pace, Ground& ground, Vec3 a, Vec3 b, double cell) {
    std::pmr::vector<Vec3> way(pace.memory());
    const auto steps = static_cast<uint32_t>(std::ceil((b - a).norm() / cell));
    Vec3 last = a, normal;
    Slice slice(Cost::microseconds);
    for (uint32_t s = 1; s <= steps; ++s) {
        Vec3 at = a + (b - a) * (static_cast<double>(s) / steps);
        bool goes = (s == steps || ground.project(at, normal)) && (at - last).norm() <= max_hop * cell;
        if (goes) goes = co_await Ground::is_clear(pace, ground, last, at);
        if (!goes) {
            way.clear();
            co_return way;
        }
        way.push_back(at);
        last = at;
        if (slice.is_over(project_work)) co_await pace;
    }
    co_return way;
}

// From each place to the farthest one that a straight way leads to, by doubling and halving.
Task<std::pmr::vector<Vec3>> pull(Pace& pace, Ground& ground, const std::pmr::vector<Vec3>& way, double cell) {
    std::pmr::vector<Vec3> taut(1, way[0], pace.memory());
    const auto last = static_cast<uint32_t>(way.size()) - 1;
    for (uint32_t stand = 0; stand < last;) {
        std::pmr::vector<Vec3> farthest(1, way[stand + 1], pace.memory());
        uint32_t seen = stand + 1, unseen = 0, stride = 2;
        for (;;) {
            const uint32_t probe = unseen > 0 ? (seen + unseen) / 2 : std::min(stand + stride, last);
            if (probe <= seen) break;
            std::pmr::vector<Vec3> straight = co_await straight_way(pace, ground, way[stand], way[probe], cell);
            if (straight.empty()) {
                unseen = probe;
                continue;
            }
            seen = probe;
            stride *= 2;
            farthest = std::move(straight);
        }
        taut.insert(taut.end(), farthest.begin(), farthest.end());
        stand = seen;
    }
    co_return taut;
}

// Whether a segment's chords are.
Task<bool> is_free(Pace& pace, const Ground& ground, const FirstCurve& first, uint32_t begin, uint32_t end) {
    bool clear = true;
    for (uint32_t p = begin; clear && p + 1 < end; ++p) {
        const double* const a = &first.points[size_t{3} * p];
        clear = co_await Ground::is_clear(pace, ground, Vec3(a), Vec3(a + 3));
    }
    co_return clear;
}

}  // namespace

Task<void> lead_around(Pace& pace, const Hypersurface& surface, const ObstacleSet& obstacles,
                       std::span<const ObstacleSide> sides, double margin, GivenPoints given, FirstCurve& first,
                       Evaluations& evaluations) {
    Ground ground(surface, obstacles, margin, pace.memory());
    for (uint32_t i = 0; i < sides.size(); ++i) co_await Ground::build_wall(pace, ground, sides[i], i);
    FirstCurve around(pace.memory());
    uint32_t begin = 0;
    for (uint32_t s = 0; s < first.ends.size(); ++s) {
        const uint32_t end = first.ends[s];
        const bool clear = co_await is_free(pace, ground, first, begin, end);
        std::pmr::vector<Vec3> way(pace.memory());
        const Vec3 a(&first.points[size_t{3} * begin]), b(&first.points[size_t{3} * end - 3]);
        double cell = surface.size() / first_cells;
        for (uint32_t grid = 0; grid < grids && !clear && way.empty(); ++grid, cell *= 0.5) {
            way = co_await search(pace, ground, a, b, cell, evaluations);
            if (!way.empty()) way = co_await pull(pace, ground, way, cell);
        }
        if (!clear && way.empty() && evaluations.are_spent()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.max_evaluations, %llu, were used up before a way was found from point %u to point %u",
                          static_cast<unsigned long long>(evaluations.most()), s, (s + 1) % given.count(3));
        }
        if (!clear && way.empty()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "no way leads from point %u to point %u over the surface around the obstacles%s", s,
                          (s + 1) % given.count(3), sides.empty() ? "" : " on the sides they are to be passed");
        }
        const uint32_t skipped = s == 0 ? 0 : 1;
        if (clear) {
            const double* const points = first.points.data();
            around.points.insert(around.points.end(), points + size_t{3} * (begin + skipped), points + size_t{3} * end);
        } else {
            for (size_t p = skipped; p < way.size(); ++p)
                around.points.insert(around.points.end(), way[p].data(), way[p].data() + 3);
        }
        around.ends.push_back(static_cast<uint32_t>(around.points.size() / 3));
        begin = end - 1;
    }
    first = std::move(around);
}

}  // namespace flg
