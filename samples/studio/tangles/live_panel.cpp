// SPDX-License-Identifier: MIT
// The step that is tried: its numbers and its seeds.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

constexpr int kMaxLines = 40;

// A length, about the one that was proposed.
void length_slider(const char* label, float* value, float proposed, const char* tip) {
    ui::length(label, value, 0.1f * proposed, 8.0f * proposed, tip, true);
}

struct SeedButton {
    const char* name;
    SeedKind kind;
    bool needs_border;
    const char* tip;
};
constexpr SeedButton kSeeds[] = {
    {"Borders", SeedKind::border, true, "Starts at the outer borders of the selection."},
    {"Each", SeedKind::each, true, "Starts at the borders of each region."},
    {"Points", SeedKind::points, false, "Starts at points. Click to add, drag to move, Delete to remove."},
    {"Scatter", SeedKind::samples, false, "Starts at points scattered at random."},
    {"Beads", SeedKind::spaced, true, "Starts at evenly spaced points along the borders."},
    {"Picked", SeedKind::picked, true, "Starts at borders you click, or at stretches you drag along."},
};

bool fits(Action action, SeedKind kind) {
    switch (action) {
        case Action::stream: return kind == SeedKind::border || kind == SeedKind::picked;
        case Action::voronoi: return kind == SeedKind::points || kind == SeedKind::samples;
        case Action::polyline: return kind == SeedKind::points;
        default: return true;
    }
}

}  // namespace

void TanglesWorkspace::draw_live(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    const ActionInfo& info = info_of(live.recipe.action);
    ui::heading(info.name);
    if (ui::row_button("Keep", 2, "Keeps this step. Enter. Other buttons and clicks keep it too."))
        later([this] { keep(); });
    ui::same_row();
    if (ui::row_button("Discard", 2, "Removes this step. Escape.")) later([this] { discard(); });
    if (!live.error.empty()) {
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextColored({1.0f, 0.62f, 0.35f, 1.0f}, "%s", live.error.c_str());
        ImGui::PopTextWrapPos();
    } else if (live.is_made && ornament.idle() &&
               ornament.regions.leaves_below(live.recipe.regions).size() == live.before.outline.leaf_count &&
               live.recipe.action != Action::displace && live.recipe.action != Action::polyline) {
        ui::hint("These settings divide nothing. Try smaller sizes.");
    }
    if (is_operator(live.recipe.action)) draw_seeds(ornament);
    draw_sizes(ornament);
}

void TanglesWorkspace::draw_sizes(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    Recipe& r = live.recipe;
    const Recipe& first = live.first;
    const bool blends = r.action == Action::contour && r.towards.kind != SeedKind::none;
    switch (r.action) {
        case Action::contour:
            if (blends)
                ui::slider("Share", &r.share, 0.02f, 0.9f, "%.2f",
                           "Width of a band, as a share of the way from start to end. More makes fewer, wider bands.");
            else
                length_slider("Width", &r.delta, first.delta, "Width of each band along the surface.");
            ui::slider("Bands", &r.count, 0, kMaxLines, r.count == 0 ? "as many as fit" : "%d",
                       "Most lines to cut. 0 cuts as many as fit.");
            break;
        case Action::stream:
            length_slider("Width", &r.delta, first.delta,
                          "Width of each stripe where it starts. More makes fewer stripes.");
            break;
        case Action::voronoi: break;
        case Action::polyline: ui::toggle("Closed", &r.closed, "Joins the last point to the first."); break;
        case Action::sunburst:
            length_slider("Width", &r.size, first.size,
                          "Width of each ray along the first border. More makes fewer rays.");
            break;
        case Action::polka_dots:
            length_slider("Radius", &r.size, first.size, "Radius of each dot.");
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Least distance between centres. More makes fewer dots.");
            break;
        case Action::frames:
            length_slider("Width", &r.size, first.size, "Width of each frame.");
            ui::slider("Frames##count", &r.count, 1, kMaxLines, "%d", "Number of nested frames.");
            break;
        case Action::flower:
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Least distance between centres. More makes fewer flowers.");
            ui::slider("Petals", &r.count, 1, kMaxLines, "%d", "Number of nested rings of petals.");
            break;
        case Action::grid:
            length_slider("Width", &r.size, first.size,
                          "Width of each column along the first border. More makes fewer columns.");
            ui::slider("Rows", &r.count, 1, kMaxLines, "%d", "Number of rows from border to border.");
            break;
        case Action::outline: length_slider("Width", &r.size, first.size, "Width of the band."); break;
        case Action::lace:
            length_slider("Radius", &r.size, first.size, "Radius of each scallop.");
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Distance between scallops. More makes fewer scallops.");
            break;
        case Action::cells:
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Least distance between centres. More makes fewer, larger cells.");
            break;
        case Action::displace: {
            const float most = 4.0f * first.amount;
            ui::length("Height", &r.amount, -most, most,
                       "Height of the middle above the borders. Below 0, the middle sinks.");
            ui::slider("Bias", &r.bias, 0.05f, 0.95f, "%.2f", "Below 0.5 makes spikes, above 0.5 makes domes.");
            ui::slider("Gain", &r.gain, 0.05f, 0.95f, "%.2f",
                       "Below 0.5 is steep at half height, above 0.5 makes a terrace there.");
            ui::length(
                "Reach", &r.reach, 0.0f, 8.0f * first.amount,
                "Distance from the border at which the full height is reached. More is gentler. 0 reaches it in the "
                "middle of each region.",
                false, true, "to the middle");
            draw_profile(r);
            break;
        }
    }
    if (is_operator(r.action) || is_macro(r.action)) draw_chance(ornament);
}

