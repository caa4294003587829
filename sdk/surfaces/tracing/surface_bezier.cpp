// SPDX-License-Identifier: MIT
#include "surfaces/tracing/surface_bezier.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/each.h"
#include "surfaces/tracing/geodesic_path.h"
#include "surfaces/tracing/straight_walk.h"
#include "surfaces/tracing/surface_path.h"
#include "surfaces/tracing/surface_walk.h"

namespace flg {

namespace {

constexpr double max_detour = 1.5;  // of a way in a plane, over the chord
constexpr size_t min_walked = 6;    // points of a way

bool is_same(const SurfacePoint& a, const SurfacePoint& b) {
    return a.triangle == b.triangle && a.u == b.u && a.v == b.v;
}

// The control polygon of a segment, or of a part of it.
struct Polygon {
    std::array<PathPart, 3> sides;
};

// Handles of a segment's ends, as paths to them from the point and back.
struct Handle {
    explicit Handle(Memory* memory) : out(memory), back(memory) {}
    SurfacePath out, back;
};

class BezierMaker {
public:
    BezierMaker(const Mesh& mesh, const SurfaceBezier* before, SurfaceBezier& out, Memory* memory)
        : mesh_(mesh),
          before_(before),
          out_(out),
          regions_(memory),
          shortener_(mesh, regions_, memory),
          way_(memory),
          walked_(memory),
          drawn_(memory),
          frame_(memory),
          reversed_(memory),
          between_(memory),
          handles_{Handle(memory), Handle(memory)} {
        for (SurfaceCurves* curves : {&way_, &walked_}) curves->closed.push_back(false);
        for (Straight& slot : straights_) slot.path.emplace(memory);
        for (auto& level : levels_) {
            for (auto& path : level) path.emplace(memory);
        }
    }

    friend Task<BezierResult> make_all(Pace& pace, BezierMaker& m);

private:
    // A shortest path from a given point to the next.
    struct Straight {
        uint32_t segment = no_index;
        std::optional<SurfacePath> path;
    };

    static Task<bool> shorten(Pace& pace, BezierMaker& m, SurfacePath& out);
    static Task<bool> connect(Pace& pace, BezierMaker& m, SurfacePoint from, SurfacePoint to, const SurfaceCurves* way,
                              SurfacePath& out);
    static Task<const SurfacePath*> straight(Pace& pace, BezierMaker& m, uint32_t segment);
    static Task<bool> find_handle(Pace& pace, BezierMaker& m, uint32_t point, bool forward, Handle& out);
    static Task<bool> find_polygon(Pace& pace, BezierMaker& m, uint32_t segment, Polygon& out);
    static Task<bool> halve(Pace& pace, BezierMaker& m, Polygon polygon, uint32_t level);

    void begin_way() {
        way_.points.clear();
        way_length_ = 0;
    }
    void append(const PathPart& part) {
        append_part(mesh_, part, way_);
        way_length_ += part.length();
    }
    uint32_t count() const { return static_cast<uint32_t>(out_.given.size()); }
    uint32_t wrapped(uint32_t point) const { return point % count(); }
    bool copies(uint32_t segment) const;

