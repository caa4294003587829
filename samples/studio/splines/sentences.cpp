// SPDX-License-Identifier: MIT
#include "splines/sentences.h"

#include <cctype>

namespace flg::studio::splines {
std::string in_words(const std::string& sentence, const std::vector<Obstacle>& obstacles) {
    const std::string argument = "desc.points: ";
    std::string out;
    for (size_t i = sentence.starts_with(argument) ? argument.size() : 0; i < sentence.size();) {
        if (std::isdigit(static_cast<unsigned char>(sentence[i])) == 0) {
            out += sentence[i++];
            continue;
        }
        size_t end = i;
        while (end < sentence.size() && std::isdigit(static_cast<unsigned char>(sentence[end])) != 0) ++end;
        const std::string digits = sentence.substr(i, end - i);
        i = end;
        const bool is_number = digits.size() < 8;
        const size_t number = is_number ? std::stoul(digits) : 0;
        const bool second = out.find("points ") != std::string::npos && out.ends_with(" and ");
        if (is_number && out.ends_with("keys[") && i < sentence.size() && sentence[i] == ']') {
            out.resize(out.size() - std::string("keys[").size());
            out += "key " + std::to_string(number + 1);
            ++i;
        } else if (is_number && out.ends_with("obstacle ") && number < obstacles.size()) {
            out.resize(out.size() - std::string("obstacle ").size());
            out += obstacles[number].name;
        } else if (is_number && (out.ends_with("point ") || out.ends_with("points ") || second)) {
            out += std::to_string(number + 1);
        } else {
            out += digits;
        }
    }
    return out;
}

}  // namespace flg::studio::splines
