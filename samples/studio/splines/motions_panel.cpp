// SPDX-License-Identifier: MIT
#include <cstdio>

#include "shell/widgets.h"
#include "splines/bodies.h"
#include "splines/panel.h"

namespace flg::studio::splines {
namespace {

constexpr const char* kEnergies[] = {"Smooth throughout", "Free flight between keys", "In between"};
constexpr const char* kInertias[] = {"Of the body as it is", "Of a ball", "Of a rod along its nose"};
constexpr double kShortest = 0.05, kLongest = 10.0;  // seconds from key to key

void player(Stage& stage, const Motion& motion) {
    const LiveMotion* const live = stage.live_motion(motion.id);
    const bool ready = live != nullptr && live->found().poses.size() > 1;
    if (ui::row_button(stage.playing ? "Pause" : "Play", 2, "Plays the motion from here. (Space)",
                       {.enabled = ready, .pressed = stage.playing}))
        stage.play(!stage.playing);
    ui::same_row();
    if (ui::row_button("To the start", 2, "Puts the body back to where it begins. (Home)", {.enabled = ready}) && ready)
        stage.seconds = live->found().begin();
    const float begin = ready ? static_cast<float>(live->found().begin()) : 0.0f;
    const float end = ready ? static_cast<float>(live->found().end()) : 1.0f;
    auto seconds = static_cast<float>(stage.seconds);
    if (ui::slider("Time", &seconds, begin, end, "%.2f s",
                   "When the body is shown, seconds since the first key. Drag to scrub.", false, ready)) {
        stage.seconds = static_cast<double>(seconds);
        stage.playing = false;
    }
}

void key_widgets(Stage& stage, Motion& motion) {
    const auto index = static_cast<size_t>(stage.key);
    if (stage.key < 0 || index >= motion.keys.size()) {
        ui::hint("Click a key's dot to turn it by its rings, or to change its time.");
        return;
    }
    char title[48];
    std::snprintf(title, sizeof title, "Key %zu", index + 1);
    ui::heading(title);
    if (index > 0) {
        const double before = motion.keys[index - 1].time;
        auto gap = static_cast<float>(motion.keys[index].time - before);
        if (ui::slider("Seconds to here", &gap, static_cast<float>(kShortest), static_cast<float>(kLongest), "%.2f s",
                       "How long the body takes from the key before to this one. More: slower. Later keys move along.",
                       true)) {
            const double by = static_cast<double>(gap) - (motion.keys[index].time - before);
            for (size_t i = index; i < motion.keys.size(); ++i) motion.keys[i].time += by;
        }
    }
    if (ui::row_button("Remove key", 1, "Removes the key with the rings. (Delete)"))
        stage.remove_key(motion, stage.key);
}

// In between the keys, where the body is just now.
void insert_key(Stage& stage, Motion& motion) {
    const LiveMotion* const live = stage.live_motion(motion.id);
    const bool ready = live != nullptr && live->found().poses.size() > 1;
    bool free = ready;
    size_t at = 0;
    for (const Key& key : motion.keys) {
        if (key.time < stage.seconds) ++at;
        if (std::abs(key.time - stage.seconds) < kShortest) free = false;
    }
    if (!ui::row_button("Key at this time", 2, "Puts a key where the body is now, to be moved or turned.",
                        {.enabled = free}))
        return;
    const Pose pose = live->found().at(stage.seconds);
    motion.keys.insert(motion.keys.begin() + static_cast<std::ptrdiff_t>(at),
                       Key{stage.seconds, pose.place, pose.turn});
    stage.key = static_cast<int>(at);
}

void shape_widgets(Stage& stage, Motion& motion) {
    ui::heading("Motion");
    ui::choice("Body", &motion.body, body_names(), "What moves.");
    auto size = static_cast<float>(motion.size);
    const auto whole = static_cast<float>(stage.size());
    if (ui::slider("Length", &size, 0.02f * whole, 1.0f * whole, "%.3f m",
                   "Of the body, metres. More: larger, and farther away from obstacles.", true))
        motion.size = static_cast<double>(size);
    int inertia = static_cast<int>(motion.inertia);
    if (ui::choice(
            "Turns with the weight", &inertia, kInertias,
            "Long bodies rather turn about their length than across it: the weight decides how the turns are spread."))
        motion.inertia = static_cast<Inertia>(inertia);
    int energy = motion.energy;
    if (ui::choice("Flies", &energy, kEnergies,
                   "Smooth: no kicks anywhere. Free flight: straight between keys, with a kick at each. In between: "
                   "tension decides."))
        motion.energy = static_cast<FlgSplineEnergy>(energy);
    if (motion.energy == FLG_SPLINE_ET) {
        auto tension = static_cast<float>(motion.tension);
        if (ui::slider("Tension", &tension, 0.1f, 1e4f, "%.3g /s\xc2\xb2",
                       "How hard the motion is pulled, per square second. More: straighter between keys.", true))
            motion.tension = static_cast<double>(tension);
    }
    ui::toggle("Closed", &motion.closed,
               "Goes from the last key back to the first, and plays over and over. Needs three keys.",
               motion.keys.size() > 2);
    ui::toggle("Avoid obstacles", &motion.avoid, "The whole body keeps out of all obstacles.");
    ui::slider("Ghosts", &motion.ghosts, 0, 40, "%d", "Pale copies of the body along its way. More: closer together.");
    ui::text("Name", &motion.name, "What the motion is called in the list and in files.");
}

}  // namespace

void motions_panel(Stage& stage) {
    Motion* motion = stage.chosen_motion();
    ground_choice(stage, motion != nullptr ? &motion->ground : nullptr);
    // One without keys is as good as another.
    if (ui::row_button("New motion", 1, "Begins another motion; clicks put its keys. (N)",
                       {.enabled = motion != nullptr && !motion->keys.empty()}))
        stage.add_motion(stage.ground_now());
    for (Motion& each : stage.document.motions) {
        ui::toggle(("##show motion " + std::to_string(each.id)).c_str(), &each.visible,
                   "Whether this motion is shown.");
        ui::same_row();
        const uint32_t id = each.id;
        const Row row = list_row(each.name, id, id == stage.motion, "motion");
        if (row == Row::removed) {
            stage.remove_motion(id);
            break;
        }
        if (row == Row::chosen && id != stage.motion) {
            stage.motion = id;
            stage.key = -1;
            stage.playing = false;
        }
    }
    motion = stage.chosen_motion();
    if (motion == nullptr || motion->keys.empty()) {
        ui::hint(
            "Click where the body is to be, one key after another; go on pressing and drag to say where its nose "
            "points.");
        if (motion == nullptr) return;
    }
    player(stage, *motion);
    insert_key(stage, *motion);
    const LiveMotion* const live = stage.live_motion(motion->id);
    if (live != nullptr && !live->error().empty()) ui::hint(("It can't be: " + live->error()).c_str());
    if (live != nullptr && live->found().poses.size() > 1) {
        char text[160];
        std::snprintf(text, sizeof text, "%zu positions, %u rounds%s, energy %.3g.", live->found().poses.size(),
                      live->found().rounds, in_milliseconds(stage.desk, live->found().busy_ms).c_str(),
                      live->found().energy);
        ui::hint(text);
    }
    key_widgets(stage, *motion);
    motion = stage.chosen_motion();
    if (motion != nullptr) shape_widgets(stage, *motion);
}

}  // namespace flg::studio::splines
