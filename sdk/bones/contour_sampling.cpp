// SPDX-License-Identifier: MIT
#include "bones/contour_sampling.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"
#include "skeletons/point2.h"

namespace flg {
namespace {

constexpr double max_points = 1 << 24;
constexpr double min_ring_points = 8;
constexpr double min_rest = 0.25;  // of the spacing, from the last point of a stretch to its end

// A ring while it gets even points.
struct EvenRing {
    // Whether the point that an edge begins at is one.
    bool is_corner(uint32_t at) const {
        const auto point = [&](uint32_t i) { return drawn.points[first + i % size]; };
        return std::max(distance(point(at + size - 1), point(at)), distance(point(at), point(at + 1))) >= step;
    }
    // Adds the next point on the edge, or goes on to the next edge. Returns whether there is one.
    bool go_on() {
        const Point2 &a = drawn.points[first + edge], &b = drawn.points[first + (edge + 1) % size];
        const double length = distance(a, b), along = made * step - begin;
        const bool ends_stretch = edge + 1 == size || is_corner(edge + 1);
        if (along <= length - (ends_stretch ? min_rest * step : 0)) {
            out.points.push_back(mix(a, b, std::clamp(along / length, 0.0, 1.0)));
            out.input_points.push_back(drawn.input_points[first + edge]);
            ++made;
            return true;
        }
        begin += length;
        ++edge;
        if (edge < size && is_corner(edge)) begin = 0, made = 0;
        return edge < size;
    }

    const Contour& drawn;
    uint32_t first, size;  // its points
    double step;
    Contour& out;
    uint32_t edge = 0;
    double begin = 0;   // how far from the last corner the edge begins
    uint32_t made = 0;  // since that corner
};

// From the stretch between a and b.
double distance_to_stretch(const Point2& p, const Point2& a, const Point2& b) {
    const double ux = b.x - a.x, uy = b.y - a.y, length2 = ux * ux + uy * uy;
    const double along = length2 > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / length2, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - along * ux, p.y - a.y - along * uy);
}

struct Farthest {
    void offer(uint32_t place, double from) {
        if (from > distance) distance = from, at = place;
    }

    uint32_t at = 0;
    double distance = -1;
};

// Places on a ring that are kept; the end may be beyond the ring's, and begins it anew.
struct Range {
    uint32_t begin, end;
    bool must_split;
};

// A ring, and which of its points are kept.
struct KeptPoints {
    const Point2& operator[](uint32_t at) const { return points[at >= size ? at - size : at]; }
    void keep(uint32_t at) {
        is_kept[at >= size ? at - size : at] = 1;
        ++count;
    }
    Farthest farthest_in(const Range& range, uint32_t at, uint32_t end, Farthest farthest) const {
        const Point2 a = (*this)[range.begin], b = (*this)[range.end];
        for (; at < end; ++at) farthest.offer(at, distance_to_stretch((*this)[at], a, b));
        return farthest;
    }

