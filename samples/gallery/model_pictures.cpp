// SPDX-License-Identifier: MIT
// Drawn models of samples/models: at rest with their bones, and in poses with strokes along the bones.
#include <algorithm>
#include <cstdio>
#include <deque>
#include <iterator>

#include "gallery/drawn_model.h"
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

constexpr uint32_t kVertices = 80'000;
constexpr glm::vec3 kBone = {0.90f, 0.88f, 0.80f}, kCream = {0.95f, 0.86f, 0.62f};

struct Model {
    const char* name;
    glm::vec3 sight;
    float time;  // of its pose, seconds
    const char* style;
    float size;      // of the style, against the limb's radius
    float shortest;  // limb with a stroke, against the model's size
    glm::vec3 stroke;
};

constexpr Model kBird = {"bird", {-0.45f, -0.30f, -1.0f}, 0.50f, "wave", 0.45f, 0.05f, kCream},
                kCat = {"cat", {-0.5f, -0.25f, -1.0f}, 0.50f, "loops", 0.55f, 0.10f, kInk},
                kCrab = {"crab", {-0.2f, -0.45f, -1.0f}, 0.50f, "knit", 0.45f, 0.05f, kCream},
                kDeer = {"deer", {-0.5f, -0.22f, -1.0f}, 0.50f, "wave", 0.45f, 0.05f, kCream},
                kTree = {"tree", {-0.3f, -0.20f, -1.0f}, 0.50f, "knit", 0.50f, 0.05f, kCream},
                kPanda = {"panda", {-0.35f, -0.15f, -1.0f}, 0.70f, "loops", 0.40f, 0.22f, kGold},
                kOctopus = {"octopus", {-0.2f, -0.35f, -1.0f}, 0.50f, "loops", 0.55f, 0.05f, kCream},
                kDragon = {"dragon", {-0.5f, -0.25f, -1.0f}, 0.50f, "knit", 0.45f, 0.05f, kCream},
                kHand = {"hand", {-0.35f, -0.12f, -1.0f}, 0.50f, "loops", 0.45f, 0.10f, kInk};

render::CurveLook in_front(glm::vec3 color, float radius) {
    render::CurveLook look = tube(color, radius);
    look.in_front = true;
    look.casts_shadow = false;
    return look;
}

// Models and their curves. Stay where they are until the picture is taken.
class Shelf {
public:
    explicit Shelf(Workshop& workshop) : workshop_(workshop) {}

    DrawnModel& model(const cli::ModelDrawing& drawing) { return models_.emplace_back(drawing, kVertices); }

    // The lines that were drawn, where they are in space; those of mirrored parts once.
    Panel outlines(const cli::ModelDrawing& drawing, const glm::vec3& sight) {
        constexpr float kLine = 0.0035f;  // of the drawing's size
        std::vector<scenes::Curve> curves;
        glm::vec3 low(1e9f), high(-1e9f);
        for (const cli::DrawnPart& part : drawing.parts) {
            const auto& m = part.placement;
            const std::vector<uint32_t>& offsets = part.contour.offsets;
            for (size_t ring = 0; ring + 1 < offsets.size(); ++ring) {
                scenes::Curve& curve = curves.emplace_back();
                curve.closed = true;
                for (size_t i = offsets[ring]; i < offsets[ring + 1]; ++i) {
                    const double x = part.contour.points[2 * i], y = part.contour.points[2 * i + 1];
                    const glm::vec3 p(m[0] * x + m[1] * y + m[3], m[4] * x + m[5] * y + m[7],
                                      m[8] * x + m[9] * y + m[11]);
                    low = glm::min(low, p), high = glm::max(high, p);
                    curve.points.push_back(to_point(p));
                }
            }
        }
        sets_.push_back(workshop_.curves(curves));
        Panel panel = panel_of(sets_.back().view(), tube(kInk, kLine * glm::distance(low, high)), sight);
        panel.ground = false;
        panel.margin = 1.05f;
        return panel;
    }

    // At rest, with bones and joints seen through it.
    Panel with_bones(DrawnModel& model, const glm::vec3& sight) {
        constexpr float kBoneRadius = 0.0030f, kJointRadius = 0.0062f;
        model.rest();
        const float size = model.bones().size;
        Panel panel = bare(model, sight);
        sets_.push_back(workshop_.curves(model.straight_bones()));
        panel.layers.push_back(shape_of(sets_.back().view(), in_front(kBone, kBoneRadius * size)));
        sets_.push_back(workshop_.curves(model.joint_balls()));
        panel.layers.push_back(shape_of(sets_.back().view(), in_front(kRed, kJointRadius * size)));
        return panel;
    }

