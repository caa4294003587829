// SPDX-License-Identifier: MIT
// Displacement of a block of samples (Minarcik, Fiser, Sykora, sec. 4.5):
//   position + magnitude * (d_t t + d_n n + d_b b),
// in single precision relative to the sample's segment; only the last addition is one of coordinates.
//
// What a sample of a plain style costs at least: 12 bytes of the target read twice, 40 written (position, tangent,
// normal, index), about 20 ns at 3 GB/s a core; some 300 operations in single precision for the segment, the place, the
// frame's step and the displacement, 10 ns where a core does 8 of 4 at once.
#pragma once

#include <span>

#include "curves/sample_block.h"

namespace flg {

struct DisplacedBlock {
    static constexpr uint32_t size = SampleBlock::size;

    // In: slot k + 1 is sample k's, as in SampleBlock.
    float along[3][size];   // d: along tangent, first and second normal; metres
    float magnitude[size];  // slot k is sample k's
    double turn_rad[size];  // likewise: by what the normal of a ribbon is turned about the tangent
    // Out.
    float displacement[3][size];  // metres, in space
    float position[3][size];

    void set_along(uint32_t k, const Vec3& d) {
        for (int c = 0; c < 3; ++c) along[c][k + 1] = static_cast<float>(d[c]);
    }
    void scale(uint32_t count, float factor) {
        for (auto& values : along)
            for (uint32_t k = 1; k <= count; ++k) values[k] *= factor;
    }
    void scale_at(uint32_t k, float factor) {
        for (auto& values : along) values[k + 1] *= factor;
    }
    void set_magnitude(double value) {
        for (float& m : magnitude) m = static_cast<float>(value);
    }
    Vec3 displacement_of(uint32_t k) const {
        return Vec3(displacement[0][k + 1], displacement[1][k + 1], displacement[2][k + 1]);
    }
};

// True if all coordinates are such as curve sets hold.
bool displace_samples(const SampleBlock& samples, DisplacedBlock& block);
// Turns the normals, which displacements don't follow.
void turn_normals(const DisplacedBlock& block, SampleBlock& samples);

}  // namespace flg
