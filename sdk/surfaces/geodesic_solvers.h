// SPDX-License-Identifier: MIT
// What distances on one surface are computed with: made by the first job that needs it, kept up to date by cuts.
#pragma once

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

    // Given back when it goes out of scope.
    class Lent {
    public:
        Lent(SolverPool& pool, std::shared_ptr<Solver> solver) : pool_(pool), solver_(std::move(solver)) {}
        Lent(const Lent&) = delete;
        Lent& operator=(const Lent&) = delete;
        ~Lent() { pool_.take_back(std::move(solver_)); }
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
        idle_.reserve(++made_);  // so that giving back can't fail
        if (idle_.empty()) {
            return Lent(*this, std::allocate_shared<Solver>(std::pmr::polymorphic_allocator<Solver>(memory_),
                                                            std::forward<Arguments>(arguments)...));
        }
        --made_;
        std::shared_ptr<Solver> solver = std::move(idle_.back());
        idle_.pop_back();
        return Lent(*this, std::move(solver));
    }

private:
    void take_back(std::shared_ptr<Solver> solver) noexcept {
        std::lock_guard lock(mutex_);
        idle_.push_back(std::move(solver));
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
    SolverPool<RefinedSolver> refined;
    SolverPool<GraphSolver> graphs;
};

}  // namespace flg
