// SPDX-License-Identifier: MIT
// wave_step.h for whatever registers it is compiled for: wave_step.cpp includes it once for each,
// in a namespace of its own, for FLG_VERTICES in a register, 1 or 2. Plain types only: an inline function of some
// header, compiled for better machines, could come to be called on lesser ones.

using Double4 = double __attribute__((vector_size(32)));
using Float8 = float __attribute__((vector_size(32)));
using Register = float __attribute__((vector_size(32 * FLG_VERTICES)));
using Bits = int32_t __attribute__((vector_size(32 * FLG_VERTICES)));

constexpr float huge = 3e38f;
constexpr uint32_t register_lanes = 8 * FLG_VERTICES;
// A step is one long chain of operations, each of which waits for the one before: two registers take turns, so that
// there are always two that do not wait for each other.
constexpr uint32_t vertices_at_a_time = 2 * FLG_VERTICES;

// By lane, those of the second vertex behind those of the first.
#if FLG_VERTICES == 2
#define FLG_LANES_OF(x, y) \
    { x, x, x, x, x, x, x, x, y, y, y, y, y, y, y, y }
#define FLG_SHUFFLE(a, b, c, d, e, f, g, h) \
    a, b, c, d, e, f, g, h, (a) + 8, (b) + 8, (c) + 8, (d) + 8, (e) + 8, (f) + 8, (g) + 8, (h) + 8
#else
#define FLG_LANES_OF(x, y) \
    { x, x, x, x, x, x, x, x }
#define FLG_SHUFFLE(a, b, c, d, e, f, g, h) a, b, c, d, e, f, g, h
#endif
#define FLG_INLINE [[gnu::always_inline]] inline

struct Floats {
    Register a, b;
};
struct Masks {
    Bits a, b;
};

FLG_INLINE Floats lanes(float x) {
    const Register filled = FLG_LANES_OF(x, x);
    return {filled, filled};
}
FLG_INLINE Floats operator+(const Floats& x, const Floats& y) {
    return {x.a + y.a, x.b + y.b};
}
FLG_INLINE Floats operator-(const Floats& x, const Floats& y) {
    return {x.a - y.a, x.b - y.b};
}
FLG_INLINE Floats operator-(const Floats& x) {
    return {-x.a, -x.b};
}
FLG_INLINE Floats operator*(const Floats& x, const Floats& y) {
    return {x.a * y.a, x.b * y.b};
}
FLG_INLINE Floats operator/(const Floats& x, const Floats& y) {
    return {x.a / y.a, x.b / y.b};
}
FLG_INLINE Masks operator<(const Floats& x, const Floats& y) {
    return {x.a < y.a, x.b < y.b};
}
FLG_INLINE Masks operator>(const Floats& x, const Floats& y) {
    return {x.a > y.a, x.b > y.b};
}
FLG_INLINE Masks operator<=(const Floats& x, const Floats& y) {
    return {x.a <= y.a, x.b <= y.b};
}
FLG_INLINE Masks operator>=(const Floats& x, const Floats& y) {
    return {x.a >= y.a, x.b >= y.b};
}
FLG_INLINE Masks operator&(const Masks& x, const Masks& y) {
    return {x.a & y.a, x.b & y.b};
}
FLG_INLINE Masks operator|(const Masks& x, const Masks& y) {
    return {x.a | y.a, x.b | y.b};
}
FLG_INLINE Masks operator-(const Masks& x) {
    return {-x.a, -x.b};
}
FLG_INLINE Masks operator~(const Masks& x) {
    return {~x.a, ~x.b};
}
FLG_INLINE Floats choose(const Masks& mask, const Floats& x, const Floats& y) {
    return {mask.a ? x.a : y.a, mask.b ? x.b : y.b};
}
FLG_INLINE Floats least(const Floats& x, const Floats& y) {
    return choose(x < y, x, y);
}
FLG_INLINE Floats greatest(const Floats& x, const Floats& y) {
    return choose(x > y, x, y);
}
FLG_INLINE Floats clamped(const Floats& x, const Floats& low, const Floats& high) {
    return least(greatest(x, low), high);
}
FLG_INLINE Floats root(const Floats& x) {
    Floats result;
    for (uint32_t i = 0; i < register_lanes; ++i) result.a[i] = __builtin_sqrtf(x.a[i]);
    for (uint32_t i = 0; i < register_lanes; ++i) result.b[i] = __builtin_sqrtf(x.b[i]);
    return result;
}
// Each lane gets the next one's value, the last its own.
FLG_INLINE Floats from_next(const Floats& x) {
    return {__builtin_shufflevector(x.a, x.a, FLG_SHUFFLE(1, 2, 3, 4, 5, 6, 7, 7)),
            __builtin_shufflevector(x.b, x.b, FLG_SHUFFLE(1, 2, 3, 4, 5, 6, 7, 7))};
}
// And from the one before, the first the last's: there no triangle is.
FLG_INLINE Floats from_previous(const Floats& x) {
    return {__builtin_shufflevector(x.a, x.a, FLG_SHUFFLE(7, 0, 1, 2, 3, 4, 5, 6)),
            __builtin_shufflevector(x.b, x.b, FLG_SHUFFLE(7, 0, 1, 2, 3, 4, 5, 6))};
}
FLG_INLINE Masks from_previous(const Masks& x) {
    return {__builtin_shufflevector(x.a, x.a, FLG_SHUFFLE(7, 0, 1, 2, 3, 4, 5, 6)),
            __builtin_shufflevector(x.b, x.b, FLG_SHUFFLE(7, 0, 1, 2, 3, 4, 5, 6))};
}
FLG_INLINE uint32_t bits(const Bits& lanes) {
#ifdef FLG_MASK
    return FLG_MASK(lanes);
#else
    uint32_t bits = 0;
    for (uint32_t i = 0; i < register_lanes; ++i) bits |= static_cast<uint32_t>(lanes[i] & 1) << i;
    return bits;
#endif
}
FLG_INLINE uint32_t bits(const Masks& mask) {
    return bits(mask.a) | bits(mask.b) << register_lanes;
}

