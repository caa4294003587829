// SPDX-License-Identifier: MIT
// The grammar is that of filigree_io.h: `x y z [radius]` a line, blank lines between curves, `# closed` before a closed
// one. A # ends the line's numbers. Within a curve either all points have a radius or none; if only some curves have
// one, the others get default_radius and a warning. Behind `# columns x y z NAME...` lines have these columns instead.
// Without that, `# color r g b a` lines colour the points that follow: what reads `x y z [radius]` alone skips them.
#include "io/text/xyz.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "io/text/text_lines.h"

namespace flg::io {

namespace {

constexpr std::string_view closed_word = "closed";

constexpr std::string_view columns_word = "columns";
constexpr std::string_view color_word = "color";
constexpr size_t channels = 4;
constexpr const char* coordinates[] = {"x", "y", "z"};
constexpr size_t max_names = 256;

// The words of a line that is a comment, without the #.
Vector<std::string_view> comment_words(std::string_view line) {
    LineCursor cursor(line, 0);
    if (!cursor.more() || cursor.peek() != '#') return {};
    Vector<std::string_view> words;
    std::string_view word = cursor.word().substr(1);
    for (word = word.empty() ? cursor.word() : word; !word.empty(); word = cursor.word()) {
        if (words.size() == 1 && words[0] != columns_word && words[0] != color_word) return {};
        words.push_back(word);
    }
    return words;
}

bool says_closed(std::span<const std::string_view> words) {
    return words.size() == 1 && words[0] == closed_word;
}

// `# columns x y z ...`; what else begins with that word is a comment like others.
bool says_columns(std::span<const std::string_view> words) {
    return words.size() > std::size(coordinates) && words[0] == columns_word &&
           std::equal(std::begin(coordinates), std::end(coordinates), words.begin() + 1);
}

using Color = std::array<float, channels>;

// `# color r g b [a]`; what else begins with that word is a comment like others.
std::optional<Color> says_color(std::span<const std::string_view> words) {
    if (words.empty() || words[0] != color_word || words.size() < channels || words.size() > channels + 1) return {};
    Color color = {0, 0, 0, 1};
    for (size_t k = 1; k < words.size(); ++k) {
        const char* const begin = words[k].data();
        const char* const end = begin + words[k].size();
        const auto [stop, error] = std::from_chars(begin, end, color[k - 1]);
        if (error != std::errc() || stop != end || !(std::abs(color[k - 1]) <= max_coordinate)) return {};
    }
    return color;
}

class XyzReader {
public:
    explicit XyzReader(const Origin& origin) : origin_(origin) {}

    CurveData read(std::string_view text) {
        data_.format = "xyz";
        TextLines lines(text);
        for (std::string_view line; lines.next(line);) {
            if (line.find('#') != line.npos) {
                const Vector<std::string_view> words = comment_words(line);
                if (says_closed(words)) {
                    announce_closed(lines.number());
                    continue;
                }
                if (says_columns(words)) {
                    announce_columns(std::span(words).subspan(1), lines.number());
                    continue;
                }
                if (const std::optional<Color> color = says_color(words); color && !declared_) {
                    color_points();
                    color_ = *color;
                    colored_ = true;
                    continue;
                }
                line = line.substr(0, line.find('#'));
                LineCursor cursor(line, lines.number());
                // Only a comment: as if the line were not there.
                if (!cursor.more()) continue;
            }
            LineCursor cursor(line, lines.number());
            if (cursor.more())
                read_point(cursor, lines.number());
            else
                end_curve();
        }
        end_curve();
        if (data_.curve_count() == 0) fail(FLG_ERROR_FORMAT, line_place(lines.number()), "the file holds no points");
        if (closed_next_) {
            data_.warnings.push_back("line " + to_text(closed_line_) + ": no curve follows `# closed`");
        }
        fill_radii();
        if (colored_) color_points();
        data_.warn(repeated_ends_, "curve", "closed, and the first point repeated at the end, left out");
        return std::move(data_);
    }

private:
    void announce_closed(uint64_t line) {
        if (in_curve_) {
            fail(FLG_ERROR_FORMAT, line_place(line), "`# closed` inside a curve: a blank line must come before it");
        }
        closed_next_ = true;
        closed_line_ = line;
    }

