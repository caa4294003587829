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
Ogre::HardwareVertexBufferSharedPtr add_column(Ogre::VertexData& data, Ogre::VertexElementType type,
                                               Ogre::VertexElementSemantic semantic) {
    const auto source = static_cast<unsigned short>(data.vertexBufferBinding->getBufferCount());
    const size_t size = data.vertexDeclaration->addElement(source, 0, type, semantic).getSize();
    const Ogre::HardwareVertexBufferSharedPtr buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        size, data.vertexCount, Ogre::HBU_GPU_ONLY, true);
    data.vertexBufferBinding->setBinding(source, buffer);
    return buffer;
}

// The SDK writes positions, normals and indices, these as narrow as they can be, into OGRE's buffers itself.
void write_shape(const FlgSkinView& skin, Ogre::VertexData& data, Ogre::IndexData& index_data) {
    const auto whole = Ogre::HardwareBuffer::HBL_DISCARD;
    const Ogre::HardwareBufferLockGuard positions(add_column(data, Ogre::VET_FLOAT3, Ogre::VES_POSITION), whole),
        normals(add_column(data, Ogre::VET_FLOAT3, Ogre::VES_NORMAL), whole);
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, skin.positions, 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, skin.normals, 0, 0}};
    const FlgBufferColumn to[] = {{FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.pData, 0, 0, {}, 0, 0},
                                  {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_FLOAT32, normals.pData, 0, 0, {}, 0, 0}};
    filigree::BufferOutput vertices;
    vertices.set_columns(to);
    vertices.row_capacity = skin.vertex_count;
    filigree::ColumnsWriteDesc desc;
    desc.set_columns(columns);
    desc.row_count = skin.vertex_count;
    desc.output = &vertices;
    filigree::columns_write(desc);

    const bool narrow = skin.vertex_count <= 65535;
    index_data.indexCount = size_t{3} * skin.triangle_count;
    index_data.indexBuffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        narrow ? Ogre::HardwareIndexBuffer::IT_16BIT : Ogre::HardwareIndexBuffer::IT_32BIT, index_data.indexCount,
        Ogre::HBU_GPU_ONLY);
    const Ogre::HardwareBufferLockGuard numbers(index_data.indexBuffer, whole);
    filigree::BufferOutput indices;
    indices.indices = numbers.pData;
    indices.index_capacity = index_data.indexCount;
    indices.index_format = narrow ? FLG_NUMBER_FORMAT_UINT16 : FLG_NUMBER_FORMAT_UINT32;
    filigree::indices_write({skin.triangles, index_data.indexCount}, indices);
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
    write_shape(skin, *mesh->sharedVertexData, *mesh->createSubMesh()->indexData);
    add_column(*mesh->sharedVertexData, Ogre::VET_UBYTE4_NORM, Ogre::VES_DIFFUSE)
        ->writeData(0, sizeof(Ogre::uint32) * colours.size(), colours.data(), true);
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
        colours[v] = colours_[model.part_sources[skin.vertex_parts[v]]].getAsABGR();
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
