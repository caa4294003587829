// SPDX-License-Identifier: MIT
#include "inflation/part_depths.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

#include "inflation/part_front.h"
#include "skeletons/node_clusters.h"
#include "skeletons/point2.h"

namespace flg {
namespace {

constexpr double about_parallel = 0.9;  // cosine between normals
constexpr double same_depth = 1e-6;     // of the drawing's size: planes that are nearer are one
constexpr double no_rise = 1e-9;        // of the drawing's size
constexpr double least_reach = 0.3;     // of `hold`: no part rises faster
constexpr double fork = 2;              // of `hold`: up to there an overlap that begins where parts hang is a fork
constexpr double broad = 3;             // of a part's radius: the same with what bears it, from `hold` on
constexpr double half_as_broad = 1.5;   // the same where they lie in one plane, and depths differ
constexpr double passes_by = 2;         // of a part's radius, from its joint
constexpr double gentle = 0.4, steepest = 1.5;  // a rise, by its reach
constexpr double within = 0.6;                  // of the height of what a part hangs on, that it may hang off the joint
constexpr uint32_t sweeps = 4;                  // over a raster's values outside

// The way from where a part hangs, on its raster.
class Ways {
public:
    static Task<Buffer<double>> make(Pace& pace, const ImplicitPart& placed, Vec3 joint) {
        const InflatedPart& part = placed.part();
        const size_t vertices = part.points.size(), triangles = part.triangles.size();
        const Vec3 at = placed.local(joint);
        uint32_t nearest = 0;
        double least = HUGE_VAL;
        const Groups corners = co_await corners_by_vertex(pace, part);
        Buffer<uint32_t> source_of(vertices, pace.memory());
        PartFront front(part, corners, source_of, pace.memory());
        co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
            front.clear(v);
            const double away = distance(part.points[v], {at.x(), at.y()});
            if (away < least) least = away, nearest = v;
        });
        front.offer(nearest, 0, 0);
        Slice slice(Cost::hundreds_of_ns);
        while (const uint32_t work = front.advance())
            if (slice.is_over(work)) co_await pace;

        Ways ways(part.raster, pace.memory());
        const auto values = static_cast<uint32_t>(ways.values_.size());
        co_await each(pace, values, Cost::some_ns, [&](uint32_t i) {
            ways.values_[i] = 0;
            ways.away_[i] = HUGE_VALF;
        });
        co_await each_by_work(pace, triangles, Cost::tens_of_ns,
                              [&](uint32_t t) { return ways.draw(part, part.triangles[t], front); });
        for (uint32_t sweep = 0; sweep < sweeps; ++sweep) {
            const bool forward = sweep % 2 == 0;
            co_await each(pace, values, Cost::tens_of_ns,
                          [&](uint32_t i) { ways.pass_on(forward ? i : values - 1 - i, forward ? -1 : 1); });
        }
        co_return std::move(ways.values_);
    }

private:
    Ways(const PartRaster& raster, Memory* memory)
        : raster_(raster), values_(raster.values.size(), memory), away_(raster.values.size(), memory) {}

    // Values in a triangle, between those of its corners.
    uint32_t draw(const InflatedPart& part, const TriangleVertices& t, const PartFront& front) {
        constexpr double slack = 1e-9;
        const Point2 &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
        const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const auto row_of = [&](double y) { return (y - raster_.origin.y) / raster_.spacing; };
        const auto column_of = [&](double x) { return (x - raster_.origin.x) / raster_.spacing; };
        const auto first_row = static_cast<uint32_t>(std::ceil(row_of(std::min({a.y, b.y, c.y})) - slack)),
                   last_row = static_cast<uint32_t>(row_of(std::max({a.y, b.y, c.y})) + slack);
        const auto first = static_cast<uint32_t>(std::ceil(column_of(std::min({a.x, b.x, c.x})) - slack)),
                   last = static_cast<uint32_t>(column_of(std::max({a.x, b.x, c.x})) + slack);
        for (uint32_t row = first_row; row <= last_row; ++row)
            for (uint32_t column = first; column <= last; ++column) {
                const double x = raster_.origin.x + raster_.spacing * column,
                             y = raster_.origin.y + raster_.spacing * row;
                const double of_b = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / twice,
                             of_c = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / twice;
                if (std::min({1 - of_b - of_c, of_b, of_c}) < -slack) continue;
                const size_t place = size_t{raster_.width} * row + column;
                values_[place] = (1 - of_b - of_c) * front.distance(t[0]) + of_b * front.distance(t[1]) +
                                 of_c * front.distance(t[2]);
                away_[place] = 0;
            }
        return 4 + (last_row + 1 - first_row) * (last + 1 - first);
    }