    // In its pose, with strokes that lie on its limbs.
    Panel with_strokes(DrawnModel& model, const Model& as) {
        constexpr float kLargest = 0.02f, kWidth = 0.0014f;  // of the model's size
        // The style's plane is the surface's.
        constexpr float kBasis[9] = {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, -1.0f, 0.0f, 1.0f, 0.0f};
        model.pose(as.time);
        const float size = model.bones().size;
        const filigree::Style style = workshop_.style(scenes::make_style(as.style));
        Panel panel = bare(model, as.sight);
        for (const scenes::Curve& limb : model.limbs(as.sight)) {
            float thickness = 0.0f, length = 0.0f;
            for (size_t i = 1; i < limb.points.size(); ++i) {
                const scenes::Point &p = limb.points[i - 1], &q = limb.points[i];
                length += glm::distance(glm::vec3(p.x, p.y, p.z), glm::vec3(q.x, q.y, q.z));
                thickness += limb.radii[i] / static_cast<float>(limb.radii.size());
            }
            if (length < as.shortest * size) continue;
            FlgCurveSetStylizeDesc desc = sized(style, as.size * std::min(thickness, kLargest * size));
            desc.frame = FLG_FRAME_METHOD_SUPPLIED;
            std::copy(std::begin(kBasis), std::end(kBasis), desc.basis);
            sets_.push_back(workshop_.stylize(style, workshop_.curve(limb), desc));
            panel.layers.push_back(shape_of(sets_.back().view(), tube(as.stroke, kWidth * size)));
        }
        return panel;
    }

private:
    static Panel bare(const DrawnModel& model, const glm::vec3& sight) {
        Panel panel;
        panel.skins = {model.surface()};
        panel.sight = sight;
        panel.margin = 1.05f;
        return panel;
    }

    Workshop& workshop_;
    std::deque<DrawnModel> models_;
    std::deque<filigree::CurveSet> sets_;
};

void show(const char* name, std::initializer_list<Model> models, Workshop& workshop, Studio& studio) {
    Shelf shelf(workshop);
    std::vector<Panel> panels, poses;
    for (const Model& one : models) {
        DrawnModel& model = shelf.model(drawing_of(one.name));
        panels.push_back(shelf.with_bones(model, one.sight));
        panels.back().title = one.name;
        poses.push_back(shelf.with_strokes(model, one));
    }
    panels.insert(panels.end(), poses.begin(), poses.end());
    studio.take(name, panels, 3, kWidth, 540);
}

cli::ModelDrawing with_thresholds(cli::ModelDrawing drawing, const FlgBoneThresholds& thresholds) {
    drawing.thresholds = thresholds;
    for (cli::DrawnPart& part : drawing.parts) part.thresholds = thresholds;
    return drawing;
}

// Fig. 10: finer, as the drawing says, coarser.
void refinement(Workshop& workshop, Studio& studio) {
    constexpr FlgBoneThresholds kSettings[] = {{.struct_size = sizeof(FlgBoneThresholds),
                                                .simplify = 0.0015f,
                                                .merge = 0.005f,
                                                .prune = 0.01f,
                                                .collapse = 0.002f,
                                                .detail = 0},
                                               {.struct_size = sizeof(FlgBoneThresholds),
                                                .simplify = 0.006f,
                                                .merge = 0.02f,
                                                .prune = 0.035f,
                                                .collapse = 0.012f,
                                                .detail = 0},
                                               {.struct_size = sizeof(FlgBoneThresholds),
                                                .simplify = 0.03f,
                                                .merge = 0.06f,
                                                .prune = 0.09f,
                                                .collapse = 0.05f,
                                                .detail = 0}};
    Shelf shelf(workshop);
    std::vector<Panel> panels;
    for (const FlgBoneThresholds& thresholds : kSettings) {
        DrawnModel& model = shelf.model(with_thresholds(drawing_of("bird"), thresholds));
        std::printf("a bird of %u joints\n", model.bones().joint_count);
        panels.push_back(shelf.with_bones(model, {-0.35f, -1.1f, -1.0f}));
    }
    entitle(panels, {"Small thresholds", "As drawn", "Large thresholds"});
    studio.take("skeleton_refinement", panels, 3, kWidth, 330);
}

