// SPDX-License-Identifier: MIT
#include "splines/manifolds/oriented_samples.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "core/failure.h"
#include "surfaces/mesh/spatial_order.h"

namespace flg {

namespace {

// What is remembered reaches this far beyond the point, in radii of the sample that suits it best.
constexpr double slack_share = 0.15;
// Which sample suits x best: by |x - p|^2 + level_weight * f(x)^2. Beside a sample on the same sheet, one on the other
// side of a part 0.1 times as thick as samples are apart is farther.
constexpr double level_weight = 50;
// The cosine of the angle from which on samples face away.
constexpr double facing_away = -0.4;
// Newton's method goes straight to the surface from a point that is within 0.6 radii of a sample.
constexpr double near_closeness = 1 - 0.6 * 0.6;
constexpr double max_step = 0.5;     // in radii of the best sample
constexpr double last_step = 1e-10;  // of the size: the step after it would be rounding
constexpr double small_step = 1e-2;  // of a radius: along the surface, from far away
// After so many rounds the sheet is held: between sheets of a sharp edge the choice could go on forever.
constexpr uint32_t free_rounds = 8, max_rounds = 48;
// A step that leaves more than this of F is followed by shorter ones.
constexpr double max_left = 0.7;
constexpr double bracket_step = 0.1;  // of the radius
constexpr uint32_t bisections = 40;
constexpr uint32_t rounds_along = 4;  // from a sample that is nearest towards the nearest point

constexpr uint32_t min_samples = 4;
// A sample is another one again if it is nearer to it than this share of both radii, and turned by less than 18
// degrees.
constexpr double same_share = 0.15, parallel_cosine = 0.95;
constexpr uint32_t looked_back = 8;

}  // namespace

// A sample that covers a point.
struct OrientedSamples::Active {
    uint32_t sample;
    double level;      // f
    double closeness;  // 1 - |x - p|^2 / r^2
    double offset[3];  // x - p
};

// A point's hint.
struct OrientedSamples::Nearby {
    double centre[3];
    double slack;       // metres; 0: nothing is remembered
    double next_slack;  // with which to look for others
    uint32_t count;     // of the samples that are not farther from the centre than their radius and the slack
    uint32_t samples[remembered + 1];
};

struct OrientedSamples::Blend {
    double value;
    Vec3 gradient;
    Eigen::Matrix3d second;
    uint32_t best;     // the sample that suits x best
    double closeness;  // the largest one
};

OrientedSamples::OrientedSamples(Buffer<OrientedSample> samples, PointTree tree, double size, double mean_radius)
    : Hypersurface(3, sizeof(Nearby) / sizeof(double), size, size),
      samples_(std::move(samples)),
      tree_(std::move(tree)),
      mean_radius_(mean_radius) {
    static_assert(sizeof(Nearby) % sizeof(double) == 0);
}

// Lists those around x with slack, which are remembered if they are few enough.
uint32_t OrientedSamples::gather(const double* x, double* hint, uint32_t* list) const {
    Nearby nearby;
    std::memcpy(&nearby, hint, offsetof(Nearby, samples));
    const double slack = nearby.next_slack > 0 ? nearby.next_slack : slack_share * mean_radius_;
    const auto collect = [&](double reach_beyond) {
        uint32_t count = 0;
        tree_.around(x, reach_beyond, [&](uint32_t first, uint32_t end) {
            for (uint32_t i = first; i < end; ++i) {
                const OrientedSample& s = samples_[i];
                const double dx = x[0] - s.position[0], dy = x[1] - s.position[1], dz = x[2] - s.position[2];
                const double reach = s.radius + reach_beyond;
                if (dx * dx + dy * dy + dz * dz <= reach * reach && count < max_active) list[count++] = i;
            }
        });
        return count;
    };
    uint32_t count = collect(slack);
    if (count == max_active) count = collect(0);
    if (count == 0) return 0;
    double smallest = samples_[list[0]].radius;
    for (uint32_t i = 1; i < count; ++i) smallest = std::min(smallest, samples_[list[i]].radius);
    const bool few = count <= remembered;
    nearby.next_slack = (few ? slack_share : 0.2 * slack_share) * smallest;
    nearby.slack = few ? slack : 0;
    nearby.count = few ? count : 0;
    std::copy_n(x, 3, nearby.centre);
    std::copy_n(list, nearby.count, nearby.samples);
    std::memcpy(hint, &nearby, offsetof(Nearby, samples) + nearby.count * sizeof(uint32_t));
    return count;
}

bool OrientedSamples::blend(const double* x, double* hint, const Vec3* sheet, bool with_second, Blend& result) const {
    Nearby nearby;
    std::memcpy(&nearby, hint, offsetof(Nearby, samples));
    uint32_t list[max_active], count = nearby.count;
    const double mx = x[0] - nearby.centre[0], my = x[1] - nearby.centre[1], mz = x[2] - nearby.centre[2];
    if (nearby.slack > 0 && mx * mx + my * my + mz * mz <= nearby.slack * nearby.slack) {
        std::memcpy(list, reinterpret_cast<const char*>(hint) + offsetof(Nearby, samples), count * sizeof(uint32_t));
    } else {
        count = gather(x, hint, list);
    }

    // Who covers x, and suits it best.
    Active active[max_active];
    uint32_t covering = 0, best = 0;
    double best_score = std::numeric_limits<double>::infinity(), closest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const OrientedSample& s = samples_[list[i]];
        const double dx = x[0] - s.position[0], dy = x[1] - s.position[1], dz = x[2] - s.position[2];
        const double square = dx * dx + dy * dy + dz * dz, closeness = 1 - square * s.sharpness;
        if (!(closeness > 0)) continue;
        const auto& b = s.bend;
        const double bent =
            dx * (b[0] * dx + 2 * (b[1] * dy + b[2] * dz)) + dy * (b[3] * dy + 2 * b[4] * dz) + b[5] * dz * dz;
        const double level = s.normal[0] * dx + s.normal[1] * dy + s.normal[2] * dz + 0.5 * bent;
        const double score = square + level_weight * level * level;
        if (score < best_score) {
            best_score = score;
            best = covering;
        }
        closest = std::max(closest, closeness);
        active[covering++] = {list[i], level, closeness, {dx, dy, dz}};
    }
    if (covering == 0) return false;
    result.best = active[best].sample;
    result.closeness = closest;
    const Vec3 out = sheet ? *sheet : normal_of(samples_[result.best]);

