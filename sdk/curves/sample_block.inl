// SPDX-License-Identifier: MIT
// The loops of sample_block.h, for whatever registers they are compiled for: sample_block.cpp includes them once for
// each, in a namespace of its own. Plain types only: an inline function of some header, compiled for better machines,
// could come to be called on lesser ones.

inline uint32_t whole_lanes(uint32_t count) {
    return (count + SampleBlock::lanes - 1) / SampleBlock::lanes * SampleBlock::lanes;
}

void make_rows(const SegmentBlock& __restrict block, uint32_t first, uint32_t last, SegmentRows& __restrict rows) {
    constexpr double offset_sq = gauss_offset * gauss_offset;
    const auto component = [&](const double* start, const double* u, const double* a, const double* b, int c) {
        for (uint32_t j = first; j < last; ++j) {
            const double m = block.magnitudes[j];
            const double from = m * a[j], to = m * b[j];
            rows.start[c][j] = static_cast<float>(start[j]);
            rows.linear[c][j] = static_cast<float>(from);
            rows.square[c][j] = static_cast<float>(3.0 * u[j] - 2.0 * from - to);
            rows.cube[c][j] = static_cast<float>(from + to - 2.0 * u[j]);
        }
    };
    component(block.points.x, block.directions.x, block.tangents_start.x, block.tangents_end.x, 0);
    component(block.points.y, block.directions.y, block.tangents_start.y, block.tangents_end.y, 1);
    component(block.points.z, block.directions.z, block.tangents_start.z, block.tangents_end.z, 2);
    for (uint32_t j = first; j < last; ++j) {
        const float low = block.speeds_low[j], middle = block.speeds_middle[j], high = block.speeds_high[j];
        rows.chord[j] = static_cast<float>(block.chords[j]);
        rows.length[j] = static_cast<float>(block.lengths[j]);
        rows.speed_slope[j] = (high - low) * static_cast<float>(0.5 / gauss_offset);
        rows.speed_bend[j] = (high + low - 2 * middle) * static_cast<float>(0.5 / offset_sq);
    }
}

void find_stops(const double* __restrict ends, uint32_t first, uint32_t last, double step, uint32_t* __restrict stops) {
    constexpr double samples_max = 2147483000.0;
    const double per_step = 1 / step;
    for (uint32_t j = first; j < last; ++j) {
        const double end = ends[j], steps = end * per_step;
        double n = static_cast<double>(static_cast<int32_t>(steps < samples_max ? steps : samples_max)) - 1;
        // Rounding may have it one off to either side.
        n = n > 0 ? n : 0;
        n += n * step < end ? 1.0 : 0.0;
        n += n * step < end ? 1.0 : 0.0;
        n += n * step < end ? 1.0 : 0.0;
        stops[j] = static_cast<uint32_t>(static_cast<int32_t>(n));
    }
}

void find_places(const double* __restrict starts, double first, double step, SampleBlock& __restrict block) {
    for (int32_t k = 0; k < static_cast<int32_t>(block.count); ++k) {
        block.along[k] = static_cast<float>((first + k) * step - starts[block.row[k]]);
    }
}

