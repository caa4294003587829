// SPDX-License-Identifier: MIT
// A camera path as a track.
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "gallery/sweep.h"

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

// Posts from a track down to the ground.
std::vector<scenes::Curve> posts(const FlgCurveSetView& track, uint32_t count) {
    const std::vector<glm::vec3> points = vectors_of(track);
    std::vector<scenes::Curve> list;
    for (uint32_t k = 0; k < count; ++k) {
        const glm::vec3 p = points[points.size() * k / count];
        list.emplace_back().points = {{p.x, -0.05f, p.z}, {p.x, p.y - 0.01f, p.z}};
    }
    return list;
}

// The track is a slab, red above and gold below.
Panel track_of(const Sweep& sweep, const filigree::CurveSet& stands) {
    Panel panel;
    panel.layers = {shape_of(stands.view(), tube(kGrey, 0.005f))};
    render::SurfaceLook look;
    look.regions = {{kRed, 0.0f, 0.4f}, {kGold, 0.0f, 0.4f}, {kInk, 0.0f, 0.5f}};
    panel.surfaces = {{sweep.view(), look}};
    panel.sight = {-0.35f, -0.45f, -1.0f};
    panel.margin = 1.05f;
    return panel;
}

void coaster(Workshop& workshop, Studio& studio) {
    constexpr float kHalfWidth = 0.055f, kThickness = 0.012f;
    constexpr uint32_t kPosts = 30;
    const filigree::CurveSet target = workshop.curve(make_target("coaster"));
    const FlgStyleAttribute angle[] = {{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.01f, 0}};
    const filigree::Style style = workshop.style(workshop.curve(make_style("twist")), angle);
    FlgCurveSetStylizeDesc desc = sized(style, 0.075f);
    desc.frame = FLG_FRAME_METHOD_SUPPLIED;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    const filigree::CurveSet below = workshop.curves(posts(target.view(), kPosts)),
                             below_result = workshop.curves(posts(result.view(), kPosts));
    const auto width = [](uint32_t) { return kHalfWidth; };
    const Sweep bare = Sweep::bands(target.view(), kThickness, width),
                rolled = Sweep::bands(result.view(), kThickness, width);
    Panel panels[] = {track_of(bare, below), track_of(rolled, below_result)};
    aim_together(panels);
    entitle(panels, {"Banked, as the camera path is", "Rolling over, as the style does"});
    studio.take("coaster", panels, 1, 720, 720);
}

constexpr Picture kPictures[] = {
    {"coaster", "Sec. 5.2: a camera path whose ribbon rolls as its example does", true, coaster},
};

}  // namespace

std::span<const Picture> coaster_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
