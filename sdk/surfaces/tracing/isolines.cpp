// SPDX-License-Identifier: MIT
#include "surfaces/tracing/isolines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint16_t no_class = 0xffff;  // of values that are not finite

class IsolineTracer {
public:
    IsolineTracer(const Mesh& mesh, std::span<const float> values, std::span<const float> levels,
                  const RegionSet& regions, SurfaceCurves& out, Memory* memory);

    // How many levels a vertex's value reaches.
    void classify(uint32_t vertex);
    // From a triangle on as far as the one behind the next that is crossed, or `end`.
    uint32_t scan(uint32_t triangle, uint32_t end);
    // The segments of that triangle, the one before where the scan has come to.
    bool has_crossing() const { return next_level_ < end_level_; }
    void cross_next_level(uint32_t triangle);
    uint32_t segment_count() const { return static_cast<uint32_t>(segments_.size()); }
    void link(uint32_t segment);
    // Whether a chain begins there, or a loop that was not drawn yet.
    bool begins(uint32_t segment, bool loop) const {
        return !segments_[segment].is_drawn && (loop || !segments_[segment].has_preceding);
    }
    // Returns the segment to draw next; no_index at the curve's end.
    uint32_t draw(uint32_t segment);

private:
    // Where an isoline crosses a triangle: in on the edge at corner `in`, out on the one at `out`.
    struct Crossing {
        uint32_t in, out;        // 0 to 2
        float in_at, out_at;     // on these edges
        bool has_length = true;  // false if both are the same vertex
    };
    struct Segment {
        SurfacePoint start;
        uint32_t following;  // the triangle it leads into, after linking the segment there; no_index if none
        uint16_t level;
        bool has_length;
        bool has_preceding;
        bool is_drawn;
    };
    // For each 64 triangles.
    struct Mark {
        uint64_t crossed;  // bit i: triangle i of them is
        uint32_t before;   // crossed triangles before these
    };
    struct CrossedTriangle {
        uint32_t first_segment;  // one segment a level, rising
        uint16_t lowest_level;
    };

    Crossing crossing(uint32_t triangle, uint32_t level) const;
    void begin_crossing(uint32_t triangle);
    uint32_t segment_at(uint32_t triangle, uint32_t level) const;
    void end_curve(bool closed);

    const Mesh& mesh_;
    std::span<const float> values_;
    std::span<const float> levels_;
    const RegionSet& regions_;
    SurfaceCurves& out_;
    Buffer<uint16_t> classes_;  // of a vertex: how many levels its value reaches
    Buffer<Mark> marks_;
    std::pmr::deque<CrossedTriangle> crossed_;
    std::pmr::deque<Segment> segments_;
    uint16_t band_ = 0;  // the class of values from band_begin_ to below band_end_; none yet
    float band_begin_ = 0, band_end_ = 0;
    uint16_t next_level_ = 0;  // of the triangle that is being crossed
    uint16_t end_level_ = 0;
    uint32_t last_drawn_ = no_index;  // the last one with length of this curve
};

IsolineTracer::IsolineTracer(const Mesh& mesh, std::span<const float> values, std::span<const float> levels,
                             const RegionSet& regions, SurfaceCurves& out, Memory* memory)
    : mesh_(mesh),
      values_(values),
      levels_(levels),
      regions_(regions),
      out_(out),
      classes_(mesh.vertex_count(), memory),
      marks_((size_t{mesh.triangle_count()} + 63) / 64, memory),
      crossed_(memory),
      segments_(memory) {}

void IsolineTracer::classify(uint32_t vertex) {
    const float value = values_[vertex];
    // Mostly the band of the vertex before.
    if (!(band_begin_ <= value && value < band_end_)) {
        if (!std::isfinite(value)) {
            classes_[vertex] = no_class;
            return;
        }
        const auto above = std::upper_bound(levels_.begin(), levels_.end(), value);
        band_ = static_cast<uint16_t>(above - levels_.begin());
        band_begin_ = above == levels_.begin() ? std::numeric_limits<float>::lowest() : *(above - 1);
        band_end_ = above == levels_.end() ? std::numeric_limits<float>::infinity() : *above;
    }
    classes_[vertex] = band_;
}

// The part above, walked around counter-clockwise, goes below the level on the edge `in` and comes back on `out`; the
// segment leads from `in` to `out` and has that part on its left.
IsolineTracer::Crossing IsolineTracer::crossing(uint32_t triangle, uint32_t level) const {
    const Triple& vertices = mesh_.triangles[triangle];
    const auto is_above = [&](uint32_t k) { return classes_[vertices[k % 3]] > level; };
    // The same from both sides of an edge: always reckoned from below.
    const auto height = [&](uint32_t below, uint32_t above) {
        const double low = values_[vertices[below % 3]], high = values_[vertices[above % 3]];
        return round_on_edge((double{levels_[level]} - low) / (high - low));
    };
    Crossing found{};
    for (uint32_t k = 0; k < 3; ++k) {
        if (is_above(k) && !is_above(k + 1)) found.in = k;
        if (!is_above(k) && is_above(k + 1)) found.out = k;
    }
    const float in_height = height(found.in + 1, found.in), out_height = height(found.out, found.out + 1);
    found.in_at = 1 - in_height;
    found.out_at = out_height;
    const bool one_above = (found.out + 1) % 3 == found.in;
    found.has_length = one_above ? in_height != 1 || out_height != 1 : in_height != 0 || out_height != 0;
    return found;
}

