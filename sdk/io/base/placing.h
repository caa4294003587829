// SPDX-License-Identifier: MIT
// Files of things far from their origin: text and doubles hold positions that floats do not. A file is read as it is;
// where most edges are short against the spacing of floats there, it is read again, relative to an origin near its
// middle in whole metres, or near the node that places it.
#pragma once

#include <cmath>
#include <optional>

#include "core/float_precision.h"
#include "core/origin.h"
#include "io/base/memory.h"

namespace flg::io {

// What a reader says about positions besides the floats.
struct Placing {
    Origin origin{};  // that the floats are relative to
    // What the file stores floats relative to, so that no other origin makes them more precise; none: it stores more
    // digits than floats have.
    std::optional<Origin> stored;
};

// How precise a file's edges are as floats: those that are short against the floats' spacing count as lost. Those of no
// length count only if there are no others: honest files have them, too.
class EdgeLoss {
public:
    void add(const float* a, const float* b);
    bool most() const { return lost_ > kept_ || (lost_ + kept_ == 0 && none_ > 0); }

private:
    uint64_t kept_ = 0, lost_ = 0, none_ = 0;
};

// Near the middle of the positions or where they are stored, in whole metres.
Origin origin_near(const Vector<float>& positions, const Placing& placing);

// `read(origin)` reads the file; its edges are visited by `visit(data, add)`.
template <class Read, class Visit>
auto read_placed(const Read& read, const Visit& visit) {
    auto data = read(Origin{});
    EdgeLoss loss;
    visit(data, [&](size_t a, size_t b) { loss.add(&data.positions[3 * a], &data.positions[3 * b]); });
    if (!loss.most()) return data;
    const Origin origin = origin_near(data.positions, data.placing);
    if (origin == Origin{}) return data;
    auto placed = read(origin);
    placed.placing.origin = origin;
    return placed;
}

}  // namespace flg::io
