// SPDX-License-Identifier: MIT
#include "stylization/mitre.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr double reach_sizes = 2;
constexpr double slide_share = 2.0 / 3;               // of the reach: k falls by 1.5 over it at most
constexpr double longest_sizes = 1.6;                 // of what was longer before, no further
constexpr double room_full = 1, room_none = 1.0 / 3;  // reach in sizes with which corners are mitred, gone through
constexpr double reversal = 1e-6;                     // sum of both sides at a turn that has no plane
constexpr double parallel = 0.05;                     // cosine below which nothing slides into a plane
constexpr uint32_t units_at_once = 200;

// Falls evenly from 1 at 0 to 0 at 1.
double faded(double r) {
    r = std::clamp(r, 0.0, 1.0);
    return 1 - r * r * (3 - 2 * r);
}

// Where a piece leads, at its start and at its end.
struct Directions {
    Vec3 start = Vec3::Zero(), end = Vec3::Zero();
};

// The slope of the line that fits a stretch best, position against arc length: the mean of its directions, each with
// the weight s (window - s).
double slope_weight(double window, double from, double to) {
    const auto sum = [=](double s) { return s * s * (0.5 * window - s / 3); };
    from = std::clamp(from, 0.0, window);
    to = std::clamp(to, 0.0, window);
    return sum(to) - sum(from);
}

double reach_of(double size, const CurvePiece& piece) {
    return std::min(reach_sizes * size, 0.5 * piece.metres);
}

Vec3 unit_or(const Vec3& v, const Vec3& other) {
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : other;
}

