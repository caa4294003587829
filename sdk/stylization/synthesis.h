// SPDX-License-Identifier: MIT
// Displacement reconstruction (Minarcik, Fiser, Sykora, sec. 4.5): a style applied to one target curve,
//   result = target + magnitude * (d_t t + d_n n + d_b b),
// with the target's moving frame and displacements read along shortest paths between random destinations of the patch
// graph; attributes (sec. 5) are read along with them. Every sample is one table look-up, once the path trees are
// there. Between two runs displacements and attributes are blended (seam_blend).
//
// Departures from the paper: a run that has come to the last patch of its style curve, with no more samples to come
// than the style has points left, goes on to the style's end instead of jumping (the paper's cul-de-sac is no trouble
// where the target ends as well); so a target as long as the guide gets the whole style.
// Closed curves: the last path is one to the node that the curve began at, as long as it has to be, with one jump,
// where both runs are most alike. They are cross-faded over more points than others are blended, and over the
// curve's first ones if the jump comes late. (The paper corrects all of the displacement, in proportion to arc
// length: the direction still has a step.)
#pragma once

#include <array>
#include <optional>
#include <span>

#include "stylization/applied_style.h"
#include "stylization/corner_fit.h"
#include "stylization/displaced_block.h"
#include "stylization/finishing.h"
#include "stylization/path_trees.h"
#include "stylization/seam_blend.h"

namespace flg {

// Which points of the style a target curve copies, one after the other.
class StyleWalk {
public:
    // More points than a curve can have: the walk has no end to aim at.
    static constexpr uint32_t endless = UINT32_MAX;

    StyleWalk() = default;
    // `from_start`: begins at the style's first point, and goes to the end of its first curve first (the first curve
    // with patches, that is). Otherwise at a random destination. `samples`: how many points there will be.
    StyleWalk(PathTrees* trees, bool from_start, uint64_t seed, uint64_t curve_index, uint32_t samples);
    // Steps may also go by the trees of another temperature, of the same graph.
    void heat(PathTrees* hot_trees) { hot_trees_ = hot_trees; }
    // Before the first step along a closed curve: begins so far from the start of the style's curve that a last path
    // can lead there. The last of the samples is the first once more. `pinned`: the style's displacements, if the
    // result is moved so that its first point has none: then it begins near by where there is least.
    void close(std::span<const Vec3> pinned);
    // Before the first step along an open curve: begins with the style's start cap, and ends with its end cap, if the
    // style has them.
    void begin_with_cap();
    void end_with_cap();
    // Likewise: whole repetitions from the first joint on, one behind the other, the last one to its end, and into the
    // cap if it ends with it. The number of samples is that of fit_stroke().
    void take_motifs(std::span<const uint32_t> joints);

    uint32_t node() const { return node_; }
    uint32_t samples_left() const { return samples_left_; }
    // Of a closed curve, or one with a given end, where the last path begins: go_home() comes next.
    bool turns_home() const { return samples_left_ == last_path_ && !going_home_; }
    // Copies on for some points, jumps, and copies up to where it began. That jump is taken however wide its gap is: so
    // the blend's seams are cross-faded from there on, over so many patches, but over all of the curve's `steps` at
    // most. `displacement`: the style's, which outlives the walk.
    static constexpr uint32_t last_blend_patches = 6;
    void go_home(uint32_t steps, std::span<const Vec3> displacement, SeamBlend& blend);
    // Copies on where that takes no decision, so many points at most; says how many.
    uint32_t copy_on(uint32_t most);
    // To the next node, by the trees or the hot ones. False if the tree to needed_tree() is missing there: make it,
    // then call again.
    bool advance(bool hot = false);
    uint32_t needed_tree() const { return destination_; }

private:
    void draw_destination();
    bool runs_out() const;
    // The node that a jump after `copies` copied points would lead to.
    uint32_t landing(uint32_t copies) const { return home_ - (samples_left_ - copies - 1); }
    // Samples from here on to the end cap, all if there is none.
    uint32_t before_cap() const { return samples_left_ - cap_; }
    uint32_t copies_before_last_jump(uint32_t points, uint32_t blended, std::span<const Vec3> displacement) const;
    void lead_home(uint32_t node, uint32_t cap, uint32_t run_in);

