// SPDX-License-Identifier: MIT
// All that the ABI's functions take by descriptor: a scenario of tests/hardening runs with valid input, but for some
// fields that the fuzzer's bytes put in the place of others. Whatever a function then says, it says in words, it is no
// bug of ours (FLG_ERROR_INTERNAL), handles are written on every path, and all memory comes back.
//
// Input: the scenario's number, then up to four edits of eight bytes: call, field, how, unused, four bytes of value.
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <typeindex>
#include <vector>

#include "filigree/filigree_all.h"
#include "fuzz/bounded_memory.h"
#include "hardening/scenarios.h"

namespace {

using namespace flg::test;

constexpr size_t max_bytes = size_t{64} << 20;
constexpr uint32_t max_ticks = 40, tick_us = 2000;
constexpr size_t edit_size = 8, max_edits = 4;

enum class Kind { real, whole, count, handle, pointer };

struct Field {
    uint32_t offset, size;
    Kind kind;
};

const std::map<std::type_index, std::vector<Field>> fields_of = {
#include "descriptor_fields.inl"
};

struct Edit {
    uint8_t call, field, how;
    uint32_t value;
};

double odd_real(const Edit& edit) {
    constexpr double odd[] = {0, -0.0, 1, -1, 1e-30, 1e30, -1e30, 0.5, 1e-3, 1e6, 1e-45, 2e38};
    float raw = 0;
    std::memcpy(&raw, &edit.value, sizeof raw);
    const uint32_t choice = edit.how % (std::size(odd) + 4);
    if (choice < std::size(odd)) return odd[choice];
    if (choice == std::size(odd)) return std::numeric_limits<double>::quiet_NaN();
    if (choice == std::size(odd) + 1) return std::numeric_limits<double>::infinity();
    return double{raw};
}

uint64_t odd_whole(uint64_t was, const Edit& edit) {
    const uint64_t odd[] = {0, 1, was + 1, was - 1, ~uint64_t{0}, 0x7fffffff, edit.value, edit.value % 8};
    return odd[edit.how % std::size(odd)];
}

void change(const Field& field, const Edit& edit, char* fields) {
    char* const place = fields + field.offset;
    uint64_t was = 0;
    std::memcpy(&was, place, field.size);
    switch (field.kind) {
        case Kind::real: {
            const double value = odd_real(edit);
            const auto narrow = static_cast<float>(value);
            std::memcpy(place, field.size == sizeof value ? static_cast<const void*>(&value) : &narrow, field.size);
            break;
        }
        case Kind::whole:
        case Kind::handle: {
            const uint64_t value = odd_whole(was, edit);
            std::memcpy(place, &value, field.size);
            break;
        }
        case Kind::count: {
            const uint64_t value = was == 0 ? 0 : edit.value % (was + 1);
            std::memcpy(place, &value, field.size);
            break;
        }
        case Kind::pointer: std::memset(place, 0, field.size); break;
    }
}

class Edits : public Meddler {
public:
    Edits(const uint8_t* data, size_t size) {
        for (size_t i = 0; i < max_edits && (i + 1) * edit_size <= size; ++i) {
            const uint8_t* const at = data + i * edit_size;
            Edit edit{at[0], at[1], at[2], 0};
            std::memcpy(&edit.value, at + 4, sizeof edit.value);
            edits_.push_back(edit);
        }
    }
    void before(const char*, const std::type_info& descriptor, void* fields) override {
        const auto found = fields_of.find(descriptor);
        const uint32_t call = calls_++;
        if (found == fields_of.end()) return;
        for (const Edit& edit : edits_) {
            if (edit.call != call) continue;
            change(found->second[edit.field % found->second.size()], edit, static_cast<char*>(fields));
        }
    }
    void after(const char* function, FlgResult result) override {
        if (result == FLG_ERROR_INTERNAL) std::fprintf(stderr, "%s: %s\n", function, flgErrorGetMessage());
        FLG_DEMAND(result != FLG_ERROR_INTERNAL);
    }

private:
    std::vector<Edit> edits_;
    uint32_t calls_ = 0;
};

// What a scenario finds amiss in its results is not the question here; what it says of them would hide crashes in
// noise.
struct Silence : testing::EmptyTestEventListener {};

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new Silence);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    if (size == 0) return 0;
    const Scenario& scenario = scenarios[data[0] % std::size(scenarios)];
    flg::fuzz::BoundedMemory memory(max_bytes);
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    desc.allocator = memory.hooks();
    FlgContext context{};
    FLG_DEMAND(flgContextCreate(&desc, &context) == FLG_OK);
    {
        Edits edits(data + 1, size - 1);
        Calls calls(context);
        calls.meddler = &edits;
        calls.contexts = desc;
        calls.tick_budget_us = tick_us;
        calls.allowed = {FLG_NOT_READY,           FLG_ERROR_INVALID_ARGUMENT, FLG_ERROR_INVALID_HANDLE,
                         FLG_ERROR_OUT_OF_MEMORY, FLG_ERROR_VERSION,          FLG_ERROR_CANCELLED,
                         FLG_ERROR_DEPENDENCY,    FLG_ERROR_FORMAT,           FLG_ERROR_LIMIT};
        calls.before_tick = [&] {
            if (calls.ticks > max_ticks) throw Ended();
        };
        try {
            scenario.run(calls);
        } catch (const Ended&) {}
    }
    FLG_DEMAND(flgContextDestroy(context) == FLG_OK);
    return 0;
}
