// SPDX-License-Identifier: MIT
// The panel of the tangles: what is selected, what can be done to it, materials, and the list of regions.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"
#include "tangles/action_icons.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

constexpr int kSwatchesInARow = 6;

std::string plural(size_t count, const char* one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

}  // namespace

void TanglesWorkspace::panel() {
    Ornament* ornament = active();
    if (ornament == nullptr || ornament->regions.count() == 0) {
        ui::hint(app_.scene.active() == nullptr
                     ? "Add a mesh first: drop a file here, or choose one under Scene on the right."
                     : "Preparing the mesh...");
        return;
    }
    draw_selection(*ornament);
    draw_deeds();
    if (ornament->live) draw_live(*ornament);
    draw_materials();
    draw_history(*ornament);
    draw_regions(*ornament);
}

void TanglesWorkspace::draw_selection(const Ornament& ornament) {
    if (!ui::section("Select")) return;
    struct Pick {
        const char* name;
        Picks picks;
        const char* tip;
    };
    constexpr Pick kPicks[] = {{"Region", Picks::region, "A click selects the region under the mouse. R."},
                               {"Group", Picks::group, "A click selects the whole group, all dots for example. G."},
                               {"Colour", Picks::alike, "A click selects all regions of the same colour. A."}};
    for (const Pick& pick : kPicks) {
        if (&pick != kPicks) ui::same_row();
        if (ui::row_button(pick.name, 3, pick.tip, {.pressed = picks_ == pick.picks})) picks_ = pick.picks;
    }
    if (ui::row_button("All", 3, "Selects all regions. Ctrl+A.")) select_all();
    ui::same_row();
    if (ui::row_button("None", 3, "Clears the selection. Buttons then act on the whole mesh. Escape.",
                       {.enabled = !selected_.empty()}))
        selected_.clear();
    ui::same_row();
    if (ui::row_button("Parent", 3, "Selects the parents of the selected regions. U.", {.enabled = !selected_.empty()}))
        select_parents();
    const size_t leaves = ornament.regions.leaves().size();
    const std::string said =
        selected_.empty() ? (leaves == 1 ? std::string("Nothing selected: buttons act on the whole mesh.")
                                         : "Nothing selected: buttons act on all " + plural(leaves, "region") + ".")
                          : plural(selected_.size(), "region") + " of " + std::to_string(leaves) + " selected.";
    ui::hint(said.c_str());
}

void TanglesWorkspace::action_button(Action action, int across) {
    const ActionInfo& info = info_of(action);
    const Ornament* ornament = trying();
    const bool chosen = ornament != nullptr && ornament->live->recipe.action == action;
    const float unit = app_.scale, text = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, 14.0f * unit});
    const std::string label = std::string("##action ") + info.name;
    const bool clicked = ui::row_button(label.c_str(), across, info.what, {.pressed = chosen});
    ImGui::PopStyleVar();
    ui::mark_last(info.name);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float size = 20.0f * unit;
    draw_action_icon(list, action, {0.5f * (low.x + high.x), low.y + 4.0f * unit + 0.5f * size}, size);
    const float font = 0.8f * text;
    const float width = ImGui::CalcTextSize(info.name).x * 0.8f;
    list.AddText(ImGui::GetFont(), font, {0.5f * (low.x + high.x - width), high.y - font - 3.0f * unit},
                 IM_COL32(225, 218, 205, 255), info.name);
    if (clicked) try_action(action);
}

void TanglesWorkspace::draw_deeds() {
    if (!ui::section("Divide")) return;
    for (int i = 0; i < 12; ++i) {
        if (i % 4 != 0) ui::same_row();
        action_button(static_cast<Action>(i), 4);
    }
    if (!refusal_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4{1.0f, 0.62f, 0.35f, 1.0f});
        ImGui::TextWrapped("%s", refusal_.c_str());
        ImGui::PopStyleColor();
    }
    const bool any = !selected_.empty();
    if (ui::row_button("Raise", 4, info_of(Action::displace).what)) try_action(Action::displace);
    ui::same_row();
    if (ui::row_button("Join", 4, "Merges the selected regions. They must touch each other.", {.enabled = any}))
        change_regions("Join", [](Ornament& o, const Regions& regions) { return o.tangle.join(regions); });
    ui::same_row();
    if (ui::row_button("Group##regions", 4, "Groups the selected regions. A click then selects all of them.",
                       {.enabled = any}))
        change_regions("Group", [](Ornament& o, const Regions& regions) { return o.tangle.group(regions); });
    ui::same_row();
    if (ui::row_button("Ungroup", 4, "Splits the group of the selected regions into single regions.", {.enabled = any}))
        change_regions("Ungroup", [](Ornament& o, const Regions& regions) {
            return o.tangle.ungroup(o.regions[o.regions.leaves_below(regions).at(0)].group);
        });
}

