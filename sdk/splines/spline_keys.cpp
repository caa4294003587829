// SPDX-License-Identifier: MIT
#include "splines/spline_keys.h"

#include <algorithm>
#include <deque>

#include "splines/manifolds/coordinates.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg {

namespace {

using Vector = std::array<double, Manifold::max_ambient>;

// A key as it grows: value, derivatives before and after it.
struct Keys {
    explicit Keys(Memory* memory) : parameters(memory), points(memory), arriving(memory), leaving(memory) {}
    std::pmr::deque<double> parameters, points, arriving, leaving;
    double largest_error = 0;
};

// A stretch of the chain without a corner: its nodes from `begin` to `end`, counted on beyond the last of a closed one.
class Stretch {
public:
    Stretch(const Spline& spline, uint32_t begin, uint32_t end, Memory* memory)
        : spline_(spline),
          n_(spline.manifold->given_ambient),
          nodes_(static_cast<uint32_t>(spline.chain.nodes.size() / n_)),
          begin_(begin),
          end_(end),
          times_(memory),
          values_(memory) {}

    static Task<void> add(Pace& pace, Stretch& s, bool periodic, double tolerance, Keys& keys);

private:
    double time_at(uint32_t node) const {
        const Buffer<double>& parameters = spline_.chain.parameters;
        return node < nodes_ ? parameters[node] : parameters[nodes_] + parameters[node - nodes_] - parameters[0];
    }
    // How far the piece is from the curve, at a node and halfway to the next.
    double error_after(uint32_t node) const;
    void set_piece(uint32_t from, uint32_t to);
    void push(Keys& keys) const;

    const Spline& spline_;
    uint32_t n_, nodes_, begin_, end_;
    std::pmr::vector<double> times_, values_;
    std::optional<NaturalCubic> curve_;
    // Of the piece that is tried.
    double t0_ = 0, t1_ = 0;
    Vector p0_{}, p1_{}, m0_{}, m1_{};
};

void Stretch::set_piece(uint32_t from, uint32_t to) {
    t0_ = times_[from - begin_];
    t1_ = times_[to - begin_];
    curve_->evaluate(t0_, 0, p0_.data());
    curve_->evaluate(t1_, 0, p1_.data());
    curve_->evaluate(t0_, 1, m0_.data());
    curve_->evaluate(t1_, 1, m1_.data());
}

double Stretch::error_after(uint32_t node) const {
    double largest = 0;
    const double begin = times_[node - begin_], step = times_[node + 1 - begin_] - begin;
    for (const double share : {0.0, 0.5}) {
        const double t = begin + share * step, h = t1_ - t0_, s = (t - t0_) / h, w = 1 - s;
        Vector exact{}, own{};
        curve_->evaluate(t, 0, exact.data());
        for (uint32_t c = 0; c < n_; ++c) {
            own[c] =
                w * w * (1 + 2 * s) * p0_[c] + s * s * (1 + 2 * w) * p1_[c] + h * s * w * (w * m0_[c] - s * m1_[c]);
        }
        largest = std::max(largest, distance_between(exact.data(), own.data(), n_));
    }
    return largest;
}

void Stretch::push(Keys& keys) const {
    const auto add = [this](std::pmr::deque<double>& to, const Vector& from) {
        to.insert(to.end(), from.begin(), from.begin() + n_);
    };
    if (keys.parameters.empty()) {
        keys.parameters.push_back(t0_);
        add(keys.points, p0_);
        add(keys.arriving, m0_);
        add(keys.leaving, m0_);
    } else {
        std::copy_n(m0_.begin(), n_, keys.leaving.end() - n_);
    }
    keys.parameters.push_back(t1_);
    add(keys.points, p1_);
    add(keys.arriving, m1_);
    add(keys.leaving, m1_);
}

Task<void> Stretch::add(Pace& pace, Stretch& s, bool periodic, double tolerance, Keys& keys) {
    const uint32_t last = periodic ? s.end_ - 1 : s.end_;
    s.times_.reserve(s.end_ - s.begin_ + 1);
    s.values_.reserve(size_t{last - s.begin_ + 1} * s.n_);
    co_await each(pace, s.end_ - s.begin_ + 1, Cost::tens_of_ns, [&s, last](uint32_t i) {
        const uint32_t node = s.begin_ + i;
        s.times_.push_back(s.time_at(node));
        if (node > last) return;
        const double* const x = &s.spline_.chain.nodes[size_t{node % s.nodes_} * s.n_];
        s.values_.insert(s.values_.end(), x, x + s.n_);
    });
    CubicData data{.knots = s.times_, .values = s.values_};
    data.dimension = s.n_;
    data.ends = periodic ? CubicEnds::periodic : CubicEnds::natural;
    s.curve_.emplace(co_await natural_cubic(pace, data));
    struct Range {
        uint32_t from, to;
    };
    std::pmr::vector<Range> waiting(pace.memory());
    const Buffer<uint32_t>& knots = s.spline_.knots;
    std::pmr::vector<uint32_t> stops(pace.memory());
    stops.reserve(knots.size() + 1);
    for (const uint32_t node : {0u, s.nodes_}) {
        co_await each(pace, knots.size(), Cost::some_ns, [&](uint32_t k) {
            const uint32_t at = knots[k] + node;
            if (at > s.begin_ && at < s.end_) stops.push_back(at);
        });
    }
    stops.push_back(s.end_);
    Slice slice(Cost::hundreds_of_ns);
    uint32_t from = s.begin_;
    for (const uint32_t stop : stops) {
        waiting.push_back({from, stop});
        from = stop;
        while (!waiting.empty()) {
            const Range range = waiting.back();
            waiting.pop_back();
            s.set_piece(range.from, range.to);
            double error = 0;
            for (uint32_t node = range.from; range.to - range.from > 1 && node < range.to && error <= tolerance;
                 ++node) {
                error = std::max(error, s.error_after(node));
                if (slice.is_over()) co_await pace;
            }
            if (error > tolerance) {
                const uint32_t middle = range.from + (range.to - range.from) / 2;
                waiting.push_back({middle, range.to});
                waiting.push_back({range.from, middle});
                continue;
            }
            keys.largest_error = std::max(keys.largest_error, error);
            s.push(keys);
        }
    }
}

}  // namespace

