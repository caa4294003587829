// SPDX-License-Identifier: MIT
#include "io/svg/svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>

#include "io/base/failure.h"
#include "io/base/limits.h"

namespace flg::io {

namespace {

// ---- Numbers and words in attributes, where `1-2.5.5` are three numbers.

class SvgNumbers {
public:
    SvgNumbers(std::string_view text, uint64_t line) : text_(text), line_(line) {}

    // Past blanks and commas: whether anything is left, and whether that is a number.
    bool more() {
        while (!text_.empty() && (text_[0] == ',' || is_blank(text_[0]))) text_.remove_prefix(1);
        return !text_.empty();
    }
    bool at_number() {
        if (!more()) return false;
        const char c = text_[0];
        return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
    }
    // Finite and at most 1e30 in size; otherwise it fails.
    double number() {
        if (!at_number()) refuse();
        std::string_view rest = text_.substr(text_[0] == '+' ? 1 : 0);
        const std::string_view digits = rest.substr(rest.starts_with('-') ? 1 : 0);
        double value = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
        const bool begins = !digits.empty() && (digits[0] == '.' || (digits[0] >= '0' && digits[0] <= '9'));
        if (error != std::errc() || !begins || !(std::abs(value) <= double{max_coordinate})) refuse();
        text_.remove_prefix(static_cast<size_t>(end - text_.data()));
        return value;
    }
    // 0 or 1, which the next number may follow at once.
    bool flag() {
        if (!more() || (text_[0] != '0' && text_[0] != '1')) refuse();
        const bool set = text_[0] == '1';
        text_.remove_prefix(1);
        return set;
    }
    char take() {
        const char c = text_[0];
        text_.remove_prefix(1);
        return c;
    }
    std::string_view rest() const { return text_; }
    void skip(size_t count) { text_.remove_prefix(count); }
    [[noreturn]] void refuse() const {
        fail(FLG_ERROR_FORMAT, line_place(line_), "no number, or one beyond 1e30: %s", cited(text_).c_str());
    }
    uint64_t line() const { return line_; }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

    std::string_view text_;
    uint64_t line_;
};

// ---- Tags, one after the other. Comments, processing instructions, declarations and text are passed
// over; entities are not replaced, so that no file can blow up.

struct SvgTag {
    enum class Kind { open, close, empty };
    Kind kind;
    std::string_view name;  // without its namespace
    Vector<std::pair<std::string_view, std::string_view>> attributes;
    uint64_t line;  // it begins on

    // "" if there is none.
    std::string_view attribute(std::string_view attribute_name) const;
};

class SvgTags {
public:
    explicit SvgTags(std::string_view text) : text_(text) {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);  // a byte order mark
    }
    // False at the end. Fails where a tag or a comment does not end, or an attribute has no value in quotes. Copies go
    // on from where they are.
    bool next(SvgTag& tag);

private:
    bool skip_past(std::string_view begin, std::string_view end);
    void read_attributes(SvgTag& tag);
    void advance(size_t count);

