// SPDX-License-Identifier: MIT
#include "chosen_scales.h"

#include <algorithm>

#include "documents/failure.h"

namespace flg::cli {
namespace {

constexpr float kRadiusPerSwing = 0.14f;  // as flgCurveSetGetScales has it

}  // namespace

float ChosenScales::radius_at(float scale) const {
    return kRadiusPerSwing * rms * scale;
}

float ChosenScales::median() const {
    std::vector<float> sorted = scales;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

void ChosenScales::describe(Report& report) const {
    const auto [least, most] = std::minmax_element(scales.begin(), scales.end());
    report.quality["scale"] = {{"min", *least}, {"median", median()}, {"max", *most}};
}

ChosenScales scales_of(FlgContext context, FlgStyle style, FlgCurveSet result) {
    FlgCurveSetScales scales = flgCurveSetScalesDefaults();
    check(flgCurveSetGetScales(context, result, &scales), "result");
    FlgStyleInfo info = flgStyleInfoDefaults();
    check(flgStyleGetInfo(context, style, &info), "style");
    return {{scales.scales, scales.scales + scales.curve_count}, info.displacement_rms};
}

ChosenScales choose_scales(Session& session, FlgStyle style, const FlgCurveSetView& curves, const std::string& name,
                           Report& report) {
    FlgContext context = session.context();
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style;
    desc.scale = 0.0f;
    check(flgCurveSetCreate(context, &curves, &desc.target), name);
    FlgCurveSet result = {};
    FlgJob job = {};
    check(flgCurveSetStylize(context, &desc, &result, &job), name);
    const Session::Pending pending[] = {{job, name}};
    session.finish(pending, report);
    ChosenScales chosen = scales_of(context, style, result);
    check(flgCurveSetRelease(context, result), name);
    check(flgCurveSetRelease(context, desc.target), name);
    return chosen;
}

}  // namespace flg::cli
