// SPDX-License-Identifier: MIT
#include "curves/sample_block.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/vector_targets.h"

namespace flg {

namespace portable {
#include "curves/sample_block.inl"

void pack(const float* __restrict x, const float* __restrict y, const float* __restrict z, uint32_t count,
          float* __restrict out) {
    for (uint32_t k = 0; k < count; ++k) {
        out[3 * k] = x[k];
        out[3 * k + 1] = y[k];
        out[3 * k + 2] = z[k];
    }
}
}  // namespace portable

#ifdef FLG_DISPATCH_VECTORS
FLG_BEGIN_AVX2
namespace avx2 {
#include "curves/sample_block.inl"

// Eight at a time: three shuffled registers, which compilers don't find by themselves.
void pack(const float* __restrict x, const float* __restrict y, const float* __restrict z, uint32_t count,
          float* __restrict out) {
    typedef float Lanes __attribute__((vector_size(32), aligned(4), may_alias));
    constexpr int any = 0;
    uint32_t k = 0;
    for (; k + 8 <= count; k += 8) {
        const Lanes a = *reinterpret_cast<const Lanes*>(x + k);
        const Lanes b = *reinterpret_cast<const Lanes*>(y + k);
        const Lanes c = *reinterpret_cast<const Lanes*>(z + k);
        // Of x and y, with room for z.
        const Lanes first = __builtin_shufflevector(a, b, 0, 8, any, 1, 9, any, 2, 10);
        const Lanes second = __builtin_shufflevector(a, b, any, 3, 11, any, 4, 12, any, 5);
        const Lanes third = __builtin_shufflevector(a, b, 13, any, 6, 14, any, 7, 15, any);
        Lanes* const rows = reinterpret_cast<Lanes*>(out + 3 * k);
        rows[0] = __builtin_shufflevector(first, c, 0, 1, 8, 3, 4, 9, 6, 7);
        rows[1] = __builtin_shufflevector(second, c, 10, 1, 2, 11, 4, 5, 12, 7);
        rows[2] = __builtin_shufflevector(third, c, 0, 13, 2, 3, 14, 5, 6, 15);
    }
    portable::pack(x + k, y + k, z + k, count - k, out + 3 * k);
}
}  // namespace avx2
FLG_END_AVX2
#endif

void make_rows(const SegmentBlock& block, uint32_t first, uint32_t last, SegmentRows& rows) {
    FLG_FOR_THIS_MACHINE(make_rows(block, first, last, rows));
}

void find_stops(const double* ends, uint32_t first, uint32_t last, double step, uint32_t* stops) {
    FLG_FOR_THIS_MACHINE(find_stops(ends, first, last, step, stops));
}

void find_places(const double* starts, double first, double step, SampleBlock& block) {
    FLG_FOR_THIS_MACHINE(find_places(starts, first, step, block));
}

void place_samples(const SegmentRows& rows, SampleBlock& block) {
    // Lanes that are nobody's go along with the last sample.
    for (uint32_t k = block.count; k % SampleBlock::lanes != 0; ++k) {
        block.row[k] = block.row[block.count - 1];
        block.along[k] = block.along[block.count - 1];
    }
    FLG_FOR_THIS_MACHINE(place_samples(rows, block));
}

FrameChain::FrameChain(double step)
    : per_step_(static_cast<float>(std::min(1 / step, double{std::numeric_limits<float>::max()}))) {}

void FrameChain::begin(SampleBlock& block, const Vec3& normal) {
    begun_ = true;
    for (int c = 0; c < 3; ++c) {
        start_[c] = block.start[c][1];
        offset_[c] = block.offset[c][1];
        tangent_[c] = block.tangent[c][1];
        block.tangent[c][0] = tangent_[c];
    }
    portable::make_bases(block, 1);
    const Vec3 first(block.first[0][0], block.first[1][0], block.first[2][0]);
    const Vec3 second(block.second[0][0], block.second[1][0], block.second[2][0]);
    const double real = normal.dot(first), imaginary = normal.dot(second);
    const double size = std::sqrt(real * real + imaginary * imaginary);
    real_ = real / size;
    imaginary_ = imaginary / size;
}

void FrameChain::follow(SampleBlock& block) {
    for (int c = 0; c < 3; ++c) {
        block.start[c][0] = start_[c];
        block.offset[c][0] = offset_[c];
        block.tangent[c][0] = tangent_[c];
    }
    FLG_FOR_THIS_MACHINE(find_steps(block, per_step_));
    double r = real_, i = imaginary_;
    for (uint32_t k = 0; k < block.count; ++k) {
        const double real = r * block.real[0][k] + i * block.real[1][k];
        i = r * block.imaginary[0][k] + i * block.imaginary[1][k];
        r = real;
        block.real[0][k] = r;
        block.imaginary[0][k] = i;
    }
    real_ = r;
    imaginary_ = i;
    FLG_FOR_THIS_MACHINE(find_normals(block));
    const uint32_t last = block.count;
    for (int c = 0; c < 3; ++c) {
        start_[c] = block.start[c][last];
        offset_[c] = block.offset[c][last];
        tangent_[c] = block.tangent[c][last];
    }
}

void pack(const float (&values)[3][SampleBlock::size], uint32_t count, float* out) {
    FLG_FOR_THIS_MACHINE(pack(values[0] + 1, values[1] + 1, values[2] + 1, count, out));
}

void pack_positions(const SampleBlock& block, uint32_t count, float* out) {
    for (uint32_t k = 0; k < count; ++k) {
        for (uint32_t c = 0; c < 3; ++c) out[3 * k + c] = block.start[c][k + 1] + block.offset[c][k + 1];
    }
}

}  // namespace flg
