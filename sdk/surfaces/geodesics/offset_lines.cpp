// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/offset_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/failure.h"
#include "surfaces/geodesics/exact_places.h"

namespace flg {

namespace {

constexpr double fine_edge = 0.125;        // of the offset: fronts are nearly straight along shorter ones
constexpr double finest_edge = 0.004;      // likewise: where two fronts meet
constexpr uint32_t most_parts = 1u << 22;  // triangles that the level may pass
constexpr uint32_t most_rounds = 50;       // of halving edges
constexpr uint32_t most_halvings = 10;     // of a stretch between edges
constexpr uint32_t most_steps = 60;        // of looking for the level
constexpr uint32_t side_steps = 40;        // likewise for the end of a side
constexpr uint32_t side_rounds = 2;        // of that: the way onto the level leads past it, each time less
constexpr double side_slack = 4e-9;        // of the longest edge: where both sides are so alike, either may be nearer
constexpr double sideless_length = 1e-6;   // of the offset: so short a stretch between two such places is left out
constexpr double step_tolerance = 1e-9;    // of the offset

// Part of a triangle.
struct LevelPart {
    uint32_t triangle;
    std::array<uint32_t, 3> nodes;
    std::array<Weights, 3> corners;
};

// Where the level crosses an edge, and the part that it enters there: no_index at an end.
struct LevelCrossing {
    double at;  // of the edge, from its lower node
    uint32_t label;
    uint32_t entered = no_index, next = no_index;
    bool has_preceding = false, is_drawn = false;
};

// Within a triangle.
struct LevelStretch {
    uint32_t triangle;
    Weights from, to;
    uint32_t from_label, to_label;
};

Weights between(const Weights& a, const Weights& b, double t) {
    Weights out;
    for (uint32_t k = 0; k < 3; ++k) out[k] = a[k] == b[k] ? a[k] : (1 - t) * a[k] + t * b[k];
    return out;
}

// Where a height is 0, by the Illinois method: between two places, at one of which it is below.
//
//     while (search.asks()) search.take(height(search.at));
class LevelSearch {
public:
    LevelSearch(double begin, double at_begin, double end, double at_end, double tolerance)
        : begin_(begin), at_begin_(at_begin), end_(end), at_end_(at_end), tolerance_(tolerance) {}

    double at = 0;  // the place that is asked for, or at last found

    bool asks() {
        if (is_found_) return false;
        is_found_ = step_++ == most_steps || !(std::abs(end_ - begin_) > 0);
        at = is_found_ ? 0.5 * (begin_ + end_) : (begin_ * at_end_ - end_ * at_begin_) / (at_end_ - at_begin_);
        return !is_found_;
    }
    void take(double height) {
        if (std::abs(height) <= tolerance_) {
            is_found_ = true;
        } else if ((height < 0) == (at_begin_ < 0)) {
            begin_ = at, at_begin_ = height;
            if (kept_ == 1) at_end_ *= 0.5;
            kept_ = 1;
        } else {
            end_ = at, at_end_ = height;
            if (kept_ == -1) at_begin_ *= 0.5;
            kept_ = -1;
        }
    }

private:
    double begin_, at_begin_, end_, at_end_, tolerance_;
    int kept_ = 0;
    uint32_t step_ = 0;
    bool is_found_ = false;
};

// Edge k of part i is 3 i + k.
struct EdgeOrder {
    const GrowingList<LevelPart>& parts;
    Groups by_high, by_low;