// What few steps need to be changed in.
void TanglesWorkspace::draw_chance(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    Recipe& r = live.recipe;
    const Recipe& first = live.first;
    const bool has_samples = is_operator(r.action) && (r.from.kind == SeedKind::samples ||
                                                       r.towards.kind == SeedKind::samples || r.perturbation > 0.0f);
    const bool scatters =
        r.action == Action::polka_dots || r.action == Action::flower || r.action == Action::cells || has_samples;
    if (!scatters && !is_operator(r.action)) return;
    if (!ui::section("Advanced", false)) return;
    if (scatters)
        ui::slider("Seed", &r.seed, 1, 99, "%d", "Number of the random choice. Each number scatters differently.");
    if (!is_operator(r.action)) return;
    if (r.action != Action::polyline) {
        const float breadth = live.before.outline.breadth();
        ui::length("Wobble", &r.perturbation, 0.0f, 0.6f * breadth,
                   "Strength of the noise on the lines. More looks drawn by a looser hand.");
        if (r.perturbation > 0.0f)
            ui::slider("Waves", &r.frequency, 0.25f * first.frequency, 8.0f * first.frequency, "%.1f /m",
                       "Waves of the noise per metre. More is finer.", true);
    }
    constexpr const char* kGroupings[] = {"Two, alternating", "One", "One per part", "Several, in turn"};
    ui::choice("Groups##of the step", &r.grouping, kGroupings,
               "Which parts form a group and start with the same colour.");
    if (r.grouping == FLG_TANGLE_GROUPING_CYCLE)
        ui::slider("Group count", &r.cycle, 2, 8, "%d groups", "Parts join this many groups in turn.");
    ui::toggle("Scaffold", &r.scaffold, "Hides the lines of this step. Its regions only help to place others.");
}

void TanglesWorkspace::draw_seeds(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    Recipe& r = live.recipe;
    if (r.action == Action::polyline) {
        ui::hint(("Points on the line: " + std::to_string(r.from.points.size()) + ".").c_str());
        return;
    }
    if (r.action == Action::contour || r.action == Action::stream) {
        if (ui::row_button("From", 2, "Choose where the lines start, here and on the mesh.",
                           {.pressed = !edits_towards_}))
            edits_towards_ = false;
        ui::same_row();
        if (ui::row_button("Towards", 2,
                           "Choose where the lines end, here and on the mesh. Bands then fill the way between.",
                           {.pressed = edits_towards_}))
            edits_towards_ = true;
    } else {
        edits_towards_ = false;
    }
    draw_seed_choice(live, edits_towards_ ? r.towards : r.from, !edits_towards_);
}

void TanglesWorkspace::draw_seed_choice(LiveStep& live, SeedChoice& seeds, bool is_from) {
    const bool has_border = !live.before.outline.loops.empty();
    int shown = 0;
    const auto next = [&] {
        if (shown++ % 4 != 0) ui::same_row();
    };
    if (!is_from) {
        next();
        if (ui::row_button("Nothing", 4, "The lines run outwards as far as there is room.",
                           {.pressed = seeds.kind == SeedKind::none}))
            seeds.kind = SeedKind::none;
    }
    for (const SeedButton& button : kSeeds) {
        if (is_from && !fits(live.recipe.action, button.kind)) continue;
        next();
        if (!ui::row_button(button.name, 4, button.tip,
                            {.enabled = has_border || !button.needs_border, .pressed = seeds.kind == button.kind}))
            continue;
        seeds.kind = button.kind;
        if (button.kind == SeedKind::picked && seeds.stretches.empty()) {
            // So that something is seen at once: the first border, or the second where it goes towards.
            const auto last = static_cast<uint32_t>(live.before.outline.loops.size() - 1);
            seeds.stretches.push_back({is_from ? 0 : std::min(1u, last), 0.0f, 1.0f});
        }
    }
    if (seeds.kind == SeedKind::samples)
        length_slider("Scattering", &seeds.radius, live.first.from.radius,
                      "Least distance between points. More makes fewer points.");
    if (seeds.kind == SeedKind::spaced)
        length_slider("Between beads", &seeds.spacing, live.first.from.spacing,
                      "Distance along the border. More makes fewer points.");
    if (seeds.kind == SeedKind::points && !seeds.points.empty()) {
        ImGui::AlignTextToFramePadding();
        ui::hint((std::to_string(seeds.points.size()) + (seeds.points.size() == 1 ? " point" : " points")).c_str());
        ui::same_row();
        if (ui::button("Clear points", "Removes all points.")) seeds.points.clear();
    }
}

void TanglesWorkspace::draw_profile(const Recipe& recipe) {
    const float unit = app_.scale, height = 46.0f * unit, width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ui::tip("Profile from the border (left) to the middle (right).");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, IM_COL32(0, 0, 0, 60), 3.0f * unit);
    ImVec2 line[65];
    for (int i = 0; i <= 64; ++i) {
        const float t = static_cast<float>(i) / 64.0f;
        // Schlick (1994), as flgTangleDisplace has it.
        const float biased = t / ((1.0f / recipe.bias - 2.0f) * (1.0f - t) + 1.0f);
        const float slope = (1.0f / recipe.gain - 2.0f) * (1.0f - 2.0f * biased);
        float h = biased < 0.5f ? biased / (slope + 1.0f) : (slope - biased) / (slope - 1.0f);
        if (recipe.amount < 0.0f) h = 1.0f - h;
        line[i] = {low.x + (0.03f + 0.94f * t) * width, low.y + (0.92f - 0.84f * h) * height};
    }
    list.AddPolyline(line, 65, IM_COL32(250, 190, 100, 255), 0, 1.8f * unit);
}

}  // namespace flg::studio