void TanglesWorkspace::draw_materials() {
    if (!ui::section("Materials")) return;
    const float unit = app_.scale;
    for (size_t m = 0; m < palette_.materials.size(); ++m) {
        if (m % kSwatchesInARow != 0) ui::same_row();
        const TangleMaterial& material = palette_.materials[m];
        const bool chosen = material_ == m;
        const std::string label = "##material " + material.name + std::to_string(m);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, 6.0f * unit});
        const std::string tip = material.name + (trying() != nullptr  ? ": colour what this step makes."
                                                 : !selected_.empty() ? ": paint the selected regions."
                                                 : paints_            ? ": paint with clicks."
                                                                      : ": click to begin painting.");
        const bool clicked = ui::row_button(label.c_str(), kSwatchesInARow, tip.c_str(), {});
        ImGui::PopStyleVar();
        ui::mark_last(material.name);
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float inset = 2.0f * unit, round = 3.0f * unit;
        const ImVec2 a = {low.x + inset, low.y + inset}, b = {high.x - inset, high.y - inset};
        list.AddRectFilled(a, b, ui::shown_color(material.color), round);
        if (material.metallic > 0.5f) {
            // A glint.
            const float w = b.x - a.x;
            const ImU32 glint = IM_COL32(255, 255, 255, 110);
            list.AddQuadFilled({a.x + 0.25f * w, a.y}, {a.x + 0.5f * w, a.y}, {a.x + 0.3f * w, b.y},
                               {a.x + 0.05f * w, b.y}, glint);
        }
        if (chosen) list.AddRect(low, high, IM_COL32(255, 205, 120, 255), round, 0, 2.0f * unit);
        if (clicked) choose_material(static_cast<uint32_t>(m));
    }
    ui::toggle("Paint with clicks", &paints_, "Clicks paint with the chosen material instead of selecting. B.");
    draw_material_editor();
}

void TanglesWorkspace::draw_material_editor() {
    if (!ui::section("Edit material", false)) return;
    Palette changed = palette_;
    TangleMaterial& material = changed.materials[material_];
    bool is_changed = false, is_released = false;
    const auto take = [&](bool one) {
        is_changed |= one;
        is_released |= ui::released();
    };
    take(ui::color("Material colour", &material.color, "Colour of all regions with this material."));
    take(ui::slider("Metal", &material.metallic, 0.0f, 1.0f, "%.2f", "0 is paint or clay, 1 is bare metal."));
    take(ui::slider("Roughness", &material.roughness, 0.05f, 1.0f, "%.2f", "Less looks polished, more looks matte."));
    take(ui::slider("Line width", &material.border_px, 0.0f, 8.0f, "%.1f px",
                    "Width of the lines around this material, in pixels. 0 uses the width of all lines."));
    if (material.border_px > 0.0f)
        take(ui::color("Line colour", &material.border_color, "Colour of the lines around this material."));
    take(ui::slider("All lines", &changed.border_px, 0.0f, 8.0f, "%.1f px",
                    "Width of the lines between regions, in pixels. 0 hides them."));
    take(ui::color("Colour of all lines", &changed.border_color, "Colour of the lines between regions."));
    if (is_changed) {
        if (!palette_before_) palette_before_ = palette_;
        palette_ = changed;
        ++app_.changes;
        recolor_all();
    }
    if ((is_released || !ImGui::IsAnyItemActive()) && palette_before_) {
        if (*palette_before_ != palette_)
            later([this, before = *palette_before_, after = palette_] {
                keep();
                later([this, before, after] {
                    did({.kind = UndoStep::Kind::palette, .before = before, .after = after});
                });
            });
        palette_before_.reset();
    }
}

