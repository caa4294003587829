// SPDX-License-Identifier: MIT
// A tangle drawn into the texture coordinates of the mesh that its surface was made of.
//
// What lives in this room: where the surface lies on that mesh and how far it was moved off it (baked_shape.h), the
// borders' pieces (border_pieces.h), whose a texel is (texel_owners.h), what it shows (texel_painter.h), padding
// (texel_padding.h). What does not: files of pictures, materials.
#pragma once

#include "baking/bake_request.h"
#include "filigree/filigree_bake.h"
#include "tangles/tangle.h"

namespace flg {

// The whole of flgTangleBake.
Task<void> bake_tangle(Pace& pace, std::shared_ptr<const Tangle> tangle, BakeRequest request);

}  // namespace flg
