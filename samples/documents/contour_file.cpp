// SPDX-License-Identifier: MIT
#include "documents/contour_file.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>

#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/text_lines.h"
#include "filigree/filigree_io.h"

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
        if (error != std::errc() || !is_apart || numbers.size() == 4)
            fail(path, line, quoted_line(text) + " is no point");
        numbers.push_back(value);
        at = next;
    }
    return numbers;
}

void end_ring(ContourArrays& contour) {
    const auto points = static_cast<uint32_t>(contour.points.size() / 2);
    if (points != contour.offsets.back()) contour.offsets.push_back(points);
}

double doubled_area(const std::vector<double>& points, uint32_t begin, uint32_t end) {
    double sum = 0;
    for (size_t i = begin; i < end; ++i) {
        const double *a = points.data() + 2 * i, *b = points.data() + 2 * (i + 1 == end ? begin : i + 1);
        sum += a[0] * b[1] - a[1] * b[0];
    }
    return std::fabs(sum);
}

void put_first(ContourArrays& contour, uint32_t ring) {
    ContourArrays sorted;
    const auto add = [&](uint32_t r) {
        const auto begin = contour.points.begin() + 2 * static_cast<ptrdiff_t>(contour.offsets[r]);
        const auto end = contour.points.begin() + 2 * static_cast<ptrdiff_t>(contour.offsets[r + 1]);
        sorted.points.insert(sorted.points.end(), begin, end);
        end_ring(sorted);
    };
    add(ring);
    for (uint32_t r = 0; r + 1 < contour.offsets.size(); ++r) {
        if (r != ring) add(r);
    }
    contour = std::move(sorted);
}

ContourArrays read_svg(const std::string& path) {
    FlgCurveFile file = nullptr;
    if (flgCurveFileRead(path.c_str(), nullptr, &file) < 0) throw InputError(flgIoErrorGetMessage());
    const std::unique_ptr<FlgCurveFileT, decltype(&flgCurveFileRelease)> owner(file, flgCurveFileRelease);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    if (flgCurveFileGetView(file, &view) < 0) throw InputError(flgIoErrorGetMessage());
    const FlgColumn& column = view.columns[0];  // positions
    const size_t stride = column.stride == 0 ? 3 : column.stride / sizeof(float);
    ContourArrays contour;
    uint32_t largest = 0;
    double most = 0;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        for (size_t i = view.curve_offsets[c]; i < view.curve_offsets[c + 1]; ++i)
            contour.points.insert(contour.points.end(), {column.data[i * stride], column.data[i * stride + 1]});
        end_ring(contour);
        const auto ring = static_cast<uint32_t>(contour.offsets.size()) - 2;
        const double area = doubled_area(contour.points, contour.offsets[ring], contour.offsets[ring + 1]);
        if (area > most) {
            most = area;
            largest = ring;
        }
    }
    put_first(contour, largest);
    return contour;
}

}  // namespace

ContourArrays read_contour_file(const std::string& path) {
    if (ends_with_one_of(path, {".svg", ".SVG"})) return read_svg(path);
    std::ifstream file(path);
    if (!file) throw InputError(path + ": can't be opened: " + std::strerror(errno));
    ContourArrays contour;
    double announced = 0;  // points, by a sketch's first line
    size_t line = 0;
    for (std::string text; next_line(file, text);) {
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
            if (!(announced >= 1)) fail(path, line, quoted_line(text) + " is no number of points");
            continue;
        }
        if (numbers.size() != (announced > 0 ? 3u : 2u))
            fail(path, line,
                 quoted_line(text) + " is no point: " + (announced > 0 ? "x y z" : "x y") + " are expected");
        if (announced > 0 && !contour.points.empty() && numbers[2] != contour.depth)
            fail(path, line, quoted_line(text) + " is not in the plane of the points before: z must be the same");
        if (announced > 0) contour.depth = numbers[2];
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