Task<void> fit_directions(Pace& pace, const MitreInput& input, std::span<Directions> directions) {
    const std::span<const CurvePiece> pieces = input.plan.pieces;
    size_t p = 0;
    double s = 0;
    Slice slice(Cost::tens_of_ns);
    for (SegmentStream stream(input.plan.curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        const SegmentBlock& block = stream.block();
        for (uint32_t j = range.first; j < range.last; ++j) {
            if (p + 1 < pieces.size() && stream.index_of(j) == pieces[p + 1].first_segment) {
                ++p;
                s = 0;
            }
            const double next = s + block.lengths[j], metres = pieces[p].metres,
                         window = reach_of(input.size, pieces[p]);
            if (s < window) directions[p].start += slope_weight(window, s, next) * block.directions[j];
            if (next > metres - window) {
                directions[p].end += slope_weight(window, metres - next, metres - s) * block.directions[j];
            }
            s = next;
        }
        if (slice.is_over(2 * (range.last - range.first) + 1)) co_await pace;
    }
    co_await each(pace, pieces.size(), Cost::tens_of_ns, [&](uint32_t k) {
        directions[k] = {unit_or(directions[k].start, pieces[k].tangent_start),
                         unit_or(directions[k].end, pieces[k].tangent_end)};
    });
}

// One side of a corner.
class CornerSide {
public:
    CornerSide() = default;
    // The sides lead along `before` and `behind`; `side`: 1 behind the corner, -1 before it. `room`: the shorter reach.
    CornerSide(const Vec3& corner, const Vec3& before, const Vec3& behind, double side, double size, double reach,
               double room)
        : corner_(corner),
          reach_(reach),
          slide_max_(slide_share * room),
          longest_(longest_sizes * size),
          strength_(1 - faded((room / size - room_none) / (room_full - room_none))) {
        const double sum = (before + behind).norm(), difference = (behind - before).norm();
        if (sum < reversal) {
            inwards_ = side * behind;
            ahead_ = 1;
            kept_ = slide_max_ = 0;
        } else {
            const double cotangent = sum / difference;  // of half the turn
            inwards_ = side / sum * (before + behind);
            ahead_ = 0.5 * sum;
            slide_max_ *= std::min(cotangent, 1.0);
            kept_ = std::min(1.0, slide_max_ / size * cotangent);
        }
    }

    // A point's displacement as the corner leaves it. `along`: metres of the target from the corner.
    Vec3 cut(const Vec3& place, const Vec3& tangent, double along, const Vec3& before) const {
        const double distance = std::max(along, (place - corner_).norm());
        if (strength_ == 0 || !(distance < reach_)) return before;
        const double k = faded(distance / reach_), forth = tangent.dot(before);
        Vec3 across = (1 - k * (1 - kept_)) * (before - forth * tangent);
        const double ahead = inwards_.dot(tangent);
        if (std::abs(ahead) > parallel) {
            const double slid = inwards_.dot(across) / ahead, share = std::min(slide_max_ / std::abs(slid), 1.0);
            across *= 1 - k * (1 - share);
            across -= k * share * slid * tangent;
        }
        Vec3 d = across + (1 - k) * forth * tangent;
        d *= 1 - faded(2 * distance / reach_ - 1) * (1 - kept_inside(place, distance, d));
        d = before + strength_ * (d - before);
        const double most = std::max(longest_, before.norm()), length = d.norm();
        return length > most ? Vec3(most / length * d) : d;
    }

private:
    // The share of it that is on this side of the plane. A side that wavers across the plane has room all the same.
    double kept_inside(const Vec3& place, double distance, const Vec3& d) const {
        const double room = std::max(inwards_.dot(place - corner_), 0.5 * distance * ahead_);
        const double towards = -inwards_.dot(d);
        return towards > room ? room / towards : 1.0;
    }

    Vec3 corner_ = Vec3::Zero();
    Vec3 inwards_ = Vec3::Zero();  // across the plane, to where the piece is
    double ahead_ = 0;             // cosine of the angle between them and the side
    double reach_ = 0;             // metres: how far the plane matters
    double slide_max_ = 0;         // metres
    double longest_ = 0;           // metres, of the displacement
    double strength_ = 0;          // 0: there is no corner, or it is gone through
    double kept_ = 1;              // share of the displacement that long tips leave
};

class Mitre {
public:
    Mitre(const MitreInput& input, std::span<const Directions> directions) : input_(input), directions_(directions) {
        take_piece();
    }

    // Samples come in order.
    void cut(uint32_t sample, const Vec3& place, const Vec3& tangent) {
        while (piece_ + 1 < input_.plan.pieces.size() && sample >= input_.plan.pieces[piece_].end_step) {
            ++piece_;
            take_piece();
        }
        float* position = input_.positions + size_t{3} * sample;
        const Vec3 before = load_vec3(position) - place;
        const double share = (sample - first_) * share_per_step_;
        const Vec3 d = sides_[1].cut(place, tangent, (1 - share) * metres_,
                                     sides_[0].cut(place, tangent, share * metres_, before));
        if (d == before) return;
        store_vec3(place + d, position);
        if (!input_.displacement) return;
        float* displacement = input_.displacement + size_t{3} * sample;
        store_vec3(load_vec3(displacement) + (d - before) / input_.magnitude, displacement);
    }

private:
    // Between piece `p` and the next one.
    CornerSide corner_behind(size_t p, double side) const {
        const std::span<const CurvePiece> pieces = input_.plan.pieces;
        const size_t next = (p + 1) % pieces.size();
        const float across = input_.across.empty() ? 1.0f : std::min(input_.across[p], input_.across[next]);
        const double size = across * input_.size;
        const double before = reach_of(size, pieces[p]), behind = reach_of(size, pieces[next]);
        return {pieces[next].start,         directions_[p].end,      directions_[next].start, side, size,
                side > 0 ? behind : before, std::min(before, behind)};
    }
    void take_piece() {
        const std::span<const CurvePiece> pieces = input_.plan.pieces;
        const CurvePiece& piece = pieces[piece_];
        const size_t count = pieces.size();
        const bool closed = input_.plan.curve.closed;
        first_ = piece_ > 0 ? pieces[piece_ - 1].end_step : 0;
        share_per_step_ = 1.0 / (piece.end_step - first_);
        // Where steps are of several lengths, samples say nothing of the way: the straight one counts.
        metres_ = input_.plan.step_scales ? 0.0 : piece.metres;
        sides_ = {};
        if (closed || piece_ > 0) sides_[0] = corner_behind((piece_ + count - 1) % count, 1);
        if (closed || piece_ + 1 < count) sides_[1] = corner_behind(piece_, -1);
    }

    const MitreInput& input_;
    std::span<const Directions> directions_;
    std::array<CornerSide, 2> sides_;
    uint32_t piece_ = 0;
    uint32_t first_ = 0;  // sample of the piece
    double share_per_step_ = 0, metres_ = 0;
};

}  // namespace

Task<void> mitre_corners(Pace& pace, MitreInput input) {
    if (input.magnitude == 0 || input.size == 0) co_return;
    Buffer<Directions> directions(input.plan.pieces.size(), pace.memory());
    const std::span<Directions> all(directions.data(), directions.size());
    co_await each(pace, directions.size(), Cost::some_ns, [&](uint32_t p) { std::construct_at(&directions[p]); });
    co_await fit_directions(pace, input, all);
    Mitre mitre(input, all);
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
