// SPDX-License-Identifier: MIT
// refined_solver_step.h for whatever registers it is compiled for: refined_solver_step.cpp includes it once for each, in a
// namespace of its own. Plain types only: an inline function of some header, compiled for better machines, could come to
// be called on lesser ones.

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
[[gnu::always_inline]] inline Float8 load(const float* values) {
    return *reinterpret_cast<const Float8*>(values);
}
// The states of eight ranks as two columns. The last rank's top bit does not count.
[[gnu::always_inline]] inline void load_states(const WaveState* states, const uint32_t* ranks, Float8& distances,
                                               Float8& bends) {
    for (int i = 0; i < 8; ++i) {
        const WaveState& state = states[i == 7 ? ranks[i] & ~block_continues : ranks[i]];
        distances[i] = state.distance;
        bends[i] = state.bend;
    }
}
[[gnu::always_inline]] inline void store_states(Float8 distances, Float8 bends, WaveState* states) {
    const Float8 low = __builtin_shufflevector(distances, bends, 0, 8, 1, 9, 2, 10, 3, 11);
    const Float8 high = __builtin_shufflevector(distances, bends, 4, 12, 5, 13, 6, 14, 7, 15);
    __builtin_memcpy(states, &low, sizeof low);
    __builtin_memcpy(states + 4, &high, sizeof high);
}
[[gnu::always_inline]] inline uint32_t mask(Int8 lanes) {
    uint32_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= static_cast<uint32_t>(lanes[i] & 1) << i;
    return bits;
}
// Each lane gets the next one's value, the last its own.
template <class Lanes>
[[gnu::always_inline]] inline Lanes from_next(Lanes a) {
    return __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 7);
}
template <class Lanes>
[[gnu::always_inline]] inline Lanes from_previous(Lanes a) {
    return __builtin_shufflevector(a, a, 0, 0, 1, 2, 3, 4, 5, 6);
}

[[gnu::always_inline]] inline Float8 clamped(Float8 a, Float8 low, Float8 high) {
    return least(greatest(a, low), high);
}

// What is known along the edge from the vertex to a neighbour.
struct WaveEdge {
    Float8 length, inverse_length;  // length: -1 if nothing crosses
    Float8 cosine, sine;  // of phi
    Float8 own_bend, far_bend;
    Float8 least_end;  // the lesser distance of its ends
    Int8 late;         // the far end is reached along the edge
};

struct Triangle {
    Float8 cosine, sine;  // of theta; the sine is 0 where there is none
    Float8 curvature;
};

struct Arrival {
    Float8 distance;  // huge where the way does not cross the edge
    Float8 bend;
    Int8 beyond;  // it crosses nearer to the far end
};

// The way to the triangle's third corner, `length` from the vertex, across `edge`.
[[gnu::always_inline]] inline Arrival cross(const WaveEdge& edge, const Triangle& triangle, Float8 distance,
                                            Float8 length) {
    const Float8 zero = {}, one = FLG_LANES(1.0f), half = FLG_LANES(0.5f);
    const Float8 cosine = edge.cosine * triangle.cosine - edge.sine * triangle.sine;
    const Float8 sine = edge.sine * triangle.cosine + edge.cosine * triangle.sine;
    // Heights above the edge: of the source, on its other side, and of the corner.
    const Float8 source_height = distance * edge.sine;
    const Float8 inverse_height = one / (source_height + length * triangle.sine);
    const Float8 crossing = distance * length * sine * inverse_height;
    const Float8 rest = edge.length - crossing;
    const Float8 square = distance * distance + length * (length - (distance + distance) * cosine);
    const Float8 straight = root(greatest(square, zero));

    const Float8 bend = (rest * edge.own_bend + crossing * edge.far_bend) * edge.inverse_length;
    const Float8 parabola = half * bend * (edge.sine * edge.sine) * crossing * rest;
    const Float8 parabola_max = FLG_LANES(0.25f) * least(crossing, rest);
    const Float8 reached = greatest(straight - clamped(parabola, -parabola_max, parabola_max), edge.least_end);

    const Float8 part = source_height * inverse_height;  // of the way is behind at the crossing
    const Float8 on = straight * (one - part);
    const Float8 turned = clamped(bend * on * part, -half, half);
    const Float8 carried = bend * part * part * (one - turned + turned * turned);
    const Float8 gained = triangle.curvature * on * (one + part + part * part) * FLG_LANES(1.0f / 3);

    const Int8 crosses =
        (triangle.sine > zero) & (sine >= zero) & (rest >= zero) & (reached < FLG_LANES(huge));
    return {crosses ? reached : FLG_LANES(huge), carried - gained, (crossing > rest) & ~edge.late};
}

