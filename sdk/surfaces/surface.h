// SPDX-License-Identifier: MIT
// A surface as hosts hold it: a mesh, what geodesics need on it, and who uses it when.
//
// What lives in this room: meshes in flat arrays, their repair and refinement, geodesic distances, tracing, cutting and
// sampling, each a task or a kernel that can be used and tested by itself; and the jobs that drive them (surface_jobs.h
// and its neighbours). What does not: picking (pick/), patterns (tangles/), files (io/).
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/origin.h"
#include "filigree/filigree_surface.h"
#include "runtime/product.h"
#include "surfaces/geodesics/geodesic_solvers.h"
#include "surfaces/mesh/mesh_growth.h"
#include "surfaces/repair/mesh_repair.h"

namespace flg {

// Jobs in the order in which they were started: readers side by side, those that change the surface alone. A job that
// fails or is cancelled before its turn is done early, so each one waits for all before it that stand in its way, not
// only for the last. Host's thread only.
class SurfaceOrder {
public:
    explicit SurfaceOrder(Memory* memory) : changes_(memory), readers_(memory) {}

    // What a job that is about to be started has to wait for; makes room for it, so that entering can't fail.
    void add_prerequisites(bool changes, std::pmr::vector<Prerequisite>& prerequisites);
    // It was started.
    void enter(const std::shared_ptr<Job>& job, bool changes) noexcept;
    // A job that changes the surface was published.
    void leave() { --pending_changes_; }

    // Changes that were started.
    uint32_t revision() const { return revision_; }
    bool is_changing() const { return pending_changes_ > 0; }

private:
    using Jobs = std::pmr::vector<std::weak_ptr<Job>>;
    static void forget_published(Jobs& jobs);

    // In the order they were started; those that are published are forgotten when the next one comes.
    Jobs changes_, readers_;
    uint32_t revision_ = 0;
    uint32_t pending_changes_ = 0;
};

class Surface final : public Product {
public:
    // `caches`: for what distances are computed with.
    Surface(Memory* memory, Memory* caches)
        : order(memory), repaired(memory), columns(memory), attributes(memory), shaped_at(memory), solvers(caches) {}

    // Host's thread.
    SurfaceOrder order;

    Origin origin{};  // of the positions; set before anything else sees the surface

    // Jobs, as the order lets them.
    RepairedMesh repaired;
    MeshExtent extent;
    MeshColumns columns;                        // beside the position; behind them the sources' weights, if asked for
    std::pmr::vector<FlgAttribute> attributes;  // of the columns that the host sees
    // The vertices of the input's triangles, welded, in the input's order; null: no one asked where triangles lie.
    std::shared_ptr<const Buffer<Triple>> input_triangles;
    // The revision at which a triangle got its vertices; those behind the end have the present one.
    GrowingBuffer<uint32_t> shaped_at;
    uint32_t shape_revision(uint32_t triangle) const {
        return triangle < shaped_at.size() ? shaped_at[triangle] : order.revision();
    }
    GeodesicSolvers solvers;

    Mesh& mesh() { return repaired.mesh; }
    const Mesh& mesh() const { return repaired.mesh; }

    // What the host sees; the view only while no change is pending.
    const FlgSurfaceView& view() const { return view_; }
    const FlgSurfaceProvenanceView& provenance() const { return provenance_; }
    FlgSurfaceReport report() const { return report_; }
    // By the job that made it, at its end: when that is published, a cut may be under way.
    void write_report();
    void warn(const Host& host) const noexcept override;
    // A job was published. While a later one may change the arrays they are left alone: the host does not see them
    // then.
    void show_if_at_rest() noexcept;

private:
    void show() noexcept override { show_if_at_rest(); }

    FlgColumn view_columns_[17];  // the position and 16 others
    FlgMeshView view_mesh_{};
    FlgSurfaceView view_{};
    FlgSurfaceProvenanceView provenance_{};
    FlgSurfaceReport report_{};
};

// A job that changes a surface: what the host sees of it, and of a product that comes with it, changes when it is
// published.
class SurfaceChange final : public Output {
public:
    SurfaceChange(std::shared_ptr<Surface> surface, std::shared_ptr<Product> product)
        : surface_(std::move(surface)), product_(std::move(product)) {}
    void publish_partial() noexcept override {}
    void publish(const Job& job) noexcept override {
        surface_->order.leave();
        surface_->show_if_at_rest();
        if (product_) product_->publish(job);
    }

private:
    std::shared_ptr<Surface> surface_;
    std::shared_ptr<Product> product_;
};

}  // namespace flg
