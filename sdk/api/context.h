// SPDX-License-Identifier: MIT
// What an FlgContext points to: the runtime and the handles of one context.
#pragma once

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
}  // namespace flg

// In the global namespace because the C header declares it.
struct FlgContextT {
    FlgContextT(const FlgContextDesc& desc, const flg::HostMemory& host_memory, uint32_t salt)
        : memory(host_memory),
          jobs(flg::HandleKind::job, salt, &memory),
          curve_sets(flg::HandleKind::curve_set, salt, &memory),
          styles(flg::HandleKind::style, salt, &memory),
          live_strokes(flg::HandleKind::live_stroke, salt, &memory),
          surfaces(flg::HandleKind::surface, salt, &memory),
          fields(flg::HandleKind::field, salt, &memory),
          surface_curves(flg::HandleKind::surface_curves, salt, &memory),
          tangles(flg::HandleKind::tangle, salt, &memory),
          straight_skeletons(flg::HandleKind::straight_skeleton, salt, &memory),
          outlines(flg::HandleKind::outline, salt, &memory),
          parts(flg::HandleKind::part, salt, &memory),
          part_meshes(flg::HandleKind::part_mesh, salt, &memory),
          models(flg::HandleKind::model, salt, &memory),
          skins(flg::HandleKind::skin, salt, &memory),
          manifolds(flg::HandleKind::manifold, salt, &memory),
          obstacles(flg::HandleKind::obstacles, salt, &memory),
          splines(flg::HandleKind::spline, salt, &memory),
          motions(flg::HandleKind::motion, salt, &memory),
          runtime(desc, &memory) {}

    static constexpr uint64_t alive = 0x66696c6967726565;  // "filigree"
    uint64_t magic = alive;
    flg::HostMemory memory;
    flg::HandleTable<flg::Job> jobs;
    flg::HandleTable<flg::CurveSet> curve_sets;
    flg::HandleTable<flg::Style> styles;
    flg::HandleTable<flg::LiveStroke> live_strokes;
    flg::HandleTable<flg::Surface> surfaces;
    flg::HandleTable<flg::Field> fields;
    flg::HandleTable<flg::TracedCurves> surface_curves;
    flg::HandleTable<flg::Tangle> tangles;
    flg::HandleTable<flg::HeldStraightSkeleton> straight_skeletons;
    flg::HandleTable<flg::HeldOutline> outlines;
    flg::HandleTable<flg::HeldPart> parts;
    flg::HandleTable<flg::HeldPartMesh> part_meshes;
    flg::HandleTable<flg::HeldModel> models;
    flg::HandleTable<flg::HeldSkin> skins;
    flg::HandleTable<flg::ManifoldProduct> manifolds;
    flg::HandleTable<flg::Obstacles> obstacles;
    flg::HandleTable<flg::Spline> splines;
    flg::HandleTable<flg::Motion> motions;
    flg::Runtime runtime;
    bool ticking = false;  // inside flgTick: callbacks may not tick, wait or destroy
};

namespace flg {

using Context = FlgContextT;

// The context behind the pointer; throws if it is null or visibly none.
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
    Submission(Context& context, const FlgJobOptions& options);

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

// Defaults of the job part of descriptors.
FlgJobOptions default_job_options();

}  // namespace flg