    uint32_t size() const { return by_low.count(); }
    uint32_t edge(uint32_t i) const { return by_high.items[by_low.items[i]]; }
    std::pair<uint32_t, uint32_t> ends(uint32_t edge) const {
        const auto& nodes = parts[edge / 3].nodes;
        return std::minmax(nodes[edge % 3], nodes[(edge % 3 + 1) % 3]);
    }
    // Whether place i has the same edge as the one before it.
    bool repeats(uint32_t i) const { return i > 0 && ends(edge(i)) == ends(edge(i - 1)); }
};

Task<EdgeOrder> order_edges(Pace& pace, const GrowingList<LevelPart>& parts, size_t nodes) {
    EdgeOrder order{parts, {}, {}};
    order.by_high =
        co_await group_by(pace, 3 * parts.size(), nodes, [&](uint32_t edge) { return order.ends(edge).second; });
    order.by_low = co_await group_by(pace, 3 * parts.size(), nodes,
                                     [&](uint32_t i) { return order.ends(order.by_high.items[i]).first; });
    co_return order;
}

class LevelLines {
public:
    LevelLines(const Mesh& mesh, const ExactPlaces& places, const ExactSolver& solver, double offset, Memory* memory)
        : mesh_(mesh),
          places_(places),
          solver_(solver),
          level_(std::abs(offset)),
          side_(offset > 0 ? 0 : 1),
          parts_(memory),
          nodes_(memory),
          crossings_(memory),
          line_(memory),
          lines_(memory),
          pending_(memory) {}

    // In this order.
    friend Task<void> choose_triangles(Pace& pace, LevelLines& lines);
    friend Task<void> divide_parts(Pace& pace, LevelLines& lines);
    friend Task<void> cross_edges(Pace& pace, LevelLines& lines);
    friend Task<void> draw_lines(Pace& pace, LevelLines& lines);
    friend Task<void> copy_lines(Pace& pace, LevelLines& lines, SurfaceCurves& out, std::pmr::deque<uint32_t>& pieces);

private:
    struct Line {
        explicit Line(Memory* memory) : stretches(memory) {}
        GrowingList<LevelStretch> stretches;
        bool closed = false;
        double length = 0;
    };

    double length_of(uint32_t triangle, const Weights& a, const Weights& b) const {
        return (places_.place(triangle, b) - places_.place(triangle, a)).norm();
    }
    double length_of(const LevelPart& part, uint32_t k) const {
        return length_of(part.triangle, part.corners[k], part.corners[(k + 1) % 3]);
    }
    // Distances change by no more than the way.
    bool may_pass(double distance, double way) const { return std::abs(distance - level_) <= way; }
    bool may_pass(const LevelPart& part) const {
        const double longest = std::max({length_of(part, 0), length_of(part, 1), length_of(part, 2)});
        return std::any_of(part.nodes.begin(), part.nodes.end(),
                           [&](uint32_t node) { return may_pass(nodes_[node], longest); });
    }
    bool is_above(uint32_t node) const { return nodes_[node] >= level_; }
    bool is_wanted(uint32_t label) const { return label < SidedSegment::beyond_end && label % 2 == side_; }

    bool is_long(const LevelPart& part, uint32_t k) const;
    void divide(const LevelPart& part, const uint32_t* middles, GrowingList<LevelPart>& out) const;
    Weights crossing_place(const LevelPart& part, uint32_t k, double at) const;
    void end_line(bool closed);

    // Each place that these ask for takes what its triangle has windows: slices count these, in Cost::some_ns.
    bool is_over(Slice& slice, uint32_t triangle) const { return slice.is_over(places_.work(triangle)); }
    // Of the level along a line between two places, at one of which the distance is below it: in the triangles of both.
    struct Sides {
        LevelPart parts[2];
        uint32_t edges[2];
        uint32_t count;
    };
    static Task<LevelCrossing> find_crossing(Pace& pace, Slice& slice, const LevelLines& lines, Sides sides);
    static Task<std::optional<Weights>> onto_level(Pace& pace, Slice& slice, const LevelLines& lines,
                                                   LevelStretch stretch, Weights begin);
    static Task<bool> clip(Pace& pace, Slice& slice, const LevelLines& lines, LevelStretch& stretch);
    static Task<void> refine(Pace& pace, Slice& slice, LevelLines& lines, LevelStretch stretch);

