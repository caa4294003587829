// SPDX-License-Identifier: MIT
#include "curves/resample.h"

#include <array>

namespace flg {

namespace {

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

ResampleKernel::ResampleKernel(const SamplingPlan& plan, const FrameColumns& out, std::span<const ColumnPair> columns)
    : sampler_(plan), curve_(plan.curve), out_(out), columns_(columns), count_(plan.sample_count()) {}

bool ResampleKernel::run(uint32_t n) {
    std::array<FramedSample, sample_block> samples;
    std::array<SamplePlace, sample_block> places;
    while (n > 0 && written_ < count_) {
        const uint32_t filled = sampler_.next(samples.data(), sample_block, n);
        for (uint32_t k = 0; k < filled; ++k) {
            const FramedSample& sample = samples[k];
            const size_t at = 3 * static_cast<size_t>(written_ + k);
            store_vec3(sample.position, out_.positions + at);
            store_vec3(sample.tangent, out_.tangents + at);
            store_vec3(sample.normal, out_.normals + at);
            places[k] = {sample.segment, sample.t};
        }
        for (const ColumnPair& column : columns_) {
            interpolate_column(column, curve_, {places.data(), filled}, written_);
        }
        written_ += filled;
    }
    return written_ == count_;
}

}  // namespace flg
