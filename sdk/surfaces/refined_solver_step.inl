// SPDX-License-Identifier: MIT
// refined_solver_step.h for whatever registers it is compiled for: refined_solver_step.cpp includes it once for each, in a
// namespace of its own. Plain types only: an inline function of some header, compiled for better machines, could come to
// be called on lesser ones.

using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Int8 = int32_t __attribute__((vector_size(32)));

constexpr float huge = 3e38f;

#define FLG_LANES(x) Float8{x, x, x, x, x, x, x, x}

[[gnu::always_inline]] inline Float8 root(Float8 a) {
    Float8 result;
    for (int i = 0; i < 8; ++i) result[i] = __builtin_sqrtf(a[i]);
    return result;
}
[[gnu::always_inline]] inline Float8 least(Float8 a, Float8 b) {
    return a < b ? a : b;
}
[[gnu::always_inline]] inline Float8 greatest(Float8 a, Float8 b) {
    return a > b ? a : b;
}
// Each lane gets the next one's value, the last its own.
[[gnu::always_inline]] inline Float8 from_next(Float8 a) {
    return __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 7);
}
[[gnu::always_inline]] inline Float8 from_previous(Float8 a) {
    return __builtin_shufflevector(a, a, 0, 0, 1, 2, 3, 4, 5, 6);
}

struct Columns {
    Float8 a, b, c, d;
};