FLG_INLINE Register joined(Float8 first, [[maybe_unused]] Float8 second) {
#if FLG_VERTICES == 2
    return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#else
    return first;
#endif
}
// A column of the vertices' blocks.
template <class T>
FLG_INLINE Floats load(const WaveVertex* const* vertices, T column) {
    const auto at = [&](uint32_t i) __attribute__((always_inline))->const Float8& {
        return *reinterpret_cast<const Float8*>(&(vertices[i]->block->*column));
    };
    constexpr uint32_t step = FLG_VERTICES;
    return {joined(at(0), at(step - 1)), joined(at(step), at(2 * step - 1))};
}
// A value of their states, in all lanes of each.
FLG_INLINE Floats load(const WaveVertex* const* vertices, float WaveState::*value) {
    const auto filled = [&](const WaveVertex& first, [[maybe_unused]] const WaveVertex& second)
        __attribute__((always_inline)) {
        const float x = first.state.*value;
        [[maybe_unused]] const float y = second.state.*value;
        return Register FLG_LANES_OF(x, y);
    };
    constexpr uint32_t step = FLG_VERTICES;
    return {filled(*vertices[0], *vertices[step - 1]), filled(*vertices[step], *vertices[2 * step - 1])};
}
// The states of eight ranks as two columns. The last rank's top bit does not count.
FLG_INLINE void load_states(const WaveState* states, const GeodesicBlock& block, Float8& distances, Float8& fronts) {
    const uint32_t* ranks = reinterpret_cast<const uint32_t*>(&block.lanes);
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
    fronts = __builtin_shufflevector(pairs, more_pairs, 1, 3, 5, 7, 9, 11, 13, 15);
}

// What a triangle of that Gaussian curvature bends a front by on a way of that length. The front's radius before it is
// `part` of that behind.
FLG_INLINE Floats bend(const Floats& curvature, const Floats& way, const Floats& part, const Floats& bend_limit) {
    const Floats bend = curvature * way * (lanes(1.0f) + part + part * part) * lanes(1.0f / 3);
    return clamped(bend, -bend_limit, bend_limit);
}

