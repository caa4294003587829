// SPDX-License-Identifier: MIT
#include "runtime/handle_table.h"

namespace flg {

const char* handle_kind_name(HandleKind kind) {
    switch (kind) {
        case HandleKind::job: return "job";
        case HandleKind::curve_set: return "curve set";
        case HandleKind::style: return "style";
        case HandleKind::live_stroke: return "live stroke";
        case HandleKind::surface: return "surface";
        case HandleKind::field: return "field";
        case HandleKind::surface_curves: return "set of surface curves";
        case HandleKind::tangle: return "tangle";
        case HandleKind::straight_skeleton: return "straight skeleton";
        case HandleKind::outline: return "outline";
        case HandleKind::part: return "part";
        case HandleKind::part_mesh: return "mesh of a part";
        case HandleKind::model: return "model";
        case HandleKind::pull: return "pull";
        case HandleKind::pulled: return "pulled mesh";
        case HandleKind::skin: return "skin";
        case HandleKind::manifold: return "manifold";
        case HandleKind::obstacles: return "obstacles";
        case HandleKind::spline: return "spline";
        case HandleKind::motion: return "motion";
    }
    return "handle";
}

}  // namespace flg
