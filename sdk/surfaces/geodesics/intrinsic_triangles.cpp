// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/intrinsic_triangles.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "surfaces/mesh/fan_walk.h"

namespace flg {

namespace {

// The cosine of 1.23 half turns.
constexpr double cosine_max = -0.75;
// Of one triangle: rounding must not let two flips undo each other forever.
constexpr uint32_t max_flips = 200;
constexpr double tangent_max = 1e6;  // of angles near a half turn

}  // namespace

// Heron's formula, as Kahan has it.
double IntrinsicTriangle::twice_area() const {
    std::array<double, 3> side = lengths;
    std::sort(side.begin(), side.end());
    const auto [c, b, a] = side;
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0 ? 0.5 * std::sqrt(product) : 0.0;
}

double IntrinsicTriangle::half_tangent(uint32_t k) const {
    const double to_next = lengths[k], far = lengths[(k + 1) % 3], to_previous = lengths[(k + 2) % 3];
    const double area = twice_area();
    if (!(area > 0)) return 0;
    // sin / (1 + cos), times both sides.
    const double rest = to_next + to_previous;
    return std::min(2 * area / ((rest - far) * (rest + far)), tangent_max);
}

IntrinsicTriangle IntrinsicSurface::triangle(uint32_t number) const {
    const IntrinsicTriangle* found = find(number);
    return found ? *found : own_triangle(number);
}

IntrinsicTriangle IntrinsicSurface::own_triangle(uint32_t number) const {
    IntrinsicTriangle own;
    own.vertices = mesh.triangles[number];
    for (uint32_t k = 0; k < 3; ++k) {
        const Vec3 begin = load_vec3(positions[own.vertices[k]].data()),
                   end = load_vec3(positions[own.vertices[following_corner(k)]].data());
        own.lengths[k] = (end - begin).norm();
        own.across[k] = within_or_none(mesh.opposite(3 * number + k));
    }
    return own;
}

Corner IntrinsicSurface::opposite(Corner corner) const {
    const IntrinsicTriangle* found = find(triangle_of(corner));
    return within_or_none(found ? found->across[corner % 3] : mesh.opposite(corner));
}

// Two triangles across an edge from a to b, the diagonal of the quadrilateral a, d, b, c.
struct Quadrilateral {
    IntrinsicTriangle upper, lower;  // with c, with d
    uint32_t upper_edge, lower_edge;

    // Whether the edge is far from Delaunay: the sines and cosines of the angles at c and d.
    bool is_to_flip() const;
    // The length of the other diagonal, and whether it leaves both triangles some area.
    double other_diagonal(bool& is_inside) const;
};

bool Quadrilateral::is_to_flip() const {
    const auto apex = [](const IntrinsicTriangle& of, uint32_t edge, double& cosine, double& sine) {
        const double far = of.lengths[edge], left = of.lengths[following_corner(edge)],
                     right = of.lengths[(edge + 2) % 3];
        cosine = 0.5 * (left * left + right * right - far * far);
        sine = of.twice_area();
        return left * right;
    };
    double cosine, sine, other_cosine, other_sine;
    const double product = apex(upper, upper_edge, cosine, sine) * apex(lower, lower_edge, other_cosine, other_sine);
    const double sum_cosine = cosine * other_cosine - sine * other_sine,
                 sum_sine = sine * other_cosine + cosine * other_sine;
    return sum_sine <= 0 && sum_cosine > cosine_max * product;
}

double Quadrilateral::other_diagonal(bool& is_inside) const {
    // a is the origin, b on the x axis, c above it, d below.
    const double length = upper.lengths[upper_edge];
    const auto apex = [=](double from_a, double from_b) {
        const double x = (length * length + (from_a - from_b) * (from_a + from_b)) / (2 * length);
        return std::array<double, 2>{x, std::sqrt(std::max((from_a - x) * (from_a + x), 0.0))};
    };
    const auto c = apex(upper.lengths[(upper_edge + 2) % 3], upper.lengths[following_corner(upper_edge)]);
    const auto d = apex(lower.lengths[following_corner(lower_edge)], lower.lengths[(lower_edge + 2) % 3]);
    const double height = c[1] + d[1];
    // Where it crosses the edge, times the height.
    const double crossing = c[0] * d[1] + d[0] * c[1];
    constexpr double least = 1e-9;
    is_inside = height > 0 && crossing > least * length * height && crossing < (1 - least) * length * height;
    return std::sqrt((c[0] - d[0]) * (c[0] - d[0]) + height * height);
}

class EdgeFlipper {
public:
    EdgeFlipper(const IntrinsicSurface& surface, FlipRequest& request, IntrinsicTriangles& flipped, Memory* memory)
        : surface_(surface), flipped_(flipped), request_(request), dissolved_(memory), made_(memory), queue_(memory) {}

