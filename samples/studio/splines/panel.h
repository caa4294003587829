// SPDX-License-Identifier: MIT
// The workspace's widgets.
#pragma once

#include <cstdio>
#include <string>

#include <string>

#include "splines/stage.h"

namespace flg::studio::splines {

void curves_panel(Stage& stage);
void obstacles_panel(Stage& stage);
void motions_panel(Stage& stage);
// A row of a list: a name to be chosen by, and a button that takes it away.
enum class Row { none, chosen, removed };
Row list_row(const std::string& name, uint32_t id, bool chosen, const char* what);
// The choice of what points lie on, for what is begun next and for `chosen`, if that is not null.
void ground_choice(Stage& stage, Ground* chosen);

// ", 2.5 ms", where times are told.
inline std::string in_milliseconds(const Desk& desk, float ms) {
    if (!desk.tells_times) return {};
    char text[32];
    std::snprintf(text, sizeof text, ", %.1f ms", static_cast<double>(ms));
    return text;
}

}  // namespace flg::studio::splines
