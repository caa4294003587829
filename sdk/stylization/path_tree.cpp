// SPDX-License-Identifier: MIT
#include "stylization/path_tree.h"

#include <algorithm>
#include <limits>

#include "core/vector_targets.h"

namespace flg {

namespace {

constexpr uint32_t lanes = 8;
constexpr uint32_t group_size = 32;
constexpr int32_t infinite = 0x7f800000;

struct TreeInMaking {
    const uint32_t *in_begin, *curve_end;
    const uint16_t* in_source;
    const float* in_cost;
    float temperature;
    float* distance;
    uint16_t* next_hop;
    int32_t *waiting, *least;
    uint32_t group_count;
};

}  // namespace

namespace portable {
#include "stylization/path_tree.inl"
}  // namespace portable

#ifdef FLG_DISPATCH_VECTORS
FLG_BEGIN_AVX2
namespace avx2 {
#include "stylization/path_tree.inl"
}  // namespace avx2
FLG_END_AVX2
#endif

namespace {

constexpr uint32_t rounded_up(uint32_t count, uint32_t step) {
    return (count + step - 1) / step * step;
}

}  // namespace

void PathTreeKernel::begin(const PatchGraph& graph, float temperature, uint32_t destination, uint16_t* next_hop) {
    graph_ = &graph;
    next_hop_ = next_hop;
    temperature_ = temperature + 0.0f;  // the bits of -0 would be the largest
    const uint32_t waiting = rounded_up(graph.node_count, group_size);
    group_count_ = rounded_up(waiting / group_size, lanes);
    if (distance_.size() < graph.node_count) distance_ = Buffer<float>(graph.node_count, memory_);
    if (waiting_.size() < waiting) waiting_ = Buffer<int32_t>(waiting, memory_);
    if (least_.size() < group_count_) least_ = Buffer<int32_t>(group_count_, memory_);
    std::fill_n(distance_.data(), graph.node_count, std::numeric_limits<float>::infinity());
    std::fill_n(waiting_.data(), waiting, infinite);
    std::fill_n(least_.data(), group_count_, infinite);
    std::fill_n(next_hop, graph.node_count, no_hop);
    distance_[destination] = 0;
    waiting_[destination] = least_[destination / group_size] = 0;
    next_hop[destination] = static_cast<uint16_t>(destination);
}

bool PathTreeKernel::run(uint32_t& units) {
    const TreeInMaking tree{graph_->in_begin.data(),
                            graph_->curve_end.data(),
                            graph_->in_source.data(),
                            graph_->in_cost.data(),
                            temperature_,
                            distance_.data(),
                            next_hop_,
                            waiting_.data(),
                            least_.data(),
                            group_count_};
    return FLG_FOR_THIS_MACHINE(settle(tree, units));
}

}  // namespace flg
