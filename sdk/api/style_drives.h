// SPDX-License-Identifier: MIT
// What steers a style along its targets, and which other styles it may turn into, as the host says it.
#pragma once

#include <cmath>

#include "api/inputs.h"
#include "stylization/steering.h"
#include "stylization/style_choice.h"

namespace flg {

// desc.drives, checked but for the columns.
StyleDrives read_drives(const FlgStyleDrive* drives, uint32_t count);

// What a job or a stroke says of styles beside the first.
template <class Desc>
void check_further_styles(const Desc& desc) {
    check_range(desc.further_style_count < styles_max, "desc.further_style_count", desc.further_style_count,
                "at most 7");
    if (desc.further_style_count > 0) require(desc.further_styles, "desc.further_styles");
    check_range(desc.style_blend >= 0 && std::isfinite(desc.style_blend), "desc.style_blend", desc.style_blend,
                "finite and at least 0");
}

// The style is driven where there are several, and nowhere else, and to numbers that they have.
void check_style_drive(const StyleDrives& drives, uint32_t further_style_count);

// What style k of a descriptor is called, in messages.
struct StyleArgument {
    explicit StyleArgument(uint32_t k);
    char name[32];
};

}  // namespace flg
