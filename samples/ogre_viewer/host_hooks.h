// SPDX-License-Identifier: MIT
// What else a host gives to the SDK: memory that is counted, and OGRE's log.
#pragma once

#include <atomic>
#include <cstddef>

#include "filigree/filigree.h"

namespace viewer {

// All memory of a context. Read it after the context is destroyed: nothing may be left.
class CountingAllocator {
public:
    FlgAllocator hook();

    size_t bytes() const { return bytes_; }  // now
    size_t peak() const { return peak_; }
    size_t calls() const { return calls_; }

private:
    void* allocate(size_t size, size_t alignment);
    void free(void* memory, size_t size, size_t alignment);

    std::atomic<size_t> bytes_ = 0, peak_ = 0, calls_ = 0;
};

// Sentences of the SDK go to Ogre::LogManager.
FlgLog ogre_log();

}  // namespace viewer
