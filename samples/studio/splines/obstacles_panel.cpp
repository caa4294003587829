// SPDX-License-Identifier: MIT
#include "shell/widgets.h"
#include "splines/panel.h"

namespace flg::studio::splines {
namespace {

struct Kind {
    FlgObstacleKind kind;
    const char *label, *tip;
};
constexpr Kind kKinds[] = {
    {FLG_OBSTACLE_BALL, "Ball", "The next click puts a ball where it hits."},
    {FLG_OBSTACLE_BOX, "Box", "The next click puts a box where it hits."},
    {FLG_OBSTACLE_CAPSULE, "Capsule", "The next click puts a post with round ends where it hits."}};

void size_slider(const char* label, double* value, double size, const char* tip) {
    auto shown = static_cast<float>(*value);
    const auto whole = static_cast<float>(size);
    if (ui::slider(label, &shown, 0.005f * whole, 1.0f * whole, "%.3f m", tip, true))
        *value = static_cast<double>(shown);
}

}  // namespace

void obstacles_panel(Stage& stage) {
    for (const Kind& kind : kKinds) {
        if (&kind != kKinds) ui::same_row();
        if (ui::row_button(kind.label, 3, kind.tip, {.enabled = true, .pressed = stage.kind == kind.kind}))
            stage.kind = kind.kind;
    }
    ui::hint(
        "Click where an obstacle is to be, on the surface or beside it. Curves and motions go around it, also while "
        "you drag it.");
    for (const Obstacle& obstacle : stage.document.obstacles) {
        const Row row = list_row(obstacle.name, obstacle.id, obstacle.id == stage.obstacle, "obstacle");
        if (row == Row::chosen) stage.obstacle = obstacle.id;
        if (row == Row::removed) {
            stage.remove_obstacle(obstacle.id);
            break;
        }
    }
    Obstacle* const chosen = stage.chosen_obstacle();
    if (chosen == nullptr) return;
    ui::heading("Obstacle");
    ui::text("Name", &chosen->name, "What the obstacle is called in the list.");
    const double size = stage.size();
    if (chosen->kind == FLG_OBSTACLE_BOX) {
        size_slider("Half width", &chosen->half.x, size,
                    "From the middle to the left and right side, metres. More: wider.");
        size_slider("Half height", &chosen->half.y, size, "From the middle to top and bottom, metres. More: higher.");
        size_slider("Half depth", &chosen->half.z, size, "From the middle to front and back, metres. More: deeper.");
    } else {
        size_slider("Radius", &chosen->radius, size, "In metres. More: thicker, and curves go a longer way around.");
    }
}

}  // namespace flg::studio::splines
