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
    desc.skin = &view;
    FLG_DEMAND(flgSkinFileWrite(copy.holding(nullptr, 0), &desc) == FLG_OK);
    flgSkinFileRelease(file);
    return 0;
}
