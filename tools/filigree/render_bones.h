// SPDX-License-Identifier: MIT
// The joints and bones of a skin as tubes.
#pragma once

#include <vector>

#include "filigree/filigree_model.h"
#include "filigree_renderer/renderer.h"

namespace flg::cli {

// Drawn over all else: a tube from each joint's parent to it, thin towards it, and a ball at each joint.
// `joint_positions`: 3 a joint, as posed; `size`: of the whole picture's content, metres.
void upload_bones(render::Renderer& renderer, const FlgSkinView& skin, const std::vector<float>& joint_positions,
                  float size);

}  // namespace flg::cli
