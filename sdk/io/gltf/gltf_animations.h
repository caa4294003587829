// SPDX-License-Identifier: MIT
// The animations of a glTF document, as rotations of a skeleton's joints and a translation of its roots; and as weights
// of morph targets.
#pragma once

#include "io/gltf/gltf_morphs.h"
#include "io/gltf/gltf_skeleton.h"

namespace flg::io {

// `size`: of the model, metres; what is smaller than a share of it does not count.
void read_animations(const GltfDocument& document, const GltfNodes& nodes, const GltfSkeleton& skeleton,
                     const GltfMorphReader& morphs, double size, SkinData& data);

}  // namespace flg::io
