// SPDX-License-Identifier: MIT
#include "splines/spline_pieces.h"

#include <algorithm>
#include <deque>

namespace flg {

namespace {

// From a given point to another; beyond the last point of a closed curve they are counted on.
struct Piece {
    uint32_t from, to;
    const SplineHandle *begin, *end;  // or null: an end of an open curve
};

std::pmr::vector<Piece> pieces_of(const SplineRequest& request, uint32_t count, Memory* memory) {
    std::pmr::vector<Piece> pieces(memory);
    pieces.reserve(request.handles.size() + 1);
    const auto& handles = request.handles;
    const bool closed = request.problem.closed;
    uint32_t from = 0;
    const SplineHandle* begin = nullptr;
    size_t next = 0;
    if (closed || handles[0].point == 0) {
        begin = &handles[0];
        from = begin->point;
        next = 1;
    }
    for (; next < handles.size(); ++next) {
        pieces.push_back({from, handles[next].point, begin, &handles[next]});
        from = handles[next].point;
        begin = &handles[next];
    }
    if (closed) {
        pieces.push_back({from, handles[0].point + count, begin, &handles[0]});
    } else if (from + 1 < count) {
        pieces.push_back({from, count - 1, begin, nullptr});
    }
    return pieces;
}

// What the pieces come to, in a row: all nodes of each but its last.
struct Joined {
    explicit Joined(Memory* memory)
        : points(memory), hints(memory), nodes(memory), steps(memory), normals(memory), knots(memory), held(memory) {}

    // Deques grow without moving what is there.
    std::pmr::deque<double> points, hints, nodes, steps;
    std::pmr::deque<float> normals;
    std::pmr::deque<uint32_t> knots, held;
    uint32_t count = 0;
};

class PieceSplitter {
public:
    explicit PieceSplitter(const SplineProblem& whole)
        : whole_(whole),
          n_(whole.manifold->ambient()),
          count_(static_cast<uint32_t>(whole.knots.size())),
          nodes_(static_cast<uint32_t>(whole.points.size() / n_)) {}

    uint32_t node_at(uint32_t point) const {
        return point < count_ ? whole_.knots[point] : nodes_ + whole_.knots[point - count_];
    }
    double parameter_at(uint32_t point) const {
        const Buffer<double>& values = whole_.parameters;
        return point < count_ ? values[point] : values[count_] - values[0] + values[point - count_];
    }
    uint32_t count() const { return count_; }

    static Task<void> split(Pace& pace, const PieceSplitter& s, const Piece& piece, SplineProblem& out);

private:
    void set_slope(const Piece& piece, bool last, SplineProblem& out) const {
        const SplineHandle* const handle = last ? piece.end : piece.begin;
        if (!handle) {
            out.has_slope[last] = whole_.has_slope[last];
            std::copy_n(whole_.slopes[last], n_, out.slopes[last]);
        } else if (handle->has_slope) {
            out.has_slope[last] = true;
            std::copy_n(handle->slope, n_, out.slopes[last]);
        }
    }
    double softness_at(uint32_t point) const {
        return whole_.softness.size() > 0 ? whole_.softness[point % count_] : whole_.smoothing;
    }

