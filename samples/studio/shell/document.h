// SPDX-License-Identifier: MIT
// Documents on disk: one JSON file, written whole or not at all, and the copy that survives a crash.
#pragma once

#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace flg::studio {

// Whole or not at all (core/saved_file.h). Throws StudioError.
void write_file(const std::string& path, const std::string& bytes);
void write_document(const std::string& path, const nlohmann::json& document);
// Throws StudioError for what is no document of ours.
nlohmann::json read_document(const std::string& path);

// Keeps a copy of a document that has changes which are not saved. One file a process, removed when it ends in good
// order.
class Autosave {
public:
    // Empty folder: off.
    explicit Autosave(std::string folder);
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    // Whether it is time for a copy: `changes` are newer than the last one and it is long enough ago.
    bool due(double seconds, uint64_t changes) const;
    // Whether there will be.
    bool waits(uint64_t changes) const { return !file_.empty() && changes != copied_; }
    // In a thread of its own. Errors come with the next call, as StudioError.
    void write(std::function<nlohmann::json()> document, double seconds, uint64_t changes);
    // What was saved has no need of a copy.
    void forget(uint64_t changes);

    // What such a process left becomes this one's copy.
    void adopt(const std::string& left);

    // Copies that processes left which are no more, the newest first.
    std::vector<std::string> left_behind() const;

private:
    std::string folder_, file_;
    std::future<void> writing_;
    double last_s_ = 0.0;
    uint64_t copied_ = 0;
};

// Where a program of this user keeps what is to survive it: below $XDG_STATE_HOME, else ~/.local/state; empty if there
// is neither.
std::string state_folder();

}  // namespace flg::studio
