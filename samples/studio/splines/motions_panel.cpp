// SPDX-License-Identifier: MIT
#include <cstdio>

#include "shell/widgets.h"
#include "splines/bodies.h"
#include "splines/panel.h"

namespace flg::studio::splines {
namespace {

constexpr const char* kEnergies[] = {"Smooth", "Straight between keys", "Taut"};
constexpr const char* kInertias[] = {"The body's own", "A ball", "A rod along its nose"};
constexpr double kShortest = 0.05, kLongest = 10.0;  // seconds from key to key

void player(SplineEditor& editor, const Motion& motion) {
    const LiveMotion* const live = editor.live_motion(motion.id);
    const bool ready = live != nullptr && live->found().poses.size() > 1;
    if (ui::row_button(editor.playing ? "Pause" : "Play", 2, "Plays or pauses the motion. Space.",
                       {.enabled = ready, .pressed = editor.playing}))
        editor.play(!editor.playing);
    ui::same_row();
    if (ui::row_button("To the start", 2, "Returns the body to the first key. Home.", {.enabled = ready}) && ready)
        editor.seconds = live->found().begin();
    const float begin = ready ? static_cast<float>(live->found().begin()) : 0.0f;
    const float end = ready ? static_cast<float>(live->found().end()) : 1.0f;
    auto seconds = static_cast<float>(editor.seconds);
    if (ui::slider("Time", &seconds, begin, end, "%.2f s", "Time since the first key. Drag to scrub.", false, ready)) {
        editor.seconds = static_cast<double>(seconds);
        editor.playing = false;
    }
}

void key_widgets(SplineEditor& editor, Motion& motion) {
    const auto index = static_cast<size_t>(editor.key);
    if (editor.key < 0 || index >= motion.keys.size()) {
        ui::hint("Click a key to turn it by its rings or to change its time.");
        return;
    }
    char title[48];
    std::snprintf(title, sizeof title, "Key %zu", index + 1);
    ui::heading(title);
    if (index > 0) {
        const double before = motion.keys[index - 1].time;
        auto gap = static_cast<float>(motion.keys[index].time - before);
        if (ui::slider("Duration", &gap, static_cast<float>(kShortest), static_cast<float>(kLongest), "%.2f s",
                       "Time from the previous key to this one. Later keys keep their spacing.", true)) {
            const double by = static_cast<double>(gap) - (motion.keys[index].time - before);
            for (size_t i = index; i < motion.keys.size(); ++i) motion.keys[i].time += by;
        }
    }
    if (ui::row_button("Remove key", 1, "Removes the selected key. Delete.")) editor.remove_key(motion, editor.key);
}

// In between the keys, where the body is just now.
void insert_key(SplineEditor& editor, Motion& motion) {
    const LiveMotion* const live = editor.live_motion(motion.id);
    const bool ready = live != nullptr && live->found().poses.size() > 1;
    bool free = ready;
    size_t at = 0;
    for (const Key& key : motion.keys) {
        if (key.time < editor.seconds) ++at;
        if (std::abs(key.time - editor.seconds) < kShortest) free = false;
    }
    if (!ui::row_button("Add key here", 2, "Adds a key at the current time.", {.enabled = free})) return;
    const Pose pose = live->found().at(editor.seconds);
    motion.keys.insert(motion.keys.begin() + static_cast<std::ptrdiff_t>(at),
                       Key{editor.seconds, pose.place, pose.turn});
    editor.key = static_cast<int>(at);
}

void shape_widgets(SplineEditor& editor, Motion& motion) {
    if (!ui::section("Motion")) return;
    ui::choice("Body", &motion.body, body_names(), "Body that moves.");
    auto size = static_cast<float>(motion.size);
    const auto whole = static_cast<float>(editor.size());
    if (ui::length("Length", &size, 0.02f * whole, 1.0f * whole,
                   "Length of the body. More also keeps it farther from obstacles.", true))
        motion.size = static_cast<double>(size);
    ui::toggle("Closed", &motion.closed, "Joins the last key to the first and loops. Needs three keys.",
               motion.keys.size() > 2);
    if (!ui::section("Advanced", false)) return;
    int inertia = static_cast<int>(motion.inertia);
    if (ui::choice("Inertia", &inertia, kInertias,
                   "Distribution of weight. A long body turns more easily about its length than across it."))
        motion.inertia = static_cast<Inertia>(inertia);
    int energy = motion.energy;
    if (ui::choice("Path", &energy, kEnergies,
                   "Smooth paths turn evenly. Straight paths turn at the keys. Taut paths lie between the two."))
        motion.energy = static_cast<FlgSplineEnergy>(energy);
    if (motion.energy == FLG_SPLINE_ENERGY_ET) {
        auto tension = static_cast<float>(motion.tension);
        if (ui::slider("Tension", &tension, 0.1f, 1e4f, "%.3g /s\xc2\xb2",
                       "Pull on the motion. More makes it straighter between keys.", true))
            motion.tension = static_cast<double>(tension);
    }
    ui::toggle("Avoid obstacles", &motion.avoid, "Leads the whole body around all obstacles.");
    ui::slider("Ghosts", &motion.ghosts, 0, 40, "%d", "Number of pale copies along the path.");
    ui::text("Name", &motion.name, "Name of the motion in the list and in files.");
}

}  // namespace

void motions_panel(SplineEditor& editor) {
    Motion* motion = editor.chosen_motion();
    ground_choice(editor, motion != nullptr ? &motion->ground : nullptr);
    // One without keys is as good as another.
    if (ui::row_button("New motion", 1, "Starts another motion. N.",
                       {.enabled = motion != nullptr && !motion->keys.empty()}))
        editor.add_motion(editor.ground_now());
    for (Motion& each : editor.document.motions) {
        ui::toggle(("##show motion " + std::to_string(each.id)).c_str(), &each.visible, "Shows or hides this motion.");
        ui::same_row();
        const uint32_t id = each.id;
        const Row row = list_row(each.name, id, id == editor.motion, "motion");
        if (row == Row::removed) {
            editor.remove_motion(id);
            break;
        }
        if (row == Row::chosen && id != editor.motion) {
            editor.motion = id;
            editor.key = -1;
            editor.playing = false;
        }
    }
    motion = editor.chosen_motion();
    if (motion == nullptr || motion->keys.empty()) {
        ui::hint("Click to place keys for the body. Press and drag to set where its nose points.");
        if (motion == nullptr) return;
    }
    player(editor, *motion);
    insert_key(editor, *motion);
    const LiveMotion* const live = editor.live_motion(motion->id);
    if (live != nullptr && !live->error().empty()) ui::hint(("No motion: " + live->error() + ".").c_str());
    if (live != nullptr && live->found().poses.size() > 1) {
        ui::hint("Done.");
        char text[160];
        std::snprintf(text, sizeof text, "%zu positions, %u iterations%s, energy %.3g.", live->found().poses.size(),
                      live->found().rounds, in_milliseconds(editor.app, live->found().busy_ms).c_str(),
                      live->found().energy);
        ui::tip(text);
    }
    key_widgets(editor, *motion);
    motion = editor.chosen_motion();
    if (motion != nullptr) shape_widgets(editor, *motion);
}

}  // namespace flg::studio::splines
