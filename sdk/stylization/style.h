// SPDX-License-Identifier: MIT
// A prepared style: what Algorithm 1 computes before it sees a target. Shared by all threads once prepared.
#pragma once

#include <cstdio>
#include <memory>

#include "core/memory.h"
#include "core/vec.h"
#include "runtime/job.h"

namespace flg {

class Style final : public Output {
public:
    explicit Style(Memory* memory) : memory_(memory) {}

    void publish_partial() noexcept override {}
    void publish(const Job& job) noexcept override {
        result_ = job.result;
        std::snprintf(error_, sizeof error_, "%s", job.error);
    }
    FlgResult visible_result() const { return result_; }
    const char* error() const { return error_; }
    std::weak_ptr<Job> producer;

private:
    Memory* memory_;
    FlgResult result_ = FLG_NOT_READY;
    char error_[256] = "";
};

}  // namespace flg
