// SPDX-License-Identifier: MIT
// A style on curves of different sizes: a job for each scale, and their results as one set, in the target's order.
#pragma once

#include "documents/session.h"
#include "filigree/filigree.h"
#include "joined_curves.h"
#include "relative_size.h"

namespace flg::cli {

struct StyledCurves {
    JoinedCurves curves;
    float default_radius;  // metres; of curves that have none
};

// `desc` with its style, which is ready, but without target and scale. Waits for the jobs.
StyledCurves style_by_size(Session& session, FlgCurveSetStylizeDesc desc, const FlgCurveSetView& target,
                           const std::string& target_name, Report& report);

// The style's sizes; it must be ready.
RelativeSize relative_size_of(FlgContext context, FlgStyle style);

// Their least, median and greatest scale into the report's quality.
void describe_scales(const std::vector<CurveSize>& sizes, Report& report);

}  // namespace flg::cli
