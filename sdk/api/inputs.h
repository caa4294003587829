// SPDX-License-Identifier: MIT
// Checks that descriptors share; the sentences name argument, value and rule.
#pragma once

#include "core/failure.h"

namespace flg {

inline void check_range(bool holds, const char* argument, double value, const char* rule) {
    if (!holds) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %g, must be %s", argument, value, rule);
}

inline void check_frame(FlgFrameMethod method, const char* argument) {
    if (method != FLG_FRAME_ROTATION_MINIMIZING && method != FLG_FRAME_FRENET) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %d, must be one of FLG_FRAME_...", argument,
                      static_cast<int>(method));
    }
}

}  // namespace flg
