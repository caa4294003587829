// SPDX-License-Identifier: MIT
// A curve in the picture: its nodes, or what a style made of them.
#pragma once

#include "scene/placed_curves.h"
#include "splines/ornaments.h"

namespace flg::studio::splines {

// Solver, decoration and picture of one curve of the document.
class LiveCurve {
public:
    LiveCurve(AppContext& app, StyleCache& style_cache) : app_(app), solver_(app), decorator_(app, style_cache) {}
    ~LiveCurve() { app_.renderer.remove(drawn_); }
    LiveCurve(const LiveCurve&) = delete;
    LiveCurve& operator=(const LiveCurve&) = delete;

    // Once a frame. `surface` is none while what it lies on is not there: then it stays as it was.
    void update(const Curve& curve, const std::optional<SurfaceLookup::Surface>& surface,
                const std::vector<Obstacle>& obstacles, const SurfaceLookup& surfaces);
    bool busy() const { return solver_.busy() || decorator_.busy(); }
    void device_lost() { drawn_ = {}, shown_ = {}; }

    const FoundCurve& found() const { return solver_.found(); }
    const std::string& error() const { return solver_.error(); }
    // As it is shown, what it lies on being placed so; only while there are nodes. Calls `use` with the view.
    template <class Use>
    void with_view(const Curve& curve, const render::Placement& placement, const Use& use) const {
        if (decorated(curve)) return use(PlacedCurves(decorator_.result().view(), placement).view());
        const NodeArrays nodes(found(), height(curve));
        use(PlacedCurves(nodes.view(), placement).view());
    }
    bool decorated(const Curve& curve) const { return curve.ornament.on && decorator_.result(); }

private:
    struct Shown {
        uint64_t version = 0, decoration = 0;
        CurveLook look;
        bool visible = false, decorated = false;
        render::Placement placement{};
        bool operator==(const Shown&) const = default;
    };
    static float height(const Curve& curve);

    AppContext& app_;
    CurveSolver solver_;
    Decorator decorator_;
    render::CurvesId drawn_{};
    Shown shown_;
};

// How the renderer shows it.
render::CurveLook look_of(const CurveLook& look, float scale);

}  // namespace flg::studio::splines