[[gnu::always_inline]] inline Float8 load_two(const float* records, uint32_t first, uint32_t second) {
    const Float4 low = *reinterpret_cast<const Float4*>(records + 4 * uint64_t{first});
    const Float4 high = *reinterpret_cast<const Float4*>(records + 4 * uint64_t{second});
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

// The records of eight ranks, of four floats each, as four columns.
[[gnu::always_inline]] inline Columns load_columns(const float* records, const uint32_t* ranks) {
    const Float8 r04 = load_two(records, ranks[0], ranks[4]), r15 = load_two(records, ranks[1], ranks[5]);
    const Float8 r26 = load_two(records, ranks[2], ranks[6]), r37 = load_two(records, ranks[3], ranks[7]);
    const Float8 ab01 = __builtin_shufflevector(r04, r15, 0, 8, 1, 9, 4, 12, 5, 13);
    const Float8 cd01 = __builtin_shufflevector(r04, r15, 2, 10, 3, 11, 6, 14, 7, 15);
    const Float8 ab23 = __builtin_shufflevector(r26, r37, 0, 8, 1, 9, 4, 12, 5, 13);
    const Float8 cd23 = __builtin_shufflevector(r26, r37, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(ab01, ab23, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab01, ab23, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(cd01, cd23, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(cd01, cd23, 2, 3, 10, 11, 6, 7, 14, 15)};
}

// What is known along the edge from the vertex to a neighbour, and its triangle's angle theta.
struct Edge {
    Float8 length, inverse_length;
    Float8 cosine, sine;            // of phi
    Float8 near_slope, far_slope;   // a and b, clamped
    Float8 least;                   // distance at its ends
};

struct Candidate {
    Float8 distance;  // huge where the way does not cross the edge
    Float8 crossing;  // how far from the vertex
};

// The way to the triangle's third corner, `length` from the vertex, across `edge`.
[[gnu::always_inline]] inline Candidate unfold(const Edge& edge, Float8 distance, Float8 length, Float8 cos_theta,
                                               Float8 sin_theta) {
    const Float8 zero = {}, one = FLG_LANES(1.0f);
    const Float8 cosine = edge.cosine * cos_theta - edge.sine * sin_theta;
    const Float8 sine = edge.sine * cos_theta + edge.cosine * sin_theta;
    const Float8 crossing = distance * length * sine / (distance * edge.sine + length * sin_theta);
    const Float8 square = distance * distance + length * (length - (distance + distance) * cosine);
    const Float8 t = crossing * edge.inverse_length, u = one - t;
    const Float8 cubic = crossing * u * (edge.near_slope * u - edge.far_slope * t);
    const Float8 reached = greatest(root(greatest(square, zero)) + cubic, edge.least);
    const Int8 crosses = (sin_theta > zero) & (sine >= zero) & (crossing <= edge.length) & (reached < FLG_LANES(huge));
    return {crosses ? reached : FLG_LANES(huge), crossing};
}

[[gnu::always_inline]] inline void wave_step(const uint32_t* lanes, const float* positions, const float* states,
                                             uint32_t rank, WaveStep& step) {
    const Float8 zero = {}, one = FLG_LANES(1.0f);
    const float* const own_position = positions + 4 * uint64_t{rank};
    const float* const own_state = states + 4 * uint64_t{rank};
    const Float8 distance = FLG_LANES(own_state[0]);

    // Geometry: directions and lengths of edges, angles between them.
    const Columns position = load_columns(positions, lanes);
    Float8 ex = position.a - own_position[0], ey = position.b - own_position[1], ez = position.c - own_position[2];
    const Float8 length = root(ex * ex + ey * ey + ez * ez);
    const Float8 inverse_length = length > zero ? one / length : zero;
    ex *= inverse_length, ey *= inverse_length, ez *= inverse_length;
    const Float8 next_x = from_next(ex), next_y = from_next(ey), next_z = from_next(ez);
    const Float8 cos_theta = ex * next_x + ey * next_y + ez * next_z;
    const Float8 nx = ey * next_z - ez * next_y, ny = ez * next_x - ex * next_z, nz = ex * next_y - ey * next_x;
    const Float8 sin_theta = root(nx * nx + ny * ny + nz * nz);

    // The wave at both ends of each edge. Neighbours that it has reached late or not at all are reached along the edge.
    const Columns wave = load_columns(states, lanes);
    const Float8 along = distance + length;
    const Int8 late = along < wave.a;
    const Float8 far = late ? along : wave.a;
    const Float8 slope_far = late ? one : wave.b * ex + wave.c * ey + wave.d * ez;
    const Float8 slope_near = own_state[1] * ex + own_state[2] * ey + own_state[3] * ez;

    const Float8 quotient = (length * length + (distance - far) * (distance + far)) / ((length + length) * distance);
    Edge edge;
    edge.length = length;
    edge.inverse_length = inverse_length;
    edge.cosine = least(greatest(quotient, -one), one);
    edge.sine = root((one - edge.cosine) * (one + edge.cosine));
    const Float8 half = FLG_LANES(0.5f);
    edge.near_slope = least(greatest(slope_near + edge.cosine, -half), half);
    edge.far_slope = least(greatest(slope_far - (length - distance * edge.cosine) / far, -half), half);
    edge.least = least(distance, far);
    const Edge next = {from_next(length),          from_next(inverse_length), from_next(edge.cosine),
                       from_next(edge.sine),       from_next(edge.near_slope), from_next(edge.far_slope),
                       from_next(edge.least)};

    // From lane l across edge l to lane l + 1, and from lane l + 1 across edge l + 1 to lane l. At the source no angle is
    // known, and none needed.
    const Float8 open = own_state[0] > 0 ? sin_theta : zero;
    Candidate ahead = unfold(edge, distance, next.length, cos_theta, open);
    const Candidate back = unfold(next, distance, length, cos_theta, open);
    ahead.distance = from_previous(ahead.distance);
    ahead.distance[0] = huge;
    ahead.crossing = from_previous(ahead.crossing);

    const Int8 takes_back = back.distance < ahead.distance;
    const Float8 across = takes_back ? back.distance : ahead.distance;
    const Int8 takes_edge = ~(across < along);
    const Float8 best = takes_edge ? along : across;
    const Int8 improved = best < wave.a * (1 - least_improvement);

    // Where the wave goes: from the point where it crosses the edge.
    const Float8 crossing = takes_edge ? zero : takes_back ? back.crossing : ahead.crossing;
    const Float8 gx = length * ex - crossing * (takes_back ? next_x : from_previous(ex));
    const Float8 gy = length * ey - crossing * (takes_back ? next_y : from_previous(ey));
    const Float8 gz = length * ez - crossing * (takes_back ? next_z : from_previous(ez));
    const Float8 norm = root(gx * gx + gy * gy + gz * gz);
    const Float8 scale = norm > zero ? one / norm : zero;

    step.improved = 0;
    for (uint32_t lane = 0; lane < lane_count; ++lane) {
        if (improved[lane]) step.improved |= 1u << lane;
        step.states[lane] = {best[lane], gx[lane] * scale[lane], gy[lane] * scale[lane], gz[lane] * scale[lane]};
    }
}

#undef FLG_LANES
