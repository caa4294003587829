// SPDX-License-Identifier: MIT
#include "curves/segment_stream.h"

#include <algorithm>

namespace flg {

namespace {

// Points that one refill looks at, at most: what a long run of equal points costs.
constexpr uint32_t reads_per_refill = 64;

}  // namespace

// Edge 0 of the first block ends at the first point: it is missing on open curves, the last edge on closed ones.
SegmentStream::SegmentStream(const CurveView& curve) : curve_(curve) {
    const Vec3 first = curve.point(0);
    block_.points.set(1, first);
    block_.points.set(0, first);
    block_.directions.set(0, Vec3::UnitX());
    block_.chords[0] = 1;
    indices_[0] = 0;
    kinds_[0] = corner;
    before_ = curve.closed ? curve.count : 0;
    ended_ = curve.count < 2;
}

bool SegmentStream::refill() {
    if (before_ > 0) {
        find_closing_edge();
        return false;
    }
    if (ready_ > 0) {
        // The edge and its vertex that go on.
        block_.points.copy(0, carried_);
        block_.points.copy(1, carried_ + 1);
        block_.directions.copy(0, carried_);
        block_.chords[0] = block_.chords[carried_];
        vertices_.copy(0, carried_);
        kinds_[0] = kinds_[carried_];
        indices_[0] = indices_[carried_];
        next_ = ready_ = 0;
    }
    const uint32_t points = take_edges();
    const bool open_end = !curve_.closed && cursor_ == curve_.count;
    if (points == 0 && !open_end) return false;
    make_vertices(points);
    uint32_t count = points;
    ended_ = open_end || around_;
    if (open_end) {
        kinds_[points + 1] = corner;
        all_smooth_ = false;
        // The last edge, unless there never was one.
        count = points + (has_edge_ || points > 0 ? 1 : 0);
    }
    make_tangents(count);
    block_.measure(count);
    next_ = has_edge_ && !hidden_edge_ ? 0 : 1;
    ready_ = std::max(count, next_);
    carried_ = points;
    has_edge_ = true;
    hidden_edge_ = false;
    if (next_ == ready_) return false;
    current_ = next_++;
    return true;
}

// Looks back from the closed curve's end for the last point that isn't equal to point 0.
void SegmentStream::find_closing_edge() {
    for (uint32_t reads = 0; reads < reads_per_refill; ++reads) {
        if (--before_ == 0) {
            ended_ = true;  // all points are one
            return;
        }
        if (curve_.same_point(before_, 0)) continue;
        block_.points.set(0, curve_.point(before_));
        const Vec3 d = block_.points[1] - block_.points[0];
        block_.chords[0] = d.norm();
        block_.directions.set(0, d / block_.chords[0]);
        has_edge_ = true;
        hidden_edge_ = true;
        before_ = 0;
        return;
    }
}

// The next points and the edges to them, behind edge 0. Mostly no point is repeated, and edges say so.
uint32_t SegmentStream::take_edges() {
    const uint32_t ahead = cursor_ < curve_.count ? std::min(curve_.count - cursor_, SegmentBlock::capacity) : 0;
    if (ahead > 0) {
        block_.load(2, curve_.raw(cursor_), ahead);
        block_.make_edges(ahead);
        const double* chords = block_.chords + 1;
        if (std::find(chords, chords + ahead, 0.0) == chords + ahead) {
            indices_[1] = last_read_;
            for (uint32_t k = 1; k < ahead; ++k) indices_[k + 1] = cursor_ + k - 1;
            cursor_ += ahead;
            last_read_ = cursor_ - 1;
            return ahead;
        }
    }
    const uint32_t points = read_points();
    block_.make_edges(points);
    return points;
}

// Puts the next points that differ from the one before them behind the two of edge 0. A closed curve goes around to its
// first point, and on to the next different one, which is needed for the tangent at the first.
uint32_t SegmentStream::read_points() {
    uint32_t points = 0;
    for (uint32_t reads = 0; reads < reads_per_refill && points < SegmentBlock::capacity && !around_; ++reads) {
        uint32_t index = cursor_;
        if (index >= curve_.count) {
            if (!curve_.closed) break;
            index -= curve_.count;
        }
        ++cursor_;
        if (!curve_.same_point(index, last_read_)) {
            block_.points.set(points + 2, curve_.point(index));
            indices_[points + 1] = last_read_;
            ++points;
            around_ = cursor_ > curve_.count + 1;
        }
        last_read_ = index;
    }
    return points;
}

void SegmentStream::make_vertices(uint32_t points) {
    double min_cosine = 1;
    std::array<double, SegmentBlock::size> cosines;
    block_.make_vertices(points, vertices_, cosines.data());
    if (!has_edge_) cosines[1] = -1;  // an open curve's first point
    for (uint32_t j = 1; j <= points; ++j) {
        kinds_[j] = cosines[j] >= corner_cosine ? smooth : corner;
        min_cosine = std::min(min_cosine, cosines[j]);
    }
    all_smooth_ = min_cosine >= corner_cosine && kinds_[0] == smooth;
}

void SegmentStream::make_tangents(uint32_t count) {
    SegmentBlock::Vectors& a = block_.tangents_start;
    SegmentBlock::Vectors& b = block_.tangents_end;
    std::copy_n(vertices_.x, count, a.x);
    std::copy_n(vertices_.y, count, a.y);
    std::copy_n(vertices_.z, count, a.z);
    std::copy_n(vertices_.x + 1, count, b.x);
    std::copy_n(vertices_.y + 1, count, b.y);
    std::copy_n(vertices_.z + 1, count, b.z);
    if (all_smooth_) return;
    for (uint32_t j = 0; j < count; ++j) {
        if (kinds_[j] == smooth && kinds_[j + 1] == smooth) continue;
        const Vec3 u = block_.directions[j];
        const auto mirrored = [&u](const Vec3& tangent) -> Vec3 { return (2.0 * tangent.dot(u)) * u - tangent; };
        a.set(j, kinds_[j] == smooth ? vertices_[j] : (kinds_[j + 1] == smooth ? mirrored(vertices_[j + 1]) : u));
        b.set(j, kinds_[j + 1] == smooth ? vertices_[j + 1] : (kinds_[j] == smooth ? mirrored(vertices_[j]) : u));
    }
}

}  // namespace flg
