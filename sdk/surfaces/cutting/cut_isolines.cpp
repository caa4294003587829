// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_isolines.h"

#include <cmath>
#include <limits>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/cutting/cut_pieces.h"
#include "surfaces/mesh/block_map.h"

namespace flg {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Triangulates a triangle with points on its edges, taken as two chains that rise side by side. Points of the same
// value are joined, so that each piece lies between two values that follow one another.
//
// Invariants
// - Both chains begin with the same vertex, or with two that edge `first_edge` joins; they end likewise, with
//   `last_edge`.
// - Values rise along each chain. The chains share no vertex but the first and the last, and if they share both, each
//   has another between.
struct Strip {
    struct Point {
        uint32_t vertex;
        uint32_t edge;  // of the triangle: where the way from the point before leads along
        float value;
    };

    explicit Strip(Memory* memory) : left(memory), right(memory) {}

    // Appends the pieces. Of two ways to halve a quad it takes the one with the shorter diagonal.
    void triangulate(const Mesh& mesh, uint32_t region, Pieces& pieces) const;

    std::pmr::vector<Point> left, right;  // as seen from outside by one who climbs
    uint32_t first_edge, last_edge;       // only where the chains begin, or end, apart
};

void Strip::triangulate(const Mesh& mesh, uint32_t region, Pieces& pieces) const {
    constexpr float never = std::numeric_limits<float>::infinity();
    size_t l = 0, r = 0;
    uint32_t below = Pieces::outer_edge | first_edge;  // what lies under the rung from left[l] to right[r]
    const auto above = [&] {
        const bool last = l + 1 == left.size() && r + 1 == right.size();
        return last ? Pieces::outer_edge | last_edge : pieces.size() + 1;
    };
    const auto outer = [](const Point& point) { return Pieces::outer_edge | point.edge; };

    if (left[0].vertex == right[0].vertex) {
        l = r = 1;
        const uint32_t next = above();
        pieces.add({left[0].vertex, right[1].vertex, left[1].vertex}, {outer(right[1]), next, outer(left[1])}, region);
        below = pieces.size() - 1;
    }
    while (l + 1 < left.size() || r + 1 < right.size()) {
        const Point &a = left[l], &b = right[r];
        const float next_left = l + 1 < left.size() ? left[l + 1].value : never;
        const float next_right = r + 1 < right.size() ? right[r + 1].value : never;
        if (next_left == next_right && left[l + 1].vertex == right[r + 1].vertex) {
            pieces.add({a.vertex, b.vertex, left[l + 1].vertex}, {below, outer(right[r + 1]), outer(left[l + 1])},
                       region);
            return;
        }
        bool climb_left = next_left < next_right;
        if (next_left == next_right) {
            const Vec3 falling = mesh.position(left[l + 1].vertex) - mesh.position(b.vertex);
            const Vec3 rising = mesh.position(right[r + 1].vertex) - mesh.position(a.vertex);
            climb_left = falling.squaredNorm() <= rising.squaredNorm();
        }
        climb_left ? ++l : ++r;
        const uint32_t next = above();
        if (climb_left) {
            pieces.add({a.vertex, b.vertex, left[l].vertex}, {below, next, outer(left[l])}, region);
        } else {
            pieces.add({a.vertex, b.vertex, right[r].vertex}, {below, outer(right[r]), next}, region);
        }
        below = pieces.size() - 1;
    }
}

// Joins the points `first` to `first` + `count` - 1 (`step` 1), or downwards from there (`step` -1), to the corner
// opposite the edge on which they lie: `edge` of the triangle, still unbroken in the last piece.
void fan_last_piece(Pieces& pieces, uint32_t edge, uint32_t first, uint32_t count, int step) {
    if (count == 0) return;
    const uint32_t changed = pieces.size() - 1;
    const Triple corners = pieces.triangles.back(), across = pieces.neighbours.back();
    const uint32_t region = pieces.regions.back(), outer = Pieces::outer_edge | edge;
    const uint32_t k = across[0] == outer ? 0 : across[1] == outer ? 1 : 2;
    const uint32_t end = corners[(k + 1) % 3], apex = corners[(k + 2) % 3];
    uint32_t point = first;
    pieces.triangles.back() = {corners[k], point, apex};
    pieces.neighbours.back() = {outer, changed + 1, across[(k + 2) % 3]};
    for (uint32_t i = 1; i <= count; ++i) {
        const uint32_t here = point;
        point = i == count ? end : point + static_cast<uint32_t>(step);
        pieces.add({here, point, apex}, {outer, i == count ? across[(k + 1) % 3] : changed + i + 1, changed + i - 1},
                   region);
    }
    // The piece across the far side now meets the last one.
    const uint32_t far = across[(k + 1) % 3];
    if (far >= Pieces::outer_edge) return;
    for (uint32_t& neighbour : pieces.neighbours[far]) {
        if (neighbour == changed) neighbour = changed + count;
    }
}

uint32_t cost_of(const CutTriangle& slot) {
    return 1 + (slot.edges[0].points + slot.edges[1].points + slot.edges[2].points) / 4;
}

class IsolineCutter {
public:
    IsolineCutter(Mesh& mesh, MeshColumns& columns, uint32_t field, const CutLevels& levels, MeshEdit& edit,
                  Memory* memory);

