// SPDX-License-Identifier: MIT
// Contexts: made, ticked, waited for, destroyed.
#include "api/context.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <new>

#include "api/descriptors.h"
#include "api/error.h"
#include "core/random.h"
#include "surfaces/field.h"
#include "surfaces/traced_curves.h"

namespace flg {

namespace {

constexpr uint32_t max_threads = 256;
constexpr double run_tick_us = 10'000;  // of flgContextRun

// Counts contexts, so that handles of one that is gone don't fit the next at the same address. The one thing that
// contexts share; what it counts to shows nowhere else.
std::atomic<uint32_t> contexts_made{0};

FlgContextDesc default_context_desc() {
    FlgContextDesc desc{};
    desc.struct_size = sizeof desc;
    desc.version = FLG_VERSION;
    desc.worker_count = 1;
    return desc;
}

// Before anything else: with another version even the struct's size may differ.
void check_version(const FlgContextDesc& desc) {
    constexpr size_t version_end = offsetof(FlgContextDesc, version) + sizeof desc.version;
    if (desc.struct_size < version_end) return;  // refused by its size
    const uint32_t major = desc.version >> 22;
    const uint32_t minor = desc.version >> 12 & 0x3ff;
    if (major != FLG_VERSION_MAJOR || (FLG_VERSION_MAJOR == 0 && minor != FLG_VERSION_MINOR)) {
        throw Failure(FLG_ERROR_VERSION, "the host was compiled for filigree %u.%u, this library is %d.%d.%d", major,
                      minor, FLG_VERSION_MAJOR, FLG_VERSION_MINOR, FLG_VERSION_PATCH);
    }
}

void check(const FlgContextDesc& desc) {
    if (desc.worker_count > max_threads) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "worker_count is %u, must be 0 to %u", desc.worker_count,
                      max_threads);
    }
    if (!desc.allocator.allocate != !desc.allocator.free) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "allocator has only one of allocate and free");
    }
    if (desc.job_system.submit && (desc.job_system.concurrency < 1 || desc.job_system.concurrency > max_threads)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "job_system.concurrency is %u, must be 1 to %u",
                      desc.job_system.concurrency, max_threads);
    }
    if (!desc.profiler.begin != !desc.profiler.end) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "profiler has only one of begin and end");
    }
}

// Callbacks run inside flgTick and must not enter it again.
void refuse_inside_callback(const Context& context, const char* function) {
    if (context.ticking)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s was called from a callback inside flgTick", function);
}

// Marks the time inside flgTick, also if a callback throws.
class Ticking {
public:
    explicit Ticking(Context& context) : context_(context) { context_.ticking = true; }
    ~Ticking() { context_.ticking = false; }
    Ticking(const Ticking&) = delete;
    Ticking& operator=(const Ticking&) = delete;

private:
    Context& context_;
};

}  // namespace

void refuse_after_destroy(const Context& context) {
    if (context.runtime.stopping()) {
        throw Failure(FLG_ERROR_INVALID_HANDLE, "context is being destroyed; call flgContextDestroy again");
    }
}

Context& get_context(FlgContext context) {
    if (!context) throw Failure(FLG_ERROR_INVALID_HANDLE, "context is null");
    if (context->magic != Context::alive) throw Failure(FLG_ERROR_INVALID_HANDLE, "context is not a living FlgContext");
    return *context;
}

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgContextDescInit(FlgContextDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_context_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgContextCreate(const FlgContextDesc* desc, FlgContext* out_context) {
    return guarded([&] {
        require(out_context, "out_context") = nullptr;
        if (desc) check_version(*desc);
        const FlgContextDesc read = desc ? read_struct(desc, default_context_desc(), "desc") : default_context_desc();
        check(read);
        HostMemory memory(read.allocator);
        void* place = memory.allocate(sizeof(Context), alignof(Context));
        try {
            const auto salt = static_cast<uint32_t>(mix64(contexts_made.fetch_add(1, std::memory_order_relaxed)));
            *out_context = new (place) Context(read, memory, salt);
        } catch (...) {
            memory.deallocate(place, sizeof(Context), alignof(Context));
            throw;
        }
        return FLG_OK;
    });
}

FlgResult flgContextDestroy(FlgContext context) {
    return guarded([&] {
        if (!context) return FLG_OK;
        Context& self = get_context(context);
        refuse_inside_callback(self, "flgContextDestroy");
        if (!self.runtime.stop()) return FLG_NOT_READY;
        HostMemory memory(self.memory);
        self.magic = 0;
        self.~Context();
        memory.deallocate(&self, sizeof(Context), alignof(Context));
        return FLG_OK;
    });
}

FlgResult flgTick(FlgContext context, uint32_t budget_us, FlgFrameReport* report) {
    return guarded([&] {
        FlgFrameReport made{};
        made.struct_size = sizeof made;
        made.longest_chunk_stage = "";
        if (report) write_struct(report, made, "report");
        Context& self = get_context(context);
        refuse_inside_callback(self, "flgTick");
        refuse_after_destroy(self);
        {
            const Ticking ticking(self);
            made = self.runtime.tick(budget_us);
        }
        if (report) write_struct(report, made, "report");
        return FLG_OK;
    });
}

FlgResult flgContextWait(FlgContext context, uint32_t timeout_us) {
    return guarded([&] {
        Context& self = get_context(context);
        refuse_inside_callback(self, "flgContextWait");
        return self.runtime.wait(timeout_us) ? FLG_OK : FLG_NOT_READY;
    });
}

FlgResult flgContextRun(FlgContext context, const FlgJob* jobs, uint32_t count, double seconds) {
    return guarded([&] {
        Context& self = get_context(context);
        refuse_inside_callback(self, "flgContextRun");
        refuse_after_destroy(self);
        if (count > 0) require(jobs, "jobs");
        if (!(seconds >= 0 && seconds <= 1e9)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "seconds is %g, must be 0 to 1e9", seconds);
        }
        for (uint32_t i = 0; i < count; ++i) self.jobs.get(jobs[i].id, "jobs");
        using Clock = std::chrono::steady_clock;
        const auto end = Clock::now() + std::chrono::duration<double, std::micro>(seconds * 1e6);
        for (bool first = true;; first = false) {
            bool finished = count > 0;
            for (uint32_t i = 0; i < count; ++i) {
                const Job& job = *self.jobs.get(jobs[i].id, "jobs");  // a callback may have released it
                finished = finished && job.status.state == FLG_JOB_FINISHED;
            }
            if (finished) break;
            const double left_us = std::chrono::duration<double, std::micro>(end - Clock::now()).count();
            if (left_us <= 0 && !first) return FLG_NOT_READY;
            const auto budget_us = static_cast<uint32_t>(std::clamp(left_us, 1.0, run_tick_us));
            {
                const Ticking ticking(self);
                const FlgFrameReport report = self.runtime.tick(budget_us);
                if (count == 0 && report.jobs_pending == 0) return FLG_OK;
            }
            self.runtime.wait(budget_us);
        }
        for (uint32_t i = 0; i < count; ++i) {
            const Job& job = *self.jobs.get(jobs[i].id, "jobs");
            if (job.status.result != FLG_OK) return set_last_error(job.status.result, job.status.error);
        }
        return FLG_OK;
    });
}

}  // extern "C"