    const SplineProblem& whole_;
    uint32_t n_, count_, nodes_;
};

Task<void> PieceSplitter::split(Pace& pace, const PieceSplitter& s, const Piece& piece, SplineProblem& out) {
    const SplineProblem& whole = s.whole_;
    const uint32_t n = s.n_, begin = s.node_at(piece.from), nodes = s.node_at(piece.to) - begin + 1,
                   points = piece.to - piece.from + 1, hint = whole.manifold->hint_size();
    out.manifold = whole.manifold;
    out.bending = whole.bending;
    out.tension = whole.tension;
    out.first_tension = whole.first_tension;
    out.tolerance = whole.tolerance;
    out.max_rounds = whole.max_rounds;
    out.holds_nodes = whole.holds_nodes;
    out.border = whole.border;
    out.within = whole.within;
    out.points = Buffer<double>(size_t{nodes} * n, pace.memory());
    if (whole.hints.size() > 0) out.hints = Buffer<double>(size_t{nodes} * hint, pace.memory());
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t from = (begin + i) % s.nodes_;
        std::copy_n(&whole.points[size_t{from} * n], n, &out.points[size_t{i} * n]);
        if (out.hints.size() > 0) std::copy_n(&whole.hints[size_t{from} * hint], hint, &out.hints[size_t{i} * hint]);
    });
    const bool is_soft = whole.softness.size() > 0 || whole.smoothing > 0;
    out.knots = Buffer<uint32_t>(points, pace.memory());
    out.given = Buffer<double>(size_t{points} * n, pace.memory());
    if (whole.parameters.size() > 0) out.parameters = Buffer<double>(points, pace.memory());
    if (is_soft) out.softness = Buffer<double>(points, pace.memory());
    if (whole.tensions.size() > 0) out.tensions = Buffer<double>(points - 1, pace.memory());
    co_await each(pace, points, Cost::tens_of_ns, [&](uint32_t k) {
        const uint32_t point = piece.from + k;
        out.knots[k] = s.node_at(point) - begin;
        std::copy_n(&whole.given[size_t{point % s.count_} * n], n, &out.given[size_t{k} * n]);
        if (out.parameters.size() > 0) out.parameters[k] = s.parameter_at(point);
        if (is_soft) out.softness[k] = k == 0 || k + 1 == points ? 0 : s.softness_at(point);
        if (k < out.tensions.size()) out.tensions[k] = whole.tensions[point % s.count_];
    });
    s.set_slope(piece, false, out);
    s.set_slope(piece, true, out);
}

Task<void> append(Pace& pace, const Spline& piece, Joined& joined) {
    const uint32_t n = piece.manifold->manifold->ambient(), shown = piece.manifold->given_ambient,
                   hint = piece.manifold->manifold->hint_size();
    const auto intervals = static_cast<uint32_t>(piece.points.size() / n) - 1;
    co_await each(pace, intervals, Cost::tens_of_ns, [&](uint32_t i) {
        const auto add = [i](auto& to, const auto& from, size_t width) {
            to.insert(to.end(), from.data() + i * width, from.data() + (i + 1) * width);
        };
        add(joined.points, piece.points, n);
        add(joined.hints, piece.hints, hint);
        add(joined.nodes, piece.chain.nodes, shown);
        if (piece.normals.size() > 0) add(joined.normals, piece.normals, 3);
        joined.steps.push_back(piece.chain.parameters[i + 1] - piece.chain.parameters[i]);
    });
    co_await each(pace, piece.knots.size() - 1, Cost::some_ns,
                  [&](uint32_t k) { joined.knots.push_back(joined.count + piece.knots[k]); });
    co_await each(pace, piece.held.size(), Cost::some_ns,
                  [&](uint32_t h) { joined.held.push_back(joined.count + piece.held[h]); });
    joined.count += intervals;
}

void append_last(const Spline& piece, Joined& joined) {
    const auto add = [](auto& to, const auto& from, size_t width) {
        to.insert(to.end(), from.end() - width, from.end());
    };
    add(joined.points, piece.points, piece.manifold->manifold->ambient());
    add(joined.hints, piece.hints, piece.manifold->manifold->hint_size());
    add(joined.nodes, piece.chain.nodes, piece.manifold->given_ambient);
    if (piece.normals.size() > 0) add(joined.normals, piece.normals, 3);
    joined.knots.push_back(joined.count++);
}

void add_report(const SplineReport& piece, SplineReport& all) {
    all.rounds += piece.rounds;
    all.projections += piece.projections;
    all.held += piece.held;
    all.energy += piece.energy;
    all.bending += piece.bending;
    all.stretching += piece.stretching;
    all.length += piece.length;
    all.residual = std::max(all.residual, piece.residual);
    all.ending = std::max(all.ending, piece.ending);  // from the best to the worst
}

