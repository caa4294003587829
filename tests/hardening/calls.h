// SPDX-License-Identifier: MIT
// Calls of the ABI that watch what comes of them: results, outputs on every path, jobs, bits. What a test lets happen
// to them (memory that runs out, jobs that are cancelled) ends the scenario they are part of; anything else fails the
// test.
#pragma once

#include <deque>
#include <functional>
#include <set>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <vector>

#include "api/surface_inputs.h"
#include "filigree/filigree_debug.h"
#include "hardening/heap.h"

namespace flg::test {

// Thrown where a scenario can't go on, for a reason that the test allows.
struct Ended {};

// The names of all functions that were called so far, by any thread.
std::set<std::string> called_functions();

// Sees each call before and after, and may change the descriptors it is made with.
class Meddler {
public:
    virtual ~Meddler() = default;
    virtual void before(const char* function, const std::type_info& descriptor, void* fields) = 0;
    virtual void after(const char* function, FlgResult result) = 0;
};

// An argument on its way to the SDK.
template <class Parameter>
struct Passed {
    Parameter argument;
    operator Parameter() { return argument; }
};

// Likewise a struct that the SDK fills: it may write no further than the struct's own size.
template <class Struct>
requires requires(Struct& fields) {
    fields.struct_size = 0;
}
class Passed<Struct*> {
public:
    explicit Passed(Struct* host) : host_(host) {
        std::memset(&fenced_, fence, sizeof fenced_);
        if (host) fenced_.fields = *host;
    }
    ~Passed() {
        if (!host_) return;
        *host_ = fenced_.fields;
        for (const unsigned char byte : fenced_.beyond) EXPECT_EQ(byte, fence) << "written beyond " << sizeof(Struct);
    }
    Passed(const Passed&) = delete;
    Passed& operator=(const Passed&) = delete;

    operator Struct*() { return host_ ? &fenced_.fields : nullptr; }

private:
    static constexpr unsigned char fence = 0x5f;

    Struct* const host_;
    struct {
        Struct fields;
        unsigned char beyond[64];
    } fenced_;
};

class Calls {
public:
    explicit Calls(FlgContext on) : context(on) {}
    Calls(const Calls&) = delete;
    Calls& operator=(const Calls&) = delete;

    const FlgContext context;
    std::vector<FlgResult> allowed;                  // failures that may happen
    FlgContextDesc contexts = flgContextDefaults();  // for scenarios that make contexts of their own
    std::function<void()> before_tick;
    Meddler* meddler = nullptr;
    uint32_t tick_budget_us = FLG_UNLIMITED;
    uint32_t ticks = 0;
    bool ended = false;
    std::string bits;                       // of all results
    std::vector<FlgSurface> surfaces;       // that jobs change
    std::vector<std::string> surface_bits;  // theirs, whenever nothing was going on

    // A call, by FLG_CALL.
    template <class... Parameters, class... Arguments>
    void call(const char* name, FlgResult (*function)(Parameters...), Arguments&&... arguments) {
        returned(name, value(name, function, std::forward<Arguments>(arguments)...));
    }
    // Likewise one whose result says something else, by FLG_VALUE.
    template <class Result, class... Parameters, class... Arguments>
    Result value(const char* name, Result (*function)(Parameters...), Arguments&&... arguments) {
        note_call(name);
        if (meddler) (meddle<Parameters>(name, arguments), ...);
        const InsideSdk inside;
        return function(Passed<Parameters>{static_cast<Parameters>(arguments)}...);
    }
    // A descriptor or view with its defaults, by FLG_INIT.
    template <class Struct>
    Struct init(const char* name, FlgResult (*function)(Struct*, uint32_t)) {
        Struct made;
        std::memset(static_cast<void*>(&made), 0xa5, sizeof made);
        call(name, function, &made, static_cast<uint32_t>(sizeof made));
        EXPECT_EQ(made.struct_size, sizeof made) << name;
        return made;
    }

    // All that an object has to draw, by FLG_DRAW: counted, written, noted.
    template <class Handle>
    void draw(const char* name, FlgResult (*function)(FlgContext, Handle, const FlgDebugDrawDesc*, FlgDebugDrawing*),
              Handle handle) {
        FlgDebugDrawDesc desc = init("flgDebugDrawDescInit", flgDebugDrawDescInit);
        FlgDebugDrawing drawing = init("flgDebugDrawingInit", flgDebugDrawingInit);
        desc.parts = 2 * FLG_DEBUG_PART_CLEARANCE - 1;
        call(name, function, context, handle, &desc, &drawing);
        std::vector<FlgDebugVertex> lines(size_t{2} * drawing.line_count), points(drawing.point_count);
        drawing.lines = lines.data();
        drawing.points = points.data();
        drawing.line_capacity = drawing.line_count;
        drawing.point_capacity = drawing.point_count;
        call(name, function, context, handle, &desc, &drawing);
        note(lines.data(), lines.size() * sizeof(FlgDebugVertex));
        note(points.data(), points.size() * sizeof(FlgDebugVertex));
    }

    // Where the next call is to write a handle. It must do so, whatever happens.
    template <class Handle>
    Handle* out(Handle& handle) {
        handle.id = unwritten;
        outs_.push_back(&handle.id);
        return &handle;
    }
    FlgJob* job() { return out(jobs_.emplace_back()); }
    // Runs all jobs to their end; they are to succeed, and are released.
    void finish();
    const std::deque<FlgJob>& jobs() const { return jobs_; }

    void note(const void* data, size_t size) { bits.append(static_cast<const char*>(data), size); }
    void note(FlgCurveSet set);
    void note(FlgField field);
    void note(FlgSurfaceCurves curves);
    // Also as one of the states that the surface may be in.
    void note(FlgSurface surface);

private:
    static constexpr uint64_t unwritten = 0xabadcafeabadcafe;

    static void note_call(const char* name);
    template <class Parameter, class Argument>
    void meddle(const char* name, Argument& argument) {
        using Pointed = std::remove_pointer_t<std::decay_t<Argument>>;
        if constexpr (std::is_same_v<Parameter, const Pointed*> &&
                      requires(Pointed & fields) { fields.struct_size = 0; }) {
            if (argument) meddler->before(name, typeid(Pointed), argument);
        }
    }
    void returned(const char* name, FlgResult result);
    bool allows(FlgResult result) const;
    [[noreturn]] void end();

    std::vector<uint64_t*> outs_;
    std::deque<FlgJob> jobs_;
};

#define FLG_CALL(calls, function, ...) (calls).call(#function, function __VA_OPT__(, ) __VA_ARGS__)
#define FLG_VALUE(calls, function, ...) (calls).value(#function, function __VA_OPT__(, ) __VA_ARGS__)
#define FLG_DRAW(calls, function, handle) (calls).draw(#function, function, handle)
#define FLG_INIT(calls, function) (calls).init(#function, function)

}  // namespace flg::test
