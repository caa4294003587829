// SPDX-License-Identifier: MIT
#include "pick/ray_order.h"

#include <algorithm>
#include <array>

namespace flg::pick {

namespace {

constexpr uint32_t cells = 128;  // a side of the box
constexpr uint32_t digit_bits = 11;
constexpr uint32_t digits = 2;  // hold the 21 bits of a cell's number

struct Entry {
    uint32_t cell, ray;
};

// Every third bit, beginning with the lowest.
uint32_t spread(uint32_t bits) {
    bits = (bits | bits << 8) & 0x0000f00f;
    bits = (bits | bits << 4) & 0x000c30c3;
    return (bits | bits << 2) & 0x00249249;
}

// Of the cell that the ray enters the box in; rays that miss the box enter somewhere at its side.
uint32_t entry_cell(const FlgRay& ray, const Vec3f& lower, const Vec3f& upper) {
    const Vec3f origin = load(ray.origin), direction = load(ray.direction);
    float entry = ray.nearest;
    for (int k = 0; k < 3; ++k) {
        if (direction[k] == 0) continue;
        entry = std::max(entry, ((direction[k] > 0 ? lower : upper)[k] - origin[k]) / direction[k]);
    }
    uint32_t number = 0;
    for (int k = 0; k < 3; ++k) {
        const float along = (origin[k] + entry * direction[k] - lower[k]) / (upper[k] - lower[k]) * cells;
        // (Written so that what is not a number is 0.)
        const float clamped = along > 0 ? std::min(along, cells - 1.0f) : 0.0f;
        number |= spread(static_cast<uint32_t>(clamped)) << k;
    }
    return number;
}

}  // namespace

std::vector<uint32_t> order_rays(const FlgRay* rays, uint32_t count, const Vec3f& lower, const Vec3f& upper) {
    std::vector<Entry> entries(count), sorted(count);
    for (uint32_t i = 0; i < count; ++i) entries[i] = {entry_cell(rays[i], lower, upper), i};
    for (uint32_t digit = 0; digit < digits; ++digit) {
        constexpr uint32_t mask = (1u << digit_bits) - 1;
        std::array<uint32_t, mask + 2> places{};
        const auto value = [&](const Entry& entry) { return entry.cell >> digit * digit_bits & mask; };
        for (const Entry& entry : entries) ++places[value(entry) + 1];
        for (uint32_t i = 1; i < places.size(); ++i) places[i] += places[i - 1];
        for (const Entry& entry : entries) sorted[places[value(entry)]++] = entry;
        entries.swap(sorted);
    }
    std::vector<uint32_t> order(count);
    for (uint32_t i = 0; i < count; ++i) order[i] = entries[i].ray;
    return order;
}

}  // namespace flg::pick
