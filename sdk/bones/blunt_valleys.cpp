// SPDX-License-Identifier: MIT
#include "bones/blunt_valleys.h"

#include <array>
#include <cmath>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr double sharp = 1.75;     // a turn, in radians
constexpr double of_edge = 0.25;   // of the shorter edge at a point, at most
constexpr double on_axis = 1e-12;  // of the distance from where the axis is known

// Of a point of a contour and those before and after it.
struct Corner {
    Point2 before, at, after;

    bool is_valley() const {
        const Point2 in{at.x - before.x, at.y - before.y}, out{after.x - at.x, after.y - at.y};
        return std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y) < -sharp;
    }
    std::array<Point2, 2> blunt(double reach) const {
        const double in = distance(before, at), out = distance(at, after);
        const double step = std::min(reach, of_edge * std::min(in, out));
        return {mix(at, before, step / in), mix(at, after, step / out)};
    }
};

}  // namespace

Task<Contour> with_blunt_valleys(Pace& pace, Contour contour, std::optional<MirrorAxis> mirror, double reach) {
    const auto corner = [&](uint32_t i) {
        const uint32_t ring = contour.ring_of(i), begin = contour.offsets[ring], end = contour.offsets[ring + 1];
        return Corner{contour.points[i == begin ? end - 1 : i - 1], contour.points[i], contour.points[contour.next(i)]};
    };
    Buffer<uint8_t> is_valley(contour.size(), pace.memory());
    uint32_t valleys = 0;
    co_await each(pace, contour.size(), Cost::tens_of_ns, [&](uint32_t i) {
        is_valley[i] = corner(i).is_valley();
        valleys += is_valley[i];
    });
    if (valleys == 0) co_return contour;
    const auto is_on_axis = [&](uint32_t i) {
        const Point2& at = contour.points[i];
        return mirror && std::abs(mirror->side(at)) <= on_axis * (distance(mirror->at, at) + reach);
    };
    // A contour with its image has its points in order and then their images backwards; maybe one on the axis first.
    const uint32_t count = contour.size(), first = is_on_axis(0) ? count : count - 1;
    const auto image = [&](uint32_t i) { return (first - i) % count; };
    Contour out(pace.memory());
    out.offsets.push_back(0);
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        if (i == contour.offsets[out.offsets.size()]) out.offsets.push_back(out.size());
        if (is_valley[i] == 0) {
            out.points.push_back(contour.points[i]);
        } else if (!mirror) {
            for (const Point2& at : corner(i).blunt(reach)) out.points.push_back(at);
        } else if (is_on_axis(i)) {
            const Point2 before = corner(i).blunt(reach)[0];
            out.points.push_back(before);
            out.points.push_back(mirror->image(before));
        } else if (i < image(i)) {
            for (const Point2& at : corner(i).blunt(reach)) out.points.push_back(at);
        } else {
            const std::array<Point2, 2> other = corner(image(i)).blunt(reach);
            out.points.push_back(mirror->image(other[1]));
            out.points.push_back(mirror->image(other[0]));
        }
        out.input_points.resize(out.size(), contour.input_points[i]);
    });
    out.offsets.push_back(out.size());
    co_return out;
}

}  // namespace flg
