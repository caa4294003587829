// SPDX-License-Identifier: MIT
#include "stylization/patch_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t columns_at_once = 256;

// The three components of the displacements, from some point on.
struct Points {
    const double* t;
    const double* n;
    const double* b;

    Points(const Displacement& d, uint32_t from)
        : t(d.along_tangent.data() + from), n(d.along_normal.data() + from), b(d.along_binormal.data() + from) {}
};

// sums[c] += |point - others[c]|^2
void add_distances(double* __restrict sums, const Points& point, const Points& others, uint32_t count) {
    const double pt = *point.t, pn = *point.n, pb = *point.b;
    const double* __restrict ot = others.t, * __restrict on = others.n, * __restrict ob = others.b;
    for (uint32_t c = 0; c < count; ++c) {
        const double t = ot[c] - pt, n = on[c] - pn, b = ob[c] - pb;
        sums[c] += t * t + n * n + b * b;
    }
}

// row[c] = before[c] + |entering - others_in[c]|^2 - |leaving - others_out[c]|^2
void roll_distances(double* __restrict row, const double* __restrict before, const Points& entering,
                    const Points& others_in, const Points& leaving, const Points& others_out, uint32_t count) {
    const double et = *entering.t, en = *entering.n, eb = *entering.b;
    const double lt = *leaving.t, ln = *leaving.n, lb = *leaving.b;
    const double* __restrict it = others_in.t, * __restrict in = others_in.n, * __restrict ib = others_in.b;
    const double* __restrict ot = others_out.t, * __restrict on = others_out.n, * __restrict ob = others_out.b;
    for (uint32_t c = 0; c < count; ++c) {
        const double t = it[c] - et, n = in[c] - en, b = ib[c] - eb;
        const double u = ot[c] - lt, v = on[c] - ln, w = ob[c] - lb;
        row[c] = before[c] + ((t * t + n * n + b * b) - (u * u + v * v + w * w));
    }
}

struct Line {
    double operator()(double a, double b) const { return (a - b) * (a - b); }
};

struct Circle {
    double period;
    double operator()(double a, double b) const {
        const double way = std::abs(a - b);
        const double other = period - way;
        const double shorter = way < other ? way : other;
        return shorter * shorter;
    }
};

// sums[c] += distance_sq(value, others[c])
template <class DistanceSq>
void add_channel(double* __restrict sums, double value, const double* __restrict others, uint32_t count,
                 DistanceSq distance_sq) {
    for (uint32_t c = 0; c < count; ++c) sums[c] += distance_sq(others[c], value);
}

// row[c] += distance_sq(entering, in[c]) - distance_sq(leaving, out[c])
template <class DistanceSq>
void roll_channel(double* __restrict row, double entering, const double* __restrict in, double leaving,
                  const double* __restrict out, uint32_t count, DistanceSq distance_sq) {
    for (uint32_t c = 0; c < count; ++c) row[c] += distance_sq(in[c], entering) - distance_sq(out[c], leaving);
}

template <class Body>
void with_distance(const PatchChannel& channel, const Body& body) {
    if (channel.period > 0) {
        body(Circle{channel.period});
    } else {
        body(Line{});
    }
}

}  // namespace

PatchMatrix::PatchMatrix(const StyleScene& scene, Memory* memory)
    : scene_(scene),
      several_(scene.sizes.size() > 1 || (scene.sizes.size() == 1 && scene.sizes.front().weight != 1)),
      sizes_(memory),
      columns_(memory) {
    const size_t nodes = scene.node_count();
    const auto add_size = [&](uint32_t patch) {
        sizes_.push_back({patch, Buffer<double>(nodes + 2, memory), Buffer<double>(nodes + 2, memory),
                          Buffer<double>(nodes * scene.curve_count(), memory)});
    };
    sizes_.reserve(std::max<size_t>(scene.sizes.size(), 1));
    if (several_) {
        for (const FlgPatchSize& size : scene.sizes) add_size(size.patch);
        costs_ = Buffer<double>(nodes + 2, memory);
    } else {
        add_size(scene.patch);
    }
    columns_.reserve(nodes / columns_at_once + scene.curve_count());
    for (uint32_t curve = 0; curve < scene.curve_count(); ++curve) {
        const uint32_t end = scene.end_patch(curve);
        for (uint32_t at = scene.first_patch(curve); at < end; at += columns_at_once)
            columns_.push_back({curve, at, std::min(at + columns_at_once, end)});
    }
}

uint32_t PatchMatrix::skip_empty(uint32_t curve) const {
    while (curve < scene_.curve_count() && scene_.end_patch(curve) == scene_.first_patch(curve)) ++curve;
    return curve;
}

