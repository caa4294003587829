// SPDX-License-Identifier: MIT
// Filigree's tasks on OGRE's worker threads: a request in its work queue each. The SDK starts no thread of its own.
#pragma once

#include <OgreWorkQueue.h>

#include <atomic>

#include "filigree/filigree.h"

namespace viewer {

// Must live until the context that uses it is destroyed, and the queue must run as long.
class JobSystem final : private Ogre::WorkQueue::RequestHandler {
public:
    JobSystem(Ogre::WorkQueue& queue, uint32_t threads);
    ~JobSystem() override;
    JobSystem(const JobSystem&) = delete;
    JobSystem& operator=(const JobSystem&) = delete;

    FlgJobSystem hook();
    // Tasks that OGRE's threads have run.
    size_t tasks() const { return tasks_; }

private:
    Ogre::WorkQueue::Response* handleRequest(const Ogre::WorkQueue::Request* request, const Ogre::WorkQueue*) override;

    Ogre::WorkQueue& queue_;
    Ogre::uint16 channel_;
    uint32_t threads_;
    std::atomic<size_t> tasks_ = 0;
};

}  // namespace viewer
