// SPDX-License-Identifier: MIT
#include "api/style_drives.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "api/error.h"
#include "api/inputs.h"
#include "core/failure.h"
#include "core/number_text.h"
#include "core/sized_struct.h"

namespace flg {

namespace {

constexpr float factor_max = 1e30f;
// Of all scales together: what coordinates can be told apart by.
constexpr double scale_min = 1e-30, scale_max = 1e30;

[[noreturn]] void refuse(uint32_t index, const char* field, float value, const char* allowed) {
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.drives[%u].%s is %s, must be %s", index, field,
                  NumberText(value).c_str(), allowed);
}

void check_value(FlgStyleDriven driven, float value, uint32_t index, const char* field) {
    if (!(std::abs(value) <= factor_max)) refuse(index, field, value, "finite and at most 1e30 in size");
    if (driven == FLG_STYLE_DRIVEN_SCALE && !(value > 0)) refuse(index, field, value, "above 0");
    const bool negative = driven == FLG_STYLE_DRIVEN_MAGNITUDE;
    if (!negative && value < 0) refuse(index, field, value, "at least 0");
}

void check_drive(const FlgStyleDrive& drive, uint32_t index) {
    char argument[48];
    std::snprintf(argument, sizeof argument, "desc.drives[%u].driven", index);
    check_enum(drive.driven, FLG_STYLE_DRIVEN_MAGNITUDE, FLG_STYLE_DRIVEN_STYLE, argument, "FLG_STYLE_DRIVEN_");
    if (!(std::abs(drive.from) <= factor_max)) refuse(index, "from", drive.from, "finite and at most 1e30 in size");
    if (!(std::abs(drive.to) <= factor_max)) refuse(index, "to", drive.to, "finite and at most 1e30 in size");
    if (drive.from == drive.to) refuse(index, "to", drive.to, "another number than `from`");
    check_value(drive.driven, drive.at_from, index, "at_from");
    check_value(drive.driven, drive.at_to, index, "at_to");
}

}  // namespace

StyleDrives read_drives(const FlgStyleDrive* drives, uint32_t count) {
    check_range(count <= style_drives_max, "desc.drive_count", count, "at most 8");
    if (count == 0) return {};
    require(drives, "desc.drives");
    double least_scale = 1, largest_scale = 1;
    uint32_t temperatures = 0, styles = 0;
    for (uint32_t k = 0; k < count; ++k) {
        const FlgStyleDrive& drive = drives[k];
        check_drive(drive, k);
        if (drive.driven == FLG_STYLE_DRIVEN_TEMPERATURE && ++temperatures > 1) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.drives[%u] drives the temperature, as one before it does",
                          k);
        }
        if (drive.driven == FLG_STYLE_DRIVEN_STYLE && ++styles > 1) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.drives[%u] drives the style, as one before it does", k);
        }
        if (drive.driven != FLG_STYLE_DRIVEN_SCALE) continue;
        least_scale *= std::min(drive.at_from, drive.at_to);
        largest_scale *= std::max(drive.at_from, drive.at_to);
    }
    if (least_scale < scale_min || largest_scale > scale_max) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.drives drive the scale by factors from %g to %g, must be 1e-30 to 1e30", least_scale,
                      largest_scale);
    }
    return StyleDrives({drives, count});
}

void check_style_drive(const StyleDrives& drives, uint32_t further_style_count) {
    const bool chosen = drives.drive(FLG_STYLE_DRIVEN_STYLE);
    if (chosen == (further_style_count > 0)) {
        const auto last = static_cast<float>(further_style_count);
        for (uint32_t k = 0; k < drives.list().size(); ++k) {
            const FlgStyleDrive& drive = drives.list()[k];
            if (drive.driven != FLG_STYLE_DRIVEN_STYLE) continue;
            char allowed[64];
            std::snprintf(allowed, sizeof allowed, "the number of a style, 0 to desc.further_style_count, %u",
                          further_style_count);
            if (drive.at_from > last) refuse(k, "at_from", drive.at_from, allowed);
            if (drive.at_to > last) refuse(k, "at_to", drive.at_to, allowed);
        }
        return;
    }
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.further_style_count is %u, but %s of desc.drives drives the style",
                  further_style_count, chosen ? "one" : "none");
}

StyleArgument::StyleArgument(uint32_t k) {
    if (k == 0) {
        std::snprintf(name, sizeof name, "desc.style");
    } else {
        std::snprintf(name, sizeof name, "desc.further_styles[%u]", k - 1);
    }
}

}  // namespace flg
