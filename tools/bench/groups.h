// SPDX-License-Identifier: MIT
// One function a group, each in a file of its own.
#pragma once

#include "bench/bench.h"

namespace flg::bench {

std::vector<Row> run_thomas();
std::vector<Row> run_prepare();
std::vector<Row> run_patch_graph();
std::vector<Row> run_ticks();
std::vector<Row> run_live();
std::vector<Row> run_live_style();
std::vector<Row> run_growth();
std::vector<Row> run_analogies();
std::vector<Row> run_hair();
std::vector<Row> run_ribbon();
std::vector<Row> run_brush_meshes();
std::vector<Row> run_buffers();
std::vector<Row> run_simplify();
std::vector<Row> run_cutting();
std::vector<Row> run_inflation();
std::vector<Row> run_tangles();
std::vector<Row> run_baking();
std::vector<Row> run_skeletons();
std::vector<Row> run_models();
std::vector<Row> run_pulling();
std::vector<Row> run_splines();
std::vector<Row> run_library();
#if defined(FLG_WITH_PICK)
std::vector<Row> run_picking();
#endif
#if defined(FLG_WITH_RENDERER)
std::vector<Row> run_magnitude();
std::vector<Row> run_drawing();
#endif
#if defined(FLG_WITH_REFERENCE)
// Against the literal versions, which are built with the tests.
std::vector<Row> run_matching();
std::vector<Row> run_matching_kinds();
std::vector<Row> run_geodesics();
// A program of the tests.
std::vector<Row> run_soak();
#endif

}  // namespace flg::bench
