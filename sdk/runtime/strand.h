// SPDX-License-Identifier: MIT
// A strand: one line of execution of a job, a chain of tasks of which the innermost is suspended or running. A job has
// one, and more while it forks. Only one thread runs a strand at a time; it wanders between threads.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "runtime/usual_times.h"

namespace flg {

class StrandHeap;
struct Strand;

struct ReadyQueue {
    Strand *first = nullptr, *last = nullptr;
};

struct Strand {
    Strand(Job& owner, const Host& host, Memory* memory) : job(owner), pace(owner, host, memory) {}

    void start(Task<void> task) {
        root = std::move(task);
        kind = kind_of(root.handle());
        pace.resume_point = root.handle();
    }

    Job& job;
    Pace pace;
    Task<void> root;
    const void* kind = nullptr;  // the same of all tasks of one function
    Fork* member_of = nullptr;   // the fork it is a branch of; null for a job's first strand
    // In a ready queue, if it is in one.
    ReadyQueue* queue = nullptr;
    Strand *next = nullptr, *previous = nullptr;
    // In a heap, if it is in one.
    StrandHeap* heap = nullptr;
    Strand *left = nullptr, *right = nullptr, *above = nullptr;
    uint32_t rank = 0;
    uint64_t latest_ns = 0;  // of its job, when it came in
};

}  // namespace flg
