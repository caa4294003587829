// SPDX-License-Identifier: MIT
// Loops that are compiled several times, for what registers processors may have. Their arithmetic has one meaning: the
// same bits come out of all of them.
//
//     namespace portable {
//     #include "room/loops.inl"
//     }
//     #ifdef FLG_DISPATCH_VECTORS
//     FLG_BEGIN_AVX2
//     namespace avx2 {
//     #include "room/loops.inl"
//     }
//     FLG_END_AVX2
//     #endif
//     void loop(int n) { FLG_FOR_THIS_MACHINE(loop(n)); }
#pragma once

// GCC does not align its stack for vectors of 32 bytes on Windows.
#if defined(__x86_64__) && !(defined(__MINGW32__) && !defined(__clang__))
#define FLG_DISPATCH_VECTORS
#ifdef __clang__
#define FLG_BEGIN_AVX2 _Pragma("clang attribute push(__attribute__((target(\"avx2\"))), apply_to = function)")
#define FLG_END_AVX2 _Pragma("clang attribute pop")
#else
#define FLG_BEGIN_AVX2 _Pragma("GCC push_options") _Pragma("GCC target(\"avx2\")")
#define FLG_END_AVX2 _Pragma("GCC pop_options")
#endif

namespace flg {

inline bool has_avx2() {
    return __builtin_cpu_supports("avx2") != 0;
}

}  // namespace flg

#define FLG_FOR_THIS_MACHINE(call) (::flg::has_avx2() ? avx2::call : portable::call)
#else
#define FLG_FOR_THIS_MACHINE(call) portable::call
#endif
