// SPDX-License-Identifier: MIT
#include "skeletons/skeletons.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"
#include "skeletons/ink.h"
#include "workspaces.h"

namespace flg::studio {

Skeletons::Skeletons(AppContext& app)
    : Workspace(app), editor_(app), picture_(app.renderer), layer_(app.renderer, app.notices) {
    editor_.did = [this] { app_.timeline.push(*this); };
}

std::string Skeletons::help() const {
    switch (mode_) {
        case Mode::draw:
            return editor_.drawing().parts.empty()
                       ? "Drag a closed outline. It becomes a body with bones. Drop a "
                         "picture to trace it."
                       : "Draw the next part so that it overlaps the body. Shift-drag inside a "
                         "part cuts a hole. Click selects.";
        case Mode::move:
            return "Drag a part to move it, Shift-drag for depth. The handles turn and resize the selected part.";
        case Mode::points:
            return editor_.selected() == nullptr
                       ? "Click a part to see the points of its line."
                       : "Drag a point, and its neighbours follow. Shift-drag moves it alone. Double-click the line to "
                         "add a point. Delete removes it.";
        case Mode::refine:
            return "Set the number of bones with the sliders. Click a part, then a branch, to refine only that. Drag a "
                   "joint to pin it.";
        case Mode::weights:
            return "Click a joint to see how much of the body follows it. Then paint. Shift-drag takes away what a "
                   "drag "
                   "adds.";
        case Mode::pull:
            return "Drag any point of the body. It stays where you let go, as a pin. Click a pin to release it.";
        default: return "Drag a joint to pose it. Shift-drag twists its bone. Double-click resets a joint.";
    }
}

void Skeletons::enter() {
    is_in_front_ = true;
    app_.scene.stop_playing();
    // The paper is looked at by itself.
    scene_camera_ = app_.view.orbit.camera;
    if (own_camera_)
        app_.view.orbit.camera = *std::exchange(own_camera_, std::nullopt);
    else
        wants_frame_ = true;
}

bool Skeletons::is_settled() const {
    const bool is_shown = (app_.scene.drawing() != nullptr) == !editor_.drawing().parts.empty();
    return !editor_.is_acting() && !editor_.contours.busy() && is_shown;
}

void Skeletons::leave() {
    is_in_front_ = false;
    // It goes on in the scene.
    if (SceneMesh* mesh = app_.scene.drawing()) mesh->plays = is_playing_;
    is_playing_ = false;
    drop_tools();
    if (!wants_frame_) own_camera_ = app_.view.orbit.camera;
    if (scene_camera_) app_.view.orbit.camera = *std::exchange(scene_camera_, std::nullopt);
    app_.scene.set_in_sight(true);
    for (const auto& mesh : app_.scene.meshes())
        if (mesh->drawn.value != 0) app_.renderer.set_visible(mesh->drawn, mesh->visible);
}

void Skeletons::drop_tools() {
    editor_.commit();
    draw_.drop();
    move_.drop();
    points_.leave();
    paint_.leave();
    pull_.leave();
    pose_.leave();
    branch_.leave();
    joint_.leave();
}

void Skeletons::drop_drags() {
    draw_.drop(), move_.drop(), points_.drop(), paint_.drop(), pull_.drop(), joint_.drop(), pose_.drop();
}

void Skeletons::set_mode(Mode mode) {
    drop_tools();
    if (mode != Mode::pose && mode != Mode::pull) play(false);
    mode_ = mode;
}

void Skeletons::play(bool on) {
    is_playing_ = on;
    if (!on) return;
    was_played_ = true;
    play_from_ = app_.seconds;
}

void Skeletons::frame_drawing(const glm::vec3& sight) {
    // Half of what is seen while there is nothing: of a size that fits what is in the scene, else metres.
    constexpr glm::vec3 kPaper{2.0f, 1.4f, 0.1f};
    constexpr float kOfScene = 0.3f;
    render::Box box = editor_.drawing().box();
    if (box.empty()) {
        const render::Box scene = app_.scene.box();
        const glm::vec3 half = scene.empty() ? kPaper : kPaper * (kOfScene * scene.diagonal());
        box = {-half, half};
    }
    app_.view.frame(box, sight);
}

// Those of the scene are in the way here with all that is on them, unless they are wanted.
void Skeletons::hide_meshes() {
    app_.scene.set_in_sight(shown_.meshes);
    for (const auto& mesh : app_.scene.meshes())
        if (mesh->drawn.value != 0)
            app_.renderer.set_visible(mesh->drawn, mesh->visible && shown_.meshes && !mesh->is_drawing());
}

void Skeletons::update() {
    editor_.contours.update();
    layer_.update(editor_.drawing().picture);
    const bool is_changing = move_.is_dragging() || points_.is_dragging() || joint_.is_dragging() || is_sliding_;
    const Body body = is_sliding_ && mode_ == Mode::refine ? Body::none : is_changing ? Body::quick : Body::fine;
    editor_.live.update(editor_.drawing(), body);
    weights_.update(mode_ == Mode::weights && is_in_front_);
    app_.scene.set_drawing(!editor_.drawing().parts.empty());
    give_surface();
    play_in_scene();
    if (is_in_front_) hide_meshes();
    if (is_in_front_ && wants_frame_ && app_.view.viewport.z > 1) {
        wants_frame_ = false;
        frame_drawing({0.0f, 0.0f, -1.0f});
    }
    show_model();
}

void Skeletons::give_surface() {
    const LiveModel::Skinned* skin = editor_.live.skin();
    SceneMesh* mesh = app_.scene.drawing();
    if (skin == nullptr || mesh == nullptr || editor_.live.busy() || editor_.is_acting()) return;
    std::vector<glm::vec3> colors;
    for (const uint32_t id : skin->parts) {
        const DrawnPart* part = editor_.drawing().find(id);
        colors.push_back(part != nullptr ? glm::min(part->color, 1.0f) : glm::vec3(0.5f));
    }
    if (mesh->surface && given_revision_ == editor_.live.shape_revision() && given_colors_ == colors) return;
    const FlgSkinView& view = skin->view;
    std::vector<float> color_of;
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        const glm::vec3& color = colors[view.vertex_parts[v]];
        color_of.insert(color_of.end(), {color.x, color.y, color.z, 1.0f});
    }
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, view.positions, 0, 0},
                                 {FLG_ATTRIBUTE_COLOR, 4, color_of.data(), 0, 0}};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    FlgMeshView input = flgMeshViewDefaults();
    input.vertex_count = view.vertex_count;
    input.triangle_count = view.triangle_count;
    input.columns = columns;
    input.column_count = 2;
    input.triangles = view.triangles;
    desc.mesh = &input;
    filigree::Job job;
    filigree::Surface surface = app_.context.surface(desc, &job);
    app_.scene.supply(*mesh, std::move(surface), std::move(job));
    given_revision_ = editor_.live.shape_revision();
    given_colors_ = std::move(colors);
}

