// SPDX-License-Identifier: MIT
// Distances and isolines on a surface that stays; tangles on surfaces that are made, decorated, undone and given back.
#include "api/surface_inputs.h"
#include "filigree/filigree_tangle.h"
#include "soak/abilities.h"

namespace flg::soak {

namespace {

FlgSurface create(Stage& stage, test::MeshArrays mesh, FlgJob* out_job) {
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    FlgSurface surface{};
    stage.must(flgSurfaceCreate(stage.context, &desc, &surface, out_job), "flgSurfaceCreate");
    return surface;
}

class Measuring : public Ability {
public:
    explicit Measuring(Stage& on) : Ability(on), surface_(create(on, test::sphere(24), nullptr)) {}

    void frame() override {
        if (!rest()) {
            stage.cancel_at_random(measuring_);
            return stage.cancel_at_random(tracing_);
        }
        const uint32_t vertex = stage.draw(3000);
        FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
        desc.surface = surface_;
        desc.vertices = &vertex;
        desc.vertex_count = 1;
        if (!stage.must(flgFieldCreateGeodesic(stage.context, &desc, &field_, &measuring_), "flgFieldCreateGeodesic"))
            return;
        FlgFieldTraceIsolinesDesc isolines = flgFieldTraceIsolinesDefaults();
        isolines.field = field_;
        isolines.level_every = 0.1f;
        stage.must(flgFieldTraceIsolines(stage.context, &isolines, &curves_, &tracing_), "flgFieldTraceIsolines");
        stage.cancel_at_random(measuring_);
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(measuring_, &made) || !stage.done(tracing_, &made)) return false;
        if (field_.id != 0) stage.must(flgFieldRelease(stage.context, field_), "flgFieldRelease");
        if (curves_.id != 0) stage.must(flgSurfaceCurvesRelease(stage.context, curves_), "flgSurfaceCurvesRelease");
        field_ = {};
        curves_ = {};
        return true;
    }

private:
    const FlgSurface surface_;
    FlgField field_{};
    FlgSurfaceCurves curves_{};
    FlgJob measuring_{}, tracing_{};
};

class Decorating : public Ability {
public:
    using Ability::Ability;

    void frame() override {
        bool made = false;
        if (!stage.done(job_, &made)) return stage.cancel_at_random(job_);
        if (step_ == 0) return begin();
        if (!made && step_ < 3) return give_back();  // nothing to decorate
        if (step_ == 24) return give_back();
        step();
        stage.cancel_at_random(job_);
        ++step_;
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(job_, &made)) return false;
        give_back();
        return true;
    }

private:
    void begin() {
        FlgJob making{};
        surface_ = create(stage, test::sphere(16), &making);
        stage.must(flgTangleCreate(stage.context, surface_, nullptr, &tangle_, &job_), "flgTangleCreate");
        stage.must(flgJobRelease(stage.context, making), "flgJobRelease");
        step_ = 1;
    }
    void give_back() {
        if (step_ == 0) return;
        stage.must(flgTangleRelease(stage.context, tangle_), "flgTangleRelease");
        stage.must(flgSurfaceRelease(stage.context, surface_), "flgSurfaceRelease");
        step_ = 0;
    }
    void step() {
        FlgTangleInfo info{};
        info.struct_size = sizeof info;
        if (!stage.must(flgTangleGetInfo(stage.context, tangle_, &info), "flgTangleGetInfo")) return;
        const uint32_t region = stage.draw(info.region_count);
        const uint32_t choice = stage.draw(10);
        if (step_ > 1 && info.undo_count > 0 && choice < 3) {
            stage.must(flgTangleUndo(stage.context, tangle_, nullptr, &job_), "flgTangleUndo");
        } else if (info.redo_count > 0 && choice < 5) {
            stage.must(flgTangleRedo(stage.context, tangle_, nullptr, &job_), "flgTangleRedo");
        } else if (choice < 6) {
            FlgTangleApplyMacroDesc desc = flgTangleApplyMacroDefaults();
            desc.tangle = tangle_;
            desc.kind = FLG_TANGLE_MACRO_POLKA_DOTS;
            desc.regions = &region;
            desc.region_count = 1;
            desc.size = 0.06f;
            stage.must(flgTangleApplyMacro(stage.context, &desc, &job_), "flgTangleApplyMacro");
        } else {
            FlgTangleDivideDesc desc = flgTangleDivideDefaults();
            desc.tangle = tangle_;
            desc.kind = choice < 8 ? FLG_TANGLE_OPERATOR_VORONOI : FLG_TANGLE_OPERATOR_CONTOUR;
            desc.regions = &region;
            desc.region_count = 1;
            FlgTangleSeeds samples = flgTangleSeedsDefaults();
            samples.sample_radius = 0.5f;
            desc.a = &samples;
            desc.seed = stage.draw(1000);
            stage.must(flgTangleDivide(stage.context, &desc, &job_), "flgTangleDivide");
        }
    }

    FlgSurface surface_{};
    FlgTangle tangle_{};
    FlgJob job_{};
    uint32_t step_ = 0;  // 0: there is no tangle
};

}  // namespace

std::unique_ptr<Ability> measure_distances(Stage& stage) {
    return std::make_unique<Measuring>(stage);
}
std::unique_ptr<Ability> decorate_surfaces(Stage& stage) {
    return std::make_unique<Decorating>(stage);
}

}  // namespace flg::soak
