// SPDX-License-Identifier: MIT
// What all commands share: their options, and how one is added to the program.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

namespace flg::cli {

struct CommonOptions {
    std::string report;
    uint64_t seed = 1;
    uint32_t workers = 0;  // set from the machine's cores by main
    uint32_t budget_us = 0;
    bool quiet = false;
};

struct Command {
    CLI::App* app;
    std::function<void()> run;  // throws InputError, UsageError
};

Command add_info(CLI::App& program, const CommonOptions& common);
Command add_stylize(CLI::App& program, const CommonOptions& common);
Command add_bench(CLI::App& program, const CommonOptions& common);
#if defined(FLG_WITH_RENDERER)
Command add_render(CLI::App& program, const CommonOptions& common);
#endif

}  // namespace flg::cli
