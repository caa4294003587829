// SPDX-License-Identifier: MIT
#include "stylization/repetitions.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t lag_samples = 512;      // of the style, when the period is looked for
constexpr uint32_t window_samples = 64;    // of a period, when two places are compared
constexpr double lag_like_shorter = 0.45;  // of D(L) over its mean up to L
constexpr double lag_like_places = 0.5;    // of D(L) over its mean
constexpr double joint_like_places = 0.5;  // the same of two joints
constexpr double lag_spread = 0.4;         // from joint to joint
constexpr double lag_weight = 0.05;        // of differing by all of that, in means of D
constexpr uint32_t shortest_period = 4;    // nodes
// Beside a cap: how much more two neighbouring repetitions may differ than half of them do, and at least may.
constexpr double odd_medians = 2.5, odd_least = 0.15;

struct StyleBody {
    const Displacement& d;
    uint32_t begin, end;      // nodes
    double unrelated_sq = 0;  // mean of D

    uint32_t size() const { return end - begin; }
    Vec3 at(uint32_t i) const { return {d.along_tangent[i], d.along_normal[i], d.along_binormal[i]}; }
};

double middle(std::span<double> values) {
    const auto half = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

// In nodes; 0: there is none. Fills in the body's mean of D.
Task<double> find_period(Pace& pace, StyleBody& body) {
    const uint32_t samples = std::min(body.size(), lag_samples), lags = samples / 2;
    const double stride = static_cast<double>(body.size() - 1) / (samples - 1);
    std::pmr::vector<Vec3> points(samples, pace.memory());
    co_await each(pace, samples, Cost::tens_of_ns,
                  [&](uint32_t k) { points[k] = body.at(body.begin + static_cast<uint32_t>(k * stride + 0.5)); });
    std::pmr::vector<double> d(lags + size_t{1}, 0.0, pace.memory()), squares(samples, 0.0, pace.memory());
    double sum = 0;
    co_await each(pace, 1, lags + 1, Cost::microseconds, [&](uint32_t lag) {
        for (uint32_t k = 0; k + lag < samples; ++k) squares[k] = (points[k] - points[k + lag]).squaredNorm();
        d[lag] = middle({squares.data(), samples - lag});
        sum += d[lag];
    });
    body.unrelated_sq = sum / lags;
    if (!(sum > 0)) co_return 0;
    double before = d[1];
    for (uint32_t lag = 2; lag + 1 < d.size(); ++lag) {
        before += d[lag];
        const bool least = d[lag] <= d[lag - 1] && d[lag] <= d[lag + 1];
        const bool like = d[lag] * lag < lag_like_shorter * before && d[lag] < lag_like_places * body.unrelated_sq;
        if (least && like && lag * stride >= shortest_period) co_return lag* stride;
    }
    co_return 0;
}

// How unlike the style is around two nodes, over `before` nodes before them and `behind` nodes behind, as far as it
// goes; 1: as two unrelated places.
double difference(const StyleBody& body, uint32_t a, uint32_t b, uint32_t before, uint32_t behind) {
    const uint32_t first = std::min({before, a - body.begin, b - body.begin});
    const uint32_t last = std::min({behind, body.end - 1 - a, body.end - 1 - b});
    const uint32_t stride = std::max((before + behind) / window_samples, 1U);
    double squares = 0;
    uint32_t count = 0;
    for (uint32_t t = 0; t <= first + last; t += stride, ++count) {
        squares += (body.at(a - first + t) - body.at(b - first + t)).squaredNorm();
    }
    return squares / count / body.unrelated_sq;
}

struct StyleJoint {
    uint32_t node = 0;
    double unlike = HUGE_VAL;
};

// Around a period behind `last`, where the style is most like around `model`.
Task<StyleJoint> next_joint(Pace& pace, const StyleBody& body, uint32_t last, double period, uint32_t model,
                            uint32_t before, uint32_t behind) {
    const auto from = static_cast<uint32_t>(last + (1 - lag_spread) * period);
    const auto to = std::min(static_cast<uint32_t>(last + (1 + lag_spread) * period) + 1, body.end);
    StyleJoint best;
    double least = HUGE_VAL;
    co_await each(pace, std::max(from, last + 1), to, Cost::hundreds_of_ns, [&](uint32_t node) {
        const double found = difference(body, model, node, before, behind);
        const double off = ((node - last) / period - 1) / lag_spread;
        if (found + lag_weight * off * off >= least) return;
        least = found + lag_weight * off * off;
        best = {node, found};
    });
    co_return best;
}

// What a joint is compared with: the second one, so that phases keep, or the one before, where the style drifts.
enum class JointModel : uint8_t { second, before };

// From a first joint on. Fewer than three: nothing repeats.
Task<void> follow_joints(Pace& pace, const StyleBody& body, uint32_t first, double period, JointModel model,
                         std::pmr::vector<StyleJoint>& joints) {
    joints.clear();
    const auto whole = static_cast<uint32_t>(period), half = whole / 2;
    if (first + whole >= body.end) co_return;
    const StyleJoint second = co_await next_joint(pace, body, first, period, first, 0, whole);
    if (!(second.unlike < joint_like_places)) co_return;
    joints.push_back({first, second.unlike});
    joints.push_back(second);
    for (;;) {
        const uint32_t last = joints.back().node, like = model == JointModel::second ? second.node : last;
        const StyleJoint next = co_await next_joint(pace, body, last, period, like, half, half);
        if (!(next.unlike < joint_like_places)) co_return;
        joints.push_back(next);
    }
}

// Without those at the ends between which the style is less like itself than elsewhere. Returns what counts as that.
double drop_odd_ends(std::pmr::vector<StyleJoint>& joints, Memory* memory) {
    std::pmr::vector<double> unlike(memory);
    for (size_t k = 1; k < joints.size(); ++k) unlike.push_back(joints[k].unlike);
    const double odd = std::max(odd_medians * middle(unlike), odd_least);
    size_t first = 0;
    while (first + 1 < joints.size() && joints[first + 1].unlike > odd) ++first;
    joints.erase(joints.begin(), joints.begin() + static_cast<ptrdiff_t>(first));
    while (joints.size() > 1 && joints.back().unlike > odd) joints.pop_back();
    return odd;
}

// For how many nodes two places go on alike, forth or back; UINT32_MAX: to the body's end.
Task<uint32_t> count_alike(Pace& pace, const StyleBody& body, uint32_t a, uint32_t b, bool forth, double odd,
                           uint32_t around) {
    const uint32_t outer = forth ? std::max(a, b) : std::min(a, b);
    const uint32_t most = forth ? body.end - 1 - outer : outer - body.begin;
    uint32_t on = 0;
    bool ended = false;
    co_await each(pace, 1, most + 1, Cost::hundreds_of_ns, [&](uint32_t k) {
        if (ended) return;
        const auto place = [&](uint32_t from) { return forth ? from + k : from - k; };
        ended = difference(body, place(a), place(b), around, around) > 2 * odd;
        if (!ended) on = k;
    });
    co_return ended&& on + around < most ? on : UINT32_MAX;
}

}  // namespace