// Into the spline, from node `first` on: that of the first point.
Task<void> keep(Pace& pace, const Joined& joined, uint32_t first, double parameter, Spline& out) {
    const uint32_t count = joined.count;
    const auto copy = [&](const auto& from, auto& to) -> Task<void> {
        const size_t width = from.size() / count;
        to = std::remove_reference_t<decltype(to)>(from.size(), pace.memory());
        return each(pace, count, Cost::tens_of_ns, [&from, &to, width, first, count](uint32_t i) {
            const auto begin = static_cast<std::ptrdiff_t>((i + first) % count * width);
            std::copy_n(from.begin() + begin, width, to.data() + i * width);
        });
    };
    co_await copy(joined.points, out.points);
    co_await copy(joined.hints, out.hints);
    co_await copy(joined.nodes, out.chain.nodes);
    if (!joined.normals.empty()) co_await copy(joined.normals, out.normals);
    out.chain.parameters = Buffer<double>(size_t{count} + 1, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) {
        out.chain.parameters[i] = parameter;
        const uint32_t interval = (i + first) % count;
        if (interval < joined.steps.size()) parameter += joined.steps[interval];
    });
    out.chain.parameters[count] = parameter;
    const auto sort_in = [&](const std::pmr::deque<uint32_t>& from, Buffer<uint32_t>& to) {
        const auto begin = std::lower_bound(from.begin(), from.end(), first) - from.begin();
        to = Buffer<uint32_t>(from.size(), pace.memory());
        return each(pace, from.size(), Cost::some_ns, [&from, &to, begin, first, count](uint32_t k) {
            to[k] = (from[(k + static_cast<size_t>(begin)) % from.size()] + count - first) % count;
        });
    };
    co_await sort_in(joined.knots, out.knots);
    co_await sort_in(joined.held, out.held);
    out.chain.on_triangles = false;
}

}  // namespace

Task<void> minimize_pieces(Pace& pace, const SplineRequest& request, SplineProblem& whole, uint32_t nodes,
                           Spline& out) {
    const PieceSplitter splitter(whole);
    const auto at_first = static_cast<uint32_t>(whole.points.size() / whole.manifold->ambient());
    const uint32_t first_intervals = whole.closed ? at_first : at_first - 1,
                   intervals = whole.closed ? nodes : nodes - 1;
    const auto share = [&](uint32_t node) {
        return static_cast<uint32_t>(uint64_t{node} * intervals / first_intervals);
    };
    const std::pmr::vector<Piece> pieces = pieces_of(request, splitter.count(), pace.memory());
    Joined joined(pace.memory());
    SplineReport report{.ending = SplineEnding::converged};
    for (size_t p = 0; p < pieces.size(); ++p) {
        SplineProblem problem;
        co_await PieceSplitter::split(pace, splitter, pieces[p], problem);
        const uint32_t begin = splitter.node_at(pieces[p].from), end = splitter.node_at(pieces[p].to),
                       segments = pieces[p].to - pieces[p].from;
        Spline piece(out.manifold);
        co_await minimize_chain(pace, request, problem, std::max(share(end) - share(begin), 2 * segments) + 1, piece);
        co_await append(pace, piece, joined);
        add_report(piece.chain.report, report);
        if (p + 1 == pieces.size() && !whole.closed) append_last(piece, joined);
    }
    const uint32_t first_point = pieces[0].from, count = splitter.count();
    const uint32_t first = first_point == 0 ? 0 : joined.knots[count - first_point];
    co_await keep(pace, joined, first, whole.parameters.size() > 0 ? whole.parameters[0] : 0, out);
    out.chain.report = report;
    out.breaks = Buffer<uint32_t>(request.handles.size(), pace.memory());
    co_await each(pace, request.handles.size(), Cost::some_ns,
                  [&](uint32_t h) { out.breaks[h] = out.knots[request.handles[h].point]; });
}

}  // namespace flg
