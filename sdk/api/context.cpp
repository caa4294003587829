// SPDX-License-Identifier: MIT
// Contexts: made, ticked, waited for, destroyed.
#include "api/context.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <new>

#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "core/random.h"
#include "surfaces/field.h"
#include "surfaces/traced_curves.h"

namespace flg {

namespace {

constexpr uint32_t max_threads = 256;
constexpr double run_tick_us = 10'000;  // of flgContextRun

// The living contexts: all that contexts share. A slot's id is that of its context's handle; the count keeps handles of
// contexts that are gone from fitting the next in their slot.
struct Slot {
    static constexpr uint64_t vacant = 0, taken = 1;  // no handle has these ids
    std::atomic<uint64_t> id{vacant};
    std::atomic<Context*> context{nullptr};
};
constexpr uint32_t max_contexts = 1024;
std::array<Slot, max_contexts> slots;
std::atomic<uint32_t> contexts_made{0};

// A handle's bits are those of runtime/handle_table.h, its kind 0xff.
uint64_t context_id(uint32_t slot, uint32_t count) {
    return (uint64_t{slot} + 1) | uint64_t{count & 0xffffff} << 32 | uint64_t{0xff} << 56;
}

uint32_t take_slot() {
    for (uint32_t slot = 0; slot < max_contexts; ++slot) {
        uint64_t expected = Slot::vacant;
        if (slots[slot].id.compare_exchange_strong(expected, Slot::taken)) return slot;
    }
    throw Failure(FLG_ERROR_LIMIT, "there are %u contexts already, the most at a time", max_contexts);
}

Slot& slot_of(FlgContext context) {
    if (context.id == 0) throw Failure(FLG_ERROR_INVALID_HANDLE, "context is null");
    const uint32_t index = static_cast<uint32_t>(context.id) - 1;
    if (index >= max_contexts || slots[index].id.load(std::memory_order_acquire) != context.id) {
        throw Failure(FLG_ERROR_INVALID_HANDLE, "context (0x%llx) is not a living context",
                      static_cast<unsigned long long>(context.id));
    }
    return slots[index];
}

// The host's struct, completed; null stands for the defaults.
template <class T>
T read_hook(const T* hook, const char* name) {
    return hook ? read_struct(hook, sized<T>(), name) : sized<T>();
}

FlgJobSystem default_job_system() {
    auto system = sized<FlgJobSystem>();
    system.concurrency = 1;
    return system;
}

FlgContextDesc default_context_desc() {
    auto desc = sized<FlgContextDesc>();
    desc.version = FLG_VERSION;
    desc.worker_count = 1;
    return desc;
}

FlgFrameReport empty_report() {
    auto report = sized<FlgFrameReport>();
    report.max_slice_stage = "";
    return report;
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

// A context's settings and hooks at this library's sizes, checked.
struct Settings {
    FlgContextDesc desc;
    FlgAllocator allocator;
    FlgJobSystem job_system;
    FlgLog log;
    FlgClock clock;
    FlgProfiler profiler;

    explicit Settings(const FlgContextDesc& from)
        : desc(from),
          allocator(read_hook(from.allocator, "desc.allocator")),
          job_system(from.job_system ? read_struct(from.job_system, default_job_system(), "desc.job_system")
                                     : default_job_system()),
          log(read_hook(from.log, "desc.log")),
          clock(read_hook(from.clock, "desc.clock")),
          profiler(read_hook(from.profiler, "desc.profiler")) {
        if (desc.worker_count > max_threads) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.worker_count is %u, must be 0 to %u", desc.worker_count,
                          max_threads);
        }
        if (!allocator.allocate != !allocator.free) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "allocator has only one of allocate and free");
        }
        if (job_system.submit && (job_system.concurrency < 1 || job_system.concurrency > max_threads)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "job_system.concurrency is %u, must be 1 to %u",
                          job_system.concurrency, max_threads);
        }
        if (!profiler.begin != !profiler.end) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "profiler has only one of begin and end");
        }
        desc.allocator = &allocator;
        desc.job_system = &job_system;
        desc.log = &log;
        desc.clock = &clock;
        desc.profiler = &profiler;
    }
    Settings(const Settings&) = delete;
    Settings& operator=(const Settings&) = delete;
};

// Callbacks run inside flgContextTick and must not enter it again.
void refuse_inside_callback(const Context& context, const char* function) {
    if (context.ticking)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s was called from a callback inside flgContextTick", function);
}

// Marks the time inside flgContextTick, also if a callback throws.
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

MemoryKind memory_kind(HandleKind kind) {
    switch (kind) {
        case HandleKind::job: return MemoryKind::runtime;
        case HandleKind::style: return MemoryKind::styles;
        case HandleKind::curve_set:
        case HandleKind::live_stroke:
        case HandleKind::spline:
        case HandleKind::motion: return MemoryKind::curves;
        case HandleKind::surface:
        case HandleKind::field:
        case HandleKind::surface_curves:
        case HandleKind::tangle:
        case HandleKind::manifold:
        case HandleKind::obstacles: return MemoryKind::surfaces;
        case HandleKind::straight_skeleton:
        case HandleKind::outline:
        case HandleKind::part:
        case HandleKind::part_mesh:
        case HandleKind::model:
        case HandleKind::pull:
        case HandleKind::pulled:
        case HandleKind::skin: return MemoryKind::models;
    }
    return MemoryKind::runtime;
}

