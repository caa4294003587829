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
    draw_borders();
    draw_status();
    draw_shortcuts();
    draw_log();
    budget_.draw(view_.viewport, options_.budget_us, renderer_);
    first_steps_.draw(view_.viewport);
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
    const float rightmost = static_cast<float>(target_->width()) - whole - gap;
    ImGui::SetCursorPos(
        {std::max(std::min(middle - 0.5f * whole, rightmost), gap), 0.5f * (height - ImGui::GetFrameHeight())});
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
            std::string("Switch to ") + workspaces_[i]->title() + ". Ctrl+" + std::to_string(i + 1) + ".";
        ui::tip(said.c_str());
        if (clicked) bring_to_front(i);
    }
    ImGui::End();
}

void Studio::draw_panel() {
    if (left_.folded()) return;
    const auto top = static_cast<float>(view_.viewport.y);
    const float width = static_cast<float>(view_.viewport.x) - SidePanel::kBorder * scale_;
    begin_fixed("##panel", 0.0f, top, width, static_cast<float>(view_.viewport.w));
    ImGui::PushID(static_cast<int>(front_));
    front().panel();
    ImGui::PopID();
    ImGui::End();
}

void Studio::draw_borders() {
    const auto top = static_cast<float>(view_.viewport.y), height = static_cast<float>(view_.viewport.w);
    const float units = static_cast<float>(target_->width()) / scale_;
    const auto left = static_cast<float>(view_.viewport.x), right = left + static_cast<float>(view_.viewport.z);
    left_.draw_border("##tool panel border", left - SidePanel::kBorder * scale_, top, height, scale_, units, 1.0f);
    right_.draw_border("##scene panel border", right, top, height, scale_, units, -1.0f);
}

void Studio::draw_scene_panel() {
    if (right_.folded()) return;
    const float left = static_cast<float>(view_.viewport.x + view_.viewport.z) + SidePanel::kBorder * scale_;
    begin_fixed("##scene", left, static_cast<float>(view_.viewport.y), static_cast<float>(target_->width()) - left,
                static_cast<float>(view_.viewport.w));
    ui::heading("Scene");
    uint32_t removed = 0;
    for (const auto& mesh : scene_.meshes()) {
        ImGui::PushID(static_cast<int>(mesh->id));
        bool visible = mesh->visible;
        if (ui::toggle(("##see " + mesh->name).c_str(), &visible,
                       "Shows or hides this mesh. A hidden mesh cannot be drawn on.")) {
            steps_.set_visible(*mesh, visible);
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
        if (ui::button(("x##remove " + mesh->name).c_str(), "Removes this mesh from the scene.")) removed = mesh->id;
        ImGui::PopID();
    }
    if (removed != 0) steps_.remove(removed);
    if (scene_.meshes().empty()) ui::hint("No mesh yet. Drop a file here or add one below.");
    ui::heading("Add");
    int row = 0;
    for (const char* name : builtin_meshes()) {
        if (row++ % 3 != 0) ui::same_row();
        if (ui::row_button((std::string(name) + "##add").c_str(), 3, "Adds this built-in mesh to the scene."))
            open_mesh(std::string("builtin:") + name);
    }
    gizmo_.panel();
    if (SceneMesh* mesh = scene_.active(); mesh != nullptr && mesh->is_drawing() && front().shows_scene())
        ui::toggle("Test motion##drawing", &mesh->plays,
                   "Swings every joint a little. Strokes and ornament follow; a click on the picture ends it.");
    if (!jobs_.idle()) {
        ui::heading("Progress");
        jobs_.draw();
    }
    ImGui::End();
}

void Studio::draw_status() {
    const float top = static_cast<float>(view_.viewport.y + view_.viewport.w);
    begin_fixed("##status", 0.0f, top, static_cast<float>(target_->width()),
                static_cast<float>(target_->height()) - top, ImGuiWindowFlags_NoScrollbar);
    ImGui::SetCursorPosY(3.0f * scale_);
    constexpr const char* kCamera = "Right-drag: orbit. Middle-drag: pan. Wheel: zoom. F1: shortcuts. F2: frame graph.";
    ImGui::TextUnformatted(front().help().c_str());
    ImGui::SameLine(0.0f, 2.0f * ImGui::GetFontSize());
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(kCamera).x) ImGui::TextDisabled("%s", kCamera);
    ImGui::End();
}

