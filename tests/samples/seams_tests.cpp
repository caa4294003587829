// SPDX-License-Identifier: MIT
// Seams and closings of the built-in styles: a result turns there no more than its style does elsewhere.
#include <algorithm>

#include "api/style_inputs.h"
#include "scenes/scenes.h"

namespace flg::test {
namespace {

FlgCurveSet create(const Host& host, const std::vector<scenes::Point>& points, bool closed = false) {
    Curves curves;
    for (const scenes::Point& p : points) curves.add_point(p.x, p.y, p.z);
    curves.end_curve(closed ? FLG_CURVE_CLOSED : 0);
    return host.create(curves);
}

FlgStyle built_in(const Host& host, const std::string& name) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = create(host, scenes::make_style(name).points);
    return prepare(host, desc);
}

struct Result {
    std::vector<double> turns;  // at each point, radians; of an open curve its ends have none
    std::vector<size_t> seams;  // points that a run begins with
    std::vector<size_t> nodes;  // of the style, that points copy

    Result(const Host& host, const FlgCurveSetStylizeDesc& desc) {
        const FlgCurveSetView view = host.view_of(stylize(host, desc));
        const size_t count = view.curve_offsets[1];
        const bool closed = view.curve_flags[0] == FLG_CURVE_CLOSED;
        const FlgColumn* index = find_column(view, FLG_ATTRIBUTE_STYLE_INDEX);
        for (size_t i = 0; i < count; ++i) {
            const bool inner = closed || (i > 0 && i + 1 < count);
            const float* p = view.columns[0].data;
            turns.push_back(inner ? turn(p + 3 * ((i + count - 1) % count), p + 3 * i, p + 3 * ((i + 1) % count)) : 0);
            nodes.push_back(static_cast<size_t>(index->data[i]));
            if (i > 0 && inner && index->data[i] != index->data[i - 1] + 1) seams.push_back(i);
        }
    }
    static double turn(const float* a, const float* b, const float* c) {
        double before = 0, after = 0, both = 0;
        for (int k = 0; k < 3; ++k) {
            const double u = double{b[k]} - a[k], v = double{c[k]} - b[k];
            before += u * u;
            after += v * v;
            both += u * v;
        }
        return std::acos(std::clamp(both / std::sqrt(before * after), -1.0, 1.0));
    }
};

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
}

TEST(Seams, TurnNoMoreThanTheStyleDoes) {
    Host host;
    std::vector<scenes::Point> target;
    for (int i = 0; i < 400; ++i) {
        const float x = 0.1f * static_cast<float>(i);
        target.push_back({x, std::sin(0.2f * x), 0});
    }
    for (const std::string& name : scenes::style_names()) {
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = built_in(host, name);
        ASSERT_EQ(flgStyleGetGuide(host.context, desc.style, &desc.target), FLG_OK);
        const Result style(host, desc);
        ASSERT_EQ(style.seams.size(), 0u) << name;
        const double usual = quantile(style.turns, 0.9);
        // Where a seam lies in a corner of the style, the style turns more: at the nodes that the seam joins.
        const auto own_turn = [&](size_t node) {
            const auto begin = style.turns.begin() + static_cast<ptrdiff_t>(node > 0 ? node - 1 : 0);
            return *std::max_element(
                begin, style.turns.begin() + static_cast<ptrdiff_t>(std::min(node + 2, style.turns.size())));
        };
        desc.target = create(host, target);
        desc.start = FLG_STYLE_START_RANDOM;
        // The largest turn of each seam and the points beside it, over what the style has.
        std::vector<double> at_seams;
        for (desc.seed = 1; desc.seed <= 3; ++desc.seed) {
            const Result result(host, desc);
            for (const size_t i : result.seams) {
                const double own = std::max({usual, own_turn(result.nodes[i - 1]), own_turn(result.nodes[i])});
                at_seams.push_back(std::max({result.turns[i - 1], result.turns[i], result.turns[i + 1]}) / own);
            }
        }
        ASSERT_GT(at_seams.size(), 120u) << name;
        EXPECT_LE(quantile(at_seams, 0.5), 1.5) << name;
    }
}

TEST(Seams, ClosedCurvesDoNotShowWhereTheyBegin) {
    Host host;
    for (const std::string& name : scenes::style_names()) {
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = built_in(host, name);
        for (const char* target : {"ring", "vine", "coaster"}) {
            desc.target = create(host, scenes::make_target(target).points, true);
            for (const uint64_t seed : {0, 1, 2, 3}) {
                desc.start = seed == 0 ? FLG_STYLE_START_STYLE : FLG_STYLE_START_RANDOM;
                desc.seed = seed;
                const std::vector<double> turns = Result(host, desc).turns;
                const size_t count = turns.size();
                const double closing = std::max({turns[count - 1], turns[0], turns[1]});
                const auto larger =
                    std::count_if(turns.begin() + 2, turns.end() - 1, [&](double turn) { return turn > closing; });
                EXPECT_GE(larger, 3) << name << " on " << target << ", seed " << seed;
            }
        }
    }
}

}  // namespace
}  // namespace flg::test