// Term by term over some columns, so that no slice depends on p.
Task<void> begin_matrix(Pace& pace, PatchMatrix& matrix) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const StyleScene& scene = matrix.scene_;
    const auto channels = static_cast<uint32_t>(scene.channels.size());
    const auto clear_costs = [costs = matrix.costs_.data()](uint32_t i) { costs[i] = infinite; };
    co_await each(pace, matrix.costs_.size(), Cost::some_ns, clear_costs);
    Slice slice(Cost::hundreds_of_ns);
    for (PatchMatrix::Size& size : matrix.sizes_) {
        const auto clear = [now = size.current.data(), before = size.previous.data()](uint32_t i) {
            now[i] = before[i] = infinite;
        };
        co_await each(pace, size.current.size(), Cost::some_ns, clear);
        for (uint32_t curve = matrix.skip_empty(0); curve < scene.curve_count(); curve = matrix.skip_empty(curve + 1)) {
            for (const PatchMatrix::Columns& columns : matrix.columns_) {
                for (uint32_t term = 0; term <= 2 * size.patch; ++term) {
                    for (uint32_t channel = 0; channel <= channels; ++channel) {
                        matrix.sum(size, curve, columns, term, channel);
                        if (slice.is_over()) co_await pace;
                    }
                }
            }
        }
    }
}

void PatchMatrix::sum(Size& size, uint32_t curve, const Columns& columns, uint32_t term, uint32_t channel) const {
    double* sums = size.first_rows.data() + size_t{curve} * scene_.node_count() + columns.begin;
    const uint32_t count = columns.end - columns.begin;
    const uint32_t point = scene_.first_patch(curve) - size.patch + term;
    const uint32_t others = columns.begin - size.patch + term;
    if (channel > 0) {
        const PatchChannel& from = scene_.channels[channel - 1];
        const double* values = from.values.data();
        with_distance(from,
                      [&](auto distance_sq) { add_channel(sums, values[point], values + others, count, distance_sq); });
        return;
    }
    if (term == 0) std::fill(sums, sums + count, 0.0);
    const Displacement& d = *scene_.displacement;
    add_distances(sums, Points(d, point), Points(d, others), count);
}

bool PatchMatrix::next_row() {
    if (begun_ && row_ + 1 < scene_.end_patch(curve_)) {
        ++row_;
        for (Size& size : sizes_) std::swap(size.current, size.previous);
        return true;
    }
    curve_ = skip_empty(begun_ ? curve_ + 1 : 0);
    begun_ = true;
    if (curve_ == scene_.curve_count()) return false;
    row_ = scene_.first_patch(curve_);
    return true;
}

bool PatchMatrix::make_part() {
    const Columns& columns = columns_[part_];
    roll(sizes_[size_], columns);
    if (channel_++ < scene_.channels.size()) return false;
    channel_ = 0;
    if (several_) add(sizes_[size_], columns);
    if (++part_ < columns_.size()) return false;
    part_ = 0;
    if (++size_ < sizes_.size()) return false;
    size_ = 0;
    return true;
}

void PatchMatrix::roll(Size& size, const Columns& columns) const {
    double* row = size.current.data() + 1;
    uint32_t begin = columns.begin;
    if (row_ == scene_.first_patch(curve_)) {
        const double* sums = first_row(size, curve_);
        if (channel_ == 0) std::copy(sums + begin, sums + columns.end, row + begin);
        return;
    }
    if (begin == scene_.first_patch(columns.curve)) {
        row[begin] = first_row(size, columns.curve)[row_];
        ++begin;
    }
    const uint32_t entering = row_ + size.patch, entering_others = begin + size.patch;
    const uint32_t leaving = row_ - 1 - size.patch, leaving_others = begin - 1 - size.patch;
    if (channel_ > 0) {
        const PatchChannel& channel = scene_.channels[channel_ - 1];
        const double* values = channel.values.data();
        with_distance(channel, [&](auto distance_sq) {
            roll_channel(row + begin, values[entering], values + entering_others, values[leaving],
                         values + leaving_others, columns.end - begin, distance_sq);
        });
        return;
    }
    const Displacement& d = *scene_.displacement;
    roll_distances(row + begin, size.previous.data() + begin, Points(d, entering), Points(d, entering_others),
                   Points(d, leaving), Points(d, leaving_others), columns.end - begin);
}

void PatchMatrix::add(const Size& size, const Columns& columns) {
    const double* distance_sq = size.current.data() + 1;
    const double weight = scene_.sizes[size_].weight;
    double* costs = costs_.data() + 1;
    const bool first = size_ == 0;
    const bool last = size_ + 1 == sizes_.size();
    for (uint32_t c = columns.begin; c < columns.end; ++c) {
        const double cost = (first ? 0.0 : costs[c]) + weight * std::sqrt(std::max(distance_sq[c], 0.0));
        costs[c] = last ? cost * cost : cost;
    }
}

}  // namespace flg
