// SPDX-License-Identifier: MIT
#include "bones/contour_mirror.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "bones/wide_part.h"
#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t first_moment = 2, moment_count = 5;
constexpr double no_moment = 1e-5;  // by the area: a moment that small says nothing
constexpr double off_real = 0.02;   // of the moments: what is left of them beside the real line at an axis
constexpr double alike = 1e-4;      // by the area: shapes as long along one axis as along another
constexpr double upright = 1e-6;    // axes as upright as each other
constexpr uint32_t probes = 48;     // points of the line whose images are looked up
constexpr double on_axis = 1e-6;    // of the line's size: drawn points may be floats

struct Complex {
    double re = 0, im = 0;
    Complex operator*(const Complex& o) const { return {re * o.re - im * o.im, re * o.im + im * o.re}; }
};

// Of Gauss and Legendre, exact to degree 7.
constexpr std::array<std::array<double, 2>, 4> nodes = {{{0.0694318442029737, 0.1739274225687269},
                                                         {0.3300094782075719, 0.3260725774312731},
                                                         {0.6699905217924281, 0.3260725774312731},
                                                         {0.9305681557970263, 0.1739274225687269}}};

// Integrals over the area, by its border: of z^n that of conj(z) z^n / 2i.
struct Moments {
    std::array<Complex, moment_count> of{};

    void add(const Complex& a, const Complex& b) {
        const Complex d{b.re - a.re, b.im - a.im};
        for (const auto& [share, weight] : nodes) {
            const Complex z{a.re + share * d.re, a.im + share * d.im};
            // conj(z) dz / 2i
            Complex power{0.5 * weight * (z.re * d.im - z.im * d.re), -0.5 * weight * (z.re * d.re + z.im * d.im)};
            power = power * z;
            for (Complex& moment : of) {
                power = power * z;
                moment.re += power.re, moment.im += power.im;
            }
        }
    }
    double size(uint32_t k) const { return std::hypot(of[k].re, of[k].im); }
};

Task<bool> is_axis(Pace& pace, const Contour& contour, MirrorAxis axis, double tolerance) {
    const uint32_t step = std::max(1u, contour.size() / probes);
    for (uint32_t i = 0; i < contour.size(); i += step) {
        const double depth = co_await depth_in(pace, contour, axis.image(contour.points[i]));
        if (std::abs(depth) > tolerance) co_return false;
    }
    co_return true;
}

int sign_of(const MirrorAxis& axis, const Point2& p, double zero) {
    const double side = axis.side(p);
    return side > zero ? 1 : side < -zero ? -1 : 0;
}

Point2 crossing(const MirrorAxis& axis, const Point2& a, const Point2& b) {
    const double from = axis.side(a), to = axis.side(b);
    return axis.on_axis(mix(a, b, from / (from - to)));
}

}  // namespace

Task<ContourArea> area_within(Pace& pace, const Contour& contour) {
    const Point2 origin = contour.points[0];
    double doubled = 0, x = 0, y = 0;
    co_await each(pace, contour.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Point2 &a = contour.points[i], &b = contour.points[contour.next(i)];
        const Point2 p{a.x - origin.x, a.y - origin.y}, q{b.x - origin.x, b.y - origin.y};
        const double cross = p.x * q.y - q.x * p.y;
        doubled += cross;
        x += cross * (p.x + q.x);
        y += cross * (p.y + q.y);
    });
    co_return {0.5 * doubled, {origin.x + x / (3 * doubled), origin.y + y / (3 * doubled)}};
}

Task<std::optional<MirrorAxis>> find_mirror(Pace& pace, const Contour& contour, double tolerance) {
    if (contour.ring_count() > 1) co_return std::nullopt;
    const ContourArea within = co_await area_within(pace, contour);
    const double unit = 1 / std::sqrt(within.area);
    const auto scaled = [&](uint32_t i) {
        return Complex{(contour.points[i].x - within.centroid.x) * unit,
                       (contour.points[i].y - within.centroid.y) * unit};
    };
    Moments moments;
    co_await each(pace, contour.size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { moments.add(scaled(i), scaled(contour.next(i))); });
    uint32_t largest = 0;
    double sum = 0;
    for (uint32_t k = 0; k < moment_count; ++k) {
        sum += moments.size(k);
        if (moments.size(k) > moments.size(largest)) largest = k;
    }
    if (moments.size(largest) < no_moment) co_return std::nullopt;
    const uint32_t order = first_moment + largest;
    const double angle = std::atan2(moments.of[largest].im, moments.of[largest].re);
    std::optional<MirrorAxis> best;
    double best_length = 0;  // of the shape along the axis, against across
    for (uint32_t k = 0; k < order; ++k) {
        const double turn = (angle + k * std::acos(-1.0)) / order;
        double rest = 0;
        for (uint32_t n = 0; n < moment_count; ++n) {
            const double back = -turn * (first_moment + n);
            rest += std::abs((moments.of[n] * Complex{std::cos(back), std::sin(back)}).im);
        }
        if (rest > off_real * sum) continue;
        MirrorAxis axis{within.centroid, {std::cos(turn), std::sin(turn)}};
        if (axis.along.y < 0) axis.along = {-axis.along.x, -axis.along.y};
        const double length = (moments.of[0] * Complex{std::cos(-2 * turn), std::sin(-2 * turn)}).re;
        const bool is_alike = std::abs(length - best_length) <= alike;
        if (best && (is_alike ? axis.along.y <= best->along.y + upright : length < best_length)) continue;
        const bool holds = co_await is_axis(pace, contour, axis, tolerance);
        if (holds) best = axis, best_length = length;
    }
    co_return best;
}

