// SPDX-License-Identifier: MIT
// refined_solver_step.h for whatever registers it is compiled for: refined_solver_step.cpp includes it once for each, in a
// namespace of its own. Plain types only: an inline function of some header, compiled for better machines, could come to
// be called on lesser ones.

using Float8 = float __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));
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
[[gnu::always_inline]] inline Float8 load(const float* values) {
    return *reinterpret_cast<const Float8*>(values);
}
// The states of eight ranks as two columns. The last rank's top bit does not count.
[[gnu::always_inline]] inline void load_states(const WaveState* states, const uint32_t* ranks, Float8& distances,
                                               Float8& bends) {
    Double4 low, high;  // a state each
    for (int i = 0; i < 4; ++i) {
        double state;
        __builtin_memcpy(&state, &states[ranks[i]], sizeof state);
        low[i] = state;
        __builtin_memcpy(&state, &states[i == 3 ? ranks[7] & ~block_continues : ranks[i + 4]], sizeof state);
        high[i] = state;
    }
    const Float8 pairs = reinterpret_cast<Float8>(low), more_pairs = reinterpret_cast<Float8>(high);
    distances = __builtin_shufflevector(pairs, more_pairs, 0, 2, 4, 6, 8, 10, 12, 14);
    bends = __builtin_shufflevector(pairs, more_pairs, 1, 3, 5, 7, 9, 11, 13, 15);
}
[[gnu::always_inline]] inline void store_states(Float8 distances, Float8 bends, WaveState* states) {
    const Float8 low = __builtin_shufflevector(distances, bends, 0, 8, 1, 9, 2, 10, 3, 11);
    const Float8 high = __builtin_shufflevector(distances, bends, 4, 12, 5, 13, 6, 14, 7, 15);
    __builtin_memcpy(states, &low, sizeof low);
    __builtin_memcpy(states + 4, &high, sizeof high);
}
[[gnu::always_inline]] inline uint32_t mask(Int8 lanes) {
#ifdef FLG_MOVE_MASK
    return static_cast<uint32_t>(FLG_MOVE_MASK(reinterpret_cast<Float8>(lanes)));
#else
    uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= static_cast<uint32_t>(lanes[i] & 1) << i;
    return bits;
#endif
}
// Each lane gets the next one's value, the last its own.
template <class Lanes>
[[gnu::always_inline]] inline Lanes from_next(Lanes a) {
    return __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 7);
}
// And from the one before, the first the last's: there no triangle is.
template <class Lanes>
[[gnu::always_inline]] inline Lanes from_previous(Lanes a) {
    return __builtin_shufflevector(a, a, 7, 0, 1, 2, 3, 4, 5, 6);
}

[[gnu::always_inline]] inline Float8 clamped(Float8 a, Float8 low, Float8 high) {
    return least(greatest(a, low), high);
}

// The front `way` further on. The last `bent` of it lead through a triangle of that Gaussian curvature; the front's radius
// before them is `part` of that behind.
[[gnu::always_inline]] inline Float8 carry(Float8 front, Float8 way, Float8 part, Float8 bent, Float8 curvature,
                                     Float8 bend_limit) {
    const Float8 one = FLG_LANES(1.0f);
    const Float8 bend = curvature * bent * (one + part + part * part) * FLG_LANES(1.0f / 3);
    return front / (one + front * way) - clamped(bend, -bend_limit, bend_limit);
}