void TanglesWorkspace::draw_regions(const Ornament& ornament) {
    if (!ui::section("Regions")) return;
    if (ui::row_button("Tree", 2, "Lists regions under the region they are part of.", {.pressed = !shows_groups_}))
        shows_groups_ = false;
    ui::same_row();
    if (ui::row_button("Groups", 2, "Lists groups of regions.", {.pressed = shows_groups_})) shows_groups_ = true;
    Ornament& shown = *active();
    if (ui::toggle("Show scaffolds", &shown.shows_scaffolds,
                   "Shows the lines of scaffolds, which only help to place other regions."))
        shown.recolor();
    rows_.refresh(ornament.regions, ornament.mesh_id(), ornament.revision(), shows_groups_);
    const float unit = app_.scale, line = ImGui::GetTextLineHeightWithSpacing();
    const float height = std::clamp(static_cast<float>(rows_.rows().size()) + 0.5f, 3.0f, 14.0f) * line;
    ImGui::BeginChild("regions", {0.0f, height}, true);
    Regions hovered;
    const auto leaves_of = [&](const RegionRow& row) {
        return shows_groups_ ? ornament.regions.of_group(ornament.regions[row.region].group) : Regions{row.region};
    };
    uint32_t toggled = FLG_NO_INDEX;
    const bool is_bare = ornament.is_bare();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows_.rows().size()), line);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const RegionRow& row = rows_.rows()[static_cast<size_t>(i)];
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float indent = 12.0f * unit * static_cast<float>(std::min(row.depth, 8u)),
                        box = 0.8f * ImGui::GetFontSize();
            ImGui::PushID(i);
            if (row.size > 0 && !shows_groups_) {
                ImGui::SetCursorScreenPos({at.x + indent, at.y});
                if (ImGui::InvisibleButton("fold", {14.0f * unit, line})) toggled = row.region;
                ui::mark_last("fold " + std::to_string(row.region));
                const ImVec2 c = {at.x + indent + 6.0f * unit, at.y + 0.45f * line};
                const float r = 3.5f * unit;
                const ImU32 ink = IM_COL32(210, 200, 185, 255);
                if (row.is_open)
                    list.AddTriangleFilled({c.x - r, c.y - 0.6f * r}, {c.x + r, c.y - 0.6f * r}, {c.x, c.y + r}, ink);
                else
                    list.AddTriangleFilled({c.x - 0.6f * r, c.y - r}, {c.x + r, c.y}, {c.x - 0.6f * r, c.y + r}, ink);
            }
            const float left = at.x + indent + 16.0f * unit;
            const uint32_t material = ornament.material_of(row.region);
            const glm::vec3& color =
                is_bare ? ornament.mesh()->look.material.color : palette_.materials[material].color;
            list.AddRectFilled({left, at.y + 1.0f * unit}, {left + box, at.y + 1.0f * unit + box},
                               ui::shown_color(color), 2.0f * unit);
            ImGui::SetCursorScreenPos({left + box + 6.0f * unit, at.y});
            std::string text = shows_groups_ ? ornament.regions.name(row.region) + ": " + plural(row.size, "region")
                                             : ornament.regions.name(row.region);
            if (!shows_groups_ && row.size > 0) text += "  (" + std::to_string(row.size) + ")";
            const bool is_selected = std::binary_search(selected_.begin(), selected_.end(), row.region);
            const std::string label = text + "##region " + std::to_string(row.region);
            if (ui::selectable(label.c_str(), is_selected)) {
                Regions regions = leaves_of(row);
                if (ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl)
                    regions.insert(regions.end(), selected_.begin(), selected_.end());
                if (ornament.live) later([this] { keep(); });
                select(std::move(regions));
            }
            ui::mark_last("region " + std::to_string(row.region));
            if (ImGui::IsItemHovered()) hovered = leaves_of(row);
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
    if (toggled != FLG_NO_INDEX) rows_.toggle(toggled);
    if (!hovered.empty()) {
        hovered_ = std::move(hovered);
        hovered_mesh_ = ornament.mesh_id();
        hovers_row_ = true;
    } else {
        hovers_row_ = false;
    }
}

}  // namespace flg::studio
