// SPDX-License-Identifier: MIT
#include "job_system.h"

namespace viewer {
namespace {

struct Task {
    void (*run)(void* task);
    void* task;
};

}  // namespace

JobSystem::JobSystem(Ogre::WorkQueue& queue, uint32_t threads)
    : queue_(queue), channel_(queue.getChannel("Filigree")), threads_(threads) {
    queue_.addRequestHandler(channel_, this);
}

JobSystem::~JobSystem() {
    queue_.removeRequestHandler(channel_, this);
}

// The queue locks what it shares: any thread may add requests, those that run tasks too.
FlgJobSystem JobSystem::hook() {
    FlgJobSystem hook = flgJobSystemDefaults();
    hook.user_data = this;
    hook.concurrency = threads_;
    hook.submit = [](void* self, void (*run)(void*), void* task) {
        auto& system = *static_cast<JobSystem*>(self);
        system.queue_.addRequest(system.channel_, 0, Ogre::Any(Task{run, task}));
    };
    return hook;
}

// On a worker thread. The response says no more than that the request was seen to: results come by flgContextTick.
Ogre::WorkQueue::Response* JobSystem::handleRequest(const Ogre::WorkQueue::Request* request, const Ogre::WorkQueue*) {
    const Task task = Ogre::any_cast<Task>(request->getData());
    task.run(task.task);
    ++tasks_;
    return OGRE_NEW Ogre::WorkQueue::Response(request, true, Ogre::Any());
}

}  // namespace viewer
