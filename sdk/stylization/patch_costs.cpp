// SPDX-License-Identifier: MIT
#include "stylization/patch_costs.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t block_size = 256;

}  // namespace

PatchCosts::PatchCosts(const StyleScene& scene, Memory* memory)
    : scene_(scene),
      several_(scene.sizes.size() > 1 || (scene.sizes.size() == 1 && scene.sizes.front().weight != 1)),
      rows_(memory) {
    if (!several_) {
        rows_.emplace_back(scene, memory);
        return;
    }
    rows_.reserve(scene.sizes.size());
    for (const FlgPatchSize& size : scene.sizes) rows_.emplace_back(scene, size.patch, memory);
    costs_ = Buffer<double>(size_t{scene.node_count()} + 2, memory);
}

bool PatchCosts::advance(uint32_t& units) {
    if (!several_) return rows_.front().advance(units);
    while (size_ < rows_.size()) {
        if (!adding_ && !rows_[size_].advance(units)) return false;
        adding_ = true;
        const auto count = static_cast<uint32_t>(costs_.size());
        while (column_ < count) {
            if (units == 0) return false;
            --units;
            const uint32_t end = std::min(column_ + block_size, count);
            add_block(end);
            column_ = end;
        }
        adding_ = false;
        column_ = 0;
        ++size_;
    }
    size_ = 0;
    return true;
}

void PatchCosts::add_block(uint32_t end) {
    const double* distance_sq = rows_[size_].row() - 1;
    const double weight = scene_.sizes[size_].weight;
    double* costs = costs_.data();
    const bool first = size_ == 0;
    const bool last = size_ + 1 == rows_.size();
    for (uint32_t c = column_; c < end; ++c) {
        const double cost = (first ? 0.0 : costs[c]) + weight * std::sqrt(std::max(distance_sq[c], 0.0));
        costs[c] = last ? cost * cost : cost;
    }
}

}  // namespace flg
