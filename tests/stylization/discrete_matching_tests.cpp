// SPDX-License-Identifier: MIT
#include "stylization/guide_discrete_matching.h"

#include <gtest/gtest.h>

#include "reference/literal_matching.h"
#include "stylization/guide_matching.h"
#include "stylization/style_inputs.h"

namespace flg {
namespace {

struct Coil {
    std::vector<Vec3> style, guide;
    double length = 0;

    Coil(int points, int guide_points) {
        for (int i = 0; i < points; ++i) {
            const double u = 20.0 * i / (points - 1);
            style.emplace_back(0.1 * u, std::cos(u), std::sin(u));
        }
        for (int i = 1; i < points; ++i) length += (style[i] - style[i - 1]).norm();
        for (int i = 0; i < guide_points; ++i) guide.emplace_back(2.0 * i / (guide_points - 1), 0.1, 0);
    }
};

template <class Matching>
std::pair<std::vector<double>, double> match(const Coil& coil, uint32_t slice) {
    const SmoothStyleCurve style(coil.style.data(), static_cast<uint32_t>(coil.style.size()), coil.length);
    Matching matching(style, coil.guide.data(), static_cast<uint32_t>(coil.guide.size()), 0.3, test::memory());
    while (!matching.run(slice)) {}
    return {{matching.matching().begin(), matching.matching().end()}, matching.energy()};
}

TEST(DiscreteMatching, IsTheLiteralOne) {
    for (const auto& [points, guide_points] : {std::pair{200, 200}, {150, 70}, {70, 150}, {16, 2}, {16, 3}}) {
        const Coil coil(points, guide_points);
        const reference::LiteralMatching expected =
            reference::match_discrete(coil.style, coil.length, coil.guide, 0.3, false);
        const auto [delta, energy] = match<DiscreteMatching>(coil, 1000);
        ASSERT_EQ(delta.size(), expected.delta.size());
        for (size_t i = 0; i < delta.size(); ++i) EXPECT_NEAR(delta[i], expected.delta[i], 1e-9) << i;
        EXPECT_NEAR(energy, expected.energy, 1e-9 * (1 + expected.energy));
        EXPECT_EQ(delta, match<DiscreteMatching>(coil, 1).first);
    }
}

TEST(DiscreteMatching, CostsNoLessThanPlacesThatAreFree) {
    const Coil coil(300, 300);
    EXPECT_GT(match<DiscreteMatching>(coil, 1000).second, match<GuideMatching>(coil, 1000).second);
}

}  // namespace
}  // namespace flg
