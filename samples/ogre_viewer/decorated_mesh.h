// SPDX-License-Identifier: MIT
// A tangle's surface as an Ogre::Mesh: vertices shared, a submesh a colour, so that each region has a material of its
// own kind. Made again where the tangle has changed, which may be while the rest of the ornament is still in the
// making.
#pragma once

#include <OgreMesh.h>
#include <OgreSceneNode.h>

#include <memory>
#include <vector>

#include "curve_object.h"
#include "filigree/filigree.hpp"
#include "ornament.h"
#include "scenes/scenes.h"

namespace viewer {

class DecoratedMesh {
public:
    // One material a Colour; `line` for the borders, which are drawn as tubes.
    DecoratedMesh(filigree::Context& context, const flg::scenes::Mesh& mesh, Ogre::SceneNode& node,
                  const std::vector<Ogre::MaterialPtr>& materials, const Ogre::MaterialPtr& line);

    void update();  // once a frame, after the tick
    bool ready() const { return borders_ != nullptr; }

private:
    void refresh(const FlgSurfaceView& view);
    void refresh_vertices(const FlgMeshView& mesh);
    void draw_borders();

    filigree::Context& context_;
    Ogre::SceneNode& node_;
    Ogre::MaterialPtr line_;
    filigree::Surface surface_;
    Ornament ornament_;
    Ogre::MeshPtr mesh_;
    Ogre::Entity* entity_ = nullptr;
    filigree::SurfaceCurves border_curves_;
    filigree::CurveSet lifted_, lines_;
    std::unique_ptr<CurveObject> borders_;
};

}  // namespace viewer
