// SPDX-License-Identifier: MIT
#include "stylization/synthesis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/moving_frame.h"
#include "core/random.h"

namespace flg {

namespace {

// Samples of a closed curve's last path, at most: the choice is among so many jumps, about 40 ns each.
constexpr uint32_t last_path_max = 256;
// Closed curves begin with so many points of the style before them, or half of a short style curve's.
constexpr uint32_t last_path_wanted = 64;
// The last jump has to be taken, however wide its gap is: so it is cross-faded over so many patches, but once around at
// most.
constexpr uint32_t last_blend_patches = 6;

}  // namespace

StyleWalk::StyleWalk(PathTrees* trees, bool from_start, uint64_t seed, uint64_t curve_index, uint32_t samples)
    : trees_(trees), seed_(seed), curve_index_(curve_index), samples_left_(samples - 1) {
    if (from_start) {
        // To the last destination of the first style curve that has any.
        node_ = trees->graph().start();
        const uint32_t end = trees->graph().curve_end[node_];
        while (destination_ + 1 < trees->destination_count() && trees->destination(destination_ + 1) < end) {
            ++destination_;
        }
        destination_node_ = trees->destination(destination_);
    } else {
        destination_ = random_below(seed, curve_index, draws_++, trees->destination_count());
        node_ = destination_node_ = trees->destination(destination_);
    }
}

void StyleWalk::close(std::span<const Vec3> pinned) {
    const PatchGraph& graph = trees_->graph();
    const uint32_t end = std::min(graph.curve_end[node_], graph.node_count - graph.end_cap);
    uint32_t ahead = 0;  // points of the same style curve before the node
    while (ahead < last_path_max && ahead + graph.start_cap < node_ &&
           graph.curve_end[node_ - ahead - 1] == graph.curve_end[node_])
        ++ahead;
    const uint32_t wanted = std::min(last_path_wanted, (end - node_ + ahead) / 2);
    if (ahead < wanted) {
        node_ += wanted - ahead;
        ahead = wanted;
    }
    if (!pinned.empty()) {
        // Near by, and not so far on that the curve's end is near.
        const uint32_t first = node_ - std::min(last_path_wanted, ahead - wanted);
        const uint32_t middle = node_ - ahead + (end - node_ + ahead) / 2;
        const uint32_t last = std::max(node_, std::min(node_ + last_path_wanted, middle));
        const auto nearer = [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); };
        const auto nearest = std::min_element(pinned.begin() + first, pinned.begin() + last + 1, nearer);
        ahead += static_cast<uint32_t>(nearest - pinned.begin()) - node_;
        node_ = static_cast<uint32_t>(nearest - pinned.begin());
    }
    home_ = node_;
    last_path_ = std::min(std::min(ahead, last_path_max) + 1, samples_left_);
}

void StyleWalk::begin_with_cap() {
    if (trees_->graph().start_cap == 0) return;
    begins_ = trees_->graph().start();
    node_ = 0;
    cap_left_ = trees_->graph().start_cap;
}

void StyleWalk::end_with_cap() {
    const PatchGraph& graph = trees_->graph();
    if (graph.end_cap == 0) return;
    const uint32_t body_end = graph.node_count - graph.end_cap;
    uint32_t run_in = 0;  // points of the same style curve before the cap
    while (run_in < last_path_max && run_in < body_end - graph.start_cap &&
           graph.curve_end[body_end - run_in - 1] == graph.node_count) {
        ++run_in;
    }
    lead_home(graph.node_count - 1, graph.end_cap, run_in);
}

void StyleWalk::take_motifs() {
    const PatchGraph& graph = trees_->graph();
    if (cap_left_ == 0) node_ = graph.start();
    motif_end_ = graph.motif_end();
    if (graph.end_cap == 0) lead_home(motif_end_ - 1, 0, std::min(last_path_max, motif_end_ - 1 - graph.start()));
}

void StyleWalk::lead_home(uint32_t node, uint32_t cap, uint32_t run_in) {
    home_ = node;
    cap_ = cap;
    // The start cap, or the first sample, is not part of it.
    last_path_ = std::min(cap + run_in, samples_left_ - (std::max(cap_left_, 1U) - 1));
}