    // F, of those on the same sheet.
    double w = 0, wf = 0;
    uint32_t together = 0;
    for (uint32_t i = 0; i < covering; ++i) {
        const Active& a = active[i];
        const OrientedSample& s = samples_[a.sample];
        const auto& n = s.normal;
        if (n[0] * out[0] + n[1] * out[1] + n[2] * out[2] < facing_away) continue;
        const double c2 = a.closeness * a.closeness * s.sharpness, weight = c2 * c2;
        w += weight;
        wf += weight * a.level;
        active[together++] = a;
    }
    if (!(w > 0)) return false;
    const double share = 1 / w, value = wf * share;
    result.value = value;

    // Sums of the derivatives of w and of w (f - F), F held.
    double w1[3] = {}, first[3] = {}, other[6] = {};
    for (uint32_t i = 0; i < together; ++i) {
        const Active& a = active[i];
        const OrientedSample& s = samples_[a.sample];
        const double* d = a.offset;
        const auto& b = s.bend;
        // w, and with it all its derivatives, has the factor sharpness^2.
        const double c2 = a.closeness * a.closeness, fine = s.sharpness * s.sharpness, weight = fine * c2 * c2;
        const double slope = -8 * fine * c2 * a.closeness * s.sharpness;  // dw = slope * d
        const double level = a.level - value, slope_level = slope * level;
        const double g[3] = {s.normal[0] + b[0] * d[0] + b[1] * d[1] + b[2] * d[2],
                             s.normal[1] + b[1] * d[0] + b[3] * d[1] + b[4] * d[2],
                             s.normal[2] + b[2] * d[0] + b[4] * d[1] + b[5] * d[2]};
        for (int k = 0; k < 3; ++k) first[k] += slope_level * d[k] + weight * g[k];
        if (!with_second) continue;
        const double curve_level = 48 * fine * c2 * s.sharpness * s.sharpness * level;  // ddw = curve d d^T + slope I
        double along[3];
        for (int k = 0; k < 3; ++k) {
            w1[k] += slope * d[k];
            along[k] = curve_level * d[k] + slope * g[k];
        }
        other[0] += along[0] * d[0] + slope * d[0] * g[0] + weight * b[0] + slope_level;
        other[1] += along[0] * d[1] + slope * d[0] * g[1] + weight * b[1];
        other[2] += along[0] * d[2] + slope * d[0] * g[2] + weight * b[2];
        other[3] += along[1] * d[1] + slope * d[1] * g[1] + weight * b[3] + slope_level;
        other[4] += along[1] * d[2] + slope * d[1] * g[2] + weight * b[4];
        other[5] += along[2] * d[2] + slope * d[2] * g[2] + weight * b[5] + slope_level;
    }
    for (int k = 0; k < 3; ++k) result.gradient[k] = first[k] *= share;
    if (!with_second) return true;
    for (int j = 0, at = 0; j < 3; ++j) {
        for (int k = j; k < 3; ++k, ++at) {
            const double h = (other[at] - (first[j] * w1[k] + first[k] * w1[j])) * share;
            result.second(j, k) = result.second(k, j) = h;
        }
    }
    return true;
}