    const Mesh& mesh_;
    const ExactPlaces& places_;
    const ExactSolver& solver_;
    const double level_;
    const uint32_t side_;
    GrowingList<LevelPart> parts_;
    GrowingList<double> nodes_;  // their distances
    GrowingList<LevelCrossing> crossings_;
    Buffer<uint32_t> crossing_of_;  // an edge
    GrowingList<LevelStretch> line_;
    std::pmr::deque<Line> lines_;
    // Stretches that are being divided, the next one last.
    struct Pending {
        LevelStretch stretch;
        uint32_t halvings;
    };
    std::pmr::vector<Pending> pending_;
};

Task<void> choose_triangles(Pace& pace, LevelLines& lines) {
    const ExactFaces& faces = lines.solver_.faces();
    Buffer<uint32_t> node_of(faces.bends.size(), pace.memory());
    co_await each(pace, node_of.size(), Cost::some_ns, [&](uint32_t v) { node_of[v] = no_index; });
    co_await each(pace, faces.faces.size(), Cost::tens_of_ns, [&](uint32_t t) {
        const ExactFace& face = faces.faces[t];
        const double longest = *std::max_element(face.lengths.begin(), face.lengths.end());
        if (std::none_of(face.vertices.begin(), face.vertices.end(),
                         [&](uint32_t v) { return lines.may_pass(lines.solver_.distance(v), longest); }))
            return;
        LevelPart part{t, face.vertices, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
        for (uint32_t& node : part.nodes) {
            const uint32_t vertex = node;
            if (node_of[vertex] == no_index) {
                node_of[vertex] = static_cast<uint32_t>(lines.nodes_.size());
                lines.nodes_.push_back(lines.solver_.distance(vertex));
            }
            node = node_of[vertex];
        }
        lines.parts_.push_back(part);
    });
}

// Whether the level may cross an edge unseen by its ends, or bends too much along it.
bool LevelLines::is_long(const LevelPart& part, uint32_t k) const {
    const double length = length_of(part, k);
    if (!(length > finest_edge * level_)) return false;
    const uint32_t from = part.nodes[k], to = part.nodes[(k + 1) % 3];
    const double off = std::abs(nodes_[from] - level_), to_off = std::abs(nodes_[to] - level_);
    const bool above = is_above(from);
    if (above != is_above(to)) return length > fine_edge * level_ && std::min(off, to_off) <= length;
    if (off + to_off >= length) return false;
    if (length > fine_edge * level_) return true;
    for (const double t : {0.5, 0.25, 0.75}) {
        const Weights place = between(part.corners[k], part.corners[(k + 1) % 3], t);
        if ((places_.at(part.triangle, place).distance >= level_) != above) return true;
    }
    return false;
}

// Into two, three or four.
void LevelLines::divide(const LevelPart& part, const uint32_t* middles, GrowingList<LevelPart>& out) const {
    const auto add = [&](std::array<uint32_t, 3> nodes, const Weights& a, const Weights& b, const Weights& c) {
        const LevelPart piece{part.triangle, nodes, {a, b, c}};
        if (may_pass(piece)) out.push_back(piece);
    };
    const auto count =
        static_cast<uint32_t>(std::count_if(middles, middles + 3, [](uint32_t m) { return m != no_index; }));
    uint32_t k = 0;
    if (count == 1) k = middles[0] != no_index ? 0 : middles[1] != no_index ? 1 : 2;
    if (count == 2) k = middles[0] == no_index ? 0 : middles[1] == no_index ? 1 : 2;
    const uint32_t next = (k + 1) % 3, last = (k + 2) % 3;
    const Weights &p = part.corners[k], &q = part.corners[next], &r = part.corners[last];
    const uint32_t a = part.nodes[k], b = part.nodes[next], c = part.nodes[last];
    const Weights pq = between(p, q, 0.5), qr = between(q, r, 0.5), rp = between(r, p, 0.5);
    const uint32_t ab = middles[k], bc = middles[next], ca = middles[last];
    if (count == 1) {
        add({a, ab, c}, p, pq, r);
        add({ab, b, c}, pq, q, r);
    } else if (count == 2) {
        add({a, b, bc}, p, q, qr);
        add({a, bc, ca}, p, qr, rp);
        add({bc, c, ca}, qr, r, rp);
    } else if (count == 3) {
        add({a, ab, ca}, p, pq, rp);
        add({ab, b, bc}, pq, q, qr);
        add({ca, bc, c}, rp, qr, r);
        add({ab, bc, ca}, pq, qr, rp);
    } else {
        add(part.nodes, part.corners[0], part.corners[1], part.corners[2]);
    }
}

Task<void> divide_parts(Pace& pace, LevelLines& lines) {
    for (uint32_t round = 0;; ++round) {
        const size_t before = lines.nodes_.size();
        Buffer<uint32_t> middles(3 * lines.parts_.size(), pace.memory());
        {
            const EdgeOrder order = co_await order_edges(pace, lines.parts_, before);
            co_await each_by_work(pace, order.size(), Cost::some_ns, [&](uint32_t i) -> uint32_t {
                constexpr uint32_t most_places = 4;
                const uint32_t edge = order.edge(i), k = edge % 3;
                const bool repeats = order.repeats(i);
                const LevelPart& part = lines.parts_[edge / 3];
                middles[edge] = repeats ? middles[order.edge(i - 1)] : no_index;
                const uint32_t work = most_places * lines.places_.work(part.triangle);
                if (repeats ? middles[edge] == no_index : !lines.is_long(part, k)) return work;
                const Weights middle = between(part.corners[k], part.corners[(k + 1) % 3], 0.5);
                const double distance = lines.places_.at(part.triangle, middle).distance;
                if (!repeats) {
                    middles[edge] = static_cast<uint32_t>(lines.nodes_.size());
                    lines.nodes_.push_back(distance);
                } else if (distance < lines.nodes_[middles[edge]]) {
                    lines.nodes_[middles[edge]] = distance;
                }
                return work;
            });
        }
        if (lines.nodes_.size() == before) break;
        GrowingList<LevelPart> divided(pace.memory());
        co_await each(pace, lines.parts_.size(), Cost::hundreds_of_ns,
                      [&](uint32_t i) { lines.divide(lines.parts_[i], &middles[3 * i], divided); });
        if (divided.size() > most_parts || round == most_rounds)
            throw Failure(FLG_ERROR_LIMIT, "desc.offset is %g: too small beside the curve's length",
                          lines.side_ == 0 ? lines.level_ : -lines.level_);
        lines.parts_.swap(divided);
    }
}

Weights LevelLines::crossing_place(const LevelPart& part, uint32_t k, double at) const {
    const uint32_t next = (k + 1) % 3;
    const bool rises = part.nodes[k] < part.nodes[next];
    return between(part.corners[rises ? k : next], part.corners[rises ? next : k], at);
}

Task<LevelCrossing> LevelLines::find_crossing(Pace& pace, Slice& slice, const LevelLines& lines, Sides sides) {
    const LevelPart* const parts = sides.parts;
    const uint32_t* const edges = sides.edges;
    const auto found_at = [&](double at) {
        const Weights place = lines.crossing_place(parts[0], edges[0], at);
        ExactPlaces::Found least = lines.places_.at(parts[0].triangle, place);
        if (sides.count < 2) return least;
        const Weights from_other = lines.crossing_place(parts[1], edges[1], at);
        const ExactPlaces::Found other = lines.places_.at(parts[1].triangle, from_other);
        const std::array<double, 2> of_sides{std::min(least.of_sides[0], other.of_sides[0]),
                                             std::min(least.of_sides[1], other.of_sides[1])};
        if (other.distance < least.distance) least = other;
        least.of_sides = of_sides;
        return least;
    };
    const uint32_t work = lines.places_.work(parts[0].triangle) + lines.places_.work(parts[1].triangle);
    const auto [low, high] = std::minmax(parts[0].nodes[edges[0]], parts[0].nodes[(edges[0] + 1) % 3]);
    LevelSearch search(0, lines.nodes_[low] - lines.level_, 1, lines.nodes_[high] - lines.level_,
                       step_tolerance * lines.level_);
    while (search.asks()) {
        search.take(found_at(search.at).distance - lines.level_);
        if (slice.is_over(work)) co_await pace;
    }
    const ExactPlaces::Found found = found_at(search.at);
    const auto& lengths = lines.solver_.faces().faces[parts[0].triangle].lengths;
    const double slack = side_slack * *std::max_element(lengths.begin(), lengths.end());
    const bool is_either = found.label < SidedSegment::beyond_end &&
                           std::max(found.of_sides[0], found.of_sides[1]) <= found.distance + slack;
    LevelCrossing crossing;
    crossing.at = search.at;
    crossing.label = is_either ? SidedSegment::no_side : found.label;
    co_return crossing;
}

Task<void> cross_edges(Pace& pace, LevelLines& lines) {
    const EdgeOrder order = co_await order_edges(pace, lines.parts_, lines.nodes_.size());
    lines.crossing_of_ = Buffer<uint32_t>(3 * lines.parts_.size(), pace.memory());
    Slice slice(Cost::some_ns);
    for (uint32_t i = 0; i < order.size(); ++i) {
        const uint32_t edge = order.edge(i);
        if (slice.is_over()) co_await pace;
        if (order.repeats(i)) {
            lines.crossing_of_[edge] = lines.crossing_of_[order.edge(i - 1)];
        } else if (const auto [low, high] = order.ends(edge); lines.is_above(low) == lines.is_above(high)) {
            lines.crossing_of_[edge] = no_index;
        } else {
            const bool has_two = i + 1 < order.size() && order.repeats(i + 1);
            const uint32_t other = has_two ? order.edge(i + 1) : edge;
            const LevelLines::Sides sides{
                {lines.parts_[edge / 3], lines.parts_[other / 3]}, {edge % 3, other % 3}, has_two ? 2u : 1u};
            lines.crossing_of_[edge] = static_cast<uint32_t>(lines.crossings_.size());
            const LevelCrossing crossing = co_await LevelLines::find_crossing(pace, slice, lines, sides);
            lines.crossings_.push_back(crossing);
        }
    }
    // Higher distances lie on the left.
    co_await each(pace, lines.parts_.size(), Cost::tens_of_ns, [&](uint32_t p) {
        const LevelPart& part = lines.parts_[p];
        uint32_t in = no_index, out = no_index;
        for (uint32_t k = 0; k < 3; ++k) {
            const bool above = lines.is_above(part.nodes[k]), next_above = lines.is_above(part.nodes[(k + 1) % 3]);
            if (above && !next_above) in = lines.crossing_of_[3 * p + k];
            if (!above && next_above) out = lines.crossing_of_[3 * p + k];
        }
        if (in == no_index) return;
        lines.crossings_[in].entered = p;
        lines.crossings_[in].next = out;
        lines.crossings_[out].has_preceding = true;
    });
}

// From a place of a stretch straight across it to the level, if the triangle goes so far.
Task<std::optional<Weights>> LevelLines::onto_level(Pace& pace, Slice& slice, const LevelLines& lines,
                                                    LevelStretch stretch, Weights begin) {
    const ExactPlaces& places = lines.places_;
    const uint32_t triangle = stretch.triangle;
    const double tolerance = step_tolerance * lines.level_;
    const double off = places.at(triangle, begin).distance - lines.level_;
    const Vec2 way = places.place(triangle, stretch.to) - places.place(triangle, stretch.from);
    const double length = way.norm();
    if (std::abs(off) <= tolerance) co_return begin;
    if (!(length > 0)) co_return std::nullopt;
    const Vec2 up = Vec2(-way.y(), way.x()) / (off < 0 ? length : -length);
    const Weights climb = places.weights_of_way(triangle, up);
    if (!std::isfinite(climb[0])) co_return std::nullopt;  // of no area
    double most = length;
    for (uint32_t k = 0; k < 3; ++k)
        if (climb[k] < 0) most = std::min(most, -begin[k] / climb[k]);
    const auto place_at = [&](double t) {
        return Weights{begin[0] + t * climb[0], begin[1] + t * climb[1], begin[2] + t * climb[2]};
    };
    double near = 0, at_near = off;
    for (double far = std::abs(off); near < most; far *= 2) {
        far = std::min(far, most);
        const double at_far = places.at(triangle, place_at(far)).distance - lines.level_;
        if (lines.is_over(slice, triangle)) co_await pace;
        if ((at_far < 0) != (off < 0)) {
            LevelSearch search(near, at_near, far, at_far, tolerance);
            while (search.asks()) {
                search.take(places.at(triangle, place_at(search.at)).distance - lines.level_);
                if (lines.is_over(slice, triangle)) co_await pace;
            }
            co_return place_at(search.at);
        }
        near = far, at_near = at_far;
    }
    co_return std::nullopt;
}

// To its part on the wanted side, of which one end at least is labelled; false if there is none.
Task<bool> LevelLines::clip(Pace& pace, Slice& slice, const LevelLines& lines, LevelStretch& stretch) {
    const ExactPlaces& places = lines.places_;
    const bool from = lines.is_wanted(stretch.from_label), to = lines.is_wanted(stretch.to_label);
    if (stretch.from_label == SidedSegment::no_side && stretch.to_label == SidedSegment::no_side) {
        stretch.from_label = places.at(stretch.triangle, between(stretch.from, stretch.to, 0.5)).label;
        co_return lines.is_wanted(stretch.from_label);
    }
    if (from == to) co_return from;
    uint32_t& other = from ? stretch.to_label : stretch.from_label;
    if (other == SidedSegment::no_side) co_return true;
    LevelStretch rest = stretch;
    Weights& end = from ? stretch.to : stretch.from;
    bool any = false;
    for (uint32_t round = 0; round < side_rounds; ++round) {
        double wanted = from ? 0 : 1, unwanted = 1 - wanted;
        for (uint32_t step = 0; step < side_steps; ++step) {
            const double t = 0.5 * (wanted + unwanted);
            const uint32_t label = places.at(rest.triangle, between(rest.from, rest.to, t)).label;
            if (lines.is_wanted(label))
                wanted = t, other = label;
            else
                unwanted = t;
            if (lines.is_over(slice, rest.triangle)) co_await pace;
        }
        any = any || wanted != (from ? 0 : 1);
        const Weights across = between(rest.from, rest.to, wanted);
        const std::optional<Weights> on_level = co_await onto_level(pace, slice, lines, rest, across);
        end = on_level.value_or(across);
        const bool is_within = lines.is_wanted(places.at(rest.triangle, end).label);
        (is_within == from ? rest.from : rest.to) = end;
    }
    co_return any;
}

// Becomes part of the line, divided where its middle is off the level.
Task<void> LevelLines::refine(Pace& pace, Slice& slice, LevelLines& lines, LevelStretch stretch) {
    lines.pending_.push_back({stretch, 0});
    while (!lines.pending_.empty()) {
        const Pending next = lines.pending_.back();
        lines.pending_.pop_back();
        const LevelStretch& whole = next.stretch;
        const Weights middle = between(whole.from, whole.to, 0.5);
        const double off = lines.places_.at(whole.triangle, middle).distance - lines.level_;
        if (lines.is_over(slice, whole.triangle)) co_await pace;
        std::optional<Weights> place;
        if (std::abs(off) > offset_tolerance * lines.level_ && next.halvings < most_halvings)
            place = co_await onto_level(pace, slice, lines, whole, middle);
        if (!place) {
            lines.line_.push_back(whole);
            continue;
        }
        const uint32_t found = lines.places_.at(whole.triangle, *place).label;
        const uint32_t label = lines.is_wanted(found)              ? found
                               : lines.is_wanted(whole.from_label) ? whole.from_label
                                                                   : whole.to_label;
        lines.pending_.push_back({{whole.triangle, *place, whole.to, label, whole.to_label}, next.halvings + 1});
        lines.pending_.push_back({{whole.triangle, whole.from, *place, whole.from_label, label}, next.halvings + 1});
    }
}

void LevelLines::end_line(bool closed) {
    if (line_.empty()) return;
    Line& line = lines_.emplace_back(lines_.get_allocator().resource());
    line.stretches.swap(line_);
    line.closed = closed;
}

Task<void> draw_lines(Pace& pace, LevelLines& lines) {
    Slice slice(Cost::some_ns);
    for (const bool loops : {false, true}) {
        for (uint32_t first = 0; first < lines.crossings_.size(); ++first) {
            if (slice.is_over()) co_await pace;
            if (lines.crossings_[first].is_drawn || (!loops && lines.crossings_[first].has_preceding)) continue;
            // Of a loop from where it comes to the wanted side.
            uint32_t start = first;
            if (loops) {
                uint32_t at = first;
                for (size_t passed = 0;; ++passed) {
                    const uint32_t next = lines.crossings_[at].next;
                    if (next == no_index || passed > lines.crossings_.size())
                        throw Failure(FLG_ERROR_INTERNAL, "offset: a line of %zu crossings does not close", passed);
                    if (!lines.is_wanted(lines.crossings_[at].label) && lines.is_wanted(lines.crossings_[next].label)) {
                        start = at;
                        break;
                    }
                    at = next;
                    if (slice.is_over()) co_await pace;
                    if (at == first) break;
                }
            }
            bool is_whole = loops;
            for (uint32_t at = start; at != no_index;) {
                LevelCrossing& crossing = lines.crossings_[at];
                if (crossing.is_drawn) break;
                crossing.is_drawn = true;
                if (crossing.entered == no_index) break;
                const LevelPart& part = lines.parts_[crossing.entered];
                LevelStretch stretch{part.triangle, {}, {}, crossing.label, lines.crossings_[crossing.next].label};
                for (uint32_t k = 0; k < 3; ++k) {
                    const uint32_t own = lines.crossing_of_[3 * crossing.entered + k];
                    if (own == at) stretch.from = lines.crossing_place(part, k, crossing.at);
                    if (own == crossing.next) stretch.to = lines.crossing_place(part, k, lines.crossings_[own].at);
                }
                at = crossing.next;
                if (stretch.from_label == SidedSegment::no_side && stretch.to_label == SidedSegment::no_side &&
                    lines.length_of(part.triangle, stretch.from, stretch.to) <= sideless_length * lines.level_)
                    continue;
                const bool ends = !lines.is_wanted(stretch.to_label) && stretch.to_label != SidedSegment::no_side;
                const bool is_left = co_await LevelLines::clip(pace, slice, lines, stretch);
                if (is_left) co_await LevelLines::refine(pace, slice, lines, stretch);
                if (!is_left) is_whole = false;
                if (ends) {
                    is_whole = false;
                    lines.end_line(false);
                }
                if (slice.is_over()) co_await pace;
            }
            lines.end_line(is_whole);
        }
    }
}

// Points on the triangle's edges so that both sides see the same.
SurfacePoint to_point(const Mesh& mesh, uint32_t triangle, const Weights& weights) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t next = (k + 1) % 3;
        if (weights[(k + 2) % 3] != 0) continue;
        const Triple& corners = mesh.triangles[triangle];
        const bool rises = corners[k] < corners[next];
        const float t = round_on_edge(std::clamp(weights[rises ? next : k], 0.0, 1.0));
        return point_on_edge(3 * triangle + k, rises ? t : 1 - t);
    }
    const auto u = static_cast<float>(std::clamp(weights[1], 0.0, 1.0)),
               v = static_cast<float>(std::clamp(weights[2], 0.0, 1.0));
    return {triangle, u, std::min(v, 1 - u)};
}

Task<void> copy_lines(Pace& pace, LevelLines& lines, SurfaceCurves& out, std::pmr::deque<uint32_t>& pieces) {
    const bool backwards = lines.side_ == 1;
    // At a line's end rounding may leave a label without a side: then that of the stretch's other end.
    const auto piece_of = [&](uint32_t label, uint32_t other) {
        return (label < SidedSegment::beyond_end ? label : other) / 2;
    };
    uint32_t largest = 0;
    Buffer<uint32_t> firsts(lines.lines_.size(), pace.memory());
    co_await each(pace, lines.lines_.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const auto& stretches = lines.lines_[i].stretches;
        const LevelStretch &front = stretches[0], &back = stretches.back();
        firsts[i] = backwards ? piece_of(back.to_label, back.from_label) : piece_of(front.from_label, front.to_label);
        largest = std::max(largest, firsts[i]);
    });
    const Groups order =
        co_await group_by(pace, lines.lines_.size(), size_t{largest} + 1, [&](uint32_t i) { return firsts[i]; });
    for (uint32_t n = 0; n < lines.lines_.size(); ++n) {
        const LevelLines::Line& line = lines.lines_[order.items[n]];
        const auto count = static_cast<uint32_t>(line.stretches.size());
        const uint32_t begun = out.offsets.back();
        double length = 0;
        co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            LevelStretch stretch = line.stretches[backwards ? count - 1 - i : i];
            if (backwards) {
                std::swap(stretch.from, stretch.to);
                std::swap(stretch.from_label, stretch.to_label);
            }
            const SurfacePoint from = to_point(lines.mesh_, stretch.triangle, stretch.from),
                               to = to_point(lines.mesh_, stretch.triangle, stretch.to);
            if (from.u != to.u || from.v != to.v) {
                out.points.push_back(from);
                pieces.push_back(piece_of(stretch.from_label, stretch.to_label));
                length += lines.length_of(stretch.triangle, stretch.from, stretch.to);
            }
            if (i + 1 == count && !line.closed && out.points.size() > begun) {
                out.points.push_back(to);
                pieces.push_back(piece_of(stretch.to_label, stretch.from_label));
            }
        });
        const auto end = static_cast<uint32_t>(out.points.size());
        if (end - begun < (line.closed ? 3u : 2u) || (line.closed && length < lines.level_)) {
            out.points.resize(begun);
            pieces.resize(pieces.size() - (end - begun));
            continue;
        }
        out.offsets.push_back(end);
        out.closed.push_back(line.closed);
        out.values.push_back(static_cast<float>(length));
    }
}

}  // namespace

