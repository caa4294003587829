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

void StyleWalk::take_motifs(std::span<const uint32_t> joints) {
    motif_ = joints.front();
    motif_end_ = joints.back() + 1;
    if (cap_left_ == 0) node_ = motif_;
    if (joints.size() > 2) {
        to_the_point_ = true;
        if (last_path_ > 0) last_path_ = steps_behind(trees_->graph(), joints);
    } else if (last_path_ == 0) {
        lead_home(motif_end_ - 1, 0, std::min(last_path_max, motif_end_ - 1 - motif_));
    }
}

void StyleWalk::lead_home(uint32_t node, uint32_t cap, uint32_t run_in) {
    home_ = node;
    cap_ = cap;
    // The start cap, or the first sample, is not part of it.
    last_path_ = std::min(cap + run_in, samples_left_ - (std::max(cap_left_, 1U) - 1));
}

// Where along the last path the runs before and behind the jump differ least, over as many points as they are
// cross-faded. Places come first where the seam before is over, both runs go on so far, and so does the path. The end
// cap is not jumped into, nor copied before its time.
uint32_t StyleWalk::copies_before_last_jump(uint32_t points, uint32_t blended,
                                            std::span<const Vec3> displacement) const {
    const PatchGraph& graph = trees_->graph();
    const uint32_t end = std::min(graph.curve_end[node_], graph.node_count - graph.end_cap);
    const uint32_t home_end = graph.curve_end[landing(0)];
    uint32_t best = 0;
    bool best_has_room = false;
    double least = HUGE_VAL;
    const uint32_t copies_end = std::min(samples_left_, before_cap() + 1);
    for (uint32_t copies = 0; copies < copies_end && node_ + copies + 1 < end; ++copies) {
        const uint32_t from = node_ + copies + 1, to = landing(copies);
        const bool has_room =
            copies >= blended && from + points < end && to + points < home_end && copies + points < before_cap();
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

// Once a curve: kept out of what each sample runs through.
[[gnu::noinline]] void StyleWalk::go_home(uint32_t steps, std::span<const Vec3> displacement, SeamBlend& blend) {
    const PatchGraph& graph = trees_->graph();
    const uint32_t points = std::min(last_blend_patches * graph.patch, steps);
    copies_ = to_the_point_ ? 0 : copies_before_last_jump(points, blend.points_left(), displacement);
    going_home_ = true;
    blend.cross_fade(points, displacement, {graph.curve_end.data(), graph.curve_end.size()});
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

uint32_t StyleWalk::copy_on(uint32_t most) {
    if (going_home_) return 0;
    // Whole motifs may end at a corner, which the last sample turns.
    const uint32_t kept = std::max(last_path_, to_the_point_ ? 1U : 0U);
    most = std::min(most, samples_left_ - std::min(samples_left_, kept));
    uint32_t copies = 0;
    if (cap_left_ > 0) {
        copies = std::min(most, cap_left_ - 1);
        cap_left_ -= copies;
    } else if (motif_end_ > 0) {
        copies = std::min(most, motif_end_ - std::min(motif_end_, node_ + 2));
    } else if (finishing_) {
        copies = most;
    } else if (hops_ != nullptr && hot_trees_ == nullptr) {
        most = std::min(most, destination_node_ >= node_ ? destination_node_ - node_ : most);
        while (copies < most && hops_[node_ + copies] == node_ + copies + 1) ++copies;
    }
    node_ += copies;
    samples_left_ -= copies;
    return copies;
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
        // What comes behind the motifs goes on from their last node, not from the first, which is like it.
        const bool goes_on = to_the_point_ && samples_left_ - 1 == last_path_;
        const bool over = node_ + 2 == motif_end_ && !goes_on;
        node_ = over ? motif_ : node_ + 1;
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
      first_steered_(input.steered ? size_t{StyleWalk::last_blend_patches} * input.trees->graph().patch + 1 : 0,
                     memory) {}

void SynthesisKernel::begin(const StrokeInput& stroke) {
    stroke_ = stroke;
    sampler_.emplace(stroke.plan);
    count_ = stroke.plan.sample_count();
    written_ = 0;
    block_.count = followed_ = 0;
    displaced_.set_magnitude(input_.magnitude);
    node_known_ = true;
    finishing_.reset();
    steered_.fill({.scale = stroke.across});
    sizes_ = PieceSizes(stroke.plan.pieces, stroke.across_pieces, stroke.plan.curve.closed);
    if (stroke.motifs_by_piece && !stroke.plan.pieces.empty()) {
        begin_piece(0);
    } else {
        begin_walk();
    }
    blend_ = SeamBlend(input_.trees->graph().patch, input_.style->bend, input_.style->attributes);
    angle_ = input_.style->find(FLG_ATTRIBUTE_ANGLE);
}

void SynthesisKernel::begin_walk() {
    const SamplingPlan& plan = stroke_.plan;
    // On closed curves one more than samples: where the style is when the curve has come around.
    const bool has_end = plan.exact_step == 0 || input_.trees->graph().end_cap > 0;
    walk_ = StyleWalk(input_.trees, stroke_.from_start, input_.seed, stroke_.key,
                      has_end ? plan.steps + 1 : StyleWalk::endless);
    walk_.heat(input_.hot_trees);
    if (plan.curve.closed && plan.steps > 0) {
        walk_.close(input_.pin_ends ? all_displacements() : std::span<const Vec3>());
    } else if (plan.steps > 0) {
        walk_.begin_with_cap();
        walk_.end_with_cap();
        if (!stroke_.joints.empty()) walk_.take_motifs(stroke_.joints);
    }
}

// Steps of the walk that there is.
uint32_t SynthesisKernel::walk_steps() const {
    const std::span<const CurvePiece> pieces = stroke_.plan.pieces;
    if (!stroke_.motifs_by_piece || pieces.empty()) return stroke_.plan.steps;
    return pieces[piece_].end_step - (piece_ > 0 ? pieces[piece_ - 1].end_step : 0);
}

// The last sample of its walk is the first one of the next, where there is one.
void SynthesisKernel::begin_piece(uint32_t piece) {
    piece_ = piece;
    const bool closed = stroke_.plan.curve.closed;
    walk_ = StyleWalk(input_.trees, true, input_.seed, stroke_.key, walk_steps() + 1);
    if (stroke_.corner_caps || (!closed && piece == 0)) walk_.begin_with_cap();
    if (stroke_.corner_caps || (!closed && piece + 1 == stroke_.plan.pieces.size())) walk_.end_with_cap();
    walk_.take_motifs(stroke_.joints);
}

bool SynthesisKernel::turns_corner() const {
    const std::span<const CurvePiece> pieces = stroke_.plan.pieces;
    if (!stroke_.motifs_by_piece || pieces.empty() || walk_.samples_left() != 1) return false;
    return stroke_.plan.curve.closed || piece_ + 1 < pieces.size();
}

bool SynthesisKernel::run(uint32_t n) {
    while (written_ < count_) {
        if (followed_ == block_.count) {
            if (n == 0) return false;
            followed_ = 0;
            if (sampler_->next(block_, n) == 0) return false;
            if (stroke_.steered) steer_block();
        }
        if (!follow_style(n)) return false;
        write_block();
    }
    return finish(n);
}

// To the next node, unless its path tree is missing.
bool SynthesisKernel::advance() {
    const uint32_t from = walk_.node();
    const auto displacement = [this](uint32_t node) -> const Vec3& { return input_.style->displacement[node]; };
    if (turns_corner()) [[unlikely]] {
        begin_piece((piece_ + 1) % static_cast<uint32_t>(stroke_.plan.pieces.size()));
        blend_.stop_cross_fading(input_.trees->graph().patch);
        blend_.step(from, walk_.node(), displacement);
        return true;
    }
    if (walk_.turns_home()) [[unlikely]] {
        walk_.go_home(walk_steps(), all_displacements(), blend_);
    }
    if (!walk_.advance(is_hot())) return false;
    blend_.step(from, walk_.node(), displacement);
    return true;
}

void SynthesisKernel::steer_block() {
    for (uint32_t k = 0; k < block_.count; ++k) {
        const uint32_t segment = block_.segment[k];
        const Steered& next = stroke_.steered[stroke_.plan.curve.following(segment)];
        steered_[k] = stroke_.steered[segment].between(next, block_.t[k]);
        steered_[k].scale *= stroke_.across * sizes_.at(written_ + k);
        if (written_ + k < first_steered_.size()) std::construct_at(&first_steered_[written_ + k], steered_[k]);
    }
}

// At the sample to come: of a closed curve, behind the last one, the first.
const Steered& SynthesisKernel::steered() const {
    return followed_ < block_.count ? steered_[followed_] : first_steered_[0];
}

std::span<const Steered> SynthesisKernel::first_steered() const {
    if (!stroke_.steered) return {};
    return {first_steered_.data(), std::min<size_t>(first_steered_.size(), written_)};
}

bool SynthesisKernel::is_hot() const {
    const uint32_t sample = written_ + (followed_ < block_.count ? followed_ : 0);
    return input_.hot_trees && steered().is_hot(input_.seed, stroke_.key, sample);
}

std::span<const Vec3> SynthesisKernel::all_displacements() const {
    return {input_.style->displacement.data(), input_.style->displacement.size()};
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

// Along the style for all samples of the block, unless the units do not suffice for a path tree that is missing.
bool SynthesisKernel::follow_style(uint32_t& units) {
    while (followed_ < block_.count) {
        if (!find_node(units)) return false;
        if (blend_.points_left() > 0) {
            copy_blended();
        } else {
            const uint32_t node = walk_.node();
            walk_.copy_on(block_.count - followed_ - 1);
            copy_style(node, walk_.node() + 1 - node);
        }
        node_known_ = false;
    }
    return true;
}

// The style as it is, from a node on.
void SynthesisKernel::copy_style(uint32_t node, uint32_t count) {
    const AppliedStyle& style = *input_.style;
    for (int c = 0; c < 3; ++c) std::copy_n(style.along[c].data() + node, count, displaced_.along[c] + followed_ + 1);
    for (uint32_t k = 0; k < count; ++k) nodes_[followed_ + k] = static_cast<float>(node + k);
    for (size_t a = 0; a < style.attributes.size(); ++a) {
        const uint32_t components = style.attributes[a].components;
        float* const out = stroke_.out.attributes[a] + size_t{written_ + followed_} * components;
        if (!stroke_.steered) {
            blend_.write_run(a, node, count, attribute_scale(a, 0), out);
            continue;
        }
        for (uint32_t k = 0; k < count; ++k) {
            blend_.write_run(a, node + k, 1, attribute_scale(a, followed_ + k), out + size_t{k} * components);
        }
    }
    if (angle_ < style.attributes.size()) {
        for (uint32_t k = 0; k < count; ++k) displaced_.turn_rad[followed_ + k] = blend_.value(angle_, 0, node + k);
    }
    followed_ += count;
}

// The style's point that the walk stands at, and what is left of the last seam.
void SynthesisKernel::copy_blended() {
    const AppliedStyle& style = *input_.style;
    const uint32_t node = walk_.node();
    displaced_.set_along(followed_, style.displacement[node] + blend_.offset());
    nodes_[followed_] = static_cast<float>(node);
    for (size_t a = 0; a < style.attributes.size(); ++a) {
        const size_t at = size_t{written_ + followed_} * style.attributes[a].components;
        blend_.write(a, node, attribute_scale(a, followed_), stroke_.out.attributes[a] + at);
    }
    if (angle_ < style.attributes.size()) displaced_.turn_rad[followed_] = blend_.value(angle_, 0, node);
    ++followed_;
}

double SynthesisKernel::attribute_scale(size_t attribute, uint32_t k) const {
    const AppliedStyle& style = *input_.style;
    return stroke_.scale * style.scale * steered_[k].size(style.attributes[attribute].attribute);
}

void SynthesisKernel::write_block() {
    const StylizedColumns& out = stroke_.out;
    const uint32_t count = block_.count;
    const size_t at = 3 * static_cast<size_t>(written_);
    // A target without length has no frame to be displaced in.
    if (stroke_.plan.steps == 0) displaced_.set_along(0, Vec3::Zero());
    if (stroke_.steered) {
        for (uint32_t k = 0; k < count; ++k) {
            displaced_.scale_at(k, static_cast<float>(displacement_scale(steered_[k])));
        }
    } else {
        displaced_.scale(count, static_cast<float>(displacement_scale(steered_[0])));
    }
    if (!displace_samples(block_, displaced_)) {
        for (uint32_t k = 0; k < count; ++k) {
            const Vec3 displacement = displaced_.displacement_of(k);
            check_position(block_.position_of(k) + input_.magnitude * displacement, input_.magnitude);
        }
    }
    if (written_ == 0) {
        first_tangent_ = block_.tangent_of(0);
        first_normal_ = block_.normal_of(0);
        first_displacement_ = displaced_.displacement_of(0);
    }
    last_displacement_ = displaced_.displacement_of(count - 1);
    if (angle_ < input_.style->attributes.size()) turn_normals(displaced_, block_);
    pack(displaced_.position, count, out.frames.positions + at);
    pack(block_.tangent, count, out.frames.tangents + at);
    pack(block_.normal, count, out.frames.normals + at);
    if (out.displacement) pack(displaced_.displacement, count, out.displacement + at);
    std::copy_n(nodes_.data(), count, out.style_index + written_);
    write_carried();
    if (stroke_.steered) steer_carried_radii();
    written_ += count;
}

void SynthesisKernel::write_carried() {
    if (stroke_.carried.empty()) return;
    std::array<SamplePlace, SampleBlock::capacity> places;
    for (uint32_t k = 0; k < block_.count; ++k) places[k] = {block_.segment[k], block_.t[k]};
    for (const ColumnPair& column : stroke_.carried) {
        interpolate_column(column, stroke_.plan.curve, {places.data(), block_.count}, written_);
    }
}

// The target's radii: those of the style are steered with the other attributes.
void SynthesisKernel::steer_carried_radii() {
    if (stroke_.out.carried_radius == nullptr) return;
    for (uint32_t k = 0; k < block_.count; ++k) stroke_.out.carried_radius[written_ + k] *= steered_[k].radius;
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

Vec3 SynthesisKernel::in_first_frame(const Vec3& displacement) const {
    const Steered& steered = stroke_.steered ? first_steered_[0] : steered_[0];
    return in_frame(displacement_scale(steered) * displacement, first_tangent_, first_normal_);
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
            first_displacement_ += in_first_frame(blend_.offset());
            last_displacement_ = first_displacement_;
        }
        const FinishingInput finishing{.out = stroke_.out,
                                       .style = input_.style,
                                       .scale = stroke_.scale,
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
