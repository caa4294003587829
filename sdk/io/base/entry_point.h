// SPDX-License-Identifier: MIT
// What all functions of the C ABI here share: failures become results and sentences, arguments are checked, structs are
// handed out as far as the host knows them. Memory is the C++ runtime's: there is no context here.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/guard.h"
#include "core/sized_struct.h"
#include "io/base/failure.h"

namespace flg::io {

void check_argument(const void* pointer, const char* name);

// A host's struct, as far as we know it.
template <class T>
T read_given(const T* given, const char* name) {
    check_argument(given, name);
    return read_struct<Longer::cut>(given, sized<T>(), name);
}

// Takes the exception that is being handled to flgIoErrorGetMessage, with `file` before it; returns its result.
FlgResult take_exception(const char* file) noexcept;

// Runs an entry point's body; `file` is what the sentence of a failure starts with.
template <class Body>
FlgResult guarded(const char* file, Body&& body) noexcept {
    return flg::guarded(std::forward<Body>(body), [&] { return take_exception(file); });
}

std::filesystem::path to_path(const char* utf8);

// In lower case, with its dot.
std::string extension_of(const std::filesystem::path& path);

// Refuses to write any other format, for writers that know one.
void check_is_glb(const std::filesystem::path& target);

// Likewise an entry point's body that takes the path of a file.
template <class Body>
FlgResult guarded_path(const char* function, const char* path, Body&& body) noexcept {
    return guarded(path ? path : function, [&] {
        check_argument(path, "path");
        body(to_path(path));
    });
}

// The whole of an entry point that reads a file: `read` takes its path and makes what the host gets, or null.
template <class File, class Read>
FlgResult read_into(File** out_file, const char* function, const char* path, Read read) noexcept {
    if (out_file) *out_file = nullptr;
    return guarded_path(function, path, [&](const std::filesystem::path& source) {
        check_argument(out_file, "out_file");
        std::unique_ptr<File> file = read(source);
        *out_file = file.release();
    });
}

// The whole of an entry point that fills a struct with its defaults.
template <class T>
FlgResult init(const char* function, T* out, uint32_t struct_size, const T& defaults, const char* name = "desc") {
    return guarded(function, [&] { init_struct(out, struct_size, defaults, name); });
}

// The whole of an entry point that shows something of a file: `describe` takes the file.
template <class File, class Out, class Describe>
FlgResult show(const char* function, File* file, Out* out, const char* name, Describe describe) {
    return guarded(function, [&] {
        write_struct<Longer::cut>(out, sized<Out>(), name);
        check_argument(file, "file");
        write_struct<Longer::cut>(out, describe(*file), name);
    });
}

// The whole of an entry point that shows a list that a file keeps, null if it is empty; `list` is a member of the
// file, or takes the file.
template <class File, class List, class Item>
FlgResult show_list(const char* function, File* file, List list, const Item** out_items, const char* name,
                    uint32_t* out_count) {
    if (out_items) *out_items = nullptr;
    if (out_count) *out_count = 0;
    return guarded(function, [&] {
        check_argument(file, "file");
        check_argument(out_items, name);
        check_argument(out_count, "out_count");
        const std::vector<Item>& items = std::invoke(list, *file);
        if (items.empty()) return;
        *out_items = items.data();
        *out_count = static_cast<uint32_t>(items.size());
    });
}

}  // namespace flg::io