// The inverse of arc length. It starts from the parabola through the three speeds, what a Newton step takes away with
// the mean speed in the place of the speed at t. Where the speed varies by more than `even_speed` that isn't good
// enough, and Chebyshev's third-order form of Newton's method on the arc length itself goes on. Speeds of one segment
// differ by a factor of two at most, so it converges from anywhere near; a step as short as `last_step` leaves less
// than 1e-5 of the segment, and on all but the sharpest turns the first one is. Squared speeds are a polynomial of
// degree 4.
void find_parameters(const SegmentRows& __restrict rows, SampleBlock& __restrict block) {
    constexpr float even_speed = 1e-3f;
    constexpr float gauss = static_cast<float>(gauss_offset);
    constexpr float last_step = 3e-3f;
    constexpr int steps_max = 3;
    const uint32_t count = whole_lanes(block.count);
    int uneven = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const int32_t j = block.row[k];
        const float slope = rows.speed_slope[j], bend = rows.speed_bend[j];
        float t = block.along[k] / rows.length[j];
        const float x = t - 0.5f;
        const float x_sq = x * x;
        t -= 0.5f * slope * (x_sq - 0.25f) + bend * ((1.0f / 3) * (x_sq * x + 0.125f) - (1.0f / 12) * t);
        t = t > 0.0f ? t : 0.0f;
        block.t[k] = t < 1.0f ? t : 1.0f;
        uneven |= __builtin_fabsf(slope) + __builtin_fabsf(bend) > even_speed ? 1 : 0;
    }
    if (uneven == 0) return;
    for (uint32_t k = 0; k < count; ++k) {
        const int32_t j = block.row[k];
        // derivative(t) = a + t * (b + t * c)
        const float ax = rows.linear[0][j], ay = rows.linear[1][j], az = rows.linear[2][j];
        const float bx = 2 * rows.square[0][j], by = 2 * rows.square[1][j], bz = 2 * rows.square[2][j];
        const float cx = 3 * rows.cube[0][j], cy = 3 * rows.cube[1][j], cz = 3 * rows.cube[2][j];
        const float c0 = ax * ax + ay * ay + az * az;
        const float c1 = 2 * (ax * bx + ay * by + az * bz);
        const float c2 = bx * bx + by * by + bz * bz + 2 * (ax * cx + ay * cy + az * cz);
        const float c3 = 2 * (bx * cx + by * cy + bz * cz);
        const float c4 = cx * cx + cy * cy + cz * cz;
        const auto speed_sq = [&](float x) { return c0 + x * (c1 + x * (c2 + x * (c3 + x * c4))); };
        const float wanted = block.along[k] / rows.chord[j];
        float t = block.t[k];
        const float variation = __builtin_fabsf(rows.speed_slope[j]) + __builtin_fabsf(rows.speed_bend[j]);
        float going = variation > even_speed ? 1.0f : 0.0f;
        for (int step = 0; step < steps_max; ++step) {
            const float low = __builtin_sqrtf(speed_sq(t * (0.5f - gauss)));
            const float middle = __builtin_sqrtf(speed_sq(t * 0.5f));
            const float high = __builtin_sqrtf(speed_sq(t * (0.5f + gauss)));
            const float reached = t * (5 * (low + high) + 8 * middle) / 18;
            const float here_sq = speed_sq(t);
            const float newton = (wanted - reached) / __builtin_sqrtf(here_sq);
            const float slope = c1 + t * (2 * c2 + t * (3 * c3 + t * 4 * c4));
            t += going * (newton * (1 - newton * slope / (4 * here_sq)));
            t = t > 0.0f ? t : 0.0f;
            t = t < 1.0f ? t : 1.0f;
            going = __builtin_fabsf(newton) <= last_step ? 0.0f : going;
        }
        block.t[k] = t;
    }
}

