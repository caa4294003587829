// SPDX-License-Identifier: MIT
// A context: the runtime and the handles of its objects.
#pragma once

#include "core/host_memory.h"
#include "curves/curve_set.h"
#include "runtime/context_memory.h"
#include "runtime/handle_table.h"
#include "runtime/runtime.h"
#include "stylization/live_stroke.h"
#include "stylization/style.h"

namespace flg {
class Surface;
class Field;
class TracedCurves;
class Tangle;
class HeldStraightSkeleton;
class HeldOutline;
class HeldPart;
class HeldPartMesh;
class HeldModel;
class HeldSkin;
class HeldPull;
class HeldPulled;
class ManifoldProduct;
class Obstacles;
class Spline;
class Motion;

// What objects behind handles of this kind are counted as.
MemoryKind memory_kind(HandleKind kind);

template <class T, class... Arguments>
std::shared_ptr<T> make_object(Memory* memory, Arguments&&... arguments) {
    return std::allocate_shared<T>(std::pmr::polymorphic_allocator<T>(memory), std::forward<Arguments>(arguments)...);
}

// What the handle of a context stands for.
struct Context {
    Context(const FlgContextDesc& desc, const HostMemory& host_memory, uint32_t salt)
        : memory(host_memory, desc.memory_limit, sizeof(Context)),
          jobs(HandleKind::job, salt, memory[MemoryKind::runtime]),
          curve_sets(HandleKind::curve_set, salt, memory[MemoryKind::runtime]),
          styles(HandleKind::style, salt, memory[MemoryKind::runtime]),
          live_strokes(HandleKind::live_stroke, salt, memory[MemoryKind::runtime]),
          surfaces(HandleKind::surface, salt, memory[MemoryKind::runtime]),
          fields(HandleKind::field, salt, memory[MemoryKind::runtime]),
          surface_curves(HandleKind::surface_curves, salt, memory[MemoryKind::runtime]),
          tangles(HandleKind::tangle, salt, memory[MemoryKind::runtime]),
          straight_skeletons(HandleKind::straight_skeleton, salt, memory[MemoryKind::runtime]),
          outlines(HandleKind::outline, salt, memory[MemoryKind::runtime]),
          parts(HandleKind::part, salt, memory[MemoryKind::runtime]),
          part_meshes(HandleKind::part_mesh, salt, memory[MemoryKind::runtime]),
          models(HandleKind::model, salt, memory[MemoryKind::runtime]),
          skins(HandleKind::skin, salt, memory[MemoryKind::runtime]),
          manifolds(HandleKind::manifold, salt, memory[MemoryKind::runtime]),
          obstacles(HandleKind::obstacles, salt, memory[MemoryKind::runtime]),
          splines(HandleKind::spline, salt, memory[MemoryKind::runtime]),
          motions(HandleKind::motion, salt, memory[MemoryKind::runtime]),
          pulls(HandleKind::pull, salt, memory[MemoryKind::runtime]),
          pulled(HandleKind::pulled, salt, memory[MemoryKind::runtime]),
          runtime(desc, memory[MemoryKind::runtime], memory.large_blocks()) {}

    // An object for a handle of the table, in the memory it is counted as; which is its last argument, if it takes it.
    template <class T, class... Arguments>
    std::shared_ptr<T> make(const HandleTable<T>& table, Arguments&&... arguments) {
        Memory* const counted = memory[memory_kind(table.kind())];
        if constexpr (std::is_constructible_v<T, Arguments..., Memory*>) {
            return make_object<T>(counted, std::forward<Arguments>(arguments)..., counted);
        } else {
            return make_object<T>(counted, std::forward<Arguments>(arguments)...);
        }
    }

