// SPDX-License-Identifier: MIT
#include "stylization/patch_graph.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t block_size = 256;

}  // namespace

PatchGraphKernel::PatchGraphKernel(const StyleScene& scene, Memory* memory)
    : scene_(scene), memory_(memory), rows_(scene, memory) {
    const uint32_t nodes = scene.node_count();
    graph_.node_count = nodes;
    graph_.curve_count = scene.curve_count();
    graph_.patch = scene.patch;
    graph_.in_begin = Buffer<uint32_t>(nodes + 1, memory);
    graph_.curve_end = Buffer<uint32_t>(nodes, memory);
    uint32_t destinations = 0;
    for (uint32_t curve = 0; curve < scene.curve_count(); ++curve) {
        const uint32_t patches = scene.end_patch(curve) - scene.first_patch(curve);
        if (patches > 0) destinations += patches - 1;
    }
    graph_.destinations = Buffer<uint16_t>(destinations, memory);
    const size_t jumps = static_cast<size_t>(nodes) * (successors_kept + scene.curve_count());
    out_begin_ = Buffer<uint32_t>(nodes + 1, memory);
    out_target_ = Buffer<uint16_t>(jumps, memory);
    out_cost_ = Buffer<float>(jumps, memory);
    cheapest_ = Buffer<float>(nodes, memory);
}

bool PatchGraphKernel::run(uint32_t n) {
    while (stage_ != Stage::done) {
        if (n == 0) return false;
        if (stage_ == Stage::rows) {
            if (!rows_.advance(n)) return false;
            begin_select();
            continue;
        }
        if (stage_ == Stage::unit) {
            if (!median_.run(n)) return false;
            graph_.temperature_unit = PatchGraph::temperature_share * median_.value();
            stage_ = Stage::done;
            continue;
        }
        --n;
        switch (stage_) {
            case Stage::nodes: nodes_block(); break;
            case Stage::select: select_block(); break;
            case Stage::offsets: offsets_block(); break;
            default: scatter_block(); break;
        }
    }
    return true;
}

float PatchGraphKernel::progress() const {
    if (stage_ == Stage::done) return 1.0f;
    return static_cast<float>(sources_done_) / static_cast<float>(graph_.node_count + 1);
}

void PatchGraphKernel::nodes_block() {
    const uint32_t end = std::min(at_ + block_size, graph_.node_count);
    for (; at_ < end; ++at_) {
        while (at_ >= scene_.boundaries[curve_ + 1]) ++curve_;
        graph_.in_begin[at_] = 0;
        graph_.curve_end[at_] = scene_.boundaries[curve_ + 1];
        if (at_ > scene_.first_patch(curve_) && at_ < scene_.end_patch(curve_)) {
            graph_.destinations[destination_count_++] = static_cast<uint16_t>(at_);
        }
    }
    if (at_ == graph_.node_count) stage_ = Stage::rows;
}

void PatchGraphKernel::begin_select() {
    const uint32_t source = rows_.index();
    for (; sources_done_ <= source; ++sources_done_) out_begin_[sources_done_] = jump_count_;
    keep_all_ = source + 1 == scene_.end_patch(rows_.curve());
    best_count_ = 0;
    least_sq_ = INFINITY;
    stage_ = Stage::select;
    to_targets_of(0);
}

void PatchGraphKernel::to_targets_of(uint32_t curve) {
    curve_ = curve;
    while (curve_ < scene_.curve_count() && scene_.end_patch(curve_) <= scene_.first_patch(curve_) + 1) ++curve_;
    if (curve_ < scene_.curve_count()) at_ = scene_.first_patch(curve_);
}

