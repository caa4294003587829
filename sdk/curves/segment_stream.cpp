// SPDX-License-Identifier: MIT
#include "curves/segment_stream.h"

namespace flg {

namespace {

constexpr double corner_cosine = 0.6427876096865394;  // of 50 degrees

}  // namespace

SegmentStream::SegmentStream(const CurveView& curve) : curve_(curve), cursor_(1) {
    end_ = curve.point(0);
    before_ = curve.closed ? curve.count : 0;
    done_ = curve.count < 2;
}

bool SegmentStream::advance() {
    if (before_ > 0) return find_closing_edge();
    if (cursor_ < curve_.count) return read(cursor_++);
    if (curve_.closed) {
        // Around to the first point, and on to the next different one, for the tangent at the first.
        const uint32_t wrapped = cursor_++ - curve_.count;
        const bool made = read(wrapped);
        if (made && wrapped > 0) done_ = true;
        return made;
    }
    done_ = true;
    if (!has_edge_) return false;
    make_segment(Vertex{});
    return true;
}

// Looks back from the closed curve's end for the first point that isn't equal to point 0; one point a call.
bool SegmentStream::find_closing_edge() {
    if (--before_ == 0) {
        done_ = true;  // all points are one
        return false;
    }
    if (curve_.same_point(before_, 0)) return false;
    start_ = curve_.point(before_);
    const Vec3 d = end_ - start_;
    edge_.length = d.norm();
    edge_.direction = d / edge_.length;
    edge_.index = before_;
    has_edge_ = true;
    closing_edge_ = true;
    before_ = 0;
    return false;
}

bool SegmentStream::read(uint32_t index) {
    if (curve_.same_point(index, current_)) {
        current_ = index;
        return false;
    }
    const Vec3 point = curve_.point(index);
    const Vec3 d = point - end_;
    Edge next;
    next.length = d.norm();
    next.direction = d / next.length;
    next.index = current_;
    Vertex vertex;
    bool made = false;
    if (has_edge_) {
        vertex.smooth = edge_.direction.dot(next.direction) >= corner_cosine;
        if (vertex.smooth) {
            vertex.tangent = next.length * edge_.direction + edge_.length * next.direction;
            vertex.tangent *= 1.0 / vertex.tangent.norm();
        }
        made = !closing_edge_;
        if (made) make_segment(vertex);
        closing_edge_ = false;
    }
    has_edge_ = true;
    start_ = end_;
    end_ = point;
    edge_ = next;
    edge_start_ = vertex;
    current_ = index;
    return made;
}

void SegmentStream::make_segment(const Vertex& end) {
    const Vec3& u = edge_.direction;
    const auto mirrored = [&u](const Vec3& tangent) -> Vec3 { return (2.0 * tangent.dot(u)) * u - tangent; };
    Vec3 t0 = u;
    Vec3 t1 = u;
    if (edge_start_.smooth) {
        t0 = edge_start_.tangent;
        t1 = end.smooth ? end.tangent : mirrored(t0);
    } else if (end.smooth) {
        t1 = end.tangent;
        t0 = mirrored(t1);
    }
    segment_ = HermiteSegment(start_, end_, u, edge_.length, t0, t1);
    index_ = edge_.index;
}

}  // namespace flg
