// SPDX-License-Identifier: MIT
// The nearest point of a surface, by filigree_pick; builds without it refuse to look.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "documents/mesh_surface.h"

namespace flg::cli {

struct NearestPoint {
    FlgSurfacePoint point;
    float distance;  // metres
};

class NearestSearch {
public:
    // Throws InputError about `subject`.
    NearestSearch(const FlgSurfaceView& surface, const std::string& subject);
    ~NearestSearch();
    NearestSearch(const NearestSearch&) = delete;
    NearestSearch& operator=(const NearestSearch&) = delete;

    NearestPoint nearest(const std::array<double, 3>& position) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
    std::string subject_;
};

}  // namespace flg::cli
