// SPDX-License-Identifier: MIT
#include "scene/mesh_picker.h"

#include <chrono>
#include <glm/gtc/type_ptr.hpp>

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

constexpr float kFarthest = 1e18f;  // what picking takes
constexpr uint32_t kObject = 0;

void check_pick(FlgResult result) {
    if (result < 0) throw StudioError(flgPickErrorGetMessage());
}

}  // namespace

MeshPicker::MeshPicker() {
    check_pick(flgPickSceneCreate(nullptr, &scene_));
}

MeshPicker::~MeshPicker() {
    if (building_.valid()) building_.wait();
    flgPickSceneDestroy(scene_);
}

void MeshPicker::update(const filigree::Surface& surface, const FlgSurfaceView& view) {
    if (building_.valid()) {
        if (building_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        check_pick(building_.get());
    }
    if (is_set_ && revision_ == view.revision) return;
    if (is_set_) {
        const std::vector<uint32_t> changed = surface.changes(revision_);
        check_pick(
            flgPickSceneSetSurface(scene_, kObject, &view, changed.data(), static_cast<uint32_t>(changed.size())));
    } else {
        check_pick(flgPickSceneSetSurface(scene_, kObject, &view, nullptr, 0));
    }
    is_set_ = true;
    revision_ = view.revision;
    building_ = std::async(std::launch::async, [scene = scene_] { return flgPickSceneCommit(scene); });
}

void MeshPicker::begin(const FlgSurfaceView& view) {
    is_set_ = true;
    revision_ = view.revision;
    building_ = std::async(std::launch::async, [scene = scene_, view] {
        const FlgResult result = flgPickSceneSetSurface(scene, kObject, &view, nullptr, 0);
        return result < 0 ? result : flgPickSceneCommit(scene);
    });
}

bool MeshPicker::is_built() const {
    return !building_.valid() || building_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::optional<FlgHit> MeshPicker::hit(const glm::vec3& origin, const glm::vec3& direction) const {
    if (!is_set_ || building_.valid()) return std::nullopt;
    FlgRay shot{};
    for (int i = 0; i < 3; ++i) {
        shot.origin[i] = origin[i];
        shot.direction[i] = direction[i];
    }
    shot.furthest = kFarthest;
    FlgHit hit{};
    if (flgPickSceneCastRays(scene_, &shot, 1, &hit) != FLG_OK || hit.object == FLG_NO_INDEX) return std::nullopt;
    return hit;
}

std::optional<FlgHit> MeshPicker::nearest(const glm::vec3& place) const {
    FlgHit hit{};
    if (!is_set_ || building_.valid()) return std::nullopt;
    if (flgPickSceneFindNearest(scene_, glm::value_ptr(place), kFarthest, &hit) != FLG_OK || hit.object == FLG_NO_INDEX)
        return std::nullopt;
    return hit;
}

}  // namespace flg::studio
