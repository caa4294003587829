// SPDX-License-Identifier: MIT
#include "skeletons/editor.h"

#include <algorithm>
#include <cmath>

namespace flg::studio {

Drawing& Editor::change(const char* act) {
    if (history_.begin(now_, act) && did) did();
    ++revision_;
    ++app.changes;
    return now_.drawing;
}

void Editor::commit() {
    if (history_.commit() && did) did();
}

void Editor::cancel() {
    if (auto before = history_.cancel()) restore(std::move(*before));
}

void Editor::select(uint32_t id) {
    if (now_.selected == id) return;
    commit();
    now_.selected = id;
    ++revision_;
}

void Editor::set_plane(Drawing& drawing, MirrorAs as) {
    if (as == MirrorAs::single) return;
    const MirrorAs before =
        std::abs(drawing.mirror.z) > std::abs(drawing.mirror.x) ? MirrorAs::front_back : MirrorAs::left_right;
    if (before == as) return;
    if (drawing.has_mirrored_parts())
        app.notices.add(Weight::info, "A drawing has one mirror. All mirrored parts use this one now.");
    drawing.mirror = as == MirrorAs::front_back ? glm::vec4(0, 0, -1, 0) : glm::vec4(1, 0, 0, 0);
}

void Editor::add(std::vector<DrawnPart> parts, MirrorAs as) {
    commit();
    Drawing& drawing = change("add");
    set_plane(drawing, as);
    for (DrawnPart& part : parts) {
        part.mirrored = as != MirrorAs::single;
        part.id = ++last_id_;
        part.name = drawing.free_name(part.name);
        now_.selected = part.id;
        drawing.parts.push_back(std::move(part));
    }
    commit();
}

void Editor::remove_selected() {
    if (selected() == nullptr) return;
    commit();
    Drawing& drawing = change("remove");
    std::erase_if(drawing.parts, [this](const DrawnPart& part) { return part.id == now_.selected; });
    now_.selected = 0;
    commit();
}

void Editor::duplicate_selected() {
    if (selected() == nullptr) return;
    DrawnPart copy = *selected();
    // Beside it, so that it is seen to be there.
    const double width = radius_of(copy.contour->rings[0]) * copy.scale;
    copy.at += glm::dvec3(width, -width, 0.0);
    const MirrorAs as = mirror_of(copy);
    add({std::move(copy)}, as);
}

void Editor::shift_selected(int by) {
    if (selected() == nullptr) return;
    const auto at = static_cast<size_t>(selected() - drawing().parts.data());
    if ((by < 0 && at == 0) || (by > 0 && at + 1 == drawing().parts.size())) return;
    commit();
    Drawing& drawing = change("order");
    std::swap(drawing.parts[at], drawing.parts[by < 0 ? at - 1 : at + 1]);
    commit();
}

void Editor::repair(uint32_t id) {
    const DrawnPart* part = drawing().find(id);
    if (part == nullptr) return;
    contours.repair(part->contour, [this, id, crossing = part->contour](ContourPtr simple) {
        const DrawnPart* now = drawing().find(id);
        // It may have been deleted or changed meanwhile.
        if (now == nullptr || now->contour != crossing) return;
        commit();
        DrawnPart& repaired = *change("repair").find(id);
        repaired.contour = std::move(simple);
        repaired.branch_simplify.clear();
        commit();
    });
}

void Editor::trace_mesh() {
    const SceneMesh* mesh = app.scene.active();
    if (mesh == nullptr || !mesh->ready) throw StudioError("There is no mesh to trace. Add one under Scene.");
    contours.trace(mesh->surface,
                   [this, name = mesh->name](ContourPtr contour, const std::array<double, 12>& placement) {
                       DrawnPart part = brush;
                       part.name = name;
                       part.contour = std::move(contour);
                       set_placement(part, placement);
                       add({std::move(part)}, MirrorAs::single);
                   });
}

MirrorAs Editor::mirror_of(const DrawnPart& part) const {
    if (!part.mirrored) return MirrorAs::single;
    const glm::vec4& plane = drawing().mirror;
    return std::abs(plane.z) > std::abs(plane.x) ? MirrorAs::front_back : MirrorAs::left_right;
}

void Editor::set_mirror(MirrorAs as) {
    brush_mirror = as;
    if (selected() == nullptr || mirror_of(*selected()) == as) return;
    commit();
    DrawnPart& part = change_selected("mirror");
    part.mirrored = false;
    set_plane(now_.drawing, as);
    part.mirrored = as != MirrorAs::single;
    if (as == MirrorAs::front_back && part.at.z == 0.0) {
        Drawing others = drawing();
        std::erase_if(others.parts, [&](const DrawnPart& other) { return other.id == part.id; });
        Ring outline;
        for (const glm::dvec2& p : part.contour->rings[0])
            outline.emplace_back(part.matrix() * glm::dvec4(p, 0.0, 1.0));
        part.at.z = depth_beside(others, outline, part.thickness);
    }
    commit();
}

void Editor::undo() {
    if (history_.is_acting()) return cancel();
    if (history_.can_undo()) restore(history_.undo(now_));
}

void Editor::redo() {
    if (history_.can_redo()) restore(history_.redo(now_));
}

void Editor::restore(State state) {
    now_ = std::move(state);
    ++revision_;
    ++app.changes;
}

void Editor::number(Drawing& drawing) {
    for (DrawnPart& part : drawing.parts) part.id = ++last_id_;
}

void Editor::replace(Drawing drawing) {
    history_.clear();
    contours.clear();
    live.clear();
    number(drawing);
    now_ = {std::move(drawing), 0};
    brush = {};
    brush_mirror = MirrorAs::single;
    ++revision_;
}

void Editor::open(Drawing drawing) {
    commit();
    number(drawing);
    change("open") = std::move(drawing);
    now_.selected = 0;
    commit();
}

}  // namespace flg::studio
