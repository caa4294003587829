// SPDX-License-Identifier: MIT
#include "runtime/context_memory.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

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

constexpr const char* total_limit = "memory_limit";
// By kind.
constexpr const char* limit_names[] = {"the limit of styles",     "the limit of surfaces", "the limit of curves",
                                       "the limit of models",     "the limit of caches",   "the limit of scratch",
                                       "the limit of the runtime"};

// The address sanitizer knows the ends of what `new` returns, not those of pages.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool finds_overflows = true;
#elif defined(__has_feature)
constexpr bool finds_overflows = __has_feature(address_sanitizer);
#else
constexpr bool finds_overflows = false;
#endif

// Of the job whose slice this thread runs.
constinit thread_local JobAccount* running_account = nullptr;

}  // namespace

void ContextMemory::Counter::reserve(uint64_t size, const char* limit_name) {
    uint64_t held = bytes.load(std::memory_order_relaxed);
    do {
        const uint64_t most = limit.load(std::memory_order_relaxed);
        if (most != 0 && (held > most || size > most - held)) throw MemoryLimitReached(limit_name, most, held, size);
    } while (!bytes.compare_exchange_weak(held, held + size, std::memory_order_relaxed));
}

ContextMemory::ContextMemory(const HostMemory& host, uint64_t limit, size_t own_size)
    : host_(host), kinds_{Kind(*this, MemoryKind::styles), Kind(*this, MemoryKind::surfaces),
                          Kind(*this, MemoryKind::curves), Kind(*this, MemoryKind::models),
                          Kind(*this, MemoryKind::caches), Kind(*this, MemoryKind::scratch),
                          Kind(*this, MemoryKind::runtime)} {
    total_.limit = limit;
    total_.reserve(own_size, total_limit);
    total_.raise_peak(own_size);
    counter(MemoryKind::runtime).add(own_size);
}

FlgMemoryUse ContextMemory::use(FlgMemoryKind kind) const {
    const bool is_total = kind == FLG_MEMORY_KIND_TOTAL;
    const Counter& counter = is_total ? total_ : counters_[static_cast<size_t>(kind) - 1];
    auto out = sized<FlgMemoryUse>();
    out.peak_bytes = counter.peak.load(std::memory_order_relaxed);
    out.limit = counter.limit.load(std::memory_order_relaxed);
    if (!is_total) out.bytes = counter.bytes.load(std::memory_order_relaxed);
    for (size_t k = 0; is_total && k < kind_count; ++k) out.bytes += counters_[k].bytes.load(std::memory_order_relaxed);
    return out;
}

void ContextMemory::set_limit(FlgMemoryKind kind, uint64_t limit) noexcept {
    Counter& counter = kind == FLG_MEMORY_KIND_TOTAL ? total_ : counters_[static_cast<size_t>(kind) - 1];
    counter.limit.store(limit, std::memory_order_relaxed);
}

bool ContextMemory::is_large(size_t size, size_t alignment) const {
    constexpr size_t page = 4096;
    return !finds_overflows && !host_.is_hooked() && size >= LargeBlocks::least && alignment <= page;
}

void* ContextMemory::take_block(size_t size, size_t alignment) {
    return is_large(size, alignment) ? large_blocks_.take(size) : host_.allocate(size, alignment);
}

void ContextMemory::give_back_block(void* block, size_t size, size_t alignment) noexcept {
    if (is_large(size, alignment)) {
        large_blocks_.give_back(block, size);
    } else {
        host_.deallocate(block, size, alignment);
    }
}

void* ContextMemory::take(MemoryKind kind, size_t size, size_t alignment) {
    const size_t tag_at = tag_offset(size);
    const size_t whole = tag_at + sizeof(Tag);
    Counter& kind_counter = counter(kind);
    kind_counter.reserve(whole, limit_names[static_cast<size_t>(kind)]);
    std::byte* block;
    try {
        total_.reserve(whole, total_limit);
        try {
            block = static_cast<std::byte*>(take_block(whole, std::max(alignment, alignof(Tag))));
        } catch (...) {
            total_.subtract(whole);
            throw;
        }
    } catch (...) {
        kind_counter.subtract(whole);
        throw;
    }
    total_.raise_peak(total_.bytes.load(std::memory_order_relaxed));
    kind_counter.raise_peak(kind_counter.bytes.load(std::memory_order_relaxed));
    auto tag = static_cast<Tag>(kind);
    // A job that has a slice has not settled: its account stands in the scratch.
    JobAccount* const account = kind == MemoryKind::scratch ? running_account : nullptr;
    if (account && &account->memory == this) {
        tag = reinterpret_cast<Tag>(account);
        account->state.fetch_add(whole, std::memory_order_relaxed);
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
    give_back_block(block, whole, std::max(alignment, alignof(Tag)));
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

std::optional<MemoryLimitReached> JobMemory::settle() noexcept {
    std::optional<MemoryLimitReached> reached;
    JobAccount* const account = std::exchange(account_, nullptr);
    if (!account) return reached;
    ContextMemory& memory = account->memory;
    const uint64_t kept = account->state.fetch_or(JobAccount::settled, std::memory_order_acq_rel) - 1;
    ContextMemory::Counter& result = memory.counter(account->result);
    try {
        result.reserve(kept, limit_names[static_cast<size_t>(account->result)]);
    } catch (const MemoryLimitReached& caught) {
        reached = caught;
        result.bytes.fetch_add(kept, std::memory_order_relaxed);  // until the failed job's result is freed
    }
    result.raise_peak(result.bytes.load(std::memory_order_relaxed));
    memory.counter(MemoryKind::scratch).subtract(kept);
    if (account->state.fetch_sub(1, std::memory_order_acq_rel) == (JobAccount::settled | 1)) memory.close(*account);
    return reached;
}

JobMemory::Slice::Slice(const JobMemory& job) noexcept : before_(std::exchange(running_account, job.account_)) {}

JobMemory::Slice::~Slice() {
    running_account = before_;
}

}  // namespace flg
