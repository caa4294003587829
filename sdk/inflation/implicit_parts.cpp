// SPDX-License-Identifier: MIT
#include "inflation/implicit_parts.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double not_even = 1e-3;  // how far axes may be from right angles and one length

struct FieldSample {
    double value, x, y;
};

// Cubic interpolation (Catmull, Rom 1974) between values 1 and 2, and its slope.
void weights(double t, double (&value)[4], double (&slope)[4]) {
    const double t2 = t * t, t3 = t2 * t;
    value[0] = 0.5 * (-t3 + 2 * t2 - t);
    value[1] = 0.5 * (3 * t3 - 5 * t2 + 2);
    value[2] = 0.5 * (-3 * t3 + 4 * t2 + t);
    value[3] = 0.5 * (t3 - t2);
    slope[0] = 0.5 * (-3 * t2 + 4 * t - 1);
    slope[1] = 0.5 * (9 * t2 - 10 * t);
    slope[2] = 0.5 * (-9 * t2 + 8 * t + 1);
    slope[3] = 0.5 * (3 * t2 - 2 * t);
}

// A place on a raster; at its edge the last whole cell goes on.
struct RasterPlace {
    RasterPlace(const PartRaster& on, double u, double v) : raster(on) {
        const double x = (u - raster.origin.x) / raster.spacing, y = (v - raster.origin.y) / raster.spacing;
        const double inner_x = std::clamp(x, 1.0, raster.width - 2.0),
                     inner_y = std::clamp(y, 1.0, raster.height - 2.0);
        column = std::min(static_cast<uint32_t>(inner_x), raster.width - 3);
        row = std::min(static_cast<uint32_t>(inner_y), raster.height - 3);
        weights(inner_x - column, wx, sx);
        weights(inner_y - row, wy, sy);
        ex = (x - inner_x) * raster.spacing;
        ey = (y - inner_y) * raster.spacing;
    }

    FieldSample of(const double* grid) const {
        FieldSample result{0, 0, 0};
        for (uint32_t j = 0; j < 4; ++j) {
            const double* values = &grid[size_t{raster.width} * (row + j - 1) + column - 1];
            const double along = (wx[0] * values[0] + wx[1] * values[1]) + (wx[2] * values[2] + wx[3] * values[3]);
            const double slope = (sx[0] * values[0] + sx[1] * values[1]) + (sx[2] * values[2] + sx[3] * values[3]);
            result.value += wy[j] * along;
            result.x += wy[j] * slope;
            result.y += sy[j] * along;
        }
        result.x /= raster.spacing;
        result.y /= raster.spacing;
        return result;
    }

    // The squared height; beyond the raster it goes on falling as a ball's does.
    FieldSample square() const {
        FieldSample result = of(raster.values.data());
        if (ex != 0 || ey != 0) {
            const double beyond = std::hypot(ex, ey), steep = std::hypot(result.x, result.y);
            result.value -= beyond * (beyond + steep);
            result.x -= ex / beyond * (2 * beyond + steep);
            result.y -= ey / beyond * (2 * beyond + steep);
        }
        return result;
    }

    const PartRaster& raster;
    uint32_t column, row;
    double wx[4], sx[4], wy[4], sy[4];
    double ex, ey;  // how far beyond
};

// How far out of its plane, and how that changes.
FieldSample lift_at(const PartLift& lift, const RasterPlace& place) {
    if (lift.ways.empty()) return {lift.base, 0, 0};
    const FieldSample way = place.of(lift.ways.data());
    const double slope = lift.slope(way.value);
    return {lift.at(way.value), slope * way.x, slope * way.y};
}

}  // namespace