    std::string_view text_;
    uint64_t line_ = 1;
};

constexpr std::string_view blanks = " \t\r\n";

std::string_view without_namespace(std::string_view name) {
    const size_t colon = name.rfind(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

std::string_view SvgTag::attribute(std::string_view attribute_name) const {
    for (const auto& [key, value] : attributes) {
        if (key == attribute_name) return value;
    }
    return {};
}

void SvgTags::advance(size_t count) {
    line_ += static_cast<uint64_t>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
    text_.remove_prefix(count);
}

// Passes over what begins and ends so, if that comes next.
bool SvgTags::skip_past(std::string_view begin, std::string_view end) {
    if (!text_.starts_with(begin)) return false;
    const size_t found = text_.find(end, begin.size());
    if (found == text_.npos) fail(FLG_ERROR_FORMAT, line_place(line_), "%s does not end", cited(begin).c_str());
    advance(found + end.size());
    return true;
}

bool SvgTags::next(SvgTag& tag) {
    for (;;) {
        const size_t begin = text_.find('<');
        if (begin == text_.npos) return false;
        advance(begin);
        if (!skip_past("<!--", "-->") && !skip_past("<![CDATA[", "]]>") && !skip_past("<?", "?>") &&
            !skip_past("<!", ">")) {
            break;
        }
    }
    tag = {SvgTag::Kind::open, {}, {}, line_};
    advance(1);
    if (text_.starts_with('/')) {
        tag.kind = SvgTag::Kind::close;
        advance(1);
    }
    const size_t length = std::min(text_.find_first_of(" \t\r\n/>"), text_.size());
    tag.name = without_namespace(text_.substr(0, length));
    advance(length);
    read_attributes(tag);
    return true;
}

void SvgTags::read_attributes(SvgTag& tag) {
    for (;;) {
        advance(std::min(text_.find_first_not_of(blanks), text_.size()));
        if (text_.starts_with('>')) {
            advance(1);
            return;
        }
        if (text_.starts_with("/>") && tag.kind == SvgTag::Kind::open) {
            tag.kind = SvgTag::Kind::empty;
            advance(2);
            return;
        }
        const size_t equals = text_.find_first_of("=<>");
        if (equals == text_.npos || text_[equals] != '=') {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "the tag %s does not end, or an attribute has no value",
                 cited(tag.name).c_str());
        }
        std::string_view name = text_.substr(0, equals);
        name = name.substr(0, name.find_first_of(blanks));
        advance(equals + 1);
        advance(std::min(text_.find_first_not_of(blanks), text_.size()));
        const char quote = text_.empty() ? '\0' : text_[0];
        const size_t end = quote == '"' || quote == '\'' ? text_.find(quote, 1) : text_.npos;
        if (end == text_.npos) {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "the attribute %s has no value in quotes",
                 cited(name).c_str());
        }
        tag.attributes.emplace_back(name, text_.substr(1, end - 1));
        advance(end + 1);
    }
}

// ---- From shapes to outlines: polylines in the drawing's plane, curves flattened to within a thousandth of
// their own size.

struct SvgPoint {
    double x = 0, y = 0;
};

// x' = a x + c y + e, y' = b x + d y + f.
struct SvgTransform {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    SvgPoint operator()(const SvgPoint& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    // First the other one, then this one.
    SvgTransform operator*(const SvgTransform& other) const;
};

struct SvgOutline {
    Vector<SvgPoint> points;
    bool closed = false;
};

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-3;  // of a curve's size
constexpr size_t max_path_points = size_t{1} << 24;
constexpr size_t max_values = 6;  // of a transform

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
    Vector<SvgOutline> take() {
        end(false);
        return std::move(outlines_);
    }

private:
    void add(const SvgPoint& point) {
        if (++count_ > max_path_points) fail(FLG_ERROR_LIMIT, line_place(line_), "more than 2^24 points");
        outline_.points.push_back(point);
    }
    void end(bool closed) {
        Vector<SvgPoint>& points = outline_.points;
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
    Vector<SvgOutline> outlines_;
};

class PathReader {
public:
    PathReader(std::string_view data, uint64_t line) : numbers_(data, line), pen_(line) {}

