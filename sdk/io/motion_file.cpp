// SPDX-License-Identifier: MIT
// The C ABI of files with motions, translated onto this room.
#include "filigree/filigree_io.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/gltf/gltf_motion_writer.h"

using namespace flg::io;
using flg::sized;

extern "C" {

FlgResult flgMotionFileWriteDescInit(FlgMotionFileWriteDesc* desc, uint32_t struct_size) {
    return init("flgMotionFileWriteDescInit", desc, struct_size, sized<FlgMotionFileWriteDesc>());
}

FlgResult flgMotionFileWrite(const char* path, const FlgMotionFileWriteDesc* desc) {
    return write_to("flgMotionFileWrite", path, desc, [&](const Path& target) {
        const CheckedMotion motion(desc);
        check_is_glb(target);
        write_file(target, write_glb_motion(motion));
    });
}

}  // extern "C"