    const Mesh& mesh_;
    const SurfaceBezier* before_;
    SurfaceBezier& out_;
    RegionSet regions_;
    PathShortener shortener_;
    SurfaceCurves way_, walked_, drawn_;
    double way_length_ = 0;
    DirectionFrame frame_;
    SurfacePath reversed_, between_;
    Handle handles_[2];
    std::array<Straight, 4> straights_;
    std::array<std::array<std::optional<SurfacePath>, 3>, max_bezier_halvings> levels_;
};

// The shortest path near the way. Where the way in the plane through both ends is shorter it begins there: to cut a
// corner off takes a round for each row of triangles.
Task<bool> BezierMaker::shorten(Pace& pace, BezierMaker& m, SurfacePath& out) {
    const SurfacePoint from = m.way_.points.front(), to = m.way_.points.back();
    bool is_walked = false;
    if (m.way_.points.size() > min_walked) {
        m.walked_.points.clear();
        const SurfaceWalk walk = co_await add_surface_walk(pace, m.mesh_, from, to, m.walked_);
        is_walked = walk.found && !m.walked_.points.empty() && walk.length <= m.way_length_;
    }
    co_return co_await connect(pace, m, from, to, is_walked ? &m.walked_ : &m.way_, out);
}

// Along a way or, if that is null, the shortest strip.
Task<bool> BezierMaker::connect(Pace& pace, BezierMaker& m, SurfacePoint from, SurfacePoint to,
                                const SurfaceCurves* way, SurfacePath& out) {
    m.drawn_.points.clear();
    const GeodesicPath path = co_await shorten_way(pace, m.shortener_, from, to, way, m.drawn_);
    if (!path.found) co_return false;
    out.clear();
    if (m.drawn_.points.empty()) out.add(m.mesh_, from);
    Slice slice(Cost::tens_of_ns);
    for (const SurfacePoint& point : m.drawn_.points) {
        out.add(m.mesh_, point);
        if (slice.is_over()) co_await pace;
    }
    co_return true;
}

// From the way in the plane through both points unless that is a detour: it takes as long as its triangles, and the
// search for a shortest strip as long as all those between.
Task<const SurfacePath*> BezierMaker::straight(Pace& pace, BezierMaker& m, uint32_t segment) {
    Straight& slot = m.straights_[segment % m.straights_.size()];
    if (slot.segment == segment) co_return &*slot.path;
    slot.segment = no_index;
    const SurfacePoint from = m.out_.given[segment], to = m.out_.given[m.wrapped(segment + 1)];
    const double chord = (position_of(m.mesh_, to) - position_of(m.mesh_, from)).norm();
    m.walked_.points.clear();
    const SurfaceWalk walk = co_await add_surface_walk(pace, m.mesh_, from, to, m.walked_);
    const bool is_near = walk.found && !m.walked_.points.empty() && walk.length <= max_detour * chord;
    const bool found = co_await connect(pace, m, from, to, is_near ? &m.walked_ : nullptr, *slot.path);
    if (!found) co_return nullptr;
    slot.segment = segment;
    co_return &*slot.path;
}

// Of a point between two segments: along the tangent, a third of the segment's length away.
Task<bool> BezierMaker::find_handle(Pace& pace, BezierMaker& m, uint32_t point, bool forward, Handle& out) {
    const uint32_t before = point > 0 ? point - 1 : m.count() - 1;
    const SurfacePath* const last = co_await straight(pace, m, before);
    if (!last) co_return false;
    reverse_path(m.mesh_, *last, m.reversed_);
    const SurfacePath* const next = co_await straight(pace, m, point);
    if (!next) co_return false;
    const double d0 = m.reversed_.length(), d1 = next->length(), own = forward ? d1 : d0;
    uint32_t to_last = 0, to_next = 0;
    const Vec3 back = first_way(m.mesh_, m.reversed_, to_last), ahead = first_way(m.mesh_, *next, to_next);
    co_await set_frame(pace, m.frame_, m.mesh_, place_in(m.mesh_, m.out_.given[point]));
    out.out.clear();
    if (m.frame_.is_valid() && !back.isZero(0) && !ahead.isZero(0)) {
        const double behind = m.frame_.angle_of(to_last, back), front = m.frame_.angle_of(to_next, ahead);
        const double x = d0 * std::cos(front) - d1 * std::cos(behind), y = d0 * std::sin(front) - d1 * std::sin(behind);
        const double speed = std::hypot(x, y) / (d0 + d1);
        const double angle = m.frame_.half_tangent(std::atan2(y, x), forward);
        co_await walk_straight(pace, m.mesh_, m.frame_.ray(m.mesh_, angle), speed * own / 3, out.out);
    } else {
        out.out.add(m.mesh_, m.out_.given[point]);
    }
    reverse_path(m.mesh_, out.out, out.back);
    co_return true;
}

Task<bool> BezierMaker::find_polygon(Pace& pace, BezierMaker& m, uint32_t segment, Polygon& out) {
    const bool is_first = !m.out_.closed && segment == 0, is_last = !m.out_.closed && segment + 2 == m.count();
    const uint32_t end = m.wrapped(segment + 1);
    const SurfacePath* path = co_await straight(pace, m, segment);
    if (!path) co_return false;
    if (is_first && is_last) {
        const double third = path->length() / 3;
        out.sides = {PathPart{path, 0, third}, {path, third, 2 * third}, {path, 2 * third, path->length()}};
        co_return true;
    }
    Handle &leaving = m.handles_[0], &arriving = m.handles_[1];
    if (!is_first) {
        const bool found = co_await find_handle(pace, m, segment, true, leaving);
        if (!found) co_return false;
    }
    if (!is_last) {
        const bool found = co_await find_handle(pace, m, end, false, arriving);
        if (!found) co_return false;
    }
    path = co_await straight(pace, m, segment);
    if (!path) co_return false;
    m.begin_way();
    if (!is_first) m.append(whole(leaving.back));
    m.append(whole(*path));
    if (!is_last) m.append(whole(arriving.out));
    const bool found = co_await shorten(pace, m, m.between_);
    if (!found) co_return false;
    // The free handle of a natural end is in the middle.
    const PathPart between = whole(m.between_);
    if (is_first) {
        out.sides = {between.half(false), between.half(true), whole(arriving.back)};
    } else if (is_last) {
        out.sides = {whole(leaving.out), between.half(false), between.half(true)};
    } else {
        out.sides = {whole(leaving.out), between, whole(arriving.back)};
    }
    co_return true;
}

// Appends the nodes within a part of a segment.
Task<bool> BezierMaker::halve(Pace& pace, BezierMaker& m, Polygon polygon, uint32_t level) {
    if (level == m.out_.halvings) co_return true;
    auto& own = m.levels_[level];
    const auto across = [&](const PathPart& first, const PathPart& second, SurfacePath& out) {
        m.begin_way();
        m.append(first.half(true));
        m.append(second.half(false));
        return shorten(pace, m, out);
    };
    const auto& sides = polygon.sides;
    bool found = co_await across(sides[0], sides[1], *own[0]);
    if (found) found = co_await across(sides[1], sides[2], *own[1]);
    if (found) found = co_await across(whole(*own[0]), whole(*own[1]), *own[2]);
    if (!found) co_return false;
    const PathPart first = whole(*own[0]), second = whole(*own[1]), top = whole(*own[2]);
    found = co_await halve(pace, m, {{sides[0].half(false), first.half(false), top.half(false)}}, level + 1);
    if (!found) co_return false;
    m.out_.nodes.push_back(last_point(m.mesh_, top.half(false)));
    co_return co_await halve(pace, m, {{top.half(true), second.half(true), sides[2].half(true)}}, level + 1);
}

// Whether a segment is as it was.
bool BezierMaker::copies(uint32_t segment) const {
    if (!before_ || before_->closed != out_.closed || before_->halvings != out_.halvings ||
        before_->given.size() != out_.given.size())
        return false;
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t point = segment + k;  // one more than it is
        if (!out_.closed && (point == 0 || point > count())) continue;
        const uint32_t i = wrapped(point + count() - 1);
        if (!is_same(before_->given[i], out_.given[i])) return false;
    }
    return true;
}

Task<BezierResult> make_all(Pace& pace, BezierMaker& m) {
    const uint32_t segments = m.out_.segments(), intervals = 1u << m.out_.halvings;
    m.out_.nodes.clear();
    m.out_.nodes.reserve(size_t{segments} * intervals + 1);
    for (uint32_t s = 0; s < segments; ++s) {
        if (m.copies(s)) {
            const auto begin = m.before_->nodes.begin() + static_cast<std::ptrdiff_t>(size_t{s} * intervals);
            m.out_.nodes.insert(m.out_.nodes.end(), begin, begin + intervals);
            co_await pace;
            continue;
        }
        m.out_.nodes.push_back(m.out_.given[s]);
        Polygon polygon;
        bool found = co_await BezierMaker::find_polygon(pace, m, s, polygon);
        if (found) found = co_await BezierMaker::halve(pace, m, polygon, 0);
        if (!found) co_return BezierResult{false, s};
    }
    if (!m.out_.closed) m.out_.nodes.push_back(m.out_.given.back());
    co_return BezierResult{true, 0};
}

}  // namespace

Task<BezierResult> make_surface_bezier(Pace& pace, const Mesh& mesh, const SurfaceBezier* before, SurfaceBezier& out) {
    BezierMaker maker(mesh, before, out, pace.memory());
    co_return co_await make_all(pace, maker);
}

}  // namespace flg
