// SPDX-License-Identifier: MIT
// Models as hosts hold them, and the job that makes them.
#pragma once

#include <deque>
#include <string>

#include "bones/connection.h"
#include "bones/part.h"
#include "core/origin.h"
#include "skeletons/bone_tree.h"

namespace flg {

// A part where the model has it.
struct ModelPart {
    explicit ModelPart(Memory* memory) : branch_simplify(memory), name(memory), suffix(memory) {}

    std::shared_ptr<const HeldPart> part;
    Eigen::Matrix<double, 3, 4> placement = Eigen::Matrix<double, 3, 4>::Identity();
    double scale = 1;  // of the placement
    double thickness = 1;
    FlgBoneThresholds thresholds{};            // shares of the model's size
    std::pmr::vector<double> branch_simplify;  // by branch, negative: the part's; none: all the part's
    std::pmr::string name, suffix;
    uint32_t source = 0;        // which of the host's parts
    uint32_t twin = no_number;  // its mirror image or what it is that of
    bool is_mirrored = false;   // it is the image

    Vec3 place(const Point2& at) const { return placement.col(0) * at.x + placement.col(1) * at.y + placement.col(3); }
};

class HeldModel final : public Product {
public:
    explicit HeldModel(Memory* memory)
        : parts(memory), tree(memory), links(memory), part_joints(memory), columns_(memory) {}

    Origin origin{};  // of the placements
    std::pmr::vector<ModelPart> parts;
    FlgBoneThresholds thresholds{};  // shares of the size
    double shape_weight = 1;
    Vec3 mirror_normal = Vec3::UnitX();
    double mirror_offset = 0;

    double size = 0;  // the length of the longest ring 0, as placed
    BoneTree tree;
    std::pmr::vector<PartLink> links;        // by part; joints as they were when it was connected
    std::pmr::vector<uint32_t> part_joints;  // by part, the joint of the tree that stands for it

    // What hosts are shown, once the rest is there: joint by joint, then part by part.
    void show_joint(const BoneJoint& joint);
    void show_part(uint32_t part);
    const FlgModelView& view() const { return view_; }

private:
    struct Columns {
        explicit Columns(Memory* memory)
            : positions(memory),
              radii(memory),
              parents(memory),
              parts(memory),
              names(memory),
              name_pointers(memory),
              joint_counts(memory),
              part_events(memory),
              part_parents(memory),
              part_sources(memory),
              part_twins(memory),
              part_mirrored(memory) {}
        std::pmr::vector<float> positions, radii;
        std::pmr::vector<uint32_t> parents, parts;
        std::pmr::deque<std::pmr::string> names;  // which stay where they are
        std::pmr::vector<const char*> name_pointers;
        std::pmr::vector<uint32_t> joint_counts;  // by part
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