[[gnu::always_inline]] inline void wave_step(const GeodesicBlock& block, const WaveState* states, const WaveState& own,
                                             float bend_max, bool labelled, WaveStep& step) {
    const Float8 zero = {}, one = FLG_LANES(1.0f), half = FLG_LANES(0.5f);
    const Float8 length = load(block.lengths.data()), tangent = load(block.tangents.data());
    const Float8 curvature = load(block.curvatures.data());
    const Float8 distance = FLG_LANES(own.distance), own_front = FLG_LANES(own.front);
    const Float8 bend_limit = FLG_LANES(bend_max), hollowest = FLG_LANES(-most_hollow * bend_max);
    const Float8 sharpest = FLG_LANES(1 / own.distance + bend_max);
    Float8 far, far_front;
    load_states(states, block.lanes.data(), far, far_front);

    // In each triangle, across the edge to its nearer corner, the base, to the one that is further, the target.
    const Float8 next_length = from_next(length), next_far = from_next(far);
    const Int8 forth = far < next_far;
    const Float8 base = forth ? length : next_length, target = forth ? next_length : length;
    const Float8 base_distance = least(far, next_far);
    const Float8 base_front = forth ? far_front : from_next(far_front);

    // The front at the base when it was at the vertex; then both as one. No circle passes so near to both ends that the cosine
    // is above 1: next to a line that is the source.
    const Float8 inverse_base = one / base;
    const Float8 ahead_by = distance - base_distance;
    const Float8 moved_front = clamped(base_front / (one + base_front * ahead_by), hollowest, sharpest);
    const Float8 trust = distance / greatest(distance + base_distance, FLG_LANES(1e-30f));
    const Float8 front = own_front + trust * (moved_front - own_front);
    const Float8 slope = ahead_by * inverse_base;
    const Float8 quotient = slope + half * base * front * (one - slope * slope);
    const Float8 cos_phi = clamped(quotient, -one, one);
    const Float8 sin_phi = root((one - cos_phi) * (one + cos_phi));
    const Float8 inverse_secant = one / (one + tangent * tangent);
    const Float8 cos_theta = (one - tangent * tangent) * inverse_secant;
    const Float8 sin_theta = (tangent + tangent) * inverse_secant;
    const Float8 cosine = cos_phi * cos_theta - sin_phi * sin_theta;
    const Float8 sine = sin_phi * cos_theta + cos_phi * sin_theta;

    // Over the front's radius: heights above the edge, of the source, on its other side, and of the target.
    const Float8 target_height = target * sin_theta;
    const Float8 inverse_height = one / (sin_phi + front * target_height);
    const Float8 crossing = target * sine * inverse_height, rest = base - crossing;
    const Float8 excess = target * (front * target - (cosine + cosine));
    const Float8 ratio = root(greatest(one + front * excess, zero));
    const Float8 on = excess / (one + ratio);
    const Float8 reached = greatest(distance + on, least(distance, base_distance));
    const Float8 less_hollow = FLG_LANES(hollow_ratio) * greatest(own_front, moved_front);
    const Float8 crossing_front = greatest((rest * own_front + crossing * moved_front) * inverse_base,
                                           least(less_hollow, FLG_LANES(-hollow_share * bend_max)));
    const Float8 bent = ratio * target_height * inverse_height;
    const Float8 across_front = carry(crossing_front, on, sin_phi * inverse_height, bent, curvature, bend_limit);
    const Int8 crosses = (sin_theta > zero) & (quotient < FLG_LANES(1.001f)) & (sine >= zero) & (crossing >= zero) &
                         (rest >= zero) & (reached < FLG_LANES(huge));
    const Float8 across = crosses ? reached : FLG_LANES(huge);

    // To lane l + 1 from triangle l, to lane l from it or along the edge.
    const Float8 ahead = from_previous(forth ? across : FLG_LANES(huge));
    const Float8 back = forth ? FLG_LANES(huge) : across;
    const Float8 along = distance + length;
    const Int8 takes_back = back < ahead;
    const Float8 best_across = least(back, ahead);
    const Int8 takes_edge = ~(best_across <= along * FLG_LANES(1 + least_improvement));
    const Float8 best = least(best_across, along);
    const Float8 leaving_front = own.distance > 0 ? own_front : FLG_LANES(sharpest_front);
    const Float8 along_front =
        carry(leaving_front, length, one / (one + leaving_front * length), length, curvature, bend_limit);
    const Float8 best_front = takes_edge ? along_front : takes_back ? across_front : from_previous(across_front);

    if (labelled) {
        const Int8 beyond = crossing > rest, after = {1, 1, 1, 1, 1, 1, 1, 1};
        const Int8 side = takes_edge ? Int8{} : takes_back ? (beyond & after) : (from_previous(beyond) & -after);
        __builtin_memcpy(step.sides, &side, sizeof side);
    }
    const Int8 improves = best < far * (1 - least_improvement);
    step.improved = mask(improves);
    step.across_next = mask(improves & takes_back & ~takes_edge);
    step.across_previous = mask(improves & ~(takes_back | takes_edge));
    store_states(best, clamped(best_front, hollowest, bend_limit + one / best), step.states);
}

#undef FLG_LANES
