// SPDX-License-Identifier: MIT
// Strokes with settings of their own, and strokes from files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shell/first_steps.h"
#include "shell/side_panel.h"
#include "shell/widgets.h"
#include "strokes/stroke_files.h"
#include "support/curve_source.h"
#include "tools/program.h"

namespace flg::studio {
namespace {

render::Placement stays(const render::Box&) {
    return {};
}

StrokePtr some_stroke() {
    auto stroke = std::make_shared<DrawnStroke>();
    stroke->samples = {{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {0, 1, 0}}};
    return stroke;
}

TEST(StudioStrokes, NumbersGoOnAmongThoseOfTheSameSettings) {
    StrokeLayer layer;
    StrokeSettings red, blue;
    blue.color = {0, 0, 1};
    for (const StrokeSettings& settings : {red, blue, red, red})
        layer.strokes.push_back(layer.made(some_stroke(), settings));
    EXPECT_EQ(layer.strokes[0].settings, layer.strokes[3].settings);
    EXPECT_NE(layer.strokes[0].settings, layer.strokes[1].settings);
    EXPECT_EQ(layer.strokes[1].number, 0u);
    EXPECT_EQ(layer.strokes[3].number, 2u);
    // Erasing one leaves the others' random numbers alone.
    layer.strokes.erase(layer.strokes.begin());
    EXPECT_EQ(layer.made(some_stroke(), red).number, 3u);
}

TEST(StudioStrokes, DocumentsKeepEachStrokesSettings) {
    StrokeDocument document;
    StrokeSettings plain;
    plain.styled = false;
    plain.upright = true;
    for (const StrokeSettings& settings : {StrokeSettings(), plain, StrokeSettings()}) {
        StrokeLayer& layer = document.active_layer();
        layer.strokes.push_back(layer.made(some_stroke(), settings));
    }
    auto sized = std::make_shared<DrawnStroke>(*some_stroke());
    sized->size = 0.25f;
    sized->color = {0.1f, 0.2f, 0.3f};
    document.active_layer().strokes.push_back(document.active_layer().made(sized, plain));
    const nlohmann::json json = to_json(document, {});
    const StrokeDocument read = strokes_from_json(json, {});
    ASSERT_EQ(read.stroke_count(), 4u);
    const std::vector<Stroke>& strokes = read.layers[0].strokes;
    EXPECT_EQ(*strokes[1].settings, plain);
    EXPECT_EQ(strokes[2].number, 1u);
    EXPECT_EQ(strokes[3].settings, strokes[1].settings);
    EXPECT_EQ(strokes[3].drawn->size, sized->size);
    EXPECT_EQ(to_json(read, {}), json);
}

TEST(StudioStrokes, DocumentsOfTheVersionBeforeAreRead) {
    const nlohmann::json part = nlohmann::json::parse(R"({"styles": [], "layers": [{"name": "a", "settings":
        {"style": "curls", "shape": "raw", "standing": true, "scale_cm": 2.0, "magnitude": 1.0, "temperature": 0.0,
         "patch": 10, "radius_mm": 3.0, "seed": 1, "color": [1, 0, 0], "color_end": [0, 0, 1]},
        "strokes": [{"samples": [0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1]},
                    {"samples": [0, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 1]}]}]})");
    const StrokeDocument read = strokes_from_json(part, {});
    ASSERT_EQ(read.stroke_count(), 2u);
    const Stroke& stroke = read.layers[0].strokes[1];
    EXPECT_EQ(stroke.number, 1u);
    EXPECT_EQ(stroke.settings->style, "curls");
    EXPECT_FALSE(stroke.settings->styled);
    EXPECT_TRUE(stroke.settings->upright);
}

TEST(StudioStrokes, OpenedStrokesHaveTheirOwnColoursAndSizes) {
    StrokeDocument document;
    StrokeSettings next;
    ASSERT_TRUE(import_strokes(document, next, stays, "builtin:bouquet"));
    const samples::CurveSource source("builtin:bouquet");
    const FlgCurveSetView& view = source.view();
    const FlgColumn& radii = *samples::find_column(view, FLG_ATTRIBUTE_RADIUS);
    const FlgColumn& colors = *samples::find_column(view, FLG_ATTRIBUTE_COLOR);
    const std::vector<Stroke>& strokes = document.active_layer().strokes;
    ASSERT_EQ(strokes.size(), view.curve_count);
    std::vector<float> largest;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        const Stroke& stroke = strokes[c];
        ASSERT_TRUE(stroke.drawn->size > 0.0f && stroke.drawn->color);
        EXPECT_EQ(stroke.drawn->color->y, samples::value_at(colors, view.curve_offsets[c])[1]);
        // Without a style it is as thick as the file says, at each of its samples.
        StrokeSettings plain = *stroke.settings;
        plain.styled = false;
        const FlgLiveStrokeDesc desc = live_desc(plain, 1.0f, stroke.drawn->size);
        float most = 0.0f;
        for (uint32_t i = 0; i < stroke.drawn->samples.size(); ++i) {
            const float pressure = stroke.drawn->samples[i].pressure;
            const float radius = *samples::value_at(radii, view.curve_offsets[c] + i);
            EXPECT_NEAR(desc.min_radius + (desc.max_radius - desc.min_radius) * pressure, radius, 1e-4f * radius);
            most = std::max(most, radius);
        }
        largest.push_back(most);
    }
    // What is drawn next has the size of most of them.
    std::sort(largest.begin(), largest.end());
    EXPECT_FLOAT_EQ(0.001f * next.radius_mm * kThickness, largest[largest.size() / 2]);
}

TEST(StudioPanels, LengthsAreInTheUnitThatFits) {
    EXPECT_EQ(ui::length_text(0.00021), "0.21 mm");
    EXPECT_EQ(ui::length_text(0.034), "34.0 mm");
    EXPECT_EQ(ui::length_text(-0.253), "-25.3 cm");
    EXPECT_EQ(ui::length_text(2.5), "2.50 m");
}

TEST(StudioPanels, LeaveMostOfASmallWindowToThePicture) {
    SidePanel panel(300.0f, 0.3f);
    EXPECT_EQ(panel.width(1280.0f), 300.0f);
    EXPECT_EQ(panel.width(900.0f), 270.0f);
    EXPECT_EQ(panel.width(400.0f), 180.0f);
    panel.fold(true);
    EXPECT_EQ(panel.width(1280.0f), 0.0f);
}

TEST(StudioFirstSteps, AreShownOnceAndNeverWithoutAFolder) {
    const test::Folder folder;
    EXPECT_TRUE(FirstSteps((folder / "state").string()).shown());
    EXPECT_FALSE(FirstSteps((folder / "state").string()).shown());
    EXPECT_FALSE(FirstSteps("").shown());
}

}  // namespace
}  // namespace flg::studio