Task<void> fit_keys(Pace& pace, double tolerance, bool breaks_everywhere, Spline& out) {
    const uint32_t n = out.manifold->given_ambient, nodes = static_cast<uint32_t>(out.chain.nodes.size() / n);
    const Buffer<uint32_t>& breaks = breaks_everywhere ? out.knots : out.breaks;
    Keys keys(pace.memory());
    std::pmr::vector<uint32_t> ends(pace.memory());
    ends.reserve(breaks.size() + 2);
    if (!out.closed) ends.push_back(0);
    co_await each(pace, breaks.size(), Cost::some_ns, [&](uint32_t b) {
        if (out.closed || (breaks[b] > 0 && breaks[b] + 1 < nodes)) ends.push_back(breaks[b]);
    });
    if (!out.closed) ends.push_back(nodes - 1);
    const bool periodic = out.closed && ends.empty();
    if (periodic) ends.push_back(0);
    if (out.closed) ends.push_back(ends.front() + nodes);
    for (size_t e = 0; e + 1 < ends.size(); ++e) {
        Stretch stretch(out, ends[e], ends[e + 1], pace.memory());
        co_await Stretch::add(pace, stretch, periodic, tolerance, keys);
    }
    if (out.closed) {
        std::copy_n(keys.arriving.end() - n, n, keys.arriving.begin());
        std::copy_n(keys.leaving.begin(), n, keys.leaving.end() - n);
    }
    Spline::Keys& kept = out.keys;
    kept.largest_error = keys.largest_error;
    const auto copy = [&](const std::pmr::deque<double>& from, Buffer<double>& to) {
        to = Buffer<double>(from.size(), pace.memory());
        return each(pace, from.size(), Cost::some_ns, [&from, &to](uint32_t i) { to[i] = from[i]; });
    };
    co_await copy(keys.parameters, kept.parameters);
    co_await copy(keys.points, kept.points);
    co_await copy(keys.arriving, kept.arriving);
    co_await copy(keys.leaving, kept.leaving);
}

}  // namespace flg
