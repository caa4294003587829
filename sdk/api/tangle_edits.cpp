// SPDX-License-Identifier: MIT
// Histories of tangles, edited before their end.
#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/tangle_change.h"
#include "api/tangle_requests.h"
#include "tangles/history_edit.h"

namespace flg {

namespace {

// `fill(edit, change, memory)` says what is edited.
template <class Fill>
FlgResult edit_step(FlgContext context, FlgTangle tangle, HistoryEdit::Kind kind, uint32_t step,
                    const FlgJobOptions* job, FlgJob* out_job, Fill fill) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        TangleChange change(self, job, tangle, "tangle");
        HistoryEdit edit(kind, memory);
        edit.step = step;
        fill(edit, change, memory);
        change.needs_blocks();
        change.commit(edit_history(change.submission.pace(), change.tangle, std::move(edit), change.revision()),
                      out_job);
    });
}

// The step of a change or an insertion.
auto read_described(const FlgTangleStep* desc) {
    return [desc](HistoryEdit& edit, const TangleChange& change, Memory* memory) {
        const FlgTangleStep step = read_struct(desc, sized<FlgTangleStep>(), "desc");
        edit.records = read_step(memory, step, change.tangle->surface).records;
    };
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgTangleEditStep(FlgContext context, FlgTangle tangle, uint32_t step, const FlgTangleStep* desc,
                            const FlgJobOptions* job, FlgJob* out_job) {
    return edit_step(context, tangle, HistoryEdit::Kind::change, step, job, out_job, read_described(desc));
}

FlgResult flgTangleInsertStep(FlgContext context, FlgTangle tangle, uint32_t step, const FlgTangleStep* desc,
                              const FlgJobOptions* job, FlgJob* out_job) {
    return edit_step(context, tangle, HistoryEdit::Kind::insert, step, job, out_job, read_described(desc));
}

FlgResult flgTangleMoveStep(FlgContext context, FlgTangle tangle, uint32_t step, uint32_t to, const FlgJobOptions* job,
                            FlgJob* out_job) {
    return edit_step(context, tangle, HistoryEdit::Kind::move, step, job, out_job,
                     [to](HistoryEdit& edit, const TangleChange&, Memory*) { edit.to = to; });
}

FlgResult flgTangleRemoveStep(FlgContext context, FlgTangle tangle, uint32_t step, const FlgJobOptions* job,
                              FlgJob* out_job) {
    return edit_step(context, tangle, HistoryEdit::Kind::remove, step, job, out_job,
                     [](HistoryEdit&, const TangleChange&, Memory*) {});
}

FlgResult flgTangleMuteStep(FlgContext context, FlgTangle tangle, uint32_t step, uint32_t muted,
                            const FlgJobOptions* job, FlgJob* out_job) {
    return edit_step(context, tangle, HistoryEdit::Kind::mute, step, job, out_job,
                     [muted](HistoryEdit& edit, const TangleChange&, Memory*) { edit.muted = muted != 0; });
}

}  // extern "C"
