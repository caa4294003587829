// SPDX-License-Identifier: MIT
#include "surface_options.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "documents/failure.h"
#include "documents/progress.h"

namespace flg::cli {
namespace {

// How far surfaces are from exact ones if nobody says so: this share of the diagonal of the whole, half a pixel of a
// picture
// 5000 pixels wide.
constexpr float kToleranceShare = 1e-4f;
// More is tolerated for larger files than this.
constexpr std::uintmax_t kMaxBytes = 40'000'000;
constexpr int kMaxRounds = 6;
constexpr double kToleranceForSize = 1.5;  // sizes fall as a power of the tolerance, not faster than its inverse

}  // namespace

void SurfaceOptions::add_to(CLI::App& app) {
    add_choice(
        app, "--as", as_, shape_names(),
        "What a .glb holds. auto: of a sketch (.tilt) ribbons where its brushes are flat and tubes where they are "
        "round, of other curves lines");
    app.add_option_function<std::string>(
           "--tolerance",
           [this](const std::string& text) {
               tolerance_.reset();
               if (text != "auto") tolerance_ = static_cast<float>(std::stod(text));
           },
           "How far curves, ribbons and tubes may be from exact ones, metres, >= 0: more makes smaller files. 0: every "
           "point. auto: lines with every point; surfaces within 1/10000 of the diagonal of the whole, or what a file "
           "of "
           "40 MB takes")
        ->type_name("D|auto")
        ->default_str("auto")
        ->check(auto_or(at_least_zero()));
    app.add_flag(
        "--quantize", quantize_,
        "Ribbons and tubes in whole numbers (KHR_mesh_quantization): half the size, for programs that read it");
}

void SurfaceOptions::describe(Report& report) const {
    report.parameters["as"] = name_of(shape_names(), as_);
    if (tolerance_) report.parameters["tolerance"] = as_written(*tolerance_);
    if (quantize_) report.parameters["quantize"] = true;
}

void SurfaceOptions::check_usage(const std::string& file, bool all_columns) const {
    if (is_surface() && !file.ends_with(".glb")) throw UsageError(file + ": only .glb holds ribbons and tubes");
    const bool lines = as_ == Shapes::lines || all_columns || !file.ends_with(".glb");
    if (lines && quantize_) throw UsageError("--quantize: " + file + " holds lines; it is for ribbons and tubes");
}

bool SurfaceOptions::holds_lines(const std::string& file, bool all_columns,
                                 const std::vector<FlgCurveGeometry>& shapes) const {
    const bool by_shapes = as_ == Shapes::automatic && !all_columns && file.ends_with(".glb");
    return !is_surface() && (!by_shapes || shapes.empty());
}

std::optional<float> SurfaceOptions::line_tolerance(const std::string& file, bool all_columns,
                                                    const std::vector<FlgCurveGeometry>& shapes) const {
    if (!tolerance_ || *tolerance_ == 0 || !holds_lines(file, all_columns, shapes)) return {};
    return tolerance_;
}

void SurfaceOptions::write(const std::string& file, const FlgCurveSetView& view, FlgCurveFileWriteDesc desc,
                           const std::vector<FlgCurveGeometry>& shapes, float diagonal, Report& report) const {
    desc.quantize = quantize_;
    if (as_ == Shapes::ribbon) desc.geometry = FLG_CURVE_GEOMETRY_RIBBON;
    if (as_ == Shapes::tube) desc.geometry = FLG_CURVE_GEOMETRY_TUBE;
    const std::vector<uint8_t> geometries(shapes.begin(), shapes.end());
    const bool surface = !holds_lines(file, desc.all_columns != 0, shapes);
    if (surface && !is_surface()) desc.geometries = geometries.data();
    desc.tolerance = tolerance_.value_or(kToleranceShare * diagonal);
    if (!surface && quantize_) {
        throw UsageError("--quantize: " + file +
                         " would hold lines, as the target has no brushes; give --as ribbon or tube");
    }
    for (int round = 0;; ++round) {
        say_step("writing " + file);
        if (flgCurveFileWrite(file.c_str(), &view, &desc) != FLG_OK) throw InputError(flgIoErrorGetMessage());
        if (!surface) return;
        const std::uintmax_t size = std::filesystem::file_size(file);
        if (tolerance_ || size <= kMaxBytes || round == kMaxRounds) break;
        const double over = static_cast<double>(size) / static_cast<double>(kMaxBytes);
        desc.tolerance *= static_cast<float>(std::max(1.5, std::pow(over, kToleranceForSize)));
    }
    report.quality["tolerance"] = desc.tolerance;
}

}  // namespace flg::cli
