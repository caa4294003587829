// SPDX-License-Identifier: MIT
// The macros of tangles.
#include "tangles/tangle_macros.h"
#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/tangle_change.h"

namespace flg {

namespace {

FlgTangleMacroDesc default_macro_desc() {
    FlgTangleMacroDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    desc.count = 4;
    desc.size = 0.1f;
    desc.spacing = 0.3f;
    desc.seed = 1;
    return desc;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgTangleMacroDescInit(FlgTangleMacroDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_macro_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgTangleApplyMacro(FlgContext context, const FlgTangleMacroDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleMacroDesc read = read_struct(desc, default_macro_desc(), "desc");
        check_enum(read.kind, FLG_TANGLE_SUNBURST, FLG_TANGLE_CELLS, "desc.kind", "FLG_TANGLE_");
        check_range(read.region_count >= 1, "desc.region_count", read.region_count, "at least 1");
        check_range(read.count >= 1 && read.count <= 256, "desc.count", read.count, "1 to 256");
        check_range(is_positive(read.size), "desc.size", read.size, "finite and above 0");
        check_range(is_positive(read.spacing), "desc.spacing", read.spacing, "finite and above 0");
        TangleChange change(self, read.job, read.tangle, "desc.tangle");
        MacroRequest macro(&self.memory);
        macro.kind = read.kind;
        macro.regions = read_region_ids(read.regions, read.region_count, "desc.regions", &self.memory);
        macro.count = read.count;
        macro.size = read.size;
        macro.spacing = read.spacing;
        macro.seed = read.seed;
        change.needs_blocks();
        change.commit(divide_in_sequence(change.submission.pace(), change.tangle, expand_macro(macro, &self.memory),
                                         change.revision()),
                      out_job);
        return FLG_OK;
    });
}

}  // extern "C"
