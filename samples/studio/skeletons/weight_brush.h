// SPDX-License-Identifier: MIT
// Weights of a skin under a brush. After each dab they have the sum 1, at most four joints a vertex, the largest first.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "filigree/filigree_model.h"
#include "skeletons/weight_strokes.h"

namespace flg::studio {

class PaintedWeights {
public:
    // A copy of a skin's, which must outlive it: its mesh is used too. Cost: 0.2 us a vertex.
    void begin(const FlgSkinView& skin);
    bool is_of_skin() const { return skin_.vertex_count > 0; }

    struct Dab {
        uint32_t seed = 0;  // the vertex that is nearest: what is painted hangs together with it
        glm::vec3 at{0.0f};
        float radius = 0.0f;  // metres; full strength in the middle, none from here on
        WeightBrush brush = WeightBrush::add;
        float strength = 0.5f;
        uint16_t joint = 0;
    };
    // Cost: 0.1 us a vertex within the radius, three times that to smooth.
    void paint(const Dab& dab);

    // Of all vertices, how much of a joint each has.
    std::vector<float> of_joint(uint16_t joint) const;
    const std::vector<uint16_t>& joints() const { return joints_; }
    const std::vector<float>& weights() const { return weights_; }

private:
    struct Shares;
    Shares shares_of(uint32_t vertex) const;
    void set(uint32_t vertex, const Shares& shares);
    std::span<const uint32_t> neighbours(uint32_t vertex) const;
    glm::vec3 position(uint32_t vertex) const;
    void find_reached(const Dab& dab);

    FlgSkinView skin_{};
    std::vector<uint16_t> joints_;
    std::vector<float> weights_;
    std::vector<uint32_t> neighbour_offsets_, neighbours_;
    // Of a dab, kept for the next one.
    std::vector<uint32_t> reached_, seen_;
    uint32_t dab_ = 0;
};

}  // namespace flg::studio
