// SPDX-License-Identifier: MIT
// Networks whose curves go on into each other where they meet.
#include "api/live_inputs.h"
#include "api/style_inputs.h"
#include "core/vec.h"

namespace flg::test {
namespace {

using ArmEnd = std::array<double, 3>;

// Straight arms that begin or end at the origin.
Curves arms(const std::vector<std::pair<ArmEnd, bool>>& ends) {
    Curves curves;
    for (const auto& [end, outwards] : ends) {
        if (outwards) curves.add_point(0, 0, 0);
        curves.add_point(end[0], end[1], end[2]);
        if (!outwards) curves.add_point(0, 0, 0);
        curves.end_curve();
    }
    return curves;
}

class Junctions : public testing::Test {
protected:
    Junctions() {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = host.create(coil(400, 12, 6, 0.1));
        desc.style = prepare(host, style);
        desc.pin_ends = desc.keep_displacement = 1;
        desc.smooth_junctions = 1;
    }
    FlgCurveSetView result(const Curves& target) {
        desc.target = host.create(target);
        return host.view_of(stylize(host, desc));
    }
    // The `column`'s value at a curve's k-th point from its start, or from its end.
    static Vec3 value(const FlgCurveSetView& view, FlgAttribute column, uint32_t curve, bool from_start, uint32_t k) {
        const uint32_t row = from_start ? view.curve_offsets[curve] + k : view.curve_offsets[curve + 1] - 1 - k;
        return load_vec3(find_column(view, column)->data + size_t{3} * row);
    }
    static Vec3 direction(const FlgCurveSetView& view, uint32_t curve, bool from_start) {
        const Vec3 junction = value(view, FLG_ATTRIBUTE_POSITION, curve, from_start, 0);
        EXPECT_EQ(junction, Vec3::Zero());
        return (value(view, FLG_ATTRIBUTE_POSITION, curve, from_start, 1) - junction).normalized();
    }
    static Vec3 tangent(const FlgCurveSetView& view, uint32_t curve, bool from_start) {
        const Vec3 t = value(view, FLG_ATTRIBUTE_TANGENT, curve, from_start, 0);
        return from_start ? t : Vec3(-t);
    }

    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
};

TEST_F(Junctions, CurvesThatContinueEachOtherShareATangent) {
    // Two lines that cross, slightly bent, and a fifth arm that continues nothing.
    const Curves crossing = arms({{{3, 0.2, 0}, true},
                                  {{-3, 0.3, 0}, false},
                                  {{0.1, 4, 0.5}, true},
                                  {{0.2, -3, 0.4}, true},
                                  {{1, 1, 3}, false}});
    const std::vector<std::array<uint32_t, 2>> pairs = {{0, 1}, {2, 3}};
    const bool from_start[] = {true, false, true, true, false};
    for (const float magnitude : {1.0f, -2.0f, 0.0f}) {
        desc.magnitude = magnitude;
        for (const uint32_t strokes : {1u, 3u}) {
            desc.strokes = strokes;
            const FlgCurveSetView view = result(crossing);
            for (uint32_t stroke = 0; stroke < strokes; ++stroke) {
                for (const auto& [a, b] : pairs) {
                    const uint32_t i = a * strokes + stroke, j = b * strokes + stroke;
                    const double cosine = -direction(view, i, from_start[a]).dot(direction(view, j, from_start[b]));
                    EXPECT_GT(cosine, 1 - 1e-6) << magnitude << ", " << a;
                    EXPECT_GT(-tangent(view, i, from_start[a]).dot(tangent(view, j, from_start[b])), 1 - 1e-6);
                }
            }
        }
    }
}

// Nothing else changes: not the free ends, not what is farther than 4 patches, not who goes on into nobody.
TEST_F(Junctions, TheRestStays) {
    const Curves crossing = arms({{{3, 0.2, 0}, true}, {{-3, 0.3, 0}, false}, {{0, 4, 0}, true}});
    const FlgCurveSetView smooth = result(crossing);
    desc.smooth_junctions = 0;
    const FlgCurveSetView plain = result(crossing);
    const uint32_t far = 4 * 10;
    const float* a = find_column(smooth, FLG_ATTRIBUTE_POSITION)->data;
    const float* b = find_column(plain, FLG_ATTRIBUTE_POSITION)->data;
    const auto expect_equal = [&](uint32_t first, uint32_t last) {
        for (uint32_t i = 3 * first; i < 3 * last; ++i) ASSERT_EQ(a[i], b[i]) << i;
    };
    expect_equal(plain.curve_offsets[0] + far, plain.curve_offsets[1]);
    expect_equal(plain.curve_offsets[1], plain.curve_offsets[2] - far);
    expect_equal(plain.curve_offsets[2], plain.curve_offsets[3]);
    EXPECT_NE(bits(smooth), bits(plain));
    // The magnitude can still be changed afterwards.
    const float* da = find_column(smooth, FLG_ATTRIBUTE_DISPLACEMENT)->data;
    const float* db = find_column(plain, FLG_ATTRIBUTE_DISPLACEMENT)->data;
    for (uint32_t i = 0; i < 3 * plain.curve_offsets[3]; ++i) ASSERT_NEAR(a[i] - da[i], b[i] - db[i], 1e-5) << i;
}

// Steps do not get longer, nor turns sharper, than the style has them.
TEST_F(Junctions, ResultsGoOnEvenly) {
    const Curves line = arms({{{5, 0, 0}, true}, {{-5, 0, 0}, false}});
    const FlgCurveSetView view = result(line);
    const auto sharpest = [&](uint32_t curve, uint32_t first, uint32_t last) {
        double least = 1;
        for (uint32_t k = first; k < last; ++k) {
            const auto at = [&](uint32_t i) { return value(view, FLG_ATTRIBUTE_POSITION, curve, curve == 0, i); };
            least = std::min(least, (at(k + 1) - at(k)).normalized().dot((at(k + 2) - at(k + 1)).normalized()));
        }
        return std::acos(least);
    };
    for (const uint32_t curve : {0u, 1u}) EXPECT_LT(sharpest(curve, 0, 40), 2 * sharpest(curve, 60, 160));
}

TEST_F(Junctions, LoopsAndDegenerateCurvesStay) {
    Curves odd;
    for (const double x : {0.0, 1.0, 1.0}) odd.add_point(x, 0, 0);
    odd.end_curve();
    odd.add_point(1, 0, 0);
    odd.end_curve();
    for (const double x : {1.0, 1.001}) odd.add_point(x, 0, 0);
    odd.end_curve();
    for (int i = 0; i <= 60; ++i) odd.add_point(std::cos(M_PI * i / 30), std::sin(M_PI * i / 30), 0);
    odd.end_curve();
    odd.add_point(0, 0, 0);
    odd.add_point(0, 1, 0);
    odd.end_curve(FLG_CURVE_CLOSED);
    for (int i = 0; i < 100; ++i) {
        odd.add_point(0, 0, 0);
        odd.add_point(0.5 * std::cos(i), 0.5 * std::sin(i), 0.1 * i);
        odd.end_curve();
    }
    const FlgCurveSetView view = result(odd);
    const float* p = find_column(view, FLG_ATTRIBUTE_POSITION)->data;
    for (uint32_t i = 0; i < 3 * view.curve_offsets[view.curve_count]; ++i) ASSERT_TRUE(std::abs(p[i]) < 20) << i;
}

TEST_F(Junctions, SameBitsUnderAnyWorkersAndBudgets) {
    expect_same_bits([&](const Host& other) {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = other.create(coil(400, 12, 6, 0.1));
        FlgCurveSetStylizeDesc wanted = flgCurveSetStylizeDefaults();
        EXPECT_EQ(flgStyleCreate(other.context, &style, &wanted.style, nullptr), FLG_OK);
        Curves grid;
        for (int i = 0; i < 40; ++i) {
            for (int j = 0; j < 40; ++j) {
                grid.add_point(i, j, 0);
                grid.add_point(i + 1, j, 0);
                grid.end_curve();
                grid.add_point(i, j, 0);
                grid.add_point(i, j + 1, 0);
                grid.end_curve();
            }
        }
        wanted.target = other.create(grid);
        wanted.pin_ends = wanted.smooth_junctions = 1;
        FlgCurveSet out{};
        EXPECT_EQ(flgCurveSetStylize(other.context, &wanted, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        return out;
    });
}

TEST_F(Junctions, NeedPinnedEnds) {
    desc.pin_ends = 0;
    desc.target = host.create(coil());
    FlgCurveSet out{};
    expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "desc.smooth_junctions");
}

}  // namespace
}  // namespace flg::test
