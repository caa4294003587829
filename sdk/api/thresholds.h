// SPDX-License-Identifier: MIT
// How fine bones are, as hosts say it.
#pragma once

#include <cstdio>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "filigree/filigree_model.h"

namespace flg {

inline FlgBoneThresholds default_thresholds() {
    return {.struct_size = sizeof(FlgBoneThresholds),
            .simplify = 0.01f,
            .merge = 0.03f,
            .prune = 0.03f,
            .collapse = 0.01f,
            .detail = 1};
}

// Those without a struct of their own take `others`.
inline FlgBoneThresholds read_thresholds(const FlgBoneThresholds* thresholds, const FlgBoneThresholds& others,
                                         const char* argument) {
    if (!thresholds) return others;
    const FlgBoneThresholds read = read_struct(thresholds, default_thresholds(), argument);
    const auto check = [&](float value, const char* name) {
        char field[96];
        std::snprintf(field, sizeof field, "%s.%s", argument, name);
        check_range(value >= 0 && value <= 10, field, value, "0 to 10");
    };
    check(read.simplify, "simplify");
    check(read.merge, "merge");
    check(read.prune, "prune");
    check(read.collapse, "collapse");
    char field[96];
    std::snprintf(field, sizeof field, "%s.detail", argument);
    check_range(read.detail == 0 || (read.detail >= 0.05f && read.detail <= 20), field, read.detail,
                "0, or 0.05 to 20");
    return read;
}

}  // namespace flg