void PatchGraphKernel::select_block() {
    if (curve_ < scene_.curve_count()) {
        const double* row = rows_.row();
        const uint32_t source = rows_.index();
        const uint32_t targets_end = scene_.end_patch(curve_) - 1;
        const uint32_t end = std::min(at_ + block_size, targets_end);
        if (keep_all_) {
            for (uint32_t c = at_; c < end; ++c) {
                if (c != source) add_jump(c + 1, row[c]);
            }
        } else {
            double worst = best_count_ == successors_kept ? best_[best_count_ - 1].cost_sq : INFINITY;
            for (uint32_t c = at_; c < end; ++c) {
                const double v = row[c];
                if (v < worst && v < row[static_cast<ptrdiff_t>(c) - 1] && v <= row[c + 1] && c != source) {
                    consider(c, v);
                    if (best_count_ == successors_kept) worst = best_[best_count_ - 1].cost_sq;
                }
            }
        }
        at_ = end;
        if (at_ == targets_end) to_targets_of(curve_ + 1);
    }
    if (curve_ == scene_.curve_count()) end_row();
}

// Puts a jump into its place among the best; of equal ones the first stays first.
void PatchGraphKernel::consider(uint32_t c, double cost_sq) {
    uint32_t place = best_count_ < successors_kept ? best_count_++ : successors_kept - 1;
    for (; place > 0 && best_[place - 1].cost_sq > cost_sq; --place) best_[place] = best_[place - 1];
    best_[place] = {cost_sq, c + 1};
}

void PatchGraphKernel::add_jump(uint32_t target, double cost_sq) {
    out_target_[jump_count_] = static_cast<uint16_t>(target);
    out_cost_[jump_count_] = static_cast<float>(std::min(std::sqrt(std::max(cost_sq, 0.0)), PatchGraph::cost_max));
    ++jump_count_;
    ++graph_.in_begin[target];
    least_sq_ = std::min(least_sq_, cost_sq);
}

void PatchGraphKernel::end_row() {
    for (uint32_t k = 0; k < best_count_; ++k) add_jump(best_[k].target, best_[k].cost_sq);
    if (least_sq_ < INFINITY) {
        cheapest_[cheapest_count_++] =
            static_cast<float>(std::min(std::sqrt(std::max(least_sq_, 0.0)), PatchGraph::cost_max));
    }
    stage_ = Stage::rows;
    if (!rows_.done()) return;
    for (; sources_done_ <= graph_.node_count; ++sources_done_) out_begin_[sources_done_] = jump_count_;
    graph_.in_source = Buffer<uint16_t>(jump_count_, memory_);
    graph_.in_cost = Buffer<float>(jump_count_, memory_);
    next_place_ = Buffer<uint32_t>(graph_.node_count, memory_);
    at_ = 0;
    jump_count_ = 0;
    stage_ = Stage::offsets;
}

// From the number of jumps into each node to where they begin.
void PatchGraphKernel::offsets_block() {
    const uint32_t end = std::min(at_ + block_size, graph_.node_count);
    for (; at_ < end; ++at_) {
        const uint32_t count = graph_.in_begin[at_];
        graph_.in_begin[at_] = jump_count_;
        next_place_[at_] = jump_count_;
        jump_count_ += count;
    }
    if (at_ < graph_.node_count) return;
    graph_.in_begin[at_] = jump_count_;
    at_ = 0;
    curve_ = 0;
    stage_ = Stage::scatter;
}

// `at_` runs over the jumps, `curve_` is the source of the next.
void PatchGraphKernel::scatter_block() {
    const uint32_t end = std::min(at_ + block_size, jump_count_);
    uint32_t source = curve_;
    for (; at_ < end; ++at_) {
        while (at_ >= out_begin_[source + 1]) ++source;
        const uint32_t place = next_place_[out_target_[at_]]++;
        graph_.in_source[place] = static_cast<uint16_t>(source);
        graph_.in_cost[place] = out_cost_[at_];
    }
    curve_ = source;
    if (at_ < jump_count_) return;
    out_begin_ = {};
    out_target_ = {};
    out_cost_ = {};
    if (cheapest_count_ > 0) {
        median_ = Median(cheapest_.data(), cheapest_count_);
        stage_ = Stage::unit;
    } else {
        stage_ = Stage::done;  // a single destination: no patch has another to jump to
    }
}

}  // namespace flg
