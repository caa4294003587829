// SPDX-License-Identifier: MIT
// What a file of curves holds: lines, or in .glb surfaces, and how exact these are.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "choices.h"
#include "documents/report.h"
#include "filigree/filigree_io.h"

namespace flg::cli {

class SurfaceOptions {
public:
    void add_to(CLI::App& app);
    void describe(Report& report) const;

    // Whether ribbons or tubes were asked for.
    bool is_surface() const { return as_ == Shapes::ribbon || as_ == Shapes::tube; }
    // Of lines, if they are to have the points alone that they need. `shapes` as in write().
    std::optional<float> line_tolerance(const std::string& file, bool all_columns,
                                        const std::vector<FlgCurveGeometry>& shapes) const;
    // Throws UsageError where they have no place.
    void check_usage(const std::string& file, bool all_columns) const;

    // Writes the curves, as surfaces if so. `shapes`, those of painted strokes or empty, are one a curve; `diagonal` is
    // that of the whole. Throws InputError.
    void write(const std::string& file, const FlgCurveSetView& view, FlgCurveFileWriteDesc desc,
               const std::vector<FlgCurveGeometry>& shapes, float diagonal, Report& report) const;

private:
    bool holds_lines(const std::string& file, bool all_columns, const std::vector<FlgCurveGeometry>& shapes) const;

    Shapes as_ = Shapes::automatic;
    std::optional<float> tolerance_;
    bool quantize_ = false;
};

}  // namespace flg::cli