[[gnu::always_inline]] inline void wave_step(const GeodesicBlock& block, const WaveState* states, const WaveState& own,
                                             float bend_max, WaveStep& step) {
    const Float8 zero = {}, one = FLG_LANES(1.0f), half = FLG_LANES(0.5f);
    const Float8 length = load(block.lengths.data()), tangent = load(block.tangents.data());
    const Float8 curvature = load(block.curvatures.data());
    const Float8 distance = FLG_LANES(own.distance), own_bend = FLG_LANES(own.bend);
    const Float8 bend_limit = FLG_LANES(bend_max);

    // Along the edges.
    const Float8 inverse_length = one / length;
    const Float8 along = distance + length;
    const Float8 part = distance / along;
    const Float8 turned = clamped(own_bend * length * part, -half, half);
    const Float8 along_bend = own_bend * part * part * (one - turned + turned * turned) -
                              curvature * length * (one + part + part * part) * FLG_LANES(1.0f / 3);

    // The wave at the far ends. Neighbours that it has reached late or not at all are reached along the edge.
    Float8 far_distance, far_bend;
    load_states(states, block.lanes.data(), far_distance, far_bend);
    const Float8 improvable = far_distance * (1 - least_improvement);
    const Int8 late = along < far_distance;
    const Float8 far = late ? along : far_distance;

    WaveEdge edge;
    edge.inverse_length = inverse_length;
    const Float8 cosine = (length * length + (distance - far) * (distance + far)) * inverse_length *
                          FLG_LANES(0.5f / own.distance);
    edge.cosine = clamped(cosine, -one, one);
    edge.sine = root((one - edge.cosine) * (one + edge.cosine));
    edge.own_bend = own_bend;
    edge.far_bend = late ? along_bend : far_bend;
    // No one point is so near to both ends: next to a line that is the source. Then nothing crosses.
    edge.length = cosine < FLG_LANES(1.001f) ? length : -one;
    edge.least_end = least(distance, far);
    edge.late = late;
    const WaveEdge next = {from_next(edge.length),      from_next(inverse_length), from_next(edge.cosine),
                           from_next(edge.sine),   own_bend,                  from_next(edge.far_bend),
                           from_next(edge.least_end), from_next(late)};

    // From lane l across edge l to lane l + 1, and from lane l + 1 across edge l + 1 to lane l. At the source no angle is
    // known, and none needed.
    const Float8 inverse_secant = one / (one + tangent * tangent);
    Triangle triangle;
    triangle.cosine = (one - tangent * tangent) * inverse_secant;
    triangle.sine = own.distance > 0 ? (tangent + tangent) * inverse_secant : zero;
    triangle.curvature = curvature;
    Arrival ahead = cross(edge, triangle, distance, from_next(length));
    const Arrival back = cross(next, triangle, distance, length);
    ahead.distance = from_previous(ahead.distance);
    ahead.distance[0] = huge;
    ahead.bend = from_previous(ahead.bend);

    const Int8 takes_back = back.distance < ahead.distance;
    const Float8 across = takes_back ? back.distance : ahead.distance;
    const Int8 takes_edge = ~(across < along);
    const Float8 best = takes_edge ? along : across;
    const Float8 bend = clamped(takes_edge ? along_bend : takes_back ? back.bend : ahead.bend, -bend_limit, bend_limit);
    const Int8 forth = {1, 1, 1, 1, 1, 1, 1, 1};
    const Int8 side = takes_edge ? Int8{} : takes_back ? (back.beyond & forth) : (from_previous(ahead.beyond) & -forth);
    __builtin_memcpy(step.sides, &side, sizeof side);
    step.improved = mask(best < improvable);
    store_states(best, bend, step.states);
}

#undef FLG_LANES
