// SPDX-License-Identifier: MIT
// Every job that the app starts, by a name that the user understands: progress, cancel, and what follows when it is
// done.
#pragma once

#include <functional>
#include <list>
#include <string>

#include "filigree/filigree.hpp"
#include "shell/notices.h"

namespace flg::studio {

class Jobs {
public:
    explicit Jobs(Notices& notices) : notices_(notices) {}

    // `done` is called once, by update(), in the frame in which the job is finished, whatever its result; it may add
    // jobs. Failures other than a cancelled job, or one that a failed job leads to, also become a notice: "NAME: why".
    // Quiet jobs are not listed: for what takes no longer than a frame or two. Where a failure is told by the caller it
    // becomes no notice.
    enum class Shown { listed, quiet };
    enum class Failure { noticed, told_by_caller };
    using Done = std::function<void(const FlgJobStatus&)>;
    void add(std::string name, filigree::Job job, Done done = {}, Shown shown = Shown::listed,
             Failure failure = Failure::noticed);

    // After each tick.
    void update();
    bool idle() const { return running_.empty(); }
    size_t count() const { return running_.size(); }
    void cancel_all();
    // The list with a bar and a button each, as wide as the panel it is drawn in; nothing while there are no jobs.
    void draw();

private:
    struct Running {
        std::string name;
        filigree::Job job;
        Done done;
        Shown shown;
        Failure failure;
        bool cancelled = false;
    };
    Notices& notices_;
    std::list<Running> running_;
};

}  // namespace flg::studio