// At the last patch of a style curve, and the rest of the curve is enough for the rest of the target.
bool StyleWalk::runs_out() const {
    const PatchGraph& graph = trees_->graph();
    const uint32_t points_left = graph.curve_end[node_] - 1 - node_;
    return last_path_ == 0 && points_left == graph.patch && samples_left_ <= points_left;
}

// One of the other destinations. A style with a single one is begun again.
void StyleWalk::draw_destination() {
    const uint32_t others = trees_->destination_count() - 1;
    if (others == 0) {
        node_ = trees_->graph().start();
    } else {
        const uint32_t drawn = random_below(seed_, curve_index_, draws_++, others);
        destination_ = drawn < destination_ ? drawn : drawn + 1;
        destination_node_ = trees_->destination(destination_);
    }
    hops_ = hot_hops_ = nullptr;
}

bool StyleWalk::advance(bool hot) {
    if (going_home_) [[unlikely]] {
        node_ = copies_ == 0 ? landing(0) : node_ + 1;
        --copies_;  // having jumped, below 0: more than there are samples
        --samples_left_;
        return true;
    }
    if (cap_left_ > 0) [[unlikely]] {
        --cap_left_;
        node_ = cap_left_ == 0 ? begins_ : node_ + 1;
        --samples_left_;
        return true;
    }
    if (motif_end_ > 0) {
        node_ = node_ + 2 == motif_end_ ? trees_->graph().start() : node_ + 1;
        --samples_left_;
        return true;
    }
    if (node_ == destination_node_ && !finishing_) {
        finishing_ = runs_out();
        if (!finishing_) draw_destination();
    }
    if (finishing_) {
        ++node_;
    } else {
        const uint16_t*& hops = hot ? hot_hops_ : hops_;
        if (hops == nullptr) hops = (hot ? hot_trees_ : trees_)->find(destination_);
        if (hops == nullptr) return false;
        node_ = hops[node_];
    }
    --samples_left_;
    return true;
}

SynthesisKernel::SynthesisKernel(const SynthesisInput& input, Memory* memory)
    : input_(input),
      tree_kernel_(memory),
      first_steered_(input.steered ? size_t{last_blend_patches} * input.trees->graph().patch + 1 : 0, memory) {}

void SynthesisKernel::begin(const StrokeInput& stroke) {
    stroke_ = stroke;
    sampler_.emplace(stroke.plan);
    count_ = stroke.plan.sample_count();
    written_ = 0;
    block_at_ = block_count_ = 0;
    node_known_ = true;
    finishing_.reset();
    steered_.fill({.scale = stroke.across});
    // On closed curves one more than samples: where the style is when the curve has come around.
    const bool has_end = stroke.plan.exact_step == 0 || input_.trees->graph().end_cap > 0;
    walk_ = StyleWalk(input_.trees, stroke.from_start, input_.seed, stroke.key,
                      has_end ? stroke.plan.steps + 1 : StyleWalk::endless);
    walk_.heat(input_.hot_trees);
    if (stroke.plan.curve.closed && stroke.plan.steps > 0) {
        walk_.close(input_.pin_ends ? all_displacements() : std::span<const Vec3>());
    } else if (stroke.plan.steps > 0) {
        walk_.begin_with_cap();
        walk_.end_with_cap();
        if (stroke.whole_motifs) walk_.take_motifs();
    }
    blend_ = SeamBlend(input_.trees->graph().patch, input_.style->attributes);
    angle_ = input_.style->find(FLG_ATTRIBUTE_ANGLE);
}

bool SynthesisKernel::run(uint32_t n) {
    while (written_ < count_) {
        if (block_at_ == block_count_) {
            if (n == 0) return false;
            block_at_ = 0;
            block_count_ = sampler_->next(block_.data(), sample_block, n);
            if (stroke_.steered) steer_block();
        }
        const uint32_t first = block_at_;
        bool out_of_units = false;
        while (block_at_ < block_count_ && !out_of_units) {
            if (find_node(n)) {
                write(block_[block_at_], steered_[block_at_]);
                ++block_at_;
            } else {
                out_of_units = true;
            }
        }
        write_carried(first);
        if (stroke_.steered) steer_carried_radii(first);
        if (out_of_units) return false;
    }
    return finish(n);
}

