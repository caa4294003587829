// SPDX-License-Identifier: MIT
#include "baking/texel_owners.h"

#include "core/failure.h"

namespace flg {

namespace {

constexpr double least_depth = 0.25;  // texels: charts that only touch overlap by rounding

}  // namespace

void refuse_overlap(const Overlaps& overlaps, uint32_t size) {
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "desc.corner_uvs: triangles %u and %u of the mesh overlap at %g %g: give each its own place in the "
                  "texture (a second set of coordinates, as for light maps), or draw them apart by desc.mesh_region",
                  overlaps.first, overlaps.second, (overlaps.x + 0.5) / size, (overlaps.y + 0.5) / size);
}

TexelOwners::TexelOwners(const BakeRequest& request, const Bands& bands, uint32_t band, Memory* memory)
    : first_row(bands.first_row(band)),
      end_row(bands.end_row(band)),
      request_(request),
      size_(request.size),
      owners_(size_t{end_row - first_row} * request.size, memory) {}

bool TexelOwners::Exact::set(const float* uvs, uint32_t size) {
    std::array<int64_t, 3> x, y;
    for (size_t k = 0; k < 3; ++k) {
        x[k] = std::llround(double{uvs[2 * k]} * size * parts);
        y[k] = std::llround(double{uvs[2 * k + 1]} * size * parts);
    }
    const int64_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0) return false;
    if (area < 0) {
        std::swap(x[1], x[2]);
        std::swap(y[1], y[2]);
    }
    for (size_t k = 0; k < 3; ++k) {
        const size_t next = (k + 1) % 3;
        const int64_t along_x = x[next] - x[k], along_y = y[next] - y[k];
        const bool owns_edge = along_y > 0 || (along_y == 0 && along_x < 0);
        from[k] = along_x * (parts / 2 - y[k]) - along_y * (parts / 2 - x[k]) - (owns_edge ? 0 : 1);
        dx[k] = -along_y * parts;
        dy[k] = along_x * parts;
    }
    const auto [west, east] = std::minmax({x[0], x[1], x[2]});
    const auto [north, south] = std::minmax({y[0], y[1], y[2]});
    const auto texel = [size](int64_t place) {
        return static_cast<uint32_t>(std::clamp<int64_t>(place / parts, 0, int64_t{size} - 1));
    };
    left = texel(west), right = texel(east), top = texel(north), bottom = texel(south);
    return true;
}

double TexelOwners::Exact::depth(uint32_t x, uint32_t y) const {
    double least = static_cast<double>(INT64_MAX);
    for (uint32_t k = 0; k < 3; ++k) {
        const double length = std::hypot(static_cast<double>(dx[k]), static_cast<double>(dy[k]));
        least = std::min(least, static_cast<double>(at(k, x, y)) / length);
    }
    return least;  // edges are `parts` times as long in dx and dy
}

void TexelOwners::begin(uint32_t triangle) {
    triangle_ = triangle;
    row_ = stop_ = 0;
    if (!exact_.set(&request_.corner_uvs[6 * size_t{triangle}], size_)) return;
    row_ = std::max(first_row, exact_.top);
    stop_ = std::min(end_row, exact_.bottom + 1);
}

uint32_t TexelOwners::run() {
    if (row_ >= stop_) return 0;
    std::array<int64_t, 3> edges;
    for (uint32_t k = 0; k < 3; ++k) edges[k] = exact_.at(k, exact_.left, row_);
    for (uint32_t x = exact_.left; x <= exact_.right; ++x) {
        if ((edges[0] | edges[1] | edges[2]) >= 0) {
            uint32_t& owner = owners_[at(x, row_)];
            if (owner == no_index) {
                owner = triangle_;
                ++overlaps.texels;
            } else {
                claim_again(x, row_);
            }
        }
        for (size_t k = 0; k < 3; ++k) edges[k] += exact_.dx[k];
    }
    ++row_;
    return exact_.right - exact_.left + 1;
}

void TexelOwners::claim_again(uint32_t x, uint32_t y) {
    Overlaps found = overlaps;
    if (found.count++ == 0) {
        found.first = owners_[at(x, y)];
        found.second = triangle_;
        found.x = x;
        found.y = y;
    }
    Exact other{};
    other.set(&request_.corner_uvs[6 * size_t{owners_[at(x, y)]}], size_);
    if (std::min(exact_.depth(x, y), other.depth(x, y)) > least_depth) {
        found.first = owners_[at(x, y)];
        found.second = triangle_;
        found.x = x;
        found.y = y;
        refuse_overlap(found, size_);
    }
    overlaps = found;
}

}  // namespace flg
