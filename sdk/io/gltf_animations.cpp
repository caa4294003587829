// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.11 animations, appendix C interpolation).
// An animation's channels are sampled at the times of all of them: between two of those every node turns at an even rate, so
// that nothing is lost where one node turns. What a pose does to each joint is then taken apart into a turn within the
// parent's frame and, of the roots, one translation; what has more to it is refused.
#include "io/gltf_animations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

namespace {

using Vector = std::array<double, 3>;
using Rotation = std::array<double, 4>;  // x, y, z, w

// Of all animations together: keys times nodes. Each takes 16 bytes, and some 200 ns.
constexpr uint64_t most_turns = uint64_t{1} << 26;
constexpr double stretch_tolerance = 1e-3;  // of rigid motions
constexpr double move_tolerance = 1e-4;     // of the model's size
constexpr double length_tolerance = 0.02;   // of quaternions; bytes hold no better ones

enum Path { translation, rotation, scale, path_count };
constexpr const char* path_names[path_count] = {"translation", "rotation", "scale"};

struct Channel {
    const std::vector<float>* times;
    GltfValues values;
};

using Channels = std::array<std::optional<Channel>, path_count>;

Rotation normalized(const Rotation& q) {
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return {q[0] / size, q[1] / size, q[2] / size, q[3] / size};
}

double dot(const Rotation& a, const Rotation& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// Conjugate of a, times b.
Rotation from_to(const Rotation& a, const Rotation& b) {
    return {a[3] * b[0] - a[0] * b[3] - a[1] * b[2] + a[2] * b[1],
            a[3] * b[1] + a[0] * b[2] - a[1] * b[3] - a[2] * b[0],
            a[3] * b[2] - a[0] * b[1] + a[1] * b[0] - a[2] * b[3], dot(a, b)};
}

Rotation slerp(const Rotation& from, const Rotation& to, double share) {
    constexpr double nearly_one = 1 - 1e-9;
    const double cosine = dot(from, to), sign = cosine < 0 ? -1 : 1;
    double a = 1 - share, b = share;
    if (std::abs(cosine) < nearly_one) {
        const double angle = std::acos(std::abs(cosine)), sine = std::sin(angle);
        a = std::sin(a * angle) / sine;
        b = std::sin(b * angle) / sine;
    }
    Rotation q;
    for (size_t k = 0; k < 4; ++k) q[k] = a * from[k] + sign * b * to[k];
    return normalized(q);
}

// Of the linear part, which must be a rotation. Shepperd, Quaternion from rotation matrix, 1978.
Rotation rotation_of(const Transform& m) {
    const double trace = m[0] + m[4] + m[8];
    if (trace > 0) return normalized({m[5] - m[7], m[6] - m[2], m[1] - m[3], 1 + trace});
    if (m[0] >= m[4] && m[0] >= m[8])
        return normalized({1 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6], m[5] - m[7]});
    if (m[4] >= m[8]) return normalized({m[1] + m[3], 1 - m[0] + m[4] - m[8], m[5] + m[7], m[6] - m[2]});
    return normalized({m[2] + m[6], m[5] + m[7], 1 - m[0] - m[4] + m[8], m[1] - m[3]});
}

bool is_rigid(const Transform& m) {
    for (size_t a = 0; a < 3; ++a) {
        for (size_t b = a; b < 3; ++b) {
            const double product = m[3 * a] * m[3 * b] + m[3 * a + 1] * m[3 * b + 1] + m[3 * a + 2] * m[3 * b + 2];
            if (!(std::abs(product - (a == b)) <= 2 * stretch_tolerance)) return false;
        }
    }
    return determinant(m) > 0;
}

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
        channels_.clear();
        times_.clear();
        read_channels(json);
        std::vector<float> keys;
        for (const auto& [accessor, times] : times_) keys.insert(keys.end(), times.begin(), times.end());
        std::sort(keys.begin(), keys.end());
        keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
        const auto name = json.find("name");
        AnimationData animation;
        animation.name =
            name != json.end() && name->is_string() ? name->get<std::string>() : "animation " + std::to_string(index);
        if (keys.empty()) {
            data_.warnings.push_back(place_ + " moves no joint of the skin: left out");
            return;
        }
        count_turns(keys.size() * needed_.size());
        animation.times = std::move(keys);
        sample(animation);
        data_.animations.push_back(std::move(animation));
    }

