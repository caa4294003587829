// SPDX-License-Identifier: MIT
// Tangles in the tests: operators in one line, and what is asked of every tangle.
#pragma once

#include <deque>
#include <set>

#include "api/surface_inputs.h"
#include "filigree/filigree_tangle.h"

namespace flg::test {

using Regions = std::vector<uint32_t>;

class TangleHost : public SurfaceHost {
public:
    explicit TangleHost(uint32_t workers = 0, uint32_t tick_budget_us = FLG_UNLIMITED)
        : SurfaceHost(workers), budget_us(tick_budget_us) {}

    const uint32_t budget_us;

    FlgTangle tangle(FlgSurface surface) const {
        FlgTangle tangle{};
        EXPECT_EQ(flgTangleCreate(context, surface, nullptr, &tangle, nullptr), FLG_OK) << flgErrorGetMessage();
        finish(budget_us);
        return tangle;
    }
    // The job's result.
    FlgResult divide(const FlgTangleDivideDesc& desc) const {
        FlgJob job{};
        EXPECT_EQ(flgTangleDivide(context, &desc, &job), FLG_OK) << flgErrorGetMessage();
        finish(budget_us);
        return result_of(job);
    }
    FlgTangleInfo info(FlgTangle tangle) const {
        FlgTangleInfo info{};
        info.struct_size = sizeof info;
        EXPECT_EQ(flgTangleGetInfo(context, tangle, &info), FLG_OK) << flgErrorGetMessage();
        return info;
    }
    FlgTangleRegion region(FlgTangle tangle, uint32_t region) const {
        FlgTangleRegion out{};
        out.struct_size = sizeof out;
        EXPECT_EQ(flgTangleGetRegion(context, tangle, region, &out), FLG_OK) << flgErrorGetMessage();
        return out;
    }
    FlgResult undo(FlgTangle tangle) const { return step(flgTangleUndo, tangle); }
    FlgResult redo(FlgTangle tangle) const { return step(flgTangleRedo, tangle); }

    // All leaves, rising.
    Regions leaves(FlgTangle tangle) const {
        Regions leaves;
        for (uint32_t r = 0; r < info(tangle).region_count; ++r) {
            const FlgTangleRegion node = region(tangle, r);
            if (node.child_count == 0 && node.joined_into == FLG_NO_INDEX) leaves.push_back(r);
        }
        return leaves;
    }
    Regions children(FlgTangle tangle, uint32_t parent) const {
        const FlgTangleRegion node = region(tangle, parent);
        Regions list;
        for (uint32_t i = 0; i < node.child_count; ++i) list.push_back(node.first_child + i);
        return list;
    }
    // The tree, all of it, to compare.
    std::string tree_bits(FlgTangle tangle) const {
        std::string all;
        for (uint32_t r = 0; r < info(tangle).region_count; ++r) {
            const FlgTangleRegion node = region(tangle, r);
            append(all, &node, 1);
        }
        return all;
    }

private:
    FlgResult step(FlgResult (*go)(FlgContext, FlgTangle, const FlgJobOptions*, FlgJob*), FlgTangle tangle) const {
        FlgJob job{};
        EXPECT_EQ(go(context, tangle, nullptr, &job), FLG_OK) << flgErrorGetMessage();
        finish(budget_us);
        return result_of(job);
    }
};

// Isolines of the distance from what `seeds` says.
inline FlgTangleSeeds samples(float radius) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.sample_radius = radius;
    return seeds;
}

inline FlgTangleSeeds borders(FlgTangleBorders which) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.borders = which;
    return seeds;
}

// Seeds for descriptors that outlive the expression they are made in: kept until the process ends.
inline const FlgTangleSeeds* kept(const FlgTangleSeeds& seeds) {
    static std::deque<FlgTangleSeeds> all;
    return &all.emplace_back(seeds);
}

inline FlgTangleDivideDesc contour(FlgTangle tangle, const Regions& regions, const FlgTangleSeeds& seeds, float delta,
                                   uint32_t count) {
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.tangle = tangle;
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    desc.a = kept(seeds);
    desc.delta = delta;
    desc.count = count;
    return desc;
}

// Regions that touch are of different groups.
inline void expect_chequered(const TangleHost& host, FlgSurface surface, FlgTangle tangle) {
    const FlgSurfaceView view = host.view(surface);
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t other = view.neighbours[3 * t + k];
            if (other == FLG_NO_INDEX || view.mesh->regions[other] == view.mesh->regions[t]) continue;
            EXPECT_NE(host.region(tangle, view.mesh->regions[t]).group,
                      host.region(tangle, view.mesh->regions[other]).group);
        }
    }
}

inline double whole_area(const FlgSurfaceView& view) {
    double sum = 0;
    for (const auto& [label, area] : areas(view)) sum += area;
    return sum;
}

// How many pieces, joined by edges, the triangles of each label are in.
inline std::map<uint32_t, uint32_t> count_pieces(const FlgSurfaceView& view) {
    std::map<uint32_t, uint32_t> pieces;
    std::vector<bool> seen(view.mesh->triangle_count);
    for (uint32_t first = 0; first < view.mesh->triangle_count; ++first) {
        if (seen[first]) continue;
        const uint32_t label = view.mesh->regions[first];
        ++pieces[label];
        std::vector<uint32_t> waiting = {first};
        seen[first] = true;
        while (!waiting.empty()) {
            const uint32_t t = waiting.back();
            waiting.pop_back();
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t other = view.neighbours[3 * t + k];
                if (other == FLG_NO_INDEX || seen[other] || view.mesh->regions[other] != label) continue;
                seen[other] = true;
                waiting.push_back(other);
            }
        }
    }
    return pieces;
}

// Labels are the leaves, each in one piece; areas of children add up to their parent's, leaves to the surface. Parents
// with joined children are left out: what was joined may lie beyond them.
inline void expect_valid(const TangleHost& host, FlgSurface surface, FlgTangle tangle, double area) {
    const FlgSurfaceView view = host.view(surface);
    expect_valid(view);
    const Regions leaves = host.leaves(tangle);
    std::map<uint32_t, double> by_label = areas(view);
    double sum = 0;
    for (const auto& [label, label_area] : by_label) {
        EXPECT_TRUE(std::binary_search(leaves.begin(), leaves.end(), label)) << "label " << label << " is no leaf";
        sum += label_area;
    }
    EXPECT_NEAR(sum, area, 1e-6 * area);
    EXPECT_EQ(by_label.size(), leaves.size());
    for (const auto& [label, pieces] : count_pieces(view)) EXPECT_EQ(pieces, 1u) << "region " << label;
    const FlgTangleInfo info = host.info(tangle);
    EXPECT_EQ(info.leaf_count, leaves.size());
    for (uint32_t r = 0; r < info.region_count; ++r) {
        const FlgTangleRegion node = host.region(tangle, r);
        EXPECT_LT(node.group, info.group_count);
        for (uint32_t child : host.children(tangle, r)) {
            EXPECT_GT(child, r);
            EXPECT_EQ(host.region(tangle, child).parent, r);
        }
    }
}

}  // namespace flg::test
