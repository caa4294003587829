// SPDX-License-Identifier: MIT
// The windows around the picture.
#include <imgui.h>

#include "scene/mesh_sources.h"
#include "shell/studio.h"
#include "shell/widgets.h"

namespace flg::studio {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_fixed(const char* name, float x, float y, float width, float height, ImGuiWindowFlags more = 0) {
    ImGui::SetNextWindowPos({x, y});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin(name, nullptr, kFixed | more);
}

}  // namespace

void Studio::draw_chrome() {
    draw_menu();
    draw_tabs();
    draw_panel();
    draw_scene_panel();
    draw_status();
    draw_shortcuts();
    draw_log();
    if (shows_budget_) budget_.draw(view_.viewport, options_.budget_us, renderer_);
    draw_questions();
    files_.draw();
}

void Studio::draw_tabs() {
    const float top = ImGui::GetFrameHeight();
    const auto height = static_cast<float>(view_.viewport.y) - top;
    begin_fixed("##tabs", 0.0f, top, static_cast<float>(target_->width()), height, ImGuiWindowFlags_NoScrollbar);
    const float gap = ImGui::GetStyle().ItemSpacing.x, width = 110.0f * scale_;
    const float whole = static_cast<float>(workspaces_.size()) * (width + gap) - gap;
    const auto middle = static_cast<float>(view_.viewport.x) + 0.5f * static_cast<float>(view_.viewport.z);
    ImGui::SetCursorPos({std::max(middle - 0.5f * whole, 0.0f), 0.5f * (height - ImGui::GetFrameHeight())});
    for (size_t i = 0; i < workspaces_.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const bool chosen = i == front_;
        const ImVec4 amber = ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive);
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, amber);
        if (chosen) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, amber);
        const bool clicked = ImGui::Button(workspaces_[i]->title(), {width, 0.0f});
        if (chosen) ImGui::PopStyleColor(2);
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        ui::mark(workspaces_[i]->title(), {{low.x, low.y}, {high.x, high.y}});
        const std::string said =
            std::string("Goes to the workspace ") + workspaces_[i]->title() + ". Ctrl+" + std::to_string(i + 1) + ".";
        ui::tip(said.c_str());
        if (clicked) bring_to_front(i);
    }
    ImGui::End();
}

void Studio::draw_panel() {
    const auto top = static_cast<float>(view_.viewport.y);
    begin_fixed("##panel", 0.0f, top, static_cast<float>(view_.viewport.x), static_cast<float>(view_.viewport.w));
    ImGui::PushID(static_cast<int>(front_));
    front().panel();
    ImGui::PopID();
    ImGui::End();
}

