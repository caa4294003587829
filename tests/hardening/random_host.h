// SPDX-License-Identifier: MIT
// A host that calls anything at any time with anything: handles that live, are stale, of another kind, null or made up;
// numbers that make sense and such that don't. Whatever it does must end with a documented result.
#pragma once

#include <map>
#include <random>

#include "filigree/filigree_live.h"
#include "filigree/filigree_model.h"
#include "filigree/filigree_motion.h"
#include "filigree/filigree_project.h"
#include "filigree/filigree_tangle.h"
#include "hardening/ledger.h"
#include "hardening/scenarios.h"

namespace flg::test {

class RandomHost {
public:
    RandomHost(uint64_t seed, uint32_t workers);
    ~RandomHost();
    RandomHost(const RandomHost&) = delete;
    RandomHost& operator=(const RandomHost&) = delete;

    // One call more.
    void step();
    // Of curves that nobody else knows, whatever else goes on: these bits.
    std::string quiet_bits();

    FlgContext context{};
    std::map<FlgResult, uint32_t> results;  // of calls and jobs, to see that all sorts of things happen

private:
    // Kinds of handles, as the pool has them.
    enum Kind {
        job,
        curve_set,
        style,
        live_stroke,
        surface,
        field,
        surface_curves,
        tangle,
        manifold,
        spline,
        obstacles,
        motion,
        skeleton,
        outline,
        part,
        part_mesh,
        model,
        skin,
        kind_count
    };
    // What a call is to write, checked after it.
    struct Output {
        uint64_t id;
        Kind kind;
    };

    uint32_t draw(uint32_t count) { return static_cast<uint32_t>(random_() % count); }
    bool chance(uint32_t one_in) { return draw(one_in) == 0; }
    // Mostly between low and high, seldom none of the kind.
    template <class Number = float>
    Number number(double low, double high) {
        static constexpr double odd[] = {0.0, -1.0, 1e30, -1e30, NAN, INFINITY, -INFINITY, 1e-30};
        if (chance(40)) return static_cast<Number>(odd[draw(std::is_floating_point_v<Number> ? 7 : 1)]);
        return static_cast<Number>(low + (high - low) * draw(1000) / 1000);
    }
    template <class Enum>
    Enum choice(uint32_t count) {
        const uint32_t value = chance(60) ? 1000 : draw(count);
        Enum made;
        std::memcpy(&made, &value, sizeof made);
        return made;
    }
    // Now and then null.
    template <class T>
    T* maybe(T* pointer) {
        return chance(60) ? nullptr : pointer;
    }
    // Now and then of a wrong size, or with odd options.
    template <class Desc>
    void odd(Desc& desc) {
        if (chance(60)) desc.struct_size = draw(2) == 0 ? draw(16) : static_cast<uint32_t>(sizeof desc) - 4;
        if constexpr (requires { desc.job; }) desc.job = maybe(options());
    }
    // Valid until asked for again.
    const FlgJobOptions* options();
    // Any handle for an argument of this kind.
    template <class Handle>
    Handle any(Kind kind) {
        if (chance(40)) return {random_()};
        if (chance(40)) return {0};
        const std::vector<uint64_t>& pool = pools_[chance(40) ? static_cast<Kind>(draw(kind_count)) : kind];
        // Mostly a recent one: of those that were made long ago most are released.
        const auto size = static_cast<uint32_t>(pool.size());
        return {pool.empty() ? 0 : pool[size - 1 - draw(chance(10) ? size : std::min(size, 4u))]};
    }
    // Where a call writes a handle of this kind; seldom nowhere.
    template <class Handle>
    Handle* out(Kind kind) {
        static_assert(sizeof(Handle) == sizeof(uint64_t));
        if (chance(80)) return nullptr;
        outputs_.push_back({~uint64_t{0}, kind});
        return reinterpret_cast<Handle*>(&outputs_.back().id);
    }
    FlgJob* job_out() { return chance(3) ? nullptr : out<FlgJob>(job); }
    // What has come of a call.
    void returned(FlgResult result);
    // A released or stale handle stays in the pool: it may be used again, and must be refused.
    template <class Handle>
    void release(FlgResult (*function)(FlgContext, Handle), Kind kind) {
        returned(function(at(), any<Handle>(kind)));
    }
    FlgContext at() { return chance(200) ? FlgContext{} : context; }

    void tick();
    void ask_jobs();
    void release_any();
    void make_curves();
    void resample();
    void simplify();
    void make_style();
    void keep_style();
    void stylize();
    void draw_live();
    void end_live();
    void make_surface();
    void change_surface();
    void measure();
    void trace();
    void cut();
    void divide_tangle();
    void edit_tangle();
    void replay_tangle();
    void make_manifold();
    void fit_spline();
    void make_obstacles();
    void move_body();
    void sketch();
    void make_model();
    void look();

    std::mt19937_64 random_;
    Ledger ledger_;
    std::vector<uint64_t> pools_[kind_count];
    std::deque<Output> outputs_;
    FlgCurveSet quiet_{};
};

}  // namespace flg::test
