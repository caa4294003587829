// SPDX-License-Identifier: MIT
// The workspace's panel: the selected part, where it is, and the list of all.
#include <algorithm>
#include <utility>

#include "shell/widgets.h"
#include "skeletons/joint_edits.h"
#include "skeletons/skeletons.h"

namespace flg::studio {
namespace {

double width_of(const DrawnPart& part) {
    glm::dvec2 low = part.contour->rings[0][0], high = low;
    for (const glm::dvec2& p : part.contour->rings[0]) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return std::max(glm::distance(low, high), 1e-12);
}

}  // namespace

void Skeletons::take_name() {
    const DrawnPart* part = editor_.drawing().find(std::exchange(name_of_, 0));
    if (part == nullptr || part->name == name_text_) return;
    const uint32_t id = part->id;
    const std::string before = part->name, name = editor_.drawing().free_name(name_text_, id);
    editor_.commit();
    Drawing& drawing = editor_.change("name");
    rename_part(drawing, before, name);
    drawing.find(id)->name = name;
    editor_.commit();
}

void Skeletons::name_field() {
    const uint32_t id = editor_.selected_id();
    // Another one was selected while this was typed.
    if (name_of_ != 0 && name_of_ != id) take_name();
    std::string text = name_of_ != 0 ? name_text_ : id != 0 ? editor_.selected()->name : editor_.brush.name;
    ui::text("Name", &text, "Name of the part and its joints.");
    if (id == 0) {
        editor_.brush.name = text;
    } else if (ui::active()) {
        name_of_ = id;
        name_text_ = text;
    } else {
        take_name();
    }
}

void Skeletons::part_panel() {
    const bool is_next = editor_.selected() == nullptr;
    ui::heading(is_next ? "Next part" : "Selected part");
    if (mode_ == Mode::draw &&
        ui::row_button("New part", 1, "Clears the selection: the settings below are then those of the next part.",
                       {.enabled = !is_next})) {
        take_name();
        return editor_.select(0);
    }
    name_field();
    const DrawnPart& part = is_next ? editor_.brush : *editor_.selected();
    const MirrorAs mirror = is_next ? editor_.brush_mirror : editor_.mirror_of(part);
    struct Choice {
        MirrorAs as;
        const char* label;
        const char* tip;
    };
    ui::hint("Copies");
    constexpr Choice kMirrors[] = {
        {MirrorAs::single, "Single", "One part, as you draw it."},
        {MirrorAs::left_right, "Left, right",
         "Two mirrored parts, left and right of the dashed line: the arms of a figure that faces you."},
        {MirrorAs::front_back, "Near, far",
         "Two parts, on the near and the far side of the body: the legs of an animal "
         "drawn from its side."}};
    for (const Choice& choice : kMirrors) {
        if (choice.as != MirrorAs::single) ui::same_row();
        if (ui::row_button(choice.label, 3, choice.tip, {.pressed = mirror == choice.as}))
            editor_.set_mirror(choice.as);
    }
    glm::vec3 color = part.color;
    if (ui::color("Colour", &color, "Colour of the part.")) {
        editor_.brush.color = color;
        if (!is_next) editor_.change_selected("colour").color = color;
    }
    end_slider();
    float thickness = 100.0f * part.thickness;
    if (ui::slider("Thickness", &thickness, 10.0f, 200.0f, "%.0f %%",
                   "Depth of the part. At 100 % a disc becomes a ball. Less is flatter.")) {
        editor_.brush.thickness = 0.01f * thickness;
        if (!is_next) editor_.change_selected("thickness").thickness = 0.01f * thickness;
    }
    end_slider();
    float depth = is_next ? draw_.depth : static_cast<float>(part.at.z);
    if (ui::length("Depth", &depth, -reach_, reach_,
                   "Distance of the part from the drawing plane. More is nearer to you.")) {
        if (is_next)
            draw_.depth = depth;
        else
            editor_.change_selected("depth").at.z = static_cast<double>(depth);
    }
    end_slider();
}

void Skeletons::move_panel() {
    if (editor_.selected() == nullptr) {
        ui::heading("Selected part");
        return ui::hint("Click a part in the view or in the list.");
    }
    part_panel();
    place_panel();
}

void Skeletons::place_panel() {
    struct Axis {
        const char* label;
        int axis;
        const char* tip;
    };
    constexpr Axis kPlaces[] = {{"Right", 0, "Distance to the right of where you drew the part."},
                                {"Up", 1, "Distance above where you drew the part."}};
    for (const Axis& along : kPlaces) {
        auto value = static_cast<float>(editor_.selected()->at[along.axis]);
        if (ui::length(along.label, &value, -reach_, reach_, along.tip))
            editor_.change_selected(along.label).at[along.axis] = static_cast<double>(value);
        end_slider();
    }
    constexpr Axis kTurns[] = {{"Tilt", 0, "Turns the part about the horizontal axis. More leans its top towards you."},
                               {"Swing", 1, "Turns the part about the vertical axis, like a door."},
                               {"Turn", 2, "Turns the part in its plane. More is counter-clockwise."}};
    for (const Axis& about : kTurns) {
        auto value = static_cast<float>(editor_.selected()->turn[about.axis]);
        if (ui::slider(about.label, &value, -180.0f, 180.0f, "%.0f deg", about.tip)) {
            glm::dvec3 turn = editor_.selected()->turn;
            turn[about.axis] = static_cast<double>(value);
            DrawnPart& part = editor_.change_selected(about.label);
            part.place(turn, part.scale);
        }
        end_slider();
    }
    const double drawn = width_of(*editor_.selected());
    auto size = static_cast<float>(editor_.selected()->scale * drawn);
    if (ui::length("Size", &size, 0.05f, 20.0f, "Length of the part from corner to corner.", true)) {
        DrawnPart& part = editor_.change_selected("size");
        part.place(part.turn, static_cast<double>(size) / drawn);
    }
    end_slider();
}

void Skeletons::parts_panel() {
    if (!ui::section("Parts")) return;
    const Drawing& drawing = editor_.drawing();
    if (drawing.parts.empty()) return ui::hint("No parts yet. Draw the body first, then the limbs.");
    uint32_t clicked = 0;
    for (const DrawnPart& part : drawing.parts) {
        const bool is_wrong = !editor_.live.state_of(part.contour).fault.empty();
        const std::string label = (is_wrong ? "! " : "") + part.name + (part.mirrored ? "  (mirrored)" : "") +
                                  (!part.visible                    ? "  (hidden)"
                                   : editor_.live.is_loose(part.id) ? "  (loose)"
                                                                    : "") +
                                  "###" + part.name + " in list";
        if (ui::selectable(label.c_str(), part.id == editor_.selected_id(),
                           "Click to select this part. A part attaches to the part above that it touches."))
            clicked = part.id;
    }
    if (clicked != 0) editor_.select(clicked == editor_.selected_id() ? 0 : clicked);
    if (editor_.live.has_loose_parts()) ui::hint("Loose parts touch no other part. Move them until they do.");
    const DrawnPart* part = editor_.selected();
    const ui::State state = {.enabled = part != nullptr};
    if (ui::row_button("Duplicate", 3, "Adds a copy beside the part. Ctrl+D.", state)) editor_.duplicate_selected();
    ui::same_row();
    const bool is_hidden = part != nullptr && !part->visible;
    if (ui::row_button(is_hidden ? "Show" : "Hide", 3, "Leaves the part out of the body and the bones.", state)) {
        editor_.commit();
        editor_.change_selected("hide").visible = is_hidden;
        editor_.commit();
    }
    ui::same_row();
    if (ui::row_button("Delete", 3, "Deletes the selected part. Delete.", state)) {
        drop_tools();
        editor_.remove_selected();
    }
    if (ui::row_button("Earlier", 2, "Moves the part up in the list. Later parts can attach to it.", state))
        editor_.shift_selected(-1);
    ui::same_row();
    if (ui::row_button("Later", 2, "Moves the part down in the list. It can attach to parts above.", state))
        editor_.shift_selected(1);
}

}  // namespace flg::studio
