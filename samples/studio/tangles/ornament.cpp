// SPDX-License-Identifier: MIT
#include "tangles/ornament.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flg::studio {
namespace {

// Weights of the second and third corner for the point of a triangle that is nearest to a place (Ericson 2005, sec.
// 5.1.5).
glm::vec2 nearest_weights(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0f && d2 <= 0.0f) return {0.0f, 0.0f};
    const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0f && d4 <= d3) return {1.0f, 0.0f};
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return {d1 / (d1 - d3), 0.0f};
    const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0f && d5 <= d6) return {0.0f, 1.0f};
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return {0.0f, d2 / (d2 - d6)};
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0f && d4 - d3 >= 0.0f && d5 - d6 >= 0.0f) {
        const float w = (d4 - d3) / (d4 - d3 + d5 - d6);
        return {1.0f - w, w};
    }
    const float sum = va + vb + vc;
    if (!(sum > 0.0f)) return {0.0f, 0.0f};
    return {vb / sum, vc / sum};
}

MeshBefore copy_mesh(const FlgSurfaceView& surface, const Regions& leaves) {
    MeshBefore copy;
    const FlgMeshView& mesh = *surface.mesh;
    copy.positions.resize(mesh.vertex_count);
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
        const float* p = mesh.columns[0].data + size_t{3} * v;
        copy.positions[v] = {p[0], p[1], p[2]};
    }
    std::vector<uint8_t> inside(leaves.empty() ? 0 : leaves.back() + 1, 0);
    for (const uint32_t leaf : leaves) inside[leaf] = 1;
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        const uint32_t label = mesh.regions != nullptr ? mesh.regions[t] : 0;
        if (label >= inside.size() || inside[label] == 0) continue;
        copy.numbers.push_back(t);
        copy.triangles.insert(copy.triangles.end(), mesh.triangles + size_t{3} * t, mesh.triangles + size_t{3} * t + 3);
    }
    copy.outline = trace_outline(surface, leaves);
    return copy;
}

}  // namespace

std::optional<SeedPoint> MeshBefore::nearest(const glm::vec3& place, float reach) const {
    std::optional<SeedPoint> best;
    float least = reach * reach;
    for (size_t i = 0; i < numbers.size(); ++i) {
        const glm::vec3 &a = positions[triangles[3 * i]], &b = positions[triangles[3 * i + 1]],
                        &c = positions[triangles[3 * i + 2]];
        const float around = std::max(glm::dot(b - a, b - a), glm::dot(c - a, c - a));
        const float apart = glm::distance(place, a) - std::sqrt(around);
        if (apart > 0.0f && apart * apart > least) continue;
        const glm::vec2 w = nearest_weights(place, a, b, c);
        const glm::vec3 found = a + w.x * (b - a) + w.y * (c - a);
        const float distance = glm::dot(found - place, found - place);
        if (distance >= least) continue;
        least = distance;
        best = SeedPoint{{numbers[i], w.x, w.y}, found};
    }
    return best;
}

Ornament::Ornament(AppContext& app, const SceneMesh& mesh, const Palette& palette)
    : app_(app), palette_(palette), mesh_id_(mesh.id), generation_(mesh.generation) {}

void Ornament::run(const std::string& name, filigree::Job job, const Owner& owner, Jobs::Shown shown, Then then) {
    ++running_;
    app_.jobs.add(
        name, std::move(job),
        [owner, id = mesh_id_, then = std::move(then)](const FlgJobStatus& status) {
            Ornament* ornament = owner(id);
            if (ornament == nullptr) return;
            --ornament->running_;
            if (then) then(status);
            if (ornament->running_ == 0) ornament->finished();
        },
        shown);
}

void Ornament::make(const Owner& owner) {
    FlgTangle made{};
    FlgJob job{};
    filigree::check(flgTangleCreate(app_.context.get(), mesh()->surface.get(), nullptr, &made, &job));
    tangle = {app_.context.get(), made};
    run("Preparing " + mesh()->name, {app_.context.get(), job}, owner, Jobs::Shown::quiet,
        [this](const FlgJobStatus& status) { failed_ = status.result != FLG_OK; });
}

