// SPDX-License-Identifier: MIT
// What OGRE's scene has of its own: floor, light with a shadow, camera, materials. Nothing of Filigree.
#pragma once

#include <OgreMaterial.h>
#include <OgreSceneManager.h>

namespace viewer {

// Lit for each pixel, with shadows: what materials without shaders of their own look like. Once, before any is drawn.
void set_up_shading(Ogre::SceneManager& scene);

// Linear colour; `shine` is the highlight's, 0 to 1.
Ogre::MaterialPtr make_material(const Ogre::String& name, const Ogre::ColourValue& colour, float shine);
// Takes its colour from the vertices.
Ogre::MaterialPtr make_vertex_colour_material(const Ogre::String& name, float shine);

// Floor and lights.
void build_stage(Ogre::SceneManager& scene);

}  // namespace viewer