Task<Buffer<uint32_t>> find_joints(Pace& pace, const PatchGraph& graph, const Displacement& displacement) {
    StyleBody body{displacement, graph.start(), graph.motif_end()};
    const double period = co_await find_period(pace, body);
    std::pmr::vector<StyleJoint> joints(pace.memory());
    // The style's start may be of its own kind.
    constexpr uint32_t starts = 4;
    for (uint32_t k = 0; k <= starts && period > 0 && joints.size() < 3; ++k) {
        co_await follow_joints(pace, body, body.begin + static_cast<uint32_t>(k * period / starts), period,
                               JointModel::second, joints);
    }
    if (joints.size() < 3) joints.assign({{body.begin, 0}, {body.end - 1, 0}});
    Buffer<uint32_t> found(joints.size(), pace.memory());
    co_await each(pace, joints.size(), Cost::some_ns, [&](uint32_t k) { found[k] = joints[k].node; });
    co_return found;
}

Task<StyleCaps> caps_beside_repetitions(Pace& pace, const Displacement& displacement) {
    StyleBody all{displacement, 0, displacement.size()};
    const double period = co_await find_period(pace, all);
    StyleCaps caps;
    const auto quarter = static_cast<uint32_t>(period / 4);
    if (quarter == 0) co_return caps;
    std::pmr::vector<StyleJoint> joints(pace.memory());
    for (uint32_t first = 0; first + 2 * period < all.end && joints.size() < 3; first += quarter) {
        co_await follow_joints(pace, all, first, period, JointModel::before, joints);
    }
    if (joints.size() < 3) co_return caps;
    const double odd = drop_odd_ends(joints, pace.memory());
    if (joints.size() < 3) co_return caps;
    // In between joints, as far as neighbouring repetitions are alike.
    const uint32_t around = std::max(quarter / 2, 1U), first = joints.front().node, last = joints.back().node;
    const uint32_t back = co_await count_alike(pace, all, first, joints[1].node, false, odd, around);
    const uint32_t forth = co_await count_alike(pace, all, joints[joints.size() - 2].node, last, true, odd, around);
    if (back != UINT32_MAX) caps.start = first - back;
    if (forth != UINT32_MAX) caps.end = all.end - 1 - last - forth;
    co_return caps;
}

}  // namespace flg
