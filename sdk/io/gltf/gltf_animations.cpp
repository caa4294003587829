// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.11 animations). An animation's channels are sampled at the times of all of
// them: between two of those every node turns at an even rate, so that nothing is lost where one node turns. What a
// pose does to each joint is then taken apart into a turn within the parent's frame and, of the roots, one translation;
// what has more to it is refused.
#include "io/gltf/gltf_animations.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/base/failure.h"
#include "io/base/limits.h"
#include "io/gltf/gltf_morphs.h"
#include "io/gltf/gltf_rotations.h"
#include "io/gltf/gltf_skeleton.h"

namespace flg::io {

namespace {

// ---- The channels of one animation, and where they move nodes to: appendix C, interpolation

// What reading animations may cost: keys times nodes, of all animations of a file together. Each takes 16 bytes or some
// 200 ns.
class TurnLimit {
public:
    // Refuses more than 2^26.
    void add(uint64_t turns, const String& place);

private:
    uint64_t count_ = 0;
};

class GltfChannels {
public:
    // Reads those of nodes that `is_needed`; refuses what is not LINEAR, not finite, or does not fit.
    GltfChannels(const GltfDocument& document, const GltfNodes& nodes, const Vector<bool>& is_needed,
                 const Json& animation, const String& place, TurnLimit& limit);

    // All of their times, rising.
    Vector<float> keys() const;
    bool moves(uint64_t node) const { return channels_.contains(node); }
    // A node's transform to its parent.
    Transform local_at(uint64_t node, float time) const;

private:
    enum Path { translation, rotation, scale, path_count };
    struct Channel {
        const Vector<float>* times;
        GltfValues values;
    };
    using Channels = std::array<std::optional<Channel>, path_count>;

    void read_channel(const Json& channel, const Json* samplers, const Vector<bool>& is_needed, const String& place);
    Channel read_sampler(const Json& sampler, Path path, const String& place);
    const Vector<float>& read_times(uint64_t accessor, const String& place);
    template <size_t N>
    static void sample(const std::optional<Channel>& channel, float time, std::array<double, N>& to);

