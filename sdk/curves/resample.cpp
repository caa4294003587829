// SPDX-License-Identifier: MIT
#include "curves/resample.h"

#include <array>

#include "runtime/pace.h"

namespace flg {

namespace {

constexpr uint32_t samples_at_once = 200;  // about 10 us

void interpolate_orientation(const float* a, const float* b, float t, float* out) {
    const Eigen::Vector4d from = Eigen::Map<const Eigen::Vector4f>(a).cast<double>();
    const Eigen::Vector4d to = Eigen::Map<const Eigen::Vector4f>(b).cast<double>();
    const double sign = from.dot(to) < 0 ? -1.0 : 1.0;
    Eigen::Vector4d q = (1.0 - t) * from + (sign * t) * to;
    const double size = q.norm();
    // Only opposite or zero quaternions in the input cancel out.
    if (size > 0) q /= size;
    Eigen::Map<Eigen::Vector4f> result(out);
    result = q.cast<float>();
}

struct Resampling {
    // True at the end.
    bool run(uint32_t units) {
        SampleBlock block;
        std::array<SamplePlace, SampleBlock::capacity> places;
        while (units > 0 && written < count) {
            const uint32_t filled = sampler.next(block, units);
            const size_t at = 3 * static_cast<size_t>(written);
            pack_positions(block, filled, out.positions + at);
            pack(block.tangent, filled, out.tangents + at);
            pack(block.normal, filled, out.normals + at);
            for (uint32_t k = 0; k < filled; ++k) places[k] = {block.segment[k], block.t[k]};
            for (const ColumnPair& column : columns)
                interpolate_column(column, curve, {places.data(), filled}, written);
            written += filled;
        }
        return written == count;
    }

    FramedSampler sampler;
    CurveView curve;
    FrameColumns out;
    std::span<const ColumnPair> columns;
    uint32_t count;
    uint32_t written = 0;
};

}  // namespace

void interpolate_column(const ColumnPair& column, const CurveView& curve, std::span<const SamplePlace> places,
                        uint32_t first) {
    const size_t width = column.components;
    float* out = column.out + width * first;
    for (const SamplePlace& place : places) {
        const uint32_t following = curve.following(place.segment);
        const float* a = column.in + width * place.segment;
        const float* b = column.in + width * following;
        if (column.orientation) {
            interpolate_orientation(a, b, place.t, out);
        } else {
            const float t = place.t;
            for (size_t k = 0; k < width; ++k) out[k] = (1.0f - t) * a[k] + t * b[k];
        }
        out += width;
    }
}

Task<void> resample_curve(Pace& pace, SamplingPlan plan, FrameColumns out, std::span<const ColumnPair> columns,
                          uint32_t progress) {
    Resampling resampling{FramedSampler(plan), plan.curve, out, columns, plan.sample_count()};
    for (bool done = false; !done;) {
        const uint32_t before = resampling.written;
        done = resampling.run(samples_at_once);
        pace.advance(uint64_t{progress} * (resampling.written - before));
        if (!done) co_await pace;
    }
}

}  // namespace flg
