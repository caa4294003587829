// SPDX-License-Identifier: MIT
#include "stylization/style_choice.h"

namespace flg {

namespace {

constexpr double patches_by_default = 2;

// The share of a blend that lies before y, from -1/2 to 1/2.
double blended(double y) {
    const double r = std::clamp(y + 0.5, 0.0, 1.0);
    return r * r * (3 - 2 * r);
}

}  // namespace

StyleWeights::StyleWeights(std::span<const StyleRun> runs, bool closed, double blend)
    : runs_(runs), closed_(closed), length_(runs.back().end), blend_(blend) {
    // Where a closed curve has come around, a place must not count twice.
    if (closed) blend_ = std::min(blend_, 0.5 * length_);
}

uint32_t StyleWeights::at(double s, StyleShares& weights) {
    weights.fill(0);
    const double half = 0.5 * blend_;
    while (first_ + 1 < runs_.size() && runs_[first_].end <= s - half) ++first_;
    uint32_t looked = 1;
    const auto add = [&](uint32_t style, double begin, double end, double from) {
        const double low = (begin - from) / blend_, high = (end - from) / blend_;
        weights[style] += blended(high) - blended(low);
    };
    const auto open_end = [&](size_t run) { return !closed_ && run + 1 == runs_.size() ? HUGE_VAL : runs_[run].end; };
    for (size_t run = first_; run < runs_.size(); ++run, ++looked) {
        const bool is_first = run == 0;
        const double begin = is_first ? (closed_ ? 0.0 : -HUGE_VAL) : runs_[run - 1].end;
        if (begin >= s + half) break;
        add(runs_[run].style, begin, open_end(run), s);
    }
    if (!closed_) return looked;
    // Around the start, from both sides.
    for (size_t run = runs_.size(); run > 0 && s < half && runs_[run - 1].end - length_ > s - half; --run, ++looked) {
        const double begin = run > 1 ? runs_[run - 2].end : 0.0;
        add(runs_[run - 1].style, begin, runs_[run - 1].end, s + length_);
    }
    for (size_t run = 0; run < runs_.size() && s + half > length_; ++run, ++looked) {
        const double begin = run > 0 ? runs_[run - 1].end : 0.0;
        if (begin + length_ >= s + half) break;
        add(runs_[run].style, begin, runs_[run].end, s - length_);
    }
    return looked;
}

double default_blend(const PreparedStyle& style, double spacing) {
    return patches_by_default * ((2.0 * style.graph.patch + 1) * spacing);
}

void LiveChoice::read(float from, float to, double length) {
    start_ += length_;
    length_ = length;
    uint32_t over = 0;
    while (over + 1 < count_ && runs_[over].end <= start_ - blend_) ++over;
    std::copy(runs_.begin() + over, runs_.begin() + count_, runs_.begin());
    count_ -= over;
    if (count_ == 0) {
        chosen_ = choice_.nearest(from);
        runs_[count_++] = {HUGE_VAL, chosen_};
    }
    choice_.follow(from, to, start_, length, [&](double s, uint32_t, uint32_t next) {
        settle(s);
        chosen_ = next;
        chosen_since_ = s;
    });
    settle(start_ + length_);
}

// What is chosen comes to count, if it is time at s.
void LiveChoice::settle(double s) {
    StyleRun& last = runs_[count_ - 1];
    if (chosen_ == last.style) return;
    const double begin = std::max(chosen_since_, counts_since_ + blend_ / changes_max);
    if (begin > s) return;
    last.end = counts_since_ = begin;
    runs_[count_++] = {HUGE_VAL, chosen_};
}

void LiveChoice::weigh(double t, StyleShares& weights) const {
    StyleWeights({runs_.data(), count_}, false, blend_).at(start_ + t * length_ - 0.5 * blend_, weights);
}

}  // namespace flg
