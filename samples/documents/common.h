// SPDX-License-Identifier: MIT
// Options of all commands.
#pragma once

#include <cstdint>
#include <string>

#include "filigree/filigree.h"

namespace flg::cli {

struct CommonOptions {
    std::string report;
    uint64_t seed = 1;
    uint32_t workers = 0;    // set from the machine's cores by main
    uint32_t budget_us = 0;  // 0: to the end
    bool quiet = false;

    // A tick's, as the SDK counts it.
    uint32_t tick_budget_us() const { return budget_us == 0 ? FLG_UNLIMITED : budget_us; }
};

}  // namespace flg::cli