    const GltfDocument& document_;
    const GltfNodes& nodes_;
    const String place_;
    TurnLimit& limit_;
    Map<uint64_t, Channels> channels_;    // by node
    Map<uint64_t, Vector<float>> times_;  // by accessor
};

constexpr uint64_t max_turns = uint64_t{1} << 26;
constexpr double length_tolerance = 0.02;  // of quaternions; bytes hold no better ones
constexpr const char* path_names[] = {"translation", "rotation", "scale"};

void TurnLimit::add(uint64_t turns, const String& place) {
    count_ += turns;
    if (count_ > max_turns) {
        fail(FLG_ERROR_LIMIT, place, "all animations together have more than %llu keys times nodes",
             static_cast<unsigned long long>(max_turns));
    }
}

GltfChannels::GltfChannels(const GltfDocument& document, const GltfNodes& nodes, const Vector<bool>& is_needed,
                           const Json& animation, const String& place, TurnLimit& limit)
    : document_(document), nodes_(nodes), place_(place), limit_(limit) {
    const Json* channels = gltf_array(animation, "channels", place);
    const Json* samplers = gltf_array(animation, "samplers", place);
    for (size_t i = 0; channels && i < channels->size(); ++i)
        read_channel((*channels)[i], samplers, is_needed, place + ".channels[" + to_text(i) + "]");
}

void GltfChannels::read_channel(const Json& channel, const Json* samplers, const Vector<bool>& is_needed,
                                const String& here) {
    const Json* const given = channel.find("target");
    if (!given || !given->is_object()) fail(FLG_ERROR_FORMAT, here, "has no target");
    const Json& target = *given;
    if (!target.find("node")) return;  // an extension's
    const uint64_t node = gltf_required(target, "node", here + ".target");
    document_.element("nodes", node, here + ".target.node");
    const Json* const path = target.find("path");
    const auto found = std::find_if(std::begin(path_names), std::end(path_names),
                                    [&](const char* name) { return path && *path == name; });
    if (found == std::end(path_names)) return;  // shapes, not joints
    if (!is_needed[node]) return;
    std::optional<Channel>& to = channels_[node][static_cast<size_t>(found - path_names)];
    if (to) fail(FLG_ERROR_FORMAT, here, "moves a node that another channel moves");
    if (nodes_.json(node).find("matrix"))
        fail(FLG_ERROR_FORMAT, here, "moves nodes[%llu], which has a matrix", static_cast<unsigned long long>(node));
    const uint64_t sampler = gltf_required(channel, "sampler", here);
    if (!samplers || sampler >= samplers->size())
        fail(FLG_ERROR_FORMAT, here + ".sampler", "is %llu, but there are %zu",
             static_cast<unsigned long long>(sampler), samplers ? samplers->size() : 0);
    to = read_sampler((*samplers)[sampler], static_cast<Path>(found - path_names),
                      place_ + ".samplers[" + to_text(sampler) + "]");
}

GltfChannels::Channel GltfChannels::read_sampler(const Json& sampler, Path path, const String& here) {
    if (!sampler.is_object()) fail(FLG_ERROR_FORMAT, here, "is no object");
    const Json* const interpolation = sampler.find("interpolation");
    if (interpolation && !(*interpolation == "LINEAR"))
        fail(FLG_ERROR_FORMAT, here + ".interpolation", "is %s; only LINEAR is supported",
             cited(interpolation->string_or("no text")).c_str());
    const Channel channel{&read_times(gltf_required(sampler, "input", here), here + ".input"),
                          document_.accessor(gltf_required(sampler, "output", here), here + ".output")};
    const GltfValues& values = channel.values;
    const uint32_t components = path == rotation ? 4 : 3;
    if (values.components != components || (values.component_type != gltf_float && !values.normalized))
        fail(FLG_ERROR_FORMAT, values.place, "does not hold %u floats a key", components);
    if (values.count != channel.times->size())
        fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, but there are %zu times",
             static_cast<unsigned long long>(values.count), channel.times->size());
    limit_.add(values.count, place_);
    for (uint64_t key = 0; key < values.count; ++key) {
        double square = 0;
        for (uint32_t k = 0; k < components; ++k) {
            const double value = values.number(key, k);
            if (!(std::abs(value) <= max_coordinate))
                fail(FLG_ERROR_FORMAT, values.place, "key %llu gives %g: must be finite, at most 1e30 in size",
                     static_cast<unsigned long long>(key), value);
            square += value * value;
        }
        if (path == rotation && !(std::abs(std::sqrt(square) - 1) <= length_tolerance))
            fail(FLG_ERROR_FORMAT, values.place, "the quaternion of key %llu is %g long, must be 1",
                 static_cast<unsigned long long>(key), std::sqrt(square));
    }
    return channel;
}

const Vector<float>& GltfChannels::read_times(uint64_t accessor, const String& here) {
    const auto [found, is_new] = times_.try_emplace(accessor);
    if (!is_new) return found->second;
    const GltfValues values = document_.accessor(accessor, here);
    if (values.components != 1 || values.component_type != gltf_float)
        fail(FLG_ERROR_FORMAT, values.place, "holds times that are no floats");
    limit_.add(values.count, place_);
    for (uint64_t key = 0; key < values.count; ++key) {
        const float time = values.number(key, 0);
        const bool rises = found->second.empty() ? time >= 0 : time > found->second.back();
        if (!rises || !(time <= max_coordinate))
            fail(FLG_ERROR_FORMAT, values.place, "time %llu is %g: times rise from 0 or later",
                 static_cast<unsigned long long>(key), double{time});
        found->second.push_back(time);
    }
    return found->second;
}

Vector<float> GltfChannels::keys() const {
    Vector<float> keys;
    for (const auto& [accessor, times] : times_) keys.insert(keys.end(), times.begin(), times.end());
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

template <size_t N>
void GltfChannels::sample(const std::optional<Channel>& channel, float time, std::array<double, N>& to) {
    if (!channel) return;
    const Vector<float>& times = *channel->times;
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    const uint64_t second = std::min(static_cast<size_t>(after - times.begin()), times.size() - 1);
    const uint64_t first = after == times.begin() ? 0 : static_cast<size_t>(after - times.begin()) - 1;
    const double share = first == second ? 0 : (double{time} - times[first]) / (double{times[second]} - times[first]);
    std::array<double, N> a, b;
    for (uint32_t k = 0; k < N; ++k) {
        a[k] = channel->values.number(first, k);
        b[k] = channel->values.number(second, k);
    }
    if constexpr (N == 4) {
        to = slerp(normalized(a), normalized(b), share);
    } else {
        for (size_t k = 0; k < N; ++k) to[k] = a[k] + share * (b[k] - a[k]);
    }
}

Transform GltfChannels::local_at(uint64_t node, float time) const {
    const auto found = channels_.find(node);
    const Json& json = nodes_.json(node);
    if (found == channels_.end()) return local_transform(json, GltfNodes::place(node));
    NodeMotion motion = node_motion(json, GltfNodes::place(node));
    sample(found->second[translation], time, motion.translation);
    sample(found->second[rotation], time, motion.rotation);
    sample(found->second[scale], time, motion.scale);
    return motion.transform();
}

using Triple = std::array<double, 3>;

constexpr double stretch_tolerance = 1e-3;  // of rigid motions
constexpr double move_tolerance = 1e-4;     // of the model's size

class AnimationReader {
public:
    AnimationReader(const GltfDocument& document, const GltfNodes& nodes, const GltfSkeleton& skeleton,
                    const GltfMorphReader& morphs, double size, SkinData& data)
        : document_(document),
          nodes_(nodes),
          skeleton_(skeleton),
          morphs_(morphs),
          move_limit_(move_tolerance * size),
          data_(data) {
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
        place_ = "animations[" + to_text(index) + "]";
        const Json& json = document_.element("animations", index, place_);
        const GltfChannels channels(document_, nodes_, is_needed_, json, place_, limit_);
        Vector<float> keys = channels.keys();
        const Json* const name = json.find("name");
        AnimationData animation;
        animation.name = name && name->is_string() ? String(name->string()) : "animation " + to_text(index);
        if (keys.empty()) {
            if (!morphs_.read_animation(json, place_, animation.name, FLG_NO_INDEX, data_))
                data_.warnings.push_back(place_ + " moves no joint of the skin: left out");
            return;
        }
        morphs_.read_animation(json, place_, animation.name, static_cast<uint32_t>(data_.animations.size()), data_);
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
            const Triple moved = take_apart(time);
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
    Triple take_apart(float time) {
        Triple moved = {0, 0, 0};
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
            const Triple is = place_by(motions_[j], at);
            Triple should = {at[0] + moved[0], at[1] + moved[1], at[2] + moved[2]};
            if (joint.parent != FLG_NO_INDEX) should = place_by(motions_[joint.parent], at);
            const Triple off = {is[0] - should[0], is[1] - should[1], is[2] - should[2]};
            const double distance = std::hypot(off[0], off[1], off[2]);
            if (joint.parent == FLG_NO_INDEX && !has_root) {
                has_root = true;
                // What is smaller than a float can say of the model is no motion.
                moved = distance > 1e-3 * move_limit_ ? off : Triple{0, 0, 0};
            } else if (!(distance <= move_limit_)) {
                refuse(joint.parent == FLG_NO_INDEX ? "moves otherwise than the other roots" : "leaves its parent");
            }
        }
        return moved;
    }

    const GltfDocument& document_;
    const GltfNodes& nodes_;
    const GltfSkeleton& skeleton_;
    const GltfMorphReader& morphs_;
    const double move_limit_;
    SkinData& data_;
    Vector<uint64_t> needed_;  // joints and what is above them, parents first
    Vector<bool> is_needed_;   // by node
    String place_;
    TurnLimit limit_;
    Vector<Transform> locals_, globals_;  // by node
    Vector<Transform> motions_;           // by joint, from rest
    Vector<Rotation> turns_;
};

}  // namespace

void read_animations(const GltfDocument& document, const GltfNodes& nodes, const GltfSkeleton& skeleton,
                     const GltfMorphReader& morphs, double size, SkinData& data) {
    AnimationReader reader(document, nodes, skeleton, morphs, size, data);
    for (uint64_t i = 0; i < document.size("animations"); ++i) reader.read(i);
}

}  // namespace flg::io
