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

Skeletons::Skeletons(Desk& desk)
    : Workspace(desk), editor_(desk), picture_(desk.renderer), layer_(desk.renderer, desk.notices) {}

std::string Skeletons::help() const {
    switch (mode_) {
        case Mode::draw:
            return editor_.drawing().parts.empty() ? "Draw a closed line with the left button: it becomes a body with "
                                                     "bones. Drop a picture to draw over it."
                                                   : "Draw the next part where it meets the others. With Shift inside "
                                                     "of a part: a hole. Click selects.";
        case Mode::move:
            return "Drag a part; with Shift nearer or farther. The knobs turn, size and move the selected one.";
        case Mode::refine:
            return "Fewer or more bones by the sliders. Click a part, then a branch of it, to refine that alone.";
        default: return "Drag a joint to pose; with Shift its bone turns about itself. Double click puts a joint back.";
    }
}

void Skeletons::enter() {
    is_in_front_ = true;
}

void Skeletons::leave() {
    is_in_front_ = false;
    play(false);
    drop_tools();
    for (const auto& mesh : desk_.scene.meshes())
        if (mesh->drawn.value != 0) desk_.renderer.set_visible(mesh->drawn, mesh->visible);
}

void Skeletons::drop_tools() {
    editor_.commit();
    draw_.drop();
    move_.drop();
    pose_.leave();
    branch_.leave();
}

void Skeletons::set_mode(Mode mode) {
    drop_tools();
    if (mode != Mode::pose) play(false);
    mode_ = mode;
}

void Skeletons::play(bool on) {
    is_playing_ = on;
    if (!on) return;
    was_played_ = true;
    play_from_ = desk_.seconds;
}

void Skeletons::frame_drawing(const glm::vec3& sight) {
    constexpr glm::vec3 kPaper{2.0f, 1.4f, 0.1f};  // half of what is seen while there is nothing, metres
    render::Box box = editor_.drawing().box();
    if (box.empty()) box = {-kPaper, kPaper};
    desk_.view.frame(box, sight);
}

// Those of the scene are in the way here, unless they are wanted.
void Skeletons::hide_meshes() {
    for (const auto& mesh : desk_.scene.meshes())
        if (mesh->drawn.value != 0) desk_.renderer.set_visible(mesh->drawn, mesh->visible && shown_.meshes);
}

void Skeletons::update() {
    editor_.contours.update();
    layer_.update(editor_.drawing().picture);
    const bool is_changing = move_.is_dragging() || is_sliding_;
    const Body body = is_sliding_ && mode_ == Mode::refine ? Body::none : is_changing ? Body::quick : Body::fine;
    editor_.live.update(editor_.drawing(), body);
    if (is_in_front_) hide_meshes();
    if (is_in_front_ && wants_frame_ && desk_.view.viewport.z > 1) {
        wants_frame_ = false;
        frame_drawing({0.0f, 0.0f, -1.0f});
    }
    show_model();
}

const Rig* Skeletons::shown_rig() const {
    const LiveModel::Skinned* skin = editor_.live.skin();
    return mode_ == Mode::pose && skin != nullptr ? &skin->rig : editor_.live.rig();
}

uint64_t Skeletons::shown_revision() const {
    const bool is_of_skin = mode_ == Mode::pose && editor_.live.skin() != nullptr;
    return is_of_skin ? 2 * editor_.live.skin_revision() : 2 * editor_.live.rig_revision() + 1;
}

std::vector<glm::quat> Skeletons::shown_turns(const Rig& rig) const {
    if (mode_ != Mode::pose) return std::vector<glm::quat>(rig.count(), glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
    std::vector<glm::quat> turns = turns_of(rig, editor_.drawing().pose);
    const LiveModel::Skinned* skin = editor_.live.skin();
    if (!is_playing_ || skin == nullptr) return turns;
    const FlgSkinAnimation animation = skin->motion.animation();
    const double length = static_cast<double>(skin->motion.times.back());
    const auto time = static_cast<float>(std::fmod(desk_.seconds - play_from_, length));
    std::vector<float> moved(4 * rig.count());
    filigree::check(flgSkinAnimationSample(&animation, skin->view.joint_count, time, moved.data(), nullptr));
    for (size_t j = 0; j < rig.count(); ++j)
        turns[j] =
            glm::normalize(turns[j] * glm::quat(moved[4 * j + 3], moved[4 * j], moved[4 * j + 1], moved[4 * j + 2]));
    return turns;
}

void Skeletons::show_model() {
    const LiveModel::Skinned* skin = editor_.live.skin();
    const uint32_t chosen = is_in_front_ && mode_ != Mode::pose ? editor_.selected_id() : 0;
    picture_.set_body_visible(shown_.body || !is_in_front_);
    if (picture_.show_body(skin, editor_.live.skin_revision(), editor_.drawing(), chosen)) transforms_.clear();
    const glm::vec3 shift = mode_ == Mode::pose ? editor_.drawing().pose.shift : glm::vec3(0.0f);
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
    const Rig* rig = shown_rig();
    joints_ = rig == nullptr ? PosedJoints{} : posed(*rig, shown_turns(*rig), shift);
    const bool sees_bones = rig != nullptr && is_in_front_ && shown_.bones;
    ModelPicture::BonesLook look;
    look.selected_part = chosen;
    if (rig != nullptr && mode_ == Mode::pose) look.bright = pose_.bright(*rig);
    picture_.show_bones(sees_bones ? *rig : Rig{}, shown_revision(), joints_.at, look);
}

void Skeletons::pointer(const Pointer& mouse) {
    if (mode_ == Mode::draw) return draw_.pointer(mouse);
    if (mode_ == Mode::move) return move_.pointer(mouse);
    if (mode_ == Mode::refine) return branch_.pointer(mouse);
    const Rig* rig = shown_rig();
    if (rig == nullptr || joints_.at.size() != rig->count()) return pose_.leave();
    // A motion that goes on would take the joint away from under the mouse.
    if (is_playing_ && mouse.pressed && mouse.inside) play(false);
    pose_.pointer(mouse, *rig, joints_);
}

void Skeletons::overlay(ImDrawList& list) {
    if (mode_ == Mode::draw || mode_ == Mode::move) layer_.draw(list, desk_.view, editor_.drawing().picture);
    if (mode_ != Mode::pose) draw_outlines(list);
    if (mode_ == Mode::draw && editor_.drawing().parts.empty() && !draw_.is_drawing() && !layer_.is_shown())
        draw_invitation(list);
    if (mode_ == Mode::draw) draw_.overlay(list);
    if (mode_ == Mode::move) move_.overlay(list);
    if (mode_ == Mode::refine) branch_.overlay(list);
    const Rig* rig = shown_rig();
    if (mode_ == Mode::pose && rig != nullptr && joints_.at.size() == rig->count()) pose_.overlay(list, *rig, joints_);
}

void Skeletons::draw_invitation(ImDrawList& list) const {
    constexpr const char* kText = "Draw the outline of a body here";
    constexpr int kDashes = 48;
    const glm::vec4 v(desk_.view.viewport);
    const glm::vec2 middle(v.x + 0.5f * v.z, v.y + 0.5f * v.w), half = 0.28f * glm::vec2(v.z, 0.7f * v.w);
    for (int i = 0; i < kDashes; ++i) {
        const auto at = [&](float step) {
            const float angle = 6.2831853f * (static_cast<float>(i) + step) / kDashes;
            return ImVec2(middle.x + half.x * std::cos(angle), middle.y + half.y * std::sin(angle));
        };
        list.AddLine(at(0.0f), at(0.55f), ink::kFaint, 2.0f * desk_.scale);
    }
    const ImVec2 size = ImGui::CalcTextSize(kText);
    list.AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, ink::kLine, kText);
}

