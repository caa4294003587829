// SPDX-License-Identifier: MIT
#include "io/base/entry_point.h"

#include <cctype>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "filigree/filigree_io.h"

namespace flg::io {

namespace {

constexpr const char* out_of_memory = "no memory is left";

// Long enough for the longest path that Linux knows, and a sentence.
thread_local char last_error[4096 + 1024] = "no error";

FlgResult set_last_error(FlgResult result, const char* file, const std::string& place, const char* reason) noexcept {
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
        return set_last_error(FLG_ERROR_FILE, file, {}, error.code().message().c_str());
    } catch (...) {
        char sentence[512];
        const FlgResult result = translate_exception(sentence, sizeof sentence, out_of_memory);
        return set_last_error(result, file, {}, sentence);
    }
}

void check_argument(const void* pointer, const char* name) {
    if (!pointer) fail(FLG_ERROR_INVALID_ARGUMENT, name, "is null");
}

std::filesystem::path to_path(const char* utf8) {
    std::filesystem::path path{std::u8string(reinterpret_cast<const char8_t*>(utf8), std::strlen(utf8))};
    return path.has_filename() ? path : path.parent_path();
}

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

void check_is_glb(const std::filesystem::path& target) {
    const std::string extension = extension_of(target);
    if (extension != ".glb") fail(FLG_ERROR_FORMAT, "", "can't be written: %s is not .glb", cited(extension).c_str());
}

}  // namespace flg::io

extern "C" const char* flgIoErrorGetMessage(void) {
    return flg::io::last_error;
}
