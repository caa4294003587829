// SPDX-License-Identifier: MIT
// The loops of segment_block.h, segment_stream.h and arc_length.h, as sample_block.inl has its own.

void load_points(const float* __restrict positions, uint32_t count, double* __restrict x, double* __restrict y,
                 double* __restrict z) {
    for (uint32_t k = 0; k < count; ++k) {
        x[k] = positions[3 * k];
        y[k] = positions[3 * k + 1];
        z[k] = positions[3 * k + 2];
    }
}

void make_edges(SegmentBlock& block, uint32_t points) {
    const SegmentBlock::Vectors& p = block.points;
    SegmentBlock::Vectors& u = block.directions;
    for (uint32_t j = 1; j <= points; ++j) {
        const double x = p.x[j + 1] - p.x[j], y = p.y[j + 1] - p.y[j], z = p.z[j + 1] - p.z[j];
        const double chord = __builtin_sqrt(x * x + y * y + z * z);
        const double inverse = 1.0 / chord;
        block.chords[j] = chord;
        u.x[j] = x * inverse;
        u.y[j] = y * inverse;
        u.z[j] = z * inverse;
    }
}

void make_vertices(const SegmentBlock& __restrict block, uint32_t points, SegmentBlock::Vectors& __restrict tangents,
                   double* __restrict cosines) {
    const SegmentBlock::Vectors& u = block.directions;
    for (uint32_t j = 1; j <= points; ++j) {
        const double before = block.chords[j - 1], after = block.chords[j];
        cosines[j] = u.x[j - 1] * u.x[j] + u.y[j - 1] * u.y[j] + u.z[j - 1] * u.z[j];
        // The vector after * u[j - 1] + before * u[j] would be this long.
        const double x = after * u.x[j - 1] + before * u.x[j];
        const double y = after * u.y[j - 1] + before * u.y[j];
        const double z = after * u.z[j - 1] + before * u.z[j];
        const double inverse = 1.0 / __builtin_sqrt(x * x + y * y + z * z);
        tangents.x[j] = x * inverse;
        tangents.y[j] = y * inverse;
        tangents.z[j] = z * inverse;
    }
}

void measure_segments(SegmentBlock& block, uint32_t count) {
    const SegmentBlock::Vectors &u = block.directions, &a = block.tangents_start, &b = block.tangents_end;
    constexpr float gauss = static_cast<float>(gauss_offset);
    for (uint32_t j = 0; j < count; ++j) {
        const auto ux = static_cast<float>(u.x[j]), uy = static_cast<float>(u.y[j]), uz = static_cast<float>(u.z[j]);
        const auto ax = static_cast<float>(a.x[j]), ay = static_cast<float>(a.y[j]), az = static_cast<float>(a.z[j]);
        const auto bx = static_cast<float>(b.x[j]), by = static_cast<float>(b.y[j]), bz = static_cast<float>(b.z[j]);
        const float cosine_start = ux * ax + uy * ay + uz * az;
        const float cosine_end = ux * bx + uy * by + uz * bz;
        const float cosine_turn = ax * bx + ay * by + az * bz;
        const float cosines = cosine_start + cosine_end;
        const float m = 4 / (2 + cosines);
        // With d the chord, g the sum and h the difference of the end derivatives, the derivative is
        // 0.6 d + 0.2 g -+ gauss_offset h at the outer points, and 1.5 d - 0.25 g in the middle.
        const float d_g = m * cosines;
        const float g_g = 2 * m * m * (1 + cosine_turn);
        const float h_h = 2 * m * m * (1 - cosine_turn);
        const float outer = 0.36f + 0.24f * d_g + 0.04f * g_g + 0.15f * h_h;
        const float skew = (2 * 0.6f * gauss) * m * (cosine_end - cosine_start);
        const float low = __builtin_sqrtf(outer - skew);
        const float middle = __builtin_sqrtf(2.25f - 0.75f * d_g + 0.0625f * g_g);
        const float high = __builtin_sqrtf(outer + skew);
        block.magnitudes[j] = m;
        block.speeds_low[j] = low;
        block.speeds_middle[j] = middle;
        block.speeds_high[j] = high;
        block.lengths[j] = block.chords[j] * (5 * (low + high) + 8 * middle) * (1.0 / 18);
    }
}

// Of the segments `first` to `last` - 1: twice the middles' deviation from `from` times the lengths, and the squared
// distance of the ends from the line along `tangent`.
void measure_deviations(const SegmentBlock& __restrict block, uint32_t first, uint32_t last, const double* from,
                        const double* tangent, double (*__restrict moments)[SegmentBlock::size],
                        double* __restrict across_sq) {
    const SegmentBlock::Vectors& p = block.points;
    const double fx = from[0], fy = from[1], fz = from[2];
    const double tx = tangent[0], ty = tangent[1], tz = tangent[2];
    for (uint32_t j = first; j < last; ++j) {
        const double x = p.x[j + 1] - fx, y = p.y[j + 1] - fy, z = p.z[j + 1] - fz;
        const double length = block.lengths[j];
        moments[0][j] = length * (p.x[j] - fx + x);
        moments[1][j] = length * (p.y[j] - fy + y);
        moments[2][j] = length * (p.z[j] - fz + z);
        const double along = x * tx + y * ty + z * tz;
        const double ax = x - along * tx, ay = y - along * ty, az = z - along * tz;
        across_sq[j] = ax * ax + ay * ay + az * az;
    }
}

// Largest coordinate in size of the points `first` to `last` - 1, which are floats.
float largest_coordinate(const SegmentBlock& block, uint32_t first, uint32_t last) {
    int32_t largest = 0;
    for (uint32_t j = first; j < last; ++j) {
        const auto x = __builtin_bit_cast(int32_t, __builtin_fabsf(static_cast<float>(block.points.x[j])));
        const auto y = __builtin_bit_cast(int32_t, __builtin_fabsf(static_cast<float>(block.points.y[j])));
        const auto z = __builtin_bit_cast(int32_t, __builtin_fabsf(static_cast<float>(block.points.z[j])));
        const int32_t here = x > y ? (x > z ? x : z) : (y > z ? y : z);
        largest = here > largest ? here : largest;
    }
    return __builtin_bit_cast(float, largest);
}
