// SPDX-License-Identifier: MIT
#include "drive_option.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace flg::cli {
namespace {

const std::map<std::string, FlgAttribute> kColumns = {{"pressure", FLG_ATTRIBUTE_PRESSURE},
                                                      {"speed", FLG_ATTRIBUTE_SPEED},
                                                      {"radius", FLG_ATTRIBUTE_RADIUS},
                                                      {"width", FLG_ATTRIBUTE_WIDTH},
                                                      {"time", FLG_ATTRIBUTE_TIME}};
constexpr std::string_view kUser = "user";
const std::map<std::string, FlgStyleDriven> kDriven = {{"magnitude", FLG_STYLE_DRIVEN_MAGNITUDE},
                                                       {"scale", FLG_STYLE_DRIVEN_SCALE},
                                                       {"temperature", FLG_STYLE_DRIVEN_TEMPERATURE},
                                                       {"radius", FLG_STYLE_DRIVEN_RADIUS},
                                                       {"style", FLG_STYLE_DRIVEN_STYLE}};

template <class Number>
std::optional<Number> number_of(std::string_view text) {
    Number number = {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<FlgAttribute> column_of(const std::string& name) {
    if (const auto found = kColumns.find(name); found != kColumns.end()) return found->second;
    if (!name.starts_with(kUser)) return std::nullopt;
    const std::optional<uint32_t> number = number_of<uint32_t>(std::string_view(name).substr(kUser.size()));
    if (!number || *number >= uint32_t{FLG_ATTRIBUTE_FORCE_32BIT} - FLG_ATTRIBUTE_USER) return std::nullopt;
    return static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + *number);
}

struct Side {
    std::string name;
    std::vector<float> numbers;
};

// NAME:NUMBER:...
std::optional<Side> side_of(const std::string& text) {
    const std::vector<std::string> words = CLI::detail::split(text, ':');
    Side side = {words.front(), {}};
    for (size_t i = 1; i < words.size(); ++i) {
        const std::optional<float> number = number_of<float>(words[i]);
        if (!number) return std::nullopt;
        side.numbers.push_back(*number);
    }
    return side;
}

}  // namespace

FlgStyleDrive parse_drive(const std::string& text) {
    const size_t equals = text.find('=');
    const std::optional<Side> by = side_of(text.substr(0, equals));
    const std::optional<Side> what = equals < text.size() ? side_of(text.substr(equals + 1)) : std::nullopt;
    const std::optional<FlgAttribute> column = by ? column_of(by->name) : std::nullopt;
    const auto driven = what ? kDriven.find(what->name) : kDriven.end();
    if (!column || driven == kDriven.end() || (by->numbers.size() != 0 && by->numbers.size() != 2) ||
        what->numbers.size() != 2) {
        throw CLI::ValidationError("--drive", "'" + text +
                                                  "' is not NAME=WHAT:A:B or NAME:FROM:TO=WHAT:A:B with NAME pressure, "
                                                  "speed, radius, width, time, user0, user1, ... and WHAT magnitude, "
                                                  "scale, temperature, radius or style");
    }
    const bool has_range = by->numbers.size() == 2;
    return {*column,          driven->second,  has_range ? by->numbers[0] : 0.0f, has_range ? by->numbers[1] : 1.0f,
            what->numbers[0], what->numbers[1]};
}

}  // namespace flg::cli
