// SPDX-License-Identifier: MIT
// How a command is added to the program. (Apart from common.h because CLI11 takes seconds to compile.)
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "documents/common.h"

namespace flg::cli {

struct Command {
    CLI::App* app;
    std::function<void()> run;  // throws InputError, UsageError
};

Command add_info(CLI::App& program, const CommonOptions& common);
Command add_stylize(CLI::App& program, const CommonOptions& common);
Command add_styles(CLI::App& program, const CommonOptions& common);
Command add_replay(CLI::App& program, const CommonOptions& common);
std::vector<Command> add_mesh(CLI::App& program, const CommonOptions& common);
Command add_geodesic(CLI::App& program, const CommonOptions& common);
Command add_motion(CLI::App& program, const CommonOptions& common);
Command add_path(CLI::App& program, const CommonOptions& common);
Command add_spline(CLI::App& program, const CommonOptions& common);
Command add_contour(CLI::App& program, const CommonOptions& common);
Command add_skeleton(CLI::App& program, const CommonOptions& common);
Command add_straight_skeleton(CLI::App& program, const CommonOptions& common);
Command add_tangle(CLI::App& program, const CommonOptions& common);
Command add_bench(CLI::App& program, const CommonOptions& common);
#if defined(FLG_WITH_RENDERER)
Command add_render(CLI::App& program, const CommonOptions& common);
Command add_panels(CLI::App& program, const CommonOptions& common);
#endif

}  // namespace flg::cli