    // The points since the colour changed.
    void color_points() {
        while (data_.colors.size() < channels * data_.point_count())
            data_.colors.insert(data_.colors.end(), color_.begin(), color_.end());
    }

    // A number of a line, behind the coordinates.
    struct Place {
        String name;
        size_t column;
        uint32_t component;
    };

    void announce_columns(std::span<const std::string_view> names, uint64_t line) {
        if (in_curve_ || data_.curve_count() > 0 || declared_) {
            fail(FLG_ERROR_FORMAT, line_place(line), "`# columns` once only, before the first point");
        }
        declared_ = true;
        if (names.size() > max_names) {
            fail(FLG_ERROR_FORMAT, line_place(line), "`# columns` has %zu names, more than 256", names.size());
        }
        data_.columns = columns_of_names(names);
        for (size_t i = 0; i < names.size(); ++i) {
            const auto name = names.begin() + static_cast<std::ptrdiff_t>(i);
            if (std::find(names.begin(), name, *name) != name) {
                fail(FLG_ERROR_FORMAT, line_place(line), "`# columns` has twice %s", cited(names[i]).c_str());
            }
            if (i >= std::size(coordinates)) places_.push_back(place_of(names[i], line));
        }
    }

    Place place_of(std::string_view name, uint64_t line) const {
        for (size_t c = 0; c < data_.columns.size(); ++c) {
            const VertexColumn& column = data_.columns[c];
            for (uint32_t k = 0; k < column.components; ++k) {
                if (column_name(column.attribute, column.components, k) == name) return {String(name), c, k};
            }
        }
        fail(FLG_ERROR_FORMAT, line_place(line), "`# columns`: no column is called so, or not all of it is there: %s",
             cited(name).c_str());
    }

    void read_columns(LineCursor& cursor, uint64_t line) {
        // An alpha that is not among them is 1.
        for (VertexColumn& column : data_.columns) column.values.resize(column.values.size() + column.components, 1.0f);
        for (const Place& place : places_) {
            VertexColumn& column = data_.columns[place.column];
            const float value = cursor.number(place.name.c_str());
            if (const char* rule = rule_broken_by(column.attribute, place.component, value)) {
                fail(FLG_ERROR_FORMAT, line_place(line), "the %s is %g, %s", place.name.c_str(), double{value}, rule);
            }
            column.values[column.values.size() - column.components + place.component] = value;
        }
        if (cursor.more()) {
            fail(FLG_ERROR_FORMAT, line_place(line), "more numbers than columns: %s", cited(cursor.word()).c_str());
        }
        in_curve_ = true;
    }

    void read_point(LineCursor& cursor, uint64_t line) {
        for (size_t k = 0; k < std::size(coordinates); ++k)
            data_.positions.push_back(cursor.coordinate(coordinates[k], origin_[k]));
        if (data_.point_count() > max_points) {
            fail(FLG_ERROR_LIMIT, line_place(line), "more than 2^31 points");
        }
        if (declared_)
            read_columns(cursor, line);
        else
            read_radius(cursor, line);
    }

    void read_radius(LineCursor& cursor, uint64_t line) {
        const bool radius = cursor.more();
        if (radius) {
            const float value = cursor.number("radius");
            if (value < 0) fail(FLG_ERROR_FORMAT, line_place(line), "the radius is %g, must be >= 0", double{value});
            curve_radii_.push_back(value);
        }
        if (cursor.more()) {
            fail(FLG_ERROR_FORMAT, line_place(line), "more than four numbers: %s", cited(cursor.word()).c_str());
        }
        if (!in_curve_) {
            in_curve_ = true;
            has_radius_ = radius;
        } else if (radius != has_radius_) {
            fail(FLG_ERROR_FORMAT, line_place(line), "this point has %s radius, the curve's points before it have %s",
                 radius ? "a" : "no", radius ? "none" : "one");
        }
    }