ImplicitPart::ImplicitPart(const PlacedPart& placed, uint32_t number)
    : part_(placed.part), lift_(placed.lift), thickness_(placed.thickness) {
    const auto& m = placed.placement;
    matrix_ << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    origin_ = Vec3(m[3], m[7], m[11]);
    const double determinant = matrix_.determinant();
    scale_ = std::cbrt(std::fabs(determinant));
    if (!std::isfinite(determinant) || !origin_.allFinite() || !(scale_ > 0) ||
        !((matrix_.transpose() * matrix_ - scale_ * scale_ * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <=
          not_even * scale_ * scale_))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "part %u: its placement is not a rotation, one scale above 0 and a translation", number);
    if (!(thickness_ > 0) || !std::isfinite(thickness_))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "part %u: its thickness is %g, not above 0", number, thickness_);
    inverse_ = matrix_.inverse();
    const double highest = part_->highest / part_->thickness;
    radius_ = scale_ * highest * std::min(thickness_, std::sqrt(0.5));
    const PartRaster& raster = part_->raster;
    const double depth = thickness_ * highest;
    const double lowest_lift = lift_ ? lift_->base + std::min(lift_->rise, 0.0) : 0,
                 highest_lift = lift_ ? lift_->base + std::max(lift_->rise, 0.0) : 0;
    for (uint32_t i = 0; i < 8; ++i) {
        // Two of the raster's cells around the contour; as much above and below.
        const double around = 2 * raster.spacing;
        const Vec3 corner =
            place(Vec3(raster.origin.x + ((i & 1) ? raster.spacing * (raster.width - 1) - around / 2 : around / 2),
                       raster.origin.y + ((i & 2) ? raster.spacing * (raster.height - 1) - around / 2 : around / 2),
                       (i & 4) ? highest_lift + depth + around : lowest_lift - depth - around));
        low_ = i == 0 ? corner : Vec3(low_.cwiseMin(corner));
        high_ = i == 0 ? corner : Vec3(high_.cwiseMax(corner));
    }
}

double ImplicitPart::squared_height(double u, double v) const {
    return thickness_ * thickness_ * RasterPlace(part_->raster, u, v).square().value;
}

double ImplicitPart::lift(double u, double v) const {
    return lift_ ? lift_at(*lift_, RasterPlace(part_->raster, u, v)).value : 0;
}

ImplicitPart::Sample ImplicitPart::sample(const Vec3& p) const {
    const Vec3 at = local(p);
    const RasterPlace place(part_->raster, at.x(), at.y());
    const FieldSample g = place.square(), lifted = lift_ ? lift_at(*lift_, place) : FieldSample{0, 0, 0};
    // Where it rises it is as thick as elsewhere at right angles to itself.
    const double squared = thickness_ * thickness_ * (1 + lifted.x * lifted.x + lifted.y * lifted.y);
    const double w = at.z() - lifted.value;
    const double value = squared * g.value - w * w;
    const Vec3 gradient(squared * g.x + 2 * w * lifted.x, squared * g.y + 2 * w * lifted.y, -2 * w);
    const double steep_squared = gradient.squaredNorm(), steep = std::sqrt(steep_squared);
    const double sum = steep + std::sqrt(std::max(0.0, steep_squared + 4 * value));
    // Both are 0 only where F is 0 and flat: nowhere but at points.
    if (!(sum > 0)) return {value < 0 ? -scale_ * std::sqrt(-value) : 0, Vec3::Zero()};
    return {scale_ * 2 * value / sum, steep > 0 ? Vec3(matrix_ * gradient / (scale_ * steep)) : Vec3(Vec3::Zero())};
}

namespace {

constexpr double blend_share = 0.15;  // of the smaller radius
constexpr double nothing = -1e30;
constexpr double least_steep = 0.5;  // of the difference of two values, which is 2 where surfaces face each other
// By the widest blend: how far from its box a part may be above minus the blend (outside, values are at most half the
// distance).
constexpr double margin_by_blend = 2.5;
constexpr double max_cells = 32;             // along an axis
constexpr uint64_t max_entries = 4'000'000;  // of the lists: parts that all reach everywhere are not sorted

}  // namespace

