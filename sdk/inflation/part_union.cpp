// SPDX-License-Identifier: MIT
#include "inflation/part_union.h"

#include <algorithm>

namespace flg {

namespace {

constexpr double blend_share = 0.15;  // of the smaller radius
constexpr double nothing = -1e30;

}  // namespace

PartUnion::PartUnion(std::span<const PlacedPart> parts, double blend, Memory* memory) : parts_(memory), blend_(blend) {
    parts_.reserve(parts.size());
    for (uint32_t i = 0; i < parts.size(); ++i) parts_.emplace_back(parts[i], i);
    for (uint32_t i = 0; i < parts.size(); ++i) widest_ = std::max(widest_, blend_of(i, i));
}

double PartUnion::blend_of(uint32_t a, uint32_t b) const {
    return blend_ >= 0 ? blend_ : blend_share * std::min(parts_[a].radius(), parts_[b].radius());
}

PartUnion::Sample PartUnion::sample(const Vec3& p) const {
    uint32_t first = 0, second = 0;
    ImplicitPart::Sample largest{nothing, Vec3::Zero()}, next = largest;
    for (uint32_t i = 0; i < parts_.size(); ++i) {
        if (!parts_[i].reaches(p, 2.5 * widest_)) continue;
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