// What is found is written from lane `at` on.
FLG_INLINE void wave_step(const WaveVertex* const* vertices, const WaveState* states, float bend_max, bool labelled,
                          uint32_t at, WaveStep& step) {
    const Floats zero = lanes(0), one = lanes(1), half = lanes(0.5f);
    const Floats length = load(vertices, &GeodesicBlock::lengths), tangent = load(vertices, &GeodesicBlock::tangents);
    const Floats curvature = load(vertices, &GeodesicBlock::curvatures);
    const Floats distance = load(vertices, &WaveState::distance), own_front = load(vertices, &WaveState::front);
    const Floats bend_limit = lanes(bend_max), hollowest = lanes(-max_hollow * bend_max);
    const Floats sharpest = one / distance + bend_limit;
    Float8 fars[4], far_fronts[4];
    for (uint32_t i = 0; i < vertices_at_a_time; ++i) load_states(states, *vertices[i]->block, fars[i], far_fronts[i]);
    constexpr uint32_t half_way = FLG_VERTICES, end = 2 * FLG_VERTICES - 1;
    const Floats far = {joined(fars[0], fars[half_way - 1]), joined(fars[half_way], fars[end])};
    const Floats far_front = {joined(far_fronts[0], far_fronts[half_way - 1]),
                              joined(far_fronts[half_way], far_fronts[end])};

    // What does not depend on distances; the step's speed is that of its longest chain of operations.
    const Floats square = tangent * tangent;
    const Floats inverse_both = one / (length * (one + square));
    const Floats inverse_length = (one + square) * inverse_both, inverse_secant = length * inverse_both;
    const Floats cos_theta = (one - square) * inverse_secant;
    const Floats sin_theta = (tangent + tangent) * inverse_secant;

    // In each triangle, across the edge to its nearer corner, the base, to the one that is further, the target.
    const Floats next_length = from_next(length), next_far = from_next(far);
    const Masks forth = far < next_far;
    const Floats base = choose(forth, length, next_length), target = choose(forth, next_length, length);
    const Floats inverse_base = choose(forth, inverse_length, from_next(inverse_length));
    const Floats base_distance = least(far, next_far);
    const Floats base_front = choose(forth, far_front, from_next(far_front));
    const Floats target_height = target * sin_theta, target_way = target * cos_theta;

    // The front at the base when it was at the vertex; then both as one. No circle passes so near to both ends that the
    // cosine is above 1: next to a line that is the source.
    const Floats ahead_by = distance - base_distance;
    const Floats moved_front = clamped(base_front / (one + base_front * ahead_by), hollowest, sharpest);
    const Floats trust = distance / greatest(distance + base_distance, lanes(1e-30f));
    const Floats own_part = own_front - trust * own_front;
    const Floats front = own_part + trust * moved_front;
    const Floats slope = ahead_by * inverse_base;
    const Floats bow = half * base * (one - slope * slope);
    const Floats quotient = (slope + bow * own_part) + (bow * trust) * moved_front;
    const Floats cos_phi = clamped(quotient, -one, one);
    const Floats sin_phi = root(greatest((one - quotient) * (one + quotient), zero));
    const Floats cosine = cos_phi * target_way - sin_phi * target_height;  // times the target's length
    const Floats sine = sin_phi * target_way + cos_phi * target_height;

    // Over the front's radius: heights above the edge, of the source, on its other side, and of the target.
    const Floats inverse_height = one / (sin_phi + front * target_height);
    const Floats crossing = sine * inverse_height, rest = base - crossing;
    const Floats excess = front * target * target - (cosine + cosine);
    const Floats ratio = root(greatest(one + front * excess, zero));
    const Floats on = excess / (one + ratio);
    const Floats reached = greatest(distance + on, least(distance, base_distance));
    const Masks crosses = (sin_theta > zero) & (quotient < lanes(1.001f)) & (sine >= zero) & (crossing >= zero) &
                          (rest >= zero) & (reached < lanes(huge));
    const Floats across = choose(crosses, reached, lanes(huge));
    const Floats less_hollow = lanes(hollow_ratio) * greatest(own_front, moved_front);
    const Floats crossing_front = greatest((rest * own_front + crossing * moved_front) * inverse_base,
                                           least(less_hollow, lanes(-hollow_share * bend_max)));
    const Floats crossing_bend =
        bend(curvature, ratio * target_height * inverse_height, sin_phi * inverse_height, bend_limit);

    // To lane l + 1 from triangle l, to lane l from it or along the edge.
    const Floats ahead = from_previous(choose(forth, across, lanes(huge)));
    const Floats back = choose(forth, lanes(huge), across);
    const Floats along = distance + length;
    const Masks takes_back = back < ahead;
    const Floats best_across = least(back, ahead);
    const Masks takes_edge = ~(best_across <= along * lanes(1 + min_improvement));
    const Floats best = least(best_across, along);

    // The front on the way that is taken, from the edge that it crosses or from the vertex.
    const Floats leaving_front = choose(distance > zero, own_front, lanes(sharpest_front));
    const auto taken = [&](const Floats& by_edge, const Floats& across_edge) __attribute__((always_inline)) {
        return choose(takes_edge, by_edge, choose(takes_back, across_edge, from_previous(across_edge)));
    };
    const Floats way = taken(length, on), before = taken(leaving_front, crossing_front);
    const Floats part = one / (one + before * way);
    const Floats bent = taken(bend(curvature, length, part, bend_limit), crossing_bend);
    const Floats best_front = clamped(before * part - bent, hollowest, bend_limit + one / best);

    if (labelled) {
        const Masks beyond = crossing > rest;
        const Masks side = ~takes_edge & ((takes_back & -beyond) | (~takes_back & from_previous(beyond)));
        __builtin_memcpy(step.sides + at, &side, sizeof side);
    }
    const Masks improves = best < far * lanes(1 - min_improvement);
    step.improved |= bits(improves) << at;
    step.across_next |= bits(improves & takes_back & ~takes_edge) << at;
    step.across_previous |= bits(improves & ~(takes_back | takes_edge)) << at;
    __builtin_memcpy(step.distances + at, &best, sizeof best);
    __builtin_memcpy(step.fronts + at, &best_front, sizeof best_front);
}

// Where there are fewer vertices than registers have room for, the last one takes the place of others.
FLG_INLINE void wave_steps(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max,
                           bool labelled, WaveStep& step) {
    step.improved = step.across_next = step.across_previous = 0;
    for (uint32_t i = 0; i < count; i += vertices_at_a_time) {
        const WaveVertex* some[vertices_at_a_time];
        for (uint32_t k = 0; k < vertices_at_a_time; ++k) some[k] = &vertices[i + k < count ? i + k : count - 1];
        wave_step(some, states, bend_max, labelled, i * lane_count, step);
    }
    if (count < wave_step_vertices) step.improved &= (1u << count * lane_count) - 1;
}

#undef FLG_SHUFFLE
#undef FLG_INLINE
#undef FLG_LANES_OF
