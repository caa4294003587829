// SPDX-License-Identifier: MIT
#include "stage.h"

#include <OgreEntity.h>
#include <OgreLight.h>
#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <OgrePass.h>
#include <OgreRTShaderSystem.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>

namespace viewer {
namespace {

const Ogre::ColourValue kAir(0.62f, 0.66f, 0.70f);

Ogre::Pass& pass_of(const Ogre::MaterialPtr& material) {
    return *material->getTechnique(0)->getPass(0);
}

Ogre::MaterialPtr make_shiny(const Ogre::String& name, float shine) {
    Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(name, Ogre::RGN_DEFAULT);
    pass_of(material).setSpecular(Ogre::ColourValue(shine, shine, shine));
    pass_of(material).setShininess(60);
    pass_of(material).setCullingMode(Ogre::CULL_NONE);  // a vase has an inside
    return material;
}

void add_light(Ogre::SceneManager& scene, const Ogre::Vector3& from, const Ogre::ColourValue& colour, bool shadows) {
    Ogre::Light* const light = scene.createLight();
    light->setType(Ogre::Light::LT_SPOTLIGHT);
    light->setSpotlightRange(Ogre::Degree(32), Ogre::Degree(52));
    light->setDiffuseColour(colour);
    light->setSpecularColour(colour);
    light->setCastShadows(shadows);
    Ogre::SceneNode* const node = scene.getRootSceneNode()->createChildSceneNode(from);
    node->setDirection(Ogre::Vector3(0, 0.4f, 0) - from, Ogre::Node::TS_WORLD);
    node->attachObject(light);
}

}  // namespace

void set_up_shading(Ogre::SceneManager& scene) {
    scene.setShadowTechnique(Ogre::SHADOWTYPE_TEXTURE_ADDITIVE_INTEGRATED);
    scene.setShadowTextureSettings(1024, 1, Ogre::PF_DEPTH16);
    scene.setShadowTextureSelfShadow(true);
    scene.setShadowFarDistance(20);
    Ogre::RTShader::ShaderGenerator& generator = Ogre::RTShader::ShaderGenerator::getSingleton();
    generator.addSceneManager(&scene);
    Ogre::RTShader::RenderState& state =
        *generator.getRenderState(Ogre::RTShader::ShaderGenerator::DEFAULT_SCHEME_NAME);
    state.addTemplateSubRenderState(generator.createSubRenderState(Ogre::RTShader::PerPixelLighting::Type));
    state.addTemplateSubRenderState(generator.createSubRenderState(Ogre::RTShader::IntegratedPSSM3::Type));
}

Ogre::MaterialPtr make_material(const Ogre::String& name, const Ogre::ColourValue& colour, float shine) {
    Ogre::MaterialPtr material = make_shiny(name, shine);
    pass_of(material).setDiffuse(colour);
    pass_of(material).setAmbient(colour);
    return material;
}

Ogre::MaterialPtr make_vertex_colour_material(const Ogre::String& name, float shine) {
    Ogre::MaterialPtr material = make_shiny(name, shine);
    pass_of(material).setVertexColourTracking(Ogre::TVC_AMBIENT | Ogre::TVC_DIFFUSE);
    // In a shadow OGRE's generated shaders know the material's ambient colour only.
    material->setReceiveShadows(false);
    return material;
}

void build_stage(Ogre::SceneManager& scene) {
    scene.setAmbientLight(Ogre::ColourValue(0.30f, 0.32f, 0.36f));
    scene.setFog(Ogre::FOG_LINEAR, kAir, 0, 4, 14);
    add_light(scene, {2.2f, 4.6f, 3.0f}, Ogre::ColourValue(0.95f, 0.90f, 0.82f), true);
    add_light(scene, {-3.5f, 2.5f, 2.5f}, Ogre::ColourValue(0.16f, 0.19f, 0.24f), false);
    Ogre::MeshManager::getSingleton().createPlane("floor.mesh", Ogre::RGN_DEFAULT,
                                                  Ogre::Plane(Ogre::Vector3::UNIT_Y, 0), 40, 40, 80, 80, true, 1, 1, 1,
                                                  Ogre::Vector3::UNIT_Z);
    Ogre::Entity* const floor = scene.createEntity("floor.mesh");
    floor->setMaterial(make_material("floor", Ogre::ColourValue(0.55f, 0.55f, 0.56f), 0));
    floor->setCastShadows(false);
    scene.getRootSceneNode()->attachObject(floor);
}

}  // namespace viewer
