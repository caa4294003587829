// SPDX-License-Identifier: MIT
// What a job makes and the host holds a handle to: not ready until its job is published, then good or failed for ever.
#pragma once

#include <cstdio>

#include "runtime/job.h"

namespace flg {

class Product : public Output {
public:
    // The job that makes it, if there is one that may not be done.
    std::weak_ptr<Job> producer;

    // Host's thread: FLG_NOT_READY until something can be seen, the job's error if it failed.
    FlgResult visible_result() const { return result_; }
    const char* error() const { return error_; }

    void publish_partial() noexcept override {}
    void publish(const Job& job) noexcept override {
        result_ = job.result;
        if (result_ == FLG_OK) {
            show();
        } else {
            std::snprintf(error_, sizeof error_, "%s", job.error);
        }
    }
    // For products made in one go on the host's thread.
    void publish_complete() noexcept {
        result_ = FLG_OK;
        show();
    }

protected:
    // Puts what is complete where the host sees it.
    virtual void show() noexcept {}
    // Something can be seen before the job is done.
    void show_early() noexcept { result_ = FLG_OK; }

private:
    FlgResult result_ = FLG_NOT_READY;
    char error_[256] = "";
};

}  // namespace flg