    static Task<std::pmr::deque<uint32_t>> run(Pace& pace, EdgeFlipper& flipper);

private:
    using Member = IntrinsicTriangles::Member;

    bool dissolve_next();
    void list_edges(uint32_t triangle);
    static Task<void> sort_edges(Pace& pace, EdgeFlipper& flipper);
    bool flip_next();
    void flip(uint32_t upper, uint32_t lower, const Quadrilateral& before, double diagonal);
    Member& member(uint32_t triangle);
    Member& make_member(uint32_t triangle, const IntrinsicTriangle& shape);
    uint32_t root(uint32_t slot);
    void join(uint32_t triangle, uint32_t other);
    bool is_free(uint32_t triangle);

    const IntrinsicSurface& surface_;
    IntrinsicTriangles& flipped_;
    FlipRequest& request_;
    std::pmr::deque<uint32_t> dissolved_;  // triangles of groups that were
    std::pmr::deque<uint32_t> made_;       // triangles that have become members
    std::pmr::deque<Corner> queue_;        // edges to look at
};

// Gives up the next triangle of the first group that is to be dissolved.
bool EdgeFlipper::dissolve_next() {
    auto& given_up = request_.given_up;
    if (given_up.empty()) return false;
    const uint32_t triangle = given_up.front();
    if (!flipped_.find(triangle)) {
        given_up.pop_front();
        return true;
    }
    const uint32_t slot = flipped_.table_.find(triangle);
    Member& member = flipped_.members_[slot];
    const uint32_t next = member.next;
    member.is_used = false;
    dissolved_.push_back(triangle);
    if (flipped_.members_[next].is_used) given_up.front() = flipped_.members_[next].triangle;
    return true;
}

// Those that may have to be flipped, seen from either side.
void EdgeFlipper::list_edges(uint32_t triangle) {
    if (triangle >= surface_.mesh.triangle_count() || !surface_.contains(triangle)) return;
    for (uint32_t k = 0; k < 3; ++k) request_.edges.push_back(3 * triangle + k);
}

// The mesh's edges that are to flip, by number, each once: from the side where it is less.
Task<void> EdgeFlipper::sort_edges(Pace& pace, EdgeFlipper& flipper) {
    std::pmr::deque<Corner>& edges = flipper.request_.edges;
    const IntrinsicSurface& surface = flipper.surface_;
    co_await each(pace, edges.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Corner across = surface.mesh.opposite(edges[i]);
        if (across != no_index) edges[i] = std::min(edges[i], across);
    });
    const Buffer<Corner> sorted =
        co_await sort_by(pace, edges, 3 * surface.mesh.triangle_count(), [](Corner edge) { return edge; });
    co_await each(pace, sorted.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (i > 0 && sorted[i] == sorted[i - 1]) return;
        const Corner edge = sorted[i], across = surface.within_or_none(surface.mesh.opposite(edge));
        if (across == no_index || !surface.contains(triangle_of(edge))) return;
        const Quadrilateral quad = {surface.own_triangle(triangle_of(edge)), surface.own_triangle(triangle_of(across)),
                                    edge % 3, across % 3};
        if (quad.is_to_flip()) flipper.queue_.push_back(edge);
    });
}

