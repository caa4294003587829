// SPDX-License-Identifier: MIT
// A part that is dragged beside another, with a skin now and then; contours that are drawn.
#include <cmath>

#include "filigree/filigree_model.h"
#include "soak/abilities.h"

namespace flg::soak {

namespace {

std::vector<double> ellipse(double rx, double ry, uint32_t count) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count;
        points.insert(points.end(), {rx * std::cos(angle), ry * std::sin(angle)});
    }
    return points;
}

FlgPart create_part(Stage& stage, const std::vector<double>& points, FlgJob* out_job) {
    FlgPartDesc desc = flgPartDefaults();
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = points.data();
    drawn.point_count = static_cast<uint32_t>(points.size() / 2);
    desc.contour = &drawn;
    FlgPart part{};
    stage.must(flgPartCreate(stage.context, &desc, &part, out_job), "flgPartCreate");
    return part;
}

class Dragging : public Ability {
public:
    explicit Dragging(Stage& on)
        : Ability(on),
          body_(create_part(on, ellipse(1, 2, 120), nullptr)),
          arm_(create_part(on, ellipse(1.2, 0.35, 80), nullptr)) {}

    void frame() override {
        bool made = false;
        if (!stage.done(modelling_, &made) || !stage.done(skinning_, &made)) return stage.cancel_at_random(skinning_);
        rest();
        FlgModelPart parts[2] = {flgModelPartDefaults(), flgModelPartDefaults()};
        parts[0].part = body_;
        parts[1].part = arm_;
        parts[1].placement[3] = 1.6 + 0.2 * stage.share();
        parts[1].placement[7] = 0.8 + 0.2 * stage.share();
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = parts;
        desc.part_count = 2;
        if (!stage.must(flgModelCreate(stage.context, &desc, &model_, &modelling_), "flgModelCreate")) return;
        if (stage.draw(60) != 0) return;
        FlgSkinDesc skin = flgSkinDefaults();
        skin.model = model_;
        skin.vertex_count = 2000;
        stage.must(flgSkinCreate(stage.context, &skin, &skin_, &skinning_), "flgSkinCreate");
        stage.cancel_at_random(modelling_);
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(modelling_, &made) || !stage.done(skinning_, &made)) return false;
        if (model_.id != 0) stage.must(flgModelRelease(stage.context, model_), "flgModelRelease");
        if (skin_.id != 0) stage.must(flgSkinRelease(stage.context, skin_), "flgSkinRelease");
        model_ = {};
        skin_ = {};
        return true;
    }

private:
    const FlgPart body_, arm_;
    FlgModel model_{};
    FlgSkin skin_{};
    FlgJob modelling_{}, skinning_{};
};

class Sketching : public Ability {
public:
    using Ability::Ability;

    void frame() override {
        if (!rest()) {
            stage.cancel_at_random(axis_);
            return stage.cancel_at_random(inflation_);
        }
        const std::vector<double> points = ellipse(1 + stage.share(), 1, 60 + stage.draw(60));
        part_ = create_part(stage, points, &axis_);
        FlgPartMeshDesc desc = flgPartMeshDefaults();
        desc.part = part_;
        stage.must(flgPartMeshCreate(stage.context, &desc, &mesh_, &inflation_), "flgPartMeshCreate");
        FlgStraightSkeletonDesc skeleton = flgStraightSkeletonDefaults();
        FlgContourView drawn = flgContourViewDefaults();
        drawn.points = points.data();
        drawn.point_count = static_cast<uint32_t>(points.size() / 2);
        skeleton.contour = &drawn;
        stage.must(flgStraightSkeletonCreate(stage.context, &skeleton, &skeleton_, &skeletonizing_),
                   "flgStraightSkeletonCreate");
        stage.cancel_at_random(axis_);
        stage.cancel_at_random(skeletonizing_);
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(axis_, &made) || !stage.done(inflation_, &made) || !stage.done(skeletonizing_, &made)) {
            return false;
        }
        if (part_.id != 0) stage.must(flgPartRelease(stage.context, part_), "flgPartRelease");
        if (mesh_.id != 0) stage.must(flgPartMeshRelease(stage.context, mesh_), "flgPartMeshRelease");
        if (skeleton_.id != 0) {
            stage.must(flgStraightSkeletonRelease(stage.context, skeleton_), "flgStraightSkeletonRelease");
        }
        part_ = {};
        mesh_ = {};
        skeleton_ = {};
        return true;
    }

private:
    FlgPart part_{};
    FlgPartMesh mesh_{};
    FlgStraightSkeleton skeleton_{};
    FlgJob axis_{}, inflation_{}, skeletonizing_{};
};

}  // namespace

std::unique_ptr<Ability> drag_parts(Stage& stage) {
    return std::make_unique<Dragging>(stage);
}
std::unique_ptr<Ability> draw_contours(Stage& stage) {
    return std::make_unique<Sketching>(stage);
}

}  // namespace flg::soak
