// SPDX-License-Identifier: MIT
// Sequences of random steps: every operator, macro and change of groups, on any region that is there.
#pragma once

#include <random>

#include "tangles/tangle_host.h"

namespace flg::test {

class RandomSession {
public:
    RandomSession(const TangleHost& host, FlgSurface surface, FlgTangle tangle, uint64_t seed)
        : host_(host), surface_(surface), tangle_(tangle), random_(seed) {}

    // One step more, if it does not fail; what it was is said in `last`.
    FlgResult step() {
        switch (draw(16)) {
            case 0: return displace();
            case 1: return group();
            case 2: return ungroup();
            case 3:
            case 4: return join();
            case 5:
            case 6: return macro();
            default: return divide();
        }
    }
    uint32_t draw(uint32_t count) { return static_cast<uint32_t>(random_() % count); }

    std::string last;

private:
    FlgResult finish(FlgResult started, FlgJob job) {
        EXPECT_EQ(started, FLG_OK) << last << ": " << flgErrorGetMessage();
        if (started != FLG_OK) return started;
        host_.finish(host_.budget_us);
        return host_.result_of(job);
    }
    uint32_t any_region() { return draw(host_.info(tangle_).region_count); }
    float share() { return static_cast<float>(draw(1000)) / 1000; }

    FlgTangleSeeds seeds() {
        FlgTangleSeeds seeds = flgTangleSeedsDefaults();
        switch (draw(7)) {
            case 0: seeds.borders = FLG_TANGLE_BORDERS_OUTER; break;
            case 1: seeds.borders = FLG_TANGLE_BORDERS_EACH; break;
            case 2:
                stretch_ = {0, 0.9f * share(), 1};
                seeds.stretches = &stretch_;
                seeds.stretch_count = 1;
                break;
            case 3:
                for (FlgSurfacePoint& point : points_) {
                    point = {draw(host_.view(surface_).mesh->triangle_count), share() / 2, share() / 2};
                }
                seeds.points = points_.data();
                seeds.point_count = static_cast<uint32_t>(points_.size());
                break;
            case 4: seeds.border_spacing = 0.3f; break;
            default: seeds.sample_radius = 0.2f + 0.4f * share();
        }
        return seeds;
    }
    FlgResult divide() {
        on_ = {any_region()};
        FlgTangleSeeds a = seeds(), b = flgTangleSeedsDefaults();
        FlgTangleDivideDesc desc = contour(tangle_, on_, a, 0.02f + 0.1f * share(), 1 + draw(2));
        desc.kind = static_cast<FlgTangleOperator>(std::max(0, static_cast<int>(draw(6)) - 2));
        if (desc.kind == FLG_TANGLE_OPERATOR_STREAM) desc.delta = 0.2f;
        if (desc.kind == FLG_TANGLE_OPERATOR_STREAM && draw(2) == 0) a.borders = FLG_TANGLE_BORDERS_OUTER;
        if (desc.kind == FLG_TANGLE_OPERATOR_CONTOUR && draw(4) == 0) b.sample_radius = 0.4f;
        if (desc.kind == FLG_TANGLE_OPERATOR_POLYLINE) {
            for (FlgSurfacePoint& point : points_) {
                point = {draw(host_.view(surface_).mesh->triangle_count), 0.25f, 0.5f};
            }
            a = flgTangleSeedsDefaults();
            a.points = points_.data();
            a.point_count = static_cast<uint32_t>(points_.size());
            desc.closed = draw(2);
        }
        if (desc.kind == FLG_TANGLE_OPERATOR_VORONOI && a.point_count == 0 && a.border_spacing == 0) {
            a.sample_radius = 0.3f;
        }
        desc.a = &a;
        desc.b = &b;
        desc.seed = random_();
        desc.grouping = static_cast<FlgTangleGrouping>(draw(4));
        desc.scaffold = draw(5) == 0;
        if (draw(6) == 0) desc.perturbation = 0.02f;
        desc.frequency = 4;
        last = "operator " + std::to_string(desc.kind) + " on " + std::to_string(on_[0]);
        FlgJob job{};
        const FlgResult started = flgTangleDivide(host_.context, &desc, &job);
        return finish(started, job);
    }
    FlgResult macro() {
        on_ = {any_region()};
        FlgTangleApplyMacroDesc desc = flgTangleApplyMacroDefaults();
        desc.tangle = tangle_;
        desc.kind = static_cast<FlgTangleMacro>(draw(8));
        desc.regions = on_.data();
        desc.region_count = 1;
        desc.count = 1 + draw(3);
        desc.size = 0.05f + 0.1f * share();
        desc.spacing = 0.3f;
        desc.seed = random_();
        last = "macro " + std::to_string(desc.kind) + " on " + std::to_string(on_[0]);
        FlgJob job{};
        const FlgResult started = flgTangleApplyMacro(host_.context, &desc, &job);
        return finish(started, job);
    }
    FlgResult displace() {
        on_ = {any_region()};
        FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
        desc.tangle = tangle_;
        desc.regions = on_.data();
        desc.region_count = 1;
        desc.amount = 0.01f * share();
        desc.bias = 0.3f + 0.4f * share();
        desc.gain = 0.6f;
        last = "displacement of " + std::to_string(on_[0]);
        FlgJob job{};
        const FlgResult started = flgTangleDisplace(host_.context, &desc, &job);
        return finish(started, job);
    }
    FlgResult group() {
        on_ = {any_region(), any_region(), any_region()};
        last = "group";
        FlgJob job{};
        const FlgResult started = flgTangleGroup(host_.context, tangle_, on_.data(), 3, nullptr, &job);
        return finish(started, job);
    }
    FlgResult ungroup() {
        const uint32_t group = host_.region(tangle_, any_region()).group;
        last = "ungroup " + std::to_string(group);
        FlgJob job{};
        const FlgResult started = flgTangleUngroup(host_.context, tangle_, group, nullptr, &job);
        return finish(started, job);
    }
    // Two that touch, mostly.
    FlgResult join() {
        const FlgSurfaceView view = host_.view(surface_);
        const uint32_t first = draw(view.mesh->triangle_count);
        uint32_t second = draw(view.mesh->triangle_count);
        for (uint32_t t = 0; t < view.mesh->triangle_count && draw(50) != 0; ++t) {
            if (view.mesh->regions[t] != view.mesh->regions[first]) continue;
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t other = view.neighbours[3 * t + k];
                if (other != FLG_NO_INDEX && view.mesh->regions[other] != view.mesh->regions[first]) second = other;
            }
        }
        on_ = {view.mesh->regions[first], view.mesh->regions[second]};
        last = "join of " + std::to_string(on_[0]) + " and " + std::to_string(on_[1]);
        FlgJob job{};
        const FlgResult started = flgTangleJoin(host_.context, tangle_, on_.data(), 2, nullptr, &job);
        return finish(started, job);
    }

    const TangleHost& host_;
    const FlgSurface surface_;
    const FlgTangle tangle_;
    std::mt19937_64 random_;
    Regions on_;
    FlgBorderStretch stretch_{};
    std::array<FlgSurfacePoint, 3> points_{};
};

}  // namespace flg::test
