// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <cstring>

#include "scene/mesh_sources.h"
#include "shell/studio.h"
#include "shell/widgets.h"

namespace flg::studio {
namespace {

// Anywhere in the window, not within what is scrolled.
void mark_item(const char* label) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui::mark(label, {{low.x, low.y}, {high.x, high.y}});
}

bool item(const char* label, const char* keys, bool enabled = true, bool chosen = false) {
    const bool clicked = ImGui::MenuItem(label, keys, chosen, enabled);
    mark_item(label);
    return clicked;
}

bool begin(const char* label) {
    const bool open = ImGui::BeginMenu(label);
    mark_item(label);
    return open;
}

}  // namespace

void Studio::draw_menu() {
    if (!ImGui::BeginMainMenuBar()) return;
    draw_file_menu();
    draw_edit_menu();
    draw_view_menu();
    if (begin("Help")) {
        if (item("Keyboard and mouse", "F1")) shows_shortcuts_ = true;
        if (item("Message log", "")) shows_log_ = true;
        ImGui::EndMenu();
    }
    const std::string shown = document_name() + (unsaved() ? " *" : "");
    ImGui::SameLine(static_cast<float>(target_->width()) - ImGui::CalcTextSize(shown.c_str()).x - 14.0f * scale_);
    ImGui::TextDisabled("%s", shown.c_str());
    ImGui::EndMainMenuBar();
}

void Studio::draw_file_menu() {
    if (!begin("File")) return;
    if (item("New", "Ctrl+N")) when_safe([this] { new_document(); });
    if (item("Open...", "Ctrl+O")) ask_open();
    if (item("Save", "Ctrl+S")) save();
    if (item("Save as...", "Ctrl+Shift+S")) ask_save_as();
    ImGui::Separator();
    if (begin("Add mesh")) {
        for (const char* name : builtin_meshes())
            if (item(name, "")) open_mesh(std::string("builtin:") + name);
        ImGui::EndMenu();
    }
    if (begin("Export")) {
        for (const auto& workspace : workspaces_) {
            for (const Workspace::Export& what : workspace->exports()) {
                const std::string label = std::string(what.what) + " as " + what.extension + "...";
                if (item(label.c_str(), "")) ask_export(*workspace, what);
            }
        }
        ImGui::EndMenu();
    }
    ImGui::Separator();
    if (item("Quit", "Ctrl+Q")) close();
    ImGui::EndMenu();
}

void Studio::draw_edit_menu() {
    if (!begin("Edit")) return;
    if (item("Undo", "Ctrl+Z", can_undo())) undo();
    if (item("Redo", "Ctrl+Shift+Z", timeline_.can_redo())) timeline_.redo();
    ImGui::Separator();
    if (item("Cancel all jobs", "", !jobs_.idle())) jobs_.cancel_all();
    ImGui::EndMenu();
}

void Studio::draw_view_menu() {
    if (!begin("View")) return;
    if (item("Fit all", "F")) view_.frame(renderer_.bounds());
    if (item("Front", "Keypad 1")) view_.frame(renderer_.bounds(), {0, 0, -1});
    if (item("Side", "Keypad 3")) view_.frame(renderer_.bounds(), {-1, 0, 0});
    if (item("Top", "Keypad 7")) view_.frame(renderer_.bounds(), {0, -1, 0});
    ImGui::Separator();
    if (item("Tool panel", "Tab", true, !left_.folded())) left_.fold(!left_.folded());
    if (item("Scene panel", "Tab", true, !right_.folded())) right_.fold(!right_.folded());
    if (item("Frame graph", "F2", true, budget_.shows())) budget_.show_more();
    render::Scene look = renderer_.scene();
    if (item("Floor", "", true, look.ground)) {
        look.ground = !look.ground;
        renderer_.set_scene(look);
    }
    ImGui::EndMenu();
}

}  // namespace flg::studio
