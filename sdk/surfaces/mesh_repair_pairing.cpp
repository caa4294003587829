// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_pairing.h"

#include "core/failure.h"

namespace flg {

PairingKernel::PairingKernel(const GrowingBuffer<Position>& positions, const GrowingBuffer<Triple>& triangles,
                             const Buffer<Corner>& sorted, Mates& mates, Memory* memory)
    : positions_(positions),
      triangles_(triangles),
      sorted_(sorted),
      mates_(mates),
      corners_(memory),
      sheets_(memory),
      duplicates_(memory) {}

void PairingKernel::join_two(Corner a, Corner b) {
    mates_.join(a, b);
    if (start_of(a) == start_of(b)) winding_differs_ = true;
}

// Sorted by apex, duplicates lie side by side, the first triangle first.
void PairingKernel::drop_duplicates() {
    std::sort(corners_.begin(), corners_.end(),
              [this](Corner a, Corner b) { return std::pair(apex_of(a), a) < std::pair(apex_of(b), b); });
    size_t kept = 1;
    for (size_t i = 1; i < corners_.size(); ++i) {
        if (apex_of(corners_[i]) == apex_of(corners_[kept - 1])) {
            duplicates_.push_back(triangle_of(corners_[i]));
        } else {
            corners_[kept++] = corners_[i];
        }
    }
    corners_.resize(kept);
}

void PairingKernel::pair_sheets(const Edge& edge) {
    const auto position = [this](uint32_t vertex) { return load_vec3(positions_[vertex].data()); };
    const Vec3 origin = position(edge.lesser);
    const Vec3 along = (position(edge.greater) - origin).stableNormalized();
    sheets_.clear();
    for (Corner corner : corners_) {
        const Vec3 to_apex = position(apex_of(corner)) - origin;
        sheets_.push_back(
            {corner, (to_apex - to_apex.dot(along) * along).stableNormalized(), start_of(corner) == edge.lesser});
    }
    // 0 if b goes on where a ends, 2 if it folds back onto it. The inside of b is before it, turning about the edge.
    const auto bend = [&](const Sheet& a, const Sheet& b) {
        constexpr double concave = 1e-3;
        return 1 + a.away.dot(b.away) + (along.dot(b.away.cross(a.away)) > 0 ? 0 : concave);
    };
    for (;;) {
        size_t best_a = 0, best_b = 0;
        double least = 4;
        for (size_t a = 0; a < sheets_.size(); ++a) {
            for (size_t b = 0; b < sheets_.size(); ++b) {
                if (!sheets_[a].forward || sheets_[b].forward) continue;
                const double value = bend(sheets_[a], sheets_[b]);
                if (value < least) {
                    least = value;
                    best_a = a;
                    best_b = b;
                }
            }
        }
        if (least == 4) return;
        mates_.join(sheets_[best_a].corner, sheets_[best_b].corner);
        sheets_.erase(sheets_.begin() + static_cast<ptrdiff_t>(std::max(best_a, best_b)));
        sheets_.erase(sheets_.begin() + static_cast<ptrdiff_t>(std::min(best_a, best_b)));
    }
}

void PairingKernel::pair_run(uint32_t begin, uint32_t end) {
    corners_.assign(sorted_.begin() + begin, sorted_.begin() + end);
    for (Corner corner : corners_) mates_.leave_open(corner);
    drop_duplicates();
    if (corners_.size() == 2) join_two(corners_[0], corners_[1]);
    if (corners_.size() <= 2) return;
    ++crowded_count_;
    if (corners_.size() <= paired_triangles_max) pair_sheets(edge_at(triangles_, corners_[0]));
}

bool PairingKernel::run(uint32_t count) {
    for (; at_ < sorted_.size(); --count) {
        if (count == 0) return false;
        const uint32_t begin = at_;
        const Edge edge = edge_at(triangles_, sorted_[begin]);
        while (++at_ < sorted_.size() && edge_at(triangles_, sorted_[at_]) == edge) {
            if (at_ - begin == edge_triangles_max) {
                throw Failure(FLG_ERROR_LIMIT, "more than %u triangles share the edge from vertex %u to vertex %u",
                              edge_triangles_max, edge.lesser, edge.greater);
            }
        }
        const Corner corner = sorted_[begin];
        if (at_ - begin == 1) {
            mates_.leave_open(corner);
        } else if (at_ - begin == 2 && apex_of(corner) != apex_of(sorted_[begin + 1])) {
            join_two(corner, sorted_[begin + 1]);
        } else {
            pair_run(begin, at_);
        }
    }
    return true;
}

}  // namespace flg
