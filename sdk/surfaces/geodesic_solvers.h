// SPDX-License-Identifier: MIT
// What distances on one surface are computed with: made by the first job that needs it, kept up to date by cuts.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "runtime/product.h"
#include "surfaces/geodesic_blocks.h"
#include "surfaces/geodesic_graph.h"
#include "surfaces/graph_solver.h"
#include "surfaces/refined_solver.h"

namespace flg {

// Scratch of solvers, lent to one job at a time and used again: fields in steady state take no memory but their own.
template <class Solver>
class SolverPool {
public:
    explicit SolverPool(Memory* memory) : memory_(memory), idle_(memory) {}

    // To be given back when its field is complete. One that was stopped in the midst of a field, by a failure or because its
    // job was cancelled, is in no state to be used again, and freed.
    class Lent {
    public:
        Lent(SolverPool& pool, std::shared_ptr<Solver> solver) : pool_(pool), solver_(std::move(solver)) {}
        Lent(const Lent&) = delete;
        Lent& operator=(const Lent&) = delete;
        ~Lent() {
            if (solver_) pool_.forget();
        }
        void give_back() { pool_.take_back(std::move(solver_)); }
        Solver& operator*() { return *solver_; }
        Solver* operator->() { return solver_.get(); }

    private:
        SolverPool& pool_;
        std::shared_ptr<Solver> solver_;
    };

    // [any thread]
    template <class... Arguments>
    Lent lend(Arguments&&... arguments) {
        std::lock_guard lock(mutex_);
        if (idle_.empty()) {
            idle_.reserve(made_ + 1);  // so that giving back can't fail
            auto solver = std::allocate_shared<Solver>(std::pmr::polymorphic_allocator<Solver>(memory_),
                                                       std::forward<Arguments>(arguments)...);
            ++made_;
            return Lent(*this, std::move(solver));
        }
        std::shared_ptr<Solver> solver = std::move(idle_.back());
        idle_.pop_back();
        return Lent(*this, std::move(solver));
    }

private:
    void take_back(std::shared_ptr<Solver> solver) noexcept {
        std::lock_guard lock(mutex_);
        idle_.push_back(std::move(solver));
    }
    void forget() noexcept {
        std::lock_guard lock(mutex_);
        --made_;
    }

    Memory* memory_;
    std::mutex mutex_;
    std::pmr::vector<std::shared_ptr<Solver>> idle_;
    size_t made_ = 0;
};

// That a job builds something for solvers, and how it ended.
class SolverBuild final : public Product {};

struct GeodesicSolvers {
    explicit GeodesicSolvers(Memory* memory) : refined(memory), graphs(memory) {}

    // Host's thread.
    std::shared_ptr<SolverBuild> blocks_build, graph_build;

    // Jobs, once these are done.
    std::optional<GeodesicBlocks> blocks;
    std::optional<GeodesicGraph> graph;
    // Whether they are there, for any thread: after they were made, a cut in which memory runs out drops them.
    std::atomic<bool> has_blocks{false}, has_graph{false};
    SolverPool<RefinedSolver> refined;
    SolverPool<GraphSolver> graphs;
};

}  // namespace flg
