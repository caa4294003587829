// SPDX-License-Identifier: MIT
// The app's widgets: ImGui's, each with a tooltip, of one look, and found by its label, so that scripts can put the
// mouse on it. Labels are unique within what is shown at a time; what follows "##" is not shown but is part of the
// label. Tooltips say what it does and, where there is a number, its unit and what more of it means.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>

struct ImVec2;

namespace flg::studio::ui {

struct Rect {
    glm::vec2 low{0.0f}, high{0.0f};  // pixels of the window
    // The part of the window it is scrolled in: it may lie outside of it.
    glm::vec2 pane_low{0.0f}, pane_high{1e9f};
};

// Of the frame that was drawn last; null if there is no such widget.
const Rect* find_widget(const std::string& label);
// All of the frame that is being drawn.
const std::map<std::string, Rect>& widgets();
// All labels, for the sentence that says there is none.
std::string widget_labels();
// To be called by the shell before each frame.
void begin_widgets();
// Widgets that are not made here (handles in the 3D picture): registers what scripts may aim at.
void mark(const std::string& label, const Rect& rect);
// The widget made last, by another name: one whose label is drawn over it.
void mark_last(const std::string& label);
// A linear colour as ImGui draws it.
uint32_t shown_color(const glm::vec3& linear);

struct State {
    bool enabled = true;
    bool pressed = false;  // shown as the one chosen
};

void heading(const char* text);
// A heading that folds what follows, which is made only if this returns true. `open`: at first.
bool section(const char* label, bool open = true);
// Small grey text, wrapped.
void hint(const char* text);
bool button(const char* label, const char* tip, const State& state = {});
// Buttons side by side, as many as `across` fill the panel's width: call before each but the first of a row.
void same_row();
// Of the panel's width, a share: `across` buttons in a row.
bool row_button(const char* label, int across, const char* tip, const State& state = {});
bool toggle(const char* label, bool* value, const char* tip, bool enabled = true);
// `format` as for printf, with the unit: "%.2f m". The value stands beside it, as the widget "LABEL value": a double
// click on either makes it a field to type in.
bool slider(const char* label, float* value, float low, float high, const char* format, const char* tip,
            bool logarithmic = false, bool enabled = true);
bool slider(const char* label, int* value, int low, int high, const char* format, const char* tip, bool enabled = true);
// A length in metres; shown, dragged and typed in millimetres below 10 cm, in centimetres below 1 m, else in metres.
// `at_zero` is shown for 0.
bool length(const char* label, float* metres, float low, float high, const char* tip, bool logarithmic = false,
            bool enabled = true, const char* at_zero = nullptr);
// The same as a text: "34.0 mm".
std::string length_text(double metres);
// Three numbers in a row, dragged by so much a pixel, or typed on double click.
bool numbers(const char* label, glm::vec3* value, float step, const char* format, const char* tip);
bool choice(const char* label, int* index, std::span<const char* const> names, const char* tip, bool enabled = true);
// Linear RGB, shown as sRGB.
bool color(const char* label, glm::vec3* value, const char* tip);
// All of it is selected when it gets the keyboard, which it does at once with `focus`.
bool text(const char* label, std::string* value, const char* tip, bool focus = false);
// A line of a list or tree; true when clicked.
bool selectable(const char* label, bool selected, const char* tip = nullptr);
// The mouse let go of the widget made last after having changed it, or a value was typed: where undo takes a step.
bool released();
// It is being dragged: where previews are made.
bool active();
// A tooltip for the widget made last.
void tip(const char* text);

// Enter, or Escape, went down in this frame: what confirms a dialog, and what cancels it.
bool enter();
bool escape();

// Asks for another frame in so many seconds, though nothing may happen until then.
void frame_in(double seconds);
// The shortest that was asked for since begin_widgets(); infinite if nothing was.
double next_frame_in();

}  // namespace flg::studio::ui
