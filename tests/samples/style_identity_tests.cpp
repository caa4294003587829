// SPDX-License-Identifier: MIT
// Identity measured from the style to the result: a style applied to its own guide comes back whole.
#include "api/style_inputs.h"
#include "core/random.h"
#include "scenes/scenes.h"

namespace flg::test {
namespace {

using Place = std::array<double, 3>;
using Polyline = std::vector<Place>;

double distance(const Place& a, const Place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double length_of(const Polyline& line) {
    double length = 0;
    for (size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
    return length;
}

double to_segment(const Place& p, const Place& a, const Place& b) {
    double along = 0, size_sq = 0;
    for (int k = 0; k < 3; ++k) {
        along += (p[k] - a[k]) * (b[k] - a[k]);
        size_sq += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double t = size_sq > 0 ? std::clamp(along / size_sq, 0.0, 1.0) : 0.0;
    return distance(p, {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
}

// How far the point of `from` that is furthest from `to` is from it.
double furthest(const Polyline& from, const Polyline& to) {
    double largest = 0;
    for (const Place& p : from) {
        double least = HUGE_VAL;
        for (size_t i = 1; i < to.size(); ++i) least = std::min(least, to_segment(p, to[i - 1], to[i]));
        largest = std::max(largest, least);
    }
    return largest;
}

struct Example {
    std::string name;
    Polyline points;
};

Polyline built_in(const std::string& name) {
    Polyline points;
    for (const scenes::Point& p : scenes::make_style(name).points) points.push_back({p.x, p.y, p.z});
    return points;
}

// A hand's scribble: an axis of some bends, and on it waves, loops that hang over, and spikes, each of random size.
Polyline scribble(uint64_t seed) {
    const auto random = [seed](uint64_t stream, uint64_t k) { return random_unit(seed, stream, k); };
    Polyline points;
    constexpr int count = 360;
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        Place p{6 * u, 0.4 * std::sin(4 * u + 6 * random(0, 0)), 0.3 * std::sin(3 * u + 6 * random(0, 1))};
        for (uint64_t k = 0; k < 6; ++k) {
            const double phase = (20 + 40 * random(1, k)) * u + 6 * random(2, k);
            for (uint64_t c = 0; c < 3; ++c)
                p[c] += 0.25 * (random(3 + c, k) - 0.5) * std::sin(phase + 6 * random(6 + c, k));
        }
        const double turn = 2 * M_PI * (8 + 8 * random(9, 0)) * u;
        const double loops = random(9, 1) * 0.5, spikes = random(9, 2) < 0.5 ? 0.8 : 0.0;
        p[0] += loops * std::sin(turn);
        p[1] += loops * std::cos(turn) + spikes * std::abs(std::remainder(turn / 3, 2.0));
        points.push_back(p);
    }
    return points;
}

std::vector<Example> examples() {
    std::vector<Example> all;
    for (const std::string& name : scenes::style_names()) all.push_back({name, built_in(name)});
    for (uint64_t seed = 1; seed <= 12; ++seed) all.push_back({"scribble " + std::to_string(seed), scribble(seed)});
    return all;
}

FlgCurveSet create(const Host& host, const Polyline& points) {
    Curves curves;
    for (const Place& p : points) curves.add_point(p[0], p[1], p[2]);
    curves.end_curve();
    return host.create(curves);
}

Polyline points_of(const FlgCurveSetView& view) {
    Polyline points;
    for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) {
        const float* p = view.columns[0].data + 3 * size_t{i};
        points.push_back({p[0], p[1], p[2]});
    }
    return points;
}

TEST(StyleIdentity, NothingOfAStyleIsCutOff) {
    Host host;
    for (const Example& example : examples()) {
        for (const float beta : {0.05f, 0.2f, 0.8f}) {
            FlgStyleDesc desc = flgStyleDefaults();
            desc.style = create(host, example.points);
            desc.beta = beta;
            FlgCurveSetStylizeDesc on_guide = flgCurveSetStylizeDefaults();
            on_guide.style = prepare(host, desc);
            const FlgStyleInfo info = style_info(host, on_guide.style);
            ASSERT_EQ(flgStyleGetGuide(host.context, on_guide.style, &on_guide.target), FLG_OK);
            const Polyline result = points_of(host.view_of(stylize(host, on_guide)));
            SCOPED_TRACE(example.name + ", beta " + std::to_string(beta));
            EXPECT_GE(length_of(result), 0.97 * info.style_length);
            EXPECT_LE(furthest(example.points, result), 0.12 * info.displacement_rms);
            EXPECT_LE(furthest(result, example.points), 0.12 * info.displacement_rms);
        }
    }
}

}  // namespace
}  // namespace flg::test
