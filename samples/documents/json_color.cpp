// SPDX-License-Identifier: MIT
#include "documents/json_color.h"

#include <cmath>

namespace flg::cli {
namespace {

float linear_of_srgb(uint32_t byte) {
    const double v = byte / 255.0;
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

}  // namespace

void read_color(const JsonPlace& place, float* color) {
    if (place.is_array()) {
        const std::vector<JsonPlace> numbers = place.items();
        if (numbers.size() != 3) place.fail("must be `#rrggbb` or three numbers");
        for (size_t k = 0; k < 3; ++k) color[k] = numbers[k].number(0, 1);
        return;
    }
    const std::string text = place.is_string() ? place.text() : "";
    const bool is_hex =
        text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!is_hex) place.fail("must be `#rrggbb` or three numbers");
    const auto value = static_cast<uint32_t>(std::stoul(text.substr(1), nullptr, 16));
    for (uint32_t k = 0; k < 3; ++k) color[k] = linear_of_srgb(value >> (16 - 8 * k) & 255);
}

}  // namespace flg::cli
