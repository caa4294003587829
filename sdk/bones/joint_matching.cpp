// SPDX-License-Identifier: MIT
#include "bones/joint_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t none = no_joint_before;
constexpr double half_as_near = 0.5;
constexpr double most_turned = 1.2;          // all limbs at a joint together, in radians
constexpr double off = 0.55;                 // one limb from the others, in radians
constexpr double as_long = 2;                // a limb by another
constexpr double found = 1.5, turned = 0.3;  // a limb that is known again, against errors; a radian of all
constexpr double same_share = 0.2;           // of a limb's length
constexpr double about_as_long = 1.15;
constexpr uint32_t most_limbs = 32;  // of a joint that are compared with each other's

enum class Kind : uint8_t { end, between, fork };

class Tree {
public:
    static Task<Tree> make(Pace& pace, std::span<const DrawnJoint> joints) {
        Groups ends = co_await group_by(pace, 2 * joints.size(), joints.size(), [&](uint32_t e) {
            const uint32_t before = joints[e / 2].before;
            return before == none ? no_key : e % 2 == 0 ? e / 2 : before;
        });
        co_return Tree(joints, std::move(ends));
    }

    uint32_t count() const { return static_cast<uint32_t>(joints_.size()); }
    const Point2& at(uint32_t joint) const { return joints_[joint].at; }
    uint32_t degree(uint32_t joint) const { return static_cast<uint32_t>(ends_.of(joint).size()); }
    uint32_t neighbour(uint32_t joint, uint32_t k) const {
        const uint32_t e = ends_.of(joint)[k];
        return e % 2 == 0 ? joints_[joint].before : e / 2;
    }
    Kind kind(uint32_t joint) const {
        return degree(joint) < 2 ? Kind::end : degree(joint) == 2 ? Kind::between : Kind::fork;
    }

private:
    Tree(std::span<const DrawnJoint> joints, Groups ends) : joints_(joints), ends_(std::move(ends)) {}

    std::span<const DrawnJoint> joints_;
    Groups ends_;  // two a joint: of it, and of the one before
};

// The nearest of a tree's joints to a point, and how far the next one is.
struct Nearest {
    double distance, next = HUGE_VAL;
    uint32_t joint = none;
};

template <class Counts>
Nearest nearer(const Tree& tree, const Point2& at, uint32_t begin, uint32_t end, Nearest best, Counts may_be) {
    for (uint32_t i = begin; i < end; ++i) {
        if (!may_be(i)) continue;
        const double d = distance(at, tree.at(i));
        if (d < best.distance) {
            best.next = best.joint == none ? best.next : best.distance;
            best.distance = d, best.joint = i;
        } else {
            best.next = std::min(best.next, d);
        }
    }
    return best;
}

// From a joint to the next end, fork or joint that is known.
struct Limb {
    uint32_t first, count;  // among the joints of all limbs
    double length, direction;
    bool is_new;  // its first joint is not known
};

class Matcher {
public:
    Matcher(Pace& pace, const Tree& now, const Tree& then, double near)
        : pace_(pace),
          sides_{{{now, Buffer<uint32_t>(now.count(), pace.memory()), std::pmr::vector<Limb>(pace.memory()),
                   std::pmr::vector<uint32_t>(pace.memory()), std::pmr::vector<double>(pace.memory())},
                  {then, Buffer<uint32_t>(then.count(), pace.memory()), std::pmr::vector<Limb>(pace.memory()),
                   std::pmr::vector<uint32_t>(pace.memory()), std::pmr::vector<double>(pace.memory())}}},
          near_(near),
          known_(pace.memory()) {}

