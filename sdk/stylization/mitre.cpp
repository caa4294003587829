// SPDX-License-Identifier: MIT
#include "stylization/mitre.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/pace.h"

namespace flg {

namespace {

constexpr double tip_max = 2;      // displacements
constexpr double reversal = 1e-6;  // sum of both tangents at a turn that has no plane
constexpr double parallel = 0.05;  // cosine below which nothing slides into a plane
constexpr double sizes_max = 4;    // displacements are hardly longer
constexpr double rounding = 1e-6;  // of coordinates
constexpr uint32_t units_at_once = 200;

// Falls evenly from 1 at 0 to 0 at 1.
double faded(double r) {
    return r < 1 ? 1 - r * r * (3 - 2 * r) : 0.0;
}

// One side of a corner.
struct CornerSide {
    Vec3 corner = Vec3::Zero();
    Vec3 inwards = Vec3::Zero();  // across the plane, to where the piece is
    double reach = 0;             // metres: how far the plane matters; 0: there is no corner
    double fade_along = 0,
           fade_across = 0;  // metres: how far points slide for what they are off along the target, across
    double kept = 1;         // share of the displacement that long tips leave

    CornerSide() = default;
    CornerSide(const Vec3& at, const Vec3& before, const Vec3& behind, double side, double size, double half_piece)
        : corner(at) {
        const double sum = (before + behind).norm(), difference = (behind - before).norm();
        if (sum < reversal) {
            inwards = side * behind;
            kept = 0;
        } else {
            inwards = side / sum * (before + behind);
            kept = std::min(1.0, tip_max * sum / difference);
        }
        const double tip = difference / std::max(sum, reversal);
        reach = sizes_max * (1 + tip_max) * (1 + tip) * size;
        fade_along = std::min(size, half_piece);
        fade_across = std::min(size * std::min(tip, tip_max), half_piece);
    }

    bool exists() const { return reach > 0; }
    // Into the plane, as far as the distance from the corner says.
    void slide(const Vec3& place, const Vec3& tangent, Vec3& d) const {
        const double distance = (place - corner).norm();
        if (!exists() || !(distance < std::max(fade_along, fade_across))) return;
        const double k = faded(distance / fade_along), l = faded(distance / fade_across);
        const double along = tangent.dot(d);
        const Vec3 across = (1 - l * (1 - kept)) * (d - along * tangent);
        const double ahead = inwards.dot(tangent);
        const double slid = std::abs(ahead) > parallel ? l * inwards.dot(across) / ahead : 0.0;
        d = across + ((1 - k) * along - slid) * tangent;
    }
    // How far the target's point is from the plane; below 0 the plane has no say.
    double room(const Vec3& place) const {
        if (!exists() || !((place - corner).norm() < reach)) return -1;
        const double away = inwards.dot(place - corner);
        const double exact = rounding * std::max(corner.cwiseAbs().maxCoeff(), place.cwiseAbs().maxCoeff());
        return away < -exact ? -1 : std::max(away, 0.0);
    }
};

// What keeps the displacement on its side of both planes.
void keep_inside(const std::array<CornerSide, 2>& sides, const Vec3& place, const Vec3& tangent, Vec3& d) {
    // It may slide by `least` to `most`.
    double least = -HUGE_VAL, most = HUGE_VAL;
    std::array<double, 2> room;
    for (size_t k = 0; k < 2; ++k) {
        room[k] = sides[k].room(place);
        const double ahead = sides[k].inwards.dot(tangent);
        if (room[k] < 0 || std::abs(ahead) <= parallel) continue;
        const double needed = (-room[k] - sides[k].inwards.dot(d)) / ahead;
        if (ahead > 0) least = std::max(least, needed);
        if (ahead < 0) most = std::min(most, needed);
    }
    const double farthest = tip_max * d.norm();
    if (least <= most) d += std::clamp(std::clamp(0.0, least, most), -farthest, farthest) * tangent;
    double kept = 1;
    for (size_t k = 0; k < 2; ++k) {
        const double towards = -sides[k].inwards.dot(d);
        if (room[k] >= 0 && towards > room[k]) kept = std::min(kept, room[k] / towards);
    }
    d *= kept;
}

class Mitre {
public:
    explicit Mitre(const MitreInput& input) : input_(input) { take_piece(); }

    // Samples come in order.
    void cut(uint32_t sample, const Vec3& place, const Vec3& tangent) {
        while (piece_ + 1 < input_.plan.pieces.size() && sample >= input_.plan.pieces[piece_].end_step) {
            ++piece_;
            take_piece();
        }
        float* position = input_.positions + size_t{3} * sample;
        const Vec3 before = load_vec3(position) - place;
        Vec3 d = before;
        for (const CornerSide& side : sides_) side.slide(place, tangent, d);
        keep_inside(sides_, place, tangent, d);
        if (d == before) return;
        store_vec3(place + d, position);
        if (!input_.displacement) return;
        float* displacement = input_.displacement + size_t{3} * sample;
        store_vec3(load_vec3(displacement) + (d - before) / input_.magnitude, displacement);
    }

private:
    void take_piece() {
        const std::span<const CurvePiece> pieces = input_.plan.pieces;
        const CurvePiece& piece = pieces[piece_];
        const size_t count = pieces.size();
        const bool closed = input_.plan.curve.closed;
        const CurvePiece& before = pieces[(piece_ + count - 1) % count];
        const CurvePiece& next = pieces[(piece_ + 1) % count];
        const double half = 0.5 * piece.metres;
        sides_ = {};
        if (closed || piece_ > 0) {
            sides_[0] = {piece.start, before.tangent_end, piece.tangent_start, 1, input_.size, half};
        }
        if (closed || piece_ + 1 < count) {
            sides_[1] = {next.start, piece.tangent_end, next.tangent_start, -1, input_.size, half};
        }
    }
    MitreInput input_;
    std::array<CornerSide, 2> sides_;
    uint32_t piece_ = 0;
};

}  // namespace

Task<void> mitre_corners(Pace& pace, MitreInput input) {
    if (input.magnitude == 0) co_return;
    Mitre mitre(input);
    FramedSampler sampler(input.plan);
    SampleBlock block;
    for (uint32_t done = 0; done < input.plan.sample_count();) {
        uint32_t units = units_at_once;
        const uint32_t count = sampler.next(block, units);
        for (uint32_t k = 0; k < count; ++k) mitre.cut(done + k, block.position_of(k), block.tangent_of(k));
        done += count;
        co_await pace;
    }
}

}  // namespace flg