// To the next node, unless its path tree is missing.
bool SynthesisKernel::advance() {
    const uint32_t from = walk_.node();
    if (walk_.turns_home()) [[unlikely]] {
        const uint32_t points = std::min(last_blend_patches * input_.trees->graph().patch, stroke_.plan.steps);
        walk_.go_home(copies_before_last_jump(points));
        blend_.cross_fade(points, all_displacements(),
                          {input_.trees->graph().curve_end.data(), input_.trees->graph().curve_end.size()});
    }
    if (!walk_.advance(is_hot())) return false;
    blend_.step(from, walk_.node(), [this](uint32_t node) -> const Vec3& { return input_.style->displacement[node]; });
    return true;
}

void SynthesisKernel::steer_block() {
    for (uint32_t k = 0; k < block_count_; ++k) {
        const FramedSample& sample = block_[k];
        const Steered& next = stroke_.steered[stroke_.plan.curve.following(sample.segment)];
        steered_[k] = stroke_.steered[sample.segment].between(next, sample.t);
        steered_[k].scale *= stroke_.across;
        if (written_ + k < first_steered_.size()) std::construct_at(&first_steered_[written_ + k], steered_[k]);
    }
}

// At the sample to come: of a closed curve, behind the last one, the first.
const Steered& SynthesisKernel::steered() const {
    return block_at_ < block_count_ ? steered_[block_at_] : first_steered_[0];
}

std::span<const Steered> SynthesisKernel::first_steered() const {
    if (!stroke_.steered) return {};
    return {first_steered_.data(), std::min<size_t>(first_steered_.size(), written_)};
}

bool SynthesisKernel::is_hot() const {
    return input_.hot_trees && steered().is_hot(input_.seed, stroke_.key, written_);
}

std::span<const Vec3> SynthesisKernel::all_displacements() const {
    return {input_.style->displacement.data(), input_.style->displacement.size()};
}

// Where along the last path the runs before and behind the jump differ least, over as many points as they are
// cross-faded. Places come first where the seam before is over, both runs go on so far, and so does the path. The end
// cap is not jumped into, nor copied before its time.
uint32_t SynthesisKernel::copies_before_last_jump(uint32_t points) const {
    const Buffer<Vec3>& displacement = input_.style->displacement;
    const PatchGraph& graph = input_.trees->graph();
    const uint32_t end = std::min(graph.curve_end[walk_.node()], graph.node_count - graph.end_cap);
    const uint32_t home_end = graph.curve_end[walk_.landing(0)];
    uint32_t best = 0;
    bool best_has_room = false;
    double least = HUGE_VAL;
    const uint32_t copies_end = std::min(walk_.samples_left(), walk_.before_cap() + 1);
    for (uint32_t copies = 0; copies < copies_end && walk_.node() + copies + 1 < end; ++copies) {
        const uint32_t from = walk_.node() + copies + 1, to = walk_.landing(copies);
        const bool has_room = copies >= blend_.points_left() && from + points < end && to + points < home_end &&
                              copies + points < walk_.before_cap();
        if (best_has_room && !has_room) continue;
        double difference = 0;
        for (uint32_t probe = 0; probe <= last_blend_patches; ++probe) {
            const uint32_t on = probe * points / last_blend_patches;
            difference +=
                (displacement[std::min(from + on, end - 1)] - displacement[std::min(to + on, home_end - 1)]).norm();
        }
        if (difference >= least && has_room == best_has_room) continue;
        least = difference;
        best = copies;
        best_has_room = has_room;
    }
    return best;
}

// Stands on the node of the sample to come, unless the units do not suffice for the path tree that is missing.
bool SynthesisKernel::find_node(uint32_t& units) {
    while (!node_known_) {
        if (advance()) {
            node_known_ = true;
            // Another thread was faster with the tree.
            if (tree_ != nullptr) input_.trees->discard(std::exchange(tree_, nullptr));
        } else if (!make_tree(units)) {
            return false;
        }
    }
    return true;
}

