// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.11 animations, appendix C interpolation).
#include "io/gltf_channels.h"

#include <algorithm>

#include "io/failure.h"
#include "io/gltf_rotations.h"
#include "io/limits.h"

namespace flg::io {

namespace {

constexpr uint64_t most_turns = uint64_t{1} << 26;
constexpr double length_tolerance = 0.02;  // of quaternions; bytes hold no better ones
constexpr const char* path_names[] = {"translation", "rotation", "scale"};

}  // namespace

void TurnLimit::add(uint64_t turns, const std::string& place) {
    count_ += turns;
    if (count_ > most_turns) {
        fail(FLG_ERROR_LIMIT, place, "all animations together have more than %llu keys times nodes",
             static_cast<unsigned long long>(most_turns));
    }
}

GltfChannels::GltfChannels(const GltfDocument& document, const GltfNodes& nodes, const std::vector<bool>& is_needed,
                           const Json& animation, const std::string& place, TurnLimit& limit)
    : document_(document), nodes_(nodes), place_(place), limit_(limit) {
    const Json* channels = gltf_array(animation, "channels", place);
    const Json* samplers = gltf_array(animation, "samplers", place);
    for (size_t i = 0; channels && i < channels->size(); ++i)
        read_channel((*channels)[i], samplers, is_needed, place + ".channels[" + std::to_string(i) + "]");
}

void GltfChannels::read_channel(const Json& channel, const Json* samplers, const std::vector<bool>& is_needed,
                                const std::string& here) {
    if (!channel.is_object() || !channel.contains("target") || !channel["target"].is_object())
        fail(FLG_ERROR_FORMAT, here, "has no target");
    const Json& target = channel["target"];
    if (!target.contains("node")) return;  // an extension's
    const uint64_t node = gltf_required(target, "node", here + ".target");
    document_.element("nodes", node, here + ".target.node");
    const auto path = target.find("path");
    const auto found = std::find_if(std::begin(path_names), std::end(path_names),
                                    [&](const char* name) { return path != target.end() && *path == name; });
    if (found == std::end(path_names)) return;  // shapes, not joints
    if (!is_needed[node]) return;
    std::optional<Channel>& to = channels_[node][static_cast<size_t>(found - path_names)];
    if (to) fail(FLG_ERROR_FORMAT, here, "moves a node that another channel moves");
    if (nodes_.json(node).contains("matrix"))
        fail(FLG_ERROR_FORMAT, here, "moves nodes[%llu], which has a matrix", static_cast<unsigned long long>(node));
    const uint64_t sampler = gltf_required(channel, "sampler", here);
    if (!samplers || sampler >= samplers->size())
        fail(FLG_ERROR_FORMAT, here + ".sampler", "is %llu, but there are %zu",
             static_cast<unsigned long long>(sampler), samplers ? samplers->size() : 0);
    to = read_sampler((*samplers)[sampler], static_cast<Path>(found - path_names),
                      place_ + ".samplers[" + std::to_string(sampler) + "]");
}

GltfChannels::Channel GltfChannels::read_sampler(const Json& sampler, Path path, const std::string& here) {
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

const std::vector<float>& GltfChannels::read_times(uint64_t accessor, const std::string& here) {
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

std::vector<float> GltfChannels::keys() const {
    std::vector<float> keys;
    for (const auto& [accessor, times] : times_) keys.insert(keys.end(), times.begin(), times.end());
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

template <size_t N>
void GltfChannels::sample(const std::optional<Channel>& channel, float time, std::array<double, N>& to) {
    if (!channel) return;
    const std::vector<float>& times = *channel->times;
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

}  // namespace flg::io