    uint32_t group_count() const { return crossed_.group_count(); }
    void clear(uint32_t group) { crossed_.clear_group(group); }
    // The next 64 triangles from there on in which the regions may be; no_index: none.
    uint32_t next_word(uint32_t word) const { return map_.next(word); }
    void scan(uint32_t word);
    void sum(uint32_t group) { crossed_.sum_group(group); }
    void make_slots(Memory* memory) { slots_ = Buffer<CutTriangle>(crossed_.size(), memory); }
    // Returns what it cost.
    uint32_t collect(uint32_t group);
    size_t slot_count() const { return slots_.size(); }
    void find_snaps(uint32_t slot);
    size_t snap_count() const { return snaps_.size(); }
    void move(uint32_t snap);
    void number(uint32_t slot);
    MeshGrowth begin_growth() {
        return {mesh_, columns_, static_cast<uint32_t>(vertices_), static_cast<uint32_t>(triangles_)};
    }
    void end_growth() {
        resize_mesh(mesh_, columns_, static_cast<uint32_t>(vertices_), static_cast<uint32_t>(triangles_));
    }
    // Both return what they cost.
    uint32_t place(uint32_t slot);
    uint32_t split(uint32_t slot);

private:
    struct Snap {
        uint32_t vertex;
        float level;
    };

    float value(uint32_t vertex) const { return field_[vertex]; }
    bool scan_doubtful(uint32_t triangle);
    void insert_crossed(uint32_t triangle);
    bool may_cut(uint32_t triangle) const;
    uint32_t label_of(uint32_t triangle, const Triple& vertices) const;
    void strip_between_levels(const CutTriangle& slot);
    void strip_beside_cuts(const CutTriangle& slot);
    void climb(const CutTriangle& slot, uint32_t from, uint32_t to, std::pmr::vector<Strip::Point>& chain) const;

    Mesh& mesh_;
    MeshColumns& columns_;
    GrowingBuffer<float>& field_;
    const uint32_t field_column_;
    const CutLevels levels_;
    BlockMap map_;  // of the regions
    MeshEdit& edit_;
    TriangleSet crossed_;
    Buffer<CutTriangle> slots_;
    std::pmr::deque<Snap> snaps_;
    PieceWriter writer_;
    Strip strip_;
    Pieces pieces_;
    // Between these levels the last triangle lay, above interval_ levels; its region, and what is listed for it.
    float low_, high_;
    uint32_t interval_ = 0;
    uint32_t region_ = no_index;
    const RegionLevels* listed_ = nullptr;
    uint64_t vertices_, triangles_;  // numbered so far
    uint32_t filled_ = 0;            // slots
};

IsolineCutter::IsolineCutter(Mesh& mesh, MeshColumns& columns, uint32_t field, const CutLevels& levels, MeshEdit& edit,
                             Memory* memory)
    : mesh_(mesh),
      columns_(columns),
      field_(columns[field].values),
      field_column_(field),
      levels_(levels),
      map_(mesh, memory),
      edit_(edit),
      crossed_(mesh.triangle_count(), memory),
      snaps_(memory),
      writer_(mesh, edit, slots_),
      strip_(memory),
      pieces_(memory),
      low_(-infinite),
      high_(levels.count() == 0 ? infinite : levels[0]),
      vertices_(mesh.vertex_count()),
      triangles_(mesh.triangle_count()) {
    for (const RegionLevels& listed : levels_.regions())
        if (!map_.add(listed.region)) break;
    map_.close();
    edit.begin(mesh);
}

// Of 64 triangles labels those of the regions that no level touches, marks the others.
void IsolineCutter::scan(uint32_t word) {
    const uint32_t first = 64 * word, end = std::min(first + 64, mesh_.triangle_count());
    uint32_t others = 0;  // labels
    for (uint32_t triangle = first; triangle < end; ++triangle) others |= mesh_.regions[triangle] ^ region_;
    if (others == 0 && listed_ == nullptr) return;
    for (uint32_t triangle = first; triangle < end; ++triangle) {
        const uint32_t region = mesh_.regions[triangle];
        if (region != region_) {
            region_ = region;
            listed_ = levels_.find(region);
        }
        if (listed_ == nullptr) continue;
        const Triple& vertices = mesh_.triangles[triangle];
        const float a = value(vertices[0]), b = value(vertices[1]), c = value(vertices[2]);
        const bool inside = (a > low_) & (a < high_) & (b > low_) & (b < high_) & (c > low_) & (c < high_);
        if (!inside && scan_doubtful(triangle)) {
            insert_crossed(triangle);
        } else {
            edit_.set_region(mesh_, triangle, listed_->label_above(interval_));
        }
    }
}

// With those across its split edges, whatever their region: they stay joined to it.
void IsolineCutter::insert_crossed(uint32_t triangle) {
    crossed_.insert(triangle);
    const Triple& vertices = mesh_.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t beside = mesh_.neighbours[triangle][k];
        if (beside == no_index) continue;
        if (levels_.between(value(vertices[k]), value(vertices[(k + 1) % 3])).count > 0) crossed_.insert(beside);
    }
}

