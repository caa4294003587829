// SPDX-License-Identifier: MIT
// Strokes: drawn in space on a mesh, on a plane that faces the camera or on the floor, and stylized while they are
// drawn. Settings are the next stroke's, until they are applied to strokes that are there.
#pragma once

#include <functional>
#include <set>

#include "strokes/guide_picture.h"
#include "strokes/live_pen.h"
#include "strokes/stroke_replay.h"

namespace flg::studio {

class StrokesWorkspace final : public Workspace {
public:
    explicit StrokesWorkspace(AppContext& app);

    const char* title() const override { return "Strokes"; }
    std::string help() const override;
    void leave() override;
    void update() override;
    void panel() override;
    void pointer(const Pointer& mouse) override;
    void overlay(ImDrawList& list) override;
    bool shortcut(const Chord& chord) override;
    std::span<const Shortcut> shortcuts() const override;
    bool can_undo() const override { return !undone_from_.empty(); }
    bool can_redo() const override { return !redone_from_.empty(); }
    void undo() override;
    void redo() override;
    void forget_undone() override { redone_from_.clear(); }
    bool give_up() override;
    bool is_settled() const override { return !pen_.down(); }
    bool open(const std::string& path) override;
    nlohmann::json save() const override { return to_json(document_, app_.scene.ids()); }
    std::function<nlohmann::json()> saver() const override {
        return [document = document_, ids = app_.scene.ids()] { return to_json(document, ids); };
    }
    void load(const nlohmann::json& part) override;
    std::span<const Export> exports() const override;
    void write(const Export& what, const std::string& path) override;
    render::Box box() const override;
    bool busy() const override {
        return layers_.busy() || replay_.layer() != 0 || lifts_pen_ || !is_warm_ || guide_.busy();
    }
    void device_lost() override;
    double count(const std::string& name) const override;

private:
    static constexpr float kThinnest_mm = 0.1f, kThickest_mm = 50.0f;  // radius
    enum class Tool { draw, draw_style, select, erase };
    enum class Ground { mesh, facing, floor };

    // Before an act: what undo goes back to.
    void remember();
    void set_tool(Tool tool);
    // `mesh`: what it lies on; null: nothing.
    std::optional<StrokeSample> sample_at(glm::vec2 px, const SceneMesh*& mesh) const;
    bool is_floor_seen(const Ray& ray, const glm::vec3& place) const;
    // Of the next stroke off what it lies on: no part of the style sinks in.
    float lift(const filigree::Style* style);
    void begin_stroke(const Pointer& mouse);
    void begin_at(const StrokeSample& sample, const SceneMesh* under);
    void end_stroke();
    void erase(const Pointer& mouse);
    void select(const Pointer& mouse);
    void select_layer();
    bool is_selected(const Stroke& stroke) const;
    void erase_selection();
    // Strokes that are no longer there are not selected.
    void forget_gone();
    // Gives the settings to strokes that are there: the selected ones of all layers, or all of the active layer.
    void apply_to_selection();
    void apply_to_layer();
    void apply(StrokeLayer& layer, const std::function<bool(const Stroke&)>& to);
    void take_from_selection();
    // The stroke of the visible layers that is drawn nearest to a pixel, within reach.
    struct Found {
        uint32_t layer = 0;
        size_t stroke = 0;
    };
    std::optional<Found> stroke_at(glm::vec2 px) const;

    void draw_tools();
    void draw_styles();
    void draw_colors();
    void draw_sizes();
    void draw_guide();
    void draw_apply();
    void draw_layers();
    void style_button(const std::string& name, const char* said);

    StyleCache style_cache_;
    GuidePicture guide_;
    StrokeDocument document_;
    StrokeLayers layers_;
    LivePen pen_;
    StrokeReplay replay_;
    std::vector<StrokeDocument> undone_from_, redone_from_;
    StrokeSettings next_;                   // of the next stroke
    float smoothing_ = 1.0f, beta_ = 0.2f;  // where the sliders are: the settings follow when they are let go
    bool keeps_colors_ = false;             // of strokes that settings are applied to
    std::set<StrokePtr> selected_;          // what was recorded stays, whatever it is made to look like

    Tool tool_ = Tool::draw;
    Ground ground_ = Ground::mesh;
    float height_mm_ = 4.0f, lift_m_ = 0.004f;
    float replay_speed_ = 1.0f;
    bool lifts_pen_ = false;  // once its stroke is the layer's
    bool is_warm_ = false;
    bool begins_on_floor_ = false;  // the stroke under way; it stays there where the floor is seen
    float last_depth_ = 0.0f;       // metres from the eye of what was drawn last, for beside the mesh
    double stroke_start_s_ = 0.0;
    std::optional<StrokeSample> hovered_;
    std::optional<Found> hovered_stroke_;
};

}  // namespace flg::studio
