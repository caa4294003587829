// SPDX-License-Identifier: MIT
// The grammar is that of filigree_io.h: `x y z [radius]` a line, blank lines between curves, `# closed` before a closed
// one. A # ends the line's numbers. Within a curve either all points have a radius or none; if only some curves have
// one, the others get default_radius and a warning.
#include "io/xyz_format.h"

#include "io/text_lines.h"

namespace flg::io {

namespace {

constexpr std::string_view closed_word = "closed";

// Whether a line is the comment `# closed`.
bool says_closed(std::string_view line) {
    LineCursor cursor(line, 0);
    if (!cursor.more() || cursor.peek() != '#') return false;
    std::string_view word = cursor.word();
    if (word == "#")
        word = cursor.word();
    else
        word.remove_prefix(1);
    return word == closed_word && !cursor.more();
}

class XyzReader {
public:
    CurveData read(std::string_view text) {
        data_.format = "xyz";
        TextLines lines(text);
        for (std::string_view line; lines.next(line);) {
            if (line.find('#') != line.npos) {
                if (says_closed(line)) {
                    announce_closed(lines.number());
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
            data_.warnings.push_back("line " + std::to_string(closed_line_) + ": no curve follows `# closed`");
        }
        fill_radii();
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

    void read_point(LineCursor& cursor, uint64_t line) {
        for (const char* what : {"x", "y", "z"}) data_.positions.push_back(cursor.number(what));
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
        if (data_.point_count() > max_points) {
            fail(FLG_ERROR_LIMIT, line_place(line), "more than 2^31 points");
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

    CurveData data_;
    std::vector<float> curve_radii_;  // of the curves that have them, back to back
    std::vector<bool> curve_has_radius_;
    size_t radius_curves_ = 0;
    bool in_curve_ = false;
    bool has_radius_ = false;
    bool closed_next_ = false;
    uint64_t closed_line_ = 0;
    Tally repeated_ends_;
};

}  // namespace

CurveData read_xyz(std::string_view text) {
    return XyzReader().read(text);
}

std::string write_xyz(const CheckedView& view) {
    constexpr size_t usual_line = 48;
    std::string text;
    text.reserve(view.point_count() * usual_line);
    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        if (c != 0) text += '\n';
        if (view.closed(c)) text += "# closed\n";
        for (size_t i = view.begin(c); i < view.end(c); ++i) {
            const float* p = view.position.at(i);
            for (int k = 0; k < 3; ++k) {
                if (k != 0) text += ' ';
                append_number(text, p[k]);
            }
            if (view.radius) {
                text += ' ';
                append_number(text, *view.radius.at(i));
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace flg::io
