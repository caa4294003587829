// SPDX-License-Identifier: MIT
// A context that is ticked until its jobs are done, as a host would tick it every frame.
#pragma once

#include <span>
#include <string>

#include "documents/common.h"
#include "documents/report.h"
#include "filigree/filigree.h"

namespace flg::cli {

class Session {
public:
    // The hooks must outlive it.
    explicit Session(const CommonOptions& common, const FlgAllocator& allocator = flgAllocatorDefaults());
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    FlgContext context() const { return context_; }

    // A job to wait for, and what its errors are about (a file).
    struct Pending {
        FlgJob job;
        std::string subject;
    };
    // Ticks until all are finished; throws InputError with the sentence of the first that failed. Adds their stages to
    // the report.
    void finish(std::span<const Pending> jobs, Report& report);

private:
    void say_progress(std::span<const Pending> jobs) const;

    const CommonOptions& common_;
    FlgContext context_{};
    TickTimes times_;
};

}  // namespace flg::cli