    const Point2* points;
    uint32_t size;
    uint8_t* is_kept;
    uint32_t count = 0;
};

// Keeps the points farthest from the ranges until none is farther than the tolerance.
Task<void> split(Pace& pace, double tolerance, std::pmr::vector<Range>& ranges, KeptPoints& ring) {
    Slice slice(Cost::some_ns);
    while (!ranges.empty()) {
        const Range range = ranges.back();
        ranges.pop_back();
        Farthest farthest;
        for (Portion part(slice, range.begin + 1, range.end); part.next();) {
            farthest = ring.farthest_in(range, part.begin, part.end, farthest);
            if (part.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
        if (!(farthest.distance > (range.must_split ? 0 : tolerance))) continue;
        ring.keep(farthest.at);
        // The shorter one first: so there are never many.
        ranges.push_back({range.begin, farthest.at, false});
        ranges.push_back({farthest.at, range.end, false});
        Range &before = ranges[ranges.size() - 2], &after = ranges.back();
        if (before.end - before.begin < after.end - after.begin) std::swap(before, after);
    }
}

Task<void> keep_points(Pace& pace, double tolerance, KeptPoints& ring) {
    const uint32_t size = ring.size;
    Point2 middle{};
    co_await each(pace, size, Cost::some_ns, [&](uint32_t i) {
        ring.is_kept[i] = 0;
        middle = {middle.x + ring[i].x / size, middle.y + ring[i].y / size};
    });
    Farthest first, second;
    co_await each(pace, size, Cost::some_ns, [&](uint32_t i) { first.offer(i, distance(ring[i], middle)); });
    const Point2 from = ring[first.at];
    co_await each(pace, size, Cost::some_ns, [&](uint32_t i) { second.offer(i, distance(ring[i], from)); });
    const uint32_t low = std::min(first.at, second.at), high = std::max(first.at, second.at);
    ring.keep(low);
    ring.keep(high);
    std::pmr::vector<Range> ranges(pace.memory());
    // If only those two stay, the halves that go off the line between them must get a third.
    for (uint32_t round = 0; round < 2 && ring.count == 2; ++round) {
        ranges.push_back({low, high, round == 1});
        ranges.push_back({high, low + size, round == 1});
        co_await split(pace, tolerance, ranges, ring);
    }
}

}  // namespace

Task<Contour> even_contour(Pace& pace, const Contour& contour, double spacing) {
    Contour out(pace.memory());
    const auto wanted_of = [spacing](double length) { return std::max(min_ring_points, std::round(length / spacing)); };
    Buffer<double> lengths(contour.ring_count(), pace.memory());
    uint32_t ring = 0;
    double all = 0;
    co_await each(pace, contour.size(), Cost::some_ns, [&](uint32_t i) {
        const uint32_t begin = contour.offsets[ring], end = contour.offsets[ring + 1];
        if (i == begin) lengths[ring] = 0;
        lengths[ring] += distance(contour.points[i == begin ? end - 1 : i - 1], contour.points[i]);
        if (i + 1 == end) all += wanted_of(lengths[ring++]);
    });
    if (all <= max_points) {
        const size_t most = static_cast<size_t>(all) + contour.size();
        out.points.reserve(most);
        out.input_points.reserve(most);
    }
    out.offsets.reserve(contour.offsets.size());
    out.offsets.push_back(0);
    for (ring = 0; ring < contour.ring_count(); ++ring) {
        const double length = lengths[ring], wanted = wanted_of(length);
        if (out.size() + wanted > max_points)
            throw Failure(FLG_ERROR_LIMIT, "contour: points every %g along ring %u, %g long, are more than 2^24",
                          spacing, ring, length);
        const uint32_t first = contour.offsets[ring];
        EvenRing even{contour, first, contour.offsets[ring + 1] - first, length / wanted, out};
        co_await repeat(pace, Cost::tens_of_ns, [&] { return even.go_on(); });
        out.offsets.push_back(out.size());
    }
    co_return out;
}

Task<Contour> simplified_contour(Pace& pace, const Contour& contour, double tolerance) {
    Buffer<uint8_t> is_kept(contour.size(), pace.memory());
    uint32_t count = 0;
    for (uint32_t ring = 0; ring < contour.ring_count(); ++ring) {
        const uint32_t begin = contour.offsets[ring];
        KeptPoints kept{&contour.points[begin], contour.offsets[ring + 1] - begin, &is_kept[begin]};
        co_await keep_points(pace, tolerance, kept);
        count += kept.count;
    }
    Contour out(pace.memory());
    out.points.reserve(count);
    out.input_points.reserve(count);
    out.offsets.reserve(contour.offsets.size());
    co_await each(pace, contour.size(), Cost::some_ns, [&](uint32_t i) {
        if (i == contour.offsets[out.offsets.size()]) out.offsets.push_back(out.size());
        if (is_kept[i] == 0) return;
        out.points.push_back(contour.points[i]);
        out.input_points.push_back(contour.input_points[i]);
    });
    out.offsets.push_back(out.size());
    co_return out;
}

}  // namespace flg
