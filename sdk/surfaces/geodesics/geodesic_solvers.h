// SPDX-License-Identifier: MIT
// What distances on one surface are computed with: made by the first job that needs it, kept up to date by cuts.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "runtime/product.h"
#include "surfaces/geodesics/geodesic_blocks.h"
#include "surfaces/geodesics/refined_solver.h"

namespace flg {

// Solvers, which are scratch memory, lent to one job at a time and used again: fields in steady state take no memory
// but their own.
class SolverPool {
public:
    explicit SolverPool(Memory* memory) : memory_(memory), idle_(memory) {}

    // To be given back when its field is complete. One that was stopped in the midst of a field, by a failure or
    // because its job was cancelled, is in no state to be used again, and freed.
    class Lent {
    public:
        Lent(SolverPool& pool, std::shared_ptr<RefinedSolver> solver) : pool_(pool), solver_(std::move(solver)) {}
        Lent(const Lent&) = delete;
        Lent& operator=(const Lent&) = delete;
        ~Lent() {
            if (solver_) pool_.forget();
        }
        void give_back() { pool_.take_back(std::move(solver_)); }
        RefinedSolver& operator*() { return *solver_; }
        RefinedSolver* operator->() { return solver_.get(); }

    private:
        SolverPool& pool_;
        std::shared_ptr<RefinedSolver> solver_;
    };

    // [any thread]
    Lent lend(const GeodesicBlocks& blocks) {
        std::lock_guard lock(mutex_);
        if (idle_.empty()) {
            idle_.reserve(made_ + 1);  // so that giving back can't fail
            auto solver = std::allocate_shared<RefinedSolver>(std::pmr::polymorphic_allocator<RefinedSolver>(memory_),
                                                              blocks, memory_);
            ++made_;
            return Lent(*this, std::move(solver));
        }
        std::shared_ptr<RefinedSolver> solver = std::move(idle_.back());
        idle_.pop_back();
        return Lent(*this, std::move(solver));
    }

private:
    void take_back(std::shared_ptr<RefinedSolver> solver) noexcept {
        std::lock_guard lock(mutex_);
        idle_.push_back(std::move(solver));
    }
    void forget() noexcept {
        std::lock_guard lock(mutex_);
        --made_;
    }

    Memory* memory_;
    std::mutex mutex_;
    std::pmr::vector<std::shared_ptr<RefinedSolver>> idle_;
    size_t made_ = 0;
};

// That a job builds something for solvers, and how it ended.
class SolverBuild final : public Product {};

struct GeodesicSolvers {
    explicit GeodesicSolvers(Memory* memory) : pool(memory) {}

    // Host's thread.
    std::shared_ptr<SolverBuild> blocks_build;

    // Jobs, once that is done.
    std::optional<GeodesicBlocks> blocks;
    // Whether they are there, for any thread: after they were made, a cut in which memory runs out drops them.
    std::atomic<bool> has_blocks{false};
    float fixed_edge = 0;  // metres: the blocks' mean edge, as EdgeScale::fix_mean has it; 0: their own
    SolverPool pool;
};

}  // namespace flg
