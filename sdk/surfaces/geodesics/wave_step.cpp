// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/wave_step.h"

// Vectors are passed only between functions that are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace flg {

#define FLG_VERTICES 1

namespace portable {
#include "surfaces/geodesics/wave_step.inl"
}  // namespace portable

void wave_step_portable(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max,
                        bool labelled, WaveStep& step) {
    portable::wave_steps(vertices, count, states, bend_max, labelled, step);
}

#ifdef FLG_WAVE_STEP_DISPATCH

#define FLG_MASK(lanes) static_cast<uint32_t>(__builtin_ia32_movmskps256(reinterpret_cast<Float8>(lanes)))

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

namespace avx2 {
#include "surfaces/geodesics/wave_step.inl"
}  // namespace avx2

void wave_step_avx2(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max, bool labelled,
                    WaveStep& step) {
    avx2::wave_steps(vertices, count, states, bend_max, labelled, step);
}

#ifdef __clang__
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx2,avx512f,avx512vl,avx512dq,avx512bw"))), apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx2,avx512f,avx512vl,avx512dq,avx512bw")
#endif

#undef FLG_VERTICES
#undef FLG_MASK
#define FLG_VERTICES 2
#define FLG_MASK(lanes) static_cast<uint32_t>(__builtin_ia32_cvtd2mask512(lanes))

namespace avx512 {
#include "surfaces/geodesics/wave_step.inl"
}  // namespace avx512

void wave_step_avx512(const WaveVertex* vertices, uint32_t count, const WaveState* states, float bend_max,
                      bool labelled, WaveStep& step) {
    avx512::wave_steps(vertices, count, states, bend_max, labelled, step);
}

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

WaveStepFunction choose_wave_step() {
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw")) {
        return wave_step_avx512;
    }
    return __builtin_cpu_supports("avx2") ? wave_step_avx2 : wave_step_portable;
}

#else

WaveStepFunction choose_wave_step() {
    return wave_step_portable;
}

#endif

}  // namespace flg
