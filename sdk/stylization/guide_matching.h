// SPDX-License-Identifier: MIT
// Which point of the style belongs to which point of the guide: the semi-discrete matching of Minarcik, Fiser, Sykora,
// "Example-Based Authoring of Expressive Space Curves", sec. 4.2. Minimizes over non-decreasing delta, ends fixed,
//     E'(delta) = sum over 1 <= i <= N-2 of  beta |G_i - gamma_S(delta_i)|^2 + (1 - beta) (delta_i - L_S i / (N - 1))^2.
//
// Departures from the paper
// - Its distortion term compares delta_i with (L_S / L_G) i; what is meant is the arc length s_i = L_G i / (N - 1).
// - Its start is not said, and E' has many local minima. Here: dynamic programming from coarse to fine. Alone, point i would
//   not go further from its even place e_i than |delta_i - e_i| <= sqrt(beta / (1 - beta)) |G_i - gamma_S(e_i)|, where
//   distortion outweighs all that closeness could win; the coarsest table is the monotone hull of that. Each finer one has
//   a third of the stride and stays within one coarse step of the path before.
// - Its Hessian 2I leaves out the style's curvature. E' couples points through their order only: each point is taken to its
//   own minimum by Newton's method inside a bracket, then the models found there are minimized in order, exactly, by
//   pooling adjacent violators; pooled points get new models where they meet, until they rest.
// Invariants: delta_0 = 0, delta_(N-1) = L_S, non-decreasing; the same bits for every slicing into run(n).
#pragma once

#include <cstdint>

#include "core/memory.h"
#include "core/vec.h"
#include "stylization/smooth_style_curve.h"

namespace flg {

class GuideMatching {
public:
    // `guide`: `count` >= 2 points, evenly spaced. Neither it nor the style's points are copied. `beta` in (0, 1): closeness
    // against evenness.
    GuideMatching(const SmoothStyleCurve& style, const Vec3* guide, uint32_t count, double beta, Memory* memory);

    // Does n units of work, cells of a table or points; true when done. At most 27 ns a unit: 800 stay below 25 us.
    bool run(uint32_t n);

    // After run() returned true: the arc lengths delta_i on the style, their energy E' (by the models, exact to third order in
    // the last steps), and how often points were pooled.
    const Buffer<double>& matching() const { return delta_; }
    double energy() const { return energy_; }
    uint32_t sweeps() const { return sweeps_; }

private:
    enum class Phase : uint8_t { reach, reach_back, table, trace, narrow, descend, settle, pool, done };

    struct Model {  // of a point's energy around a place on the style
        double place;
        double energy;
        double slope;
        double curvature;  // > 0
        double minimum;    // where the model is least, within reach of `place`
    };
    struct Block {  // points that share one place: the minimum of the sum of their models
        double weight;
        double place;
        uint32_t end;
    };

    void reach(uint32_t end);
    void reach_back(uint32_t end);
    void table(uint32_t n);
    void trace(uint32_t n);
    void narrow(uint32_t end);
    void descend(uint32_t n);
    void settle(uint32_t end);
    void pool(uint32_t n);
    void enter(Phase phase);
    void choose_stride();
    void begin_table(uint32_t stride);
    void begin_row();
    bool merge_last_blocks();
    Model model(uint32_t i, double place, const SmoothStyleCurve::Jet& style, double longest_move) const;

    uint32_t row_stride(uint32_t stride) const;
    double even_place(uint32_t i) const { return style_.length() * i / (count_ - 1); }

    SmoothStyleCurve style_;
    const Vec3* guide_;
    uint32_t count_;
    double beta_;
    Memory* memory_;
    Phase phase_ = Phase::reach;
    uint32_t index_ = 0;

    // The table: a row for each row_stride-th point of the guide, a column for each stride-th one of the style.
    Buffer<uint32_t> low_;  // by guide point: the band, as points of the style
    Buffer<uint32_t> high_;
    uint64_t band_width_sum_ = 0;
    uint32_t stride_ = 1;
    uint32_t row_stride_ = 1;
    uint32_t last_row_ = 0;
    Buffer<uint32_t> first_column_;  // by row; row 0 is the first point, which stays
    Buffer<uint32_t> last_column_;
    Buffer<uint32_t> row_start_;  // into best_
    Buffer<uint32_t> best_;       // by cell: the best column of the row up to here
    Buffer<double> cost_;         // of the last row, by column: the least cost up to here
    Buffer<double> next_cost_;
    Buffer<uint32_t> chosen_;  // by row: the point of the style on the best path
    uint32_t column_ = 0;
    double running_ = 0.0;
    uint32_t running_column_ = 0;

    Buffer<double> delta_;
    Buffer<Model> models_;
    Buffer<Block> blocks_;
    uint32_t block_count_ = 0;
    double energy_ = 0.0;
    double largest_move_ = 0.0;
    uint32_t sweeps_ = 0;
};

}  // namespace flg
