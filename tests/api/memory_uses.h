// SPDX-License-Identifier: MIT
// What a context holds of every kind, at once.
#pragma once

#include <gtest/gtest.h>

#include "filigree/filigree.h"

namespace flg::test {

struct MemoryUses {
    // `get`: the use of a kind.
    template <class Get>
    explicit MemoryUses(const Get& get)
        : styles(get(FLG_MEMORY_KIND_STYLES)),
          surfaces(get(FLG_MEMORY_KIND_SURFACES)),
          curves(get(FLG_MEMORY_KIND_CURVES)),
          models(get(FLG_MEMORY_KIND_MODELS)),
          caches(get(FLG_MEMORY_KIND_CACHES)),
          scratch(get(FLG_MEMORY_KIND_SCRATCH)),
          runtime(get(FLG_MEMORY_KIND_RUNTIME)),
          total(get(FLG_MEMORY_KIND_TOTAL)) {}

    uint64_t sum() const {
        return styles.bytes + surfaces.bytes + curves.bytes + models.bytes + caches.bytes + scratch.bytes +
               runtime.bytes;
    }

    FlgMemoryUse styles, surfaces, curves, models, caches, scratch, runtime, total;
};

inline MemoryUses memory_uses(FlgContext context) {
    return MemoryUses([&](FlgMemoryKind kind) {
        FlgMemoryUse use = flgMemoryUseDefaults();
        EXPECT_EQ(flgContextGetMemory(context, kind, &use), FLG_OK) << flgErrorGetMessage();
        return use;
    });
}

}  // namespace flg::test
