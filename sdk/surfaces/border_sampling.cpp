// SPDX-License-Identifier: MIT
#include "surfaces/border_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double most_points = 0x1p24;

}  // namespace

BorderSamplingKernel::BorderSamplingKernel(const Mesh& mesh, const RegionLoops& loops,
                                           std::span<const BorderStretch> stretches, float spacing,
                                           SurfaceCurves& curves)
    : mesh_(mesh), loops_(loops), stretches_(stretches), spacing_(spacing), curves_(curves) {}

void BorderSamplingKernel::begin_stretch() {
    const BorderStretch& stretch = stretches_[at_];
    const double length = loops_.lengths[stretch.loop] * (stretch.end - stretch.begin);
    const double steps = std::round(length / spacing_);
    if (!(steps <= most_points)) {
        throw Failure(FLG_ERROR_LIMIT, "spacing %g makes more than 2^24 points of a border of %g m", double{spacing_},
                      length);
    }
    count_ = std::max(3u, static_cast<uint32_t>(steps));
    placed_ = stretch.is_whole() ? 0 : 1;
    edge_ = loops_.offsets[stretch.loop];
    walked_ = 0;
    within_ = true;
}

void BorderSamplingKernel::end_stretch() {
    const BorderStretch& stretch = stretches_[at_++];
    curves_.offsets.push_back(static_cast<uint32_t>(curves_.points.size()));
    curves_.closed.push_back(stretch.is_whole());
    curves_.values.push_back(static_cast<float>(loops_.lengths[stretch.loop] * (stretch.end - stretch.begin)));
    within_ = false;
}

// A point, or on to the next edge. A border without length has all its points in one place.
bool BorderSamplingKernel::run(uint32_t count) {
    for (; count > 0; --count) {
        if (!within_) {
            if (at_ == stretches_.size()) return true;
            begin_stretch();
        }
        if (placed_ == count_) {
            end_stretch();
            continue;
        }
        const BorderStretch& stretch = stretches_[at_];
        const double whole = loops_.lengths[stretch.loop];
        const double place = whole * (stretch.begin + (stretch.end - stretch.begin) * placed_ / count_);
        const double length = edge_length(mesh_, loops_.edges[edge_]);
        if (place < walked_ + length || whole == 0) {
            const double t = length > 0 ? std::clamp((place - walked_) / length, 0.0, 1.0) : 0;
            curves_.points.push_back(point_on_edge(loops_.edges[edge_], round_on_edge(t)));
            ++placed_;
            continue;
        }
        walked_ += length;
        if (++edge_ == loops_.offsets[stretch.loop + 1]) edge_ = loops_.offsets[stretch.loop];
    }
    return false;
}

}  // namespace flg