bool OrientedSamples::evaluate(const double* x, double* hint, double* value, double* gradient, double* second) const {
    Blend result;
    if (!blend(x, hint, nullptr, second != nullptr, result)) return false;
    *value = result.value;
    for (int i = 0; i < 3; ++i) gradient[i] = result.gradient[i];
    if (second) std::copy_n(result.second.data(), 9, second);
    return true;
}

bool OrientedSamples::distance_estimate(const Vec3& place, double* distance) const {
    double hint[sizeof(Nearby) / sizeof(double)] = {};
    Blend here;
    if (!blend(place.data(), hint, nullptr, false, here)) return false;
    const double slope = here.gradient.norm();
    *distance = slope > 0 ? std::abs(here.value) / slope : 0;
    return true;
}

// Newton's method along the gradient, from a place near the surface.
bool OrientedSamples::descend(Vec3& x, double* hint, bool from_sample) const {
    Vec3 at = x, sheet = Vec3::Zero();
    Blend here;
    double before = std::numeric_limits<double>::infinity(), share = 1;
    for (uint32_t round = 0; round < max_rounds; ++round) {
        if (!blend(at.data(), hint, round > free_rounds ? &sheet : nullptr, false, here)) return false;
        if (here.closeness < near_closeness && !from_sample) return false;
        const OrientedSample& best = samples_[here.best];
        if (round <= free_rounds) sheet = normal_of(best);
        const double slope = here.gradient.squaredNorm();
        if (!(slope > 0)) return false;
        share = std::abs(here.value) > max_left * before ? 0.5 * share : std::min(1.0, 2 * share);
        before = std::abs(here.value);
        Vec3 step = -here.value / slope * here.gradient;
        const double length = step.norm(), most = max_step * best.radius;
        if (length <= last_step * size()) {
            x = at + step;
            return true;
        }
        at += std::min(share, most / length) * step;
    }
    return false;
}

// Between sheets that Newton's method does not get along with: by bisection along the normal of a sample, on its sheet.
bool OrientedSamples::bracket(Vec3& x, const OrientedSample& sample, double* hint) const {
    const Vec3 place = place_of(sample), normal = normal_of(sample);
    Blend here;
    const auto level = [&](double t, double& value) {
        const Vec3 at = place + t * normal;
        if (!blend(at.data(), hint, &normal, false, here)) return false;
        value = here.value;
        return true;
    };
    double from = 0, before = 0;
    if (!level(0, before)) return false;
    const double step = (before > 0 ? -bracket_step : bracket_step) * sample.radius;
    double to = 0, after = before;
    while ((after > 0) == (before > 0)) {
        from = to;
        to += step;
        if (std::abs(to) >= sample.radius || !level(to, after)) return false;
    }
    for (uint32_t round = 0; round < bisections; ++round) {
        const double middle = 0.5 * (from + to);
        if (!level(middle, after)) return false;
        ((after > 0) == (before > 0) ? from : to) = middle;
    }
    x = place + to * normal;
    return true;
}

