// SPDX-License-Identifier: MIT
// What all functions of the C ABI here share: failures become results and sentences, arguments are checked, structs are
// handed out as far as the host knows them, and a call has the host's memory and files.
#pragma once

#include <cstddef>
#include <functional>

#include "core/guard.h"
#include "core/sized_struct.h"
#include "io/base/failure.h"
#include "io/base/files.h"
#include "io/base/memory.h"

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

// Refuses to write any other format, for writers that know one.
void check_is_glb(const Path& target);

// The hooks of a call, checked: memory, and the file system, null for the operating system's.
struct CheckedHooks {
    CheckedHooks(const FlgFileHooks* hooks, bool writes);
    FlgAllocator allocator = runtime_memory;
    FlgFileSystem files = {};
    bool has_files = false;
};

// Likewise an entry point's body that takes the path of a file. The hooks are those of the descriptor, if it is there
// and long enough to name any.
template <class Desc, class Body>
FlgResult guarded_path(const char* function, const char* path, const Desc* desc, bool writes, Body&& body) noexcept {
    // Outermost: the sentence of a failure is in the host's memory, too.
    FlgAllocator allocator = runtime_memory;
    const MemoryScope scope(allocator);
    return guarded(path ? path : function, [&] {
        check_argument(path, "path");
        const bool has_hooks = desc && desc->struct_size >= offsetof(Desc, hooks) + sizeof(void*);
        const CheckedHooks checked(has_hooks ? desc->hooks : nullptr, writes);
        allocator = checked.allocator;
        body(Path(path, checked.has_files ? &checked.files : nullptr));
    });
}

// The whole of an entry point that writes a file.
template <class Desc, class Body>
FlgResult write_to(const char* function, const char* path, const Desc* desc, Body&& body) noexcept {
    return guarded_path(function, path, desc, true, std::forward<Body>(body));
}

// The whole of an entry point that reads a file: `read` takes its path and makes what the host gets, or null.
template <class File, class Desc, class Read>
FlgResult read_into(File** out_file, const char* function, const char* path, const Desc* desc, Read read) noexcept {
    if (out_file) *out_file = nullptr;
    return guarded_path(function, path, desc, false, [&](const Path& source) {
        check_argument(out_file, "out_file");
        if (desc) read_given(desc, "desc");
        Owned<File> file = read(source);
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
    const MemoryScope scope(file ? file->allocator : runtime_memory);
    return guarded(function, [&] {
        write_struct<Longer::cut>(out, sized<Out>(), name);
        check_argument(file, "file");
        write_struct<Longer::cut>(out, describe(*file), name);
    });
}

// Likewise one of several that a file keeps: `list` is a member of the file, or takes the file.
template <class File, class List, class Out>
FlgResult show_one(const char* function, File* file, List list, uint32_t index, const char* index_name, Out* out,
                   const char* name) {
    return show(function, file, out, name, [&](const File& shown) -> Out {
        const auto& all = std::invoke(list, shown);
        if (index >= all.size()) {
            fail(FLG_ERROR_INVALID_ARGUMENT, index_name, "is %u, but there are %zu", index, all.size());
        }
        return all[index];
    });
}

}  // namespace flg::io
