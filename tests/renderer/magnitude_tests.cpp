// SPDX-License-Identifier: MIT
// Magnitude changed on the device shows what stylizing anew at that magnitude would.
#include <algorithm>
#include <limits>

#include "curves.h"
#include "filigree/filigree.hpp"

namespace flg::render::test {
namespace {

constexpr float shifted_m = 10.0f;

// Curves with displacements as the host may have them: no stylization involved.
struct Displaced {
    Curves curves;
    std::vector<float> displacements;

    void add(glm::vec3 position, glm::vec3 displacement) {
        curves.add(position);
        displacements.insert(displacements.end(), {displacement.x, displacement.y, displacement.z});
    }
    FlgCurveSetView view() {
        FlgCurveSetView v = curves.view();
        curves.columns.push_back({FLG_ATTRIBUTE_DISPLACEMENT, 3, displacements.data(), 0, 0});
        v.columns = curves.columns.data();
        v.column_count = static_cast<uint32_t>(curves.columns.size());
        return v;
    }
    Curves at(float offset) const {
        Curves moved = curves;
        for (size_t i = 0; i < displacements.size(); ++i) moved.positions[i] += offset * displacements[i];
        return moved;
    }
};

class MagnitudeTest : public RendererTest {
protected:
    // An open helix and a closed trefoil in loops that turn all the way round, so that frames are put to the test.
    filigree::CurveSet stylized(float magnitude) {
        Curves loops;
        for (int i = 0; i < 300; ++i) {
            const float u = static_cast<float>(i) / 299, angle = 20 * pi * u;
            const float size = 0.05f + 0.02f * std::sin(7 * u);
            loops.add({u + size * std::sin(angle), size * std::cos(angle), 0.5f * size * std::sin(0.5f * angle)});
        }
        loops.end();
        Curves targets = helix(400);
        for (int i = 0; i < 400; ++i) {
            const float t = 2 * pi * static_cast<float>(i) / 400;
            targets.add({0.25f * (std::sin(t) + 2 * std::sin(2 * t)), 0.25f * (std::cos(t) - 2 * std::cos(2 * t)),
                         -0.25f * std::sin(3 * t)});
        }
        targets.end(true);
        const filigree::CurveSet example = context_.curve_set(loops.view()),
                                 target = context_.curve_set(targets.view());
        FlgStyleDesc style_desc = flgStyleDefaults();
        style_desc.style = example.get();
        style_desc.point_count = 300;
        const filigree::Style style = context_.style(style_desc);
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = style.get();
        desc.target = target.get();
        desc.magnitude = magnitude;
        desc.scale = 3;
        desc.keep_displacement = 1;
        filigree::CurveSet result = context_.stylize(desc);
        context_.run();
        return result;
    }

    // How unlike two pictures look: of the blocks of 4 x 4 pixels with something in them, the share whose mean colours
    // differ by more than a tenth. Ribbons that turn fast are not flat between two points, tubes not quite round: edges
    // may differ.
    static double difference(const Image& a, const Image& b, const Image& empty) {
        constexpr uint32_t block = 4;
        constexpr int most = block * block * 255 / 10;
        uint32_t filled = 0, differing = 0;
        for (uint32_t top = 0; top < a.height; top += block)
            for (uint32_t left = 0; left < a.width; left += block) {
                bool has_curve = false;
                int sum[3] = {};
                for (uint32_t i = 0; i < block * block; ++i) {
                    const uint32_t x = left + i % block, y = top + i / block;
                    const uint8_t *in_a = a.at(x, y), *in_b = b.at(x, y);
                    has_curve |= std::memcmp(in_a, empty.at(x, y), 4) || std::memcmp(in_b, empty.at(x, y), 4);
                    for (int c = 0; c < 3; ++c) sum[c] += in_a[c] - in_b[c];
                }
                filled += has_curve;
                differing += std::max({std::abs(sum[0]), std::abs(sum[1]), std::abs(sum[2])}) > most;
            }
        return static_cast<double>(differing) / std::max(filled, 1u);
    }

