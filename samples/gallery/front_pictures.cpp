// SPDX-License-Identifier: MIT
// What the project's README opens with: an example and a line make a result; a stroke that takes on its style while
// it is drawn; a real sketch before and after.
#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>

#include "gallery/animated_png.h"
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "support/curve_source.h"
#include "support/live_sample.h"

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

scenes::Curve scaled(scenes::Curve curve, float by, const glm::vec3& to) {
    for (scenes::Point& p : curve.points) p = {by * p.x, by * p.y, by * p.z};
    return moved(std::move(curve), to);
}

// ---- An example, a line, and what they make

scenes::Curve bare_line() {
    scenes::Curve curve;
    for (int i = 0; i < 240; ++i) {
        const float u = static_cast<float>(i) / 239.0f, a = 7.2f * u;
        curve.points.push_back({1.1f * u, 0.02f + 0.17f * std::sin(a) + 0.04f * u, 0.0f});
    }
    return curve;
}

void example(Workshop& workshop, Studio& studio) {
    constexpr float kMiddle = 1.30f, kRight = 2.70f;  // metres, where line and result begin
    const scenes::Curve drawn = make_style("loops"), line = bare_line();
    const filigree::Style style = workshop.style(drawn);
    const filigree::CurveSet target = workshop.curve(moved(line, {kRight, 0.0f, 0.0f})),
                             result = workshop.stylize(style, target, sized(style, 0.058f)),
                             shown = workshop.curve(moved(drawn, {0.0f, 0.02f, 0.0f})),
                             plain = workshop.curve(moved(line, {kMiddle, 0.0f, 0.0f}));
    Panel panel;
    panel.layers = {shape_of(shown.view(), tube(kRed, 0.011f)), shape_of(plain.view(), tube(kInk, 0.012f)),
                    shape_of(result.view(), tube(kTeal, 0.011f))};
    constexpr float kLabel = -0.32f;
    panel.notes = {{{0.5f, kLabel, 0.0f}, "draw one example", {}, kRed, 22.0f},
                   {{kMiddle + 0.55f, kLabel, 0.0f}, "give it any line", {}, kInk, 22.0f},
                   {{kRight + 0.55f, kLabel, 0.0f}, "get the line in that style", {}, kTeal, 22.0f},
                   {{1.15f, 0.06f, 0.0f}, "+", {}, kInk, 56.0f},
                   {{2.55f, 0.06f, 0.0f}, "=", {}, kInk, 56.0f}};
    panel.aim = {{-0.06f, -0.36f, 0.0f}, {3.92f, -0.36f, 0.0f}, {-0.06f, 0.34f, 0.0f}, {3.92f, 0.34f, 0.0f}};
    panel.sight = {0.0f, -0.08f, -1.0f};
    panel.margin = 1.0f;
    studio.take("example", {&panel, 1}, 1, kWidth, 230);
}

// ---- Strokes while they are drawn

struct Pass {
    const char* style;
    float size;  // of the displacement, metres
    glm::vec3 color;
    scenes::Curve hand;  // a point a sample
    FlgFrameMethod frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;
};

scenes::Curve sampled(int count, const std::function<glm::vec3(float u)>& place) {
    scenes::Curve curve;
    for (int i = 0; i < count; ++i) {
        curve.points.push_back(to_point(place(static_cast<float>(i) / static_cast<float>(count - 1))));
    }
    return curve;
}

std::vector<Pass> passes() {
    const auto hill = [](float u) {
        return glm::vec3(-0.88f + 1.74f * u, 0.40f + 0.07f * std::sin(7.4f * u + 0.6f), 0.0f);
    };
    const auto sweep = [](float u) { return glm::vec3(-0.86f + 1.7f * u, -0.40f - 0.12f * std::sin(3.2f * u), 0.0f); };
    return {{"curls", 0.032f, kTeal, scaled(make_target("flourish", 230), 0.80f, {0.06f, -0.10f, 0.0f})},
            {"loops", 0.034f, kRed, sampled(140, hill), FLG_FRAME_METHOD_SUPPLIED},
            {"knit", 0.030f, kGold, sampled(120, sweep), FLG_FRAME_METHOD_SUPPLIED}};
}

// Draws passes one after the other, as live strokes, a frame each 15th of a second.
class Drawing {
public:
    Drawing(Workshop& workshop, Studio& studio) : workshop_(workshop), studio_(studio), passes_(passes()) {
        constexpr float kLeft = -1.62f, kSmaller = 0.46f;
        float height = 0.30f;
        for (const Pass& pass : passes_) {
            keep(scaled(make_style(pass.style), kSmaller, {kLeft, height, 0.0f}), tube(pass.color, 0.0060f));
            height -= 0.37f;
        }
    }

    std::vector<Frame> frames() {
        for (const Pass& pass : passes_) draw(pass);
        // The picture as it is finished comes first: some programs show no more.
        frames_.insert(frames_.begin(), {picture(finished_), 2500});
        return std::move(frames_);
    }

private:
    static constexpr uint32_t kWidth = 720, kHeight = 380;

    Layer kept(const scenes::Curve& curve, const render::CurveLook& look) {
        sets_.push_back(workshop_.curve(curve));
        return shape_of(sets_.back().view(), look);
    }
    void keep(const scenes::Curve& curve, const render::CurveLook& look) { finished_.push_back(kept(curve, look)); }

