// SPDX-License-Identifier: MIT
// Models as hosts hold them, and the job that makes them.
#pragma once

#include <array>
#include <deque>
#include <string>
#include <string_view>

#include "bones/connection.h"
#include "bones/joint_labels.h"
#include "bones/part.h"
#include "core/origin.h"
#include "skeletons/bone_tree.h"

namespace flg {

// A part where the model has it.
struct ModelPart {
    explicit ModelPart(Memory* memory) : branch_simplify(memory), name(memory), suffix(memory), parent_joint(memory) {}

    std::shared_ptr<const HeldPart> part;
    Eigen::Matrix<double, 3, 4> placement = Eigen::Matrix<double, 3, 4>::Identity();
    double scale = 1;  // of the placement
    double thickness = 1;
    double depth = 0;                          // as FlgModelPart has it
    std::array<double, 4> picture{};           // likewise
    FlgBoneThresholds thresholds{};            // shares of the model's size
    std::pmr::vector<double> branch_simplify;  // by branch, negative: the part's; none: all the part's
    std::pmr::string name, suffix;
    uint32_t source = 0;            // which of the host's parts
    uint32_t twin = no_number;      // its mirror image or what it is that of
    bool is_mirrored = false;       // it is the image
    uint32_t parent = no_number;    // that the host hung it on, itself: none; no_number: to be found
    std::pmr::string parent_joint;  // its key; none: the nearest

    // Of what is measured across the axis in the drawing, the average with what is through the part, in space.
    double radius_scale() const { return scale * 0.5 * (1 + thickness); }
    Point2 drawn(const Vec3& at) const {
        const Vec3 offset = (at - placement.col(3)) / (scale * scale);
        return {offset.dot(placement.col(0)), offset.dot(placement.col(1))};
    }
    Vec3 place(const Point2& at) const { return placement.col(0) * at.x + placement.col(1) * at.y + placement.col(3); }
};

// What a host or its user set about a joint.
struct JointEdit {
    explicit JointEdit(Memory* memory) : joint(memory), name(memory) {}

    FlgJointEditKind kind = FLG_JOINT_EDIT_KIND_PIN;
    std::pmr::string joint, name;
    Vec3 at = Vec3::Zero();  // in the drawing
    double share = 0.5;
};

// Of a model before this one, as a file kept it.
struct KeptJoint {
    std::pmr::string key;
    Point2 at;        // in the drawing of its part
    uint32_t parent;  // comes first; no_number: none
};

class HeldModel final : public Product {
public:
    explicit HeldModel(Memory* memory)
        : parts(memory),
          apart(memory),
          root_joint(memory),
          edits(memory),
          kept_joints(memory),
          tree(memory),
          links(memory),
          part_joints(memory),
          own_joints(memory),
          own_numbers(memory),
          own_begins(memory),
          own_counts(memory),
          columns_(memory) {}

    Origin origin{};  // of the placements
    std::pmr::vector<ModelPart> parts;
    FlgBoneThresholds thresholds{};  // shares of the size
    double shape_weight = 1;
    Vec3 mirror_normal = Vec3::UnitX();
    double mirror_offset = 0;
    std::pmr::vector<std::array<uint32_t, 2>> apart;  // parts that the host does not want welded
    uint32_t root = no_number;                        // a part; no_number: to be found
    std::pmr::string root_joint;                      // its key; none: the middle
    std::pmr::vector<JointEdit> edits;
    std::shared_ptr<const HeldModel> previous;  // until the job is done
    std::pmr::vector<KeptJoint> kept_joints;    // in its place, likewise

    double size = 0;  // the length of the longest ring 0, as placed
    BoneTree tree;
    std::pmr::vector<PartLink> links;        // by part; joints as they were when it was connected
    std::pmr::vector<uint32_t> part_joints;  // by part, the joint of the tree that stands for it

    // What a model made after this one knows joints by.
    std::pmr::vector<DrawnJoint> own_joints;
    std::pmr::vector<uint32_t> own_numbers;
    std::pmr::vector<uint32_t> own_begins, own_counts;  // by part

    // What hosts are shown, once the rest is there: joint by joint, then part by part.
    void show_joint(const BoneJoint& joint, std::string_view key, std::string_view name, bool is_pinned);
    void show_part(uint32_t part);
    const FlgModelView& view() const { return view_; }
    // For jobs, which may run before the host sees the view.
    const char* joint_name(uint32_t joint) const { return columns_.name_pointers[joint]; }

private:
    struct Columns {
        explicit Columns(Memory* memory)
            : positions(memory),
              radii(memory),
              parents(memory),
              parts(memory),
              names(memory),
              keys(memory),
              name_pointers(memory),
              key_pointers(memory),
              places(memory),
              pinned(memory),
              part_events(memory),
              part_parents(memory),
              part_sources(memory),
              part_twins(memory),
              part_mirrored(memory) {}
        std::pmr::vector<float> positions, radii;
        std::pmr::vector<uint32_t> parents, parts;
        std::pmr::deque<std::pmr::string> names, keys;  // which stay where they are
        std::pmr::vector<const char*> name_pointers, key_pointers;
        std::pmr::vector<double> places;
        std::pmr::vector<uint8_t> pinned;
        std::pmr::vector<FlgPartEvent> part_events;
        std::pmr::vector<uint32_t> part_parents, part_sources, part_twins;
        std::pmr::vector<uint8_t> part_mirrored;
    };

    void show() noexcept override;

    Columns columns_;
    FlgModelView view_{};
};

// The whole of flgModelCreate.
Task<void> make_model(Pace& pace, std::shared_ptr<HeldModel> model);

}  // namespace flg
