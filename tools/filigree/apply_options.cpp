// SPDX-License-Identifier: MIT
#include "apply_options.h"

#include "choices.h"
#include "documents/failure.h"
#include "drive_option.h"
#include "support/curve_source.h"

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
    tau_ = app.add_option("--tau", temperature_,
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
    start_option_ = add_choice(
        app, "--start", start_, kStarts,
        "Where on the style a curve begins: its start, at random, or auto: its start for a lone curve and for "
        "strokes that are drawn");
    app.add_option_function<std::vector<std::string>>(
           "--drive",
           [this](const std::vector<std::string>& words) {
               drives_said_ = words;
               drives_.clear();
               for (const std::string& word : words) drives_.push_back(parse_drive(word));
           },
           "A column of the curves steers the style along them, from A where it is 0 to B where it is 1, or where it "
           "is "
           "FROM and TO: pressure, speed (else from times, m/s), radius, width, time, user0, user1, ...; WHAT is "
           "magnitude, scale or radius, which are factors, temperature, or the number of a style. At most 8 "
           "(pressure=magnitude:0.2:1)")
        ->delimiter(',')
        ->type_name("NAME[:FROM:TO]=WHAT:A:B,...");
}

std::array<float, 2> ApplyOptions::temperatures() const {
    for (const FlgStyleDrive& drive : drives_) {
        if (drive.driven == FLG_STYLE_DRIVEN_TEMPERATURE) return {drive.at_from, drive.at_to};
    }
    return {temperature_, temperature_};
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
    for (const std::string& drive : drives_said_) report.parameters["drive"].push_back(drive);
}

void ApplyOptions::check_usage(size_t styles, bool whole_motifs) const {
    for (const CLI::Option* option : {tau_, start_option_}) {
        if (!whole_motifs || option->count() == 0) continue;
        throw UsageError(option->get_name() +
                         ": whole motifs (--fit, --corners motif) follow one another from the style's start");
    }
    bool chosen = false;
    for (size_t k = 0; k < drives_.size(); ++k) {
        if (drives_[k].driven != FLG_STYLE_DRIVEN_STYLE) continue;
        chosen = true;
        const std::string drive = "--drive " + drives_said_[k];
        if (styles == 1) throw UsageError(drive + ": there is one --style; give several to choose among");
        const float last = static_cast<float>(styles - 1);
        for (const float at : {drives_[k].at_from, drives_[k].at_to}) {
            if (at >= 0.0f && at <= last) continue;
            throw UsageError(drive + ": styles have the numbers 0 to " + std::to_string(styles - 1));
        }
    }
    if (styles > 1 && !chosen) {
        throw UsageError("--style: is given " + std::to_string(styles) +
                         " times, but no --drive NAME=style:A:B chooses among them");
    }
}

void ApplyOptions::check_columns(const FlgCurveSetView& view, const std::string& subject, bool by_hand) const {
    for (size_t k = 0; k < drives_.size(); ++k) {
        const FlgAttribute attribute = drives_[k].attribute;
        const std::string drive = "--drive " + drives_said_[k];
        if (by_hand && attribute != FLG_ATTRIBUTE_PRESSURE && attribute != FLG_ATTRIBUTE_SPEED) {
            throw UsageError(drive + ": a hand that draws has pressure and speed");
        }
        const bool by_times = attribute == FLG_ATTRIBUTE_SPEED;
        const FlgColumn* column = samples::find_column(view, attribute);
        if (column != nullptr && column->components == 1 && !(by_hand && by_times)) continue;
        if (by_times && samples::find_column(view, FLG_ATTRIBUTE_TIME) != nullptr) continue;
        throw InputError(subject + ": " + drive + ": " +
                         (by_times ? "there are no times to tell the speed by" : "there is no such column"));
    }
}

}  // namespace flg::cli
