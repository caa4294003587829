// SPDX-License-Identifier: MIT
#include "bench/groups.h"

namespace flg::bench {

const std::vector<Group>& groups() {
    static const std::vector<Group> list = {
        {"stylization", "thomas", run_thomas},
        {"stylization", "prepare", run_prepare},
        {"stylization", "patch_graph", run_patch_graph},
#if defined(FLG_WITH_REFERENCE)
        {"stylization", "matching", run_matching},
#endif
        {"stylization", "growth", run_growth},
        {"stylization", "analogies", run_analogies},
#if defined(FLG_WITH_REFERENCE)
        {"stylization", "fig14", run_matching_kinds},
#endif
        {"stylization", "hair", run_hair},
        {"stylization", "ribbon", run_ribbon},
        {"stylization", "brush_meshes", run_brush_meshes},
        {"stylization", "simplify", run_simplify},
        {"stylization", "buffers", run_buffers},
        {"runtime", "ticks", run_ticks},
        {"live strokes", "live", run_live},
        {"live strokes", "live_style", run_live_style},
#if defined(FLG_WITH_REFERENCE)
        {"surfaces", "geodesics", run_geodesics},
#endif
        {"surfaces", "cutting", run_cutting},
#if defined(FLG_WITH_PICK)
        {"surfaces", "picking", run_picking},
#endif
        {"tangles", "tangles", run_tangles},
        {"tangles", "baking", run_baking},
        {"skeletons", "skeletons", run_skeletons},
        {"skeletons", "inflation", run_inflation},
        {"skeletons", "models", run_models},
        {"skeletons", "pulling", run_pulling},
        {"splines", "splines", run_splines},
#if defined(FLG_WITH_RENDERER)
        {"renderer", "magnitude", run_magnitude},
        {"renderer", "renderer", run_drawing},
#endif
        {"the whole", "library", run_library},
#if defined(FLG_WITH_REFERENCE)
        {"the whole", "soak", run_soak},
#endif
    };
    return list;
}

}  // namespace flg::bench
