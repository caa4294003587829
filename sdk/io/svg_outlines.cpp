// SPDX-License-Identifier: MIT
#include "io/svg_outlines.h"

#include <algorithm>
#include <numbers>

#include "io/svg_numbers.h"

namespace flg::io {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-3;  // of a curve's size
constexpr size_t most_points = size_t{1} << 24;
constexpr size_t most_values = 6;  // of a transform

SvgPoint operator+(const SvgPoint& a, const SvgPoint& b) {
    return {a.x + b.x, a.y + b.y};
}
SvgPoint operator-(const SvgPoint& a, const SvgPoint& b) {
    return {a.x - b.x, a.y - b.y};
}
SvgPoint operator*(double t, const SvgPoint& p) {
    return {t * p.x, t * p.y};
}
double size_of(const SvgPoint& p) {
    return std::max(std::abs(p.x), std::abs(p.y));
}

// Draws a path's commands.
class Pen {
public:
    explicit Pen(uint64_t line) : line_(line) {}

    const SvgPoint& at() const { return at_; }
    void move(const SvgPoint& to) {
        end(false);
        at_ = start_ = to;
    }
    void draw(const SvgPoint& to) {
        if (outline_.points.empty()) add(at_);
        add(to);
        at_ = to;
    }
    void cubic(const SvgPoint& b, const SvgPoint& c, const SvgPoint& d) {
        const SvgPoint a = at_;
        const double size = std::max({size_of(b - a), size_of(c - a), size_of(d - a)});
        const double bend = std::max(size_of(a - 2 * b + c), size_of(b - 2 * c + d));
        // A chord of 1 / n of the way is off by bend * 3 / (4 n^2) at most, along either axis.
        const int pieces = size > 0 ? static_cast<int>(std::ceil(std::sqrt(0.75 * bend / (tolerance * size)))) : 1;
        for (int i = 1; i < pieces; ++i) {
            const double t = double(i) / pieces, s = 1 - t;
            draw(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
        }
        draw(d);
    }
    // As the appendix of SVG on arcs has it.
    void arc(double rx, double ry, double turn_deg, bool large, bool sweep, const SvgPoint& to) {
        rx = std::abs(rx), ry = std::abs(ry);
        const SvgPoint from = at_;
        if (rx == 0 || ry == 0 || (from.x == to.x && from.y == to.y)) return draw(to);
        const double turn = turn_deg * pi / 180, cosine = std::cos(turn), sine = std::sin(turn);
        const SvgPoint half = 0.5 * (from - to), middle = 0.5 * (from + to);
        // In units of the radii, along the axes of the ellipse.
        double x = (cosine * half.x + sine * half.y) / rx, y = (-sine * half.x + cosine * half.y) / ry;
        const double square = x * x + y * y;
        if (square > 1) {
            const double grown = std::sqrt(square);
            rx *= grown, ry *= grown, x /= grown, y /= grown;
        }
        const double out = std::sqrt(std::max(0.0, 1 / std::min(square, 1.0) - 1)) * (large == sweep ? -1 : 1);
        const SvgPoint centre = {out * y, -out * x};
        const double first = std::atan2(y - centre.y, x - centre.x);
        double angle = std::atan2(-y - centre.y, -x - centre.x) - first;
        if (sweep && angle < 0) angle += 2 * pi;
        if (!sweep && angle > 0) angle -= 2 * pi;
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (2 * std::acos(1 - tolerance)))));
        for (int i = 1; i < pieces; ++i) {
            const double a = first + angle * i / pieces;
            const double u = rx * (centre.x + std::cos(a)), v = ry * (centre.y + std::sin(a));
            draw({middle.x + cosine * u - sine * v, middle.y + sine * u + cosine * v});
        }
        draw(to);
    }
    void close() {
        end(true);
        at_ = start_;
    }
    std::vector<SvgOutline> take() {
        end(false);
        return std::move(outlines_);
    }

private:
    void add(const SvgPoint& point) {
        if (++count_ > most_points) fail(FLG_ERROR_LIMIT, line_place(line_), "more than 2^24 points");
        outline_.points.push_back(point);
    }
    void end(bool closed) {
        std::vector<SvgPoint>& points = outline_.points;
        const auto same = [](const SvgPoint& a, const SvgPoint& b) { return a.x == b.x && a.y == b.y; };
        while (closed && points.size() > 1 && same(points.front(), points.back())) points.pop_back();
        outline_.closed = closed;
        if (points.size() > 1) outlines_.push_back(std::move(outline_));
        outline_ = {};
    }

    const uint64_t line_;
    size_t count_ = 0;
    SvgPoint at_, start_;
    SvgOutline outline_;
    std::vector<SvgOutline> outlines_;
};