void Skeletons::draw_outlines(ImDrawList& list) const {
    const float unit = desk_.scale;
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
                const auto line =
                    ring_in_window(desk_.view, part, ring, is_image ? &editor_.drawing().mirror : nullptr);
                ink::line(list, line, color, (is_chosen || is_hovered || is_wrong ? 2.5f : 1.2f) * unit, true);
            }
        }
        for (const glm::dvec2& place : state.crossings) {
            const auto at = desk_.view.project(glm::vec3(part.matrix() * glm::dvec4(place, 0.0, 1.0)));
            if (!at) continue;
            list.AddCircle({at->x, at->y}, 11.0f * unit, ink::kShade, 0, 5.0f * unit);
            list.AddCircle({at->x, at->y}, 11.0f * unit, ink::kWrong, 0, 3.0f * unit);
        }
        if (const auto at = desk_.view.project(glm::vec3(part.centre())))
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
        case GLFW_KEY_DELETE:
        case GLFW_KEY_BACKSPACE:
            drop_tools();
            editor_.remove_selected();
            return true;
        case GLFW_KEY_SPACE:
            if (mode_ != Mode::pose) return false;
            play(!is_playing_);
            return true;
        case GLFW_KEY_ESCAPE: {
            const bool was_drawing = draw_.is_drawing() || editor_.is_acting();
            draw_.drop(), move_.drop(), pose_.drop();
            editor_.cancel();
            if (!was_drawing) editor_.select(0);
            return true;
        }
        default: return false;
    }
}

std::span<const Workspace::Shortcut> Skeletons::shortcuts() const {
    static constexpr Shortcut kShortcuts[] = {
        {"Q, W, E, R", "Draw, move, refine, pose"},    {"Shift+drag in Draw", "A hole in the part under the mouse"},
        {"Shift+drag in Move", "Nearer or farther"},   {"Shift+drag in Pose", "Turns a bone about itself"},
        {"Double click in Pose", "Puts a joint back"}, {"Space in Pose", "Plays or stops the test motion"},
        {"Delete", "Deletes the selected part"},       {"Ctrl+D", "Duplicates the selected part"},
        {"Escape", "Lets go; selects nothing"},
    };
    return kShortcuts;
}

void Skeletons::undo() {
    draw_.drop(), move_.drop(), pose_.drop();
    editor_.undo();
}

void Skeletons::redo() {
    draw_.drop(), move_.drop(), pose_.drop();
    editor_.redo();
}

bool Skeletons::busy() const {
    return is_playing_ || editor_.live.busy() || editor_.contours.busy() || layer_.busy();
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
    if (name == "faults") return static_cast<double>(editor_.live.fault_count(drawing));
    if (name == "selected") return editor_.selected() != nullptr ? 1.0 : 0.0;
    if (name == "joints") return rig == nullptr ? 0.0 : static_cast<double>(rig->count());
    if (name == "roots") return rig == nullptr ? 0.0 : static_cast<double>(rig->count() - rig->bone_count());
    if (name == "vertices") return editor_.live.skin() ? editor_.live.skin()->view.vertex_count : 0.0;
    if (name == "turned") return static_cast<double>(drawing.pose.turns.size());
    if (name == "playing") return is_playing_ ? 1.0 : 0.0;
    if (name == "picture") return layer_.is_shown() ? 1.0 : 0.0;
    if (name == "mode") return static_cast<double>(mode_);
    throw StudioError("the workspace Skeletons has nothing to count by the name " + name + ".");
}

std::unique_ptr<Workspace> make_skeletons(Desk& desk) {
    return std::make_unique<Skeletons>(desk);
}

}  // namespace flg::studio
