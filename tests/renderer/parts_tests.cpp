// SPDX-License-Identifier: MIT
// Curves of more points than a buffer of the device holds are drawn as if they were not divided.
#include "curves.h"

namespace flg::render::test {
namespace {

void add_all(Curves& to, const Curves& from) {
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    for (size_t c = 0; c < from.flags.size(); ++c) {
        to.offsets.push_back(to.offsets.back() + from.offsets[c + 1] - from.offsets[c]);
        to.flags.push_back(from.flags[c]);
    }
}

// Longer and shorter than a part, open and closed.
Curves mixed() {
    Curves curves;
    add_all(curves, helix(1000));
    Curves knot = trefoil(777);
    for (float& x : knot.positions) x *= 0.3f;
    add_all(curves, knot);
    for (int strand = 0; strand < 30; ++strand) {
        const float x = -1.0f + 0.06f * static_cast<float>(strand);
        for (int i = 0; i < 20 + strand; ++i)
            curves.add({x + 0.01f * std::sin(static_cast<float>(i)), -0.9f + 0.01f * static_cast<float>(i), 0});
        curves.end(strand % 4 == 3);
    }
    return curves;
}

TEST_F(RendererTest, DividedCurvesLookWhole) {
    without_ground();
    Options small = options();
    small.max_points = 128;
    Renderer divided{small};
    divided.set_scene(renderer.scene());
    Curves curves = mixed();
    const uint32_t points = curves.offsets.back();
    std::vector<float> displacements(3 * size_t{points});
    for (uint32_t i = 0; i < points; ++i) displacements[3 * i + 2] = 0.05f * std::sin(0.2f * static_cast<float>(i));
    FlgCurveSetView view = curves.view();
    curves.columns.push_back({FLG_ATTRIBUTE_DISPLACEMENT, 3, displacements.data(), 0, 0});
    view.columns = curves.columns.data();
    view.column_count = 2;
    Target target(renderer, picture_size, picture_size), other(divided, picture_size, picture_size);
    const Image empty = picture(target);
    for (const Shape shape : {Shape::ribbon, Shape::tube, Shape::line}) {
        for (const float offset : {0.0f, 1.0f}) {
            const CurveLook look{.shape = shape, .radius = 0.02f, .line_width_px = 3};
            const CurvesId id = renderer.upload(view, look), parts = divided.upload(view, look);
            renderer.set_magnitude_offset(id, offset);
            divided.set_magnitude_offset(parts, offset);
            divided.draw(other, front_camera());
            const Image whole = picture(target);
            EXPECT_GT(differing_pixels(whole, empty), 5000u);
            EXPECT_EQ(differing_pixels(whole, divided.capture(other)), 0u) << static_cast<int>(shape) << " " << offset;
            EXPECT_EQ(renderer.bounds().min, divided.bounds().min);
            EXPECT_EQ(renderer.bounds().max, divided.bounds().max);
            renderer.remove(id);
            divided.remove(parts);
        }
    }
    expect_silence(divided);
}

TEST_F(RendererTest, PartsHaveRoomForAChunkAndItsNeighbours) {
    Options options_127 = options();
    options_127.max_points = 127;
    expect_error([&] { Renderer r{options_127}; }, "options.max_points is 127");
}

}  // namespace
}  // namespace flg::render::test
