// SPDX-License-Identifier: MIT
#include "api/error.h"

#include <cstdio>

namespace flg {

namespace {

thread_local char last_error[512] = "no error";

}  // namespace

FlgResult set_last_error(FlgResult result, const char* message) noexcept {
    std::snprintf(last_error, sizeof last_error, "%s", message);
    return result;
}

FlgResult translate_exception() noexcept {
    return translate_exception(last_error, sizeof last_error, "the allocator returned null");
}

}  // namespace flg

extern "C" {

const char* flgErrorGetMessage(void) {
    return flg::last_error;
}

uint32_t flgVersionGet(void) {
    return FLG_VERSION;
}

const char* flgResultGetName(FlgResult result) {
    switch (result) {
        case FLG_OK: return "FLG_OK";
        case FLG_NOT_READY: return "FLG_NOT_READY";
        case FLG_ERROR_INVALID_ARGUMENT: return "FLG_ERROR_INVALID_ARGUMENT";
        case FLG_ERROR_INVALID_HANDLE: return "FLG_ERROR_INVALID_HANDLE";
        case FLG_ERROR_OUT_OF_MEMORY: return "FLG_ERROR_OUT_OF_MEMORY";
        case FLG_ERROR_VERSION: return "FLG_ERROR_VERSION";
        case FLG_ERROR_CANCELLED: return "FLG_ERROR_CANCELLED";
        case FLG_ERROR_DEPENDENCY: return "FLG_ERROR_DEPENDENCY";
        case FLG_ERROR_FILE: return "FLG_ERROR_FILE";
        case FLG_ERROR_FORMAT: return "FLG_ERROR_FORMAT";
        case FLG_ERROR_LIMIT: return "FLG_ERROR_LIMIT";
        case FLG_ERROR_INTERNAL: return "FLG_ERROR_INTERNAL";
        case FLG_RESULT_FORCE_32BIT: break;
    }
    return "FLG_RESULT_UNKNOWN";
}

}  // extern "C"