class PathReader {
public:
    PathReader(std::string_view data, uint64_t line) : numbers_(data, line), pen_(line) {}

    std::vector<SvgOutline> read() {
        char command = 0;
        while (numbers_.more()) {
            if (!numbers_.at_number()) {
                command = numbers_.take();
                if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(command) == std::string_view::npos) {
                    fail(FLG_ERROR_FORMAT, line_place(numbers_.line()), "no command of paths: %s",
                         cited(std::string_view(&command, 1)).c_str());
                }
                if (first_ && command != 'M' && command != 'm') {
                    fail(FLG_ERROR_FORMAT, line_place(numbers_.line()), "the path does not begin with M");
                }
            } else if (command == 0 || command == 'Z' || command == 'z') {
                fail(FLG_ERROR_FORMAT, line_place(numbers_.line()), "numbers without a command: %s",
                     cited(numbers_.rest()).c_str());
            }
            first_ = false;
            run(command);
            // Further points of a move are lines.
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        return pen_.take();
    }

private:
    SvgPoint point(bool relative) {
        SvgPoint p;
        p.x = numbers_.number();
        p.y = numbers_.number();
        return relative ? p + pen_.at() : p;
    }

    void run(char command) {
        const bool relative = command >= 'a';
        const char kind = static_cast<char>(relative ? command - 'a' + 'A' : command);
        const SvgPoint at = pen_.at();
        const SvgPoint mirrored = kind == 'S' || kind == 'T' ? mirrored_control(kind) : at;
        last_ = kind;
        switch (kind) {
            case 'M': pen_.move(point(relative)); break;
            case 'L': pen_.draw(point(relative)); break;
            case 'H': pen_.draw({numbers_.number() + (relative ? at.x : 0), at.y}); break;
            case 'V': pen_.draw({at.x, numbers_.number() + (relative ? at.y : 0)}); break;
            case 'C':
            case 'S': {
                const SvgPoint b = kind == 'C' ? point(relative) : mirrored;
                control_ = point(relative);
                pen_.cubic(b, control_, point(relative));
                break;
            }
            case 'Q':
            case 'T': {
                control_ = kind == 'Q' ? point(relative) : mirrored;
                const SvgPoint to = point(relative), c = control_;
                pen_.cubic(at + 2.0 / 3 * (c - at), to + 2.0 / 3 * (c - to), to);
                break;
            }
            case 'A': {
                const double rx = numbers_.number(), ry = numbers_.number(), turn = numbers_.number();
                const bool large = numbers_.flag(), sweep = numbers_.flag();
                pen_.arc(rx, ry, turn, large, sweep, point(relative));
                break;
            }
            default: pen_.close(); break;
        }
    }

    // Of a smooth curve: the last one's control point on the other side, if that was of its kind.
    SvgPoint mirrored_control(char kind) const {
        const bool follows = kind == 'S' ? last_ == 'C' || last_ == 'S' : last_ == 'Q' || last_ == 'T';
        return follows ? 2 * pen_.at() - control_ : pen_.at();
    }

    SvgNumbers numbers_;
    Pen pen_;
    bool first_ = true;
    char last_ = 0;
    SvgPoint control_;
};

// A length in user units; `px` is one.
double length_of(const SvgTag& tag, std::string_view name) {
    const std::string_view text = tag.attribute(name);
    if (text.empty()) return 0;
    SvgNumbers numbers(text, tag.line);
    const double value = numbers.number();
    const bool known = !numbers.more() || numbers.rest() == "px";
    if (!known) {
        fail(FLG_ERROR_FORMAT, line_place(tag.line), "%s is in other units than px: %s", cited(name).c_str(),
             cited(text).c_str());
    }
    return value;
}

std::vector<SvgOutline> read_points(const SvgTag& tag, bool closed) {
    SvgNumbers numbers(tag.attribute("points"), tag.line);
    Pen pen(tag.line);
    for (bool first = true; numbers.more(); first = false) {
        SvgPoint p;
        p.x = numbers.number();
        p.y = numbers.number();
        first ? pen.move(p) : pen.draw(p);
    }
    if (closed) pen.close();
    return pen.take();
}

std::vector<SvgOutline> ellipse(const SvgTag& tag, double rx, double ry) {
    const double x = length_of(tag, "cx"), y = length_of(tag, "cy");
    Pen pen(tag.line);
    if (rx <= 0 || ry <= 0) return {};
    pen.move({x + rx, y});
    pen.arc(rx, ry, 0, false, true, {x - rx, y});
    pen.arc(rx, ry, 0, false, true, {x + rx, y});
    pen.close();
    return pen.take();
}

