// SPDX-License-Identifier: MIT
#include "host_hooks.h"

#include <OgreLogManager.h>

#include <new>

namespace viewer {

FlgAllocator CountingAllocator::hook() {
    FlgAllocator hook = flgAllocatorDefaults();
    hook.user_data = this;
    hook.allocate = [](void* self, size_t size, size_t alignment) {
        return static_cast<CountingAllocator*>(self)->allocate(size, alignment);
    };
    hook.free = [](void* self, void* memory, size_t size, size_t alignment) {
        static_cast<CountingAllocator*>(self)->free(memory, size, alignment);
    };
    return hook;
}

// From any thread. Null if there is no memory: what needed it then fails with FLG_ERROR_OUT_OF_MEMORY.
void* CountingAllocator::allocate(size_t size, size_t alignment) {
    void* const memory = ::operator new (size, std::align_val_t{alignment}, std::nothrow);
    if (!memory) return nullptr;
    ++calls_;
    const size_t now = bytes_ += size;
    for (size_t peak = peak_; now > peak && !peak_.compare_exchange_weak(peak, now);) {}
    return memory;
}

void CountingAllocator::free(void* memory, size_t size, size_t alignment) {
    bytes_ -= size;
    ::operator delete (memory, std::align_val_t{alignment});
}

FlgLog ogre_log() {
    FlgLog hook = flgLogDefaults();
    hook.write = [](void*, FlgLogLevel level, const char* message) {
        constexpr Ogre::LogMessageLevel kLevels[] = {Ogre::LML_NORMAL, Ogre::LML_WARNING, Ogre::LML_CRITICAL};
        Ogre::LogManager::getSingleton().logMessage(Ogre::String("Filigree: ") + message, kLevels[level]);
    };
    return hook;
}

}  // namespace viewer
