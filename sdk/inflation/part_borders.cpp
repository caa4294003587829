// SPDX-License-Identifier: MIT
#include "inflation/part_borders.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <initializer_list>
#include <memory>
#include <optional>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr double alike = 1e-3;       // by the spacing: parts whose values differ by less are one there
constexpr double near_share = 0.3;   // of an edge: vertices that are nearer to a border move onto it
constexpr double min_turn = 0.5;     // cosine: how far triangles may turn when a vertex moves
constexpr double min_breadth = 0.3;  // of a triangle's height by its longest side, after a vertex moved
constexpr uint32_t halvings = 10, newton_steps = 16;
constexpr double near_enough = 0.02 * border_tolerance;
constexpr double max_step = 0.3, max_way = 0.5;  // from the edge, by the spacing
constexpr double landing = 0.8;                  // of the tolerance: what is farther off is put onto the surface
constexpr double least_det = 0.02;               // sine squared between the surface and where parts are alike

// Shares of a triangle's corners in its point nearest to `p` (Ericson: Real-time collision detection, 2005, 5.1.5).
std::array<double, 3> nearest_shares(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - share, share};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

// Which parts a point belongs to: those that meet there.
struct Owners {
    bool has(uint32_t part) const {
        return std::find(parts.begin(), parts.begin() + count, part) != parts.begin() + count;
    }
    void add(uint32_t part) {
        if (count < parts.size() && !has(part)) parts[count++] = part;
    }
    void add(const Owners& other) {
        for (uint32_t i = 0; i < other.count; ++i) add(other.parts[i]);
    }
    bool shares(const Owners& other) const {
        return std::any_of(parts.begin(), parts.begin() + count, [&](uint32_t part) { return other.has(part); });
    }

    std::array<uint32_t, 3> parts{};
    uint32_t count = 0;
};

struct Crossing {
    double distance = HUGE_VAL;  // from the vertex
    uint32_t other = none;       // the edge's other end
};

struct BorderCut {
    BorderCut(const PartUnion& of_parts, UnionMesh of_mesh, Memory* memory)
        : parts(of_parts),
          mesh(of_mesh),
          rest(of_mesh.positions.size(), memory),
          owners(of_mesh.positions.size(), memory),
          first_corner(of_mesh.positions.size(), memory),
          nearest(of_mesh.positions.size(), memory),
          cut(3 * of_mesh.triangles.size(), memory),
          points(memory),
          point_owners(memory),
          point_samples(memory),
          origins(of_mesh.positions.size(), memory),
          point_origins(memory),
          centres(memory) {}

    void begin(uint32_t vertex) {
        Owners own;
        own.add(mesh.samples[vertex].part);
        owners[vertex] = own;
        nearest[vertex] = Crossing();
        std::construct_at(&rest[vertex], mesh.positions[vertex]);
        origins[vertex] = {{vertex, vertex, vertex}, {1, 0, 0}};
    }

    // Where along an edge between vertices of different parts these are alike; none where they are so all along.
    std::optional<double> crossing(uint32_t from, uint32_t to) const {
        const uint32_t p = owners[from].parts[0], q = owners[to].parts[0];
        const Vec3 &a = mesh.positions[from], &b = mesh.positions[to];
        double low = 0, high = 1, at_low = parts.difference(a, p, q).value, at_high = parts.difference(b, p, q).value;
        if (std::max(std::fabs(at_low), std::fabs(at_high)) < alike * mesh.spacing) return {};
        if (at_low <= 0) return 0;
        if (at_high >= 0) return 1;
        double share = 0.5;
        for (uint32_t i = 0; i < halvings; ++i) {
            share = i % 3 == 2 ? (low + high) / 2 : low + (high - low) * at_low / (at_low - at_high);
            const double value = parts.difference(a + share * (b - a), p, q).value;
            if (std::fabs(value) < near_enough * mesh.spacing) break;
            (value > 0 ? low : high) = share;
            (value > 0 ? at_low : at_high) = value;
        }
        return share;
    }

