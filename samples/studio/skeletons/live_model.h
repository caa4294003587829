// SPDX-License-Identifier: MIT
// The bones and the body of a drawing, made by jobs while it is drawn and changed: always at most one job for the
// newest state behind the one that runs, so that what is seen follows the mouse.
#pragma once

#include <memory>

#include "documents/kept_joints.h"
#include "documents/test_motion.h"
#include "filigree/filigree.hpp"
#include "filigree/filigree_model.h"
#include "shell/jobs.h"
#include "skeletons/rig.h"

namespace flg::studio {

using PartOwner = filigree::detail::Owner<FlgPart, flgPartRelease>;
using ModelOwner = filigree::detail::Owner<FlgModel, flgModelRelease>;
using SkinOwner = filigree::detail::Owner<FlgSkin, flgSkinRelease>;

// What a model is made from, of all that is in a drawing.
struct ModelRecipe {
    struct Part {
        uint32_t id;
        std::string name;
        ContourPtr contour;
        std::array<double, 12> placement;
        float thickness, depth;
        bool mirrored;
        std::optional<std::array<float, 5>> thresholds;
        std::vector<float> branch_simplify;
        bool operator==(const Part&) const = default;
        // All that the body's shape hangs on.
        bool is_shaped_as(const Part& other) const;
    };
    std::vector<Part> parts;
    std::array<float, 4> mirror;
    std::array<float, 5> thresholds;
    std::vector<JointEdit> joint_edits;
    std::vector<uint32_t> apart;  // indices of parts, two a pair
    bool operator==(const ModelRecipe&) const = default;
    bool is_shaped_as(const ModelRecipe& other) const;
};

// How much the body is worth just now. A fine one of another shape comes after a quick one.
enum class Body { none, quick, fine };

class LiveModel {
public:
    LiveModel(filigree::Context& context, Jobs& jobs, Notices& notices)
        : context_(context), jobs_(jobs), notices_(notices) {}

    // Once a frame. Body::none: an older one stays.
    void update(const Drawing& drawing, Body body);
    void clear();

    // Null while there are none. They change with their revisions alone.
    const Rig* rig() const { return rig_.count() == 0 ? nullptr : &rig_; }
    uint64_t rig_revision() const { return rig_revision_; }
    FlgModelView model() const;  // of the rig
    // The next model is of another document: its joints are those that the document kept; null: new ones.
    void begin_with(std::unique_ptr<const cli::KeptJoints> joints);
    // What a document keeps of the joints; null: nothing yet.
    nlohmann::json kept_joints() const;
    const ModelRecipe& recipe() const { return recipe_; }

    // Parts that hang on nothing, although they are not the first.
    bool is_loose(uint32_t part) const;
    bool has_loose_parts() const { return !loose_.empty(); }
    // A part whose line was changed into one that has no axis: bones and body keep the last line that had one.
    bool keeps_line(uint32_t part) const;

    struct Skinned {
        FlgSkinView view;
        Rig rig;                      // its own: that of the model may be newer
        std::vector<uint32_t> parts;  // for vertex_parts: ids of drawn parts
        std::vector<bool> is_image;   // the same: whether it is the mirror image
        cli::TestMotion motion;
    };
    const Skinned* skin() const { return skin_ ? &skinned_ : nullptr; }
    uint64_t skin_revision() const { return skin_revision_; }
    // Of its mesh: other weights leave it as it is.
    uint64_t shape_revision() const { return shape_revision_; }
    // The body with other weights than its own, four joints and weights a vertex, in a job; until it has a new shape.
    void bind(const std::vector<uint16_t>& joints, const std::vector<float>& weights);
    void unbind();
    bool is_bound() const { return bound_ || coming_bound_; }
    bool is_binding() const { return static_cast<bool>(coming_bound_); }
    // With its own weights; there must be a skin.
    const FlgSkinView& automatic() const { return automatic_; }

    struct PartState {
        bool ready = false;
        std::string fault;  // a sentence: why there is no axis
        std::vector<glm::dvec2> crossings;
    };
    const PartState& state_of(const ContourPtr& contour) const;
    // Null until ready.
    const FlgPartView* axis_of(const ContourPtr& contour) const;
    size_t fault_count(const Drawing& drawing) const;
    bool busy() const;

private:
    struct PartMade {
        std::weak_ptr<const Contour> contour;
        PartOwner part;
        PartState state;
        FlgPartView view = flgPartViewDefaults();
    };
    void make_parts(const Drawing& drawing);
    void look_at_parts(const Drawing& drawing);
    void start_model(const Drawing& drawing);
    void take_model();
    void start_skin(uint32_t vertices);
    void take_skin();
    void take_bound();
    void drop_skin();
    bool wants_skin() const;
    // What bones are made of; null: the part has no line for them.
    ContourPtr line_for(const DrawnPart& part) const;

    filigree::Context& context_;
    Jobs& jobs_;
    Notices& notices_;
    std::map<const Contour*, PartMade> parts_;
    std::map<uint32_t, ContourPtr> good_lines_;  // by part: the last that had an axis
    ModelRecipe wanted_{}, recipe_{}, coming_recipe_{}, skin_recipe_{}, coming_skin_recipe_{};
    ModelOwner model_, coming_model_;
    bool is_other_document_ = false;               // than model_ is of
    std::unique_ptr<const cli::KeptJoints> kept_;  // of the model before the next one, in place of model_
    SkinOwner skin_, coming_skin_, bound_, coming_bound_;
    FlgSkinView automatic_{};
    Rig rig_;
    std::vector<uint32_t> loose_;
    Skinned skinned_{}, coming_skinned_{};             // the second without its view
    bool model_failed_ = false, skin_failed_ = false;  // what is wanted: not tried again
    uint32_t wanted_vertices_ = 0;                     // 0: no new body
    uint32_t skin_vertices_ = 0, coming_vertices_ = 0;
    uint64_t rig_revision_ = 0, skin_revision_ = 0, shape_revision_ = 0;
};

}  // namespace flg::studio
