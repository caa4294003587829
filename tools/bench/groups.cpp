// SPDX-License-Identifier: MIT
#include "bench/groups.h"

namespace flg::bench {

const std::vector<Group>& groups() {
    static const std::vector<Group> list = {
        {"thomas", run_thomas},
        {"prepare", run_prepare},
        {"patch_graph", run_patch_graph},
#if defined(FLG_WITH_REFERENCE)
        {"matching", run_matching},
        {"geodesics", run_geodesics},
#endif
        {"ticks", run_ticks},
        {"live", run_live},
        {"live_style", run_live_style},
        {"growth", run_growth},
        {"analogies", run_analogies},
        {"fig14", run_matching_kinds},
        {"hair", run_hair},
        {"ribbon", run_ribbon},
        {"cutting", run_cutting},
        {"inflation", run_inflation},
        {"tangles", run_tangles},
        {"skeletons", run_skeletons},
        {"models", run_models},
        {"splines", run_splines},
#if defined(FLG_WITH_PICK)
        {"picking", run_picking},
#endif
#if defined(FLG_WITH_RENDERER)
        {"magnitude", run_magnitude},
        {"renderer", run_drawing},
#endif
    };
    return list;
}

}  // namespace flg::bench