    struct Off {
        PartUnion::Sample whole;
        ImplicitPart::Sample between;
        double size() const { return std::hypot(whole.value, between.value); }
    };
    Off off(const Vec3& at, uint32_t p, uint32_t q) const { return {parts.sample(at), parts.difference(at, p, q)}; }

    // From near a border onto it: to a point nearby where the surface is, and both parts are alike. By Newton's method,
    // with shorter steps where the last one led farther away; where both are about parallel, to the surface alone.
    Vec3 settled(const Vec3& from, uint32_t p, uint32_t q, const Vec3& outwards) const {
        Vec3 at = from;
        Off here = off(at, p, q);
        double share = 1;
        for (uint32_t i = 0; i < newton_steps && here.size() > near_enough * mesh.spacing; ++i) {
            const Vec3 &f = here.whole.gradient, &g = here.between.gradient;
            const double ff = f.squaredNorm(), gg = g.squaredNorm(), fg = f.dot(g), det = ff * gg - fg * fg;
            const double whole = here.whole.value, between = here.between.value;
            if (!(ff > 0)) break;
            Vec3 step = f * (whole / ff);
            if (det > least_det * ff * gg)
                step = (f * (gg * whole - fg * between) + g * (ff * between - fg * whole)) / det;
            step *= share * std::min(1.0, max_step * mesh.spacing / step.norm());
            const Vec3 to = at - step;
            const Off there = off(to, p, q);
            if (there.size() >= here.size() || (to - from).norm() > max_way * mesh.spacing) {
                share /= 2;
                continue;
            }
            at = to;
            here = there;
            share = std::min(1.0, 2 * share);
        }
        return std::fabs(here.whole.value) > landing * border_tolerance * mesh.spacing ? landed(from, outwards) : at;
    }

    // Onto the surface alone, straight out or in: at a kink both are not found together. Where the surface is too far
    // off it stays.
    Vec3 landed(const Vec3& from, const Vec3& outwards) const {
        if (!(outwards.norm() > 0)) return from;
        const Vec3 reach = max_way * mesh.spacing * outwards.normalized();
        double low = -1, high = 1;
        const bool grows = parts.sample(from + high * reach).value > parts.sample(from + low * reach).value;
        const auto is_low = [&](double way) { return (parts.sample(from + way * reach).value < 0) == grows; };
        if (!is_low(low) || is_low(high)) return from;
        for (uint32_t i = 0; i < halvings; ++i) (is_low((low + high) / 2) ? low : high) = (low + high) / 2;
        return from + (low + high) / 2 * reach;
    }

    void find_near(uint32_t corner) {
        const TriangleVertices& t = mesh.triangles[corner / 3];
        const uint32_t a = t[corner % 3], b = t[(corner + 1) % 3];
        first_corner[a] = corner;
        if (owners[a].shares(owners[b])) return;
        const std::optional<double> share = crossing(a, b);
        if (!share) return;
        const double distance = *share * (mesh.positions[b] - mesh.positions[a]).norm();
        if (*share < near_share && distance < nearest[a].distance) nearest[a] = {distance, b};
    }

    // Calls visit(triangle, place of the vertex in it) all around a vertex.
    template <class Visit>
    void around(uint32_t vertex, const Visit& visit) const {
        uint32_t corner = first_corner[vertex];
        do {
            const uint32_t triangle = corner / 3, k = corner % 3;
            visit(triangle, k);
            // Across the side from here to the next corner, which is opposite to the one before.
            const uint32_t next = mesh.across[triangle][(k + 2) % 3];
            const TriangleVertices& n = mesh.triangles[next];
            corner = 3 * next + (n[0] == vertex ? 0 : n[1] == vertex ? 1 : 2);
        } while (corner != first_corner[vertex]);
    }

