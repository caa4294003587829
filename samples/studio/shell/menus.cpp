// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <cstring>

#include "scene/mesh_sources.h"
#include "shell/studio.h"
#include "shell/widgets.h"

namespace flg::studio {
namespace {

void mark_last(const char* label) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui::mark(label, {{low.x, low.y}, {high.x, high.y}});
}

bool item(const char* label, const char* keys, bool enabled = true, bool chosen = false) {
    const bool clicked = ImGui::MenuItem(label, keys, chosen, enabled);
    mark_last(label);
    return clicked;
}

bool begin(const char* label) {
    const bool open = ImGui::BeginMenu(label);
    mark_last(label);
    return open;
}

}  // namespace

void Studio::draw_menu() {
    if (!ImGui::BeginMainMenuBar()) return;
    draw_file_menu();
    draw_edit_menu();
    draw_view_menu();
    if (begin("Help")) {
        if (item("Keys and mouse", "F1")) shows_shortcuts_ = true;
        if (item("What was said", "")) shows_log_ = true;
        ImGui::EndMenu();
    }
    const size_t slash = path_.find_last_of('/');
    const std::string name = path_.empty() ? "untitled" : path_.substr(slash == std::string::npos ? 0 : slash + 1);
    const std::string shown = name + (unsaved() ? " *" : "");
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
    if (begin("Add a mesh")) {
        for (const char* name : builtin_meshes())
            if (item(name, "")) {
                scene_.open(std::string("builtin:") + name);
                ++desk_.changes;
            }
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
    if (item("Undo", "Ctrl+Z", front().can_undo())) front().undo();
    if (item("Redo", "Ctrl+Shift+Z", front().can_redo())) front().redo();
    ImGui::Separator();
    if (item("Cancel all work", "", !jobs_.idle())) jobs_.cancel_all();
    ImGui::EndMenu();
}

void Studio::draw_view_menu() {
    if (!begin("View")) return;
    if (item("See everything", "F")) view_.frame(renderer_.bounds());
    if (item("From the front", "Keypad 1")) view_.frame(renderer_.bounds(), {0, 0, -1});
    if (item("From the side", "Keypad 3")) view_.frame(renderer_.bounds(), {-1, 0, 0});
    if (item("From above", "Keypad 7")) view_.frame(renderer_.bounds(), {0, -1, 0});
    ImGui::Separator();
    if (item("Frame's budget", "F2", true, shows_budget_)) shows_budget_ = !shows_budget_;
    render::Scene look = renderer_.scene();
    if (item("Floor", "", true, look.ground)) {
        look.ground = !look.ground;
        renderer_.set_scene(look);
    }
    ImGui::EndMenu();
}

}  // namespace flg::studio
