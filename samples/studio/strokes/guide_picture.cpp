// SPDX-License-Identifier: MIT
#include "strokes/guide_picture.h"

#include <imgui.h>

#include <algorithm>

#include "strokes/flat_plane.h"
#include "support/curve_source.h"

namespace flg::studio {
namespace {

constexpr int kDisplacements = 160;  // lines at most

// The place at an arc length; the lengths asked for rise.
class Walk {
public:
    explicit Walk(const std::vector<glm::vec3>& points) : points_(points) {}
    glm::vec3 to(float length) {
        while (i_ + 2 < points_.size() && passed_ + step() < length) {
            passed_ += step();
            ++i_;
        }
        const float t = step() > 0.0f ? std::clamp((length - passed_) / step(), 0.0f, 1.0f) : 0.0f;
        return glm::mix(points_[i_], points_[i_ + 1], t);
    }

private:
    float step() const { return glm::distance(points_[i_], points_[i_ + 1]); }

    const std::vector<glm::vec3>& points_;
    size_t i_ = 0;
    float passed_ = 0.0f;
};

}  // namespace

void GuidePicture::update(const StrokeDocument& document, const StrokeSettings& settings) {
    const DrawnStyle* drawn = document.find_style(settings.style);
    const Wanted wanted{settings.style, drawn ? drawn->stroke : nullptr, settings.smoothing, settings.beta};
    if (making_ || wanted == asked_ || !style_cache_.has(document, settings.style)) return;
    asked_ = wanted;
    making_ = true;
    const std::vector<glm::vec3> example = style_cache_.example(document, settings.style);
    style_ = style_cache_.prepare(
        example, settings,
        [this, example](const FlgJobStatus& status) {
            making_ = false;
            if (status.result != FLG_OK) return;
            lines_ = lines_of(style_, example);
            ++made_;
        },
        Jobs::Shown::quiet);
}

GuidePicture::Lines GuidePicture::lines_of(const filigree::Style& style, const std::vector<glm::vec3>& example) const {
    Lines lines;
    const FlgStyleInfo info = style_cache_.info(style);
    const filigree::CurveSet set = style.guide();
    const FlgCurveSetView view = set.view();
    if (example.size() < 2 || view.curve_count == 0 || info.point_count == 0) return lines;
    const FlatPlane plane(example);
    for (const glm::vec3& point : example) lines.style.push_back(plane.flat(point));
    Walk walk(example);
    const FlgColumn& positions = *samples::find_column(view, FLG_ATTRIBUTE_POSITION);
    for (uint32_t i = 0; i < info.point_count; ++i) {
        const float* p = samples::value_at(positions, i);
        lines.guide.push_back(plane.flat({p[0], p[1], p[2]}));
        lines.matched.push_back(plane.flat(walk.to(info.matching[i])));
    }
    glm::vec2 low(1e30f), high(-1e30f);
    for (const auto* line : {&lines.style, &lines.guide})
        for (const glm::vec2& p : *line) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    const float size = std::max({high.x - low.x, high.y - low.y, 1e-9f});
    for (auto* line : {&lines.style, &lines.guide, &lines.matched})
        for (glm::vec2& p : *line) p = (p - low) / size;
    lines.size = (high - low) / size;
    lines.learns = !style_cache_.has_nothing_to_learn(style);
    if (lines.learns) lines.displacement = info.displacement_rms / info.guide_length;
    return lines;
}

void GuidePicture::draw(ImDrawList& list, glm::vec2 low, glm::vec2 high, float unit) const {
    list.AddRectFilled({low.x, low.y}, {high.x, high.y}, IM_COL32(0, 0, 0, 70), 3.0f * unit);
    const float margin = 6.0f * unit;
    const glm::vec2 room = glm::max(high - low - 2.0f * margin, 1.0f);
    const float size = std::min(room.x / std::max(lines_.size.x, 1e-3f), room.y / std::max(lines_.size.y, 1e-3f));
    const glm::vec2 corner = 0.5f * (low + high) - 0.5f * size * lines_.size;
    const auto at = [&](const glm::vec2& p) { return ImVec2(corner.x + size * p.x, corner.y + size * p.y); };
    list.PushClipRect({low.x, low.y}, {high.x, high.y}, true);
    const auto line = [&](const std::vector<glm::vec2>& points, ImU32 color, float width) {
        std::vector<ImVec2> out;
        for (const glm::vec2& p : points) out.push_back(at(p));
        list.AddPolyline(out.data(), static_cast<int>(out.size()), color, 0, width * unit);
    };
    const size_t step = 1 + lines_.guide.size() / kDisplacements;
    for (size_t i = 0; i < lines_.guide.size(); i += step)
        list.AddLine(at(lines_.guide[i]), at(lines_.matched[i]), IM_COL32(120, 160, 190, 110), unit);
    line(lines_.style, IM_COL32(205, 195, 180, 255), 1.2f);
    line(lines_.guide, IM_COL32(255, 170, 60, 255), 2.0f);
    list.PopClipRect();
}

}  // namespace flg::studio
