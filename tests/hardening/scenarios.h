// SPDX-License-Identifier: MIT
// Everything the SDK can do, in small: each scenario calls all entry points of one ability with what they take. Results
// go into Calls::bits; the same scenario gives the same bits, whatever runs beside it.
#pragma once

#include "hardening/calls.h"

namespace flg::test {

struct Scenario {
    const char* name;
    void (*run)(Calls&);
    int64_t cost = 1;  // about how many times as long as most others it takes
};

inline void PrintTo(const Scenario& scenario, std::ostream* out) {
    *out << scenario.name;
}
inline std::string name_of(const testing::TestParamInfo<Scenario>& test) {
    return test.param.name;
}

void make_contexts(Calls&);
void make_curves(Calls&);
void make_styles(Calls&);
void stylize_curves(Calls&);
void draw_live_strokes(Calls&);
void make_surfaces(Calls&);
void measure_surfaces(Calls&);
void trace_surfaces(Calls&);
void cut_surfaces(Calls&);
void bake_tangles(Calls&);
void divide_tangles(Calls&);
void edit_tangles(Calls&);
void replay_tangles(Calls&);
void make_manifolds(Calls&);
void make_sampled_manifolds(Calls&);
void fit_splines(Calls&);
void hang_cables(Calls&);
void avoid_obstacles(Calls&);
void move_bodies(Calls&);
void make_straight_skeletons(Calls&);
void make_models(Calls&);
void make_outlines(Calls&);
void make_mesh_skins(Calls&);
void pull_meshes(Calls&);
void pose_skins(Calls&);

inline constexpr Scenario scenarios[] = {
    {"contexts", make_contexts},
    {"curves", make_curves},
    {"styles", make_styles},
    {"stylization", stylize_curves},
    {"live_strokes", draw_live_strokes},
    {"surfaces", make_surfaces},
    {"fields", measure_surfaces},
    {"traces", trace_surfaces},
    {"cuts", cut_surfaces},
    {"tangle_divisions", divide_tangles},
    {"tangle_bakes", bake_tangles},
    {"tangle_edits", edit_tangles},
    {"tangle_replays", replay_tangles},
    {"manifolds", make_manifolds},
    {"sampled_manifolds", make_sampled_manifolds},
    {"splines", fit_splines},
    {"cables", hang_cables},
    {"obstacles", avoid_obstacles, 10},
    {"motions", move_bodies},
    {"straight_skeletons", make_straight_skeletons},
    {"models", make_models, 2},
    {"outlines", make_outlines},
    {"mesh_skins", make_mesh_skins},
    {"pulls", pull_meshes},
    {"poses", pose_skins},
};

// Those of the libraries beside: they need no context, and take the C++ runtime's memory.
#ifdef FLG_WITH_IO
void keep_plain_files(Calls&);
void keep_curve_files(Calls&);
void keep_mesh_files(Calls&);
void keep_skin_files(Calls&);
void keep_tangle_files(Calls&);
#endif
#ifdef FLG_WITH_PICK
void pick(Calls&);
#endif

}  // namespace flg::test