// The carried columns of the block's samples that were just written, from `first` on.
void SynthesisKernel::write_carried(uint32_t first) {
    if (stroke_.carried.empty()) return;
    const uint32_t count = block_at_ - first;
    std::array<SamplePlace, sample_block> places;
    for (uint32_t k = 0; k < count; ++k) places[k] = {block_[first + k].segment, block_[first + k].t};
    for (const ColumnPair& column : stroke_.carried) {
        interpolate_column(column, stroke_.plan.curve, {places.data(), count}, written_ - count);
    }
}

// The target's radii: those of the style are steered with the other attributes.
void SynthesisKernel::steer_carried_radii(uint32_t first) {
    if (stroke_.out.carried_radius == nullptr) return;
    const uint32_t count = block_at_ - first;
    for (uint32_t k = 0; k < count; ++k) stroke_.out.carried_radius[written_ - count + k] *= steered_[first + k].radius;
}

bool SynthesisKernel::make_tree(uint32_t& units) {
    PathTrees& trees = is_hot() ? *input_.hot_trees : *input_.trees;
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

// A target without length has no frame to be displaced in.
Vec3 SynthesisKernel::displaced_in(const FramedSample& sample, const Vec3& d) const {
    if (stroke_.plan.steps == 0) return Vec3::Zero();
    return in_frame(d, sample.tangent, sample.normal);
}

void SynthesisKernel::write(const FramedSample& sample, const Steered& steered) {
    const StylizedColumns& out = stroke_.out;
    const Vec3 displacement =
        steered.weight() * displaced_in(sample, input_.style->displacement[walk_.node()] + blend_.offset());
    const size_t at = 3 * static_cast<size_t>(written_);
    const Vec3 position = sample.position + input_.magnitude * displacement;
    check_position(position, input_.magnitude);
    store_vec3(position, out.frames.positions + at);
    store_vec3(sample.tangent, out.frames.tangents + at);
    store_vec3(sample.normal, out.frames.normals + at);
    if (out.displacement) store_vec3(displacement, out.displacement + at);
    out.style_index[written_] = static_cast<float>(walk_.node());
    write_attributes(sample, steered);
    if (written_ == 0) {
        first_ = sample;
        first_displacement_ = displacement;
    }
    last_displacement_ = displacement;
    ++written_;
    node_known_ = false;
}

void SynthesisKernel::write_attributes(const FramedSample& sample, const Steered& steered) {
    const AppliedStyle& style = *input_.style;
    for (size_t a = 0; a < style.attributes.size(); ++a) {
        const size_t at = size_t{written_} * style.attributes[a].components;
        const double scale = style.scale * steered.size(style.attributes[a].attribute);
        blend_.write(a, walk_.node(), scale, stroke_.out.attributes[a] + at);
    }
    if (angle_ == style.attributes.size()) return;
    const Vec3 normal = turned_about(sample.tangent, sample.normal, blend_.value(angle_, 0, walk_.node()));
    store_vec3(normal, stroke_.out.frames.normals + 3 * static_cast<size_t>(written_));
}

// Once all samples are written.
bool SynthesisKernel::finish(uint32_t& units) {
    if (!finishing_) {
        const bool has_ends = stroke_.plan.steps > 0;
        const bool closed = has_ends && stroke_.plan.curve.closed;
        const bool pinned = has_ends && input_.pin_ends;
        if (!closed && !pinned && !stroke_.out.time) return true;
        if (closed) {
            // The curve's first sample, and what of the last seam is not over there.
            if (!find_node(units)) return false;
            const double weight = stroke_.steered ? first_steered_[0].weight() : 1.0;
            first_displacement_ += weight * displaced_in(first_, blend_.offset());
            last_displacement_ = first_displacement_;
        }
        const FinishingInput finishing{.out = stroke_.out,
                                       .style = input_.style,
                                       .target = stroke_.plan.curve,
                                       .count = count_,
                                       .steps = stroke_.plan.steps,
                                       .magnitude = input_.magnitude,
                                       .pinned = pinned,
                                       .closed = closed,
                                       .start_excess = first_displacement_,
                                       .end_excess = last_displacement_,
                                       .around = blend_,
                                       .first_steered = first_steered(),
                                       .start_time = stroke_.start_time};
        finishing_.emplace(finishing);
    }
    return finishing_->run(units);
}

}  // namespace flg