    Vector<SvgOutline> read() {
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

Vector<SvgOutline> read_points(const SvgTag& tag, bool closed) {
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

Vector<SvgOutline> ellipse(const SvgTag& tag, double rx, double ry) {
    const double x = length_of(tag, "cx"), y = length_of(tag, "cy");
    Pen pen(tag.line);
    if (rx <= 0 || ry <= 0) return {};
    pen.move({x + rx, y});
    pen.arc(rx, ry, 0, false, true, {x - rx, y});
    pen.arc(rx, ry, 0, false, true, {x + rx, y});
    pen.close();
    return pen.take();
}

Vector<SvgOutline> rectangle(const SvgTag& tag) {
    const double x = length_of(tag, "x"), y = length_of(tag, "y");
    const double width = length_of(tag, "width"), height = length_of(tag, "height");
    if (width <= 0 || height <= 0) return {};
    const bool has_rx = !tag.attribute("rx").empty(), has_ry = !tag.attribute("ry").empty();
    double rx = length_of(tag, has_rx ? "rx" : "ry"), ry = length_of(tag, has_ry ? "ry" : "rx");
    rx = std::clamp(rx, 0.0, width / 2), ry = std::clamp(ry, 0.0, height / 2);
    Pen pen(tag.line);
    const bool is_round = rx > 0 && ry > 0;
    const auto corner = [&](const SvgPoint& begin, const SvgPoint& end) {
        pen.draw(begin);
        if (is_round) pen.arc(rx, ry, 0, false, true, end);
    };
    pen.move({x + rx, y});
    corner({x + width - rx, y}, {x + width, y + ry});
    corner({x + width, y + height - ry}, {x + width - rx, y + height});
    corner({x + rx, y + height}, {x, y + height - ry});
    if (is_round) corner({x, y + ry}, {x + rx, y});
    pen.close();
    return pen.take();
}

SvgTransform make_transform(std::string_view name, const std::array<double, max_values>& v, size_t count,
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

SvgTransform SvgTransform::operator*(const SvgTransform& o) const {
    return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
            b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
}

// `translate(1 2) rotate(30)`; "" is none. Fails on what is none of matrix, translate, scale, rotate, skewX and skewY.
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
        std::array<double, max_values> values{};
        size_t count = 0;
        while (count < max_values && numbers.at_number()) values[count++] = numbers.number();
        if (!numbers.more() || numbers.take() != ')') {
            fail(FLG_ERROR_FORMAT, line_place(line), "the transform does not end: %s", cited(name).c_str());
        }
        whole = whole * make_transform(name, values, count, line);
    }
    return whole;
}

// The outlines of a path, polygon, polyline, line, rect, circle or ellipse, not yet transformed; none of other
// elements. Fails with FLG_ERROR_LIMIT beyond 2^24 points.
Vector<SvgOutline> read_outlines(const SvgTag& tag) {
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

constexpr size_t max_depth = 256;
constexpr uint32_t max_uses = 16;  // of what uses others, in each other
constexpr uint64_t max_used_elements = 1 << 20;

// What is only drawn where something else refers to it.
bool is_hidden(std::string_view name) {
    constexpr std::string_view names[] = {"defs", "clipPath", "mask", "symbol", "pattern", "marker"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool is_left_out(std::string_view name) {
    return name == "text" || name == "image";
}

// A property of an element, of its style or else an attribute; "" if it has neither.
std::string_view property(const SvgTag& tag, std::string_view name) {
    const auto trimmed = [&](std::string_view text) {
        const size_t first = std::min(text.find_first_not_of(blanks), text.size());
        return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
    };
    std::string_view value = tag.attribute(name);
    for (std::string_view style = tag.attribute("style"); !style.empty();) {
        const size_t end = std::min(style.find(';'), style.size());
        const std::string_view declaration = style.substr(0, end);
        const size_t colon = declaration.find(':');
        if (colon != std::string_view::npos && trimmed(declaration.substr(0, colon)) == name)
            value = declaration.substr(colon + 1);
        style.remove_prefix(std::min(end + 1, style.size()));
    }
    return trimmed(value);
}

class SvgReader {
public:
    explicit SvgReader(std::string_view text) : tags_(text) {
        if (text.find("use") != text.npos) list_ids();
    }

    CurveData read() {
        data_.format = "svg";
        SvgTag tag;
        while (tags_.next(tag)) {
            if (tag.kind == SvgTag::Kind::close) {
                close(tag);
            } else {
                open(tag);
            }
        }
        if (!is_drawing_) fail(FLG_ERROR_FORMAT, "", "the file has no svg element");
        if (!stack_.empty()) fail(FLG_ERROR_FORMAT, line_place(stack_.back().line), "an element is not closed");
        if (data_.curve_count() == 0) fail(FLG_ERROR_FORMAT, "", "the drawing has no outlines");
        data_.warn(left_out_, "element", "text and image are not read");
        data_.warn(unknown_, "element", "what it uses is not in the file, or has a view of its own");
        return std::move(data_);
    }

private:
    struct Level {
        std::string_view name;
        SvgTransform transform;
        bool hidden;     // with all that is in it
        bool invisible;  // but for what in it is visible again
        uint64_t line;
    };

    // An element that others may use: its name, and where it begins.
    struct Known {
        std::string_view id;
        SvgTags at;
    };
    void list_ids() {
        SvgTags at = tags_, before = at;
        for (SvgTag tag; at.next(tag); before = at)
            if (const std::string_view id = tag.attribute("id"); !id.empty()) ids_.push_back({id, before});
        // Of those with one name the first counts.
        std::sort(ids_.begin(), ids_.end(), [](const Known& a, const Known& b) {
            return a.id != b.id ? a.id < b.id : a.id.data() < b.id.data();
        });
    }

    // Another element in this place, with all that is in it.
    void use(const SvgTag& tag, const Level& level) {
        std::string_view name = tag.attribute("href");
        if (name.empty()) name = tag.attribute("xlink:href");
        name.remove_prefix(std::min<size_t>(name.starts_with('#') ? 1 : name.size(), name.size()));
        const auto found = std::lower_bound(ids_.begin(), ids_.end(), name,
                                            [](const Known& known, std::string_view id) { return known.id < id; });
        if (name.empty() || found == ids_.end() || found->id != name) return unknown_.add(elements_);
        if (uses_ >= max_uses)
            fail(FLG_ERROR_LIMIT, line_place(tag.line), "elements use each other more than %u deep", max_uses);
        ++uses_;
        const size_t base = stack_.size();
        stack_.push_back(level);
        stack_.back().transform = level.transform * SvgTransform{1, 0, 0, 1, length_of(tag, "x"), length_of(tag, "y")};
        SvgTags tags = found->at;
        SvgTag used;
        bool is_first = true;
        while (tags.next(used)) {
            if (++used_elements_ > max_used_elements)
                fail(FLG_ERROR_LIMIT, line_place(tag.line), "more than 2^20 elements are used again");
            const bool has_view = is_first && !used.attribute("viewBox").empty();
            if (has_view) unknown_.add(elements_);
            if (has_view) break;
            used.kind == SvgTag::Kind::close ? close(used) : open(used, is_first);
            is_first = false;
            if (stack_.size() == base + 1) break;
        }
        stack_.resize(base);
        --uses_;
    }

    // `is_used`: by another, which shows what is only kept to be used.
    void open(const SvgTag& tag, bool is_used = false) {
        if (!is_drawing_ && tag.name != "svg") {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "the first element is not svg: %s", cited(tag.name).c_str());
        }
        is_drawing_ = true;
        if (stack_.size() >= max_depth) {
            fail(FLG_ERROR_LIMIT, line_place(tag.line), "elements lie more than %zu deep in each other", max_depth);
        }
        const Level around = stack_.empty() ? Level{} : stack_.back();
        const std::string_view visibility = property(tag, "visibility");
        const Level level = {tag.name, around.transform * read_transform(tag.attribute("transform"), tag.line),
                             around.hidden || (is_hidden(tag.name) && !is_used) || property(tag, "display") == "none",
                             visibility.empty() || visibility == "inherit" ? around.invisible : visibility != "visible",
                             tag.line};
        if (!level.hidden && !level.invisible) {
            if (is_left_out(tag.name)) left_out_.add(elements_);
            if (tag.name == "use") use(tag, level);
            add(read_outlines(tag), level);
        }
        if (uses_ == 0) ++elements_;
        if (tag.kind == SvgTag::Kind::open) stack_.push_back(level);
    }

    void close(const SvgTag& tag) {
        if (stack_.empty() || stack_.back().name != tag.name) {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "closes another element than the last: %s",
                 cited(tag.name).c_str());
        }
        stack_.pop_back();
    }

    // Drawings have y downwards.
    void add(const Vector<SvgOutline>& outlines, const Level& level) {
        for (const SvgOutline& outline : outlines) {
            for (const SvgPoint& point : outline.points) {
                const SvgPoint p = level.transform(point);
                if (!(std::abs(p.x) <= double{max_coordinate} && std::abs(p.y) <= double{max_coordinate})) {
                    fail(FLG_ERROR_FORMAT, line_place(level.line), "a point lies beyond 1e30");
                }
                data_.positions.insert(data_.positions.end(), {static_cast<float>(p.x), static_cast<float>(-p.y), 0});
            }
            if (data_.point_count() > max_points)
                fail(FLG_ERROR_LIMIT, line_place(level.line), "more than 2^31 points");
            data_.end_curve(outline.closed && outline.points.size() > 2);
        }
    }

    SvgTags tags_;
    CurveData data_;
    Vector<Level> stack_;
    Vector<Known> ids_;
    uint32_t uses_ = 0;  // that are open
    uint64_t used_elements_ = 0;
    Tally left_out_, unknown_;
    uint64_t elements_ = 0;
    bool is_drawing_ = false;
};

}  // namespace

CurveData read_svg(std::string_view text) {
    return SvgReader(text).read();
}

}  // namespace flg::io
