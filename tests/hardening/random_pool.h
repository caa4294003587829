// SPDX-License-Identifier: MIT
// The worst job system that keeps the rules: runs tasks in any order, on any of its threads, after any delay.
#pragma once

#include <condition_variable>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "filigree/filigree.h"
#include "hardening/heap.h"

namespace flg::test {

class RandomPool {
public:
    RandomPool(uint32_t threads, uint64_t seed) : random_(seed) {
        for (uint32_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }
    ~RandomPool() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    RandomPool(const RandomPool&) = delete;
    RandomPool& operator=(const RandomPool&) = delete;

    // Valid until asked for again.
    const FlgJobSystem* hook(uint32_t concurrency) {
        hook_ = {sizeof hook_, concurrency, this, [](void* self, void (*run)(void*), void* task) {
                     const OutsideSdk outside;
                     auto& pool = *static_cast<RandomPool*>(self);
                     {
                         const std::lock_guard lock(pool.mutex_);
                         pool.tasks_.push_back({run, task});
                     }
                     pool.wake_.notify_one();
                 }};
        return &hook_;
    }
    std::vector<std::thread::id> ids() const {
        std::vector<std::thread::id> ids;
        for (const std::thread& thread : threads_) ids.push_back(thread.get_id());
        return ids;
    }

private:
    FlgJobSystem hook_{};
    struct Task {
        void (*run)(void*);
        void* task;
    };
    void work() {
        for (;;) {
            Task next{};
            uint64_t delay = 0;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [this] { return stop_ || !tasks_.empty(); });
                if (tasks_.empty()) return;
                const size_t at = random_() % tasks_.size();
                next = tasks_[at];
                tasks_.erase(tasks_.begin() + static_cast<ptrdiff_t>(at));
                delay = random_() % 8;
            }
            if (delay == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
            if (delay == 1) std::this_thread::yield();
            next.run(next.task);
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<Task> tasks_;
    std::mt19937_64 random_;
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace flg::test
