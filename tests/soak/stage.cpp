// SPDX-License-Identifier: MIT
#include "soak/stage.h"

#include <cstdlib>

namespace flg::soak {

namespace {

void* allocate(void* user_data, size_t size, size_t alignment) {
    auto& stage = *static_cast<Stage*>(user_data);
    const int64_t live = stage.live_bytes.fetch_add(static_cast<int64_t>(size)) + static_cast<int64_t>(size);
    int64_t most = stage.max_live_bytes;
    while (live > most && !stage.max_live_bytes.compare_exchange_weak(most, live)) {}
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void release(void* user_data, void* memory, size_t size, size_t) {
    static_cast<Stage*>(user_data)->live_bytes -= static_cast<int64_t>(size);
    std::free(memory);
}

}  // namespace

Stage::Stage(uint64_t seed) : random_(seed) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 1;
    const FlgAllocator allocator = {sizeof allocator, this, allocate, release};
    desc.allocator = &allocator;
    must(flgContextCreate(&desc, &context), "flgContextCreate");
}

Stage::~Stage() {
    flgContextDestroy(context);
}

bool Stage::must(FlgResult result, const char* what) {
    if (result == FLG_OK) return true;
    errors.push_back(std::string(what) + ": " + flgResultGetName(result) + ", " + flgErrorGetMessage());
    return false;
}

bool Stage::done(FlgJob& job, bool* out_made) {
    *out_made = false;
    if (job.id == 0) return true;
    FlgJobStatus status{};
    status.struct_size = sizeof status;
    if (!must(flgJobGetStatus(context, job, &status), "flgJobGetStatus")) return true;
    if (status.state != FLG_JOB_STATE_FINISHED) return false;
    ++jobs_finished;
    *out_made = status.result == FLG_OK;
    if (status.result == FLG_ERROR_CANCELLED || status.result == FLG_ERROR_DEPENDENCY) {
        ++jobs_cancelled;
    } else if (!*out_made) {
        errors.push_back(std::string("a job: ") + flgResultGetName(status.result) + ", " + status.error);
    }
    must(flgJobRelease(context, job), "flgJobRelease");
    job = {};
    return true;
}

void Stage::cancel_at_random(FlgJob job) {
    if (job.id != 0 && draw(25) == 0) must(flgJobCancel(context, job), "flgJobCancel");
}

}  // namespace flg::soak
