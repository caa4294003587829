// SPDX-License-Identifier: MIT
#include "documents/mesh_nearest.h"

#include "documents/failure.h"

#if defined(FLG_WITH_PICK)
#include <limits>

#include "filigree/filigree_pick.h"

namespace flg::cli {

struct NearestSearch::Scene {
    Scene() = default;
    ~Scene() { flgPickSceneDestroy(handle); }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    FlgPickScene handle = nullptr;
};

namespace {

void check_pick(FlgResult result, const std::string& subject) {
    if (result != FLG_OK) throw InputError(subject + ": " + flgPickLastError());
}

}  // namespace

NearestSearch::NearestSearch(const FlgSurfaceView& surface, const std::string& subject)
    : scene_(std::make_unique<Scene>()), subject_(subject) {
    check_pick(flgPickSceneCreate(nullptr, &scene_->handle), subject);
    check_pick(flgPickSceneSetSurface(scene_->handle, 0, &surface, nullptr, 0), subject);
    check_pick(flgPickSceneCommit(scene_->handle), subject);
}

NearestSearch::~NearestSearch() = default;

NearestPoint NearestSearch::nearest(const std::array<float, 3>& position) const {
    FlgHit hit = {};
    check_pick(flgPickNearest(scene_->handle, position.data(), std::numeric_limits<float>::infinity(), &hit), subject_);
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

NearestPoint NearestSearch::nearest(const std::array<float, 3>&) const {
    return {};
}

}  // namespace flg::cli

#endif
