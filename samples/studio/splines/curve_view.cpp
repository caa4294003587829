// SPDX-License-Identifier: MIT
#include "splines/curve_view.h"

namespace flg::studio::splines {
namespace {

constexpr float kLinePx = 3.0f;
// Bands and lines lie over the surface, so that it does not come through; tubes are sunk into it by half.
constexpr float kBandHeight = 0.35f, kTubeHeight = 0.35f, kOrnamentHeight = 0.8f;
// And of what a style swings away: upright ones stand on the surface, flat ones have some thickness too.
constexpr float kUprightHeight = 0.9f, kFlatHeight = 0.2f;
// Decorated curves are drawn thinner, so that their turns stay apart.
constexpr float kOrnamentThinning = 0.55f;

}  // namespace

render::CurveLook look_of(const CurveLook& look, float scale) {
    render::CurveLook out;
    out.shape = look.form == Form::tube     ? render::Shape::tube
                : look.form == Form::ribbon ? render::Shape::ribbon
                                            : render::Shape::line;
    out.color = out.color_end = look.color;
    out.radius = look.radius;
    out.line_width_px = kLinePx * scale;
    out.gloss = 0.5f;
    return out;
}

float LiveCurve::height(const Curve& curve) {
    const Ornament& ornament = curve.ornament;
    if (ornament.on)
        return kOrnamentHeight * curve.look.radius +
               (ornament.flat ? kFlatHeight : kUprightHeight) * ornament.size * ornament.magnitude;
    return (curve.look.form == Form::tube ? kTubeHeight : kBandHeight) * curve.look.radius;
}

void LiveCurve::update(const Curve& curve, const std::optional<SurfaceLookup::Surface>& surface,
                       const std::vector<Obstacle>& obstacles, const SurfaceLookup& surfaces) {
    if (surface && curve.points.size() > 1)
        solver_.want(problem_of(curve, *surface, obstacles), curve.name);
    else if (curve.points.size() < 2)
        solver_.want(std::nullopt, curve.name);
    solver_.update(curve.ground, surfaces);
    decorator_.update(found(), solver_.version(), curve.ornament, height(curve), curve.name);
    const bool is_seen =
        curve.visible && !found().nodes.empty() && surfaces.is_seen(curve.ground) && app_.scene.in_sight();
    const Shown wanted{solver_.version(), decorator_.version(), curve.look,
                       is_seen,           decorated(curve),     surfaces.placement(curve.ground)};
    if (wanted == shown_ && (drawn_.value != 0) == wanted.visible) return;
    shown_ = wanted;
    if (!wanted.visible) {
        app_.renderer.remove(std::exchange(drawn_, {}));
        return;
    }
    render::CurveLook look = look_of(curve.look, app_.scale);
    if (wanted.decorated) look.radius_scale = kOrnamentThinning;
    look.radius *= wanted.placement.scale;
    with_view(curve, wanted.placement, [&](const FlgCurveSetView& view) {
        if (drawn_.value == 0)
            drawn_ = app_.renderer.upload(view, look);
        else
            app_.renderer.update(drawn_, view, look);
    });
}

}  // namespace flg::studio::splines