    PathTrees* trees_ = nullptr;
    PathTrees* hot_trees_ = nullptr;
    // To the destination; null before it was looked up.
    const uint16_t* hops_ = nullptr;
    const uint16_t* hot_hops_ = nullptr;
    uint64_t seed_ = 0;
    uint64_t curve_index_ = 0;
    uint32_t draws_ = 0;
    uint32_t node_ = 0;
    uint32_t destination_ = 0;  // as PathTrees numbers them
    uint32_t destination_node_ = 0;
    uint32_t samples_left_ = 0;  // after node()
    uint32_t cap_left_ = 0;      // steps to come of the start cap, the last one to where the walk then begins
    uint32_t begins_ = 0;        // there
    uint32_t motif_ = 0;         // the first node of the motifs
    uint32_t motif_end_ = 0;     // one behind their last one; 0: none are taken
    bool to_the_point_ = false;  // the last path jumps at once
    uint32_t home_ = 0;          // of a closed curve: where it began; of one with a given end: that
    uint32_t cap_ = 0;           // samples of the end cap
    uint32_t last_path_ = 0;     // its samples, the first one behind its start and the last one home; 0: no home
    uint32_t copies_ = 0;        // before the jump
    bool going_home_ = false;
    bool finishing_ = false;  // goes on to the style's end
};

struct SynthesisInput {
    const AppliedStyle* style = nullptr;
    PathTrees* trees = nullptr;
    double magnitude = 1;
    bool pin_ends = false;
    uint64_t seed = 1;
    PathTrees* hot_trees = nullptr;  // of a driven temperature's other end
    bool steered = false;            // strokes are
};

// One stroke along one target curve.
struct StrokeInput {
    SamplingPlan plan;  // steps from even_step_count() with the guide's spacing times the scale
    double scale = 1;   // of the style as it is applied; in the plan's spacing already
    uint64_t key = 0;   // of its random choices
    bool from_start = false;
    double start_time = 0;                   // seconds; for styles with SPEED
    StylizedColumns out;                     // outlive the run
    std::span<const ColumnPair> carried;     // the same
    const Steered* steered = nullptr;        // at the curve's points
    float across = 1;                        // factor on the style's size beside its steps
    std::span<const uint32_t> joints{};      // of the style's motifs, if they are to be whole
    bool motifs_by_piece = false;            // from corner to corner, if the plan has pieces
    bool corner_caps = false;                // there too
    std::span<const float> across_pieces{};  // as `across`, of each piece; none: 1
};

// The key of stroke number `stroke` along a curve; of stroke 0 it is the curve's index, however many there are.
constexpr uint64_t stroke_key(uint32_t curve, uint32_t stroke) {
    return uint64_t{stroke} << 32 | curve;
}

// Stylizes one curve after the other. Stays a kernel: it allocates nothing per curve or sample. A unit is a sample, a
// point of the target or a settled node of a path tree: 10 to 60 ns.
class SynthesisKernel {
public:
    // What the input refers to outlives the kernel. Scratch memory for path trees is taken when one is missing.
    SynthesisKernel(const SynthesisInput& input, Memory* memory);
    ~SynthesisKernel() { input_.trees->discard(tree_); }
    SynthesisKernel(const SynthesisKernel&) = delete;
    SynthesisKernel& operator=(const SynthesisKernel&) = delete;

    void begin(const StrokeInput& stroke);
    bool run(uint32_t n);
    // Samples of the curve written so far.
    uint32_t written() const { return written_; }

private:
    bool find_node(uint32_t& units);
    bool advance();
    void begin_walk();
    void begin_piece(uint32_t piece);
    bool turns_corner() const;
    uint32_t walk_steps() const;
    void steer_block();
    const Steered& steered() const;
    std::span<const Steered> first_steered() const;
    bool is_hot() const;
    std::span<const Vec3> all_displacements() const;
    bool make_tree(uint32_t& units);
    bool follow_style(uint32_t& units);
    void copy_style(uint32_t node, uint32_t count);
    void copy_blended();
    double displacement_scale(const Steered& steered) const { return stroke_.scale * steered.weight(); }
    double attribute_scale(size_t attribute, uint32_t k) const;
    void write_block();
    void write_carried();
    void steer_carried_radii();
    Vec3 in_first_frame(const Vec3& displacement) const;
    bool finish(uint32_t& units);

    SynthesisInput input_;
    PathTreeKernel tree_kernel_;
    uint16_t* tree_ = nullptr;  // being made
    std::optional<FramedSampler> sampler_;
    SampleBlock block_;
    DisplacedBlock displaced_;
    std::array<float, SampleBlock::capacity> nodes_;
    uint32_t followed_ = 0;                               // samples of the block that know what they copy
    std::array<Steered, SampleBlock::capacity> steered_;  // the block's; if nothing is driven, all alike
    Buffer<Steered> first_steered_;  // the first samples', as many as a closed curve's last blend has
    StyleWalk walk_;
    SeamBlend blend_;
    StrokeInput stroke_;
    uint32_t piece_ = 0;  // that the walk is on, if each has its own
    PieceSizes sizes_;
    uint32_t count_ = 0;
    uint32_t written_ = 0;
    bool node_known_ = true;  // walk_ stands at the next sample's node
    Vec3 first_tangent_, first_normal_;
    size_t angle_ = 0;  // where among the attributes ANGLE is
    Vec3 first_displacement_, last_displacement_;
    std::optional<Finishing> finishing_;
};

}  // namespace flg
