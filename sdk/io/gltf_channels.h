// SPDX-License-Identifier: MIT
// The channels of one glTF animation, and where they move nodes to.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "io/gltf_nodes.h"

namespace flg::io {

// What reading animations may cost: keys times nodes, of all animations of a file together. Each takes 16 bytes or some 200 ns.
class TurnLimit {
public:
    // Refuses more than 2^26.
    void add(uint64_t turns, const std::string& place);

private:
    uint64_t count_ = 0;
};

class GltfChannels {
public:
    // Reads those of nodes that `is_needed`; refuses what is not LINEAR, not finite, or does not fit.
    GltfChannels(const GltfDocument& document, const GltfNodes& nodes, const std::vector<bool>& is_needed,
                 const Json& animation, const std::string& place, TurnLimit& limit);

    // All of their times, rising.
    std::vector<float> keys() const;
    bool moves(uint64_t node) const { return channels_.contains(node); }
    // A node's transform to its parent.
    Transform local_at(uint64_t node, float time) const;

private:
    enum Path { translation, rotation, scale, path_count };
    struct Channel {
        const std::vector<float>* times;
        GltfValues values;
    };
    using Channels = std::array<std::optional<Channel>, path_count>;

    void read_channel(const Json& channel, const Json* samplers, const std::vector<bool>& is_needed,
                      const std::string& place);
    Channel read_sampler(const Json& sampler, Path path, const std::string& place);
    const std::vector<float>& read_times(uint64_t accessor, const std::string& place);
    template <size_t N>
    static void sample(const std::optional<Channel>& channel, float time, std::array<double, N>& to);

    const GltfDocument& document_;
    const GltfNodes& nodes_;
    const std::string place_;
    TurnLimit& limit_;
    std::map<uint64_t, Channels> channels_;         // by node
    std::map<uint64_t, std::vector<float>> times_;  // by accessor
};

}  // namespace flg::io
