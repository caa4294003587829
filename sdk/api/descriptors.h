// SPDX-License-Identifier: MIT
// Sized structs at the ABI: the host's struct may be smaller than ours (an older header); what it lacks takes its
// default.
#pragma once

#include <algorithm>
#include <cstring>

#include "core/failure.h"

namespace flg {

// The size a struct had in its first release; smaller is not a size that any host can have. Structs that grow later get
// a specialization here.
template <class T>
inline constexpr uint32_t first_size = sizeof(T);

template <class T>
void check_struct_size(uint32_t struct_size, const char* name) {
    if (struct_size < first_size<T> || struct_size > sizeof(T)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "%s: struct_size is %u, must be %u to %zu; take the struct from its defaults function", name,
                      struct_size, first_size<T>, sizeof(T));
    }
}

template <class T>
T read_struct(const T* in, const T& defaults, const char* name) {
    if (!in) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is null", name);
    check_struct_size<T>(in->struct_size, name);
    T value = defaults;
    std::memcpy(static_cast<void*>(&value), in, in->struct_size);
    return value;
}

// Fills the host's struct with `value`, as far as it reaches.
template <class T>
void write_struct(T* out, const T& value, const char* name) {
    if (!out) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is null", name);
    const uint32_t struct_size = out->struct_size;
    check_struct_size<T>(struct_size, name);
    std::memcpy(static_cast<void*>(out), &value, struct_size);
    out->struct_size = struct_size;
}

// The host's defaults. Its struct may be larger than ours, of a newer header: the rest becomes zero, and
// flgContextCreate tells the host that the versions do not fit.
template <class T>
void init_struct(T* out, uint32_t struct_size, const T& defaults, const char* name) {
    if (!out) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is null", name);
    if (struct_size < first_size<T>) check_struct_size<T>(struct_size, name);
    std::memset(static_cast<void*>(out), 0, struct_size);
    std::memcpy(static_cast<void*>(out), &defaults, std::min<size_t>(struct_size, sizeof(T)));
    out->struct_size = struct_size;
}

template <class T>
T& require(T* pointer, const char* name) {
    if (!pointer) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is null", name);
    return *pointer;
}

}  // namespace flg