Task<std::optional<Contour>> left_half(Pace& pace, const Contour& contour, MirrorAxis axis) {
    const uint32_t count = contour.size();
    const double zero = on_axis * distance(axis.at, contour.points[0]);
    Buffer<int8_t> sign(count, pace.memory());
    uint32_t crossings = 0, begin = count;
    int last = 0, first = 0;
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const int s = sign_of(axis, contour.points[i], zero);
        sign[i] = static_cast<int8_t>(s);
        if (s == 0) return;
        if (first == 0) first = s;
        crossings += last != 0 && s != last;
        if (last == -1 && s == 1) begin = i;
        last = s;
    });
    crossings += first != last;
    if (last == -1 && first == 1)
        for (begin = 0; sign[begin] == 0;) ++begin;
    if (crossings != 2 || begin == count) co_return std::nullopt;
    Contour half(pace.memory());
    half.offsets.push_back(0);
    const auto before = [&](uint32_t i) { return i == 0 ? count - 1 : i - 1; };
    const auto border = [&](uint32_t inside, uint32_t outside) {
        const Point2 &a = contour.points[inside], &b = contour.points[outside];
        return sign[outside] == 0 ? axis.on_axis(b) : crossing(axis, a, b);
    };
    half.points.push_back(border(begin, before(begin)));
    uint32_t i = begin;
    bool is_simple = true;
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (sign[i] != 1) return false;
        half.points.push_back(contour.points[i]);
        i = i + 1 == count ? 0 : i + 1;
        return true;
    });
    half.points.push_back(border(before(i), i));
    // The line may touch the axis from one side, and would be two pieces.
    uint32_t left = 0;
    co_await each(pace, count, Cost::some_ns, [&](uint32_t k) { left += sign[k] == 1; });
    is_simple = half.points.size() == static_cast<size_t>(left) + 2 && half.points.size() >= 4;
    half.offsets.push_back(half.size());
    half.input_points.resize(half.size(), UINT32_MAX);
    if (!is_simple) co_return std::nullopt;
    co_return half;
}

Task<double> gap_at_axis(Pace& pace, const Contour& half, MirrorAxis axis, double reach) {
    const uint32_t last = half.size() - 1;
    double length = 0;
    co_await each(pace, last, Cost::some_ns,
                  [&](uint32_t i) { length += distance(half.points[i], half.points[i + 1]); });
    double way = 0, least = HUGE_VAL;
    co_await each(pace, last, Cost::some_ns, [&](uint32_t i) {
        if (way > reach && length - way > reach) least = std::min(least, std::abs(axis.side(half.points[i])));
        way += distance(half.points[i], half.points[i + 1]);
    });
    co_return least;
}

Task<Contour> with_image(Pace& pace, const Contour& half, MirrorAxis axis, double tolerance) {
    Contour whole(pace.memory());
    const uint32_t count = half.size();
    double size = 0;
    co_await each(pace, count, Cost::some_ns,
                  [&](uint32_t i) { size = std::max(size, distance(axis.at, half.points[i])); });
    const auto along = [&](const Point2& p) {
        return axis.along.x * (p.x - axis.at.x) + axis.along.y * (p.y - axis.at.y);
    };
    // The longest edge beside the axis is the one that closes the half; what else is on the axis there goes with it.
    // Its ends may be off: the half is simplified.
    const double beside = std::max(2 * tolerance, 10 * on_axis * size);
    const auto is_within = [&](uint32_t i, double reach) { return std::abs(axis.side(half.points[i])) <= reach; };
    double longest = 0;
    uint32_t begin = count, end = count;
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) {
        const uint32_t next = half.next(i);
        if (!is_within(i, beside) || !is_within(next, beside)) return;
        const double length = std::abs(along(half.points[next]) - along(half.points[i]));
        if (length > longest) longest = length, end = i, begin = next;
    });
    if (begin == count) co_return whole;
    const auto previous = [&](uint32_t i) { return i == 0 ? count - 1 : i - 1; };
    while (begin != end && is_within(half.next(begin), 10 * on_axis * size)) begin = half.next(begin);
    while (begin != end && is_within(previous(end), 10 * on_axis * size)) end = previous(end);
    if (begin == end || half.next(begin) == end) co_return whole;
    const auto is_corner = [&](uint32_t on, uint32_t off) {
        return std::abs(along(half.points[on]) - along(half.points[off])) > tolerance;
    };
    whole.offsets.push_back(0);
    if (is_corner(begin, half.next(begin))) whole.points.push_back(axis.on_axis(half.points[begin]));
    const auto first = static_cast<uint32_t>(whole.points.size());
    uint32_t i = half.next(begin), before = i;
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (i == end) return false;
        whole.points.push_back(half.points[i]);
        before = i;
        i = half.next(i);
        return true;
    });
    const uint32_t last = whole.size();
    if (is_corner(i, before)) whole.points.push_back(axis.on_axis(half.points[i]));
    co_await each(pace, last - first, Cost::tens_of_ns,
                  [&](uint32_t k) { whole.points.push_back(axis.image(whole.points[last - 1 - k])); });
    whole.offsets.push_back(whole.size());
    whole.input_points.resize(whole.size(), UINT32_MAX);
    co_return whole;
}

}  // namespace flg
