// SPDX-License-Identifier: MIT
// Options that are one of a few words, or a number in a range.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <map>
#include <string>

namespace flg::cli {

template <class T>
std::string name_of(const std::map<std::string, T>& names, T value) {
    for (const auto& [name, meaning] : names) {
        if (meaning == value) return name;
    }
    return "";
}

template <class T>
CLI::Option* add_choice(CLI::App& app, const std::string& option, T& value, const std::map<std::string, T>& names,
                        const std::string& description) {
    std::string words;
    for (const auto& [name, meaning] : names) words += (words.empty() ? "" : "|") + name;
    const auto set = [&value, &names, option, words](const std::string& word) {
        const auto found = names.find(word);
        if (found == names.end()) throw CLI::ValidationError(option, "'" + word + "' is none of " + words);
        value = found->second;
    };
    return app.add_option_function<std::string>(option, set, description)
        ->type_name(words)
        ->default_str(name_of(names, value));
}

// What a .glb of curves holds.
enum class Shapes { automatic, lines, ribbon, tube };

inline const std::map<std::string, Shapes>& shape_names() {
    static const std::map<std::string, Shapes> names = {
        {"auto", Shapes::automatic}, {"lines", Shapes::lines}, {"ribbon", Shapes::ribbon}, {"tube", Shapes::tube}};
    return names;
}

// A float as its shortest decimal, for reports: 0.2, not 0.20000000298.
inline double as_written(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double decimal = 0.0;
    std::from_chars(text, end, decimal);
    return decimal;
}

// CLI::Range lets NaN pass; these do not.
template <class Holds>
CLI::Validator number_that(Holds holds, const std::string& demand) {
    return CLI::Validator(
        [holds, demand](std::string& text) {
            double value = 0.0;
            const bool number = CLI::detail::lexical_cast(text, value);
            const auto kept = static_cast<float>(value);  // as the SDK gets it
            const bool good = number && std::isfinite(kept) && holds(kept);
            return good ? std::string() : "'" + text + "' is not " + demand;
        },
        "");
}

inline CLI::Validator finite() {
    return number_that([](double) { return true; }, "a number from -3.4e38 to 3.4e38");
}
inline CLI::Validator at_least_zero() {
    return number_that([](double v) { return v >= 0.0; }, "a number from 0 to 3.4e38");
}
inline CLI::Validator above_zero() {
    return number_that([](double v) { return v > 0.0; }, "a number above 0, to 3.4e38");
}
inline CLI::Validator between(double low, double high) {
    return number_that([=](double v) { return v > low && v < high; }, "a number between 0 and 1, these excluded");
}
inline CLI::Validator between_including(double low, double high) {
    return number_that([=](double v) { return v >= low && v <= high; }, "a number from 0 to 1");
}

// The word auto, 0 that means the same, or what `number` lets pass.
inline CLI::Validator auto_or(const CLI::Validator& number) {
    return CLI::Validator(
        [number](std::string& text) {
            if (text == "auto" || text == "0") return std::string();
            const std::string fault = number(text);
            return fault.empty() ? fault : fault + ", nor auto";
        },
        "");
}

// CLI11 takes what strtoull takes, which wraps -1 and cuts what is too long.
inline CLI::Validator whole_64_bit() {
    return CLI::Validator(
        [](std::string& text) {
            uint64_t value = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            const bool good = error == std::errc() && end == text.data() + text.size();
            return good ? std::string() : "'" + text + "' is not a whole number from 0 to 18446744073709551615";
        },
        "");
}

}  // namespace flg::cli
