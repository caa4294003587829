// SPDX-License-Identifier: MIT
// Ribbons and tubes along curves, as triangles: how many, and what they are. Compiled into filigree and into
// filigree_io alike, which does not link it: nothing here allocates, throws, or knows a context.
#pragma once

#include <cstdint>

#include "brush/brush_curve.h"
#include "brush/cross_section.h"
#include "brush/library.h"
#include "brush/row_writer.h"
#include "brush/section_walk.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

struct Counts {
    uint64_t vertices = 0, indices = 0;
};

// A growing curve, without its last point, which is written anew when it is known where the curve goes on from there.
struct Growth {
    WalkPlace walk;
    FramePlace frame;
    Counts before;  // what stays as it is
};

// Sections of one curve to rows, caps and the triangles between them.
class Sweep {
public:
    Sweep(const Style& style, const CrossSection& section, const Output& output);

    // Before the first section. `length`: what texture coordinates from 0 to 1 are measured by. With `continues`, a row
    // was written right before.
    void begin(bool closed, double length, bool continues);
    void add(const Section* sections, uint32_t count);
    // After the last one.
    void end();
    // Written since the sweep was made.
    Counts written() const { return {writer_.vertex_count(), writer_.index_count()}; }

private:
    Row row_of(const Section& section) const;
    void add_cap(const Section& section, const CapProfile& profile, bool back);
    double coordinate(double along) const;

    const Style& style_;
    const CrossSection& section_;
    RowWriter writer_;
    bool closed_ = false, begun_ = false;
    double length_ = 1;
    int64_t previous_ = 0, first_ = 0;
    Section first_section_, last_section_;
};

// As few sides as keep a round tube within `tolerance` metres, up to style.sides.
uint32_t sides_within(double radius, double tolerance, uint32_t most);
float widest_radius(const Curve& curve);

// What `rows` rows of a curve take, with caps and what is between them. `continues`: a row was written right before,
// and no cap at the start.
Counts counts_of(const Style& style, uint64_t rows, bool closed, bool continues, float start_radius, float end_radius);

// What write() writes of a curve. `growth` is null for a whole curve.
Counts count(const Curve& curve, const Style& style, const Growth* growth);
// `growth`, if not null, becomes what the next call goes on from. Sizes fit; a curve with growth is open. Returns what
// was written.
Counts write(const Curve& curve, const Style& style, const Output& output, Growth* growth);
// Behind what was written.
void advance(Output& output, const Counts& written);

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