Task<PartUnion> PartUnion::make(Pace& pace, std::span<const PlacedPart> placed, double blend) {
    PartUnion all(blend, pace.memory());
    all.parts_.reserve(placed.size());
    all.apart_from_.reserve(placed.size());
    co_await each(pace, placed.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        const ImplicitPart& part = all.parts_.emplace_back(placed[i], i);
        all.apart_from_.push_back(placed[i].apart_from);
        all.low_ = i == 0 ? part.low() : Vec3(all.low_.cwiseMin(part.low()));
        all.high_ = i == 0 ? part.high() : Vec3(all.high_.cwiseMax(part.high()));
        all.widest_ = std::max(all.widest_, all.blend_of(i, i));
    });
    all.margin_ = margin_by_blend * all.widest_;
    all.low_.array() -= all.margin_;
    all.high_.array() += all.margin_;
    const Vec3 extent = all.high_ - all.low_;
    const double along = std::min(max_cells, std::ceil(2 * std::cbrt(static_cast<double>(placed.size())) + 1));
    all.cell_ = extent.maxCoeff() / along;
    for (uint32_t k = 0; k < 3; ++k) all.counts_[k] = static_cast<uint32_t>(extent[k] / all.cell_) + 1;
    uint64_t entries = 0;
    co_await each(pace, placed.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Cells cells = all.cells_of(all.parts_[i]);
        uint64_t volume = 1;
        for (uint32_t k = 0; k < 3; ++k) volume *= cells.last[k] - cells.first[k] + 1;
        entries += volume;
    });
    if (entries > max_entries) {
        all.cell_ = 2 * extent.maxCoeff();
        all.counts_ = {1, 1, 1};
        entries = placed.size();
    }

    // Parts by cell. A part's cells come layer by layer.
    const uint32_t cells = all.counts_[0] * all.counts_[1] * all.counts_[2], layers = all.counts_[2];
    all.offsets_ = Buffer<uint32_t>(cells + size_t{2}, pace.memory());
    all.near_ = Buffer<uint32_t>(entries, pace.memory());
    Buffer<uint32_t>& offsets = all.offsets_;
    co_await each(pace, offsets.size(), Cost::some_ns, [&](uint32_t cell) { offsets[cell] = 0; });
    co_await each_by_work(pace, placed.size() * layers, Cost::some_ns, [&](uint32_t i) {
        return all.each_cell_in_layer(i / layers, i % layers, [&](uint32_t cell) { ++offsets[cell + 2]; });
    });
    co_await each(pace, cells, Cost::some_ns, [&](uint32_t cell) { offsets[cell + 2] += offsets[cell + 1]; });
    co_await each_by_work(pace, placed.size() * layers, Cost::some_ns, [&](uint32_t i) {
        return all.each_cell_in_layer(i / layers, i % layers,
                                      [&](uint32_t cell) { all.near_[offsets[cell + 1]++] = i / layers; });
    });
    co_return all;
}

PartUnion::Cells PartUnion::cells_of(const ImplicitPart& part) const {
    const auto cell = [this](double at, uint32_t k) {
        return std::min(counts_[k] - 1, static_cast<uint32_t>(std::max(0.0, (at - low_[k]) / cell_)));
    };
    Cells cells{};
    for (uint32_t k = 0; k < 3; ++k) {
        cells.first[k] = cell(part.low()[k] - margin_, k);
        cells.last[k] = cell(part.high()[k] + margin_, k);
    }
    return cells;
}

// Returns about what it did, in cells.
template <class Action>
uint32_t PartUnion::each_cell_in_layer(uint32_t part, uint32_t layer, const Action& action) const {
    const Cells cells = cells_of(parts_[part]);
    if (layer < cells.first[2] || layer > cells.last[2]) return 4;
    for (uint32_t y = cells.first[1]; y <= cells.last[1]; ++y)
        for (uint32_t x = cells.first[0]; x <= cells.last[0]; ++x) action((layer * counts_[1] + y) * counts_[0] + x);
    return 4 + (cells.last[1] - cells.first[1] + 1) * (cells.last[0] - cells.first[0] + 1);
}

double PartUnion::blend_of(uint32_t a, uint32_t b) const {
    return blend_ >= 0 ? blend_ : blend_share * std::min(parts_[a].radius(), parts_[b].radius());
}

bool PartUnion::are_apart(uint32_t a, uint32_t b) const {
    return std::find(apart_from_[a].begin(), apart_from_[a].end(), b) != apart_from_[a].end();
}

// What the parts that are kept apart from others are at a point; beyond so many they are found anew where needed.
struct PartUnion::Near {
    static constexpr uint32_t capacity = 24;

    void add(uint32_t part, const ImplicitPart::Sample& sample) {
        parts[count] = part;
        samples[count++] = sample;
    }
    const ImplicitPart::Sample* find(uint32_t part) const {
        for (uint32_t i = 0; i < count; ++i)
            if (parts[i] == part) return &samples[i];
        return nullptr;
    }

    std::array<uint32_t, capacity> parts;
    std::array<ImplicitPart::Sample, capacity> samples;
    uint32_t count = 0;
};