    // Where a point is, on the triangles around some vertices as they were.
    BorderOrigin origin_of(const Vec3& at, std::initializer_list<uint32_t> beside) const {
        BorderOrigin found{};
        double least = HUGE_VAL;
        for (const uint32_t vertex : beside)
            around(vertex, [&](uint32_t triangle, uint32_t) {
                const TriangleVertices& t = mesh.triangles[triangle];
                const std::array<double, 3> shares = nearest_shares(at, rest[t[0]], rest[t[1]], rest[t[2]]);
                const double off =
                    (shares[0] * rest[t[0]] + shares[1] * rest[t[1]] + shares[2] * rest[t[2]] - at).squaredNorm();
                if (!(off < least)) return;
                least = off;
                found = {t, shares};
            });
        const auto largest = std::max_element(found.shares.begin(), found.shares.end()) - found.shares.begin();
        std::swap(found.shares[0], found.shares[largest]);
        std::swap(found.vertices[0], found.vertices[largest]);
        return found;
    }

    // Whether triangles around a vertex stay what they are when it moves, and none lies along the border with all of
    // its corners.
    bool may_move(uint32_t vertex, const Vec3& to, const Owners& then) const {
        bool may = true;
        around(vertex, [&](uint32_t triangle, uint32_t k) {
            const TriangleVertices& t = mesh.triangles[triangle];
            const uint32_t b = t[(k + 1) % 3], c = t[(k + 2) % 3];
            const Vec3 &pb = mesh.positions[b], &pc = mesh.positions[c];
            const Vec3 now = (pb - mesh.positions[vertex]).cross(pc - mesh.positions[vertex]);
            const Vec3 after = (pb - to).cross(pc - to);
            const double longest =
                std::max({(pb - to).squaredNorm(), (pc - to).squaredNorm(), (pb - pc).squaredNorm()});
            const bool turns = after.dot(now) < min_turn * after.norm() * now.norm();
            const bool is_thin = after.norm() < min_breadth * longest;
            const bool lies_along =
                owners[b].count > 1 && owners[c].count > 1 && owners[b].shares(then) && owners[c].shares(then);
            may = may && !turns && !is_thin && !lies_along;
        });
        return may;
    }

    void move(uint32_t vertex) {
        const uint32_t other = nearest[vertex].other;
        if (other == none || mesh.is_fixed[vertex] || owners[vertex].shares(owners[other])) return;
        const std::optional<double> share = crossing(vertex, other);
        if (!share || *share >= near_share) return;
        Vec3& at = mesh.positions[vertex];
        const uint32_t p = owners[vertex].parts[0], q = owners[other].parts[0];
        const Vec3& outwards = mesh.samples[vertex].gradient;
        const Vec3 to = settled(at + *share * (mesh.positions[other] - at), p, q, outwards);
        if (std::fabs(parts.sample(to).value) > border_tolerance * mesh.spacing) return;
        Owners then = owners[vertex];
        then.add(q);
        if (!may_move(vertex, to, then)) return;
        at = to;
        origins[vertex] = origin_of(to, {vertex});
        owners[vertex] = then;
        mesh.samples[vertex] = parts.sample(to);
        mesh.samples[vertex].part = p;
    }

    uint32_t add_point(const Vec3& at, const Owners& own, const BorderOrigin& origin) {
        points.push_back(at);
        point_origins.push_back(origin);
        point_owners.push_back(own);
        point_samples.push_back(parts.sample(at));
        point_samples.back().part = own.parts[0];
        return static_cast<uint32_t>(mesh.positions.size() + points.size() - 1);
    }

