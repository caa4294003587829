// SPDX-License-Identifier: MIT
// A curve in the picture: its nodes, or what a style made of them.
#pragma once

#include "splines/ornaments.h"

namespace flg::studio::splines {

// Solver, decoration and picture of one curve of the document.
class LiveCurve {
public:
    LiveCurve(Desk& desk, StyleShelf& shelf) : desk_(desk), solver_(desk), decorator_(desk, shelf) {}
    ~LiveCurve() { desk_.renderer.remove(drawn_); }
    LiveCurve(const LiveCurve&) = delete;
    LiveCurve& operator=(const LiveCurve&) = delete;

    // Once a frame. `surface` is none while what it lies on is not there: then it stays as it was.
    void update(const Curve& curve, const std::optional<Grounds::Surface>& surface,
                const std::vector<Obstacle>& obstacles, const Grounds& grounds);
    bool busy() const { return solver_.busy() || decorator_.busy(); }
    void device_lost() { drawn_ = {}, shown_ = {}; }

    const FoundCurve& found() const { return solver_.found(); }
    const std::string& error() const { return solver_.error(); }
    // As it is shown; only while there are nodes. Calls `use` with the view.
    template <class Use>
    void with_view(const Curve& curve, const Use& use) const {
        if (decorated(curve)) return use(decorator_.result().view());
        const NodeArrays nodes(found(), height(curve));
        use(nodes.view());
    }
    bool decorated(const Curve& curve) const { return curve.ornament.on && decorator_.result(); }

private:
    struct Shown {
        uint64_t version = 0, decoration = 0;
        CurveLook look;
        bool visible = false, decorated = false;
        bool operator==(const Shown&) const = default;
    };
    static float height(const Curve& curve);

    Desk& desk_;
    CurveSolver solver_;
    Decorator decorator_;
    render::CurvesId drawn_{};
    Shown shown_;
};

// How the renderer shows it.
render::CurveLook look_of(const CurveLook& look, float scale);

}  // namespace flg::studio::splines
