// SPDX-License-Identifier: MIT
#include "stylization/automatic_scale.h"

#include <algorithm>
#include <cmath>

#include "curves/sampling_job.h"

namespace flg {

namespace {

constexpr double swing_per_radius = 1.2;   // more: the style leaves the shape that was painted
constexpr double finest = 8;               // more: turns on long thin strokes too small to see
constexpr double coarsest = 1.25;          // more: dabs get less than a turn of most styles
constexpr double radius_per_swing = 0.14;  // more: turns touch; less: they are hairs
constexpr double scale_min = 1e-30, scale_max = 1e30;

constexpr uint32_t points_chunk = 1000;  // about 10 us

struct CurveExtent {
    double size = 0;    // metres
    double radius = 0;  // metres, mean along the curve; 0: none
};

// Moments of a curve's length about its first point.
class Moments {
public:
    void add(const Vec3& from, const Vec3& to, double radius) {
        const double length = (to - from).norm();
        const Vec3 middle = 0.5 * (from + to);
        length_ += length;
        first_ += length * middle;
        second_ += length * (middle.squaredNorm() + length * length / 12.0);
        radius_ += length * radius;
    }
    CurveExtent extent() const {
        if (!(length_ > 0)) return {};
        const double variance = std::max(second_ / length_ - (first_ / length_).squaredNorm(), 0.0);
        const double spread = std::sqrt(12.0 * variance);
        return {spread * std::cbrt(spread / length_), radius_ / length_};
    }

private:
    double length_ = 0, second_ = 0, radius_ = 0;
    Vec3 first_ = Vec3::Zero();
};

Task<CurveExtent> measure_extent(Pace& pace, const CurveSet& set, uint32_t curve) {
    const Column* const radii = set.find(FLG_ATTRIBUTE_RADIUS);
    const CurveView view = curve_view(set, curve);
    const float* const radius = radii ? radii->values.data() + set.offsets()[curve] : nullptr;
    const auto radius_at = [radius](uint32_t i) { return radius ? double{radius[i]} : 0.0; };
    const Vec3 start = load_vec3(view.raw(0));
    Moments moments;
    Vec3 before = Vec3::Zero();
    const uint32_t ends = view.count + (view.closed ? 1 : 0);
    for (uint32_t k = 1; k < ends; ++k) {
        const uint32_t i = k % view.count;
        const Vec3 here = load_vec3(view.raw(i)) - start;
        moments.add(before, here, 0.5 * (radius_at(k - 1) + radius_at(i)));
        before = here;
        if (k % points_chunk == 0) co_await pace;
    }
    co_return moments.extent();
}

struct Choice {
    const CurveSet& target;
    double guide_size, rms;  // metres
    ChosenScales chosen;

    void choose(uint32_t curve, const CurveExtent& extent) {
        double scale = 1, thinning = 1;
        if (extent.size > 0 && guide_size > 0) {
            const double proportion = extent.size / guide_size;
            scale = proportion;
            if (extent.radius > 0 && rms > 0) {
                scale = std::clamp(swing_per_radius * extent.radius / rms, proportion / finest, coarsest * proportion);
            }
            scale = std::clamp(scale, scale_min, scale_max);
        }
        if (extent.radius > 0 && rms > 0) thinning = std::min(1.0, radius_per_swing * scale * rms / extent.radius);
        chosen.scale[curve] = static_cast<float>(scale);
        chosen.thinning[curve] = static_cast<float>(thinning);
    }
};

Task<void> choose_batch(Pace& pace, Choice& choice, uint32_t batch) {
    const CurveRange range = curves_of_batch(choice.target, batch);
    for (uint32_t c = range.first; c < range.last; ++c) {
        choice.choose(c, co_await measure_extent(pace, choice.target, c));
        co_await pace;
    }
}

}  // namespace

Task<ChosenScales> choose_scales(Pace& pace, const PreparedStyle& style, const CurveSet& target) {
    pace.stage("size");
    const uint32_t curves = target.curve_count();
    Choice choice{target, 0, style.displacement_rms,
                  ChosenScales{Buffer<float>(curves, pace.memory()), Buffer<float>(curves, pace.memory())}};
    for (uint32_t c = 0; c < style.guide->curve_count(); ++c) {
        const CurveExtent extent = co_await measure_extent(pace, *style.guide, c);
        choice.guide_size = std::max(choice.guide_size, extent.size);
    }
    co_await fork(pace, batch_count(target), &choose_batch, choice);
    co_return std::move(choice.chosen);
}

double live_scale(const PreparedStyle& style, double radius) {
    if (!(radius > 0) || !(style.displacement_rms > 0)) return 1;
    return std::clamp(radius / (radius_per_swing * style.displacement_rms), scale_min, scale_max);
}

}  // namespace flg