    ContextMemory memory;
    HandleTable<Job> jobs;
    HandleTable<CurveSet> curve_sets;
    HandleTable<Style> styles;
    HandleTable<LiveStroke> live_strokes;
    HandleTable<Surface> surfaces;
    HandleTable<Field> fields;
    HandleTable<TracedCurves> surface_curves;
    HandleTable<Tangle> tangles;
    HandleTable<HeldStraightSkeleton> straight_skeletons;
    HandleTable<HeldOutline> outlines;
    HandleTable<HeldPart> parts;
    HandleTable<HeldPartMesh> part_meshes;
    HandleTable<HeldModel> models;
    HandleTable<HeldSkin> skins;
    HandleTable<ManifoldProduct> manifolds;
    HandleTable<Obstacles> obstacles;
    HandleTable<Spline> splines;
    HandleTable<Motion> motions;
    HandleTable<HeldPull> pulls;
    HandleTable<HeldPulled> pulled;
    Runtime runtime;
    bool ticking = false;  // inside flgContextTick: callbacks may not tick, wait or destroy
};

// The context behind the handle; throws if there is none.
Context& get_context(FlgContext context);

// After a first flgContextDestroy that had to wait, nothing else is to be done with a context.
void refuse_after_destroy(const Context& context);

// Starts a job in two steps, so that a failure in between leaves nothing behind: make one of these, start its job's
// strand with a task, then commit. `Output` is the object that the job makes.
class Submission {
public:
    Submission(Context& context, const FlgJobOptions* job);  // null: defaults

    Job& job() { return *job_; }
    Pace& pace() { return job_->strand.pace; }

    // The job waits for whatever still makes this input; refuses one whose job failed.
    template <class T>
    void read(const T& input, const char* argument) {
        if (input.visible_result() < 0) {
            throw Failure(FLG_ERROR_DEPENDENCY, "%s was not made: %.200s", argument, input.error());
        }
        if (std::shared_ptr<Job> producer = input.producer.lock()) dependencies_.push_back(std::move(producer));
    }

    // The job waits for another, which may be null: done already.
    void wait_for(std::shared_ptr<Job> job) {
        if (job) dependencies_.push_back(std::move(job));
    }
    // Likewise, but that one may fail.
    void wait_for_end_of(const std::shared_ptr<Job>& job) {
        if (job) dependencies_.emplace_back(job, true);
    }
    // The job waits for its turn on a surface, and for the job that makes it.
    void read_surface(const std::shared_ptr<Surface>& surface, const char* argument) {
        use_surface(surface, false, argument);
    }
    // Likewise a job that changes it.
    void change_surface(const std::shared_ptr<Surface>& surface, const char* argument) {
        use_surface(surface, true, argument);
    }

    // Queues the job. Writes handles for the output and, unless out_job is null, for the job.
    template <class T>
    uint64_t commit(HandleTable<T>& table, const std::shared_ptr<T>& output, FlgJob* out_job) {
        return commit(table, output, output, out_job);
    }

    // Likewise a job that makes more than what the handle is for: `whole` publishes it all.
    template <class T>
    uint64_t commit(HandleTable<T>& table, std::shared_ptr<T> output, std::shared_ptr<Output> whole, FlgJob* out_job) {
        output->producer = job_;
        job_->output = std::move(whole);
        job_->memory.set_result(memory_kind(table.kind()));
        Output& shown = *output;
        const uint64_t id = shown.handle = table.add(std::move(output));
        try {
            queue(out_job);
        } catch (...) {
            table.remove(id, "output");
            throw;
        }
        return id;
    }

    // Queues a job whose output, which may be null, has no handle of its own.
    void commit(std::shared_ptr<Output> output, MemoryKind kind, FlgJob* out_job) {
        job_->output = std::move(output);
        job_->memory.set_result(kind);
        queue(out_job);
    }

private:
    void use_surface(const std::shared_ptr<Surface>& surface, bool changes, const char* argument);
    void queue(FlgJob* out_job);

    Context& context_;
    std::shared_ptr<Job> job_;
    std::pmr::vector<Prerequisite> dependencies_;
    struct Turn {
        std::shared_ptr<Surface> surface;
        bool changes;
    };
    std::pmr::vector<Turn> turns_;
};

}  // namespace flg