    // Outside: of the nearest value inside.
    void pass_on(uint32_t place, int sign) {
        if (away_[place] == 0) return;
        const auto x = static_cast<int>(place % raster_.width), y = static_cast<int>(place / raster_.width);
        constexpr int steps[4][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
        for (const auto& step : steps) {
            const int u = x + sign * step[0], v = y + sign * step[1];
            if (u < 0 || v < 0 || u >= static_cast<int>(raster_.width) || v >= static_cast<int>(raster_.height))
                continue;
            const size_t from = size_t{raster_.width} * static_cast<size_t>(v) + static_cast<size_t>(u);
            const float away = away_[from] + (step[0] != 0 && step[1] != 0 ? 1.414f : 1.0f);
            if (away >= away_[place]) continue;
            away_[place] = away;
            values_[place] = values_[from];
        }
    }

    const PartRaster& raster_;
    Buffer<double> values_;
    Buffer<float> away_;  // from the contour, in values
};

// Two parts that may cross.
struct Pair {
    std::array<uint32_t, 2> parts;
    // From the nearest part that bears both to where each hangs; below 0: that part itself.
    std::array<double, 2> before{};
    std::array<double, 2> hold{};  // of the limbs that they belong to there
    bool overlap = false, cross = false;
    bool bones_cross = false;               // away from where they hang
    bool is_rooted = false;                 // where one hangs, the other bears it, directly or not, and is there too
    std::array<double, 2> needed = {0, 0};  // how far to move the first, the second in front
    std::array<double, 2> first = {HUGE_VAL, HUGE_VAL};  // the least way to where they cross; in contours' units
};

constexpr double bears_other = -1;

class Arrangement {
public:
    Arrangement(const DrawnParts& drawn, Memory* memory)
        : drawn_(drawn),
          shapes_(memory),
          pairs_(memory),
          ways_(memory),
          levels_(memory),
          joints_(memory),
          unit_(memory),
          depth_(memory) {}

    static Task<PartDepths> make(Pace& pace, DrawnParts drawn) {
        Arrangement all(drawn, pace.memory());
        co_await place_parts(pace, all);
        co_await list_pairs(pace, all);
        co_await look_for_overlaps(pace, all);
        co_await measure_crossings(pace, all);
        PartDepths out(pace.memory());
        out.lifts.resize(all.count());
        if (std::any_of(all.pairs_.begin(), all.pairs_.end(), [](const Pair& pair) { return pair.cross; })) {
            co_await make_units(pace, all);
            co_await choose_depths(pace, all);
            co_await set_lifts(pace, all, out);
        }
        co_await list_apart(pace, all, out);
        // One by one: all at once they would take longer to be given back than a slice may.
        for (; !all.ways_.empty(); all.ways_.pop_back()) co_await pace;
        co_return out;
    }

private:
    uint32_t count() const { return static_cast<uint32_t>(drawn_.parts.size()); }
    bool is_root(uint32_t part) const { return drawn_.hung[part].parent == no_part; }

