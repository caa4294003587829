// SPDX-License-Identifier: MIT
#include "documents/mesh_nearest.h"

#include "documents/failure.h"

#if defined(FLG_WITH_PICK)
#include <algorithm>
#include <limits>

#include "filigree/filigree_pick.h"

namespace flg::cli {

struct NearestSearch::Scene {
    Scene() = default;
    ~Scene() { flgPickSceneDestroy(handle); }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    FlgPickScene handle = nullptr;
    double origin[3] = {};  // of the surface
};

namespace {

void check_pick(FlgResult result, const std::string& subject) {
    if (result != FLG_OK) throw InputError(subject + ": " + flgPickErrorGetMessage());
}

}  // namespace

NearestSearch::NearestSearch(const FlgSurfaceView& surface, const std::string& subject)
    : scene_(std::make_unique<Scene>()), subject_(subject) {
    FlgPickSceneDesc desc = flgPickSceneDefaults();
    std::copy(std::begin(surface.mesh->origin), std::end(surface.mesh->origin), desc.origin);
    std::copy(std::begin(surface.mesh->origin), std::end(surface.mesh->origin), scene_->origin);
    check_pick(flgPickSceneCreate(&desc, &scene_->handle), subject);
    check_pick(flgPickSceneSetSurface(scene_->handle, 0, &surface, nullptr, 0), subject);
    check_pick(flgPickSceneCommit(scene_->handle), subject);
}

NearestSearch::~NearestSearch() = default;

NearestPoint NearestSearch::nearest(const std::array<double, 3>& position) const {
    FlgHit hit = {};
    std::array<float, 3> near;
    for (size_t k = 0; k < 3; ++k) near[k] = static_cast<float>(position[k] - scene_->origin[k]);
    check_pick(flgPickSceneFindNearest(scene_->handle, near.data(), std::numeric_limits<float>::infinity(), &hit),
               subject_);
    return {{hit.element, hit.u, hit.v}, hit.distance};
}

}  // namespace flg::cli

#else

namespace flg::cli {

struct NearestSearch::Scene {};

NearestSearch::NearestSearch(const FlgSurfaceView&, const std::string& subject) : subject_(subject) {
    throw InputError(subject_ + ": this build has no picking (FLG_BUILD_PICK), so only vertices can be named");
}

NearestSearch::~NearestSearch() = default;

NearestPoint NearestSearch::nearest(const std::array<double, 3>&) const {
    return {};
}

}  // namespace flg::cli

#endif