const Rig* Skeletons::shown_rig() const {
    const LiveModel::Skinned* skin = editor_.live.skin();
    return (is_posed() || mode_ == Mode::weights) && skin != nullptr ? &skin->rig : editor_.live.rig();
}

uint64_t Skeletons::shown_revision() const {
    const bool is_of_skin = (is_posed() || mode_ == Mode::weights) && editor_.live.skin() != nullptr;
    return is_of_skin ? 2 * editor_.live.skin_revision() : 2 * editor_.live.rig_revision() + 1;
}

std::vector<glm::quat> Skeletons::shown_turns(const Rig& rig) const {
    if (!is_posed()) return std::vector<glm::quat>(rig.count(), glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
    std::vector<glm::quat> turns = turns_of(rig, editor_.drawing().pose);
    const LiveModel::Skinned* skin = editor_.live.skin();
    return is_playing_ && skin != nullptr ? moved_turns(std::move(turns), app_.seconds - play_from_) : turns;
}

std::vector<glm::quat> Skeletons::moved_turns(std::vector<glm::quat> turns, double seconds) const {
    const LiveModel::Skinned* skin = editor_.live.skin();
    const FlgSkinAnimation animation = skin->motion.animation();
    const auto time = static_cast<float>(std::fmod(seconds, static_cast<double>(skin->motion.times.back())));
    std::vector<float> moved(4 * turns.size());
    filigree::check(flgSkinAnimationSample(&animation, skin->view.joint_count, time, moved.data(), nullptr));
    for (size_t j = 0; j < turns.size(); ++j)
        turns[j] =
            glm::normalize(turns[j] * glm::quat(moved[4 * j + 3], moved[4 * j], moved[4 * j + 1], moved[4 * j + 2]));
    return turns;
}

void Skeletons::play_in_scene() {
    SceneMesh* mesh = app_.scene.drawing();
    const LiveModel::Skinned* skin = editor_.live.skin();
    if (mesh == nullptr) return;
    const bool is_of_skin = skin != nullptr && given_revision_ == editor_.live.shape_revision();
    if (!mesh->plays || is_in_front_ || !is_of_skin) return mesh->bend.rest();
    if (bent_revision_ != editor_.live.skin_revision() || mesh->bend.skin() == nullptr) {
        mesh->bend.take(skin->view);
        bent_revision_ = editor_.live.skin_revision();
    }
    if (mesh->bent() == nullptr) play_from_ = app_.seconds;
    const std::vector<glm::quat> still(skin->rig.count(), glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
    std::vector<float> rotations, joints(8 * skin->rig.count());
    for (const glm::quat& turn : moved_turns(still, app_.seconds - play_from_))
        rotations.insert(rotations.end(), {turn.x, turn.y, turn.z, turn.w});
    filigree::check(flgSkinPose(&skin->view, rotations.data(), nullptr, nullptr, joints.data()));
    mesh->bend.pose(std::move(joints));
}

void Skeletons::show_model() {
    const LiveModel::Skinned* skin = editor_.live.skin();
    const uint32_t chosen = is_in_front_ && !is_posed() && mode_ != Mode::weights ? editor_.selected_id() : 0;
    if (picture_.show_body(skin, editor_.live.skin_revision(), editor_.drawing(), chosen)) transforms_.clear();
    const glm::vec3 shift = is_posed() ? editor_.drawing().pose.shift : glm::vec3(0.0f);
    if (skin != nullptr && skin_floor_of_ != editor_.live.skin_revision()) {
        skin_floor_of_ = editor_.live.skin_revision();
        skin_floor_ = skin->view.positions[1];
        for (uint32_t v = 1; v < skin->view.vertex_count; ++v)
            skin_floor_ = std::min(skin_floor_, skin->view.positions[3 * v + 1]);
    }
    if (skin != nullptr) {
        const std::vector<glm::quat> turns = shown_turns(skin->rig);
        std::vector<float> rotations;
        for (const glm::quat& turn : turns) rotations.insert(rotations.end(), {turn.x, turn.y, turn.z, turn.w});
        const bool is_linear = skinning_ == FLG_SKINNING_LINEAR;
        std::vector<float> transforms((is_linear ? 12 : 8) * skin->rig.count());
        filigree::check(flgSkinPose(&skin->view, rotations.data(), &shift.x, is_linear ? transforms.data() : nullptr,
                                    is_linear ? nullptr : transforms.data()));
        if (transforms != transforms_ || skinning_ != transforms_as_) {
            picture_.pose_body(skinning_, transforms);
            transforms_ = std::move(transforms);
            transforms_as_ = skinning_;
        }
    }
    show_weights();
    show_pulled();
    const bool has_shape = shows_weights() || shows_pulled();
    if (!has_shape) picture_.hide_shape();
    picture_.set_body_visible(shown_.body && is_in_front_ && !has_shape);
    const Rig* rig = shown_rig();
    joints_ = rig == nullptr ? PosedJoints{} : posed(*rig, shown_turns(*rig), shift);
    const bool sees_bones = rig != nullptr && is_in_front_ && shown_.bones;
    ModelPicture::BonesLook look;
    look.selected_part = chosen;
    if (rig != nullptr && mode_ == Mode::pose) look.bright = pose_.bright(*rig);
    if (rig != nullptr && mode_ == Mode::refine) look.bright = joint_.bright(*rig);
    if (rig != nullptr && mode_ == Mode::weights) look.bright = paint_.bright(*rig);
    picture_.show_bones(sees_bones ? *rig : Rig{}, shown_revision(), joints_.at, look);
}

bool Skeletons::shows_weights() const {
    const LiveModel::Skinned* skin = editor_.live.skin();
    return is_in_front_ && mode_ == Mode::weights && skin != nullptr && weights_.weights() != nullptr &&
           paint_.chosen(skin->rig).has_value();
}

void Skeletons::show_weights() {
    if (!shows_weights()) return;
    const LiveModel::Skinned& skin = *editor_.live.skin();
    const uint32_t joint = *paint_.chosen(skin.rig);
    const std::vector<float> field = weights_.weights()->of_joint(static_cast<uint16_t>(joint));
    picture_.show_shape(skin, {skin.view.positions, size_t{3} * skin.view.vertex_count}, field,
                        {editor_.live.skin_revision(), weights_.revision(), joint});
}

bool Skeletons::shows_pulled() const {
    return is_in_front_ && mode_ == Mode::pull && editor_.live.skin() != nullptr && !pull_.solver().positions().empty();
}

void Skeletons::show_pulled() {
    if (!is_in_front_ || mode_ != Mode::pull) return;
    if (editor_.live.skin() == nullptr) return pull_.leave();
    pull_.update(posed_positions());
    if (!shows_pulled()) return;
    picture_.show_shape(*editor_.live.skin(), pull_.solver().positions(), {},
                        {editor_.live.shape_revision(), pull_.solver().revision(), FLG_NO_INDEX});
}

std::vector<float> Skeletons::posed_positions() const {
    const LiveModel::Skinned& skin = *editor_.live.skin();
    if (editor_.drawing().pose.is_rest() && !is_playing_) return {};
    std::vector<float> positions(size_t{3} * skin.view.vertex_count);
    filigree::check(flgSkinDeform(&skin.view, transforms_as_, transforms_.data(), positions.data(), nullptr));
    return positions;
}

void Skeletons::pointer(const Pointer& mouse) {
    if (mode_ == Mode::draw) return draw_.pointer(mouse);
    if (mode_ == Mode::move) return move_.pointer(mouse);
    if (mode_ == Mode::points) return points_.pointer(mouse);
    const Rig* rig = shown_rig();
    const bool has_joints = rig != nullptr && joints_.at.size() == rig->count();
    if (mode_ == Mode::refine) {
        if (!has_joints || !joint_.pointer(mouse, *rig, joints_)) branch_.pointer(mouse);
        return;
    }
    if (mode_ == Mode::weights)
        return has_joints && editor_.live.skin() != nullptr ? paint_.pointer(mouse, *rig, joints_) : paint_.leave();
    if (mode_ == Mode::pull) return pull_.pointer(mouse);
    if (!has_joints) return pose_.leave();
    // A motion that goes on would take the joint away from under the mouse.
    if (is_playing_ && mouse.pressed && mouse.inside) play(false);
    pose_.pointer(mouse, *rig, joints_);
}

void Skeletons::overlay(ImDrawList& list) {
    if (mode_ == Mode::draw || mode_ == Mode::move || mode_ == Mode::points)
        layer_.draw(list, app_.view, editor_.drawing().picture);
    if (!is_posed() && mode_ != Mode::weights) draw_outlines(list);
    if (mode_ == Mode::draw && editor_.drawing().parts.empty() && !draw_.is_drawing() && !layer_.is_shown())
        draw_invitation(list);
    if (mode_ == Mode::draw) draw_.overlay(list);
    if (mode_ == Mode::move) move_.overlay(list);
    if (mode_ == Mode::points) points_.overlay(list);
    if (mode_ == Mode::refine) branch_.overlay(list);
    if (mode_ == Mode::pull) pull_.overlay(list);
    const Rig* rig = shown_rig();
    if (rig == nullptr || joints_.at.size() != rig->count()) return;
    if (mode_ == Mode::refine) joint_.overlay(list, *rig, joints_);
    if (mode_ == Mode::pose) pose_.overlay(list, *rig, joints_);
    if (mode_ == Mode::weights) paint_.overlay(list, *rig, joints_);
}

void Skeletons::draw_invitation(ImDrawList& list) const {
    constexpr const char* kText = "Draw the outline of a body here";
    constexpr int kDashes = 48;
    const glm::vec4 v(app_.view.viewport);
    const glm::vec2 middle(v.x + 0.5f * v.z, v.y + 0.5f * v.w), half = 0.28f * glm::vec2(v.z, 0.7f * v.w);
    for (int i = 0; i < kDashes; ++i) {
        const auto at = [&](float step) {
            const float angle = 6.2831853f * (static_cast<float>(i) + step) / kDashes;
            return ImVec2(middle.x + half.x * std::cos(angle), middle.y + half.y * std::sin(angle));
        };
        list.AddLine(at(0.0f), at(0.55f), ink::kFaint, 2.0f * app_.scale);
    }
    const ImVec2 size = ImGui::CalcTextSize(kText);
    list.AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, ink::kLine, kText);
}

void Skeletons::draw_outlines(ImDrawList& list) const {
    const float unit = app_.scale;
    for (const DrawnPart& part : editor_.drawing().parts) {
        if (!part.visible) continue;
        const LiveModel::PartState& state = editor_.live.state_of(part.contour);
        const bool is_chosen = part.id == editor_.selected_id(), is_wrong = !state.fault.empty();
        const bool is_hovered = mode_ == Mode::move && part.id == move_.hovered_part();
        const ImU32 color = is_wrong ? ink::kWrong : is_chosen ? ink::kChosen : is_hovered ? ink::kHover : ink::kFaint;
        for (const bool is_image : {false, true}) {
            if (is_image && (!part.mirrored || is_wrong)) continue;
            if (!shown_.outlines && !is_wrong && !is_chosen && !is_hovered) continue;
            for (const Ring& ring : part.contour->rings) {
                const auto line = ring_in_window(app_.view, part, ring, is_image ? &editor_.drawing().mirror : nullptr);
                ink::line(list, line, color, (is_chosen || is_hovered || is_wrong ? 2.5f : 1.2f) * unit, true);
            }
        }
        for (const glm::dvec2& place : state.crossings) {
            const auto at = app_.view.project(glm::vec3(part.matrix() * glm::dvec4(place, 0.0, 1.0)));
            if (!at) continue;
            list.AddCircle({at->x, at->y}, 11.0f * unit, ink::kShade, 0, 5.0f * unit);
            list.AddCircle({at->x, at->y}, 11.0f * unit, ink::kWrong, 0, 3.0f * unit);
        }
        if (const auto at = app_.view.project(glm::vec3(part.centre())))
            ui::mark("part " + part.name, {*at - 6.0f * unit, *at + 6.0f * unit});
    }
}

bool Skeletons::shortcut(const Chord& chord) {
    if (chord.control) {
        if (chord.key != GLFW_KEY_D) return false;
        editor_.duplicate_selected();
        return true;
    }
    switch (chord.key) {
        case GLFW_KEY_Q: set_mode(Mode::draw); return true;
        case GLFW_KEY_W: set_mode(Mode::move); return true;
        case GLFW_KEY_E: set_mode(Mode::refine); return true;
        case GLFW_KEY_R: set_mode(Mode::pose); return true;
        case GLFW_KEY_P: set_mode(Mode::points); return true;
        case GLFW_KEY_T: set_mode(Mode::weights); return true;
        case GLFW_KEY_Y: set_mode(Mode::pull); return true;
        case GLFW_KEY_DELETE:
        case GLFW_KEY_BACKSPACE:
            // Never the part, when a point was meant.
            if (mode_ == Mode::points) {
                points_.remove_chosen();
                return true;
            }
            drop_tools();
            editor_.remove_selected();
            return true;
        case GLFW_KEY_SPACE:
            if (mode_ == Mode::pull && editor_.drawing().pulls.record) {
                pull_.play(!pull_.is_playing());
                return true;
            }
            if (!is_posed()) return false;
            play(!is_playing_);
            return true;
        case GLFW_KEY_ESCAPE: {
            const bool was_drawing = draw_.is_drawing() || paint_.is_painting() || editor_.is_acting();
            drop_drags();
            editor_.cancel();
            if (!was_drawing) editor_.select(0), paint_.choose({});
            return true;
        }
        default: return false;
    }
}

std::span<const Workspace::Shortcut> Skeletons::shortcuts() const {
    static constexpr Shortcut kShortcuts[] = {
        {"Q, W, E, R", "Draw, move, refine, pose"},
        {"P, T, Y", "Points of a line, weights, pull"},
        {"Shift+drag in Draw", "Cut a hole in the part"},
        {"Shift+drag in Move", "Move nearer or farther"},
        {"Shift+drag in Points", "Move a point alone"},
        {"Double-click in Points", "Add a point to the line"},
        {"Delete in Points", "Remove the chosen point"},
        {"Drag in Refine", "Pin a joint elsewhere"},
        {"Shift+drag in Pose", "Twist a bone"},
        {"Shift+drag in Weights", "Take away in place of adding"},
        {"Click in Pull", "Set or release a pin"},
        {"Double-click in Pose", "Reset a joint"},
        {"Space in Pose, Pull", "Play or stop the motion"},
        {"Delete", "Delete the selected part"},
        {"Ctrl+D", "Duplicate the selected part"},
        {"Escape", "Drop the drag, or clear the selection"},
    };
    return kShortcuts;
}

bool Skeletons::give_up() {
    const bool has_some = draw_.is_drawing() || paint_.is_painting() || editor_.is_acting();
    if (!has_some) return false;
    drop_drags();
    editor_.cancel();
    return true;
}

void Skeletons::undo() {
    drop_drags();
    editor_.undo();
}

void Skeletons::redo() {
    drop_drags();
    editor_.redo();
}

// Under the body at rest, which stands still while it is posed.
float Skeletons::floor() const {
    const LiveModel::Skinned* skin = editor_.live.skin();
    if (shown_.meshes || skin == nullptr) return app_.scene.floor();
    return skin_floor_;
}

bool Skeletons::busy() const {
    return is_playing_ || (mode_ == Mode::pull && pull_.busy()) || editor_.live.is_binding() || weights_.busy() ||
           editor_.live.busy() || editor_.contours.busy() || layer_.busy();
}

void Skeletons::device_lost() {
    picture_.device_lost();
    layer_.device_lost();
    transforms_.clear();
}

double Skeletons::count(const std::string& name) const {
    const Drawing& drawing = editor_.drawing();
    const auto parts_where = [&](auto holds) {
        return static_cast<double>(std::count_if(drawing.parts.begin(), drawing.parts.end(), holds));
    };
    const Rig* rig = shown_rig();
    if (name == "parts") return static_cast<double>(drawing.parts.size());
    if (name == "mirrored") return parts_where([](const DrawnPart& part) { return part.mirrored; });
    if (name == "hidden") return parts_where([](const DrawnPart& part) { return !part.visible; });
    if (name == "holes") return parts_where([](const DrawnPart& part) { return part.contour->rings.size() > 1; });
    if (name == "points") {
        size_t points = 0;
        if (editor_.selected() != nullptr)
            for (const Ring& ring : editor_.selected()->contour->rings) points += ring.size();
        return static_cast<double>(points);
    }
    if (name == "line_length")
        return editor_.selected() != nullptr
                   ? editor_.selected()->scale * length_of(editor_.selected()->contour->rings[0])
                   : 0.0;
    if (name == "renamed") {
        double renamed = 0.0;
        for (size_t j = 0; rig != nullptr && j < rig->count(); ++j)
            renamed += rig->names[j] != rig->keys[j] ? 1.0 : 0.0;
        return renamed;
    }
    if (name == "faults") return static_cast<double>(editor_.live.fault_count(drawing));
    if (name == "selected") return editor_.selected() != nullptr ? 1.0 : 0.0;
    if (name == "joints") return rig == nullptr ? 0.0 : static_cast<double>(rig->count());
    if (name == "roots") return rig == nullptr ? 0.0 : static_cast<double>(rig->count() - rig->bone_count());
    if (name == "vertices") return editor_.live.skin() ? editor_.live.skin()->view.vertex_count : 0.0;
    if (name == "pinned")
        return rig == nullptr ? 0.0 : static_cast<double>(std::count(rig->pinned.begin(), rig->pinned.end(), true));
    if (name == "joint_edits") return static_cast<double>(drawing.joint_edits.size());
    if (name == "weight_strokes") return static_cast<double>(drawing.weight_strokes.size());
    if (name == "lost_strokes") return static_cast<double>(weights_.lost_count());
    if (name == "weight") {
        const LiveModel::Skinned* skin = editor_.live.skin();
        const auto joint = skin != nullptr ? paint_.chosen(skin->rig) : std::nullopt;
        if (!joint || weights_.weights() == nullptr) return 0.0;
        double sum = 0.0;
        for (const float share : weights_.weights()->of_joint(static_cast<uint16_t>(*joint))) sum += share;
        return sum / skin->view.vertex_count;
    }
    if (name == "pins") return static_cast<double>(drawing.pulls.pins.size());
    if (name == "lost_pins") return static_cast<double>(pull_.solver().lost_count());
    if (name == "keys") return drawing.pulls.record ? static_cast<double>(drawing.pulls.record->keys.size()) : 0.0;
    if (name == "pulled") {
        const auto positions = pull_.solver().positions();
        double most = 0.0;
        for (size_t i = 0; editor_.live.skin() != nullptr && i < positions.size(); ++i)
            most = std::max(most, static_cast<double>(std::abs(positions[i] - editor_.live.skin()->view.positions[i])));
        return most;
    }
    if (name == "turned") return static_cast<double>(drawing.pose.turns.size());
    if (name == "playing") return is_playing_ || pull_.is_playing() ? 1.0 : 0.0;
    if (name == "picture") return layer_.is_shown() ? 1.0 : 0.0;
    if (name == "mode") return static_cast<double>(mode_);
    throw StudioError("skeletons has no value named " + name + ".");
}

std::unique_ptr<Workspace> make_skeletons(AppContext& app) {
    return std::make_unique<Skeletons>(app);
}

}  // namespace flg::studio
