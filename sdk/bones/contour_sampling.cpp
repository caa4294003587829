// SPDX-License-Identifier: MIT
#include "bones/contour_sampling.h"

#include <algorithm>
#include <cmath>

#include "skeletons/plane.h"

namespace flg {
namespace {

constexpr double most_points = 1 << 24;
constexpr double fewest_points = 8;
constexpr uint32_t batch = 16;
constexpr double least_rest = 0.25;  // of the spacing, from the last point of a stretch to its end

// From the stretch between a and b.
double distance_to_stretch(const Point2& p, const Point2& a, const Point2& b) {
    const double ux = b.x - a.x, uy = b.y - a.y, length2 = ux * ux + uy * uy;
    const double along = length2 > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / length2, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - along * ux, p.y - a.y - along * uy);
}

}  // namespace

bool RingLength::run(uint32_t count) {
    for (; count > 0 && at_ < end_; --count, before_ = at_++)
        length_ += distance(contour_->points[before_], contour_->points[at_]);
    return at_ == end_;
}

EvenContour::EvenContour(const Contour& contour, double spacing, Contour& out)
    : contour_(contour), spacing_(spacing), out_(out), length_(contour, 0) {
    out_.offsets.push_back(0);
}

void EvenContour::begin_points() {
    const double wanted = std::max(fewest_points, std::round(length_.length() / spacing_));
    if (out_.size() + wanted > most_points)
        throw Failure(FLG_ERROR_LIMIT, "contour: points every %g along ring %u, %g long, are more than 2^24", spacing_,
                      ring_, length_.length());
    wanted_ = static_cast<uint32_t>(wanted);
    step_ = length_.length() / wanted;
    edge_ = made_ = 0;
    begin_ = 0;
}

bool EvenContour::run(uint32_t count) {
    for (; ring_ < contour_.ring_count(); --count) {
        if (count == 0) return false;
        if (wanted_ == 0) {
            if (length_.run(batch)) begin_points();
            continue;
        }
        add_point();
        if (edge_ < contour_.offsets[ring_ + 1] - contour_.offsets[ring_]) continue;
        out_.offsets.push_back(out_.size());
        wanted_ = 0;
        if (++ring_ < contour_.ring_count()) length_ = RingLength(contour_, ring_);
    }
    return true;
}

// Whether the point that an edge begins at is one.
bool EvenContour::is_corner(uint32_t edge) const {
    const uint32_t first = contour_.offsets[ring_], size = contour_.offsets[ring_ + 1] - first;
    const auto point = [&](uint32_t i) { return contour_.points[first + i % size]; };
    return std::max(distance(point(edge + size - 1), point(edge)), distance(point(edge), point(edge + 1))) >= step_;
}

// The next point on the edge, or on to the next edge.
void EvenContour::add_point() {
    const uint32_t first = contour_.offsets[ring_], size = contour_.offsets[ring_ + 1] - first;
    const Point2 &a = contour_.points[first + edge_], &b = contour_.points[first + (edge_ + 1) % size];
    const double length = distance(a, b), along = made_ * step_ - begin_;
    const bool ends_stretch = edge_ + 1 == size || is_corner(edge_ + 1);
    if (along <= length - (ends_stretch ? least_rest * step_ : 0)) {
        out_.points.push_back(mix(a, b, std::clamp(along / length, 0.0, 1.0)));
        out_.input_points.push_back(contour_.input_points[first + edge_]);
        ++made_;
        return;
    }
    begin_ += length;
    ++edge_;
    if (edge_ < size && is_corner(edge_)) begin_ = 0, made_ = 0;
}

SimplifiedContour::SimplifiedContour(const Contour& contour, double tolerance, Contour& out, Memory* memory)
    : contour_(contour), tolerance_(tolerance), out_(out), kept_(contour.size(), false, memory), ranges_(memory) {
    begin_ring();
}

void SimplifiedContour::begin_ring() {
    out_.offsets.push_back(out_.size());
    if (ring_ == contour_.ring_count()) return enter(Pass::done);
    begin_ = contour_.offsets[ring_];
    size_ = contour_.offsets[ring_ + 1] - begin_;
    sum_ = {};
    enter(Pass::middle);
}

bool SimplifiedContour::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void SimplifiedContour::step() {
    const uint32_t end = std::min(at_ + batch, size_);
    switch (pass_) {
        case Pass::middle:
            for (; at_ < end; ++at_) sum_ = {sum_.x + point(at_).x / size_, sum_.y + point(at_).y / size_};
            if (at_ < size_) return;
            from_ = sum_;
            return enter(Pass::first);
        case Pass::first:
            for (; at_ < end; ++at_) look(at_, distance(point(at_), from_));
            if (at_ < size_) return;
            first_ = farthest_;
            from_ = point(first_);
            return enter(Pass::second);
        case Pass::second: {
            for (; at_ < end; ++at_) look(at_, distance(point(at_), from_));
            if (at_ < size_) return;
            const uint32_t low = std::min(first_, farthest_), high = std::max(first_, farthest_);
            kept_[place(low)] = kept_[place(high)] = true;
            ranges_.push_back({low, high, false});
            ranges_.push_back({high, low + size_, false});
            enter(Pass::scan);
            at_ = high + 1;
            return;
        }
        case Pass::scan: return scan(at_ + batch);
        case Pass::collect:
            for (; at_ < end; ++at_) {
                if (!kept_[begin_ + at_]) continue;
                out_.points.push_back(contour_.points[begin_ + at_]);
                out_.input_points.push_back(contour_.input_points[begin_ + at_]);
            }
            if (at_ < size_) return;
            ++ring_;
            return begin_ring();
        case Pass::done: return;
    }
}

void SimplifiedContour::scan(uint32_t end) {
    const Range& range = ranges_.back();
    const Point2 &a = point(range.begin), &b = point(range.end);
    for (; at_ < std::min(end, range.end); ++at_) look(at_, distance_to_stretch(point(at_), a, b));
    if (at_ >= range.end) end_range();
}

void SimplifiedContour::end_range() {
    const Range range = ranges_.back();
    ranges_.pop_back();
    if (most_ > (range.must_split ? 0 : tolerance_)) {
        kept_[place(farthest_)] = true;
        ranges_.push_back({range.begin, farthest_, false});
        ranges_.push_back({farthest_, range.end, false});
    }
    if (ranges_.empty()) {
        uint32_t kept = 0;
        for (uint32_t i = 0; i < size_ && kept < 3; ++i) kept += kept_[begin_ + i];
        if (kept >= 3) return enter(Pass::collect);
        // Two points: the half that goes farther from the line between them gets a third.
        const uint32_t low = std::min(range.begin % size_, range.end % size_);
        const uint32_t high = std::max(range.begin % size_, range.end % size_);
        ranges_.push_back({low, high, true});
        ranges_.push_back({high, low + size_, true});
    }
    const uint32_t begin = ranges_.back().begin;
    enter(Pass::scan);
    at_ = begin + 1;
}

}  // namespace flg