uint32_t OrientedSamples::nearest_sample(const Vec3& x) const {
    double square = std::numeric_limits<double>::infinity();
    uint32_t nearest = 0;
    tree_.nearest(x.data(), square, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            const double away = (place_of(samples_[i]) - x).squaredNorm();
            if (away < square) {
                square = away;
                nearest = i;
            }
        }
    });
    return nearest;
}

bool OrientedSamples::project(double* x, double* hint) const {
    const Vec3 from(x[0], x[1], x[2]);
    Vec3 at = from;
    if (!descend(at, hint, false)) {
        const OrientedSample& nearest = samples_[nearest_sample(from)];
        at = place_of(nearest);
        if (!descend(at, hint, true) && !bracket(at, nearest, hint)) return false;
        // Downhill in the distance from where it came, along the surface. What is `away` from a surface that bends by k
        // has its distance bend by 1 + away * k.
        double bend = 0;
        for (const double b : nearest.bend) bend = std::max(bend, std::abs(b));
        const double share = 1 / (1 + (from - at).norm() * bend);
        Blend here;
        for (uint32_t round = 0; round < rounds_along; ++round) {
            if (!blend(at.data(), hint, nullptr, false, here)) break;
            const Vec3 normal = here.gradient.normalized();
            Vec3 step = share * ((from - at) - normal.dot(from - at) * normal);
            const double length = step.norm(), most = max_step * nearest.radius;
            if (length <= small_step * nearest.radius) break;
            if (length > most) step *= most / length;
            Vec3 next = at + step;
            if (!descend(next, hint, false) || !((next - from).squaredNorm() < (at - from).squaredNorm())) break;
            at = next;
        }
    }
    std::copy_n(at.data(), 3, x);
    return true;
}

namespace {

// Whether a sample is all but another one: of those that came last, since what is near in space is near in the order.
bool is_another(const OrientedSample& sample, const OrientedSample* kept, uint32_t count) {
    const Vec3 place(sample.position.data()), normal(sample.normal.data());
    for (uint32_t back = 1; back <= std::min(count, looked_back); ++back) {
        const OrientedSample& other = kept[count - back];
        const double apart = (Vec3(other.position.data()) - place).norm();
        const bool parallel = normal.dot(Vec3(other.normal.data())) > parallel_cosine;
        if (parallel && apart < same_share * std::min(other.radius, sample.radius)) return true;
    }
    return false;
}

}  // namespace

Task<OrientedSamples> oriented_samples(Pace& pace, GrowingBuffer<OrientedSample>& samples) {
    const auto count = static_cast<uint32_t>(samples.size());
    if (count < min_samples) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a surface needs %u samples that have a normal, and there are %u",
                      min_samples, count);
    }
    GrowingBuffer<Position> positions(count, pace.memory());
    Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) {
        const Vec3 p(samples[i].position.data());
        store_vec3(p, positions[i].data());
        lower = i == 0 ? p : lower.cwiseMin(p);
        upper = i == 0 ? p : upper.cwiseMax(p);
    });
    std::optional<SpatialOrder> order = co_await spatial_order(pace, positions);
    Buffer<OrientedSample> sorted(count, pace.memory());
    uint32_t kept = 0;
    double radii = 0;
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const OrientedSample& sample = samples[order->vertex_at(i)];
        if (is_another(sample, sorted.data(), kept)) return;
        OrientedSample& own = sorted[kept++];
        own = sample;
        own.sharpness = 1 / (sample.radius * sample.radius);
        radii += sample.radius;
    });
    order.reset();
    co_await pace;
    positions = {};
    co_await pace;
    samples = {};
    co_await pace;
    const OrientedSample* const all = sorted.data();
    const auto ball = [all](uint32_t i, double* centre, double& radius) {
        for (size_t k = 0; k < 3; ++k) centre[k] = all[i].position[k];
        radius = all[i].radius;
    };
    PointTree tree = co_await point_tree(pace, kept, ball);
    OrientedSamples surface(std::move(sorted), std::move(tree), (upper - lower).norm(), radii / kept);
    co_return surface;
}

}  // namespace flg