void Studio::draw_shortcuts() {
    if (!shows_shortcuts_) return;
    static constexpr Workspace::Shortcut kShell[] = {
        {"Ctrl+1 .. Ctrl+4", "Strokes, Tangles, Skeletons, Splines"},
        {"Ctrl+Z, Ctrl+Shift+Z", "Undo, redo (also Ctrl+Y)"},
        {"Ctrl+S, Ctrl+Shift+S", "Save, save as"},
        {"Ctrl+O, Ctrl+N, Ctrl+Q", "Open, new, quit"},
        {"F or Home", "Fit everything in the view"},
        {"Keypad 1, 3, 7", "View from the front, the side, the top"},
        {"Right drag, Alt+drag", "Orbit the camera"},
        {"Middle drag, Shift+right drag", "Pan the camera"},
        {"Wheel", "Zoom"},
        {"Tab", "Fold or unfold the panels"},
        {"F1, F2", "These shortcuts, the frame graph"},
    };
    const float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::Begin("Keyboard and mouse", &shows_shortcuts_,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
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
    ImGui::Begin("Message log", &shows_log_, ImGuiWindowFlags_NoCollapse);
    if (notices_.log().empty()) ui::hint("No messages yet.");
    for (const Notices::Notice& notice : notices_.log()) ImGui::TextWrapped("%s", notice.sentence.c_str());
    ImGui::End();
}

void Studio::draw_questions() {
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove;
    const float unit = ImGui::GetFontSize();
    if (when_safe_ && !ImGui::IsPopupOpen("Unsaved changes") && !files_.is_open()) ImGui::OpenPopup("Unsaved changes");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::BeginPopupModal("Unsaved changes", nullptr, flags)) {
        const std::string question = "Save your changes to " + document_name() + (closes_ ? " before closing?" : "?");
        ImGui::TextUnformatted(question.c_str());
        ImGui::Dummy({26.0f * unit, 0.0f});
        std::function<void()> chosen;
        if (ui::row_button("Save##changes", 3, "Saves the changes and continues. Enter.") || ui::enter()) {
            save();
            guarded("save", [&] { finish_saving(true); });
            if (!unsaved()) chosen = when_safe_;
        }
        ui::same_row();
        if (ui::row_button("Discard##changes", 3, "Continues without saving. This cannot be undone."))
            chosen = when_safe_;
        ui::same_row();
        const bool stay = ui::row_button("Cancel##changes", 3, "Returns to your work. Escape.") || ui::escape();
        if (chosen || stay || files_.is_open()) {
            if (!files_.is_open()) when_safe_ = nullptr;
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
        if (chosen) chosen();
    }
    if (!left_behind_.empty() && !ImGui::IsPopupOpen("Recover unsaved work")) ImGui::OpenPopup("Recover unsaved work");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    if (ImGui::BeginPopupModal("Recover unsaved work", nullptr, flags)) {
        ImGui::TextUnformatted("The studio closed without saving. A copy of your work was kept.");
        ImGui::Dummy({28.0f * unit, 0.0f});
        const bool restore = ui::row_button("Recover##copy", 2, "Opens the copy. Enter.") || ui::enter();
        ui::same_row();
        const bool discard = ui::row_button("Discard##copy", 2, "Deletes the copy. This cannot be undone.");
        const std::string left = restore || discard ? std::exchange(left_behind_, {}) : std::string();
        if (discard) std::remove(left.c_str());
        // What could not be taken whole is kept as it is, and offered again.
        if (restore && take_document(read_document(left))) autosave_.adopt(left);
        if (restore) ++app_.changes;
        if (restore || discard) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
}

}  // namespace flg::studio
