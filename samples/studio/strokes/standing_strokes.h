// SPDX-License-Identifier: MIT
// Strokes where they stand now: what was drawn on a mesh goes where that goes, bends as that bends, and is seen while
// that is.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "filigree/filigree.h"
#include "scene/scene.h"
#include "strokes/stroke_document.h"

namespace flg::studio {

// Whether it has a colour that counts, apart from its settings.
bool has_own_color(const Stroke& stroke);

// Its mesh is in the scene, if it is on one.
bool is_there(const Scene& scene, const DrawnStroke& stroke);
bool is_seen(const Scene& scene, const DrawnStroke& stroke);
// Its mesh is seen away from rest.
bool is_bent(const Scene& scene, const DrawnStroke& stroke);
// From where it was drawn to where it stands.
render::Placement moved(const Scene& scene, const DrawnStroke& stroke);

// What holds the points of curves on bent meshes, by curve. Of one set of curves.
class StrokeSkinWeights {
public:
    const SkinWeights& of(uint32_t curve, const std::shared_ptr<const SkinCopy>& skin, std::span<const glm::vec3> own);

private:
    struct Held {
        std::shared_ptr<const SkinCopy> skin;
        SkinWeights hold;
    };
    std::map<uint32_t, Held> held_;
};

// What was made of strokes, where they stand: of those that are seen.
class StandingCurves {
public:
    explicit StandingCurves(const Scene& scene) : scene_(scene) {}
    // A curve a stroke, with NORMAL and RADIUS. Without holds, bent meshes count as at rest.
    void add(const FlgCurveSetView& curves, std::span<const Stroke> strokes, StrokeSkinWeights* holds = nullptr);
    bool empty() const { return offsets_.size() == 1; }
    // POSITION, NORMAL, RADIUS, and COLOR on request. Lives as long as this, until the next add().
    FlgCurveSetView view(bool with_colors);

private:
    const Scene& scene_;
    std::vector<float> positions_, normals_, radii_, colors_;
    std::vector<uint32_t> offsets_{0};
    std::vector<FlgColumn> columns_;
};

}  // namespace flg::studio
