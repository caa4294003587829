// SPDX-License-Identifier: MIT
// A context: the runtime and the handles of its objects.
#pragma once

#include "core/host_memory.h"
#include "curves/curve_set.h"
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
class ManifoldProduct;
class Obstacles;
class Spline;
class Motion;

// What the handle of a context stands for.
struct Context {
    Context(const FlgContextDesc& desc, const HostMemory& host_memory, uint32_t salt)
        : memory(host_memory),
          jobs(HandleKind::job, salt, &memory),
          curve_sets(HandleKind::curve_set, salt, &memory),
          styles(HandleKind::style, salt, &memory),
          live_strokes(HandleKind::live_stroke, salt, &memory),
          surfaces(HandleKind::surface, salt, &memory),
          fields(HandleKind::field, salt, &memory),
          surface_curves(HandleKind::surface_curves, salt, &memory),
          tangles(HandleKind::tangle, salt, &memory),
          straight_skeletons(HandleKind::straight_skeleton, salt, &memory),
          outlines(HandleKind::outline, salt, &memory),
          parts(HandleKind::part, salt, &memory),
          part_meshes(HandleKind::part_mesh, salt, &memory),
          models(HandleKind::model, salt, &memory),
          skins(HandleKind::skin, salt, &memory),
          manifolds(HandleKind::manifold, salt, &memory),
          obstacles(HandleKind::obstacles, salt, &memory),
          splines(HandleKind::spline, salt, &memory),
          motions(HandleKind::motion, salt, &memory),
          runtime(desc, &memory) {}

    HostMemory memory;
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
    Runtime runtime;
    bool ticking = false;  // inside flgContextTick: callbacks may not tick, wait or destroy
};

// The context behind the handle; throws if there is none.
Context& get_context(FlgContext context);

// After a first flgContextDestroy that had to wait, nothing else is to be done with a context.
void refuse_after_destroy(const Context& context);

// A new object in the context's memory.
template <class T, class... Arguments>
std::shared_ptr<T> make_object(Context& context, Arguments&&... arguments) {
    return std::allocate_shared<T>(std::pmr::polymorphic_allocator<T>(&context.memory),
                                   std::forward<Arguments>(arguments)...);
}

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
        const uint64_t id = table.add(std::move(output));
        try {
            queue(out_job);
        } catch (...) {
            table.remove(id, "output");
            throw;
        }
        return id;
    }

    // Queues a job whose output, which may be null, has no handle of its own.
    void commit(std::shared_ptr<Output> output, FlgJob* out_job) {
        job_->output = std::move(output);
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
