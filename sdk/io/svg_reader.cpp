// SPDX-License-Identifier: MIT
#include "io/svg_reader.h"

#include <algorithm>
#include <cmath>

#include "io/failure.h"
#include "io/limits.h"
#include "io/svg_outlines.h"

namespace flg::io {

namespace {

constexpr size_t most_depth = 256;

// What is only drawn where something else refers to it.
bool is_hidden(std::string_view name) {
    constexpr std::string_view names[] = {"defs", "clipPath", "mask", "symbol", "pattern", "marker"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool is_left_out(std::string_view name) {
    return name == "use" || name == "text" || name == "image";
}

class SvgReader {
public:
    explicit SvgReader(std::string_view text) : tags_(text) {}

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
        data_.warn(left_out_, "element", "use, text and image are not read");
        return std::move(data_);
    }

private:
    struct Level {
        std::string_view name;
        SvgTransform transform;
        bool hidden;
        uint64_t line;
    };

    void open(const SvgTag& tag) {
        if (!is_drawing_ && tag.name != "svg") {
            fail(FLG_ERROR_FORMAT, line_place(tag.line), "the first element is not svg: %s", cited(tag.name).c_str());
        }
        is_drawing_ = true;
        if (stack_.size() >= most_depth) {
            fail(FLG_ERROR_LIMIT, line_place(tag.line), "elements lie more than %zu deep in each other", most_depth);
        }
        const Level around = stack_.empty() ? Level{} : stack_.back();
        const Level level = {tag.name, around.transform * read_transform(tag.attribute("transform"), tag.line),
                             around.hidden || is_hidden(tag.name), tag.line};
        if (!level.hidden) {
            if (is_left_out(tag.name)) left_out_.add(elements_);
            add(read_outlines(tag), level);
        }
        ++elements_;
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
    void add(const std::vector<SvgOutline>& outlines, const Level& level) {
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
    std::vector<Level> stack_;
    Tally left_out_;
    uint64_t elements_ = 0;
    bool is_drawing_ = false;
};

}  // namespace

CurveData read_svg(std::string_view text) {
    return SvgReader(text).read();
}

}  // namespace flg::io