    // Side k of a triangle, opposite to corner k; both triangles of a side get its point.
    void cut_side(uint32_t side) {
        const uint32_t triangle = side / 3, other = mesh.across[triangle][side % 3];
        if (other < triangle) return;
        cut[side] = none;
        const TriangleVertices &t = mesh.triangles[triangle], &o = mesh.triangles[other];
        const uint32_t a = t[(side + 1) % 3], b = t[(side + 2) % 3];
        const uint32_t other_side = 3 * other + (o[0] != a && o[0] != b ? 0 : o[1] != a && o[1] != b ? 1 : 2);
        cut[other_side] = none;
        if (owners[a].shares(owners[b])) return;
        const std::optional<double> share = crossing(a, b);
        if (!share) return;
        const Vec3 &pa = mesh.positions[a], &pb = mesh.positions[b];
        const double along = std::clamp(*share, 0.05, 0.95);
        const Vec3 on_edge = pa + along * (pb - pa);
        const Vec3 outwards = mesh.samples[a].gradient + mesh.samples[b].gradient;
        Owners own;
        own.add(owners[a].parts[0]);
        own.add(owners[b].parts[0]);
        const Vec3 at = settled(on_edge, own.parts[0], own.parts[1], outwards);
        // Where the surface is not near, as between parts that barely touch, the border goes around the triangles.
        if (std::fabs(parts.sample(at).value) > border_tolerance * mesh.spacing) return;
        cut[side] = cut[other_side] = add_point(at, own, origin_of(at, {a, b}));
    }

    uint32_t cuts_of(uint32_t triangle) const {
        uint32_t count = 0;
        for (uint32_t k = 0; k < 3; ++k) count += cut[3 * triangle + k] != none;
        return count;
    }

    const Vec3& at(uint32_t vertex) const {
        return vertex < mesh.positions.size() ? mesh.positions[vertex] : points[vertex - mesh.positions.size()];
    }
    const Owners& owners_of(uint32_t vertex) const {
        return vertex < mesh.positions.size() ? owners[vertex] : point_owners[vertex - mesh.positions.size()];
    }

    // What all corners have in common, else the largest in the middle.
    uint32_t part_of(const TriangleVertices& t) const {
        const Owners &a = owners_of(t[0]), &b = owners_of(t[1]), &c = owners_of(t[2]);
        uint32_t common = none, found = 0;
        for (uint32_t i = 0; i < a.count; ++i)
            if (b.has(a.parts[i]) && c.has(a.parts[i]) && ++found == 1) common = a.parts[i];
        return found == 1 ? common : parts.sample((at(t[0]) + at(t[1]) + at(t[2])) / 3).part;
    }

    void add(uint32_t a, uint32_t b, uint32_t c) {
        const TriangleVertices t = {a, b, c};
        (*out)[made] = t;
        (*out_parts)[made++] = part_of(t);
    }

    // Where three parts meet in a triangle, if the surface is near its middle. Returns how many triangles it becomes.
    uint32_t count_triangles(uint32_t triangle) {
        const uint32_t cuts = cuts_of(triangle);
        if (cuts < 3) return 1 + cuts;
        const TriangleVertices& t = mesh.triangles[triangle];
        Owners own;
        Vec3 outwards = Vec3::Zero(), middle = Vec3::Zero();
        for (uint32_t k = 0; k < 3; ++k) {
            own.add(owners[t[k]].parts[0]);
            outwards += mesh.samples[t[k]].gradient;
            middle += at(cut[3 * triangle + k]) / 3;
        }
        const Vec3 centre = landed(middle, outwards);
        const bool is_near = std::fabs(parts.sample(centre).value) <= border_tolerance * mesh.spacing;
        centres.push_back(is_near ? add_point(centre, own, origin_of(centre, {t[0], t[1], t[2]})) : none);
        return is_near ? 6 : 4;
    }

