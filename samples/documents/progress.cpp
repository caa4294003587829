// SPDX-License-Identifier: MIT
#include "documents/progress.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <utility>

namespace flg::cli {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kLines = 1800ms;                  // from one line to the next in a log
constexpr auto kFirst = 500ms, kRedraw = 100ms;  // on a terminal

std::atomic<Progress*> current = nullptr;

}  // namespace

Progress::Progress(bool quiet, std::string command)
    : terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), step_(std::move(command)), said_(start_) {
    if (quiet) return;
    thread_ = std::thread([this] { run(); });
    current = this;
}

Progress::~Progress() {
    if (!thread_.joinable()) return;
    current = nullptr;
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    end_.notify_one();
    thread_.join();
    clear_line();
}

void Progress::set(std::string step, double share) {
    const std::lock_guard lock(mutex_);
    step_ = std::move(step);
    share_ = share;
}

void Progress::clear_line() {
    const std::lock_guard lock(mutex_);
    if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
    shown_ = false;
}

void Progress::run() {
    std::unique_lock lock(mutex_);
    while (!ended_) {
        end_.wait_for(lock, kRedraw);
        const auto now = Clock::now();
        const bool due = terminal_ ? now - start_ >= kFirst : now - said_ >= kLines;
        if (!ended_ && due) say();
    }
}

void Progress::say() {
    said_ = Clock::now();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(said_ - start_).count();
    char share[16] = "";
    if (share_ >= 0.0) std::snprintf(share, sizeof share, " %.0f %%", 100.0 * share_);
    std::fprintf(stderr, terminal_ ? "\r\033[Kfiligree: %lld s: %s%s" : "filigree: %lld s: %s%s\n",
                 static_cast<long long>(seconds), step_.c_str(), share);
    std::fflush(stderr);
    shown_ = true;
}

void say_step(const std::string& step) {
    if (Progress* progress = current) progress->set(step, -1.0);
}

void say_share(const std::string& step, double share) {
    if (Progress* progress = current) progress->set(step, share);
}

void clear_progress_line() {
    if (Progress* progress = current) progress->clear_line();
}

}  // namespace flg::cli
