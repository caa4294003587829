// SPDX-License-Identifier: MIT
// The step that is tried: its numbers and its seeds.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

constexpr int kMostLines = 40;

// A length, about the one that was proposed.
void length_slider(const char* label, float* value, float proposed, const char* tip) {
    ui::slider(label, value, 0.1f * proposed, 8.0f * proposed, proposed < 0.02f ? "%.4f m" : "%.3f m", tip, true);
}

struct SeedButton {
    const char* name;
    SeedKind kind;
    bool needs_border;
    const char* tip;
};
constexpr SeedButton kSeeds[] = {
    {"Borders", SeedKind::border, true, "From the borders of the selected regions together."},
    {"Each", SeedKind::each, true, "From the borders of each region by itself."},
    {"Points", SeedKind::points, false, "From points: click to add, drag to move, Delete takes one away."},
    {"Scatter", SeedKind::samples, false, "From points scattered evenly by chance."},
    {"Beads", SeedKind::spaced, true, "From points evenly along the borders."},
    {"Picked", SeedKind::picked, true, "From borders that you click, or stretches that you drag along."},
};

bool fits(Deed deed, SeedKind kind) {
    switch (deed) {
        case Deed::stream: return kind == SeedKind::border || kind == SeedKind::picked;
        case Deed::voronoi: return kind == SeedKind::points || kind == SeedKind::samples;
        case Deed::polyline: return kind == SeedKind::points;
        default: return true;
    }
}

}  // namespace

void TanglesWorkspace::draw_live(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    const DeedInfo& info = info_of(live.recipe.deed);
    ui::heading(info.name);
    if (ui::row_button("Keep", 2, "Keeps the step as it is. Enter. Other buttons and clicks keep it too."))
        later([this] { keep(); });
    ui::same_row();
    if (ui::row_button("Discard", 2, "Takes the step back. Escape.")) later([this] { discard(); });
    if (!live.error.empty()) {
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextColored({1.0f, 0.62f, 0.35f, 1.0f}, "%s", live.error.c_str());
        ImGui::PopTextWrapPos();
    } else if (live.is_made && ornament.idle() &&
               ornament.regions.leaves_below(live.recipe.regions).size() == live.before.outline.leaf_count &&
               live.recipe.deed != Deed::displace && live.recipe.deed != Deed::polyline) {
        ui::hint("Nothing is divided by these numbers: try smaller sizes.");
    }
    if (is_operator(live.recipe.deed)) draw_seeds(ornament);
    draw_sizes(ornament);
}

