// SPDX-License-Identifier: MIT
#include "skinned_model.h"

#include <OgreAnimation.h>
#include <OgreBone.h>
#include <OgreEntity.h>
#include <OgreHardwareBufferManager.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSkeletonManager.h>
#include <OgreSubMesh.h>

#include "walk.h"

namespace viewer {
namespace {

const Ogre::String& group = Ogre::RGN_DEFAULT;

// Joints have their parents first and are not turned at rest, so that a bone's place is that within its parent's.
Ogre::SkeletonPtr skeleton_of(const FlgSkinView& skin) {
    Ogre::SkeletonPtr skeleton = Ogre::SkeletonManager::getSingleton().create("drawn.skeleton", group, true);
    for (uint32_t j = 0; j < skin.joint_count; ++j) {
        Ogre::Bone* const bone = skeleton->createBone(skin.joint_names[j], static_cast<unsigned short>(j));
        Ogre::Vector3 place(skin.joint_positions + size_t{3} * j);
        const uint32_t parent = skin.joint_parents[j];
        if (parent != FLG_NO_INDEX) {
            place -= Ogre::Vector3(skin.joint_positions + size_t{3} * parent);
            skeleton->getBone(static_cast<unsigned short>(parent))->addChild(bone);
        }
        bone->setPosition(place);
    }
    skeleton->setBindingPose();
    return skeleton;
}

// One buffer a column, so that OGRE may blend positions and normals and leave colours alone.
template <class Value>
void add_column(Ogre::VertexData& data, Ogre::VertexElementType type, Ogre::VertexElementSemantic semantic,
                const Value* values) {
    const auto source = static_cast<unsigned short>(data.vertexBufferBinding->getBufferCount());
    const size_t size = data.vertexDeclaration->addElement(source, 0, type, semantic).getSize();
    const Ogre::HardwareVertexBufferSharedPtr buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        size, data.vertexCount, Ogre::HBU_GPU_ONLY, true);
    buffer->writeData(0, size * data.vertexCount, values, true);
    data.vertexBufferBinding->setBinding(source, buffer);
}

void add_weights(Ogre::Mesh& mesh, const FlgSkinView& skin) {
    for (uint32_t v = 0; v < skin.vertex_count; ++v) {
        for (size_t k = size_t{4} * v; k < size_t{4} * (v + 1); ++k) {
            if (skin.vertex_weights[k] > 0) mesh.addBoneAssignment({v, skin.vertex_joints[k], skin.vertex_weights[k]});
        }
    }
    mesh._compileBoneAssignments();
}

Ogre::MeshPtr mesh_of(const FlgSkinView& skin, const std::vector<Ogre::uint32>& colours) {
    Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().createManual("drawn.mesh", group);
    mesh->sharedVertexData = OGRE_NEW Ogre::VertexData();
    mesh->sharedVertexData->vertexCount = skin.vertex_count;
    add_column(*mesh->sharedVertexData, Ogre::VET_FLOAT3, Ogre::VES_POSITION, skin.positions);
    add_column(*mesh->sharedVertexData, Ogre::VET_FLOAT3, Ogre::VES_NORMAL, skin.normals);
    add_column(*mesh->sharedVertexData, Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE, colours.data());
    Ogre::SubMesh* const sub = mesh->createSubMesh();
    const size_t indices = size_t{3} * skin.triangle_count;
    sub->indexData->indexCount = indices;
    sub->indexData->indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        Ogre::HardwareIndexBuffer::IT_32BIT, indices, Ogre::HBU_GPU_ONLY);
    sub->indexData->indexBuffer->writeData(0, indices * sizeof(uint32_t), skin.triangles, true);
    Ogre::AxisAlignedBox box;
    for (uint32_t v = 0; v < skin.vertex_count; ++v) box.merge(Ogre::Vector3(skin.positions + size_t{3} * v));
    box.scale(Ogre::Vector3(1.2f));  // it moves
    mesh->_setBounds(box);
    return mesh;
}

}  // namespace

SkinnedModel::SkinnedModel(filigree::Context& context, const Drawing& drawing, Ogre::SceneNode& node,
                           const Ogre::MaterialPtr& material)
    : node_(node), material_(material) {
    // Handles of what is still in the making are good inputs: one call after the other, and nothing waits.
    std::vector<filigree::Part> parts;
    std::vector<FlgBoneThresholds> thresholds(drawing.parts.size());
    const auto thresholds_of = [&](float prune) {
        FlgBoneThresholds made = flgBoneThresholdsDefaults();
        made.simplify = drawing.simplify;
        made.merge = drawing.merge;
        made.prune = prune;
        made.collapse = drawing.collapse;
        return made;
    };
    std::vector<FlgModelPart> placed;
    for (const DrawnPart& drawn : drawing.parts) {
        FlgPartDesc desc = flgPartDefaults();
        FlgContourView input = flgContourViewDefaults();
        input.points = drawn.contour.data();
        input.point_count = static_cast<uint32_t>(drawn.contour.size() / 2);
        desc.contour = &input;
        parts.push_back(context.part(desc));
        FlgModelPart& part = placed.emplace_back(flgModelPartDefaults());
        part.part = parts.back().get();
        part.name = drawn.name.c_str();
        for (size_t k = 0; k < 12; ++k) part.placement[k] = drawn.placement[k / 4][k % 4];
        part.thickness = drawn.thickness;
        part.mirrored = drawn.mirrored;
        thresholds[placed.size() - 1] = thresholds_of(drawn.prune);
        part.thresholds = &thresholds[placed.size() - 1];
        colours_.push_back(drawn.colour);
    }
    FlgModelDesc model = flgModelDefaults();
    model.parts = placed.data();
    model.part_count = static_cast<uint32_t>(placed.size());
    const FlgBoneThresholds of_all = thresholds_of(drawing.prune);
    model.thresholds = &of_all;
    for (size_t k = 0; k < 4; ++k) model.mirror[k] = drawing.mirror[k];
    model_ = context.model(model);
    FlgSkinDesc skin = flgSkinDefaults();
    skin.model = model_.get();
    skin.vertex_count = 16000;
    skin_ = context.skin(skin);
}

void SkinnedModel::build() {
    const FlgSkinView skin = skin_.view();
    const FlgModelView model = model_.view();
    std::vector<Ogre::uint32> colours(skin.vertex_count);
    for (uint32_t v = 0; v < skin.vertex_count; ++v)
        colours[v] = colours_[model.parts[skin.vertex_parts[v]].source].getAsABGR();
    Ogre::SkeletonPtr skeleton = skeleton_of(skin);
    add_walk(*skeleton);
    const Ogre::MeshPtr mesh = mesh_of(skin, colours);
    mesh->_notifySkeleton(skeleton);
    add_weights(*mesh, skin);
    Ogre::Entity* const entity = node_.getCreator()->createEntity(mesh);
    entity->setMaterial(material_);
    node_.attachObject(entity);
    animation_ = entity->getAnimationState(kWalk);
    animation_->setEnabled(true);
    // OGRE has copies of all of it.
    skin_.reset();
    model_.reset();
}

void SkinnedModel::update(float time) {
    if (!animation_ && skin_.ready()) build();
    if (animation_) animation_->setTimePosition(time);
}

}  // namespace viewer
