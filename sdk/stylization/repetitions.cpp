// SPDX-License-Identifier: MIT
#include "stylization/repetitions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t lag_samples = 512;       // of the style, when the period is looked for
constexpr uint32_t window_samples = 64;     // of a period, when two places are compared
constexpr double lag_like_shorter = 0.35;   // of D(L) over its mean
constexpr double lag_like_places = 0.5;     // of D(L) over that of unrelated places
constexpr double joint_like_places = 0.35;  // the same of two joints
constexpr double lag_spread = 0.4;          // from joint to joint
constexpr double lag_weight = 0.05;         // of differing by all of that, in squared differences of unrelated places
constexpr uint32_t shortest_period = 4;     // nodes

struct StyleBody {
    const Displacement& d;
    uint32_t begin, end;      // nodes
    double unrelated_sq = 0;  // mean squared distance of two nodes

    uint32_t size() const { return end - begin; }
    Vec3 at(uint32_t i) const { return {d.along_tangent[i], d.along_normal[i], d.along_binormal[i]}; }
};

Task<double> mean_square(Pace& pace, const StyleBody& body) {
    Vec3 sum = Vec3::Zero();
    double squares = 0;
    co_await each(pace, body.begin, body.end, Cost::some_ns, [&](uint32_t i) {
        sum += body.at(i);
        squares += body.at(i).squaredNorm();
    });
    const double count = body.size();
    co_return 2 * std::max(squares / count - (sum / count).squaredNorm(), 0.0);
}

// In nodes; 0: there is none.
Task<double> find_period(Pace& pace, const StyleBody& body) {
    const uint32_t samples = std::min(body.size(), lag_samples);
    const double stride = static_cast<double>(body.size() - 1) / (samples - 1);
    std::pmr::vector<Vec3> points(samples, pace.memory());
    co_await each(pace, samples, Cost::tens_of_ns,
                  [&](uint32_t k) { points[k] = body.at(body.begin + static_cast<uint32_t>(k * stride + 0.5)); });
    std::pmr::vector<double> share(samples / 2 + 1, 1.0, pace.memory()), mean(samples / 2 + 1, 1.0, pace.memory());
    double sum = 0;
    co_await each(pace, 1, samples / 2 + 1, Cost::microseconds, [&](uint32_t lag) {
        double squares = 0;
        for (uint32_t k = 0; k + lag < samples; ++k) squares += (points[k] - points[k + lag]).squaredNorm();
        share[lag] = squares / (samples - lag) / body.unrelated_sq;
        sum += share[lag];
        mean[lag] = sum > 0 ? share[lag] * lag / sum : 1.0;
    });
    for (uint32_t lag = 2; lag + 1 < share.size(); ++lag) {
        const bool least = share[lag] <= share[lag - 1] && share[lag] <= share[lag + 1];
        if (least && mean[lag] < lag_like_shorter && share[lag] < lag_like_places && lag * stride >= shortest_period) {
            co_return lag* stride;
        }
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

// From a first joint on. Fewer than three: nothing repeats.
Task<void> follow_joints(Pace& pace, const StyleBody& body, uint32_t first, double period,
                         std::pmr::vector<uint32_t>& joints) {
    joints.clear();
    const auto whole = static_cast<uint32_t>(period), half = whole / 2;
    if (first + whole >= body.end) co_return;
    const StyleJoint second = co_await next_joint(pace, body, first, period, first, 0, whole);
    if (!(second.unlike < joint_like_places)) co_return;
    joints.push_back(first);
    joints.push_back(second.node);
    for (;;) {
        const StyleJoint next = co_await next_joint(pace, body, joints.back(), period, second.node, half, half);
        if (!(next.unlike < joint_like_places)) co_return;
        joints.push_back(next.node);
    }
}

}  // namespace

Task<Buffer<uint32_t>> find_joints(Pace& pace, const PatchGraph& graph, const Displacement& displacement) {
    StyleBody body{displacement, graph.start(), graph.motif_end()};
    body.unrelated_sq = co_await mean_square(pace, body);
    std::pmr::vector<uint32_t> joints(pace.memory());
    const double period = body.unrelated_sq > 0 ? co_await find_period(pace, body) : 0.0;
    // The style's start may be of its own kind.
    constexpr uint32_t starts = 4;
    for (uint32_t k = 0; k <= starts && period > 0 && joints.size() < 3; ++k) {
        co_await follow_joints(pace, body, body.begin + static_cast<uint32_t>(k * period / starts), period, joints);
    }
    if (joints.size() < 3) joints.assign({body.begin, body.end - 1});
    Buffer<uint32_t> found(joints.size(), pace.memory());
    co_await each(pace, joints.size(), Cost::some_ns, [&](uint32_t k) { found[k] = joints[k]; });
    co_return found;
}

}  // namespace flg
