// SPDX-License-Identifier: MIT
// Filigree and Curve Analogies side by side (sec. 7 and Fig. 11 of the paper): all built-in styles, each on a target
// with an inflection (s_curve) and on one of high torsion (flourish), with the same predefined guide. The worst style
// counts.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/analogies_scene.h"
#include "bench/groups.h"
#include "filigree/filigree.h"
#include "scenes/scenes.h"
#include "stylization/seam_blend.h"

namespace flg::bench {
namespace {

constexpr double kSpeedBar = 30.0;
// Of the displacement's rms: rounding of results to float.
constexpr double kLeanBar = 1e-3;
constexpr float kScale = 1.0f;
constexpr int kAnalogyRuns = 3;
constexpr uint32_t kNoBlending = 0;

// How far the style leans over: the largest change of the displacement's part along the curve, over the displacement's
// rms. Nothing changes it but a rotation out of the curve's cross-section, so that turning about the curve is no error;
// what seams between runs are blended with over `patch` points is none either.
double lean_of(const AnalogiesScene& scene, const Analogy& result, uint32_t patch) {
    double sum_sq = 0.0, largest = 0.0;
    for (size_t i = 0; i < scene.guide.size(); ++i) sum_sq += (scene.style[i] - scene.guide[i]).squaredNorm();
    const auto along = [&](size_t node) {
        return (scene.style[node] - scene.guide[node]).dot(scene.guide_tangents[node]);
    };
    SeamBlend blend(patch);
    for (size_t i = 0; i < result.points.size(); ++i) {
        if (i > 0 && patch != kNoBlending) {
            blend.step(result.matches[i - 1], result.matches[i],
                       [&](uint32_t node) { return Vec3(along(node), 0.0, 0.0); });
        }
        const double own = along(result.matches[i]) + blend.offset().x();
        const double copied = (result.points[i] - scene.target[i]).dot(scene.target_tangents[i]);
        largest = std::max(largest, std::abs(copied - own));
    }
    return largest / std::sqrt(sum_sq / static_cast<double>(scene.guide.size()));
}

// Places where the result does not go on with the style's next point.
uint32_t seams_of(const Analogy& result) {
    uint32_t count = 0;
    for (size_t i = 1; i < result.matches.size(); ++i) count += result.matches[i] != result.matches[i - 1] + 1;
    return count;
}

}  // namespace

std::vector<Row> run_analogies() {
    double cold = 1e30, warm = 1e30, theirs_least_lean = 1e30, theirs_lean = 0.0, lean = 0.0;
    uint32_t seams = 0, theirs_seams = 0;
    const uint32_t patch = flgStyleDefaults().patch;
    char cold_note[128] = "", warm_note[128] = "";
    for (const std::string& style : scenes::style_names()) {
        for (const char* target : {"s_curve", "flourish"}) {
            const AnalogiesScene scene = make_analogies_scene(style, target, kScale, kAnalogyRuns);
            const auto describe = [&](char(&note)[128], double ours_ms) {
                std::snprintf(note, sizeof note, "%s on %s, %zu points: %.3g ms against %.3g ms", style.c_str(), target,
                              scene.target.size(), ours_ms, scene.theirs_ms);
                return scene.theirs_ms / ours_ms;
            };
            char note[128];
            if (describe(note, scene.cold_ms) < cold) cold = describe(cold_note, scene.cold_ms);
            if (describe(note, scene.warm_ms) < warm) warm = describe(warm_note, scene.warm_ms);
            const double theirs = lean_of(scene, scene.theirs, kNoBlending);
            theirs_lean = std::max(theirs_lean, theirs);
            theirs_least_lean = std::min(theirs_least_lean, theirs);
            lean = std::max(lean, lean_of(scene, scene.ours, patch));
            seams += seams_of(scene.ours);
            theirs_seams += seams_of(scene.theirs);
        }
    }
    char lean_note[128];
    std::snprintf(lean_note, sizeof lean_note, "Curve Analogies: %.2g to %.2g; it makes %u seams, ours %u",
                  theirs_least_lean, theirs_lean, theirs_seams, seams);
    return {at_least("Curve Analogies at equal guide: speed over it, with matching and graph", cold, "x", kSpeedBar,
                     cold_note),
            at_least("Curve Analogies at equal guide: speed over it, prepared style", warm, "x", kSpeedBar, warm_note),
            below("style leaning over at inflections and torsion, of its size", lean, "", kLeanBar, lean_note)};
}

}  // namespace flg::bench
