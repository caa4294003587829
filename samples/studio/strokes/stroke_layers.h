// SPDX-License-Identifier: MIT
// What layers become on the screen. Strokes of one layer that have the same settings are one job, which draws them as
// live strokes are drawn (flgLiveStrokeReplay), so that what the pen showed stays to the bit.
#pragma once

#include <functional>
#include <list>
#include <map>

#include "strokes/standing_strokes.h"
#include "strokes/stroke_arrays.h"
#include "strokes/style_cache.h"

namespace flg::studio {

class StrokeLayers {
public:
    StrokeLayers(AppContext& app, StyleCache& style_cache) : app_(app), style_cache_(style_cache) {}
    ~StrokeLayers();
    StrokeLayers(const StrokeLayers&) = delete;
    StrokeLayers& operator=(const StrokeLayers&) = delete;

    // Starts what is to be made anew, shows what is done. `hidden`: a layer that is being replayed; 0: none.
    void update(const StrokeDocument& document, uint32_t hidden);
    // What is shown is not what the document says, yet.
    bool busy() const { return busy_; }
    // Points of the results that are there.
    size_t point_count() const;
    // The results of a layer that are there, each with its strokes.
    using Visitor = std::function<void(const FlgCurveSetView& curves, std::span<const Stroke> strokes)>;
    void visit(uint32_t layer, const Visitor& visitor) const;
    void device_lost();

private:
    // Strokes with the same settings and sizes, and with numbers one after the other.
    using Group = std::vector<Stroke>;
    // A mesh with strokes of a group.
    struct Stand {
        uint32_t mesh;
        bool is_seen;
        render::Placement placement;
        uint64_t bend = 0;  // its revision; 0: at rest
        bool operator==(const Stand&) const = default;
    };
    struct Shown {
        uint32_t id = 0;                       // never given again
        Group wanted;                          // what it is to show
        Group coming_of;                       // what the job that runs is given
        Group made_of;                         // what `result` was made of
        bool running = false, failed = false;  // failed: to make `coming_of`
        filigree::CurveSet coming, result;
        StrokeSkinWeights holds;  // of the result
        Group drawn_of;           // what was uploaded
        std::vector<Stand> stands;
        bool is_shown = false;  // as it is to be, which may be nothing
        bool drawn_visible = true;
        render::CurvesId drawn{};
    };
    struct LayerShown {
        std::vector<Stroke> strokes;   // of the document when it was split into groups
        std::list<Shown> groups, old;  // old ones are shown until the new ones can be
    };

    static std::vector<Group> groups_of(const std::vector<Stroke>& strokes);
    void regroup(LayerShown& layer, const std::vector<Stroke>& strokes);
    void start(const StrokeDocument& document, const StrokeLayer& layer, Shown& shown);
    std::vector<Stand> stands_of(const Group& group) const;
    void upload(Shown& shown);
    Shown* find(uint32_t layer, uint32_t id);

    AppContext& app_;
    StyleCache& style_cache_;
    std::map<uint32_t, LayerShown> layers_;
    uint32_t last_id_ = 0;
    bool busy_ = false;
};

// How strokes with these settings are drawn.
render::CurveLook look_of(const StrokeSettings& settings);

}  // namespace flg::studio