    void cut_triangle(uint32_t triangle) {
        const TriangleVertices& t = mesh.triangles[triangle];
        const uint32_t* sides = &cut[size_t{3} * triangle];
        const uint32_t cuts = cuts_of(triangle);
        if (cuts == 0) return add(t[0], t[1], t[2]);
        if (cuts == 3) {
            const uint32_t centre = centres[next_centre++];
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t before = sides[(k + 2) % 3], after = sides[(k + 1) % 3];
                if (centre == none) {
                    add(t[k], before, after);
                    continue;
                }
                add(t[k], before, centre);
                add(t[k], centre, after);
            }
            if (centre == none) add(sides[0], sides[1], sides[2]);
            return;
        }
        // The corner that is alone on its side of the border, or, with one cut, the one opposite to it.
        uint32_t k = 0;
        while ((sides[k] == none) != (cuts == 2)) ++k;
        const uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
        if (cuts == 1) {
            add(a, b, sides[k]);
            add(a, sides[k], c);
            return;
        }
        const uint32_t on_ab = sides[(k + 2) % 3], on_ca = sides[(k + 1) % 3];
        add(a, on_ab, on_ca);
        if ((at(on_ab) - at(c)).squaredNorm() < (at(on_ca) - at(b)).squaredNorm()) {
            add(on_ab, b, c);
            add(on_ab, c, on_ca);
        } else {
            add(on_ab, b, on_ca);
            add(on_ca, b, c);
        }
    }

    const PartUnion& parts;
    UnionMesh mesh;
    Buffer<Vec3> rest;
    Buffer<Owners> owners;
    Buffer<uint32_t> first_corner;
    Buffer<Crossing> nearest;
    Buffer<uint32_t> cut;  // by side, its new vertex
    std::pmr::deque<Vec3> points;
    std::pmr::deque<Owners> point_owners;
    std::pmr::deque<PartUnion::Sample> point_samples;
    Buffer<BorderOrigin> origins;
    std::pmr::deque<BorderOrigin> point_origins;
    Buffer<TriangleVertices>* out = nullptr;
    Buffer<uint32_t>* out_parts = nullptr;
    std::pmr::deque<uint32_t> centres;  // of triangles that are cut three times
    size_t next_centre = 0;
    uint32_t made = 0;  // triangles that are out
};

}  // namespace

Task<BorderedMesh> cut_at_borders(Pace& pace, const PartUnion& parts, UnionMesh mesh) {
    Memory* memory = pace.memory();
    const auto vertices = static_cast<uint32_t>(mesh.positions.size());
    const size_t sides = 3 * mesh.triangles.size();
    BorderCut cut(parts, mesh, memory);
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) { cut.begin(v); });
    co_await each(pace, sides, Cost::hundreds_of_ns, [&](uint32_t corner) { cut.find_near(corner); });
    co_await each(pace, vertices, Cost::hundreds_of_ns, [&](uint32_t v) { cut.move(v); });
    co_await each(pace, sides, Cost::hundreds_of_ns, [&](uint32_t side) { cut.cut_side(side); });

    size_t triangles = 0;
    co_await each(pace, mesh.triangles.size(), Cost::tens_of_ns,
                  [&](uint32_t t) { triangles += cut.count_triangles(t); });
    const size_t all = vertices + cut.points.size();
    BorderedMesh result{Buffer<Vec3>(all, memory), Buffer<BorderOrigin>(all, memory),
                        Buffer<PartUnion::Sample>(all, memory), Buffer<TriangleVertices>(triangles, memory),
                        Buffer<uint32_t>(triangles, memory)};
    cut.out = &result.triangles;
    cut.out_parts = &result.triangle_parts;
    co_await each(pace, mesh.triangles.size(), Cost::hundreds_of_ns, [&](uint32_t t) { cut.cut_triangle(t); });
    co_await each(pace, all, Cost::tens_of_ns, [&](uint32_t v) {
        std::construct_at(&result.positions[v], cut.at(v));
        result.origins[v] = v < vertices ? cut.origins[v] : cut.point_origins[v - vertices];
        std::construct_at(&result.samples[v], v < vertices ? mesh.samples[v] : cut.point_samples[v - vertices]);
    });
    co_return result;
}

}  // namespace flg
