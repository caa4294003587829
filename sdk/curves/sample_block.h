// SPDX-License-Identifier: MIT
// Samples of a smooth curve with their frames, as many at once as compilers have lanes for.
//
// Positions are a segment's start, which is a point of the polyline to the bit, and an offset from it: so all else is
// in single precision, relative to the segment. Every sample has its own lane and no lane reads another but for the
// frames' chain, which goes from one sample to the next: results are the same however samples are cut into blocks, and
// whatever registers the loops are compiled for.
//
// Frames are rotation minimizing by double reflection (Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing
// Frames, 2008), as core/moving_frame.h has it. Departure: a normal is an angle in its tangent's own basis (Duff et
// al.: Building an Orthonormal Basis, Revisited, 2017). What two reflections make of one basis in the next is worked
// out for all samples at once; what is left of the chain is one product of complex numbers a sample.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "curves/segment_block.h"

namespace flg {

// Cubics of a block's segments. From the start: chord * t * (linear + t * (square + t * cube)).
struct SegmentRows {
    static constexpr uint32_t size = SegmentBlock::size;
    float linear[3][size], square[3][size], cube[3][size];
    float start[3][size];
    float chord[size], length[size];            // metres
    float speed_slope[size], speed_bend[size];  // of the parabola through the speeds at the Gauss points
};

struct SampleBlock {
    static constexpr uint32_t capacity = 64;
    static constexpr uint32_t lanes = 8;
    static constexpr uint32_t size = capacity + lanes;

    uint32_t count = 0;
    // Where sample k lies.
    int32_t row[size];       // of SegmentRows
    float along[size];       // metres from the segment's start
    uint32_t segment[size];  // between the points `segment` and `segment` + 1 (around, if closed) of the polyline
    float t[size];           // where between them, 0 to 1; for columns that are interpolated linearly
    // By component. Slot k + 1 is sample k's; slot 0 that of the sample before the block.
    float start[3][size], offset[3][size];
    float tangent[3][size];  // unit
    float normal[3][size];   // unit, across the tangent
    // The tangents' own bases.
    float first[3][size], second[3][size];
    // Sample k's step: what it makes of the normal before as a number in the basis, of its real and its imaginary part.
    double real[2][size], imaginary[2][size];

    Vec3 position_of(uint32_t k) const { return vector(start, k) + vector(offset, k); }
    Vec3 tangent_of(uint32_t k) const { return vector(tangent, k); }
    Vec3 normal_of(uint32_t k) const { return vector(normal, k); }
    void set_normal(uint32_t k, const Vec3& v) {
        for (int c = 0; c < 3; ++c) normal[c][k + 1] = static_cast<float>(v[c]);
    }
    // To another place altogether, such as a curve's very end.
    void set_place(uint32_t k, const float* position, const Vec3& unit_tangent) {
        for (int c = 0; c < 3; ++c) {
            start[c][k + 1] = position[c];
            offset[c][k + 1] = 0;
            tangent[c][k + 1] = static_cast<float>(unit_tangent[c]);
        }
    }

private:
    static Vec3 vector(const float (&values)[3][size], uint32_t k) {
        return Vec3(values[0][k + 1], values[1][k + 1], values[2][k + 1]);
    }
};

// Rotation-minimizing frames over blocks. A value: copies go on independently.
class FrameChain {
public:
    // `step`: metres, about as far as samples are apart.
    explicit FrameChain(double step = 1);

    bool begun() const { return begun_; }
    // The block's first sample is the curve's.
    void begin(SampleBlock& block, const Vec3& normal);
    // Gives the block's samples their normals; begun already.
    void follow(SampleBlock& block);

private:
    float per_step_ = 1;
    bool begun_ = false;
    // Of the last sample.
    float start_[3] = {}, offset_[3] = {}, tangent_[3] = {};
    double real_ = 1, imaginary_ = 0;  // the normal in the tangent's basis
};

// Of the block's segments `first` to `last` - 1.
void make_rows(const SegmentBlock& block, uint32_t first, uint32_t last, SegmentRows& rows);
// Of the segments, which end at these arc lengths: the first of the samples 0, step, 2 step, ... behind each.
void find_stops(const double* ends, uint32_t first, uint32_t last, double step, uint32_t* stops);
// Finds `along` of the samples `first`, `first` + 1, ..., whose rows are known, and begin at these arc lengths.
void find_places(const double* starts, double first, double step, SampleBlock& block);
// Finds t, start, offset and tangent of the samples, whose rows and places along are known.
void place_samples(const SegmentRows& rows, SampleBlock& block);

// Of the first `count` samples, tightly packed.
void pack(const float (&values)[3][SampleBlock::size], uint32_t count, float* out);
void pack_positions(const SampleBlock& block, uint32_t count, float* out);

}  // namespace flg
