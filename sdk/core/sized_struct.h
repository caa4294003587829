// SPDX-License-Identifier: MIT
// Sized structs at the ABIs: the host's struct may be shorter than ours (an older header); what it lacks takes its
// default.
#pragma once

#include <algorithm>
#include <cstring>

#include "core/failure.h"

namespace flg {

template <class T>
T& require(T* pointer, const char* name) {
    if (!pointer) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is null", name);
    return *pointer;
}

// The size a struct had in its first release; smaller is not a size that any host can have. Structs that grow later get
// a specialization.
template <class T>
inline constexpr uint32_t first_size = sizeof(T);

// What becomes of a host's struct that is longer than ours (a newer header). Libraries without a context have not
// compared versions: they cut it, and leave what is beyond ours as it is.
enum class Longer { refused, cut };

template <class T, Longer longer = Longer::refused>
void check_struct_size(uint32_t struct_size, const char* name) {
    if (longer == Longer::refused && struct_size > sizeof(T)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "%s: struct_size is %u, but this library knows %zu: the header is newer, or the size was not set",
                      name, struct_size, sizeof(T));
    }
    if (longer == Longer::refused && struct_size < first_size<T>) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "%s: struct_size is %u, must be %u to %zu; take the struct from its defaults function", name,
                      struct_size, first_size<T>, sizeof(T));
    }
    if (struct_size < first_size<T>) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: struct_size is %u, must be at least %u", name, struct_size,
                      first_size<T>);
    }
}

// All zero but its size.
template <class T>
constexpr T sized() {
    T value{};
    value.struct_size = sizeof value;
    return value;
}

// What hosts may not use yet, so that it can mean something later.
template <class T>
void check_reserved(const T& value, const char* name) {
    if constexpr (requires { value.reserved; }) {
        if (value.reserved != 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.reserved is %u, must be 0", name, value.reserved);
        }
    }
    if constexpr (requires { value.reserved2; }) {
        if (value.reserved2 != 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.reserved2 is %u, must be 0", name, value.reserved2);
        }
    }
}

template <Longer longer = Longer::refused, class T>
T read_struct(const T* in, const T& defaults, const char* name) {
    check_struct_size<T, longer>(require(in, name).struct_size, name);
    T value = defaults;
    std::memcpy(static_cast<void*>(&value), in, std::min<size_t>(in->struct_size, sizeof value));
    check_reserved(value, name);
    return value;
}

// Element `index` of a host's array, the elements of which have the size that the first one says.
template <Longer longer = Longer::refused, class T>
T read_element(const T* elements, uint32_t index, const T& defaults, const char* name) {
    const uint32_t size = elements->struct_size;
    const auto* const element =
        reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(elements) + size_t{index} * size);
    if (element->struct_size != size) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: struct_size is %u, but that of the first is %u", name,
                      element->struct_size, size);
    }
    return read_struct<longer>(element, defaults, name);
}

// Fills the host's struct with `value`, as far as it reaches.
template <Longer longer = Longer::refused, class T>
void write_struct(T* out, const T& value, const char* name) {
    const uint32_t struct_size = require(out, name).struct_size;
    check_struct_size<T, longer>(struct_size, name);
    std::memcpy(static_cast<void*>(out), &value, std::min<size_t>(struct_size, sizeof value));
    out->struct_size = struct_size;
}

// The host's defaults. Its struct may be larger than ours, of a newer header: the rest becomes zero, and
// flgContextCreate tells the host that the versions do not fit.
template <class T>
void init_struct(T* out, uint32_t struct_size, const T& defaults, const char* name) {
    require(out, name);
    check_struct_size<T, Longer::cut>(struct_size, name);
    std::memset(static_cast<void*>(out), 0, struct_size);
    std::memcpy(static_cast<void*>(out), &defaults, std::min<size_t>(struct_size, sizeof(T)));
    out->struct_size = struct_size;
}

}  // namespace flg
