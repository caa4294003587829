// SPDX-License-Identifier: MIT
#include "io/base/entry_point.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "filigree/filigree_io.h"

namespace flg::io {

namespace {

constexpr const char* out_of_memory = "no memory is left";

// Long enough for the longest path that Linux knows, and a sentence.
thread_local char last_error[4096 + 1024] = "no error";

FlgResult set_last_error(FlgResult result, const char* file, const String& place, const char* reason) noexcept {
    const char* separator = *file != '\0' && !place.empty() ? ":" : "";
    std::snprintf(last_error, sizeof last_error, "%s%s%s: %s", file, separator, place.c_str(), reason);
    return result;
}

}  // namespace

FlgResult take_exception(const char* file) noexcept {
    try {
        throw;
    } catch (const Failure& failure) {
        return set_last_error(failure.result(), file, failure.place(), failure.what());
    } catch (const std::length_error&) {
        return set_last_error(FLG_ERROR_OUT_OF_MEMORY, file, {}, out_of_memory);
    } catch (const std::filesystem::filesystem_error& error) {
        try {
            return set_last_error(FLG_ERROR_FILE, file, {}, error.code().message().c_str());
        } catch (...) {
            return set_last_error(FLG_ERROR_OUT_OF_MEMORY, file, {}, out_of_memory);
        }
    } catch (...) {
        char sentence[512];
        const FlgResult result = translate_exception(sentence, sizeof sentence, out_of_memory);
        return set_last_error(result, file, {}, sentence);
    }
}

void check_argument(const void* pointer, const char* name) {
    if (!pointer) fail(FLG_ERROR_INVALID_ARGUMENT, name, "is null");
}

void check_is_glb(const Path& target) {
    const String extension = target.extension();
    if (extension != ".glb") fail(FLG_ERROR_FORMAT, "", "can't be written: %s is not .glb", cited(extension).c_str());
}

CheckedHooks::CheckedHooks(const FlgFileHooks* given, bool writes) {
    if (!given) return;
    const FlgFileHooks hooks = read_given(given, "hooks");
    if (hooks.files) {
        files = read_given(hooks.files, "hooks.files");
        has_files = true;
        check_argument(reinterpret_cast<const void*>(files.open), "hooks.files.open");
        check_argument(reinterpret_cast<const void*>(files.size), "hooks.files.size");
        check_argument(reinterpret_cast<const void*>(files.read), "hooks.files.read");
        check_argument(reinterpret_cast<const void*>(files.close), "hooks.files.close");
        if (writes) check_argument(reinterpret_cast<const void*>(files.write), "hooks.files.write");
    }
    if (!hooks.allocator) return;
    const FlgAllocator given_allocator = read_given(hooks.allocator, "hooks.allocator");
    if (!given_allocator.allocate != !given_allocator.free) {
        fail(FLG_ERROR_INVALID_ARGUMENT, given_allocator.allocate ? "hooks.allocator.free" : "hooks.allocator.allocate",
             "is null, but the other function is not");
    }
    allocator = given_allocator;
}

}  // namespace flg::io

extern "C" {

const char* flgIoErrorGetMessage(void) {
    return flg::io::last_error;
}

FlgResult flgFileSystemInit(FlgFileSystem* files, uint32_t struct_size) {
    return flg::io::init("flgFileSystemInit", files, struct_size, flg::sized<FlgFileSystem>(), "files");
}

FlgResult flgFileHooksInit(FlgFileHooks* hooks, uint32_t struct_size) {
    return flg::io::init("flgFileHooksInit", hooks, struct_size, flg::sized<FlgFileHooks>(), "hooks");
}

}  // extern "C"
