// SPDX-License-Identifier: MIT
// What the program is at, on stderr, so that it is never silent for more than two seconds: a thread says it, whatever
// the others do. On a terminal one line that changes, elsewhere a line now and then.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace flg::cli {

class Progress {
public:
    // Says nothing if `quiet`. At most one at a time; say_step and say_share reach it from anywhere.
    Progress(bool quiet, std::string command);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void set(std::string step, double share);
    // Before anything else is written on stderr.
    void clear_line();

private:
    void run();
    void say();

    const bool terminal_;
    const std::chrono::steady_clock::time_point start_;
    std::string step_;
    double share_ = -1.0;  // of the step; below 0: not known
    bool shown_ = false, ended_ = false;
    std::chrono::steady_clock::time_point said_;
    std::mutex mutex_;
    std::condition_variable end_;
    std::thread thread_;
};

// What is done now, such as `reading a.ply`.
void say_step(const std::string& step);
// How far it is, 0 to 1.
void say_share(const std::string& step, double share);
void clear_progress_line();

}  // namespace flg::cli
