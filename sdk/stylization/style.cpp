// SPDX-License-Identifier: MIT
#include "stylization/style.h"

#include <algorithm>
#include <cinttypes>

#include "runtime/host.h"

namespace flg {

namespace {

// Of the guide's length: the root mean square of a displacement that cannot be seen.
constexpr double unseen_share = 1e-5;

}  // namespace

double PreparedStyle::squared_bend(uint32_t point) const {
    const bool inner =
        point > 0 && point + 1 < point_count() && graph.curve_end[point - 1] == graph.curve_end[point + 1];
    if (!inner) return 0;
    double sum = 0;
    for (const Buffer<double>* d :
         {&displacement.along_tangent, &displacement.along_normal, &displacement.along_binormal}) {
        const double second = (*d)[point - 1] - 2 * (*d)[point] + (*d)[point + 1];
        sum += second * second;
    }
    return sum;
}

bool Style::has_nothing_to_learn() const {
    return prepared.displacement_rms < unseen_share * prepared.guide_length;
}

void Style::warn(const Host& host) const noexcept {
    if (!has_nothing_to_learn()) return;
    host.log(FLG_LOG_LEVEL_WARNING,
             "style (0x%" PRIx64 ") has nothing to learn: its example is its own guide, straight or without waves",
             handle);
}

std::shared_ptr<PathTrees> Style::trees(float asked_temperature) {
    const float temperature = PathTrees::finite_temperature(prepared.graph, asked_temperature);
    std::lock_guard lock(mutex_);
    const auto found = std::find_if(trees_.begin(), trees_.end(),
                                    [&](const auto& trees) { return trees->temperature() == temperature; });
    if (found != trees_.end()) {
        std::rotate(found, found + 1, trees_.end());
    } else {
        if (trees_.size() == temperatures_kept) trees_.erase(trees_.begin());
        trees_.push_back(std::allocate_shared<PathTrees>(std::pmr::polymorphic_allocator<PathTrees>(caches_),
                                                         prepared.graph, temperature, caches_));
    }
    return trees_.back();
}

FlgStyleInfo Style::info() const {
    return {.struct_size = sizeof(FlgStyleInfo),
            .point_count = prepared.point_count(),
            .patch = prepared.graph.patch,
            .edge_count = prepared.graph.edge_count(),
            .style_length = static_cast<float>(prepared.style_length),
            .guide_length = static_cast<float>(prepared.guide_length),
            .spacing = static_cast<float>(prepared.spacing()),
            .displacement_rms = static_cast<float>(prepared.displacement_rms),
            .matching_energy = static_cast<float>(prepared.matching_energy),
            .temperature_unit = prepared.graph.temperature_unit,
            .flow_steps = prepared.flow_steps,
            .reserved = 0,
            .matching = prepared.matching.data(),
            .start_cap_points = prepared.graph.start_cap,
            .end_cap_points = prepared.graph.end_cap};
}

}  // namespace flg