// Fig. 11: junctions where legs and tail meet the body, and one in their place.
void merging(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kHips = {-2.75f, -0.2f, 0.22f};  // and room for titles
    constexpr float kReach = 1.12f;
    Shelf shelf(workshop);
    std::vector<Panel> panels;
    for (const bool merged : {false, true}) {
        FlgBoneThresholds thresholds = drawing_of("cat").thresholds;
        if (!merged) thresholds.merge = thresholds.collapse = 0.0f;
        DrawnModel& model = shelf.model(with_thresholds(drawing_of("cat"), thresholds));
        Panel& panel = panels.emplace_back(shelf.with_bones(model, {-0.5f, -0.3f, -1.0f}));
        panel.aim = around(kHips, kReach);
        panel.margin = 1.0f;
    }
    entitle(panels, {"Separate junctions", "Merged into one"});
    studio.take("skeleton_merging", panels, 2, kWidth, 400);
}

// Fig. 1: one part; more parts, each hung on what was there; bones refined.
void overview(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kSight = {-0.5f, -0.25f, -1.0f};
    constexpr size_t kFirst = 1, kSome = 6;
    const cli::ModelDrawing all = drawing_of("cat");
    const auto first_parts = [&](size_t count) {
        cli::ModelDrawing some = all;
        some.parts.resize(count);
        return some;
    };
    const FlgBoneThresholds coarse = {.struct_size = sizeof(FlgBoneThresholds),
                                      .simplify = 0.03f,
                                      .merge = 0.06f,
                                      .prune = 0.09f,
                                      .collapse = 0.05f,
                                      .detail = 0};
    Shelf shelf(workshop);
    std::vector<Panel> panels;
    const auto add = [&](Panel panel, const char* title) {
        panel.title = title;
        panels.push_back(std::move(panel));
    };
    add(shelf.outlines(first_parts(kFirst), kSight), "Draw an outline:");
    add(shelf.with_bones(shelf.model(first_parts(kFirst)), kSight), "a body with bones comes of it");
    add(shelf.with_bones(shelf.model(first_parts(kSome)), kSight), "Draw parts: bones connect");
    add(shelf.with_bones(shelf.model(all), kSight), "All parts: one skeleton");
    add(shelf.with_bones(shelf.model(with_thresholds(all, coarse)), kSight), "Refine it: fewer bones");
    add(shelf.with_strokes(shelf.model(all), kCat), "and move it");
    studio.take("skeleton_overview", panels, 3, kWidth, 600);
}

void front_page(Workshop& workshop, Studio& studio) {
    Shelf shelf(workshop);
    std::vector<Panel> drawings, panels;
    for (const Model& one : {kCat, kDragon, kCrab}) {
        const cli::ModelDrawing drawing = drawing_of(one.name);
        drawings.push_back(shelf.outlines(drawing, one.sight));
        char words[80];
        std::snprintf(words, sizeof words, "%s: %zu drawn outlines", one.name, drawing.parts.size());
        drawings.back().title = words;
        panels.push_back(shelf.with_strokes(shelf.model(drawing), one));
    }
    panels[0].title = "the model, in a pose";
    panels[1].title = "strokes lie along its bones";
    drawings.insert(drawings.end(), panels.begin(), panels.end());
    studio.take("models", drawings, 3, kWidth, 600);
}

constexpr Picture kPictures[] = {
    {"models", "Three models from drawings, in poses", true, front_page},
    {"models_1", "Fig. 12: bird, cat and crab: bones at rest; in poses, with strokes along the bones", true,
     [](Workshop& workshop, Studio& studio) {
         show("models_1", {kBird, kCat, kCrab}, workshop, studio);
     }},
    {"models_2", "Fig. 12: deer, tree and panda", true,
     [](Workshop& workshop, Studio& studio) {
         show("models_2", {kDeer, kTree, kPanda}, workshop, studio);
     }},
    {"models_3", "Fig. 12: octopus, dragon and hand", true,
     [](Workshop& workshop, Studio& studio) {
         show("models_3", {kOctopus, kDragon, kHand}, workshop, studio);
     }},
    {"skeleton_overview", "Fig. 1: a drawn outline becomes a body with bones, parts are added, bones refined", true,
     overview},
    {"skeleton_refinement", "Fig. 10: a bird's bones at three settings", true, refinement},
    {"skeleton_merging", "Fig. 11: a cat's hips before and after merging", true, merging},
};

}  // namespace

std::span<const Picture> model_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