Context& get_context(FlgContext context) {
    return *slot_of(context).context.load(std::memory_order_relaxed);
}

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgAllocatorInit(FlgAllocator* allocator, uint32_t struct_size) {
    return init(allocator, struct_size, sized<FlgAllocator>(), "allocator");
}

FlgResult flgLogInit(FlgLog* log, uint32_t struct_size) {
    return init(log, struct_size, sized<FlgLog>(), "log");
}

FlgResult flgClockInit(FlgClock* clock, uint32_t struct_size) {
    return init(clock, struct_size, sized<FlgClock>(), "clock");
}

FlgResult flgProfilerInit(FlgProfiler* profiler, uint32_t struct_size) {
    return init(profiler, struct_size, sized<FlgProfiler>(), "profiler");
}

FlgResult flgJobSystemInit(FlgJobSystem* system, uint32_t struct_size) {
    return init(system, struct_size, default_job_system(), "system");
}

FlgResult flgContextDescInit(FlgContextDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_context_desc());
}

FlgResult flgContextCreate(const FlgContextDesc* desc, FlgContext* out_context) {
    return guarded([&] {
        require(out_context, "out_context") = {};
        if (desc) check_version(*desc);
        const Settings settings(desc ? read_struct(desc, default_context_desc(), "desc") : default_context_desc());
        HostMemory memory(settings.allocator);
        void* place = memory.allocate(sizeof(Context), alignof(Context));
        try {
            const uint32_t count = contexts_made.fetch_add(1, std::memory_order_relaxed);
            const uint32_t slot = take_slot();
            try {
                const auto salt = static_cast<uint32_t>(mix64(count));
                slots[slot].context.store(new (place) Context(settings.desc, memory, salt), std::memory_order_relaxed);
            } catch (...) {
                slots[slot].id.store(Slot::vacant, std::memory_order_release);
                throw;
            }
            *out_context = {context_id(slot, count)};
            slots[slot].id.store(out_context->id, std::memory_order_release);
        } catch (...) {
            memory.deallocate(place, sizeof(Context), alignof(Context));
            throw;
        }
        return FLG_OK;
    });
}

FlgResult flgContextDestroy(FlgContext context) {
    return guarded([&] {
        if (context.id == 0) return FLG_OK;
        Context& self = get_context(context);
        refuse_inside_callback(self, "flgContextDestroy");
        if (!self.runtime.stop()) return FLG_NOT_READY;
        slot_of(context).id.store(Slot::vacant, std::memory_order_release);
        HostMemory memory(self.memory.host());
        self.~Context();
        memory.deallocate(&self, sizeof(Context), alignof(Context));
        return FLG_OK;
    });
}

FlgResult flgFrameReportInit(FlgFrameReport* report, uint32_t struct_size) {
    return init(report, struct_size, empty_report(), "report");
}

FlgResult flgContextTick(FlgContext context, uint32_t budget_us, FlgFrameReport* report) {
    return guarded([&] {
        FlgFrameReport made = empty_report();
        if (report) write_struct(report, made, "report");
        Context& self = get_context(context);
        refuse_inside_callback(self, "flgContextTick");
        refuse_after_destroy(self);
        {
            const Ticking ticking(self);
            made = self.runtime.tick(budget_us);
        }
        if (report) write_struct(report, made, "report");
        return FLG_OK;
    });
}

FlgResult flgMemoryUseInit(FlgMemoryUse* use, uint32_t struct_size) {
    return init(use, struct_size, sized<FlgMemoryUse>(), "use");
}

FlgResult flgContextGetMemory(FlgContext context, FlgMemoryKind kind, FlgMemoryUse* out_use) {
    return guarded([&] {
        write_struct(out_use, sized<FlgMemoryUse>(), "out_use");
        check_enum(kind, FLG_MEMORY_KIND_TOTAL, FLG_MEMORY_KIND_RUNTIME, "kind", "FLG_MEMORY_KIND_");
        write_struct(out_use, get_context(context).memory.use(kind), "out_use");
    });
}

FlgResult flgContextSetMemoryLimit(FlgContext context, FlgMemoryKind kind, uint64_t bytes) {
    return guarded([&] {
        check_enum(kind, FLG_MEMORY_KIND_TOTAL, FLG_MEMORY_KIND_RUNTIME, "kind", "FLG_MEMORY_KIND_");
        get_context(context).memory.set_limit(kind, bytes);
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
        const auto job_at = [&](uint32_t i) {
            char name[24];
            std::snprintf(name, sizeof name, "jobs[%u]", i);
            return self.jobs.get(jobs[i].id, name);
        };
        for (uint32_t i = 0; i < count; ++i) job_at(i);
        using Clock = std::chrono::steady_clock;
        const auto end = Clock::now() + std::chrono::duration<double, std::micro>(seconds * 1e6);
        for (bool first = true;; first = false) {
            bool finished = count > 0;
            for (uint32_t i = 0; i < count; ++i) {
                // A callback may have released it.
                finished = finished && job_at(i)->status.state == FLG_JOB_STATE_FINISHED;
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
            const FlgJobStatus& status = job_at(i)->status;
            if (status.result != FLG_OK) return set_last_error(status.result, status.error);
        }
        return FLG_OK;
    });
}

}  // extern "C"
