// SPDX-License-Identifier: MIT
// Curve Analogies, the baseline of the benchmarks, beside Filigree.
#include <deque>

#include "bench/analogies_scene.h"
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

// Fig. 11, with the same predefined guide: left Curve Analogies, right Filigree.
void analogies(Workshop& workshop, Studio& studio) {
    constexpr struct {
        const char *style, *target;
        float scale, radius;
        glm::vec3 sight;
    } kPairs[] = {{"loops", "s_curve", 0.8f, 0.006f, {-0.1f, -0.12f, -1.0f}},
                  {"zigzag", "flourish", 0.7f, 0.006f, {-0.1f, -0.70f, -1.0f}}};
    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    for (const auto& pair : kPairs) {
        const bench::AnalogiesScene scene = bench::make_analogies_scene(pair.style, pair.target, pair.scale, 1);
        const auto line = [&](const std::vector<Vec3>& points) -> const filigree::CurveSet& {
            scenes::Curve curve;
            for (const Vec3& p : points) curve.points.push_back(to_point(glm::vec3(p.x(), p.y(), p.z())));
            return sets.emplace_back(workshop.curve(curve));
        };
        for (const auto* points : {&scene.theirs.points, &scene.ours.points}) {
            const bool ours = points == &scene.ours.points;
            panels.push_back(panel_of(line(*points).view(), tube(ours ? kTeal : kRed, pair.radius), pair.sight));
            panels.back().layers.push_back(shape_of(line(scene.target).view(), tube(kGrey, 0.0022f)));
        }
        aim_together(std::span(panels).last(2));
    }
    entitle(panels, {"Curve Analogies: loops lean over", "Filigree: loops keep to their plane",
                     "Curve Analogies: the zigzag flattens where the line rises", "Filigree: it does not"});
    studio.take("analogies", panels, 2, kWidth, 720);
}

constexpr Picture kPictures[] = {
    {"analogies", "Fig. 11: Curve Analogies and Filigree with the same guide", true, analogies},
};

}  // namespace

std::span<const Picture> analogies_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
