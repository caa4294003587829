// SPDX-License-Identifier: MIT
// Strokes: drawn in space on a mesh, on a plane that faces the camera or on the floor, and stylized while they are drawn.
#pragma once

#include "strokes/live_pen.h"
#include "strokes/stroke_replay.h"

namespace flg::studio {

class StrokesWorkspace final : public Workspace {
public:
    explicit StrokesWorkspace(Desk& desk);

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
    bool open(const std::string& path) override;
    nlohmann::json save() const override { return to_json(document_); }
    void load(const nlohmann::json& part) override;
    std::span<const Export> exports() const override;
    void write(const Export& what, const std::string& path) override;
    bool busy() const override { return layers_.busy() || replay_.layer() != 0 || lifts_pen_ || !is_warm_; }
    void device_lost() override;
    double count(const std::string& name) const override;

private:
    enum class Tool { draw, draw_style, erase };
    enum class Ground { mesh, facing, floor };

    // Before an act: what undo goes back to. Acts of one drag of a slider are one.
    void remember();
    void set_tool(Tool tool);
    std::optional<StrokeSample> sample_at(glm::vec2 px) const;
    void begin_stroke(const Pointer& mouse);
    void end_stroke();
    void erase(const Pointer& mouse);
    // The stroke of the visible layers that is drawn nearest to a pixel, within reach.
    struct Found {
        uint32_t layer = 0;
        size_t stroke = 0;
    };
    std::optional<Found> stroke_at(glm::vec2 px) const;

    void draw_tools();
    void draw_styles();
    void draw_sliders();
    void draw_layers();
    void style_button(const std::string& name, const char* said);
    // Of the widget made last, on a copy of the active layer's settings.
    void take(const StrokeSettings& changed, bool is_changed);

    StyleShelf shelf_;
    StrokeDocument document_;
    StrokeLayers layers_;
    LivePen pen_;
    StrokeReplay replay_;
    std::vector<StrokeDocument> undone_from_, redone_from_;
    bool slider_remembered_ = false;

    Tool tool_ = Tool::draw;
    Ground ground_ = Ground::mesh;
    float height_mm_ = 4.0f;
    float replay_speed_ = 1.0f;
    bool lifts_pen_ = false;  // once its stroke is the layer's
    bool is_warm_ = false;
    float last_depth_ = 0.0f;  // metres from the eye of what was drawn last, for beside the mesh
    double stroke_start_s_ = 0.0;
    std::optional<StrokeSample> hovered_;
    std::optional<Found> hovered_stroke_;
};

}  // namespace flg::studio
