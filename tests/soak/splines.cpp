// SPDX-License-Identifier: MIT
// Splines on a mesh whose points are dragged; motions through keys that change.
#include "api/spline_inputs.h"
#include "filigree/filigree_motion.h"
#include "soak/abilities.h"

namespace flg::soak {

namespace {

FlgManifold create_torus(Stage& stage) {
    test::MeshArrays mesh = test::torus_mesh(80, 32, 2, 0.8);
    FlgSurfaceDesc surface = flgSurfaceDefaults();
    const FlgMeshView input = mesh.view();
    surface.mesh = &input;
    FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
    FlgManifold manifold{};
    stage.must(flgSurfaceCreate(stage.context, &surface, &desc.surface, nullptr), "flgSurfaceCreate");
    stage.must(flgManifoldCreateFromSurface(stage.context, &desc, &manifold, nullptr), "flgManifoldCreateFromSurface");
    return manifold;
}

class DraggingSplines : public Ability {
public:
    explicit DraggingSplines(Stage& on) : Ability(on), manifold_(create_torus(on)) {}

    void frame() override {
        bool made = false;
        if (!stage.done(job_, &made)) return stage.cancel_at_random(job_);
        angle_ += 0.01 * stage.share();
        std::vector<double> points = test::torus_points(8, 2, 0.8);
        points[0] = 2.8 * std::cos(angle_);
        points[1] = 2.8 * std::sin(angle_);
        FlgSplineDesc desc = flgSplineDefaults();
        desc.manifold = manifold_;
        desc.points = points.data();
        desc.point_count = 8;
        desc.closed = 1;
        desc.node_count = 64;
        desc.warm_start = spline_;
        if (angle_ > 0.5) angle_ = -0.5;
        FlgSpline next{};
        stage.must(flgSplineCreate(stage.context, &desc, &next, &job_), "flgSplineCreate");
        stage.cancel_at_random(job_);
        release();
        spline_ = next;
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(job_, &made)) return false;
        release();
        return true;
    }

private:
    void release() {
        if (spline_.id != 0) stage.must(flgSplineRelease(stage.context, spline_), "flgSplineRelease");
        spline_ = {};
    }

    const FlgManifold manifold_;
    FlgSpline spline_{};
    FlgJob job_{};
    double angle_ = 0;
};

class Moving : public Ability {
public:
    using Ability::Ability;

    void frame() override {
        if (!rest()) return stage.cancel_at_random(job_);
        const double times[] = {0, 1, 2.5};
        const double poses[] = {1, 0, 0, 0, 0, 1, 0,  0, 0, 0, 1, stage.share(),  //
                                1, 0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0,              //
                                0, 0, 1, 1, 1, 0, 0,  2, 0, 1, 0, 0};
        FlgMotionDesc desc = flgMotionDefaults();
        desc.key_count = 3;
        desc.times = times;
        desc.poses = poses;
        stage.must(flgMotionCreate(stage.context, &desc, &motion_, &job_), "flgMotionCreate");
        stage.cancel_at_random(job_);
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(job_, &made)) return false;
        if (motion_.id != 0) stage.must(flgMotionRelease(stage.context, motion_), "flgMotionRelease");
        motion_ = {};
        return true;
    }

private:
    FlgMotion motion_{};
    FlgJob job_{};
};

}  // namespace

std::unique_ptr<Ability> drag_splines(Stage& stage) {
    return std::make_unique<DraggingSplines>(stage);
}
std::unique_ptr<Ability> move_bodies(Stage& stage) {
    return std::make_unique<Moving>(stage);
}

}  // namespace flg::soak
