// SPDX-License-Identifier: MIT
#include "contour_file.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>

#include "failure.h"

namespace flg::cli {
namespace {

[[noreturn]] void fail(const std::string& path, size_t line, const std::string& sentence) {
    throw InputError(path + ":" + std::to_string(line) + ": " + sentence);
}

// The numbers of a line, at most four of them.
std::vector<double> numbers_of(const std::string& path, size_t line, const std::string& text) {
    std::vector<double> numbers;
    const char *at = text.data(), *end = at + text.find_last_not_of(" \t\r") + 1;
    while (at < end) {
        while (*at == ' ' || *at == '\t') ++at;
        double value = 0;
        const auto [next, error] = std::from_chars(at + (*at == '+'), end, value);
        const bool is_apart = next == end || *next == ' ' || *next == '\t';
        if (error != std::errc() || !is_apart || numbers.size() == 4) fail(path, line, "'" + text + "' is no point");
        numbers.push_back(value);
        at = next;
    }
    return numbers;
}

void end_ring(ContourArrays& contour) {
    const auto points = static_cast<uint32_t>(contour.points.size() / 2);
    if (points != contour.offsets.back()) contour.offsets.push_back(points);
}

}  // namespace

ContourArrays read_contour_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw InputError(path + ": can't be opened: " + std::strerror(errno));
    ContourArrays contour;
    double announced = 0;  // points, by a sketch's first line
    size_t line = 0;
    for (std::string text; std::getline(file, text);) {
        ++line;
        const size_t comment = text.find('#');
        if (comment != std::string::npos) text.resize(comment);
        if (text.find_first_not_of(" \t\r") == std::string::npos) {
            if (comment == std::string::npos) end_ring(contour);
            continue;
        }
        const std::vector<double> numbers = numbers_of(path, line, text);
        if (numbers.size() == 1 && contour.points.empty() && announced == 0) {
            announced = numbers[0];
            if (!(announced >= 1)) fail(path, line, "'" + text + "' is no number of points");
            continue;
        }
        if (numbers.size() != (announced > 0 ? 3u : 2u))
            fail(path, line, "'" + text + "' is no point: " + (announced > 0 ? "x y z" : "x y") + " are expected");
        contour.points.insert(contour.points.end(), numbers.begin(), numbers.begin() + 2);
    }
    if (file.bad()) throw InputError(path + ": can't be read");
    end_ring(contour);
    const double points = static_cast<double>(contour.points.size() / 2);
    if (announced > 0 && points != announced) {
        throw InputError(path + ": has " + std::to_string(contour.points.size() / 2) + " points, but line 1 says " +
                         std::to_string(static_cast<long long>(announced)));
    }
    if (contour.points.empty()) throw InputError(path + ": has no points");
    return contour;
}

}  // namespace flg::cli