std::vector<SvgOutline> rectangle(const SvgTag& tag) {
    const double x = length_of(tag, "x"), y = length_of(tag, "y");
    const double width = length_of(tag, "width"), height = length_of(tag, "height");
    if (width <= 0 || height <= 0) return {};
    const bool has_rx = !tag.attribute("rx").empty(), has_ry = !tag.attribute("ry").empty();
    double rx = length_of(tag, has_rx ? "rx" : "ry"), ry = length_of(tag, has_ry ? "ry" : "rx");
    rx = std::clamp(rx, 0.0, width / 2), ry = std::clamp(ry, 0.0, height / 2);
    Pen pen(tag.line);
    pen.move({x + rx, y});
    pen.draw({x + width - rx, y});
    pen.arc(rx, ry, 0, false, true, {x + width, y + ry});
    pen.draw({x + width, y + height - ry});
    pen.arc(rx, ry, 0, false, true, {x + width - rx, y + height});
    pen.draw({x + rx, y + height});
    pen.arc(rx, ry, 0, false, true, {x, y + height - ry});
    pen.draw({x, y + ry});
    pen.arc(rx, ry, 0, false, true, {x + rx, y});
    pen.close();
    return pen.take();
}

SvgTransform make_transform(std::string_view name, const std::array<double, most_values>& v, size_t count,
                            uint64_t line) {
    const auto turned = [](double degrees) {
        const double cosine = std::cos(degrees * pi / 180), sine = std::sin(degrees * pi / 180);
        return SvgTransform{cosine, sine, -sine, cosine, 0, 0};
    };
    if (name == "matrix" && count == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (count == 1 || count == 2)) return {1, 0, 0, 1, v[0], v[1]};
    if (name == "scale" && (count == 1 || count == 2)) return {v[0], 0, 0, count == 1 ? v[0] : v[1], 0, 0};
    if (name == "rotate" && count == 1) return turned(v[0]);
    if (name == "rotate" && count == 3) {
        return SvgTransform{1, 0, 0, 1, v[1], v[2]} * turned(v[0]) * SvgTransform{1, 0, 0, 1, -v[1], -v[2]};
    }
    if (name == "skewX" && count == 1) return {1, 0, std::tan(v[0] * pi / 180), 1, 0, 0};
    if (name == "skewY" && count == 1) return {1, std::tan(v[0] * pi / 180), 0, 1, 0, 0};
    fail(FLG_ERROR_FORMAT, line_place(line), "no transform, or not so many numbers: %s", cited(name).c_str());
}

}  // namespace

SvgTransform SvgTransform::operator*(const SvgTransform& o) const {
    return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
            b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
}

SvgTransform read_transform(std::string_view text, uint64_t line) {
    SvgTransform whole;
    SvgNumbers numbers(text, line);
    while (numbers.more()) {
        const size_t open = numbers.rest().find('(');
        if (open == std::string_view::npos) {
            fail(FLG_ERROR_FORMAT, line_place(line), "no transform: %s", cited(numbers.rest()).c_str());
        }
        std::string_view name = numbers.rest().substr(0, open);
        name = name.substr(0, name.find_first_of(" \t\r\n"));
        numbers.skip(open + 1);
        std::array<double, most_values> values{};
        size_t count = 0;
        while (count < most_values && numbers.at_number()) values[count++] = numbers.number();
        if (!numbers.more() || numbers.take() != ')') {
            fail(FLG_ERROR_FORMAT, line_place(line), "the transform does not end: %s", cited(name).c_str());
        }
        whole = whole * make_transform(name, values, count, line);
    }
    return whole;
}

std::vector<SvgOutline> read_outlines(const SvgTag& tag) {
    if (tag.name == "path") return PathReader(tag.attribute("d"), tag.line).read();
    if (tag.name == "polygon") return read_points(tag, true);
    if (tag.name == "polyline") return read_points(tag, false);
    if (tag.name == "rect") return rectangle(tag);
    if (tag.name == "circle") return ellipse(tag, length_of(tag, "r"), length_of(tag, "r"));
    if (tag.name == "ellipse") return ellipse(tag, length_of(tag, "rx"), length_of(tag, "ry"));
    if (tag.name == "line") {
        Pen pen(tag.line);
        pen.move({length_of(tag, "x1"), length_of(tag, "y1")});
        pen.draw({length_of(tag, "x2"), length_of(tag, "y2")});
        return pen.take();
    }
    return {};
}

}  // namespace flg::io