void Studio::draw_scene_panel() {
    const float left = static_cast<float>(view_.viewport.x + view_.viewport.z);
    begin_fixed("##scene", left, static_cast<float>(view_.viewport.y), static_cast<float>(target_->width()) - left,
                static_cast<float>(view_.viewport.w));
    ui::heading("Scene");
    uint32_t removed = 0;
    for (const auto& mesh : scene_.meshes()) {
        ImGui::PushID(static_cast<int>(mesh->id));
        bool visible = mesh->visible;
        if (ui::toggle(("##see " + mesh->name).c_str(), &visible,
                       "Whether this mesh can be seen, drawn on and picked.")) {
            scene_.set_visible(*mesh, visible);
            ++desk_.changes;
        }
        ImGui::SameLine();
        const float width = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight();
        ImGui::BeginChild("##name", {width, ImGui::GetFrameHeight()}, false,
                          ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::AlignTextToFramePadding();
        if (ui::selectable(mesh->name.c_str(), scene_.active() == mesh.get(), mesh->source.c_str()))
            scene_.set_active(mesh->id);
        ImGui::EndChild();
        ImGui::SameLine();
        if (ui::button(("x##remove " + mesh->name).c_str(), "Takes this mesh out of the scene.")) removed = mesh->id;
        ImGui::PopID();
    }
    if (removed != 0) removing_ = removed;
    if (scene_.meshes().empty()) ui::hint("No mesh yet. Drop a file here, or begin with one of these:");
    int row = 0;
    for (const char* name : builtin_meshes()) {
        if (row++ % 3 != 0) ui::same_row();
        if (ui::row_button((std::string(name) + "##add").c_str(), 3, "Adds this built-in mesh to the scene.")) {
            scene_.open(std::string("builtin:") + name);
            ++desk_.changes;
        }
    }
    if (!jobs_.idle()) {
        ui::heading("Work under way");
        jobs_.draw();
    }
    ImGui::End();
}

void Studio::draw_status() {
    const float top = static_cast<float>(view_.viewport.y + view_.viewport.w);
    begin_fixed("##status", 0.0f, top, static_cast<float>(target_->width()),
                static_cast<float>(target_->height()) - top, ImGuiWindowFlags_NoScrollbar);
    ImGui::SetCursorPosY(3.0f * scale_);
    ImGui::TextDisabled("%s   Right button turns, middle moves, wheel zooms. F1: keys.", front().help().c_str());
    ImGui::End();
}

void Studio::draw_shortcuts() {
    if (!shows_shortcuts_) return;
    static constexpr Workspace::Shortcut kShell[] = {
        {"Ctrl+1 .. Ctrl+4", "Strokes, Tangles, Skeletons, Splines"},
        {"Ctrl+Z, Ctrl+Shift+Z", "Undo, redo (also Ctrl+Y)"},
        {"Ctrl+S, Ctrl+Shift+S", "Save, save as"},
        {"Ctrl+O, Ctrl+N, Ctrl+Q", "Open, new, quit"},
        {"F or Home", "See everything"},
        {"Keypad 1, 3, 7", "From the front, the side, above"},
        {"Right drag, Alt+drag", "Turn the camera"},
        {"Middle drag, Shift+right drag", "Move the camera"},
        {"Wheel", "Zoom"},
        {"F1, F2", "These keys, the frame's budget"},
    };
    const float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::Begin("Keys and mouse", &shows_shortcuts_, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
    const auto rows = [&](const char* title, std::span<const Workspace::Shortcut> list) {
        ui::heading(title);
        for (const Workspace::Shortcut& shortcut : list) {
            ImGui::TextUnformatted(shortcut.keys);
            ImGui::SameLine(16.0f * unit);
            ImGui::TextDisabled("%s", shortcut.what);
        }
    };
    rows("Everywhere", kShell);
    rows(front().title(), front().shortcuts());
    ImGui::Dummy({32.0f * unit, 0.0f});
    ImGui::End();
}

void Studio::draw_log() {
    if (!shows_log_) return;
    const float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowSize({40.0f * unit, 16.0f * unit}, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::Begin("What was said", &shows_log_, ImGuiWindowFlags_NoCollapse);
    if (notices_.log().empty()) ui::hint("Nothing so far.");
    for (const Notices::Notice& notice : notices_.log()) ImGui::TextWrapped("%s", notice.sentence.c_str());
    ImGui::End();
}

void Studio::draw_questions() {
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove;
    const float unit = ImGui::GetFontSize();
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (removing_ != 0 && !ImGui::IsPopupOpen("Take a mesh out")) ImGui::OpenPopup("Take a mesh out");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::BeginPopupModal("Take a mesh out", nullptr, flags)) {
        ImGui::TextUnformatted("What was made on it goes with it, and can't be had back.");
        ImGui::Dummy({28.0f * unit, 0.0f});
        const bool remove = ui::row_button("Take it out", 2, "Takes the mesh out of the scene.");
        ui::same_row();
        const bool keep = ui::row_button("Keep it", 2, "Nothing happens. Escape.") || escape;
        if (remove) {
            scene_.remove(removing_);
            ++desk_.changes;
        }
        if (remove || keep) {
            removing_ = 0;
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
    if (when_safe_ && !ImGui::IsPopupOpen("Unsaved work") && !files_.is_open()) ImGui::OpenPopup("Unsaved work");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::BeginPopupModal("Unsaved work", nullptr, flags)) {
        ImGui::TextUnformatted("There are changes that are not saved.");
        ImGui::Dummy({26.0f * unit, 0.0f});
        std::function<void()> chosen;
        if (ui::row_button("Save them", 3, "Saves, then goes on.")) {
            save();
            if (!unsaved()) chosen = when_safe_;
        }
        ui::same_row();
        if (ui::row_button("Discard them", 3, "Goes on without them: they are lost.")) chosen = when_safe_;
        ui::same_row();
        const bool stay = ui::row_button("Stay here", 3, "Nothing happens. Escape.") || escape;
        if (chosen || stay || files_.is_open()) {
            if (!files_.is_open()) when_safe_ = nullptr;
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
        if (chosen) chosen();
    }
    if (!left_behind_.empty() && !ImGui::IsPopupOpen("Work was left behind")) ImGui::OpenPopup("Work was left behind");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::BeginPopupModal("Work was left behind", nullptr, flags)) {
        ImGui::TextUnformatted("The program ended last time without saving. Its work was kept.");
        ImGui::Dummy({28.0f * unit, 0.0f});
        const bool restore = ui::row_button("Bring it back", 2, "Opens what was kept.");
        ui::same_row();
        const bool discard = ui::row_button("Throw it away", 2, "It can't be had back.");
        const std::string left = restore || discard ? std::exchange(left_behind_, {}) : std::string();
        if (discard) std::remove(left.c_str());
        // What could not be taken whole is kept as it is, and offered again.
        if (restore && take_document(read_document(left))) autosave_.adopt(left);
        if (restore) ++desk_.changes;
        if (restore || discard) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
}

}  // namespace flg::studio
