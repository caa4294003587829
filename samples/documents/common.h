// SPDX-License-Identifier: MIT
// Options of all commands.
#pragma once

#include <cstdint>
#include <string>

namespace flg::cli {

struct CommonOptions {
    std::string report;
    uint64_t seed = 1;
    uint32_t workers = 0;  // set from the machine's cores by main
    uint32_t budget_us = 0;
    bool quiet = false;
};

}  // namespace flg::cli
