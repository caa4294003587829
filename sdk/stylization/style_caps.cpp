// SPDX-License-Identifier: MIT
#include "stylization/style_caps.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr double like_share = 0.1;    // of the distance of unrelated patches
constexpr double like_medians = 2.0;  // of the median distance to the most like patch
constexpr uint32_t patches_per_style = 16;

}  // namespace

StyleCaps marked_caps(std::span<const uint32_t> boundaries, std::span<const float> matching, double last_length,
                      double start_cap, double end_cap) {
    StyleCaps caps;
    const auto place = [&](uint32_t node) { return double{matching[node]}; };
    while (caps.start < boundaries[1] && place(caps.start) < start_cap) ++caps.start;
    const uint32_t end = boundaries.back(), last_curve = end - boundaries[boundaries.size() - 2];
    while (end_cap > 0 && caps.end < last_curve && last_length - place(end - 1 - caps.end) < end_cap) ++caps.end;
    return caps;
}

StyleScene wide_scene(StyleScene scene) {
    scene.patch = std::max(scene.patch, scene.node_count() / (2 * patches_per_style));
    scene.sizes = {};
    return scene;
}

Task<StyleCaps> find_caps(Pace& pace, const PatchGraph& graph, const StyleScene& scene, double rms) {
    Buffer<float> cheapest(graph.node_count, pace.memory());
    co_await each(pace, graph.node_count, Cost::some_ns, [&](uint32_t i) { cheapest[i] = HUGE_VALF; });
    co_await each(pace, graph.jump_count(), Cost::some_ns, [&](uint32_t jump) {
        float& least = cheapest[graph.in_source[jump]];
        least = std::min(least, graph.in_cost[jump]);
    });
    const double median = graph.temperature_unit / PatchGraph::temperature_share;
    const double unrelated = std::sqrt(2.0 * (2 * scene.patch + 1)) * rms;
    const double like = std::max(like_share * unrelated, like_medians * median);
    const uint32_t needed = 2 * scene.patch + 1;
    const uint32_t last_curve = scene.curve_count() - 1;
    StyleCaps caps;
    uint32_t run = 0;
    bool found = false;
    co_await each(pace, scene.first_patch(0), scene.end_patch(0), Cost::some_ns, [&](uint32_t i) {
        run = cheapest[i] <= like ? run + 1 : 0;
        if (run != needed || found) return;
        found = true;
        caps.start = i + 1 - run - scene.patch;
    });
    run = 0;
    co_await each(pace, scene.first_patch(last_curve), scene.end_patch(last_curve), Cost::some_ns, [&](uint32_t i) {
        run = cheapest[i] <= like ? run + 1 : 0;
        if (run >= needed) caps.end = scene.node_count() - (i + scene.patch + 1);
    });
    co_return caps;
}

}  // namespace flg
