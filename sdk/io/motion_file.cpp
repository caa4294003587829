// SPDX-License-Identifier: MIT
// The C ABI of files with motions, translated onto this room.
#include "filigree/filigree_io.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/gltf/gltf_motion_writer.h"

using namespace flg::io;

extern "C" {

FlgResult flgMotionFileDescInit(FlgMotionFileDesc* desc, uint32_t struct_size) {
    return guarded("flgMotionFileDescInit", [&] {
        check_argument(desc, "desc");
        check_size<FlgMotionFileDesc>(struct_size, "desc");
        std::memset(desc, 0, struct_size);
        hand_out(motion_file_defaults(), desc, struct_size);
    });
}

FlgResult flgMotionFileWrite(const char* path, const FlgMotionFileDesc* desc) {
    return guarded(path ? path : "flgMotionFileWrite", [&] {
        check_argument(path, "path");
        const CheckedMotion motion(desc);
        const std::filesystem::path target = to_path(path);
        const std::string extension = extension_of(target);
        if (extension != ".glb")
            fail(FLG_ERROR_FORMAT, "", "can't be written: %s is not .glb", cited(extension).c_str());
        write_file(target, write_glb_motion(motion));
    });
}

}  // extern "C"
