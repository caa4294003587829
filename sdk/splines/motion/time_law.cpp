// SPDX-License-Identifier: MIT
#include "splines/motion/time_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

namespace {

constexpr double max_rate = 3;          // of the mean one of an interval
constexpr double least_square = 1e-12;  // of rates that are not at rest: else the motion would never go on
constexpr int halvings = 50;
constexpr double max_fall = 0.02;  // half the share of the square of the rate that it may lose in a step
constexpr double at_rest = 0.1;    // of the speed two steps away

struct Range {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    bool empty() const { return !(low <= high); }
};

// The a for which |second v + first a| is within a limit.
void restrict(const Vec3& first, const Vec3& second, double v, double limit, Range& range) {
    if (limit == 0) return;
    const double square = first.squaredNorm(), product = first.dot(second) * v;
    const double rest = second.squaredNorm() * v * v - limit * limit;
    const double discriminant = product * product - square * rest;
    if (rest > 0 && !(discriminant >= 0 && square > 0)) {
        range = {1, -1};
        return;
    }
    if (!(square > 0)) return;
    const double root = std::sqrt(std::max(discriminant, 0.0));
    range.low = std::max(range.low, (-product - root) / square);
    range.high = std::min(range.high, (-product + root) / square);
}

Range range_at(const NodeMotion& node, const MotionLimits& limits, double v) {
    Range range;
    restrict(node.velocity, node.acceleration, v, limits.acceleration, range);
    restrict(node.turn, node.turn_acceleration, v, limits.turn_acceleration, range);
    return range;
}

uint32_t step_count(const MotionSteps& steps) {
    return static_cast<uint32_t>(steps.times.size()) - 1;
}

Vec3 mean_of(std::span<const double> changes, const MotionSteps& steps, uint32_t step) {
    const double duration = steps.times[step + 1] - steps.times[step];
    return Vec3(changes[3 * step], changes[3 * step + 1], changes[3 * step + 2]) / duration;
}

// What the square of the rate may be, by what happens just before or after a node: such that it need not fall by more
// than a share in the next step to keep to the limits, nor rise above 1. Else, where the motion hardly moves, any rate
// could be made good by a change of it.
double cap_of(const MotionSteps& steps, const MotionLimits& limits, uint32_t node, NodeSide side, double v) {
    const uint32_t count = step_count(steps);
    const bool after = side == NodeSide::after;
    if (!steps.closed && node == (after ? count : 0)) return v;
    const uint32_t step = (node + count - (after ? 0 : 1)) % count;
    const double duration = steps.times[step + 1] - steps.times[step];
    const NodeMotion motion = motion_at(steps, node, side);
    const auto fits = [&](double square) {
        Range range = range_at(motion, limits, square);
        const double fall = square * max_fall / duration, rise = (1 - square) / (2 * duration);
        range.low = std::max(range.low, after ? -fall : -rise);
        range.high = std::min(range.high, after ? rise : fall);
        return !range.empty();
    };
    if (fits(v)) return v;
    // What is allowed is convex, and 0 is: one bound.
    double low = 0, high = v;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

// The greatest square of the rate at a node, whatever its neighbours are.
double cap_at(const MotionSteps& steps, const MotionLimits& limits, uint32_t node) {
    const NodeMotion before = motion_at(steps, node, NodeSide::before), after = motion_at(steps, node, NodeSide::after);
    double fastest = std::max(before.velocity.norm(), after.velocity.norm());
    double turns = std::max(before.turn.norm(), after.turn.norm());
    double width = 0;  // of the steps beside the node
    for (const uint32_t beside : {0u, 1u}) {
        const uint32_t count = step_count(steps), step = node + beside;
        if (!steps.closed && (step == 0 || step > count)) continue;
        const uint32_t of = (step + count - 1) % count;
        width += steps.times[of + 1] - steps.times[of];
        fastest = std::max(fastest, mean_of(steps.moved, steps, of).norm());
        turns = std::max(turns, mean_of(steps.turned, steps, of).norm());
    }
    double rate = 1;
    if (limits.speed > 0) rate = std::min(rate, limits.speed / fastest);
    if (limits.turn > 0) rate = std::min(rate, limits.turn / turns);
    double v = rate * rate;
    const auto take_up = [&](const Vec3& jump, double limit) {
        if (limit > 0) v = std::min(v, limit / (2 / width * jump).norm());
    };
    take_up(after.velocity - before.velocity, limits.acceleration);
    take_up(after.turn - before.turn, limits.turn_acceleration);
    return std::min(cap_of(steps, limits, node, NodeSide::before, v), cap_of(steps, limits, node, NodeSide::after, v));
}

// Whether an open motion comes to rest at its end by itself, as eased ones do: slower than two steps further inwards.
bool is_at_rest(const MotionSteps& steps, uint32_t end) {
    const uint32_t count = step_count(steps), inwards = std::min(count, 2u);
    const NodeSide side = end == 0 ? NodeSide::after : NodeSide::before;
    const NodeMotion at = motion_at(steps, end, side),
                     inner = motion_at(steps, end == 0 ? inwards : end - inwards, side);
    return at.velocity.norm() <= at_rest * inner.velocity.norm() && at.turn.norm() <= at_rest * inner.turn.norm();
}

}  // namespace

double LawWalk::parameter_at(double time) {
    const size_t last = law_.times.size() - 1;
    while (entry_ + 1 < last && time >= law_.times[entry_ + 1]) ++entry_;
    const double begin = law_.times[entry_], duration = law_.times[entry_ + 1] - begin;
    const double from = law_.parameters[entry_], to = law_.parameters[entry_ + 1];
    if (time <= begin) return from;
    if (time >= law_.times[entry_ + 1]) return to;
    const double u = (time - begin) / duration, change = to - from;
    const double first = std::min(law_.rates[2 * entry_ + 1] * duration, max_rate * change);
    const double second = std::min(law_.rates[2 * entry_ + 2] * duration, max_rate * change);
    const double value = from + u * (first + u * (3 * change - 2 * first - second + u * (first + second - 2 * change)));
    return std::clamp(value, from, to);
}

Task<TimeLaw> eased_law(Pace& pace, std::span<const double> times, std::span<const double> eases) {
    TimeLaw law(times.size(), pace.memory());
    co_await each(pace, times.size(), Cost::some_ns, [&](uint32_t i) {
        law.times[i] = law.parameters[i] = times[i];
        law.rates[2 * i] = 1 - eases[2 * i];
        law.rates[2 * i + 1] = 1 - eases[2 * i + 1];
    });
    co_return law;
}

NodeMotion motion_at(const MotionSteps& steps, uint32_t node, NodeSide side) {
    const uint32_t count = step_count(steps);
    const uint32_t nodes = steps.closed ? count : count + 1;
    node %= nodes;
    const auto is_kink = [&](uint32_t at) {
        return std::binary_search(steps.kinks.begin(), steps.kinks.end(), at % nodes);
    };
    // The node in the middle of three on one side of a kink, if there are three.
    const bool after = side == NodeSide::after;
    const uint32_t beside = node + (after ? 1 : nodes - 1);
    const bool inwards = steps.closed || (after ? node + 2 <= count : node >= 2);
    const bool one_sided = is_kink(node) && inwards && !is_kink(beside);
    const auto derive = [&](std::span<const double> changes, Vec3& first, Vec3& second) {
        if (!steps.closed && count == 1) {
            first = mean_of(changes, steps, 0);
            second.setZero();
            return;
        }
        // At an end, too, the parabola through the nearest three nodes.
        const bool at_begin = !steps.closed && node == 0, at_end = !steps.closed && node == count;
        const int away = at_begin || (one_sided && after) ? 1 : at_end || one_sided ? -1 : 0;
        const uint32_t middle = (node + nodes + static_cast<uint32_t>(away)) % nodes;
        const uint32_t step = (middle + count - 1) % count, next = middle % count;
        const double h = steps.times[step + 1] - steps.times[step], k = steps.times[next + 1] - steps.times[next];
        const Vec3 d = mean_of(changes, steps, step), e = mean_of(changes, steps, next);
        second = 2 / (h + k) * (e - d);
        first = (k * d + h * e) / (h + k);
        if (away > 0) first -= h * second;
        if (away < 0) first += k * second;
    };
    NodeMotion motion;
    derive(steps.moved, motion.velocity, motion.acceleration);
    derive(steps.turned, motion.turn, motion.turn_acceleration);
    return motion;
}

Task<TimeLaw> limited_law(Pace& pace, MotionSteps steps, MotionLimits limits) {
    const uint32_t count = step_count(steps);
    TimeLaw law(size_t{count} + 1, pace.memory());
    Buffer<double> squares(size_t{count} + 1, pace.memory());
    co_await each(pace, squares.size(), Cost::microseconds,
                  [&](uint32_t i) { squares[i] = std::max(cap_at(steps, limits, i), least_square); });
    if (limits.accelerates()) {
        if (!steps.closed && !is_at_rest(steps, 0)) squares[0] = 0;
        if (!steps.closed && !is_at_rest(steps, count)) squares[count] = 0;
        // Around a cycle twice: the second time from where the first one came to.
        const uint32_t rounds = steps.closed ? 2 : 1;
        const auto pass = [&](uint32_t from, uint32_t to, double step, bool forwards) {
            const NodeSide side = forwards ? NodeSide::after : NodeSide::before;
            const Range range = range_at(motion_at(steps, from, side), limits, squares[from]);
            if (range.empty()) return;
            const double v = squares[from] + 2 * step * (forwards ? range.high : -range.low);
            squares[to] = std::min(squares[to], std::max(v, least_square));
        };
        co_await each(pace, size_t{rounds} * count, Cost::hundreds_of_ns, [&](uint32_t k) {
            const uint32_t i = k % count;
            pass(i, i + 1, steps.times[i + 1] - steps.times[i], true);
            if (steps.closed && i + 1 == count) squares[0] = squares[count];
        });
        co_await each(pace, size_t{rounds} * count, Cost::hundreds_of_ns, [&](uint32_t k) {
            const uint32_t i = count - 1 - k % count;
            pass(i + 1, i, steps.times[i + 1] - steps.times[i], false);
            if (steps.closed && i == 0) squares[count] = squares[0];
        });
    }
    law.times[0] = steps.times[0];
    co_await each(pace, squares.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const double rate = std::sqrt(squares[i]);
        law.parameters[i] = steps.times[i];
        law.rates[2 * i] = law.rates[2 * i + 1] = rate;
        if (i == count) return;
        const double mean = std::max(0.5 * (rate + std::sqrt(squares[i + 1])), std::sqrt(least_square));
        law.times[i + 1] = law.times[i] + (steps.times[i + 1] - steps.times[i]) / mean;
    });
    co_return law;
}

}  // namespace flg
