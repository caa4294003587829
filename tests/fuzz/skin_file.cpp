// SPDX-License-Identifier: MIT
// Files of skinned models, of the format FLG_EXTENSION: refused, or a skin that can be written again (the writer checks
// all that a view promises).
#include <vector>

#include "filigree/filigree_io.h"
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const flg::fuzz::InputFile input(FLG_EXTENSION), copy(".copy.glb");
    FlgSkinFile file = nullptr;
    const FlgResult result = flgSkinFileRead(input.holding(data, size), &file);
    if (result != FLG_OK) {
        FLG_DEMAND(file == nullptr);
        flg::fuzz::demand_refusal(result, flgIoLastError());
        return 0;
    }
    if (file == nullptr) return 0;
    FlgSkinView view = {};
    view.struct_size = sizeof view;
    FlgSkinFileInfo info = {};
    info.struct_size = sizeof info;
    FlgSkinFileDesc desc = {};
    FLG_DEMAND(flgSkinFileDescInit(&desc, sizeof desc) == FLG_OK);
    FLG_DEMAND(flgSkinFileGetView(file, &view) == FLG_OK && flgSkinFileGetInfo(file, &info) == FLG_OK);
    FLG_DEMAND(flgSkinFileGetAnimations(file, &desc.animations, &desc.animation_count) == FLG_OK);
    FLG_DEMAND(flgSkinFileGetMaterials(file, &desc.materials, &desc.material_count) == FLG_OK);
    desc.skin = &view;
    FLG_DEMAND(flgSkinFileWrite(copy.holding(nullptr, 0), &desc) == FLG_OK);
    flgSkinFileRelease(file);
    return 0;
}