void Ornament::finished() {
    if (failed_ || mesh() == nullptr) return;
    regions.refresh(tangle);
    steps = list_steps(tangle);
    if (carried_) paints = carried_->paints.on(steps, regions, carried_->moved, carried_->edited, carried_->to);
    carried_.reset();
    if (live) live->is_made = regions.undo_count() > live->undo_count;
    // The first time it was only made ready.
    if (revision_++ > 0) ++app_.changes;
    recolor();
}

void Ornament::carry_paints(Moved moved, uint32_t edited, uint32_t to) {
    carried_.emplace(Carrying{{steps, regions, paints}, moved, edited, to});
}

void Ornament::begin(Action action, const Regions& on) {
    const FlgSurfaceView surface = mesh()->surface.view();
    LiveStep step;
    step.before = copy_mesh(surface, regions.leaves_below(on));
    step.recipe = step.first = default_recipe(action, on, step.before.outline);
    step.undo_count = regions.undo_count();
    step.region_count = regions.count();
    live = std::move(step);
}

bool Ornament::wants_try() const {
    if (!live || !idle()) return false;
    return live->tried != live->recipe || regions.undo_count() > live->undo_count + 1;
}

void Ornament::try_again(const Owner& owner) {
    const std::string name = info_of(live->recipe.action).name;
    for (uint32_t made = regions.undo_count(); made > live->undo_count; --made)
        run("Undoing " + name, tangle.undo(), owner, Jobs::Shown::quiet);
    live->tried = live->recipe;
    live->error = missing(live->recipe);
    if (!live->error.empty()) {
        live->is_made = false;
        return;
    }
    run(name, start(live->recipe, tangle), owner, Jobs::Shown::listed, [this](const FlgJobStatus& status) {
        if (!live || status.result == FLG_OK) return;
        live->error = status.result == FLG_ERROR_CANCELLED ? "Cancelled. Move a slider to try again." : status.error;
    });
}

Regions Ornament::new_parts() const {
    if (live->recipe.action == Action::displace) return regions.leaves_below(live->recipe.regions);
    const std::vector<uint32_t> materials = color_regions(regions, paints, palette_.materials.size());
    Regions made, other;
    for (const uint32_t leaf : regions.leaves()) {
        const uint32_t seen = seen_region(regions, leaf);
        if (seen < live->region_count) continue;
        uint32_t around = seen;
        while (around >= live->region_count) around = regions[around].parent;
        made.push_back(leaf);
        if (materials[seen] != materials[around]) other.push_back(leaf);
    }
    return other.empty() ? made : other;
}

Paints Ornament::shown_paints() const {
    Paints shown = paints;
    if (live && live->is_made && live->material)
        for (const uint32_t leaf : new_parts()) shown.insert_or_assign(seen_region(regions, leaf), *live->material);
    return shown;
}

void Ornament::recolor() {
    SceneMesh* shown = mesh();
    if (shown == nullptr || regions.count() == 0) return;
    materials_ = color_regions(regions, shown_paints(), palette_.materials.size());
    TangleLook look;
    if (!is_bare()) look = make_look(regions, materials_, palette_, shows_scaffolds);
    look.look.material = shown->look.material;
    constexpr float kThinnest_px = 0.5f, kWidest_px = 64.0f;  // that are drawn
    const auto scaled = [&](float px) {
        return px > 0.0f ? std::clamp(px * app_.scale, kThinnest_px, kWidest_px) : 0.0f;
    };
    look.look.border_width_px = scaled(look.look.border_width_px);
    for (render::Material& material : look.look.regions) material.border_width_px = scaled(material.border_width_px);
    shown->look = std::move(look.look);
    shown->label_of = std::move(look.label_of);
    app_.scene.redraw(*shown);
}

}  // namespace flg::studio
