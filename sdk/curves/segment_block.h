// SPDX-License-Identifier: MIT
// Cubics of the smooth curve through a polyline's points, with their arc lengths, a block at a time.
//
// The derivative's size at both ends is m = 2 chord / (1 + cos a), a being the angle between tangent and chord: with it
// a cubic follows a circular arc to fourth order (m = 4 R tan(turn / 4)); with tangents along the chord it is the
// chord's length, and the segment is straight and run through evenly. Arc length is Gauss-Legendre quadrature with
// three points. The two end derivatives being equally long, their sum and difference are at right angles, and the three
// speeds follow from three dot products. A block is structure of arrays, so that compilers vectorize its making, and
// the roots and divisions of one segment do not wait for those of another. Coordinates and chords are in double, since
// coordinates of 1e30 give squares of 1e60; what is relative to the chord is in single precision.
#pragma once

#include <cmath>

#include "core/vec.h"

namespace flg {

struct SegmentBlock {
    static constexpr uint32_t capacity = 32;
    static constexpr uint32_t size = capacity + 2;  // with a segment carried over, and one more point

    struct Vectors {
        double x[size], y[size], z[size];

        Vec3 operator[](size_t i) const { return Vec3(x[i], y[i], z[i]); }
        void set(size_t i, const Vec3& v) {
            x[i] = v.x();
            y[i] = v.y();
            z[i] = v.z();
        }
        void copy(size_t to, size_t from) {
            x[to] = x[from];
            y[to] = y[from];
            z[to] = z[from];
        }
    };

    // Set by the stream: segment j runs from points[j] to points[j + 1] along the unit directions[j] for chords[j].
    Vectors points, directions, tangents_start, tangents_end;
    double chords[size];
    // Set by measure().
    double lengths[size];
    float magnitudes[size];  // of the derivative at both ends, in units of the chord
    float speeds_low[size], speeds_middle[size], speeds_high[size];  // at the Gauss points, likewise

    // Takes points from number `first` on, which lie tightly packed.
    void load(uint32_t first, const float* positions, uint32_t count);
    // Of the edges 1 to `points`, whose ends are known: directions and chords.
    void make_edges(uint32_t points);
    // Where edges 1 to `points` begin: the curve's tangent, and the cosine of the angle between the edges there.
    void make_vertices(uint32_t points, Vectors& tangents, double* cosines) const;
    void measure(uint32_t count);

    // How far segments are from a point of the curve.
    struct Deviations {
        double moments[3][size];  // twice the middle's deviation times the length
        double across_sq[size];   // of the end, from the line along the tangent
        float largest;            // coordinate in size
    };
    void deviate(uint32_t first, uint32_t last, const Vec3& from, const Vec3& tangent, Deviations& out) const;
};

// One of a block, valid as long as the block isn't refilled.
class Segment {
public:
    Segment(const SegmentBlock& block, uint32_t j) : b_(&block), j_(j) {}

    Vec3 start() const { return b_->points[j_]; }
    Vec3 end() const { return b_->points[j_ + 1]; }
    Vec3 tangent_start() const { return b_->tangents_start[j_]; }
    Vec3 tangent_end() const { return b_->tangents_end[j_]; }
    double length() const { return b_->lengths[j_]; }

private:
    const SegmentBlock* b_;
    uint32_t j_;
};

constexpr double gauss_offset = 0.3872983346207417;  // sqrt(15) / 10: of the outer Gauss points from the middle

}  // namespace flg