Task<std::pmr::deque<uint32_t>> EdgeFlipper::run(Pace& pace, EdgeFlipper& flipper) {
    IntrinsicTriangles& flipped = flipper.flipped_;
    do {
        // From the beginning, with all groups that were met: as if they had never been.
        const size_t dissolved = flipper.dissolved_.size();
        ++flipped.run_;
        co_await each(pace, flipper.made_.size(), Cost::tens_of_ns,
                      [&](uint32_t i) { flipped.members_[flipped.table_.find(flipper.made_[i])].is_used = false; });
        flipper.made_.clear();
        flipper.queue_.clear();
        co_await repeat(pace, Cost::tens_of_ns, [&] { return flipper.dissolve_next(); });
        co_await each(pace, static_cast<uint32_t>(dissolved), static_cast<uint32_t>(flipper.dissolved_.size()),
                      Cost::tens_of_ns, [&](uint32_t i) { flipper.list_edges(flipper.dissolved_[i]); });
        const auto& restored = flipper.request_.restored;
        co_await IndexTable::reserve(pace, flipped.table_, restored.size() + 6);
        co_await each(pace, restored.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
            flipper.make_member(restored[i], flipper.surface_.own_triangle(restored[i]));
            flipper.list_edges(restored[i]);
        });
        co_await sort_edges(pace, flipper);
        Slice slice(Cost::hundreds_of_ns);
        while (flipper.flip_next()) {
            if (!flipped.table_.has_room(6)) co_await IndexTable::reserve(pace, flipped.table_, 6);
            if (slice.is_over()) co_await pace;
        }
    } while (!flipper.request_.given_up.empty());
    co_await each(pace, flipper.made_.size(), Cost::some_ns,
                  [&](uint32_t i) { flipper.dissolved_.push_back(flipper.made_[i]); });
    co_return std::move(flipper.dissolved_);
}

// Whether a triangle may change, or what it lies at. One that is of a group made before would not have been there: that
// group is to be dissolved too.
bool EdgeFlipper::is_free(uint32_t triangle) {
    if (const uint32_t slot = flipped_.table_.find(triangle); slot != no_index && flipped_.members_[slot].is_used) {
        if (flipped_.members_[slot].run == flipped_.run_) return true;
        request_.given_up.push_back(triangle);
        return false;
    }
    return !surface_.flipped_before || !surface_.flipped_before->find(triangle);
}

// False if no edge is left. Where groups are in the way the edge stays: all flips are done again without them, and it
// is better to know of many by then than to begin again for each.
bool EdgeFlipper::flip_next() {
    if (queue_.empty()) return false;
    const Corner edge = queue_.front();
    queue_.pop_front();
    const uint32_t upper = triangle_of(edge);
    const Corner across = surface_.opposite(edge);
    if (across == no_index || triangle_of(across) == upper) return true;
    const uint32_t lower = triangle_of(across);
    const Quadrilateral quad = {surface_.triangle(upper), surface_.triangle(lower), edge % 3, across % 3};
    if (!quad.is_to_flip()) return true;
    bool is_inside = false;
    const double diagonal = quad.other_diagonal(is_inside);
    if (!is_inside) return true;
    bool are_free = is_free(upper);
    are_free = is_free(lower) && are_free;
    for (uint32_t k = 1; k < 3; ++k) {
        for (const Corner outer :
             {quad.upper.across[(quad.upper_edge + k) % 3], quad.lower.across[(quad.lower_edge + k) % 3]}) {
            if (outer != no_index) are_free = is_free(triangle_of(outer)) && are_free;
        }
    }
    if (are_free) flip(upper, lower, quad, diagonal);
    return true;
}