    Task<Buffer<uint32_t>> match() {
        for (Side& side : sides_)
            co_await each(pace_, side.same.size(), Cost::some_ns, [&](uint32_t j) { side.same[j] = none; });
        size_t next = 0;
        for (const Kind kind : {Kind::fork, Kind::end, Kind::between}) {
            co_await match_nearest([&](const Tree& tree, uint32_t j) { return tree.kind(j) == kind; }, half_as_near);
            for (; next < known_.size(); ++next) co_await match_limbs(known_[next]);
        }
        co_await match_nearest([](const Tree&, uint32_t) { return true; }, 1);
        co_return std::move(sides_[0].same);
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    struct Side {
        const Tree& tree;
        Buffer<uint32_t> same;              // by joint the other side's
        std::pmr::vector<Limb> limbs;       // of the joint that is looked at
        std::pmr::vector<uint32_t> joints;  // theirs
        std::pmr::vector<double> ways;      // from that joint, by joint of theirs
    };

    void join(uint32_t now, uint32_t then) {
        sides_[0].same[now] = then;
        sides_[1].same[then] = now;
        known_.push_back(now);
    }

    // By joint of one side that is not known the nearest one of the other.
    template <class Counts>
    Task<Buffer<Nearest>> nearest_of(uint32_t k, Counts counts) {
        const Side &own = sides_[k], &other = sides_[1 - k];
        Buffer<Nearest> out(own.tree.count(), pace_.memory());
        Slice slice(Cost::some_ns);
        for (uint32_t i = 0; i < own.tree.count(); ++i) {
            Nearest best{near_};
            if (own.same[i] == none && counts(own.tree, i)) {
                const auto may_be = [&](uint32_t j) { return other.same[j] == none && counts(other.tree, j); };
                for (Portion part(slice, 0, other.tree.count()); part.next();) {
                    best = nearer(other.tree, own.tree.at(i), part.begin, part.end, best, may_be);
                    if (part.is_over()) co_await pace_;
                }
            }
            out[i] = best;
            if (slice.is_over()) co_await pace_;
        }
        co_return out;
    }

    // Those that are each other's nearest, and nearer than that share of the next one's distance.
    template <class Counts>
    Task<void> match_nearest(Counts counts, double nearer_by) {
        const Buffer<Nearest> then_of = co_await nearest_of(0, counts);
        const Buffer<Nearest> now_of = co_await nearest_of(1, counts);
        co_await each(pace_, then_of.size(), Cost::tens_of_ns, [&](uint32_t i) {
            const Nearest& then = then_of[i];
            if (then.joint == none || now_of[then.joint].joint != i) return;
            const Nearest& now = now_of[then.joint];
            if (then.distance > nearer_by * std::min(then.next, now.next)) return;
            join(i, then.joint);
        });
    }

    // Those that leave a joint.
    Task<void> list_limbs(Side& side, uint32_t joint) {
        side.limbs.clear();
        side.joints.clear();
        side.ways.clear();
        Slice slice(Cost::tens_of_ns);
        const Tree& tree = side.tree;
        for (uint32_t k = 0; k < std::min(tree.degree(joint), most_limbs); ++k) {
            Limb limb{static_cast<uint32_t>(side.joints.size()), 0, 0, 0, false};
            uint32_t before = joint, at = tree.neighbour(joint, k);
            limb.is_new = side.same[at] == none;
            for (;;) {
                limb.length += distance(tree.at(before), tree.at(at));
                side.joints.push_back(at);
                side.ways.push_back(limb.length);
                if (slice.is_over()) co_await pace_;
                if (tree.kind(at) != Kind::between || side.same[at] != none) break;
                const uint32_t next = tree.neighbour(at, tree.neighbour(at, 0) == before ? 1 : 0);
                before = at, at = next;
            }
            limb.count = static_cast<uint32_t>(side.joints.size()) - limb.first;
            const Point2 middle = point_along(side, joint, limb, 0.5 * limb.length), &from = tree.at(joint);
            limb.direction = std::atan2(middle.y - from.y, middle.x - from.x);
            side.limbs.push_back(limb);
        }
    }

    static Point2 point_along(const Side& side, uint32_t joint, const Limb& limb, double way) {
        const double* ways = side.ways.data() + limb.first;
        const auto k = static_cast<uint32_t>(
            std::min<ptrdiff_t>(std::lower_bound(ways, ways + limb.count, way) - ways, limb.count - 1));
        const double before = k > 0 ? ways[k - 1] : 0, step = ways[k] - before;
        const uint32_t from = k > 0 ? side.joints[limb.first + k - 1] : joint;
        return mix(side.tree.at(from), side.tree.at(side.joints[limb.first + k]), step > 0 ? (way - before) / step : 0);
    }

    static double angle_between(double from, double to) { return std::remainder(to - from, 2 * std::numbers::pi); }

    // How little two limbs are the same one, `turn` apart; HUGE_VAL: they are not.
    double error_of(const Limb& now, const Limb& then, double turn) const {
        if (now.is_new != then.is_new) return HUGE_VAL;
        const uint32_t first = sides_[0].joints[now.first];
        if (!now.is_new && sides_[0].same[first] != sides_[1].joints[then.first]) return HUGE_VAL;
        const double angle = std::fabs(angle_between(then.direction + turn, now.direction));
        if (!now.is_new) return std::min(1.0, angle / off);
        const double longer = std::max(now.length, then.length), shorter = std::min(now.length, then.length);
        if (angle > off || !(longer <= as_long * shorter)) return HUGE_VAL;
        return angle / off + std::log(longer / shorter) / std::log(as_long);
    }

    using Pairs = std::array<uint32_t, most_limbs>;  // by limb of now the one of then

    // Limbs that are each other's best, all turned by one angle. Returns how well they fit.
    double pair_limbs(double turn, Pairs& pairs) const {
        const auto &now = sides_[0].limbs, &then = sides_[1].limbs;
        std::array<double, most_limbs> least_then;
        std::array<uint32_t, most_limbs> best_then;
        least_then.fill(HUGE_VAL);
        best_then.fill(none);
        double fit = -turned * std::fabs(turn);
        for (uint32_t i = 0; i < now.size(); ++i) {
            double least = HUGE_VAL;
            pairs[i] = none;
            for (uint32_t j = 0; j < then.size(); ++j) {
                const double error = error_of(now[i], then[j], turn);
                if (error < least) least = error, pairs[i] = j;
                if (error < least_then[j]) least_then[j] = error, best_then[j] = i;
            }
        }
        for (uint32_t i = 0; i < now.size(); ++i) {
            if (pairs[i] == none) continue;
            if (best_then[pairs[i]] == i)
                fit += found - least_then[pairs[i]];
            else
                pairs[i] = none;
        }
        return fit;
    }

    Task<void> match_limbs(uint32_t joint) {
        Side &now = sides_[0], &then = sides_[1];
        co_await list_limbs(now, joint);
        co_await list_limbs(then, now.same[joint]);
        Pairs pairs{}, best{};
        double fit = pair_limbs(0, best);
        Slice slice(Cost::tens_of_ns);
        const auto steps = static_cast<uint32_t>(now.limbs.size() * then.limbs.size());
        for (const Limb& a : now.limbs)
            for (const Limb& b : then.limbs) {
                const double turn = angle_between(b.direction, a.direction);
                if (std::fabs(turn) <= most_turned) {
                    const double other = pair_limbs(turn, pairs);
                    if (other > fit + 1e-9) fit = other, best = pairs;
                }
                if (slice.is_over(1 + steps)) co_await pace_;
            }
        for (uint32_t i = 0; i < now.limbs.size(); ++i)
            if (best[i] != none && now.limbs[i].is_new) co_await match_along(now.limbs[i], then.limbs[best[i]]);
    }

    // Joints that are each other's nearest along both limbs: by their share of the length, or by their way where one
    // limb has lost a piece. Of limbs about as long, both ends.
    Task<void> match_along(const Limb& now, const Limb& then) {
        const bool is_as_long = std::max(now.length, then.length) < about_as_long * std::min(now.length, then.length);
        const double unit_now = is_as_long ? now.length : 1, unit_then = is_as_long ? then.length : 1;
        const uint32_t end = now.first + now.count, end_then = then.first + then.count;
        if (is_as_long) match_if_new(end - 1, end_then - 1);
        Slice slice(Cost::tens_of_ns);
        for (uint32_t i = now.first; i < end; ++i) {
            const double place = sides_[0].ways[i] / unit_now;
            const uint32_t j = nearest_along(1, then, place * unit_then);
            const double place_then = sides_[1].ways[j] / unit_then;
            if (slice.is_over()) co_await pace_;
            if (nearest_along(0, now, place_then * unit_now) != i) continue;
            if (std::fabs(place - place_then) <= same_share * (is_as_long ? 1 : then.length)) match_if_new(i, j);
        }
    }
    void match_if_new(uint32_t i, uint32_t j) {
        const uint32_t now = sides_[0].joints[i], then = sides_[1].joints[j];
        if (sides_[0].same[now] == none && sides_[1].same[then] == none) join(now, then);
    }
    // Of a limb's joints.
    uint32_t nearest_along(uint32_t k, const Limb& limb, double way) const {
        const double* ways = sides_[k].ways.data();
        const double* after = std::lower_bound(ways + limb.first, ways + limb.first + limb.count - 1, way);
        const bool is_before = after > ways + limb.first && way - after[-1] < *after - way;
        return static_cast<uint32_t>(after - ways) - (is_before ? 1 : 0);
    }

    Pace& pace_;
    std::array<Side, 2> sides_;  // now and then
    double near_;
    std::pmr::vector<uint32_t> known_;  // of now, in the order they were found
};

}  // namespace

Task<Buffer<uint32_t>> match_joints(Pace& pace, std::span<const DrawnJoint> now, std::span<const DrawnJoint> then,
                                    double near) {
    if (now.empty() || then.empty()) {
        Buffer<uint32_t> out(now.size(), pace.memory());
        co_await each(pace, now.size(), Cost::some_ns, [&](uint32_t j) { out[j] = none; });
        co_return out;
    }
    const Tree now_tree = co_await Tree::make(pace, now);
    const Tree then_tree = co_await Tree::make(pace, then);
    Matcher matcher(pace, now_tree, then_tree, near);
    co_return co_await matcher.match();
}

}  // namespace flg
