// SPDX-License-Identifier: MIT
#include "stylization/synthesis.h"

#include <Eigen/Geometry>
#include <array>

#include "core/random.h"

namespace flg {

StyleWalk::StyleWalk(PathTrees* trees, bool from_start, uint64_t seed, uint64_t curve_index, uint32_t samples)
    : trees_(trees), seed_(seed), curve_index_(curve_index), samples_left_(samples - 1) {
    if (from_start) {
        // The last destination of the first style curve.
        const uint32_t end = trees->graph().curve_end[0];
        while (destination_ + 1 < trees->destination_count() && trees->destination(destination_ + 1) < end) {
            ++destination_;
        }
        destination_node_ = trees->destination(destination_);
    } else {
        destination_ = random_below(seed, curve_index, draws_++, trees->destination_count());
        node_ = destination_node_ = trees->destination(destination_);
    }
}

// At the last patch of a style curve, and the rest of the curve is enough for the rest of the target.
bool StyleWalk::runs_out() const {
    const PatchGraph& graph = trees_->graph();
    const uint32_t points_left = graph.curve_end[node_] - 1 - node_;
    return points_left == graph.patch && samples_left_ <= points_left;
}

// One of the other destinations. A style with a single one is begun again.
void StyleWalk::draw_destination() {
    const uint32_t others = trees_->destination_count() - 1;
    if (others == 0) {
        node_ = 0;
    } else {
        const uint32_t drawn = random_below(seed_, curve_index_, draws_++, others);
        destination_ = drawn < destination_ ? drawn : drawn + 1;
        destination_node_ = trees_->destination(destination_);
    }
    hops_ = nullptr;
}

bool StyleWalk::advance() {
    if (node_ == destination_node_ && !finishing_) {
        finishing_ = runs_out();
        if (!finishing_) draw_destination();
    }
    if (finishing_) {
        ++node_;
    } else {
        if (hops_ == nullptr) hops_ = trees_->find(destination_);
        if (hops_ == nullptr) return false;
        node_ = hops_[node_];
    }
    --samples_left_;
    return true;
}

void SynthesisKernel::begin(const SamplingPlan& plan, uint64_t curve_index, const StylizedColumns& out,
                            std::span<const ColumnPair> columns) {
    sampler_.emplace(plan);
    curve_ = plan.curve;
    out_ = out;
    columns_ = columns;
    count_ = plan.sample_count();
    written_ = 0;
    block_at_ = block_count_ = 0;
    node_known_ = true;
    walk_ = StyleWalk(input_.trees, input_.from_start, input_.seed, curve_index, count_);
    // A target without length has no frame to be displaced in.
    factor_ = plan.steps > 0 ? input_.magnitude * input_.scale : 0.0;
}

bool SynthesisKernel::run(uint32_t n) {
    while (written_ < count_) {
        if (block_at_ == block_count_) {
            if (n == 0) return false;
            block_at_ = 0;
            block_count_ = sampler_->next(block_.data(), sample_block, n);
        }
        const uint32_t first = block_at_;
        bool out_of_units = false;
        while (block_at_ < block_count_ && !out_of_units) {
            if (find_node(n)) {
                write(block_[block_at_++]);
            } else {
                out_of_units = true;
            }
        }
        carry_columns(first);
        if (out_of_units) return false;
    }
    return true;
}

// Stands on the node of the sample to come, unless the units do not suffice for the path tree that is missing.
bool SynthesisKernel::find_node(uint32_t& units) {
    while (!node_known_) {
        if (walk_.advance()) {
            node_known_ = true;
            // Another thread was faster with the tree.
            if (tree_ != nullptr) input_.trees->discard(std::exchange(tree_, nullptr));
        } else if (!make_tree(units)) {
            return false;
        }
    }
    return true;
}

// The other columns of the block's samples that were just written, from `first` on.
void SynthesisKernel::carry_columns(uint32_t first) {
    if (columns_.empty()) return;
    std::array<SamplePlace, sample_block> places;
    const uint32_t count = block_at_ - first;
    for (uint32_t k = 0; k < count; ++k) places[k] = {block_[first + k].segment, block_[first + k].t};
    for (const ColumnPair& column : columns_) {
        interpolate_column(column, curve_, {places.data(), count}, written_ - count);
    }
}

bool SynthesisKernel::make_tree(uint32_t& units) {
    PathTrees& trees = *input_.trees;
    const uint32_t k = walk_.needed_tree();
    if (tree_ == nullptr) {
        if (units == 0) return false;
        --units;
        tree_ = trees.allocate();
        tree_kernel_.begin(trees.graph(), trees.temperature(), trees.destination(k), tree_);
    }
    if (!tree_kernel_.run(units)) return false;
    trees.publish(k, std::exchange(tree_, nullptr));
    return true;
}

void SynthesisKernel::write(const FramedSample& sample) {
    const Displacement& d = *input_.displacement;
    const uint32_t node = walk_.node();
    const Vec3 binormal = sample.tangent.cross(sample.normal);
    const Vec3 position =
        sample.position + factor_ * (d.along_tangent[node] * sample.tangent + d.along_normal[node] * sample.normal +
                                     d.along_binormal[node] * binormal);
    const size_t at = 3 * static_cast<size_t>(written_);
    store_vec3(position, out_.frames.positions + at);
    store_vec3(sample.tangent, out_.frames.tangents + at);
    store_vec3(sample.normal, out_.frames.normals + at);
    out_.style_index[written_] = static_cast<float>(node);
    ++written_;
    node_known_ = false;
}

}  // namespace flg
