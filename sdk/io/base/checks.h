// SPDX-License-Identifier: MIT
// What many of a host's arrays are checked for. All fail with FLG_ERROR_INVALID_ARGUMENT.
#pragma once

#include <cmath>
#include <cstring>

#include "io/base/entry_point.h"
#include "io/base/json_text.h"
#include "io/base/limits.h"

namespace flg::io {

inline String element_of(const String& array, size_t index) {
    return array + "[" + to_text(index) + "]";
}

inline void check_floats(const float* values, size_t count, const String& name) {
    check_argument(values, name.c_str());
    for (size_t i = 0; i < count; ++i) {
        if (std::abs(values[i]) <= max_coordinate) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(name, i), "is %g, must be finite and at most 1e30 in size",
             double{values[i]});
    }
}

// Null is none.
inline void check_name(const char* name, const String& place) {
    constexpr size_t max_name = 255;
    if (!name || (strnlen(name, max_name + 1) <= max_name && is_utf8(name))) return;
    fail(FLG_ERROR_INVALID_ARGUMENT, place, "must be UTF-8 of at most 255 bytes");
}

// Keys of animations.
inline void check_times(const float* times, size_t count, const String& name) {
    check_floats(times, count, name);
    float before = -1;
    for (size_t key = 0; key < count; ++key) {
        if (!(times[key] >= 0 && times[key] > before)) {
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of(name, key), "is %g after %g; times rise from 0 or later",
                 double{times[key]}, double{before});
        }
        before = times[key];
    }
}

}  // namespace flg::io