    void end_curve() {
        if (!in_curve_) return;
        const size_t begin = data_.offsets.back();
        const size_t last = data_.point_count() - 1;
        const float* points = data_.positions.data();
        if (closed_next_ && last > begin && std::equal(points + 3 * begin, points + 3 * begin + 3, points + 3 * last)) {
            data_.positions.resize(3 * last);
            if (has_radius_) curve_radii_.pop_back();
            data_.colors.resize(std::min(data_.colors.size(), channels * last));
            for (VertexColumn& column : data_.columns) column.values.resize(column.values.size() - column.components);
            repeated_ends_.add(data_.curve_count());
        }
        radius_curves_ += has_radius_;
        curve_has_radius_.push_back(has_radius_);
        data_.end_curve(closed_next_);
        in_curve_ = closed_next_ = false;
    }

    void fill_radii() {
        if (radius_curves_ == 0) return;
        if (radius_curves_ == data_.curve_count()) {
            data_.radii = std::move(curve_radii_);
            return;
        }
        Tally without;
        size_t taken = 0;
        data_.radii.assign(data_.point_count(), default_radius);
        for (size_t c = 0; c < data_.curve_count(); ++c) {
            if (!curve_has_radius_[c]) {
                without.add(c);
                continue;
            }
            for (size_t i = data_.offsets[c]; i < data_.offsets[c + 1]; ++i) data_.radii[i] = curve_radii_[taken++];
        }
        data_.warn(without, "curve", "no radius where others have one, set to 0.005 m");
    }

    const Origin origin_;
    CurveData data_;
    Vector<float> curve_radii_;  // of the curves that have them, back to back
    Vector<bool> curve_has_radius_;
    size_t radius_curves_ = 0;
    Vector<Place> places_;
    bool declared_ = false;  // by `# columns`
    bool colored_ = false;   // by `# color`
    Color color_ = {1, 1, 1, 1};
    bool in_curve_ = false;
    bool has_radius_ = false;
    bool closed_next_ = false;
    uint64_t closed_line_ = 0;
    Tally repeated_ends_;
};

// Of a point, unless it is that of the one before it.
const float* say_color(String& text, const float* color, const float* before) {
    if (before && std::equal(color, color + channels, before)) return before;
    append_numbers((text += "# ") += color_word, color, channels);
    text += '\n';
    return color;
}

}  // namespace

CurveData read_xyz(std::string_view text, const Origin& origin) {
    return XyzReader(origin).read(text);
}

void write_xyz(const CheckedView& view, const FlgCurveFileWriteDesc& desc, FileWriter& file) {
    String& text = file.text;
    // What is written behind the coordinates: the radius first, where plain readers look for it.
    Vector<FlgColumn> columns;
    for (const FlgColumn& column : view.columns()) {
        if (column.attribute == FLG_ATTRIBUTE_RADIUS) columns.insert(columns.begin(), column);
        if (column.attribute == FLG_ATTRIBUTE_RADIUS || column.attribute == FLG_ATTRIBUTE_POSITION) continue;
        if (desc.all_columns) columns.push_back(column);
    }
    if (desc.all_columns) text += "# columns x y z";
    for (const FlgColumn& column : columns) {
        for (uint32_t k = 0; desc.all_columns && k < column.components; ++k) {
            text += ' ' + column_name(column.attribute, column.components, k);
        }
    }
    if (desc.all_columns) text += '\n';
    const float* color = nullptr;  // as it was said last
    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        if (c != 0) text += '\n';
        if (view.closed(c)) text += "# closed\n";
        for (size_t i = view.begin(c); i < view.end(c); ++i) {
            if (view.color && !desc.all_columns) color = say_color(text, view.color.at(i), color);
            for (size_t k = 0; k < std::size(coordinates); ++k) {
                if (k > 0) text += ' ';
                append_coordinate(text, view.position.at(i)[k], view.origin()[k]);
            }
            for (const FlgColumn& column : columns) append_numbers(text, resolved(column).at(i), column.components);
            text += '\n';
            file.drain();
        }
    }
}

}  // namespace flg::io
