// SPDX-License-Identifier: MIT
// What layers become on the screen: each is one job that draws all its strokes as live strokes are drawn (flgLiveStrokeReplay), so
// that what the pen showed stays to the bit. A layer whose settings change while its job runs is made again when that is done.
#pragma once

#include <map>

#include "strokes/stroke_arrays.h"
#include "strokes/style_shelf.h"

namespace flg::studio {

class StrokeLayers {
public:
    StrokeLayers(Desk& desk, StyleShelf& shelf) : desk_(desk), shelf_(shelf) {}
    ~StrokeLayers();
    StrokeLayers(const StrokeLayers&) = delete;
    StrokeLayers& operator=(const StrokeLayers&) = delete;

    // Starts what is to be made anew, shows what is done. `hidden`: a layer that is being replayed; 0: none.
    void update(const StrokeDocument& document, uint32_t hidden);
    // What is shown is not what the document says, yet.
    bool busy() const { return busy_; }
    // Points of the results that are there.
    size_t point_count() const;
    // The result of a layer; null while there is none.
    const filigree::CurveSet* result(uint32_t layer) const;
    void device_lost();

private:
    struct Shown {
        std::vector<StrokePtr> strokes;  // that the result was made of, or is being
        StrokeSettings settings;
        bool running = false, failed = false;
        filigree::CurveSet coming, result;
        StrokeSettings look;  // as it was uploaded
        bool drawn_visible = true;
        render::CurvesId drawn{};
    };

    void start(const StrokeDocument& document, const StrokeLayer& layer, Shown& shown);
    void upload(const StrokeLayer& layer, Shown& shown);

    Desk& desk_;
    StyleShelf& shelf_;
    std::map<uint32_t, Shown> layers_;
    bool busy_ = false;
};

// How strokes with these settings are drawn.
render::CurveLook look_of(const StrokeSettings& settings);

}  // namespace flg::studio
