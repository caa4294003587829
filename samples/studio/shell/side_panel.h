// SPDX-License-Identifier: MIT
// A panel at the left or right of the window: as wide as its border is dragged, or folded away. Kept while the program
// runs.
#pragma once

namespace flg::studio {

class SidePanel {
public:
    // `share`: of the window, which it does not exceed before its border was dragged.
    SidePanel(float width, float share) : width_(width), share_(share) {}

    // Of a window so many units of the layout wide.
    float width(float window_units) const;
    bool folded() const { return folded_; }
    void fold(bool folded) { folded_ = folded; }
    // The strip between panel and picture, which is `kBorder` units wide: dragging resizes the panel, a click folds or
    // unfolds it. `x` and `top` in pixels, `sign` +1 for a panel to the left of its border.
    void draw_border(const char* label, float x, float top, float height, float scale, float window_units, float sign);

    static constexpr float kBorder = 10.0f;

private:
    float width_, share_;  // units; of the window
    bool folded_ = false, dragged_ = false;
};

}  // namespace flg::studio