void IsolineTracer::begin_crossing(uint32_t triangle) {
    if (!regions_.contains(mesh_.regions[triangle])) return;
    const Triple& vertices = mesh_.triangles[triangle];
    const auto [lowest, highest] = std::minmax({classes_[vertices[0]], classes_[vertices[1]], classes_[vertices[2]]});
    if (highest == no_class) return;
    marks_[triangle / 64].crossed |= uint64_t{1} << triangle % 64;
    crossed_.push_back({static_cast<uint32_t>(segments_.size()), lowest});
    next_level_ = lowest;
    end_level_ = highest;
}

uint32_t IsolineTracer::scan(uint32_t triangle, uint32_t end) {
    while (triangle < end && !has_crossing()) {
        if (triangle % 64 == 0) marks_[triangle / 64] = {0, static_cast<uint32_t>(crossed_.size())};
        const Triple& t = mesh_.triangles[triangle];
        const uint16_t a = classes_[t[0]], b = classes_[t[1]], c = classes_[t[2]];
        if (a != b || b != c) begin_crossing(triangle);
        ++triangle;
    }
    return triangle;
}

void IsolineTracer::cross_next_level(uint32_t triangle) {
    const Crossing c = crossing(triangle, next_level_);
    segments_.push_back({point_on_edge(3 * triangle + c.in, c.in_at), mesh_.neighbours[triangle][c.out], next_level_,
                         c.has_length, false, false});
    ++next_level_;
}

uint32_t IsolineTracer::segment_at(uint32_t triangle, uint32_t level) const {
    if (triangle == no_index) return no_index;
    const Mark& mark = marks_[triangle / 64];
    const uint64_t bit = uint64_t{1} << triangle % 64;
    if ((mark.crossed & bit) == 0) return no_index;
    const CrossedTriangle& found =
        crossed_[mark.before + static_cast<uint32_t>(std::popcount(mark.crossed & (bit - 1)))];
    return found.first_segment + level - found.lowest_level;
}

void IsolineTracer::link(uint32_t index) {
    Segment& segment = segments_[index];
    segment.following = segment_at(segment.following, segment.level);
    if (segment.following != no_index) segments_[segment.following].has_preceding = true;
}

uint32_t IsolineTracer::draw(uint32_t index) {
    Segment& segment = segments_[index];
    segment.is_drawn = true;
    if (segment.has_length) {
        out_.points.push_back(segment.start);
        last_drawn_ = index;
    }
    const uint32_t following = segment.following;
    if (following == no_index) {
        if (last_drawn_ != no_index) {
            const Segment& last = segments_[last_drawn_];
            const Crossing c = crossing(last.start.triangle, last.level);
            out_.points.push_back(point_on_edge(3 * last.start.triangle + c.out, c.out_at));
        }
        end_curve(false);
    } else if (segments_[following].is_drawn) {
        end_curve(true);
        return no_index;
    }
    return following;
}

void IsolineTracer::end_curve(bool closed) {
    const uint32_t first = out_.offsets.back();
    const auto end = static_cast<uint32_t>(out_.points.size());
    if (end - first < (closed ? 3 : 2)) {
        out_.points.resize(first);
    } else {
        out_.offsets.push_back(end);
        out_.closed.push_back(closed);
        out_.values.push_back(levels_[segments_[last_drawn_].level]);
    }
    last_drawn_ = no_index;
}

Task<void> draw_curves(Pace& pace, IsolineTracer& tracer, bool loops) {
    Slice slice(Cost::tens_of_ns);
    for (uint32_t first = 0; first < tracer.segment_count(); ++first) {
        for (uint32_t at = tracer.begins(first, loops) ? first : no_index; at != no_index;) {
            at = tracer.draw(at);
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
}

}  // namespace

Task<void> add_isolines(Pace& pace, const Mesh& mesh, std::span<const float> values, std::span<const float> levels,
                        const RegionSet& regions, SurfaceCurves& out) {
    constexpr uint32_t units_a_segment = 8;
    IsolineTracer tracer(mesh, values, levels, regions, out, pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&tracer](uint32_t v) { tracer.classify(v); });
    Slice slice(Cost::some_ns);
    for (uint32_t at = 0; at < mesh.triangle_count();) {
        const uint32_t begin = at, end = at + std::min(mesh.triangle_count() - at, slice.left());
        at = tracer.scan(begin, end);
        if (slice.is_over(at - begin)) co_await pace;
        while (tracer.has_crossing()) {
            tracer.cross_next_level(at - 1);
            if (slice.is_over(units_a_segment)) co_await pace;
        }
    }
    co_await each(pace, tracer.segment_count(), Cost::tens_of_ns, [&tracer](uint32_t s) { tracer.link(s); });
    co_await draw_curves(pace, tracer, false);
    co_await draw_curves(pace, tracer, true);
}

}  // namespace flg
