// SPDX-License-Identifier: MIT
#include "runtime/context_memory.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "core/failure.h"
#include "core/sized_struct.h"

namespace flg {

// What the blocks that one job took have in common. Lives until the job has ended and the last of them is freed.
struct JobAccount {
    static constexpr uint64_t settled = uint64_t{1} << 63;

    explicit JobAccount(ContextMemory& owner) : memory(owner) {}

    ContextMemory::Counter& counter(uint64_t seen) {
        return memory.counter((seen & settled) != 0 ? result : MemoryKind::scratch);
    }

    ContextMemory& memory;
    MemoryKind result = MemoryKind::scratch;
    // The bytes of its blocks, one more until the job has ended, and the bit above. All in one word, so that a block
    // freed by another thread while the job ends is counted off where it was counted then.
    std::atomic<uint64_t> state{1};
};

namespace {

using Tag = uintptr_t;  // a kind, or an account's address, which is above all kinds

size_t tag_offset(size_t size) {
    return (size + alignof(Tag) - 1) / alignof(Tag) * alignof(Tag);
}

// Of the job whose slice this thread runs.
constinit thread_local JobAccount* running_account = nullptr;

}  // namespace

ContextMemory::ContextMemory(const HostMemory& host, uint64_t limit, size_t own_size)
    : host_(host), limit_(limit), kinds_{Kind(*this, MemoryKind::styles), Kind(*this, MemoryKind::surfaces),
                                         Kind(*this, MemoryKind::curves), Kind(*this, MemoryKind::models),
                                         Kind(*this, MemoryKind::caches), Kind(*this, MemoryKind::scratch),
                                         Kind(*this, MemoryKind::runtime)} {
    reserve(own_size);
    total_.raise_peak(own_size);
    counter(MemoryKind::runtime).add(own_size);
}

FlgContextMemory ContextMemory::use() const {
    auto out = sized<FlgContextMemory>();
    FlgMemoryUse* const uses[kind_count] = {&out.styles, &out.surfaces, &out.curves, &out.models,
                                            &out.caches, &out.scratch,  &out.runtime};
    out.total = total_.use();
    out.total.bytes = 0;
    for (size_t k = 0; k < kind_count; ++k) {
        *uses[k] = counters_[k].use();
        out.total.bytes += uses[k]->bytes;
    }
    return out;
}

// Room for so many bytes more, or an exception.
void ContextMemory::reserve(size_t size) {
    if (limit_ == 0) {
        total_.bytes.fetch_add(size, std::memory_order_relaxed);
        return;
    }
    uint64_t held = total_.bytes.load(std::memory_order_relaxed);
    do {
        if (size > limit_ - held) throw MemoryLimitReached(limit_, held, size);
    } while (!total_.bytes.compare_exchange_weak(held, held + size, std::memory_order_relaxed));
}

void* ContextMemory::take(MemoryKind kind, size_t size, size_t alignment) {
    const size_t tag_at = tag_offset(size);
    const size_t whole = tag_at + sizeof(Tag);
    reserve(whole);
    std::byte* block;
    try {
        block = static_cast<std::byte*>(host_.allocate(whole, std::max(alignment, alignof(Tag))));
    } catch (...) {
        total_.subtract(whole);
        throw;
    }
    total_.raise_peak(total_.bytes.load(std::memory_order_relaxed));
    auto tag = static_cast<Tag>(kind);
    JobAccount* const account = kind == MemoryKind::scratch ? running_account : nullptr;
    if (account && &account->memory == this) {
        tag = reinterpret_cast<Tag>(account);
        account->counter(account->state.fetch_add(whole, std::memory_order_relaxed)).add(whole);
    } else {
        counter(kind).add(whole);
    }
    std::memcpy(block + tag_at, &tag, sizeof tag);
    return block;
}

void ContextMemory::give_back(void* block, size_t size, size_t alignment) noexcept {
    const size_t tag_at = tag_offset(size);
    const size_t whole = tag_at + sizeof(Tag);
    Tag tag;
    JobAccount* address;  // if the tag is one
    static_assert(sizeof(Tag) == sizeof(void*));
    std::memcpy(&tag, static_cast<std::byte*>(block) + tag_at, sizeof tag);
    std::memcpy(&address, static_cast<std::byte*>(block) + tag_at, sizeof tag);
    host_.deallocate(block, whole, std::max(alignment, alignof(Tag)));
    total_.subtract(whole);
    if (tag < kind_count) {
        counter(static_cast<MemoryKind>(tag)).subtract(whole);
    } else {
        JobAccount& account = *address;
        const uint64_t before = account.state.fetch_sub(whole, std::memory_order_acq_rel);
        account.counter(before).subtract(whole);
        if ((before & ~JobAccount::settled) == whole) close(account);
    }
}

void ContextMemory::close(JobAccount& account) noexcept {
    std::destroy_at(&account);
    kinds_[static_cast<size_t>(MemoryKind::runtime)].deallocate(&account, sizeof account, alignof(JobAccount));
}

void JobMemory::open(ContextMemory& memory) {
    void* const place = memory[MemoryKind::runtime]->allocate(sizeof(JobAccount), alignof(JobAccount));
    account_ = new (place) JobAccount(memory);
}

void JobMemory::set_result(MemoryKind kind) {
    if (account_) account_->result = kind;
}

void JobMemory::settle() noexcept {
    JobAccount* const account = std::exchange(account_, nullptr);
    if (!account) return;
    ContextMemory& memory = account->memory;
    const uint64_t kept = account->state.fetch_or(JobAccount::settled, std::memory_order_acq_rel) - 1;
    memory.counter(account->result).add(kept);
    memory.counter(MemoryKind::scratch).subtract(kept);
    if (account->state.fetch_sub(1, std::memory_order_acq_rel) == (JobAccount::settled | 1)) memory.close(*account);
}

JobMemory::Slice::Slice(const JobMemory& job) noexcept : before_(std::exchange(running_account, job.account_)) {}

JobMemory::Slice::~Slice() {
    running_account = before_;
}

}  // namespace flg
