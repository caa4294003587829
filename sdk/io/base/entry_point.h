// SPDX-License-Identifier: MIT
// What all functions of the C ABI here share: failures become results and sentences, arguments are checked, structs are
// handed out as far as the host knows them. Memory is the C++ runtime's: there is no context here.
#pragma once

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>

#include "io/base/failure.h"

namespace flg::io {

// Takes the exception that is being handled to flgIoLastError, with `file` before it; returns its result.
FlgResult take_exception(const char* file) noexcept;

// Runs an entry point's body; `file` is what the sentence of a failure starts with.
template <class Body>
FlgResult guarded(const char* file, Body&& body) noexcept {
    try {
        body();
        return FLG_OK;
    } catch (...) {
        return take_exception(file);
    }
}

void check_argument(const void* pointer, const char* name);

// Fills a host's struct as far as the host knows it. All structs so far have their first version's size.
template <class Struct>
void hand_out(Struct value, Struct* out, uint32_t struct_size) {
    value.struct_size = struct_size;
    std::memcpy(out, &value, std::min<size_t>(struct_size, sizeof value));
}

template <class Struct>
void check_size(uint32_t struct_size, const char* name) {
    if (struct_size < sizeof(Struct)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, name, "has the struct_size %u, must be at least %zu", struct_size,
             sizeof(Struct));
    }
}

// Checks a struct that the host wants filled, and clears it; returns its struct_size.
template <class Struct>
uint32_t open_out(Struct* out, const char* name) {
    check_argument(out, name);
    const uint32_t struct_size = out->struct_size;
    check_size<Struct>(struct_size, name);
    hand_out(Struct{}, out, struct_size);
    return struct_size;
}

std::filesystem::path to_path(const char* utf8);

// In lower case, with its dot.
std::string extension_of(const std::filesystem::path& path);

}  // namespace flg::io
