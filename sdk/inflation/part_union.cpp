// SPDX-License-Identifier: MIT
#include "inflation/part_union.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr double blend_share = 0.15;  // of the smaller radius
constexpr double nothing = -1e30;
// By the widest blend: how far from its box a part may be above minus the blend (outside, values are at most half the distance).
constexpr double margin_by_blend = 2.5;
constexpr double most_cells = 32;             // along an axis
constexpr uint32_t most_entries = 4'000'000;  // of the lists: parts that all reach everywhere are not sorted
constexpr uint32_t batch = 64;

}  // namespace

PartUnion::PartUnion(std::span<const PlacedPart> parts, double blend, Memory* memory)
    : placed_(parts), memory_(memory), parts_(memory), blend_(blend) {
    parts_.reserve(parts.size());
}

bool PartUnion::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        const auto offsets = static_cast<uint32_t>(offsets_.size());
        switch (pass_) {
            case Pass::parts: {
                const ImplicitPart& part = parts_.emplace_back(placed_[at_], at_);
                low_ = at_ == 0 ? part.low() : Vec3(low_.cwiseMin(part.low()));
                high_ = at_ == 0 ? part.high() : Vec3(high_.cwiseMax(part.high()));
                widest_ = std::max(widest_, blend_of(at_, at_));
                if (++at_ == placed_.size()) begin_cells();
                break;
            }
            case Pass::clear:
                for (const uint32_t stop = std::min(offsets, at_ + batch); at_ < stop; ++at_) offsets_[at_] = 0;
                if (at_ < offsets) break;
                at_ = 0;
                pass_ = Pass::count;
                break;
            case Pass::count:
                if (!layer([this](uint32_t cell) { ++offsets_[cell + 2]; })) break;
                pass_ = Pass::sum;
                break;
            case Pass::sum:
                for (const uint32_t stop = std::min(offsets, at_ + batch); at_ + 1 < stop; ++at_)
                    offsets_[at_ + 1] = std::min(most_entries + 1, offsets_[at_ + 1] + offsets_[at_]);
                if (at_ + 1 < offsets) break;
                if (offsets_[offsets - 1] > most_entries) {
                    cell_ = 2 * (high_ - low_).maxCoeff();
                    counts_ = {1, 1, 1};
                    offsets_ = Buffer<uint32_t>(3, memory_);
                    at_ = 0;
                    pass_ = Pass::clear;
                    break;
                }
                near_ = Buffer<uint32_t>(offsets_[offsets - 1], memory_);
                at_ = 0;
                pass_ = Pass::fill;
                break;
            case Pass::fill:
                if (layer([this](uint32_t cell) { near_[offsets_[cell + 1]++] = at_; })) pass_ = Pass::done;
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

void PartUnion::begin_cells() {
    margin_ = margin_by_blend * widest_;
    low_.array() -= margin_;
    high_.array() += margin_;
    const double along = std::min(most_cells, std::ceil(2 * std::cbrt(static_cast<double>(parts_.size())) + 1));
    cell_ = (high_ - low_).maxCoeff() / along;
    for (uint32_t k = 0; k < 3; ++k) counts_[k] = static_cast<uint32_t>((high_ - low_)[k] / cell_) + 1;
    offsets_ = Buffer<uint32_t>(size_t{counts_[0]} * counts_[1] * counts_[2] + 2, memory_);
    at_ = 0;
    pass_ = Pass::clear;
}

void PartUnion::cells_of(const ImplicitPart& part, std::array<uint32_t, 3>& first,
                         std::array<uint32_t, 3>& last) const {
    const auto cell = [this](double at, uint32_t k) {
        return std::min(counts_[k] - 1, static_cast<uint32_t>(std::max(0.0, (at - low_[k]) / cell_)));
    };
    for (uint32_t k = 0; k < 3; ++k) {
        first[k] = cell(part.low()[k] - margin_, k);
        last[k] = cell(part.high()[k] + margin_, k);
    }
}

// The cells of one part in one layer; true after the last of the last part.
template <class Action>
bool PartUnion::layer(const Action& action) {
    std::array<uint32_t, 3> first, last;
    cells_of(parts_[at_], first, last);
    for (uint32_t y = first[1]; y <= last[1]; ++y)
        for (uint32_t x = first[0]; x <= last[0]; ++x) action(((first[2] + layer_) * counts_[1] + y) * counts_[0] + x);
    if (first[2] + ++layer_ <= last[2]) return false;
    layer_ = 0;
    if (++at_ < parts_.size()) return false;
    at_ = 0;
    return true;
}

double PartUnion::blend_of(uint32_t a, uint32_t b) const {
    return blend_ >= 0 ? blend_ : blend_share * std::min(parts_[a].radius(), parts_[b].radius());
}

PartUnion::Sample PartUnion::sample(const Vec3& p) const {
    uint32_t first = 0, second = 0;
    ImplicitPart::Sample largest{nothing, Vec3::Zero()}, next = largest;
    const Vec3 place = (p - low_) / cell_;
    if (!((p - low_).array() >= 0).all() || !((p - high_).array() <= 0).all()) return {nothing, Vec3::Zero(), 0};
    const uint32_t cell = (std::min(counts_[2] - 1, static_cast<uint32_t>(place.z())) * counts_[1] +
                           std::min(counts_[1] - 1, static_cast<uint32_t>(place.y()))) *
                              counts_[0] +
                          std::min(counts_[0] - 1, static_cast<uint32_t>(place.x()));
    for (uint32_t e = offsets_[cell]; e < offsets_[cell + 1]; ++e) {
        const uint32_t i = near_[e];
        if (!parts_[i].reaches(p, margin_)) continue;
        const ImplicitPart::Sample sample = parts_[i].sample(p);
        if (sample.value > largest.value) {
            next = largest;
            second = first;
            largest = sample;
            first = i;
        } else if (sample.value > next.value) {
            next = sample;
            second = i;
        }
    }
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

}  // namespace flg
