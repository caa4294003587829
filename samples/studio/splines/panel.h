// SPDX-License-Identifier: MIT
// The workspace's widgets.
#pragma once

#include <cstdio>
#include <string>

#include <string>

#include "splines/spline_editor.h"

namespace flg::studio::splines {

void curves_panel(SplineEditor& editor);
void obstacles_panel(SplineEditor& editor);
void motions_panel(SplineEditor& editor);
// A row of a list: a name to be chosen by, and a button that takes it away.
enum class Row { none, chosen, removed };
Row list_row(const std::string& name, uint32_t id, bool chosen, const char* what);
// The choice of what points lie on, for what is begun next and for `chosen`, if that is not null.
void ground_choice(SplineEditor& editor, SurfaceRef* chosen);

// ", 2.5 ms", where times are told.
inline std::string in_milliseconds(const AppContext& app, float ms) {
    if (!app.tells_times) return {};
    char text[32];
    std::snprintf(text, sizeof text, ", %.1f ms", static_cast<double>(ms));
    return text;
}

}  // namespace flg::studio::splines
