// SPDX-License-Identifier: MIT
#include "shell/document.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/saved_file.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

namespace fs = std::filesystem;

constexpr double kCopyEvery_s = 15.0;
constexpr const char* kFormat = "filigree";
constexpr int kVersion = 1;
constexpr const char *kPrefix = "autosave-", *kSuffix = ".filigree";

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw StudioError(path + " cannot be " + what + ": " + std::strerror(errno) + ".");
}

}  // namespace

void write_file(const std::string& path, const std::string& bytes) {
    try {
        SavedFile file(path);
        file.write(bytes);
        file.save();
    } catch (const std::system_error& error) {
        throw StudioError(path + " cannot be written: " + error.code().message() + ".");
    }
}

void write_document(const std::string& path, const nlohmann::json& document) {
    nlohmann::json whole = document;
    whole[kFormat] = kVersion;
    // Names in files need not be UTF-8.
    write_file(path, whole.dump(1, '\t', false, nlohmann::json::error_handler_t::replace));
}

nlohmann::json read_document(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "read");
    nlohmann::json document;
    try {
        document = nlohmann::json::parse(file);
    } catch (const nlohmann::json::exception& error) {
        throw StudioError(path + " is not valid JSON: " + error.what() + ".");
    }
    if (!document.is_object() || !document.contains(kFormat) || !document[kFormat].is_number_integer())
        throw StudioError(path + " is not a Filigree document.");
    if (document[kFormat] != kVersion)
        throw StudioError(path + " has version " + document[kFormat].dump() + "; this program reads version 1.");
    return document;
}

Autosave::Autosave(std::string folder) : folder_(std::move(folder)) {
    if (folder_.empty()) return;
    std::error_code error;
    fs::create_directories(folder_, error);
    file_ = folder_ + "/" + kPrefix + std::to_string(::getpid()) + kSuffix;
}

Autosave::~Autosave() {
    if (writing_.valid()) writing_.wait();
    if (!file_.empty()) ::unlink(file_.c_str());
}

bool Autosave::due(double seconds, uint64_t changes) const {
    if (file_.empty() || changes == copied_ || seconds - last_s_ < kCopyEvery_s) return false;
    return !writing_.valid() || writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void Autosave::write(std::function<nlohmann::json()> document, double seconds, uint64_t changes) {
    last_s_ = seconds;
    copied_ = changes;
    if (writing_.valid()) writing_.get();
    writing_ = std::async(std::launch::async,
                          [file = file_, document = std::move(document)] { write_document(file, document()); });
}

void Autosave::forget(uint64_t changes) {
    copied_ = changes;
    if (writing_.valid()) writing_.wait();
    if (!file_.empty()) ::unlink(file_.c_str());
}

void Autosave::adopt(const std::string& left) {
    if (::rename(left.c_str(), file_.c_str()) != 0) fail(left, "renamed");
}

std::vector<std::string> Autosave::left_behind() const {
    std::vector<fs::directory_entry> found;
    std::error_code error;
    if (folder_.empty()) return {};
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) continue;
        const long process = std::strtol(name.c_str() + std::strlen(kPrefix), nullptr, 10);
        const bool alive = process > 0 && (::kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM);
        if (!alive) found.push_back(entry);
    }
    std::sort(found.begin(), found.end(),
              [&](const auto& a, const auto& b) { return a.last_write_time(error) > b.last_write_time(error); });
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : found) paths.push_back(entry.path().string());
    return paths;
}

std::string state_folder() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && state[0] == '/') return std::string(state) + "/filigree";
    const char* home = std::getenv("HOME");
    if (home != nullptr && home[0] == '/') return std::string(home) + "/.local/state/filigree";
    return {};
}

}  // namespace flg::studio
