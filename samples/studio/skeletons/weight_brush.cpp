// SPDX-License-Identifier: MIT
#include "skeletons/weight_brush.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

namespace flg::studio {
namespace {

constexpr size_t kMostJoints = 4;

}  // namespace

// Of a vertex, while more than four joints may have a share.
struct PaintedWeights::Shares {
    std::vector<std::pair<uint16_t, float>> of;

    float& operator[](uint16_t joint) {
        for (auto& [other, share] : of)
            if (other == joint) return share;
        return of.emplace_back(joint, 0.0f).second;
    }
    void scale(float by) {
        for (auto& entry : of) entry.second *= by;
    }
};

void PaintedWeights::begin(const FlgSkinView& skin) {
    skin_ = skin;
    joints_.assign(skin.vertex_joints, skin.vertex_joints + 4 * size_t{skin.vertex_count});
    weights_.assign(skin.vertex_weights, skin.vertex_weights + 4 * size_t{skin.vertex_count});
    // The surface is closed: each side is there in both directions, so each neighbour comes once.
    neighbour_offsets_.assign(skin.vertex_count + 1, 0);
    const size_t corners = 3 * size_t{skin.triangle_count};
    for (size_t c = 0; c < corners; ++c) ++neighbour_offsets_[skin.triangles[c] + 1];
    for (size_t v = 0; v < skin.vertex_count; ++v) neighbour_offsets_[v + 1] += neighbour_offsets_[v];
    std::vector<uint32_t> next(neighbour_offsets_.begin(), neighbour_offsets_.end() - 1);
    neighbours_.resize(corners);
    for (size_t c = 0; c < corners; ++c)
        neighbours_[next[skin.triangles[c]]++] = skin.triangles[c % 3 == 2 ? c - 2 : c + 1];
    seen_.assign(skin.vertex_count, 0);
    dab_ = 0;
}

glm::vec3 PaintedWeights::position(uint32_t vertex) const {
    return glm::make_vec3(skin_.positions + 3 * size_t{vertex});
}

std::span<const uint32_t> PaintedWeights::neighbours(uint32_t vertex) const {
    return {neighbours_.data() + neighbour_offsets_[vertex], neighbours_.data() + neighbour_offsets_[vertex + 1]};
}

PaintedWeights::Shares PaintedWeights::shares_of(uint32_t vertex) const {
    Shares shares;
    for (size_t k = 4 * size_t{vertex}; k < 4 * size_t{vertex} + 4; ++k)
        if (weights_[k] > 0.0f) shares[joints_[k]] += weights_[k];
    return shares;
}

void PaintedWeights::set(uint32_t vertex, const Shares& shares) {
    std::vector<std::pair<uint16_t, float>> sorted = shares.of;
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    sorted.resize(std::min(sorted.size(), kMostJoints));
    float sum = 0.0f;
    for (const auto& entry : sorted) sum += entry.second;
    for (size_t k = 0; k < kMostJoints; ++k) {
        const bool is_used = k < sorted.size() && sorted[k].second > 0.0f;
        joints_[4 * size_t{vertex} + k] = is_used ? sorted[k].first : uint16_t{0};
        weights_[4 * size_t{vertex} + k] = is_used ? sorted[k].second / sum : 0.0f;
    }
}

// Those within the radius that hang together with the seed: not the limb beside it.
void PaintedWeights::find_reached(const Dab& dab) {
    ++dab_;
    reached_.assign(1, dab.seed);
    seen_[dab.seed] = dab_;
    for (size_t i = 0; i < reached_.size(); ++i)
        for (const uint32_t next : neighbours(reached_[i]))
            if (seen_[next] != dab_ && glm::distance(position(next), dab.at) < dab.radius) {
                seen_[next] = dab_;
                reached_.push_back(next);
            }
}

void PaintedWeights::paint(const Dab& dab) {
    find_reached(dab);
    const uint32_t parent = skin_.joint_parents[dab.joint];
    std::vector<Shares> painted;
    for (const uint32_t v : reached_) {
        const float far = std::min(glm::distance(position(v), dab.at) / dab.radius, 1.0f);
        const float share = dab.strength * (1.0f - far * far) * (1.0f - far * far);
        Shares& shares = painted.emplace_back(shares_of(v));
        if (dab.brush == WeightBrush::add) {
            shares.scale(1.0f - share);
            shares[dab.joint] += share;
        } else if (dab.brush == WeightBrush::subtract) {
            const float before = shares[dab.joint], taken = share * before;
            // To the others as they have shares already; else to the joint before.
            if (before < 1.0f - 1e-4f) {
                shares.scale((1.0f - before + taken) / (1.0f - before));
                shares[dab.joint] = before - taken;
            } else if (parent != FLG_NO_INDEX) {
                shares[dab.joint] -= taken;
                shares[static_cast<uint16_t>(parent)] += taken;
            }
        } else {
            shares.scale(1.0f - share);
            const auto around = neighbours(v);
            for (const uint32_t next : around)
                for (const auto& [joint, weight] : shares_of(next).of)
                    shares[joint] += share * weight / static_cast<float>(around.size());
        }
    }
    // After all of them are known: what is smoothed does not depend on the order.
    for (size_t i = 0; i < reached_.size(); ++i) set(reached_[i], painted[i]);
}

std::vector<float> PaintedWeights::of_joint(uint16_t joint) const {
    std::vector<float> shares(skin_.vertex_count, 0.0f);
    for (size_t i = 0; i < weights_.size(); ++i)
        if (weights_[i] > 0.0f && joints_[i] == joint) shares[i / 4] += weights_[i];
    return shares;
}

}  // namespace flg::studio