void place_samples(const SegmentRows& __restrict rows, SampleBlock& __restrict block) {
    find_parameters(rows, block);
    const uint32_t count = whole_lanes(block.count);
    for (uint32_t k = 0; k < count; ++k) {
        const int32_t j = block.row[k];
        const float t = block.t[k], chord = rows.chord[j];
        float d[3];
        for (int c = 0; c < 3; ++c) {
            const float linear = rows.linear[c][j], square = rows.square[c][j], cube = rows.cube[c][j];
            block.start[c][k + 1] = rows.start[c][j];
            block.offset[c][k + 1] = chord * (t * (linear + t * (square + t * cube)));
            d[c] = linear + t * (2 * square + t * (3 * cube));
        }
        const float per_size = 1 / __builtin_sqrtf(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (int c = 0; c < 3; ++c) block.tangent[c][k + 1] = per_size * d[c];
    }
}

// Of slots 0 to `count` - 1.
void make_bases(SampleBlock& block, uint32_t count) {
    for (uint32_t k = 0; k < count; ++k) {
        const float x = block.tangent[0][k], y = block.tangent[1][k], z = block.tangent[2][k];
        const float sign = z >= 0.0f ? 1.0f : -1.0f;
        const float a = -1 / (sign + z);
        const float b = x * y * a;
        block.first[0][k] = 1 + sign * x * x * a;
        block.first[1][k] = sign * b;
        block.first[2][k] = -sign * x;
        block.second[0][k] = b;
        block.second[1][k] = sign + y * y * a;
        block.second[2][k] = -y;
    }
}

// Where the step has no length or runs across the tangent (a corner, a reversal), the chord is replaced by the sum of
// the tangents, which gives the smallest rotation from one to the other; on a reversal the normal stays.
void find_steps(SampleBlock& block, float per_step) {
    constexpr float across_sq = 1e-4f;     // of the second reflection's vector, which is 2 long on smooth curves
    constexpr float still_sq = 1e-12f;     // of the chord, in steps
    constexpr float reversal_sq = 1e-10f;  // of the sum of the tangents
    const uint32_t count = whole_lanes(block.count);
    make_bases(block, count + 1);
    for (uint32_t k = 0; k < count; ++k) {
        float chord[3], before[3], here[3], from[3], second[3], sum[3];
        float chord_sq = 0, ahead = 0, sum_sq = 0, second_sq = 0;
        for (int c = 0; c < 3; ++c) {
            before[c] = block.tangent[c][k];
            here[c] = block.tangent[c][k + 1];
            from[c] = block.first[c][k];
            const float between = block.start[c][k + 1] - block.start[c][k];
            chord[c] = per_step * (between + (block.offset[c][k + 1] - block.offset[c][k]));
            sum[c] = here[c] + before[c];
            chord_sq += chord[c] * chord[c];
            ahead += chord[c] * before[c];
            sum_sq += sum[c] * sum[c];
        }
        const bool still = !(chord_sq > still_sq);
        const float mirror = still ? 0.0f : 2 * ahead / chord_sq;
        for (int c = 0; c < 3; ++c) {
            second[c] = here[c] - before[c] + mirror * chord[c];
            second_sq += second[c] * second[c];
        }
        const bool across = still || second_sq < across_sq;
        const bool back = across && sum_sq < reversal_sq;
        const float first_sq = across ? sum_sq : chord_sq;
        const float first_factor = back ? 0.0f : 2 / first_sq;
        const float second_factor = back ? 0.0f : 2 / (across ? 4.0f : second_sq);
        float along_first = 0, along_second = 0, real = 0, imaginary = 0;
        for (int c = 0; c < 3; ++c) {
            chord[c] = across ? sum[c] : chord[c];
            second[c] = across ? 2 * here[c] : second[c];
            along_first += chord[c] * from[c];
        }
        along_first *= first_factor;
        for (int c = 0; c < 3; ++c) {
            from[c] -= along_first * chord[c];
            along_second += second[c] * from[c];
        }
        along_second *= second_factor;
        for (int c = 0; c < 3; ++c) {
            from[c] -= along_second * second[c];
            real += from[c] * block.first[c][k + 1];
            imaginary += from[c] * block.second[c][k + 1];
        }
        // To unit size: rounding has left it there but for `excess`.
        const double r = real, i = imaginary;
        const double excess = r * r + i * i - 1;
        const double to_unit = 1 - excess * (0.5 - 0.375 * excess);
        const double handed = back ? -to_unit : to_unit;  // a reversal turns the basis over
        block.real[0][k] = to_unit * r;
        block.imaginary[0][k] = to_unit * i;
        block.real[1][k] = handed * -i;
        block.imaginary[1][k] = handed * r;
    }
}

// From the numbers in real[0] and imaginary[0].
void find_normals(SampleBlock& block) {
    const uint32_t count = whole_lanes(block.count);
    for (uint32_t k = 0; k < count; ++k) {
        const float real = static_cast<float>(block.real[0][k]), imaginary = static_cast<float>(block.imaginary[0][k]);
        for (int c = 0; c < 3; ++c) {
            block.normal[c][k + 1] = real * block.first[c][k + 1] + imaginary * block.second[c][k + 1];
        }
    }
}
