// SPDX-License-Identifier: MIT
#include "apply_options.h"

#include "choices.h"

namespace flg::cli {
namespace {

constexpr int kBasisNumbers = 9;
const std::string kAuto = "auto";

const std::map<std::string, FlgStyleStart> kStarts = {
    {"auto", FLG_STYLE_START_AUTO}, {"style", FLG_STYLE_START_STYLE}, {"random", FLG_STYLE_START_RANDOM}};

}  // namespace

void ApplyOptions::add_to(CLI::App& app, const std::map<std::string, FlgFrameMethod>& frames,
                          const std::string& frame_help) {
    frames_ = &frames;
    app.add_option("--sigma", magnitude_, "Factor on the displacement; any finite number, 0 = the bare curves")
        ->capture_default_str()
        ->check(finite());
    app.add_option("--tau", temperature_,
                   "Temperature, >= 0: 0 copies long runs of the style, higher jumps more often; 1 = the median "
                   "distance of a patch to the one most like it")
        ->capture_default_str()
        ->check(at_least_zero());
    app.add_option_function<std::string>(
           "--scale",
           [this](const std::string& text) { scale_ = text == kAuto ? 0.0f : static_cast<float>(std::stod(text)); },
           "Size of the style on the curves, > 0; 1 = as drawn. auto or 0: each curve gets it in the proportion that "
           "the example has, and as wide as its stroke where it has a radius; its line is thinner than the stroke then")
        ->type_name("S|auto")
        ->default_str(kAuto)
        ->check(auto_or(above_zero()));
    add_choice(app, "--frame", frame_, frames, frame_help);
    app.add_option("--basis", basis_,
                   "3 x 3 row by row: turns the style (tangent, first and second normal) within the curves' frame")
        ->delimiter(',')
        ->expected(kBasisNumbers)
        ->type_name("B11,...,B33")
        ->check(finite());
    add_choice(app, "--start", start_, kStarts,
               "Where on the style a curve begins: its start, at random, or auto: its start for a lone curve and for "
               "strokes that are drawn");
}

void ApplyOptions::describe(Report& report) const {
    report.parameters["sigma"] = as_written(magnitude_);
    report.parameters["tau"] = as_written(temperature_);
    if (scale_ > 0.0f) {
        report.parameters["scale"] = as_written(scale_);
    } else {
        report.parameters["scale"] = kAuto;
    }
    report.parameters["frame"] = name_of(*frames_, frame_);
    report.parameters["start"] = name_of(kStarts, start_);
    for (float value : basis_) report.parameters["basis"].push_back(as_written(value));
}

}  // namespace flg::cli
