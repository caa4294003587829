// SPDX-License-Identifier: MIT
// BoundedDP (Ma, Wang, Li, Zhang 2021, sec. 3.1, Algorithms 1 and 2): which points of a branch's axis become joints. As
// with Douglas and Peucker a stretch is divided at the point of the largest error until that is below a threshold; but
// the error counts the shape as well as the axis,
//     E_i = distance to the chord + shape_weight * (distances of the slice's ends to the sides of the trapezoid between the end slices),
// with the slices put side by side along the straightened axis; and the threshold falls by a fifth until all bones are
// inside of the shape: they cross every slice between the joints, and no edge of the contour.
//
// Departures: Algorithm 1 marks a point before it looks at the threshold; the text, and this, only if the error is
// larger. The weight is in the text and lost in Algorithm 1. A threshold can't fall for ever: after `most_rounds` all
// points are taken.
#pragma once

#include <span>
#include <vector>

#include "bones/part_skeleton.h"

namespace flg {

class BoundedDpKernel {
public:
    // Of the samples of one branch. All outlive the kernel; `joints` gets the numbers of the samples that stay, ends
    // included, and is complete when run() returns true.
    BoundedDpKernel(const Contour& contour, std::span<const AxisSample> samples, double threshold, double shape_weight,
                    std::pmr::vector<uint32_t>& joints, Memory* memory);

    // A unit is 16 samples looked at, or a bone held against 64 edges of the contour: about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { along, scan, collect, slices, contour, done };
    struct Range {
        uint32_t begin, end;
    };

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    void begin_round();
    void begin_range();
    void scan();
    void hold_against_slices();
    void hold_against_contour();
    void next_bone();
    void leaves_shape();

    const Contour& contour_;
    std::span<const AxisSample> samples_;
    double threshold_, shape_weight_;
    std::pmr::vector<uint32_t>& joints_;
    std::pmr::vector<double> along_;
    std::pmr::vector<bool> kept_;
    std::pmr::vector<Range> ranges_;
    double most_ = 0;
    uint32_t farthest_ = 0;
    uint32_t round_ = 0, bone_ = 0;
    Pass pass_ = Pass::along;
    uint32_t at_ = 0;
};

}  // namespace flg
