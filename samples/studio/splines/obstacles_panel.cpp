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
    {FLG_OBSTACLE_KIND_BALL, "Ball", "The next click adds a ball."},
    {FLG_OBSTACLE_KIND_BOX, "Box", "The next click adds a box."},
    {FLG_OBSTACLE_KIND_CAPSULE, "Capsule", "The next click adds a capsule, a post with round ends."}};

void size_slider(const char* label, double* value, double size, const char* tip) {
    auto shown = static_cast<float>(*value);
    const auto whole = static_cast<float>(size);
    if (ui::length(label, &shown, 0.005f * whole, 1.0f * whole, tip, true)) *value = static_cast<double>(shown);
}

}  // namespace

void obstacles_panel(SplineEditor& editor) {
    for (const Kind& kind : kKinds) {
        if (&kind != kKinds) ui::same_row();
        if (ui::row_button(kind.label, 3, kind.tip, {.enabled = true, .pressed = editor.kind == kind.kind}))
            editor.kind = kind.kind;
    }
    ui::hint("Click on the surface or beside it to add an obstacle. Curves and motions go around it.");
    for (const Obstacle& obstacle : editor.document.obstacles) {
        const Row row = list_row(obstacle.name, obstacle.id, obstacle.id == editor.obstacle, "obstacle");
        if (row == Row::chosen) editor.obstacle = obstacle.id;
        if (row == Row::removed) {
            editor.remove_obstacle(obstacle.id);
            break;
        }
    }
    Obstacle* const chosen = editor.chosen_obstacle();
    if (chosen == nullptr) return;
    ui::heading("Obstacle");
    ui::text("Name", &chosen->name, "Name of the obstacle in the list.");
    const double size = editor.size();
    if (chosen->kind == FLG_OBSTACLE_KIND_BOX) {
        size_slider("Half width", &chosen->half.x, size, "Distance from the centre to the sides.");
        size_slider("Half height", &chosen->half.y, size, "Distance from the centre to top and bottom.");
        size_slider("Half depth", &chosen->half.z, size, "Distance from the centre to front and back.");
    } else {
        size_slider("Radius", &chosen->radius, size, "Radius of the obstacle.");
    }
}

}  // namespace flg::studio::splines
