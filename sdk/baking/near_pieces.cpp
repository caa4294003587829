// SPDX-License-Identifier: MIT
#include "baking/near_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flg {

namespace {

using Lanes = float __attribute__((vector_size(16)));
using Numbers = int32_t __attribute__((vector_size(16)));
constexpr uint32_t lane_width = 4, parts = TexelBatch::lanes / lane_width;

constexpr uint32_t units_per_piece = 2;  // to gather it
constexpr uint32_t pieces_searched = 2;  // for all lanes, a unit

template <class Vector, class T>
Vector load_lanes(const T* values) {
    Vector out;
    for (uint32_t i = 0; i < lane_width; ++i) out[i] = values[i];
    return out;
}

}  // namespace

bool TexelPlane::set(const Buffer<Position>& positions, const Triple& corners, const float* uvs, uint32_t size) {
    const double x1 = size * (double{uvs[2]} - double{uvs[0]}), y1 = size * (double{uvs[3]} - double{uvs[1]});
    const double x2 = size * (double{uvs[4]} - double{uvs[0]}), y2 = size * (double{uvs[5]} - double{uvs[1]});
    const double area = x1 * y2 - x2 * y1;
    if (area == 0) return false;
    origin = load_vec3(positions[corners[0]].data());
    const Vec3 first = load_vec3(positions[corners[1]].data()) - origin;
    const Vec3 second = load_vec3(positions[corners[2]].data()) - origin;
    const double per_area = 1 / area;
    const Vec3 right = per_area * (y2 * first - y1 * second), down = per_area * (x1 * second - x2 * first);
    corner = {size * double{uvs[0]}, size * double{uvs[1]}};
    step_x = right.norm();
    axis_x = (step_x > 0 ? 1 / step_x : 0.0) * right;
    row_x = axis_x.dot(down);
    const Vec3 across = down - row_x * axis_x;
    row_y = across.norm();
    axis_y = (row_y > 0 ? 1 / row_y : 0.0) * across;
    axis_z = axis_x.cross(axis_y);
    unit = std::max(step_x, row_y);
    if (unit == 0) unit = 1;
    per_metre = 1 / unit;
    step_x *= per_metre;
    row_x *= per_metre;
    row_y *= per_metre;
    return true;
}

// How far one texel on, and one row on, lead across it.
float NearPiece::width(const TexelPlane& plane) const {
    const double flat_sq = double{along_x} * double{along_x} + double{along_y} * double{along_y};
    if (flat_sq == 0) return static_cast<float>(std::sqrt(plane.step_x * plane.step_x + plane.row_y * plane.row_y));
    const double over_x = double{along_y} * plane.step_x;
    const double over_y = double{along_y} * plane.row_x - double{along_x} * plane.row_y;
    return static_cast<float>(std::sqrt((over_x * over_x + over_y * over_y) / flat_sq));
}

void NearPieces::begin(const Triple& vertices) {
    pieces_.clear();
    hub_count_ = hub_ = end_ = 0;
    for (const uint32_t v : vertices) {
        if (!borders_.at_vertex.of(v).empty()) {
            add_hub(v);
        } else if (borders_.nearest[v] != no_index) {
            for (const uint32_t end : borders_.pieces[borders_.nearest[v]].ends) add_hub(end);
        }
    }
}

bool NearPieces::is_known(uint32_t vertex) const {
    return std::find(hubs_.begin(), hubs_.begin() + hub_count_, vertex) != hubs_.begin() + hub_count_;
}

void NearPieces::add_hub(uint32_t vertex) {
    if (!is_known(vertex)) hubs_[hub_count_++] = vertex;
}

uint32_t NearPieces::gather(const TexelPlane& plane, uint32_t units) {
    uint32_t done = 0;
    while (hub_ < hub_count_ && done < units) {
        const auto ends = borders_.at_vertex.of(hubs_[hub_]);
        const auto before = hubs_.begin() + hub_;
        for (; end_ < ends.size() && done < units; ++end_) {
            const uint32_t piece = ends[end_] / 2, other = borders_.pieces[piece].ends[1 - ends[end_] % 2];
            done += units_per_piece;
            if (std::find(hubs_.begin(), before, other) == before) add_piece(plane, piece);
        }
        if (end_ < ends.size()) break;
        end_ = 0;
        ++hub_;
    }
    return done;
}

void NearPieces::add_piece(const TexelPlane& plane, uint32_t piece) {
    const BorderPiece& border = borders_.pieces[piece];
    const Vec3 offset = plane.per_metre * (load_vec3(border.from.data()) - plane.origin);
    const Vec3 along = plane.per_metre * load_vec3(border.along.data());
    pieces_.push_back({static_cast<float>(plane.axis_x.dot(offset)), static_cast<float>(plane.axis_y.dot(offset)),
                       static_cast<float>(plane.axis_z.dot(offset)), static_cast<float>(plane.axis_x.dot(along)),
                       static_cast<float>(plane.axis_y.dot(along)), static_cast<float>(plane.axis_z.dot(along)),
                       static_cast<float>(border.inverse_length_sq * plane.unit * plane.unit), piece});
}

void NearPieces::begin_search(TexelBatch& batch) {
    batch.distances_sq.fill(std::numeric_limits<float>::infinity());
    batch.nearest.fill(-1);
    searched_ = 0;
}

uint32_t NearPieces::search(TexelBatch& batch, uint32_t units) {
    const size_t begin = searched_;
    searched_ = std::min(pieces_.size(), begin + size_t{units} * pieces_searched);
    std::array<Lanes, parts> x, y, least;
    std::array<Numbers, parts> nearest;
    for (uint32_t k = 0; k < parts; ++k) {
        x[k] = load_lanes<Lanes>(&batch.x[k * lane_width]);
        y[k] = load_lanes<Lanes>(&batch.y[k * lane_width]);
        least[k] = load_lanes<Lanes>(&batch.distances_sq[k * lane_width]);
        nearest[k] = load_lanes<Numbers>(&batch.nearest[k * lane_width]);
    }
    for (size_t i = begin; i < searched_; ++i) {
        const NearPiece& piece = pieces_[i];
        for (uint32_t k = 0; k < parts; ++k) {
            const Lanes to_x = x[k] - piece.x, to_y = y[k] - piece.y;
            const Lanes dot = to_x * piece.along_x + to_y * piece.along_y - piece.z * piece.along_z;
            Lanes share = dot * piece.inverse_length_sq;
            share = share > 0.0f ? share : Lanes{};
            share = share < 1.0f ? share : Lanes{} + 1.0f;
            const Lanes off_x = to_x - share * piece.along_x, off_y = to_y - share * piece.along_y,
                        off_z = -piece.z - share * piece.along_z;
            const Lanes found = off_x * off_x + off_y * off_y + off_z * off_z;
            const Numbers is_less = found < least[k];
            least[k] = is_less ? found : least[k];
            nearest[k] = is_less ? Numbers{} + static_cast<int32_t>(i) : nearest[k];
        }
    }
    for (uint32_t lane = 0; lane < TexelBatch::lanes; ++lane) {
        batch.distances_sq[lane] = least[lane / lane_width][lane % lane_width];
        batch.nearest[lane] = nearest[lane / lane_width][lane % lane_width];
    }
    return 1 + static_cast<uint32_t>(searched_ - begin) / pieces_searched;
}

}  // namespace flg