// a, d, b, c: the upper triangle a, b, c becomes c, a, d, the lower one b, a, d becomes d, b, c.
void EdgeFlipper::flip(uint32_t upper, uint32_t lower, const Quadrilateral& before, double diagonal) {
    Member &first = member(upper), &second = member(lower);
    if (std::max(first.flips, second.flips) == max_flips) return;
    ++first.flips;
    ++second.flips;
    const uint32_t ab = before.upper_edge, bc = following_corner(ab), ca = following_corner(bc);
    const uint32_t ba = before.lower_edge, ad = following_corner(ba), db = following_corner(ad);
    const IntrinsicTriangle &x = before.upper, &y = before.lower;
    first.shape = {{x.vertices[ca], x.vertices[ab], y.vertices[db]},
                   {x.across[ca], y.across[ad], 3 * lower + 2},
                   {x.lengths[ca], y.lengths[ad], diagonal}};
    second.shape = {{y.vertices[db], x.vertices[bc], x.vertices[ca]},
                    {y.across[db], x.across[bc], 3 * upper + 2},
                    {y.lengths[db], x.lengths[bc], diagonal}};
    // An outer edge may be another one of the same two triangles.
    const std::array<std::array<Corner, 2>, 4> moved = {{{3 * upper + ca, 3 * upper},
                                                         {3 * lower + ad, 3 * upper + 1},
                                                         {3 * lower + db, 3 * lower},
                                                         {3 * upper + bc, 3 * lower + 1}}};
    for (IntrinsicTriangle* shape : {&first.shape, &second.shape}) {
        for (uint32_t k = 0; k < 2; ++k) {
            for (const auto& [from, to] : moved) {
                if (shape->across[k] != from) continue;
                shape->across[k] = to;
                break;
            }
        }
    }
    join(upper, lower);
    for (const auto& [from, edge] : moved) {
        queue_.push_back(edge);
        const Corner outer = flipped_.find(triangle_of(edge))->across[edge % 3];
        if (outer == no_index) continue;
        member(triangle_of(outer)).shape.across[outer % 3] = edge;
        join(upper, triangle_of(outer));
    }
}

EdgeFlipper::Member& EdgeFlipper::member(uint32_t triangle) {
    const uint32_t slot = flipped_.table_.find(triangle);
    if (slot != no_index && flipped_.members_[slot].is_used) return flipped_.members_[slot];
    return make_member(triangle, surface_.triangle(triangle));
}

EdgeFlipper::Member& EdgeFlipper::make_member(uint32_t triangle, const IntrinsicTriangle& shape) {
    uint32_t slot = flipped_.table_.find(triangle);
    if (slot == no_index) {
        slot = static_cast<uint32_t>(flipped_.members_.size());
        flipped_.members_.emplace_back();
        flipped_.table_.insert(triangle, slot);
    }
    made_.push_back(triangle);
    return flipped_.members_[slot] = {shape, triangle, slot, slot, 0, flipped_.run_, true};
}

uint32_t EdgeFlipper::root(uint32_t slot) {
    auto& members = flipped_.members_;
    while (members[slot].root != slot) slot = members[slot].root = members[members[slot].root].root;
    return slot;
}

void EdgeFlipper::join(uint32_t triangle, uint32_t other) {
    const uint32_t a = flipped_.table_.find(triangle), b = flipped_.table_.find(other);
    const uint32_t root_a = root(a), root_b = root(b);
    if (root_a == root_b) return;
    flipped_.members_[root_b].root = root_a;
    std::swap(flipped_.members_[a].next, flipped_.members_[b].next);
}

Task<std::pmr::deque<uint32_t>> flip_edges(Pace& pace, const IntrinsicSurface& surface, FlipRequest& request,
                                           IntrinsicTriangles& flipped) {
    EdgeFlipper flipper(surface, request, flipped, pace.memory());
    co_return co_await EdgeFlipper::run(pace, flipper);
}

}  // namespace flg