// Where the part ends because of those that it is kept apart from; the edge is rounded.
ImplicitPart::Sample PartUnion::cut_off(const ImplicitPart::Sample& whole, uint32_t part, const Vec3& p,
                                        const Near& near) const {
    ImplicitPart::Sample sample = whole;
    for (const uint32_t other : apart_from_[part]) {
        if (other >= parts_.size() || !parts_[other].reaches(p, margin_ + gap_)) continue;
        const ImplicitPart::Sample* const known = near.find(other);
        const ImplicitPart::Sample theirs = known ? *known : parts_[other].sample(p);
        const Vec3 slope = whole.gradient - theirs.gradient;
        const double steep = std::max(slope.norm(), least_steep);
        const ImplicitPart::Sample cut{(whole.value - theirs.value) / steep - gap_ / 2, slope / steep};
        const bool is_cut = cut.value < sample.value;
        const ImplicitPart::Sample least = is_cut ? cut : sample, more = is_cut ? sample : cut;
        const double blend = blend_of(part, other), share = blend > 0 ? 1 - (more.value - least.value) / blend : 0;
        sample = least;
        if (!(share > 0)) continue;
        sample.value -= share * share * blend / 4;
        sample.gradient += (more.gradient - least.gradient) * (share / 2);
    }
    return sample;
}

PartUnion::Sample PartUnion::sample(const Vec3& p) const {
    struct Valued {
        ImplicitPart::Sample sample;
        uint32_t part;
    };
    // The largest first. The third stands in where the second is kept apart from the first.
    constexpr uint32_t ranks = 3;
    std::array<Valued, ranks> best;
    best.fill({{nothing, Vec3::Zero()}, 0});
    const Vec3 place = (p - low_) / cell_;
    if (!((p - low_).array() >= 0).all() || !((p - high_).array() <= 0).all()) return {nothing, Vec3::Zero(), 0};
    const uint32_t cell = (std::min(counts_[2] - 1, static_cast<uint32_t>(place.z())) * counts_[1] +
                           std::min(counts_[1] - 1, static_cast<uint32_t>(place.y()))) *
                              counts_[0] +
                          std::min(counts_[0] - 1, static_cast<uint32_t>(place.x()));
    const auto offer = [&](const ImplicitPart::Sample& sample, uint32_t i) {
        uint32_t rank = ranks;
        for (; rank > 0 && sample.value > best[rank - 1].sample.value; --rank)
            if (rank < ranks) best[rank] = best[rank - 1];
        if (rank < ranks) best[rank] = {sample, i};
    };
    // Those that are kept apart from others come last, when these are known.
    Near near;
    for (uint32_t e = offsets_[cell]; e < offsets_[cell + 1]; ++e) {
        const uint32_t i = near_[e];
        if (!parts_[i].reaches(p, margin_)) continue;
        const ImplicitPart::Sample sample = parts_[i].sample(p);
        if (apart_from_[i].empty()) {
            offer(sample, i);
        } else if (near.count < Near::capacity) {
            near.add(i, sample);
        } else {
            offer(cut_off(sample, i, p, near), i);
        }
    }
    for (uint32_t k = 0; k < near.count; ++k)
        if (near.samples[k].value > best[ranks - 1].sample.value)
            offer(cut_off(near.samples[k], near.parts[k], p, near), near.parts[k]);
    const auto& [largest, first] = best[0];
    const auto& [next, second] = best[are_apart(first, best[1].part) ? 2 : 1];
    if (next.value > largest.value - widest_ && next.value > nothing) {
        const double crossing = std::min(1.0, 1 - largest.gradient.dot(next.gradient));
        const double blend = crossing * blend_of(first, second);
        const double share = 1 - (largest.value - next.value) / blend;
        if (blend > 0 && share > 0)
            return {largest.value + share * share * blend / 4,
                    largest.gradient + (next.gradient - largest.gradient) * (share / 2), first};
    }
    return {largest.value, largest.gradient, first};
}

ImplicitPart::Sample PartUnion::difference(const Vec3& p, uint32_t a, uint32_t b) const {
    Near none;
    none.count = 0;
    const auto sample = [&](uint32_t part) {
        const ImplicitPart::Sample whole = parts_[part].sample(p);
        return apart_from_[part].empty() ? whole : cut_off(whole, part, p, none);
    };
    const ImplicitPart::Sample of_a = sample(a), of_b = sample(b);
    return {of_a.value - of_b.value, of_a.gradient - of_b.gradient};
}

}  // namespace flg
