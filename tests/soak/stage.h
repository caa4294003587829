// SPDX-License-Identifier: MIT
// What the abilities of the soak play on: one context whose memory is counted, jobs that are followed to their end and
// cancelled at random, and a list of what went wrong.
#pragma once

#include <atomic>
#include <random>
#include <string>
#include <vector>

#include "filigree/filigree.h"

namespace flg::soak {

class Stage {
public:
    explicit Stage(uint64_t seed);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    FlgContext context{};
    std::atomic<int64_t> live_bytes{0};
    std::atomic<int64_t> max_live_bytes{0};  // since it was set last
    uint64_t jobs_finished = 0, jobs_cancelled = 0;
    std::vector<std::string> errors;

    // Anything but FLG_OK is an error; says whether it was.
    bool must(FlgResult result, const char* what);
    // Whether a job is no longer under way; null ones are not. Then it is released, and `out_made` says whether it
    // succeeded.
    bool done(FlgJob& job, bool* out_made);
    // Now and then.
    void cancel_at_random(FlgJob job);
    uint32_t draw(uint32_t count) { return static_cast<uint32_t>(random_() % count); }
    double share() { return static_cast<double>(draw(10000)) / 10000; }

private:
    std::mt19937_64 random_;
};

// Something that the SDK can do, done again and again.
class Ability {
public:
    explicit Ability(Stage& on) : stage(on) {}
    virtual ~Ability() = default;
    Ability(const Ability&) = delete;
    Ability& operator=(const Ability&) = delete;

    virtual void frame() = 0;
    // Starts nothing more. Once nothing is under way it gives back all that it does not keep for good, and says so.
    virtual bool rest() = 0;

protected:
    Stage& stage;
};

}  // namespace flg::soak
