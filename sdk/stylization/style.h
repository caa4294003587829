// SPDX-License-Identifier: MIT
// A prepared style: what Algorithm 1 (Minarcik, Fiser, Sykora) computes before it sees a target.
//
// What lives in this room: the paper's stages, each a kernel that can be used and tested by itself, in the order
// guide_flow, guide_matching, displacement, style_attributes, patch_matrix and
// patch_graph, path_tree, applied_style, displaced_block, synthesis, seam_blend, finishing; the two jobs that drive
// them, prepare_style and apply_style. What does not: curves as such (curves/), scheduling (runtime/).
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "curves/curve_set.h"
#include "stylization/displacement.h"
#include "stylization/patch_graph.h"
#include "stylization/path_trees.h"
#include "stylization/style_attributes.h"

namespace flg {

// Filled in by prepare_style, then never changed (but for the cache of path trees) and shared by all threads.
struct PreparedStyle {
    explicit PreparedStyle(Memory* memory) : attributes(memory) {}

    // Open curves with POSITION, TANGENT, NORMAL. Their points, one curve behind the other, are the style's points, and
    // so the nodes of the graph; where each curve begins is guide->offsets().
    std::shared_ptr<CurveSet> guide;
    Displacement displacement;
    std::pmr::vector<StyleAttribute> attributes;
    PatchGraph graph;
    Buffer<float> matching;                     // arc lengths on the style curve, metres
    double style_length = 0, guide_length = 0;  // metres, of all curves together
    double displacement_rms = 0;                // metres
    double bend = 0;                            // root mean square of the displacement's second differences, metres
    double matching_energy = 0;                 // square metres, mean over the points
    uint32_t flow_steps = 0;

    uint32_t point_count() const { return displacement.size(); }
    // The displacement's second difference at a point, squared; 0 at the ends of its curve.
    double squared_bend(uint32_t point) const;
    // Of neighbouring points of the guide, metres: each curve is sampled as nearly so as whole steps allow.
    double spacing() const { return guide_length / (point_count() - guide->curve_count()); }
    // Metres; `units` of temperature_unit.
    float temperature(double units) const { return static_cast<float>(units * double{graph.temperature_unit}); }
};

class Style final : public Product {
public:
    Style(Memory* memory, Memory* caches) : prepared(memory), caches_(caches), trees_(caches) {}

    PreparedStyle prepared;

    // [any thread] The path trees at a temperature (metres), shared by all jobs that ask for the same; those of the
    // last few temperatures are kept. Only once the style is prepared.
    std::shared_ptr<PathTrees> trees(float asked_temperature);

    FlgStyleInfo info() const;
    // An example that is straight or too short to have waves is its own guide.
    bool has_nothing_to_learn() const;
    void warn(const Host& host) const noexcept override;

private:
    void show() noexcept override { prepared.guide->publish_complete(); }

    static constexpr size_t temperatures_kept = 4;

    Memory* caches_;
    std::mutex mutex_;
    std::pmr::vector<std::shared_ptr<PathTrees>> trees_;  // the one used last at the end
};

}  // namespace flg
