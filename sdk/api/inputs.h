// SPDX-License-Identifier: MIT
// Checks that descriptors share; the sentences name argument, value and rule.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "core/failure.h"
#include "core/number_text.h"
#include "core/origin.h"

namespace flg {

inline void check_range(bool holds, const char* argument, double value, const char* rule) {
    if (holds) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %s, must be %s", argument, NumberText(value).c_str(), rule);
}

// The number a host wrote into an enum, which may be none of its values (reading that as the enum would be undefined).
template <class Enum>
int32_t number_of(const Enum& value) {
    static_assert(sizeof(Enum) == sizeof(int32_t));
    int32_t number;
    std::memcpy(&number, &value, sizeof number);
    return number;
}

template <class Enum>
void check_enum(const Enum& value, Enum first, Enum last, const char* argument, const char* prefix) {
    const int32_t number = number_of(value);
    if (number < static_cast<int32_t>(first) || number > static_cast<int32_t>(last)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %d, must be one of %s...", argument, number, prefix);
    }
}

// Whether a number may be a coordinate, or a factor on some.
inline bool is_coordinate(float value) {
    return std::abs(value) <= 1e30f;
}

// The place that a host counts coordinates from.
inline Origin read_origin(const double (&origin)[3], const char* argument) {
    Origin read;
    for (uint32_t c = 0; c < 3; ++c) {
        if (!(std::abs(origin[c]) <= 1e30)) {
            char name[64];
            std::snprintf(name, sizeof name, "%s[%u]", argument, c);
            check_range(false, name, origin[c], "finite and at most 1e30 in size");
        }
        read[c] = origin[c];
    }
    return read;
}

// Of what has so many coordinates.
inline Origin read_origin_in(uint32_t ambient, const double (&origin)[3], const char* argument) {
    const Origin read = read_origin(origin, argument);
    for (const double coordinate : read) {
        check_range(ambient == 3 || coordinate == 0, argument, coordinate, "0 unless in R^3");
    }
    return read;
}

inline void check_frame(const FlgFrameMethod& method, const char* argument) {
    check_enum(method, FLG_FRAME_METHOD_ROTATION_MINIMIZING, FLG_FRAME_METHOD_SUPPLIED, argument, "FLG_FRAME_METHOD_");
}

// desc.basis of any numbers up to 1e30.
inline void check_basis(const float (&basis)[9]) {
    for (int i = 0; i < 9; ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "desc.basis[%d]", i);
        check_range(is_coordinate(basis[i]), name, basis[i], "finite and at most 1e30 in size");
    }
}

}  // namespace flg