    void draw(const Pass& pass) {
        constexpr uint32_t kSamplesAFrame = 6, kSamplesASecond = 90;
        constexpr uint16_t kFrameMilliseconds = 1000 * kSamplesAFrame / kSamplesASecond;
        const render::CurveLook look = tube(pass.color, 0.0075f);
        const filigree::Style style = workshop_.style(make_style(pass.style));
        style.warm();
        workshop_.context().run();
        FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
        desc.style = style.get();
        desc.scale = sized(style, pass.size).scale;
        desc.frame = pass.frame;
        filigree::LiveStroke stroke = workshop_.context().begin(desc);
        scenes::Curve hand, made;
        for (uint32_t i = 0; i < pass.hand.points.size(); ++i) {
            const scenes::Point& p = pass.hand.points[i];
            samples::LiveSample sample{};
            sample.position[0] = p.x, sample.position[1] = p.y, sample.position[2] = p.z;
            if (pass.frame == FLG_FRAME_METHOD_SUPPLIED)
                sample.orientation[3] = 1.0f;  // the controller is held upright
            sample.pressure = 0.5f;
            sample.time = static_cast<double>(i) / kSamplesASecond;
            for (const glm::vec3& point : vectors_of(stroke.push(samples::view_of(sample))))
                made.points.push_back(to_point(point));
            hand.points.push_back(p);
            if ((i + 1) % kSamplesAFrame != 0 || made.points.empty()) continue;
            std::vector<Layer> layers = finished_;
            layers.push_back(kept(made, look));
            layers.push_back(kept(hand, tube(kInk, 0.0030f)));
            sets_.push_back(workshop_.curve(pen_at(p)));
            layers.push_back({Columns(sets_.back().view()).without(FLG_ATTRIBUTE_COLOR), tube(kInk)});
            frames_.push_back({picture(layers), kFrameMilliseconds});
        }
        sets_.push_back(stroke.end().stylized);
        workshop_.context().run();
        finished_.push_back(shape_of(sets_.back().view(), look));
    }

    // Its point is at `p`.
    static scenes::Curve pen_at(const scenes::Point& p) {
        constexpr int kSteps = 12;
        scenes::Curve pen;
        for (int i = 0; i <= kSteps; ++i) {
            const float u = static_cast<float>(i) / kSteps;
            pen.points.push_back({p.x + 0.12f * u, p.y + 0.20f * u, p.z + 0.10f * u});
            pen.radii.push_back(0.016f * std::min(1.0f, 0.12f + 4.0f * u));
        }
        return pen;
    }

    render::Image picture(std::vector<Layer> layers) {
        Panel panel;
        panel.layers = std::move(layers);
        // The sentence is below, where the pen does not cross it.
        panel.notes = {{{-1.62f, 0.57f, 0.0f}, "Examples", {}, kInk, 17.0f, Align::left},
                       {{0.0f, -0.65f, 0.0f}, "Strokes take on their style while they are drawn", {}, kInk, 17.0f}};
        panel.aim = {{-1.68f, -0.65f, 0.0f}, {0.96f, -0.65f, 0.0f}, {-1.68f, 0.65f, 0.0f}, {0.96f, 0.65f, 0.0f}};
        panel.sight = {-0.05f, -0.10f, -1.0f};
        panel.margin = 1.01f;
        panel.ground = false;
        return studio_.draw(panel, kWidth, kHeight);
    }

    Workshop& workshop_;
    Studio& studio_;
    std::vector<Pass> passes_;
    std::deque<filigree::CurveSet> sets_;
    std::vector<Layer> finished_;
    std::vector<Frame> frames_;
};

void drawing(Workshop& workshop, Studio& studio) {
    write_animated_png(Drawing(workshop, studio).frames(), studio.path_of("drawing"));
}

// ---- A sketch of the user's

constexpr float kDisplacementPerRadius = 1.6f, kRadiusPerRadius = 0.22f;

float mean_radius(const FlgCurveSetView& view) {
    constexpr float kUsual = 0.005f;
    const FlgColumn* const radii = samples::find_column(view, FLG_ATTRIBUTE_RADIUS);
    const uint32_t count = view.curve_offsets[view.curve_count];
    if (radii == nullptr || count == 0) return kUsual;
    double sum = 0.0;
    for (uint32_t i = 0; i < count; ++i) sum += static_cast<double>(*samples::value_at(*radii, i));
    return static_cast<float>(sum / count);
}

constexpr Picture kPictures[] = {
    {"example", "An example stroke, a plain line, and the line in the example's style", true, example},
    {"drawing", "An animation: three live strokes take on their styles while they are drawn", true, drawing},
};

}  // namespace

void before_and_after(const std::string& file, const std::string& credit, Workshop& workshop, Studio& studio) {
    const samples::CurveSource source(file);
    const filigree::CurveSet drawn = workshop.context().curve_set(source.view());
    const filigree::Style style = workshop.style(make_style("loops"));
    const float radius = mean_radius(source.view());
    const filigree::CurveSet result = workshop.stylize(style, drawn, sized(style, kDisplacementPerRadius * radius));
    Panel panels[2];
    panels[0].layers = {{source.view(), tube()}};
    panels[1].layers = {{result.view().get(), tube(kInk, radius, kRadiusPerRadius)}};
    panels[0].title = "A sketch drawn in VR";
    panels[0].credit = credit;
    panels[1].title = "the same strokes in the style of one example";
    for (Panel& panel : panels) panel.sight = {0.6f, -0.25f, 1.0f}, panel.margin = 1.06f;
    aim_together(panels);
    studio.take("sketch", panels, 2, kWidth, 480);
}

std::span<const Picture> front_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
