// SPDX-License-Identifier: MIT
// A picture of what a style learns: its example, the guide, and the displacement between them. While a slider moves,
// one style after the other is prepared for it, each for where the slider is by then.
#pragma once

#include <vector>

#include "strokes/style_cache.h"

struct ImDrawList;

namespace flg::studio {

class GuidePicture {
public:
    GuidePicture(AppContext& app, StyleCache& style_cache) : app_(app), style_cache_(style_cache) {}

    // Sees to it that the picture shows these settings soon.
    void update(const StrokeDocument& document, const StrokeSettings& settings);
    // Between two corners, pixels.
    void draw(ImDrawList& list, glm::vec2 low, glm::vec2 high, float unit) const;

    bool busy() const { return making_; }
    // The example is its own guide.
    bool nothing_to_learn() const { return !lines_.style.empty() && !lines_.learns; }
    // Pictures so far.
    int made() const { return made_; }
    // Of the displacement, root mean square, in lengths of the guide.
    float displacement() const { return lines_.displacement; }

private:
    struct Wanted {
        std::string style;
        StrokePtr drawn;
        float smoothing = 0.0f, beta = 0.0f;
        bool operator==(const Wanted&) const = default;
    };
    struct Lines {
        std::vector<glm::vec2> style, guide, matched;  // 0 to 1 along the longer side; matched: of the guide's points
        glm::vec2 size{1.0f};
        bool learns = true;
        float displacement = 0.0f;
    };

    Lines lines_of(const filigree::Style& style, const std::vector<glm::vec3>& example) const;

    AppContext& app_;
    StyleCache& style_cache_;
    filigree::Style style_;  // the one shown, or in the making
    Wanted asked_;
    Lines lines_;
    bool making_ = false;
    int made_ = 0;
};

}  // namespace flg::studio
