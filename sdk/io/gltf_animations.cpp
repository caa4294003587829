// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.11 animations).
// An animation's channels are sampled at the times of all of them: between two of those every node turns at an even rate, so
// that nothing is lost where one node turns. What a pose does to each joint is then taken apart into a turn within the
// parent's frame and, of the roots, one translation; what has more to it is refused.
#include "io/gltf_animations.h"

#include <cmath>

#include "io/failure.h"
#include "io/gltf_channels.h"
#include "io/gltf_rotations.h"

namespace flg::io {

namespace {

using Vector = std::array<double, 3>;

constexpr double stretch_tolerance = 1e-3;  // of rigid motions
constexpr double move_tolerance = 1e-4;     // of the model's size

class AnimationReader {
public:
    AnimationReader(const GltfDocument& document, const GltfNodes& nodes, const GltfSkeleton& skeleton, double size,
                    SkinData& data)
        : document_(document), nodes_(nodes), skeleton_(skeleton), move_limit_(move_tolerance * size), data_(data) {
        is_needed_.resize(nodes.size());
        for (const GltfJoint& joint : skeleton.joints()) {
            for (uint64_t node = joint.node; node != no_node && !is_needed_[node]; node = nodes.parent(node))
                is_needed_[node] = true;
        }
        for (const uint64_t node : nodes.order()) {
            if (is_needed_[node]) needed_.push_back(node);
        }
        locals_.resize(nodes.size(), identity_transform);
        globals_.resize(nodes.size(), identity_transform);
        motions_.resize(skeleton.joints().size());
        turns_.resize(skeleton.joints().size());
    }

    void read(uint64_t index) {
        place_ = "animations[" + std::to_string(index) + "]";
        const Json& json = document_.element("animations", index, place_);
        const GltfChannels channels(document_, nodes_, is_needed_, json, place_, limit_);
        std::vector<float> keys = channels.keys();
        const auto name = json.find("name");
        AnimationData animation;
        animation.name =
            name != json.end() && name->is_string() ? name->get<std::string>() : "animation " + std::to_string(index);
        if (keys.empty()) {
            data_.warnings.push_back(place_ + " moves no joint of the skin: left out");
            return;
        }
        limit_.add(keys.size() * needed_.size(), place_);
        animation.times = std::move(keys);
        sample(channels, animation);
        data_.animations.push_back(std::move(animation));
    }

private:
    void sample(const GltfChannels& channels, AnimationData& animation) {
        const size_t joint_count = motions_.size();
        bool roots_move = false;
        for (const uint64_t node : needed_) locals_[node] = channels.local_at(node, 0);
        for (const float time : animation.times) {
            for (const uint64_t node : needed_) {
                if (channels.moves(node)) locals_[node] = channels.local_at(node, time);
                const uint64_t parent = nodes_.parent(node);
                globals_[node] = parent == no_node ? locals_[node] : compose(globals_[parent], locals_[node]);
            }
            const Vector moved = take_apart(time);
            for (const double value : moved) {
                roots_move |= value != 0;
                animation.translations.push_back(static_cast<float>(value));
            }
            const size_t before = animation.rotations.size();
            for (size_t j = 0; j < joint_count; ++j) {
                const uint32_t parent = skeleton_.joints()[j].parent;
                Rotation q = parent == FLG_NO_INDEX ? turns_[j] : from_to(turns_[parent], turns_[j]);
                q = normalized(q);
                // Of a rotation's two quaternions the one nearer to the key before.
                double same = q[3];
                if (before != 0) {
                    const float* last = &animation.rotations[before - 4 * joint_count + 4 * j];
                    same = q[0] * last[0] + q[1] * last[1] + q[2] * last[2] + q[3] * last[3];
                }
                for (const double value : q)
                    animation.rotations.push_back(static_cast<float>(same < 0 ? -value : value));
            }
        }
        if (!roots_move) animation.translations.clear();
    }

    // Fills `motions_` and `turns_` from the nodes; returns how far the roots are moved.
    Vector take_apart(float time) {
        Vector moved = {0, 0, 0};
        bool has_root = false;
        for (size_t j = 0; j < motions_.size(); ++j) {
            const GltfJoint& joint = skeleton_.joints()[j];
            const auto refuse = [&](const char* why) {
                fail(FLG_ERROR_FORMAT, place_, "at %g s joint %s %s, which skins here can't do", double{time},
                     cited(data_.joint_names[j]).c_str(), why);
            };
            motions_[j] = compose(globals_[joint.node], joint.from_placed);
            if (!is_rigid(motions_[j], stretch_tolerance)) refuse("is scaled");
            turns_[j] = rotation_of(motions_[j]);
            const double at[3] = {data_.joint_positions[3 * j], data_.joint_positions[3 * j + 1],
                                  data_.joint_positions[3 * j + 2]};
            const Vector is = place_by(motions_[j], at);
            Vector should = {at[0] + moved[0], at[1] + moved[1], at[2] + moved[2]};
            if (joint.parent != FLG_NO_INDEX) should = place_by(motions_[joint.parent], at);
            const Vector off = {is[0] - should[0], is[1] - should[1], is[2] - should[2]};
            const double distance = std::hypot(off[0], off[1], off[2]);
            if (joint.parent == FLG_NO_INDEX && !has_root) {
                has_root = true;
                // What is smaller than a float can say of the model is no motion.
                moved = distance > 1e-3 * move_limit_ ? off : Vector{0, 0, 0};
            } else if (!(distance <= move_limit_)) {
                refuse(joint.parent == FLG_NO_INDEX ? "moves otherwise than the other roots" : "leaves its parent");
            }
        }
        return moved;
    }

    const GltfDocument& document_;
    const GltfNodes& nodes_;
    const GltfSkeleton& skeleton_;
    const double move_limit_;
    SkinData& data_;
    std::vector<uint64_t> needed_;  // joints and what is above them, parents first
    std::vector<bool> is_needed_;   // by node
    std::string place_;
    TurnLimit limit_;
    std::vector<Transform> locals_, globals_;  // by node
    std::vector<Transform> motions_;           // by joint, from rest
    std::vector<Rotation> turns_;
};

}  // namespace

void read_animations(const GltfDocument& document, const GltfNodes& nodes, const GltfSkeleton& skeleton, double size,
                     SkinData& data) {
    AnimationReader reader(document, nodes, skeleton, size, data);
    for (uint64_t i = 0; i < document.size("animations"); ++i) reader.read(i);
}

}  // namespace flg::io
