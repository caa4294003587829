// SPDX-License-Identifier: MIT
// Which of several styles is chosen along a curve, and how much each counts there.
//
// The value that a drive gives goes evenly from point to point, and the nearest style counts. Over the length b one
// style turns into the next: a style's weight at arc length s is the share of the places x that choose it,
//   w(s) = int over them of K((x - s) / b) dx / b,   K(y) = 3/2 - 6 y^2 within 1/2 of 0,
// so that weights add up to 1, change without steps or bends, and are 1 where a style is alone for longer than b.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "stylization/style.h"

namespace flg {

constexpr uint32_t styles_max = 8;

using StyleShares = std::array<double, styles_max>;

// A stretch of a curve that chooses one style, to `end` metres along it.
struct StyleRun {
    double end;
    uint32_t style;
};

// The choice, segment by segment.
class StyleChoice {
public:
    explicit StyleChoice(uint32_t styles = 1) : styles_(styles) {}

    uint32_t nearest(double value) const {
        return static_cast<uint32_t>(std::clamp(std::floor(value + 0.5), 0.0, styles_ - 1.0));
    }
    // The last one.
    uint32_t style() const { return style_; }
    // Along a segment from arc length s on, over which the value goes evenly: where the choice changes,
    // visit(arc length, style up to there, style from there on).
    template <class Visit>
    void follow(double from, double to, double s, double length, const Visit& visit) {
        const uint32_t first = nearest(from), last = nearest(to);
        if (begun_ && first != style_) visit(s, style_, first);
        begun_ = true;
        style_ = first;
        while (style_ != last) {
            const uint32_t next = style_ < last ? style_ + 1 : style_ - 1;
            const double middle = 0.5 * (style_ + next);
            visit(s + length * std::clamp((middle - from) / (to - from), 0.0, 1.0), style_, next);
            style_ = next;
        }
    }

private:
    uint32_t styles_;
    uint32_t style_ = 0;
    bool begun_ = false;
};

// What runs of a curve make of it. `runs` outlive it; there is one at least. Where a curve is open, the first and the
// last run go on without end.
class StyleWeights {
public:
    StyleWeights(std::span<const StyleRun> runs, bool closed, double blend);
    // At the arc length; in order. Returns how many runs were looked at.
    uint32_t at(double s, StyleShares& weights);

private:
    std::span<const StyleRun> runs_;
    bool closed_;
    double length_;
    double blend_;
    size_t first_ = 0;
};

// Two patches, metres; `spacing` of the style's points as it is applied.
double default_blend(const PreparedStyle& style, double spacing);

// The choice along a curve that is being drawn, of which only the past counts: a blend begins where the choice changes
// and is over b behind it. Weights at s are those that the curve, were it known, would have at s - b / 2. A choice
// holds for b / changes_max at least: one that changes sooner comes to count there.
class LiveChoice {
public:
    static constexpr uint32_t changes_max = 16;  // within a blend: each costs 10 ns a point

    LiveChoice() = default;
    LiveChoice(uint32_t styles, double blend) : choice_(styles), blend_(blend) {}

    // One segment more, over which the value goes evenly.
    void read(float from, float to, double length);
    // At t, 0 to 1, of the last segment read.
    void weigh(double t, StyleShares& weights) const;

private:
    void settle(double s);

    StyleChoice choice_;
    double blend_ = 1;
    double start_ = 0, length_ = 0;  // of the last segment
    // Since when it is chosen what now is, and since when something else counted.
    double chosen_since_ = 0, counts_since_ = -HUGE_VAL;
    uint32_t chosen_ = 0;
    uint32_t count_ = 0;
    // Those within a blend of the segment's start, and on the segment: it can pass all styles and begin with another.
    std::array<StyleRun, changes_max + styles_max + 2> runs_{};
};

}  // namespace flg
