// SPDX-License-Identifier: MIT
// Styles, prepared once for each way to prepare them and kept warm for the pen: built in, or drawn.
#pragma once

#include <map>
#include <set>
#include <tuple>

#include "shell/workspace.h"
#include "strokes/stroke_document.h"

namespace flg::studio {

class StyleCache {
public:
    explicit StyleCache(AppContext& app) : app_(app) {}

    bool has(const StrokeDocument& document, const std::string& name) const;
    // Prepared, or in the making; null for a name that nobody knows.
    const filigree::Style* get(const StrokeDocument& document, const StrokeSettings& settings);
    // A style of its own, made of these points.
    filigree::Style prepare(const std::vector<glm::vec3>& example, const StrokeSettings& settings, Jobs::Done done,
                            Jobs::Shown shown = Jobs::Shown::listed);
    // The points of its curve.
    std::vector<glm::vec3> example(const StrokeDocument& document, const std::string& name) const;
    // Zeros while it is in the making, or if that failed. Where there is nothing to learn the displacement is given as
    // long as the guide, so that it stays nothing at the size that is asked for.
    FlgStyleInfo info(const filigree::Style& style) const;
    bool has_nothing_to_learn(const filigree::Style& style) const;
    // Whether a live stroke can begin with it; if not, sees to it that it soon can.
    bool warm(const filigree::Style& style, float temperature);
    // Drawn styles may have got other strokes, and sliders leave styles that nothing is drawn with.
    void forget(const StrokeDocument& document, const StrokeSettings& next);

    // How far it reaches from its middle line at most, in the example's size: out of the plane it lies in, and within.
    glm::vec2 reach(const StrokeDocument& document, const std::string& name);

    // The beginning of its curve, for a picture of it: in the plane it lies in, 0 to 1 along it; z is its radius, of
    // the mean.
    const std::vector<glm::vec3>& preview(const StrokeDocument& document, const std::string& name);

private:
    struct Entry {
        filigree::Style style;
        StrokePtr drawn;  // of drawn ones: what it was made of
    };
    using Key = std::tuple<std::string, int, float, float>;
    static Key key_of(const StrokeSettings& s) { return {s.style, s.patch, s.smoothing, s.beta}; }
    FlgStyleInfo read_info(const filigree::Style& style) const;

    AppContext& app_;
    std::map<Key, Entry> styles_;
    std::set<std::pair<uint64_t, float>> warm_, warming_;
    std::map<std::string, std::pair<StrokePtr, std::vector<glm::vec3>>> previews_;
    std::map<std::string, std::pair<StrokePtr, glm::vec2>> reaches_;
};

}  // namespace flg::studio
