// SPDX-License-Identifier: MIT
// Files of skinned models, of the format FLG_EXTENSION: refused, or a skin that can be written again (the writer checks
// all that a view promises).
#include <vector>

#include "filigree/filigree_io.h"
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const flg::fuzz::InputFile input(FLG_EXTENSION), copy(".copy.glb");
    FlgSkinFile file = nullptr;
    const FlgResult result = flgSkinFileRead(input.holding(data, size), nullptr, &file);
    if (result != FLG_OK) {
        FLG_DEMAND(file == nullptr);
        flg::fuzz::demand_refusal(result, flgIoErrorGetMessage());
        return 0;
    }
    if (file == nullptr) return 0;
    FlgSkinView view = {};
    view.struct_size = sizeof view;
    FlgSkinFileInfo info = {};
    info.struct_size = sizeof info;
    FlgSkinFileWriteDesc desc = {};
    FLG_DEMAND(flgSkinFileWriteDescInit(&desc, sizeof desc) == FLG_OK);
    FLG_DEMAND(flgSkinFileGetView(file, &view) == FLG_OK && flgSkinFileGetInfo(file, &info) == FLG_OK);
    std::vector<FlgSkinAnimation> animations(info.animation_count);
    for (uint32_t i = 0; i < info.animation_count; ++i) {
        animations[i].struct_size = sizeof animations[i];
        FLG_DEMAND(flgSkinFileGetAnimation(file, i, &animations[i]) == FLG_OK);
    }
    desc.animations = animations.data();
    desc.animation_count = info.animation_count;
    std::vector<FlgMeshMaterial> materials(info.material_count, flgMeshMaterialDefaults());
    for (uint32_t i = 0; i < info.material_count; ++i) {
        FLG_DEMAND(flgSkinFileGetMaterial(file, i, &materials[i]) == FLG_OK);
    }
    desc.materials = materials.data();
    desc.material_count = info.material_count;
    std::vector<FlgTexture> textures(info.texture_count, flgTextureDefaults());
    for (uint32_t i = 0; i < info.texture_count; ++i)
        FLG_DEMAND(flgSkinFileGetTexture(file, i, &textures[i]) == FLG_OK);
    // Materials may say a texture where no primitive has coordinates.
    if (view.corner_uvs) {
        desc.textures = textures.data();
        desc.texture_count = info.texture_count;
    } else {
        for (FlgMeshMaterial& material : materials) material.texture = FLG_NO_INDEX;
    }
    desc.vertex_colors = info.vertex_colors;
    std::vector<FlgMorphTarget> morphs(info.morph_count, flgMorphTargetDefaults());
    for (uint32_t i = 0; i < info.morph_count; ++i)
        FLG_DEMAND(flgSkinFileGetMorphTarget(file, i, &morphs[i]) == FLG_OK);
    std::vector<FlgMorphAnimation> shapes(info.morph_animation_count, flgMorphAnimationDefaults());
    for (uint32_t i = 0; i < info.morph_animation_count; ++i)
        FLG_DEMAND(flgSkinFileGetMorphAnimation(file, i, &shapes[i]) == FLG_OK);
    desc.morphs = morphs.data();
    desc.morph_count = info.morph_count;
    desc.morph_animations = shapes.data();
    desc.morph_animation_count = info.morph_animation_count;
    desc.skin = &view;
    FLG_DEMAND(flgSkinFileWrite(copy.holding(nullptr, 0), &desc) == FLG_OK);
    flgSkinFileRelease(file);
    return 0;
}