void TanglesWorkspace::draw_sizes(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    Recipe& r = live.recipe;
    const Recipe& first = live.first;
    const bool blends = r.deed == Deed::contour && r.towards.kind != SeedKind::none;
    switch (r.deed) {
        case Deed::contour:
            if (blends)
                ui::slider("Share", &r.share, 0.02f, 0.9f, "%.2f",
                           "Of the way from the seeds to those it goes towards: more makes fewer, wider bands.");
            else
                length_slider("Width", &r.delta, first.delta, "Of each band, metres along the surface: more is wider.");
            ui::slider("Bands", &r.count, 0, kMostLines, r.count == 0 ? "as many as fit" : "%d",
                       "How many lines at most; 0: as many as there is room for.");
            break;
        case Deed::stream:
            length_slider("Width", &r.delta, first.delta, "Of each stripe where it begins, metres: more makes fewer.");
            break;
        case Deed::voronoi: break;
        case Deed::polyline: ui::toggle("Closed", &r.closed, "From the last point back to the first one."); break;
        case Deed::sunburst:
            length_slider("Width", &r.size, first.size,
                          "Of each ray along the first border, metres: more makes fewer.");
            break;
        case Deed::polka_dots:
            length_slider("Radius", &r.size, first.size, "Of each dot, metres: more is larger.");
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Between dots' centres, at least, metres: more makes fewer.");
            break;
        case Deed::frames:
            length_slider("Width", &r.size, first.size, "Of each frame, metres: more is wider.");
            ui::slider("Frames##count", &r.count, 1, kMostLines, "%d", "How many, one in the other.");
            break;
        case Deed::flower:
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Between flowers' centres, at least, metres: more makes fewer.");
            ui::slider("Petals", &r.count, 1, kMostLines, "%d", "Rings of petals one in the other.");
            break;
        case Deed::grid:
            length_slider("Width", &r.size, first.size,
                          "Of each column along the first border, metres: more makes fewer.");
            ui::slider("Rows", &r.count, 1, kMostLines, "%d", "From border to border.");
            break;
        case Deed::outline: length_slider("Width", &r.size, first.size, "Of the band, metres: more is wider."); break;
        case Deed::lace:
            length_slider("Radius", &r.size, first.size, "Of each scallop, metres: more is larger.");
            length_slider("Spacing", &r.spacing, first.spacing, "Between scallops, metres: more makes fewer.");
            break;
        case Deed::cells:
            length_slider("Spacing", &r.spacing, first.spacing,
                          "Between cells' centres, at least, metres: more makes fewer, larger ones.");
            break;
        case Deed::displace: {
            const float most = 4.0f * first.amount;
            ui::slider("Height", &r.amount, -most, most, first.amount < 0.02f ? "%.4f m" : "%.3f m",
                       "Of the middle above the borders, metres: more is higher, below 0 sinks.");
            ui::slider("Bias", &r.bias, 0.05f, 0.95f, "%.2f", "Below 0.5 spikes, above it domes.");
            ui::slider("Gain", &r.gain, 0.05f, 0.95f, "%.2f",
                       "Below 0.5 steep at half height, above it a terrace there.");
            ui::slider("Reach", &r.reach, 0.0f, 8.0f * first.amount, r.reach == 0.0f ? "to the middle" : "%.3f m",
                       "How far from the border the full height is reached, metres; more is gentler, 0: in each "
                       "region's middle.");
            draw_profile(r);
            break;
        }
    }
    const bool has_samples = is_operator(r.deed) && (r.from.kind == SeedKind::samples ||
                                                     r.towards.kind == SeedKind::samples || r.perturbation > 0.0f);
    const bool scatters = r.deed == Deed::polka_dots || r.deed == Deed::flower || r.deed == Deed::cells || has_samples;
    if (scatters)
        ui::slider("Chance", &r.seed, 1, 99, "%d",
                   "Which of the many ways that chance has: each number is another, always the same.");
    if (!is_operator(r.deed)) return;
    if (r.deed != Deed::polyline) {
        const float breadth = live.before.outline.breadth();
        ui::slider("Wobble", &r.perturbation, 0.0f, 0.6f * breadth, "%.3f m",
                   "Noise on the distances, metres: more looks drawn by a looser hand.");
        if (r.perturbation > 0.0f)
            ui::slider("Waves", &r.frequency, 0.25f * first.frequency, 8.0f * first.frequency, "%.1f /m",
                       "Of that noise, in a metre: more is finer.", true);
    }
    constexpr const char* kGroupings[] = {"Two: every other one", "One", "Each by itself", "In turn"};
    ui::choice("Groups##of the step", &r.grouping, kGroupings,
               "Which parts belong together, and have one colour at first.");
    if (r.grouping == FLG_TANGLE_GROUP_CYCLE)
        ui::slider("In turn##cycle", &r.cycle, 2, 8, "%d groups", "Parts are dealt to so many groups in turn.");
    ui::toggle("Scaffold", &r.scaffold, "Its lines are not seen: its regions only help to place others.");
}

void TanglesWorkspace::draw_seeds(Ornament& ornament) {
    LiveStep& live = *ornament.live;
    Recipe& r = live.recipe;
    if (r.deed == Deed::polyline) {
        ui::hint(("Line of " + std::to_string(r.from.points.size()) + " points.").c_str());
        return;
    }
    if (r.deed == Deed::contour || r.deed == Deed::stream) {
        ui::hint("It goes ...");
        if (ui::row_button("From", 2, "Choose here, and on the mesh, what it begins at.", {.pressed = !edits_towards_}))
            edits_towards_ = false;
        ui::same_row();
        if (ui::row_button(
                "Towards", 2,
                "Choose here, and on the mesh, what it goes towards: bands then fill the way from one to the other.",
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
        if (ui::row_button("Nothing", 4, "It goes outwards, as far as there is room.",
                           {.pressed = seeds.kind == SeedKind::none}))
            seeds.kind = SeedKind::none;
    }
    for (const SeedButton& button : kSeeds) {
        if (is_from && !fits(live.recipe.deed, button.kind)) continue;
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
                      "Between points, at least, metres: more makes fewer.");
    if (seeds.kind == SeedKind::spaced)
        length_slider("Between beads", &seeds.spacing, live.first.from.spacing,
                      "Metres along the border: more makes fewer.");
    if (seeds.kind == SeedKind::points && !seeds.points.empty()) {
        ImGui::AlignTextToFramePadding();
        ui::hint((std::to_string(seeds.points.size()) + (seeds.points.size() == 1 ? " point" : " points")).c_str());
        ui::same_row();
        if (ui::button("Clear the points", "Takes all points away.")) seeds.points.clear();
    }
}

void TanglesWorkspace::draw_profile(const Recipe& recipe) {
    const float unit = desk_.scale, height = 46.0f * unit, width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ui::tip("The profile from a border (left) to the middle (right).");
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
