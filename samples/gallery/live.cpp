// SPDX-License-Identifier: MIT
// A stroke stylized while it is drawn: what each push of samples made, in its own colour. What is there stays as it is.
#include <deque>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "support/live_sample.h"

namespace flg::gallery {
namespace {

constexpr float kSampleRate = 90.0f;  // hertz
constexpr uint32_t kSamplesAPush = 12;
constexpr uint32_t kStages = 3;

std::vector<samples::LiveSample> hand_samples() {
    std::vector<samples::LiveSample> samples;
    const scenes::Curve stroke = scenes::make_target("flourish", 240);
    for (size_t i = 0; i < stroke.points.size(); ++i) {
        const scenes::Point& p = stroke.points[i];
        samples::LiveSample& sample = samples.emplace_back(samples::LiveSample());
        sample.position[0] = p.x, sample.position[1] = p.y, sample.position[2] = p.z;
        sample.pressure = 0.5f;
        sample.time = static_cast<double>(i) / kSampleRate;
    }
    return samples;
}

void live(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kColors[] = {kTeal, kGold};
    const filigree::Style style = workshop.style(scenes::make_style("curls"));
    style.warm();
    workshop.context().run();
    const FlgCurveSetStylizeDesc size = sized(style, 0.022f);
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = style.get();
    desc.scale = size.scale;
    filigree::LiveStroke stroke = workshop.context().begin(desc);
    const std::vector<samples::LiveSample> samples = hand_samples();

    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    std::vector<Layer> drawn;
    std::vector<scenes::Curve> hand;
    scenes::Point last = {};
    for (uint32_t first = 0, push = 0; first < samples.size(); first += kSamplesAPush, ++push) {
        const FlgCurveSetView made = stroke.push(samples::view_of({&samples[first], kSamplesAPush}));
        scenes::Curve piece;
        if (push > 0) piece.points.push_back(last);
        for (const glm::vec3& p : vectors_of(made)) piece.points.push_back(to_point(p));
        last = piece.points.back();
        sets.push_back(workshop.curve(piece));
        drawn.push_back(shape_of(sets.back().view(), tube(kColors[push % 2], 0.0055f)));
        for (uint32_t i = 0; i < kSamplesAPush; ++i) {
            const float* const p = samples[first + i].position;
            hand.push_back(dot({p[0], p[1], p[2]}));
        }
        if (first + kSamplesAPush < samples.size() * (panels.size() + 1) / kStages) continue;
        sets.push_back(workshop.curves(hand));
        Panel& panel = panels.emplace_back();
        panel.layers = drawn;
        panel.layers.push_back(shape_of(sets.back().view(), tube(kInk, 0.0080f)));
        panel.layers.back().look.in_front = true;  // curls would hide them
        panel.sight = {-0.05f, -0.1f, -1.0f};
    }
    aim_together(panels);
    panels[0].keys = {{kInk, "samples"}, {kTeal, "made by one push"}, {kGold, "by the next"}};
    entitle(panels, {"After a third of the samples", "Two thirds: what is there stays", "All of them"});
    studio.take("live", panels, 1, 720, 860);
}

constexpr Picture kPictures[] = {
    {"live", "A live stroke after a third, two thirds and all of its samples; a colour for each push", true, live},
};

}  // namespace

std::span<const Picture> live_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