    Image picture_of(const FlgCurveSetView& view, const CurveLook& look, const Camera& camera, float offset = 0) {
        Target target(renderer, picture_size, picture_size);
        const CurvesId id = renderer.upload(view, look);
        if (offset != 0) renderer.set_magnitude_offset(id, offset);
        const Image image = picture(target, camera);
        renderer.remove(id);
        return image;
    }

    filigree::Context context_ = filigree::Context::create();
};

TEST_F(MagnitudeTest, ShowsWhatStylizingAnewShows) {
    const Camera camera{{1.5f, 2.5f, 3.5f}, {0, 0.5f, 0}, {0, 1, 0}, default_fov_y_rad};
    constexpr float magnitudes[] = {0, 0.5f, 1, 1.5f};
    std::vector<filigree::CurveSet> sets;
    for (const float magnitude : magnitudes) sets.push_back(stylized(magnitude));
    without_ground();
    const Image empty = picture_of(Curves().view(), {}, camera);
    for (const Shape shape : {Shape::ribbon, Shape::tube, Shape::line}) {
        const CurveLook look{.shape = shape, .radius = 0.03f};
        std::vector<Image> anew;
        for (const filigree::CurveSet& set : sets) anew.push_back(picture_of(set.view(), look, camera));
        for (const int from : {0, 2})
            for (int to = 0; to < 4; ++to) {
                if (to == from) continue;
                const Image shown = picture_of(sets[from].view(), look, camera, magnitudes[to] - magnitudes[from]);
                // 0.03 and more for ribbons that are not followed, or follow the curve as it was uploaded.
                EXPECT_LT(difference(shown, anew[to], empty), shape == Shape::ribbon ? 0.02 : 0.005);
                EXPECT_GT(difference(anew[from], anew[to], empty), 0.5) << "of a change there would be nothing to see";
            }
    }
}

TEST_F(MagnitudeTest, ShadowsFollow) {
    const Camera camera{{1.5f, 2.5f, 3.5f}, {0, 0.5f, 0}, {0, 1, 0}, default_fov_y_rad};
    const filigree::CurveSet before = stylized(0), after = stylized(1);
    const CurveLook look{.shape = Shape::tube, .radius = 0.03f};
    const Image empty = picture_of(Curves().view(), look, camera);
    Target target(renderer, picture_size, picture_size);
    const CurvesId id = renderer.upload(before.view(), look);
    picture(target, camera);  // with the shadow as uploaded
    renderer.set_magnitude_offset(id, 1);
    const Image shown = picture(target, camera);
    renderer.remove(id);
    EXPECT_LT(difference(shown, picture_of(after.view(), look, camera), empty), 0.005);
}

TEST_F(MagnitudeTest, ThereAndBackIsThePictureBeforeAndUploadsNothing) {
    const filigree::CurveSet set = stylized(1);
    Target target(renderer, picture_size, picture_size);
    const CurvesId id = renderer.upload(set.view());
    const Image before = picture(target);
    EXPECT_GT(renderer.stats().uploaded_bytes, 0u);
    for (const float offset : {0.7f, -2.0f}) {
        renderer.set_magnitude_offset(id, offset);
        EXPECT_GT(differing_pixels(picture(target), before), 500u);
        EXPECT_EQ(renderer.stats().uploaded_bytes, 0u);
    }
    renderer.set_magnitude_offset(id, 0);
    EXPECT_EQ(picture(target).pixels, before.pixels);
    renderer.set_magnitude_offset(id, 1);
    renderer.update(id, set.view());
    EXPECT_EQ(picture(target).pixels, before.pixels) << "an update begins with the offset 0";
}

TEST_F(MagnitudeTest, BoundsAreThoseOfTheCurvesShown) {
    constexpr float from = 1;
    const filigree::CurveSet set = stylized(from);
    const CurveLook look{.shape = Shape::tube, .radius = 0.1f};
    const CurvesId id = renderer.upload(set.view(), look);
    Renderer other(options());
    for (const float magnitude : {-2.0f, -1.0f, 0.0f, 0.3f, 1.0f, 2.0f, 2.5f, 4.0f}) {
        renderer.set_magnitude_offset(id, magnitude - from);
        const Box bounds = renderer.bounds();
        other.clear();
        const filigree::CurveSet anew = stylized(magnitude);
        other.upload(anew.view(), look);
        const Box expected = other.bounds();
        const bool exact = std::abs(magnitude - from) <= 2 && magnitude == std::floor(magnitude);
        const float larger = exact ? 1e-5f : 0.2f * expected.diagonal();
        for (int i = 0; i < 3; ++i) {
            EXPECT_LE(bounds.min[i], expected.min[i] + 1e-5f) << magnitude;
            EXPECT_GE(bounds.max[i], expected.max[i] - 1e-5f) << magnitude;
            EXPECT_GE(bounds.min[i], expected.min[i] - larger) << magnitude;
            EXPECT_LE(bounds.max[i], expected.max[i] + larger) << magnitude;
        }
    }
    expect_silence(other);
}

// Nothing of the curve as uploaded is in the picture.
TEST_F(MagnitudeTest, CurvesComeIntoSight) {
    Displaced bar;
    for (int i = 0; i <= 300; ++i) bar.add({0.004f * static_cast<float>(i) - 0.6f, -shifted_m, 0}, {0, shifted_m, 0});
    bar.curves.end();
    without_ground();
    const CurveLook look{.shape = Shape::tube, .radius = 0.1f};
    const Image empty = picture_of(Curves().view(), look, front_camera());
    const Image shown = picture_of(bar.view(), look, front_camera(), 1);
    Curves moved = bar.at(1);
    EXPECT_LT(difference(shown, picture_of(moved.view(), look, front_camera()), empty), 0.005);
    EXPECT_GT(differing_pixels(shown, empty), 1000u);
}

// Points that lie so close as uploaded that most are skipped.
TEST_F(MagnitudeTest, DetailComesIntoSight) {
    Displaced zigzag;
    for (int i = 0; i <= 128; ++i) {
        const float u = static_cast<float>(i) / 128 - 0.5f;
        zigzag.add({0.01f * u, 0, 0}, {u, i % 2 ? 0.4f : -0.4f, 0});
    }
    zigzag.curves.end();
    without_ground();
    const CurveLook look{.shape = Shape::line, .line_width_px = 1};
    const Image empty = picture_of(Curves().view(), look, front_camera());
    const Image shown = picture_of(zigzag.view(), look, front_camera(), 1);
    Curves moved = zigzag.at(1);
    EXPECT_LT(difference(shown, picture_of(moved.view(), look, front_camera()), empty), 0.005);
}

// Three points in one place have no direction.
TEST_F(MagnitudeTest, CurvesThatShrinkToAPointAreHarmless) {
    Displaced bar;
    for (int i = 0; i <= 100; ++i) {
        const float x = 0.01f * static_cast<float>(i) - 0.5f;
        bar.add({x, 0, 0}, {-x, 0, 0});
    }
    bar.curves.end();
    for (const Shape shape : {Shape::ribbon, Shape::tube, Shape::line})
        picture_of(bar.view(), {.shape = shape, .radius = 0.05f}, front_camera(), 1);
}

TEST_F(MagnitudeTest, WhatCannotBeUsedIsRefused) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expect_error = [](auto&& action, const char* part) {
        try {
            action();
            ADD_FAILURE() << "no error that says \"" << part << "\"";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    Curves plain = helix(100);
    const CurvesId bare = renderer.upload(plain.view());
    expect_error([&] { renderer.set_magnitude_offset(bare, 1); }, "without a DISPLACEMENT column");
    Displaced bar;
    for (int i = 0; i < 10; ++i) bar.add({static_cast<float>(i), 0, 0}, {0, 1, 0});
    bar.curves.end();
    const CurvesId id = renderer.upload(bar.view());
    for (const float offset : {nan, 1e7f, -std::numeric_limits<float>::infinity()})
        expect_error([&] { renderer.set_magnitude_offset(id, offset); }, "magnitude offset");
    renderer.remove(id);
    expect_error([&] { renderer.set_magnitude_offset(id, 1); }, "no curves with the id");
    bar.displacements[14] = nan;
    expect_error([&] { renderer.upload(bar.view()); }, "Point 4 has a displacement");
}

}  // namespace
}  // namespace flg::render::test
