// SPDX-License-Identifier: MIT
// Tangles: regions of meshes are clicked and divided, again and again, by operators whose numbers can be changed while
// one looks. What the user asks for while a step is under way waits for it, in order.
#pragma once

#include <deque>
#include <map>
#include <memory>

#include "tangles/highlight.h"
#include "tangles/ornament.h"
#include "tangles/region_rows.h"
#include "tangles/undo_steps.h"

namespace flg::studio {

class TanglesWorkspace final : public Workspace {
public:
    explicit TanglesWorkspace(AppContext& app);

    const char* title() const override { return "Tangles"; }
    std::string help() const override;
    void enter() override { in_front_ = true; }
    void leave() override;
    void update() override;
    void panel() override;
    void pointer(const Pointer& mouse) override;
    void overlay(ImDrawList& list) override;
    bool shortcut(const Chord& chord) override;
    std::span<const Shortcut> shortcuts() const override;
    bool can_undo() const override { return undo_steps_.can_undo(); }
    bool can_redo() const override { return undo_steps_.can_redo(); }
    void undo() override;
    void redo() override;
    void forget_undone() override { undo_steps_.forget_undone(); }
    void settle() override;
    bool is_settled() const override { return commands_.empty() && all_idle() && trying() == nullptr; }
    bool open(const std::string& path) override;
    nlohmann::json save() const override;
    void load(const nlohmann::json& part) override;
    std::span<const Export> exports() const override;
    void write(const Export& what, const std::string& path) override;
    bool busy() const override;
    void device_lost() override;
    double count(const std::string& name) const override;

private:
    enum class Picks { region, group, alike };

    // The one of the active mesh; null while there is none.
    Ornament* active() const;
    Ornament* find(uint32_t mesh) const;
    Ornament* trying() const;  // whose step is not accepted yet
    // Waits until no step is under way.
    void later(std::function<void()> command) { commands_.push_back(std::move(command)); }
    bool all_idle() const;
    Ornament::Owner owner();
    Ornament& make_ornament(const SceneMesh& mesh);

    // What can be done; all through later().
    void try_action(Action action);
    void try_again(Ornament& ornament);
    void keep();
    void discard();
    // Throws StudioError if nobody could see what is done to it.
    void need_visible(const Ornament& ornament) const;
    void change_regions(const char* name, filigree::Job (*begin)(Ornament&, const Regions&));
    void paint(uint32_t material, Regions on);
    // Paints the selection; while a step is tried, only what that makes.
    void choose_material(uint32_t material);
    UndoStep paint_of(const Ornament& ornament, uint32_t material, const Regions& on) const;
    UndoStep paint_of_step(const Ornament& ornament) const;
    void do_paint(UndoStep step);
    void did(UndoStep step);
    void apply(const UndoStep& step, bool forward);
    void recolor_all();
    // Ornament that waits for a surface to be made on, or for another one than that on which it could not be.
    struct Waiting {
        nlohmann::json json;  // history and paints
        std::optional<uint32_t> failed_generation{};
    };
    void make_waiting();
    void replay(Ornament& ornament, Waiting waiting);
    nlohmann::json to_json(const Ornament& ornament) const;

    void select(Regions regions);
    void select_parents();
    void select_all();
    // What a click on a leaf means.
    Regions meant(const Ornament& ornament, uint32_t leaf) const;
    void refresh_highlights();
    void take_snapshot();
    // What is saved, by meshes' identifiers: they outlive places in the scene.
    struct Kept {
        std::map<uint32_t, nlohmann::json> ornaments;  // history and paints
        nlohmann::json palette;
        UndoSteps acts;
    };
    Kept kept() const;

    // The mouse. True: it was for the seeds of the step that is tried.
    bool edit_seeds(Ornament& ornament, const Pointer& mouse);
    bool edit_points(Ornament& ornament, SeedChoice& seeds, const Pointer& mouse);
    bool edit_borders(Ornament& ornament, SeedChoice& seeds, const Pointer& mouse);
    std::optional<SeedPoint> place_under(const Ornament& ornament, const Ray& ray) const;
    // Of places on the ornament's mesh, in its own space.
    bool is_hidden(const Ornament& ornament, const glm::vec3& own) const;
    std::optional<glm::vec2> project(const Ornament& ornament, const glm::vec3& own) const;
    // A click that waits for the picking scene, which is being built for a while after each step.
    struct Click {
        Ray ray;
        bool shift, control, adds_point;
    };
    // False: it has to wait.
    bool click(const Click& click);
    bool add_point(Ornament& ornament, SeedChoice& seeds, const Ray& ray);
    SeedChoice& edited_seeds(LiveStep& live);
    bool delete_point();

    // The panel.
    void draw_selection(const Ornament& ornament);
    void draw_deeds();
    void action_button(Action action, int across);
    void draw_live(Ornament& ornament);
    void draw_sizes(Ornament& ornament);
    void draw_chance(Ornament& ornament);
    void draw_seeds(Ornament& ornament);
    void draw_seed_choice(LiveStep& live, SeedChoice& seeds, bool is_from);
    void draw_profile(const Recipe& recipe);
    void draw_materials();
    void draw_material_editor();
    void draw_regions(const Ornament& ornament);
    void draw_history(Ornament& ornament);
    void draw_step_edit(const Ornament& ornament);

    // Of steps before the last.
    enum class EditKind { mute, move, remove };
    void edit_history(const char* name, uint32_t to, EditKind kind);
    void run_edit(Ornament& ornament, const char* name, filigree::Job job, Ornament::Moved moved, uint32_t to,
                  bool goes_on);
    void try_edit();

    Palette palette_ = house_palette();
    std::map<uint32_t, std::unique_ptr<Ornament>> ornaments_;
    std::map<uint32_t, Waiting> waiting_;
    UndoSteps undo_steps_;
    std::deque<std::function<void()>> commands_;
    bool in_front_ = false;

    Regions selected_, hovered_;
    uint32_t selected_mesh_ = 0, hovered_mesh_ = 0;
    Picks picks_ = Picks::group;
    bool paints_ = false;  // with clicks
    uint32_t material_ = 1;
    std::optional<Palette> palette_before_;  // while it is being changed
    RegionRows rows_;
    bool shows_groups_ = false, hovers_row_ = false;

    // The step that is chosen in the list, and what its numbers become.
    struct StepEdit {
        uint32_t mesh, step;
        StepNumbers now, tried, first{};
        uint32_t tries = 0;
        std::string error{};
    };
    std::optional<StepEdit> step_edit_;

    // Of the step that is tried.
    bool edits_towards_ = false;
    std::optional<size_t> hovered_point_, dragged_point_;
    struct Grip {
        uint32_t loop;
        float share;
    };
    std::optional<Grip> hovered_grip_, dragged_grip_;
    glm::vec2 pressed_px_{0.0f};
    bool pressed_on_picture_ = false;
    std::deque<Click> waiting_clicks_;
    std::string refusal_;  // why the last button could not do it

    // What is drawn, and of what.
    struct Shown {
        uint32_t mesh = 0, revision = 0;
        Regions regions{};
        render::Placement placement{};
        bool operator==(const Shown&) const = default;
    };
    Highlight selection_lines_, hover_lines_, grip_lines_;
    Shown selection_shown_, hover_shown_;

    Kept snapshot_;  // when all was last idle
    uint64_t snapshot_changes_ = 0;
    double snapshot_after_s_ = 0.0;
};

}  // namespace flg::studio