// True if a level passes; otherwise the triangle's interval is the current one from now on.
bool IsolineCutter::scan_doubtful(uint32_t triangle) {
    float low = infinite, high = -infinite;
    bool finite = true;
    for (uint32_t vertex : mesh_.triangles[triangle]) {
        const float at = value(vertex);
        if (!std::isfinite(at)) {
            finite = false;
            continue;
        }
        low = std::min(low, at);
        high = std::max(high, at);
    }
    if (low <= high && levels_.below(low) != levels_.up_to(high)) return true;
    interval_ = finite ? levels_.up_to(low) : levels_.count();
    low_ = interval_ == 0 ? -infinite : levels_[interval_ - 1];
    high_ = interval_ == levels_.count() ? infinite : levels_[interval_];
    return false;
}

uint32_t IsolineCutter::collect(uint32_t group) {
    const uint32_t before = filled_;
    crossed_.visit(group, [this](uint32_t triangle) { slots_[filled_++].triangle = triangle; });
    return 1 + filled_ - before;
}

bool IsolineCutter::may_cut(uint32_t triangle) const {
    for (uint32_t vertex : mesh_.triangles[triangle]) {
        if (!std::isfinite(value(vertex))) return false;
    }
    return levels_.find(mesh_.regions[triangle]) != nullptr;
}

void IsolineCutter::find_snaps(uint32_t slot) {
    const uint32_t triangle = slots_[slot].triangle;
    if (!may_cut(triangle)) return;
    const Triple& vertices = mesh_.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const float at = value(vertices[k]);
        const uint32_t above = levels_.up_to(at);
        constexpr double infinitely_far = std::numeric_limits<double>::infinity();
        const double up = above < levels_.count() ? double{levels_[above]} - at : infinitely_far;
        const double down = above > 0 ? double{at} - levels_[above - 1] : infinitely_far;
        if (down == 0) continue;
        const double steepest = std::max(std::abs(double{value(vertices[(k + 1) % 3])} - at),
                                         std::abs(double{value(vertices[(k + 2) % 3])} - at));
        if (std::min(up, down) > cut_tolerance * steepest) continue;
        snaps_.push_back({vertices[k], down <= up ? levels_[above - 1] : levels_[above]});
    }
}

void IsolineCutter::move(uint32_t index) {
    const Snap& snap = snaps_[index];
    if (value(snap.vertex) != snap.level) edit_.set_value(columns_, field_column_, snap.vertex, snap.level);
}