private:
    void count_turns(uint64_t count) {
        turn_count_ += count;
        if (turn_count_ > most_turns) {
            fail(FLG_ERROR_LIMIT, place_, "all animations together have more than %llu keys times nodes",
                 static_cast<unsigned long long>(most_turns));
        }
    }

    void read_channels(const Json& json) {
        const Json* channels = gltf_array(json, "channels", place_);
        const Json* samplers = gltf_array(json, "samplers", place_);
        for (size_t i = 0; channels && i < channels->size(); ++i) {
            const std::string here = place_ + ".channels[" + std::to_string(i) + "]";
            const Json& channel = (*channels)[i];
            if (!channel.is_object() || !channel.contains("target") || !channel["target"].is_object())
                fail(FLG_ERROR_FORMAT, here, "has no target");
            const Json& target = channel["target"];
            if (!target.contains("node")) continue;  // an extension's
            const uint64_t node = gltf_required(target, "node", here + ".target");
            document_.element("nodes", node, here + ".target.node");
            const auto path = target.find("path");
            const auto found = std::find_if(std::begin(path_names), std::end(path_names),
                                            [&](const char* name) { return path != target.end() && *path == name; });
            if (found == std::end(path_names)) continue;  // shapes, not joints
            if (!is_needed_[node]) continue;
            std::optional<Channel>& to = channels_[node][static_cast<size_t>(found - path_names)];
            if (to) fail(FLG_ERROR_FORMAT, here, "moves a node that another channel moves");
            if (nodes_.json(node).contains("matrix"))
                fail(FLG_ERROR_FORMAT, here, "moves nodes[%llu], which has a matrix",
                     static_cast<unsigned long long>(node));
            const uint64_t sampler = gltf_required(channel, "sampler", here);
            if (!samplers || sampler >= samplers->size())
                fail(FLG_ERROR_FORMAT, here + ".sampler", "is %llu, but there are %zu",
                     static_cast<unsigned long long>(sampler), samplers ? samplers->size() : 0);
            to = read_sampler((*samplers)[sampler], static_cast<Path>(found - path_names),
                              place_ + ".samplers[" + std::to_string(sampler) + "]");
        }
    }

    Channel read_sampler(const Json& sampler, Path path, const std::string& here) {
        if (!sampler.is_object()) fail(FLG_ERROR_FORMAT, here, "is no object");
        const auto interpolation = sampler.find("interpolation");
        if (interpolation != sampler.end() && *interpolation != "LINEAR")
            fail(FLG_ERROR_FORMAT, here + ".interpolation", "is %s; only LINEAR is supported",
                 cited(interpolation->dump()).c_str());
        const Channel channel{&read_times(gltf_required(sampler, "input", here), here + ".input"),
                              document_.accessor(gltf_required(sampler, "output", here), here + ".output")};
        const GltfValues& values = channel.values;
        const uint32_t components = path == rotation ? 4 : 3;
        if (values.components != components || (values.component_type != gltf_float && !values.normalized))
            fail(FLG_ERROR_FORMAT, values.place, "does not hold %u floats a key", components);
        if (values.count != channel.times->size())
            fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, but there are %zu times",
                 static_cast<unsigned long long>(values.count), channel.times->size());
        count_turns(values.count);
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

    const std::vector<float>& read_times(uint64_t accessor, const std::string& here) {
        const auto [found, is_new] = times_.try_emplace(accessor);
        if (!is_new) return found->second;
        const GltfValues values = document_.accessor(accessor, here);
        if (values.components != 1 || values.component_type != gltf_float)
            fail(FLG_ERROR_FORMAT, values.place, "holds times that are no floats");
        count_turns(values.count);
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

    template <size_t N>
    static void sample_channel(const std::optional<Channel>& channel, float time, std::array<double, N>& to) {
        if (!channel) return;
        const std::vector<float>& times = *channel->times;
        const auto after = std::upper_bound(times.begin(), times.end(), time);
        const uint64_t second = std::min(static_cast<size_t>(after - times.begin()), times.size() - 1);
        const uint64_t first = after == times.begin() ? 0 : static_cast<size_t>(after - times.begin()) - 1;
        const double share =
            first == second ? 0 : (double{time} - times[first]) / (double{times[second]} - times[first]);
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

    Transform local_at(uint64_t node, float time) const {
        const auto found = channels_.find(node);
        const Json& json = nodes_.json(node);
        if (found == channels_.end()) return local_transform(json, GltfNodes::place(node));
        NodeMotion motion = node_motion(json, GltfNodes::place(node));
        sample_channel(found->second[translation], time, motion.translation);
        sample_channel(found->second[rotation], time, motion.rotation);
        sample_channel(found->second[scale], time, motion.scale);
        return motion.transform();
    }

    void sample(AnimationData& animation) {
        const size_t joint_count = motions_.size();
        bool roots_move = false;
        for (const uint64_t node : needed_) locals_[node] = local_at(node, 0);
        for (const float time : animation.times) {
            for (const uint64_t node : needed_) {
                if (channels_.contains(node)) locals_[node] = local_at(node, time);
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
            if (!is_rigid(motions_[j])) refuse("is scaled");
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
    std::map<uint64_t, Channels> channels_;         // by node
    std::map<uint64_t, std::vector<float>> times_;  // by accessor
    std::vector<Transform> locals_, globals_;       // by node
    std::vector<Transform> motions_;                // by joint, from rest
    std::vector<Rotation> turns_;
    uint64_t turn_count_ = 0;
};

}  // namespace

void read_animations(const GltfDocument& document, const GltfNodes& nodes, const GltfSkeleton& skeleton, double size,
                     SkinData& data) {
    AnimationReader reader(document, nodes, skeleton, size, data);
    for (uint64_t i = 0; i < document.size("animations"); ++i) reader.read(i);
}

}  // namespace flg::io