Task<void> add_offset_lines(Pace& pace, const Mesh& mesh, const SurfaceCurves& curves, double offset,
                            SurfaceCurves& out, std::pmr::deque<uint32_t>& pieces) {
    const RegionSet all(pace.memory());
    ExactFaces faces(mesh, pace.memory());
    co_await lay_out_faces(pace, mesh, all, faces);
    const double level = std::abs(offset);
    const SolveLimits limits{.distance = static_cast<float>(level + 2 * faces.longest),
                             .targets = std::pmr::vector<uint32_t>(pace.memory())};
    ExactSolver solver(mesh, faces, limits, pace.memory());
    GrowingList<Window> windows(pace.memory());
    std::pmr::deque<SidedSegment> laid(pace.memory());
    solver.keep_windows(level, windows);
    co_await begin_exact(pace, solver);
    ExactSources sources(mesh, all, solver);
    const uint32_t first = curves.offsets[0], last = curves.offsets[1] - 1;
    const bool closed = curves.closed[0];
    co_await each(pace, first, closed ? last + 1 : last, Cost::microseconds, [&](uint32_t i) {
        const SidedSegment labels{
            .piece = i - first, .begins = !closed && i == first, .ends = !closed && i + 1 == last};
        laid.push_back(sources.add_sided(curves.points[i], curves.points[i == last ? first : i + 1], labels));
    });
    co_await spread_exact(pace, solver);
    ExactPlaces places(solver, windows, laid, pace.memory());
    co_await sort_lights(pace, places);
    LevelLines lines(mesh, places, solver, offset, pace.memory());
    co_await choose_triangles(pace, lines);
    co_await divide_parts(pace, lines);
    co_await cross_edges(pace, lines);
    co_await draw_lines(pace, lines);
    co_await copy_lines(pace, lines, out, pieces);
}

}  // namespace flg