// Gives new points and pieces their places. A split edge is numbered by its owner; points rise with the field.
void IsolineCutter::number(uint32_t slot) {
    CutTriangle& cut = slots_[slot];
    const bool cuts = may_cut(cut.triangle);
    uint32_t points = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        CutTriangle::Edge& edge = cut.edges[k];
        edge = {0, 0, no_index, no_index};
        const Corner corner = 3 * cut.triangle + k, across = mesh_.opposite(corner);
        const uint32_t other = across == no_index ? no_index : crossed_.slot_of(triangle_of(across));
        if (other < slot) {
            edge = slots_[other].edges[across % 3];
            edge.twin = 3 * other + across % 3;
        } else if (cuts || (other != no_index && may_cut(triangle_of(across)))) {
            const float a = value(mesh_.vertex_at(corner)), b = value(mesh_.vertex_at(next_corner(corner)));
            edge.points = levels_.between(a, b).count;
            edge.first_vertex = static_cast<uint32_t>(vertices_);
            vertices_ += edge.points;
        }
        points += edge.points;
    }
    cut.first_added = static_cast<uint32_t>(triangles_);
    triangles_ += points;
    if (vertices_ >= no_index || triangles_ > no_index / 3) {
        throw Failure(FLG_ERROR_LIMIT, "the mesh would have more than 2^32 corners after a cut at %u levels",
                      levels_.count());
    }
}

uint32_t IsolineCutter::place(uint32_t index) {
    const CutTriangle& slot = slots_[index];
    for (uint32_t k = 0; k < 3; ++k) {
        const CutTriangle::Edge& edge = slot.edges[k];
        if (edge.points == 0 || edge.twin != no_index) continue;
        uint32_t a = mesh_.triangles[slot.triangle][k], b = mesh_.triangles[slot.triangle][(k + 1) % 3];
        if (value(a) > value(b)) std::swap(a, b);
        const uint32_t first = levels_.between(value(a), value(b)).first;
        for (uint32_t i = 0; i < edge.points; ++i) {
            const uint32_t vertex = edge.first_vertex + i;
            const float level = levels_[first + i];
            const double t = (double{level} - value(a)) / (double{value(b)} - value(a));
            place_vertex(mesh_, columns_, vertex, {a, b, b}, {1 - t, t, 0});
            field_[vertex] = level;
        }
    }
    return cost_of(slot);
}

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

uint32_t IsolineCutter::split(uint32_t index) {
    CutTriangle& slot = slots_[index];
    if (slot.edges[0].points + slot.edges[1].points + slot.edges[2].points == 0) {
        edit_.set_region(mesh_, slot.triangle, label_of(slot.triangle, mesh_.triangles[slot.triangle]));
        return 1;
    }
    strip_.left.clear();
    strip_.right.clear();
    pieces_.clear();
    may_cut(slot.triangle) ? strip_between_levels(slot) : strip_beside_cuts(slot);
    writer_.write(slot, pieces_);
    return cost_of(slot);
}

}  // namespace

Task<void> embed_isolines(Pace& pace, Mesh& mesh, MeshColumns& columns, uint32_t field, CutLevels levels,
                          MeshEdit& edit) {
    constexpr uint32_t grown = 3200;  // elements, about 10 us
    IsolineCutter cutter(mesh, columns, field, levels, edit, pace.memory());
    co_await each(pace, cutter.group_count(), Cost::some_ns, [&](uint32_t group) { cutter.clear(group); });
    uint32_t word = 0;
    co_await repeat(pace, Cost::hundreds_of_ns, [&] {
        word = cutter.next_word(word);
        if (word == no_index) return false;
        cutter.scan(word++);
        return true;
    });
    co_await each(pace, cutter.group_count(), Cost::hundreds_of_ns, [&](uint32_t group) { cutter.sum(group); });
    cutter.make_slots(pace.memory());
    co_await each_by_work(pace, cutter.group_count(), Cost::some_ns,
                          [&](uint32_t group) { return cutter.collect(group); });
    co_await each(pace, cutter.slot_count(), Cost::hundreds_of_ns, [&](uint32_t slot) { cutter.find_snaps(slot); });
    co_await each(pace, cutter.snap_count(), Cost::tens_of_ns, [&](uint32_t snap) { cutter.move(snap); });
    co_await each(pace, cutter.slot_count(), Cost::hundreds_of_ns, [&](uint32_t slot) { cutter.number(slot); });
    MeshGrowth growth = cutter.begin_growth();
    while (!growth.run(grown)) co_await pace;
    cutter.end_growth();
    co_await each_by_work(pace, cutter.slot_count(), Cost::hundreds_of_ns,
                          [&](uint32_t slot) { return cutter.place(slot); });
    co_await each_by_work(pace, cutter.slot_count(), Cost::hundreds_of_ns,
                          [&](uint32_t slot) { return cutter.split(slot); });
    edit.end(mesh);
}

}  // namespace flg