    static Task<void> place_parts(Pace& pace, Arrangement& all) {
        const uint32_t count = all.count();
        all.shapes_.reserve(count);
        all.levels_.resize(count);
        all.ways_.resize(count);
        Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
        co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t p) {
            const ImplicitPart& shape = all.shapes_.emplace_back(all.drawn_.parts[p], p);
            low = low.cwiseMin(shape.low());
            high = high.cwiseMax(shape.high());
        });
        all.size_ = (high - low).norm();
        all.joints_.reserve(count);
        co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t p) {
            const HungPart& hung = all.drawn_.hung[p];
            const bool is_own = hung.parent == no_part || all.is_inside(hung.parent, hung.joint);
            all.joints_.push_back(is_own ? hung.joint : hung.bearing);
        });
        Slice slice(Cost::some_ns);
        for (uint32_t p = 0; p < count; ++p)
            for (uint32_t at = p; !all.is_root(at); at = all.drawn_.hung[at].parent) {
                ++all.levels_[p];
                if (slice.is_over()) co_await pace;
            }
        uint32_t root = 0;
        while (!all.is_root(root)) ++root;
        all.front_ = all.shapes_[root].normal();
    }

    // 1 or -1: where a part's normal points; 0: it is not parallel to the drawing.
    double side(uint32_t part) const {
        const double cosine = shapes_[part].normal().dot(front_);
        return std::fabs(cosine) < about_parallel ? 0 : cosine < 0 ? -1 : 1;
    }

    bool bears_one(const Pair& pair) const { return pair.before[0] == bears_other || pair.before[1] == bears_other; }

    bool boxes_meet(uint32_t a, uint32_t b) const {
        return ((shapes_[a].low() - shapes_[b].high()).array() < 0).all() &&
               ((shapes_[b].low() - shapes_[a].high()).array() < 0).all();
    }

    static Task<void> list_pairs(Pace& pace, Arrangement& all) {
        Slice slice(Cost::some_ns);
        for (uint32_t a = 0; a < all.count(); ++a)
            for (uint32_t b = a + 1; b < all.count(); ++b) {
                if (slice.is_over()) co_await pace;
                if (!all.boxes_meet(a, b) || all.drawn_.hung[a].twin == b || all.side(a) == 0 || all.side(b) == 0)
                    continue;
                Pair pair{.parts = {a, b}};
                if (all.measure_before(pair)) all.pairs_.push_back(pair);
                if (slice.is_over(all.levels_[a] + all.levels_[b] + 16)) co_await pace;
            }
    }

    // False: nothing bears both.
    bool measure_before(Pair& pair) const {
        std::array<uint32_t, 2> at = pair.parts, limb = {no_part, no_part};
        while (at[0] != at[1]) {
            const uint32_t lower = levels_[at[0]] >= levels_[at[1]] ? 0 : 1;
            const HungPart& hung = drawn_.hung[at[lower]];
            if (hung.parent == no_part) return false;
            if (limb[lower] != no_part) pair.before[lower] += (joints_[at[lower]] - joints_[limb[lower]]).norm();
            limb[lower] = at[lower];
            pair.hold[lower] = hung.hold;
            at[lower] = hung.parent;
        }
        for (uint32_t k = 0; k < 2; ++k)
            if (limb[k] == no_part) pair.before[k] = bears_other;
        return true;
    }

    // What is over a vertex of one of two parts.
    struct Over {
        double height = 0, other = 0;  // half of the two bodies' thickness there; in the model's units
        double behind = 0;             // how far the other's plane is behind
        Point2 at{};                   // in the other's plane
    };
    bool is_over(uint32_t part, uint32_t vertex, uint32_t other, Over& out) const {
        const ImplicitPart &own = shapes_[part], &shape = shapes_[other];
        const Point2& p = own.part().points[vertex];
        const Vec3 at = shape.local(own.place({p.x, p.y, 0}));
        const PartRaster& raster = shape.part().raster;
        const double x = (at.x() - raster.origin.x) / raster.spacing, y = (at.y() - raster.origin.y) / raster.spacing;
        if (!(x > 1 && y > 1 && x < raster.width - 2.0 && y < raster.height - 2.0)) return false;
        const double square = shape.squared_height(at.x(), at.y());
        if (!(square > 0)) return false;
        out.height = own.scale() * own.thickness() * std::sqrt(own.part().squares[vertex]);
        out.other = shape.scale() * std::sqrt(square);
        out.behind = side(other) * shape.scale() * at.z();
        out.at = {at.x(), at.y()};
        return std::fabs(out.behind) < out.height + out.other;
    }

    // Which parts' ways are to be measured: those of pairs that overlap where they may cross.
    static Task<void> look_for_overlaps(Pace& pace, Arrangement& all) {
        for (Pair& pair : all.pairs_)
            for (uint32_t k = 0; k < 2; ++k) {
                const uint32_t part = pair.parts[k], other = pair.parts[1 - k];
                co_await each(pace, all.shapes_[part].part().points.size(), Cost::hundreds_of_ns, [&](uint32_t v) {
                    Over over;
                    if (!pair.overlap) pair.overlap = all.is_over(part, v, other, over) && all.may_cross(pair, k, v);
                });
            }
    }

    // No way is shorter than the straight line; few that cross are much longer.
    bool may_cross(const Pair& pair, uint32_t k, uint32_t vertex) const {
        constexpr double straight = 0.8;
        const ImplicitPart& own = shapes_[pair.parts[k]];
        const Point2& p = own.part().points[vertex];
        const Vec3 at = own.place({p.x, p.y, 0});
        for (uint32_t i = 0; i < 2; ++i)
            if (pair.before[i] != bears_other &&
                (at - joints_[pair.parts[i]]).norm() + pair.before[i] < straight * pair.hold[i])
                return false;
        return true;
    }

    static Task<void> measure_crossings(Pace& pace, Arrangement& all) {
        const Groups bones = co_await group_by(pace, all.drawn_.bones.size(), all.count(),
                                               [&](uint32_t bone) { return all.drawn_.bones[bone].part; });
        for (Pair& pair : all.pairs_) {
            if (!pair.overlap) continue;
            for (uint32_t k = 0; k < 2; ++k)
                if (pair.before[k] != bears_other) co_await measure_way(pace, all, pair.parts[k]);
            if (all.bears_one(pair)) {
                pair.is_rooted = all.is_rooted(pair);
            } else {
                const auto own = bones.of(pair.parts[0]), others = bones.of(pair.parts[1]);
                co_await each(pace, own.size() * others.size(), Cost::tens_of_ns, [&](uint32_t i) {
                    if (!pair.bones_cross)
                        pair.bones_cross = all.bones_cross(pair, own[i / others.size()], others[i % others.size()]);
                });
            }
            for (uint32_t k = 0; k < 2; ++k) co_await measure_overlap(pace, all, pair, k);
        }
    }

    bool is_rooted(const Pair& pair) const {
        const uint32_t limb = pair.before[0] == bears_other ? 1 : 0;
        return is_inside(pair.parts[1 - limb], joints_[pair.parts[limb]]);
    }
    bool is_inside(uint32_t part, const Vec3& p) const {
        const Vec3 at = shapes_[part].local(p);
        return shapes_[part].squared_height(at.x(), at.y()) > at.z() * at.z();
    }

    // Seen from the front.
    bool bones_cross(const Pair& pair, uint32_t own, uint32_t other) const {
        const ImplicitPart& shape = shapes_[pair.parts[0]];
        const auto flat = [&](const Vec3& p) {
            const Vec3 at = shape.local(p);
            return Point2{at.x(), at.y()};
        };
        const BoneSegment &a = drawn_.bones[own], &b = drawn_.bones[other];
        const Point2 from = flat(a.from), to = flat(a.to);
        if (!stretches_meet(from, to, flat(b.from), flat(b.to))) return false;
        // Where they do.
        const Vec3 across = b.to - b.from, along = a.to - a.from, between = b.from - a.from;
        const double turn = along.cross(across).dot(front_);
        const double share = turn != 0 ? std::clamp(between.cross(across).dot(front_) / turn, 0.0, 1.0) : 0;
        const Vec3 at = a.from + share * along;
        for (uint32_t i = 0; i < 2; ++i)
            if (pair.before[i] + (at - joints_[pair.parts[i]]).norm() < pair.hold[i]) return false;
        return true;
    }

    struct Met {
        Over over;
        std::array<double, 2> ways;
        bool is_there = false, is_held = false;
    };

    // Overlaps that hang together with where the parts are held are told from the others.
    static Task<void> measure_overlap(Pace& pace, const Arrangement& all, Pair& pair, uint32_t k) {
        const InflatedPart& part = all.shapes_[pair.parts[k]].part();
        const size_t vertices = part.points.size();
        Buffer<Met> met(vertices, pace.memory());
        NodeClusters pieces(vertices, pace.memory());
        Buffer<double> beyond(vertices, pace.memory());  // by piece, how far it goes on; below 0: it is not held
        co_await each(pace, vertices, Cost::hundreds_of_ns, [&](uint32_t v) {
            std::construct_at(&met[v], all.meet(pair, k, v));
            pieces.begin(v);
            beyond[v] = bears_other;
        });
        co_await each(pace, part.triangles.size(), Cost::tens_of_ns, [&](uint32_t i) {
            const TriangleVertices& t = part.triangles[i];
            for (uint32_t c = 0; c < 3; ++c)
                if (met[t[c]].is_there && met[t[(c + 1) % 3]].is_there) pieces.join(t[c], t[(c + 1) % 3]);
        });
        co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
            if (met[v].is_there && met[v].is_held) beyond[pieces.first(v)] = 0;
        });
        co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
            if (!met[v].is_there || beyond[pieces.first(v)] < 0) return;
            double& farthest = beyond[pieces.first(v)];
            farthest = std::max(farthest, all.beyond(pair, met[v]));
        });
        co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
            if (met[v].is_there && !met[v].is_held && all.crosses(pair, met[v], beyond[pieces.first(v)]))
                all.add_crossing(pair, k, met[v]);
        });
    }

    // Where ways begin: where it hangs, unless a limb passes by that place, as an arm across the chest does.
    static Task<Vec3> begin_of(Pace& pace, const Arrangement& all, uint32_t part) {
        const Vec3 &own = all.drawn_.hung[part].joint, &at = all.joints_[part];
        const ImplicitPart& shape = all.shapes_[part];
        const Vec3 local = shape.local(at), own_local = shape.local(own);
        if (shape.squared_height(local.x(), local.y()) > 0) co_return at;
        const auto& points = shape.part().points;
        Point2 nearest{own_local.x(), own_local.y()};
        double least = HUGE_VAL;
        co_await each(pace, points.size(), Cost::some_ns, [&](uint32_t v) {
            const double away = distance(points[v], {local.x(), local.y()});
            if (away < least) least = away, nearest = points[v];
        });
        const double off = shape.scale() * distance(nearest, {own_local.x(), own_local.y()});
        co_return off > passes_by* shape.radius() ? own : at;
    }

    static Task<void> measure_way(Pace& pace, Arrangement& all, uint32_t part) {
        if (!all.ways_[part].empty()) co_return;
        const Vec3 begin = co_await begin_of(pace, all, part);
        all.ways_[part] = co_await Ways::make(pace, all.shapes_[part], begin);
    }

    // In the contour's units; the nearest value on the raster.
    double way(uint32_t part, const Point2& at) const {
        const PartRaster& raster = shapes_[part].part().raster;
        const auto column = static_cast<size_t>((at.x - raster.origin.x) / raster.spacing + 0.5),
                   row = static_cast<size_t>((at.y - raster.origin.y) / raster.spacing + 0.5);
        return ways_[part][raster.width * row + column];
    }

    Met meet(const Pair& pair, uint32_t k, uint32_t vertex) const {
        Met met{.over = {}, .ways = {HUGE_VAL, HUGE_VAL}};
        met.is_there = is_over(pair.parts[k], vertex, pair.parts[1 - k], met.over);
        if (!met.is_there) return met;
        for (uint32_t i = 0; i < 2; ++i) {
            if (pair.before[i] == bears_other) continue;
            met.ways[i] = way(pair.parts[i], i == k ? shapes_[pair.parts[k]].part().points[vertex] : met.over.at);
            met.is_held =
                met.is_held || total(pair, i, met.ways[i]) < pair.hold[i] ||
                (pair.is_rooted && met.ways[i] * shapes_[pair.parts[i]].scale() < drawn_.hung[pair.parts[i]].hold);
        }
        return met;
    }
    // From what bears both.
    double total(const Pair& pair, uint32_t i, double way) const {
        return pair.before[i] + way * shapes_[pair.parts[i]].scale();
    }
    // Where both, or the one that hangs on the other, are held.
    double beyond(const Pair& pair, const Met& met) const {
        double least = HUGE_VAL;
        for (uint32_t i = 0; i < 2; ++i)
            if (pair.before[i] != bears_other) least = std::min(least, total(pair, i, met.ways[i]) - pair.hold[i]);
        return std::max(0.0, least);
    }

    // `goes_on`: how far the overlap does from where the parts are held; below 0: it is another.
    bool crosses(const Pair& pair, const Met& met, double goes_on) const {
        if (goes_on < 0 || pair.bones_cross) return true;
        if (bears_one(pair)) {
            const uint32_t limb = pair.parts[pair.before[0] == bears_other ? 1 : 0];
            const bool is_asked = drawn_.hung[pair.parts[0]].depth != drawn_.hung[pair.parts[1]].depth &&
                                  plane(pair.parts[0]) == plane(pair.parts[1]);
            return goes_on > (is_asked ? half_as_broad : broad) * shapes_[limb].radius();
        }
        return total(pair, 0, met.ways[0]) > fork * pair.hold[0] && total(pair, 1, met.ways[1]) > fork * pair.hold[1];
    }

    void add_crossing(Pair& pair, uint32_t k, const Met& met) const {
        pair.cross = true;
        const double heights = met.over.height + met.over.other + drawn_.gap;
        pair.needed[k] = std::max(pair.needed[k], heights - met.over.behind);
        pair.needed[1 - k] = std::max(pair.needed[1 - k], heights + met.over.behind);
        for (uint32_t i = 0; i < 2; ++i) pair.first[i] = std::min(pair.first[i], met.ways[i]);
    }

    // Larger: farther in front.
    std::tuple<double, double, double> rank(uint32_t part) const {
        const HungPart& hung = drawn_.hung[part];
        const double turned = hung.is_turned ? -1 : 1;
        return {turned * hung.depth, plane(part), turned * part};
    }
    // Rounded: planes that are nearer to each other are one.
    double plane(uint32_t part) const {
        return std::round(front_.dot(shapes_[part].low() + shapes_[part].high()) / 2 / (same_depth * size_));
    }

    // What bears a part stays where it is for that one.
    bool moves_for(uint32_t part, const Pair& pair) const {
        return pair.cross && ((pair.parts[0] == part && pair.before[0] != bears_other) ||
                              (pair.parts[1] == part && pair.before[1] != bears_other));
    }
    // Parts by level, those above before those that hang on them; each with the part that it moves with.
    static Task<void> make_units(Pace& pace, Arrangement& all) {
        all.unit_.resize(all.count());
        all.order_ = co_await group_by(pace, all.count(), all.count(), [&](uint32_t p) { return all.levels_[p]; });
        const Groups crossings = co_await group_by(pace, 2 * all.pairs_.size(), all.count(), [&](uint32_t end) {
            const Pair& pair = all.pairs_[end / 2];
            return all.moves_for(pair.parts[end % 2], pair) ? pair.parts[end % 2] : no_key;
        });
        co_await each_by_work(pace, all.count(), Cost::tens_of_ns, [&](uint32_t i) {
            const uint32_t p = all.order_.items[i];
            const auto own = crossings.of(p);
            all.unit_[p] = p;
            if (all.is_root(p)) return 1u;
            const uint32_t above = all.unit_[all.drawn_.hung[p].parent];
            const bool is_deeper = all.drawn_.hung[p].depth != all.drawn_.hung[above].depth && !own.empty();
            // Of the others those count that come before it.
            const bool crosses = std::any_of(own.begin(), own.end(), [&](uint32_t end) {
                const uint32_t other = all.pairs_[end / 2].parts[1 - end % 2];
                return all.is_root(above) || (std::tuple(all.levels_[other], other) < std::tuple(all.levels_[p], p) &&
                                              all.unit_[other] == above);
            });
            if (!is_deeper && !crosses) all.unit_[p] = above;
            return 1 + static_cast<uint32_t>(own.size());
        });
    }

    // Units from behind to the front: sorted by a heap, as that may pause.
    static Task<Buffer<uint32_t>> sort_by_rank(Pace& pace, const Arrangement& all) {
        Buffer<uint32_t> order(all.count(), pace.memory());
        const auto is_behind = [&](uint32_t a, uint32_t b) { return all.rank(a) < all.rank(b); };
        co_await each(pace, all.count(), Cost::hundreds_of_ns, [&](uint32_t p) {
            order[p] = p;
            std::push_heap(order.begin(), order.begin() + p + 1, is_behind);
        });
        co_await each(pace, all.count(), Cost::microseconds,
                      [&](uint32_t i) { std::pop_heap(order.begin(), order.end() - i, is_behind); });
        co_return order;
    }

    // Of each unit, along the drawing's front.
    static Task<void> choose_depths(Pace& pace, Arrangement& all) {
        struct Asked {
            uint32_t behind, front;
            double distance;
        };
        const uint32_t count = all.count();
        std::pmr::deque<Asked> asked(pace.memory());
        co_await each(pace, all.pairs_.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
            const Pair& pair = all.pairs_[i];
            const uint32_t a = all.unit_[pair.parts[0]], b = all.unit_[pair.parts[1]];
            if (!pair.cross || a == b) return;
            const bool a_behind = all.rank(a) < all.rank(b);
            asked.push_back({a_behind ? a : b, a_behind ? b : a, pair.needed[a_behind ? 1 : 0]});
        });
        const Groups from = co_await group_by(pace, asked.size(), count, [&](uint32_t i) { return asked[i].behind; });
        const Groups to = co_await group_by(pace, asked.size(), count, [&](uint32_t i) { return asked[i].front; });
        const Buffer<uint32_t> order = co_await sort_by_rank(pace, all);
        struct Chain {
            double behind = 0, before = 0;              // sums of distances, from what moves
            double least = -HUGE_VAL, most = HUGE_VAL;  // because of what does not
        };
        std::pmr::vector<Chain> chains(count, pace.memory());
        co_await each(pace, count, Cost::some_ns, [&](uint32_t p) {
            if (all.is_root(p)) chains[p].least = chains[p].most = 0;
        });
        co_await each_by_work(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            const Chain& own = chains[order[i]];
            for (const uint32_t ask : from.of(order[i])) {
                Chain& front = chains[asked[ask].front];
                if (all.is_root(asked[ask].front)) continue;
                front.least = std::max(front.least, own.least + asked[ask].distance);
                if (!all.is_root(order[i])) front.behind = std::max(front.behind, own.behind + asked[ask].distance);
            }
            return 1 + static_cast<uint32_t>(from.of(order[i]).size());
        });
        co_await each_by_work(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            const uint32_t unit = order[count - 1 - i];
            const Chain& own = chains[unit];
            for (const uint32_t ask : to.of(unit)) {
                Chain& behind = chains[asked[ask].behind];
                if (all.is_root(asked[ask].behind)) continue;
                behind.most = std::min(behind.most, own.most - asked[ask].distance);
                if (!all.is_root(unit)) behind.before = std::max(behind.before, own.before + asked[ask].distance);
            }
            return 1 + static_cast<uint32_t>(to.of(unit).size());
        });
        all.depth_.resize(count);
        co_await each(pace, count, Cost::some_ns, [&](uint32_t p) {
            const Chain& own = chains[p];
            all.depth_[p] = std::min(own.most, std::max(own.least, (own.behind - own.before) / 2));
        });
    }

    // From where it hangs, parents first.
    static Task<void> set_lifts(Pace& pace, Arrangement& all, PartDepths& out) {
        std::pmr::vector<double> first(all.count(), HUGE_VAL, pace.memory());
        co_await each(pace, all.pairs_.size(), Cost::tens_of_ns, [&](uint32_t i) {
            const Pair& pair = all.pairs_[i];
            for (uint32_t k = 0; k < 2; ++k)
                if (pair.cross) first[pair.parts[k]] = std::min(first[pair.parts[k]], pair.first[k]);
        });
        Slice slice(Cost::microseconds);
        for (const uint32_t p : all.order_.items) {
            if (slice.is_over()) co_await pace;
            if (all.is_root(p) || all.side(p) == 0) continue;
            const HungPart& hung = all.drawn_.hung[p];
            const ImplicitPart above(with_lift(all.drawn_.parts[hung.parent], out.lifts[hung.parent]), hung.parent);
            const Vec3 joint = above.local(all.joints_[p]);
            double base = all.side(hung.parent) * above.scale() * above.lift(joint.x(), joint.y());
            double rise = all.depth_[all.unit_[p]] - base;
            const double scale = all.shapes_[p].scale(), unit = all.side(p) / scale;
            PartLift& lift = out.lifts[p];
            lift.reach = std::max(first[p] < HUGE_VAL ? first[p] : hung.hold / scale, least_reach * hung.hold / scale);
            const double room =
                within * above.scale() * std::sqrt(std::max(0.0, above.squared_height(joint.x(), joint.y())));
            const double off = std::clamp(std::fabs(rise) - gentle * lift.reach * scale, 0.0, room);
            base += std::copysign(off, rise);
            rise -= std::copysign(off, rise);
            lift.base = base * unit;
            lift.reach = std::max(lift.reach, std::fabs(rise) / (steepest * scale));
            if (std::fabs(rise) <= no_rise * all.size_ || !(lift.reach > 0)) continue;
            lift.rise = rise * unit;
            co_await measure_way(pace, all, p);
            lift.ways = std::move(all.ways_[p]);
        }
    }

    static PlacedPart with_lift(PlacedPart part, const PartLift& lift) {
        part.lift = &lift;
        return part;
    }

    static Task<void> list_apart(Pace& pace, const Arrangement& all, PartDepths& out) {
        std::pmr::vector<std::array<uint32_t, 2>> apart(pace.memory());
        apart.reserve(all.drawn_.apart.size() + all.pairs_.size());
        co_await each_by_work(pace, all.drawn_.apart.size(), Cost::some_ns, [&](uint32_t i) {
            const auto& [a, b] = all.drawn_.apart[i];
            if (!all.bears(a, b) && !all.bears(b, a)) apart.push_back({a, b});
            return 8 + all.levels_[a] + all.levels_[b];
        });
        co_await each(pace, all.pairs_.size(), Cost::tens_of_ns, [&](uint32_t i) {
            const Pair& pair = all.pairs_[i];
            if (pair.cross && !all.bears_one(pair)) apart.push_back(pair.parts);
        });
        out.apart = co_await group_by(pace, 2 * apart.size(), all.count(),
                                      [&](uint32_t end) { return apart[end / 2][end % 2]; });
        co_await each(pace, out.apart.items.size(), Cost::some_ns, [&](uint32_t i) {
            uint32_t& item = out.apart.items[i];
            item = apart[item / 2][1 - item % 2];
        });
    }

    bool bears(uint32_t part, uint32_t other) const {
        while (levels_[other] > levels_[part]) other = drawn_.hung[other].parent;
        return part == other;
    }

    DrawnParts drawn_;
    std::pmr::vector<ImplicitPart> shapes_;
    std::pmr::deque<Pair> pairs_;
    std::pmr::deque<Buffer<double>> ways_;  // by part; none: not needed
    std::pmr::vector<uint32_t> levels_;     // by part: how many it hangs on, one on the other
    std::pmr::vector<Vec3> joints_;         // by part: where it hangs, within what it hangs on
    Groups order_;                          // parts by level
    std::pmr::vector<uint32_t> unit_;       // by part
    std::pmr::vector<double> depth_;        // by unit
    Vec3 front_ = Vec3::UnitZ();
    double size_ = 0;
};

}  // namespace

Task<PartDepths> find_depths(Pace& pace, DrawnParts drawn) {
    co_return co_await Arrangement::make(pace, drawn);
}

}  // namespace flg
