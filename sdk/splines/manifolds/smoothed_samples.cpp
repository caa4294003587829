// SPDX-License-Identifier: MIT
#include "splines/manifolds/smoothed_samples.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "splines/manifolds/quadric_fit.h"

namespace flg {

namespace {

// Of the scale: about 15 samples reach a place.
constexpr double radius_share = 2;
// Likewise of meshes' own samples, over how far they are apart.
constexpr double own_radius_share = 1.6;
// The cosine of the angle from which on samples count as those of another side.
constexpr double same_side = -0.3;
constexpr double max_bent = 0.7;     // bends over the spacing
constexpr double max_scale = 0.25;   // of the size
constexpr double min_radius = 0.25;  // of the mean one: where the scales begin

// Calls visit(i) for the samples within `reach` of another one that face its way. Returns how many it looked at.
template <class Visit>
uint32_t for_near(const OrientedSamples& surface, const OrientedSample& at, double reach, Visit&& visit) {
    const Vec3 place = place_of(at), normal = normal_of(at);
    uint32_t looked = 0;
    surface.around(place, reach, [&](uint32_t first, uint32_t end) {
        looked += end - first;
        for (uint32_t i = first; i < end; ++i) {
            const OrientedSample& other = surface.sample(i);
            if ((place_of(other) - place).squaredNorm() > reach * reach) continue;
            if (normal_of(other).dot(normal) > same_side) visit(i);
        }
    });
    return looked;
}

// Returns how many samples it looked at.
uint32_t fit(const OrientedSamples& surface, const OrientedSample& at, double scale, OrientedSample& out) {
    const double spacing = std::max(scale, at.radius / own_radius_share), reach = quadric_reach * spacing;
    const Vec3 place = place_of(at);
    Vec3 normal = Vec3::Zero();
    const uint32_t looked = for_near(surface, at, reach, [&](uint32_t i) {
        const OrientedSample& other = surface.sample(i);
        const double closeness = 1 - (place_of(other) - place).squaredNorm() / (reach * reach);
        normal += closeness * closeness * normal_of(other);
    });
    normal.normalize();
    // Which side others are on is asked of the mean: the sample's own normal may be noise.
    OrientedSample middle = at;
    middle.normal = {normal.x(), normal.y(), normal.z()};
    QuadricFit quadric(place, normal, spacing, QuadricKind::smooth);
    for_near(surface, middle, reach, [&](uint32_t i) {
        const OrientedSample& other = surface.sample(i);
        quadric.add_point(place_of(other));
        quadric.add_normal(place_of(other), normal_of(other));
    });
    BentNormal bent = quadric.solve();
    if (bent.curvature * spacing > max_bent) {
        for (double& b : bent.bend) b *= max_bent / (bent.curvature * spacing);
    }
    const Vec3 on = place + std::clamp(bent.height, -spacing, spacing) * normal;
    const Vec3& n = bent.normal;
    const double radius = std::max(radius_share * scale, at.radius);
    out = {{on.x(), on.y(), on.z()}, {n.x(), n.y(), n.z()}, bent.bend, radius};
    return looked;
}

struct Kept {
    uint32_t sample;
    bool is_alone;  // there is no other one within the scale
};

Task<std::pmr::vector<Kept>> thin_out(Pace& pace, const OrientedSamples& surface, double scale) {
    std::pmr::vector<Kept> kept(pace.memory());
    Buffer<uint8_t> is_covered(surface.sample_count(), pace.memory());
    co_await each(pace, surface.sample_count(), Cost::some_ns, [&](uint32_t i) { is_covered[i] = 0; });
    kept.reserve(surface.sample_count());
    co_await each_by_work(pace, surface.sample_count(), Cost::tens_of_ns, [&](uint32_t i) {
        if (is_covered[i]) return 1u;
        uint32_t near = 0;
        const uint32_t looked = for_near(surface, surface.sample(i), scale, [&](uint32_t other) {
            is_covered[other] = 1;
            ++near;
        });
        kept.push_back({i, near == 1});
        return 20 + looked / 4;
    });
    co_return kept;
}

Task<OrientedSamples> coarser_samples(Pace& pace, const OrientedSamples& surface, double scale) {
    const std::pmr::vector<Kept> kept = co_await thin_out(pace, surface, scale);
    GrowingBuffer<OrientedSample> samples(kept.size(), pace.memory());
    co_await each_by_work(pace, kept.size(), Cost::tens_of_ns, [&](uint32_t k) {
        const OrientedSample& own = surface.sample(kept[k].sample);
        samples[k] = own;
        return kept[k].is_alone ? 1 : 20 + fit(surface, own, scale, samples[k]);
    });
    OrientedSamples coarser = co_await oriented_samples(pace, samples);
    co_return coarser;
}

}  // namespace

Task<OrientedSamples> smoothed_samples(Pace& pace, OrientedSamples surface, double scale) {
    const double largest_scale = max_scale * surface.size();
    if (scale > largest_scale) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.smoothing_scale is %g m, and the surface has a size of %g m; give at most %g m", scale,
                      surface.size(), largest_scale);
    }
    double smallest = surface.mean_radius();
    co_await each(pace, surface.sample_count(), Cost::some_ns,
                  [&](uint32_t i) { smallest = std::min(smallest, surface.sample(i).radius); });
    const double finest = 2 * std::max(smallest, min_radius * surface.mean_radius()) / own_radius_share;
    const int doublings = std::max(0, static_cast<int>(std::log2(scale / finest)));
    for (int k = doublings; k >= 0; --k) {
        OrientedSamples coarser = co_await coarser_samples(pace, surface, std::ldexp(scale, -k));
        surface = std::move(coarser);
    }
    co_return surface;
}

}  // namespace flg
