// SPDX-License-Identifier: MIT
#include "documents/contour_file.h"

#include <algorithm>
#include <array>
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

// A ring of a drawing.
struct Ring {
    explicit Ring(std::vector<double> of_points) : points(std::move(of_points)) {
        for (size_t i = 0, before = points.size() - 2; i < points.size(); before = i, i += 2) {
            area += 0.5 * (points[before] * points[i + 1] - points[i] * points[before + 1]);
            for (size_t k = 0; k < 2; ++k) {
                low[k] = std::min(low[k], points[i + k]);
                high[k] = std::max(high[k], points[i + k]);
            }
        }
        area = std::fabs(area);
    }
    double diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1]); }

    bool encloses(double x, double y) const {
        bool is_inside = false;
        for (size_t i = 0, before = points.size() - 2; i < points.size(); before = i, i += 2) {
            const double *a = points.data() + before, *b = points.data() + i;
            if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
                is_inside = !is_inside;
        }
        return is_inside;
    }
    // By a few of its points.
    bool encloses(const Ring& other) const {
        constexpr size_t looks = 64;
        for (size_t k = 0; k < 2; ++k)
            if (other.low[k] < low[k] || other.high[k] > high[k]) return false;
        const size_t count = other.points.size() / 2, step = std::max<size_t>(1, count / looks);
        for (size_t i = 0; i < count; i += step)
            if (!encloses(other.points[2 * i], other.points[2 * i + 1])) return false;
        return true;
    }

    std::vector<double> points;
    double area = 0;
    std::array<double, 2> low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL};
};

void add_ring(ContourArrays& contour, const Ring& ring) {
    contour.points.insert(contour.points.end(), ring.points.begin(), ring.points.end());
    end_ring(contour);
}

bool is_svg(const std::string& path) {
    return ends_with_one_of(path, {".svg", ".SVG"});
}

// `warnings` may be null.
std::vector<Ring> read_svg(const std::string& path, std::vector<std::string>* warnings) {
    FlgCurveFile file = nullptr;
    if (flgCurveFileRead(path.c_str(), nullptr, &file) < 0) throw InputError(flgIoErrorGetMessage());
    const std::unique_ptr<FlgCurveFileT, decltype(&flgCurveFileRelease)> owner(file, flgCurveFileRelease);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    if (flgCurveFileGetView(file, &view) < 0) throw InputError(flgIoErrorGetMessage());
    const FlgColumn& column = view.columns[0];  // positions
    const size_t stride = column.stride == 0 ? 3 : column.stride / sizeof(float);
    std::vector<Ring> rings;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        std::vector<double> points;
        for (size_t i = view.curve_offsets[c]; i < view.curve_offsets[c + 1]; ++i)
            points.insert(points.end(), {column.data[i * stride], column.data[i * stride + 1]});
        if (!points.empty()) rings.emplace_back(std::move(points));
    }
    FlgCurveFileInfo info = flgCurveFileInfoDefaults();
    if (warnings != nullptr && flgCurveFileGetInfo(file, &info) == FLG_OK)
        for (uint32_t i = 0; i < info.warning_count; ++i) warnings->push_back(path + ": " + info.warnings[i]);
    if (rings.empty()) throw InputError(path + ": has no outline");
    return rings;
}

// Numbers of rings, the largest first.
std::vector<size_t> by_area(const std::vector<Ring>& rings) {
    std::vector<size_t> order(rings.size());
    for (size_t r = 0; r < rings.size(); ++r) order[r] = r;
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return rings[a].area != rings[b].area ? rings[a].area > rings[b].area : a < b;
    });
    return order;
}

ContourArrays contour_of_svg(const std::string& path) {
    const std::vector<Ring> rings = read_svg(path, nullptr);
    const size_t largest = by_area(rings).front();
    ContourArrays contour;
    add_ring(contour, rings[largest]);
    for (size_t r = 0; r < rings.size(); ++r)
        if (r != largest) add_ring(contour, rings[r]);
    return contour;
}

Outlines outlines_of_svg(const std::string& path) {
    constexpr double speck = 1.0 / 100;
    constexpr size_t none = SIZE_MAX;
    Outlines out;
    std::vector<Ring> rings = read_svg(path, &out.warnings);
    const auto leave_out = [&](const std::string& what, const auto& is_left_out) {
        const size_t count = std::erase_if(rings, is_left_out);
        if (count == 1) out.warnings.push_back(path + ": 1 outline is " + what + " and left out");
        if (count > 1)
            out.warnings.push_back(path + ": " + std::to_string(count) + " outlines are " + what + " and left out");
    };
    leave_out("a line", [](const Ring& ring) { return ring.points.size() < 6; });
    std::vector<double> corners;
    for (const Ring& ring : rings) {
        corners.insert(corners.end(), ring.low.begin(), ring.low.end());
        corners.insert(corners.end(), ring.high.begin(), ring.high.end());
    }
    if (rings.empty()) throw InputError(path + ": has no outline, only lines");
    const double smallest = speck * Ring(corners).diagonal();
    leave_out("smaller than 1/100 of the drawing", [&](const Ring& ring) { return ring.diagonal() < smallest; });
    const std::vector<size_t> order = by_area(rings);
    std::vector<size_t> parent(rings.size(), none);  // the smallest that encloses it
    std::vector<bool> is_hole(rings.size(), false);
    for (size_t i = 0; i < order.size(); ++i) {
        const size_t ring = order[i];
        for (size_t k = i; k-- > 0 && parent[ring] == none;)
            if (rings[order[k]].encloses(rings[ring])) parent[ring] = order[k];
        is_hole[ring] = parent[ring] != none && !is_hole[parent[ring]];
    }
    std::vector<size_t> contour_of(rings.size());
    for (size_t r = 0; r < rings.size(); ++r) {
        if (is_hole[r]) continue;
        contour_of[r] = out.contours.size();
        add_ring(out.contours.emplace_back(), rings[r]);
    }
    for (size_t r = 0; r < rings.size(); ++r)
        if (is_hole[r]) add_ring(out.contours[contour_of[parent[r]]], rings[r]);
    return out;
}

}  // namespace

ContourArrays read_contour_file(const std::string& path) {
    if (is_svg(path)) return contour_of_svg(path);
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

Outlines read_outlines(const std::string& path) {
    if (is_svg(path)) return outlines_of_svg(path);
    return {{read_contour_file(path)}, {}};
}

}  // namespace flg::cli
