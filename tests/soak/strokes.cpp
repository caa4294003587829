// SPDX-License-Identifier: MIT
// A live stroke that is drawn, ended and begun again; curves that are stylized.
#include "api/live_inputs.h"
#include "soak/abilities.h"

namespace flg::soak {

namespace {

using test::Curves;

FlgCurveSet create(Stage& stage, Curves curves) {
    const FlgCurveSetView view = curves.view();
    FlgCurveSet set{};
    stage.must(flgCurveSetCreate(stage.context, &view, &set), "flgCurveSetCreate");
    return set;
}

void release(Stage& stage, FlgCurveSet& set) {
    if (set.id != 0) stage.must(flgCurveSetRelease(stage.context, set), "flgCurveSetRelease");
    set = {};
}

FlgStyle create_style(Stage& stage) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = create(stage, test::coil());
    FlgStyle style{};
    FlgJob job{};
    stage.must(flgStyleCreate(stage.context, &desc, &style, nullptr), "flgStyleCreate");
    stage.must(flgStyleWarm(stage.context, style, 0, nullptr, &job), "flgStyleWarm");
    bool made = false;
    while (!stage.done(job, &made)) {
        flgContextWait(stage.context, 10000);
        stage.must(flgContextTick(stage.context, FLG_UNLIMITED, nullptr), "flgContextTick");
    }
    release(stage, desc.style);
    return style;
}

class Drawing : public Ability {
public:
    explicit Drawing(Stage& on) : Ability(on), style_(create_style(on)) {}

    void frame() override {
        if (!end_if_done()) return;
        if (stroke_.id == 0) begin();
        test::LiveSample sample{};
        test::hand_position(0.006 * samples_, sample.position);
        sample.pressure = 0.5f;
        sample.time = samples_ / 90.0;
        FlgCurveSetView view = flgCurveSetViewDefaults();
        stage.must(test::push_samples(stage.context, stroke_, &sample, 1, &view), "flgLiveStrokePush");
        if (++samples_ % 50 == 49) {
            stage.must(flgLiveStrokeUndo(stage.context, stroke_, 10, nullptr), "flgLiveStrokeUndo");
            samples_ -= 10;
        }
        if (stage.draw(250) == 0) end();
    }
    bool rest() override {
        if (!end_if_done()) return false;
        if (stroke_.id != 0) end();
        return stroke_.id == 0;
    }

private:
    void begin() {
        FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
        desc.style = style_;
        desc.scale = 0.3f;
        desc.max_samples = 4096;
        desc.max_points = 32768;
        stage.must(flgLiveStrokeBegin(stage.context, &desc, &stroke_), "flgLiveStrokeBegin");
        samples_ = 0;
    }
    void end() {
        if (samples_ == 0) return;
        stage.must(flgLiveStrokeEnd(stage.context, stroke_, nullptr, &stylized_, &recorded_, &job_),
                   "flgLiveStrokeEnd");
        ended_ = true;
    }
    // Whether the stroke is drawn, or there is none.
    bool end_if_done() {
        bool made = false;
        if (!stage.done(job_, &made)) return false;
        if (!ended_) return true;
        ended_ = false;
        release(stage, stylized_);
        release(stage, recorded_);
        stage.must(flgLiveStrokeRelease(stage.context, stroke_), "flgLiveStrokeRelease");
        stroke_ = {};
        return true;
    }

    const FlgStyle style_;
    FlgLiveStroke stroke_{};
    FlgCurveSet stylized_{}, recorded_{};
    FlgJob job_{};
    bool ended_ = false;
    int samples_ = 0;
};

class Stylizing : public Ability {
public:
    explicit Stylizing(Stage& on) : Ability(on), style_(create_style(on)), target_(create(on, test::arcs(40))) {}

    void frame() override {
        if (!rest()) return stage.cancel_at_random(job_);
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = style_;
        desc.target = target_;
        desc.seed = stage.draw(1000);
        desc.temperature = static_cast<float>(stage.draw(3));
        desc.scale = 0.5f;
        FlgJobOptions options = flgJobOptionsDefaults();
        options.priority = FLG_PRIORITY_LOW;
        desc.job = &options;
        stage.must(flgCurveSetStylize(stage.context, &desc, &made_, &job_), "flgCurveSetStylize");
        stage.cancel_at_random(job_);
    }
    bool rest() override {
        bool made = false;
        if (!stage.done(job_, &made)) return false;
        FlgCurveSetView view = flgCurveSetViewDefaults();
        if (made) stage.must(flgCurveSetGetView(stage.context, made_, &view), "flgCurveSetGetView");
        release(stage, made_);
        return true;
    }

private:
    const FlgStyle style_;
    const FlgCurveSet target_;
    FlgCurveSet made_{};
    FlgJob job_{};
};

}  // namespace

std::unique_ptr<Ability> draw_strokes(Stage& stage) {
    return std::make_unique<Drawing>(stage);
}
std::unique_ptr<Ability> stylize_curves(Stage& stage) {
    return std::make_unique<Stylizing>(stage);
}

}  // namespace flg::soak
