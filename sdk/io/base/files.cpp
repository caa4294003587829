// SPDX-License-Identifier: MIT
// The operating system's part is the C++ runtime's: it takes a little memory of its own for names and buffers.
#include "io/base/files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include "core/saved_file.h"
#include "io/base/failure.h"

namespace flg::io {

namespace {

#ifdef _WIN32
constexpr std::string_view os_separators = "/\\";
#else
constexpr std::string_view os_separators = "/";
#endif

std::filesystem::path os_path(const Path& path) {
    return std::u8string_view(reinterpret_cast<const char8_t*>(path.name().data()), path.name().size());
}

Path with_name(const Path& path, const std::filesystem::path& name) {
    const std::u8string text = name.u8string();
    return {String(reinterpret_cast<const char*>(text.data()), text.size()), path.host()};
}

// The part of a name that is its folder, with the separator.
std::string_view folder_of(const Path& path) {
    const std::string_view name = path.name();
    const size_t last = name.find_last_of(path.host() ? "/" : os_separators);
    return name.substr(0, last == name.npos ? 0 : last + 1);
}

}  // namespace

Path::Path(String name, const FlgFileSystem* host) : name_(std::move(name)), host_(host) {
    // Of a folder's name, not of the root's.
    while (name_.size() > 1 && folder_of(*this).size() == name_.size()) name_.pop_back();
}

std::string_view Path::filename() const {
    return std::string_view(name_).substr(folder_of(*this).size());
}

String Path::extension() const {
    const std::string_view file = filename();
    const size_t dot = file.find_last_of('.');
    String extension(dot == file.npos || dot == 0 || file == ".." ? "" : file.substr(dot));
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

Path Path::beside(std::string_view file) const {
    return {String(folder_of(*this)).append(file), host_};
}

Path Path::within(std::string_view file) const {
    return {(name_ + "/").append(file), host_};
}

namespace {

void check_size(uint64_t size, uint64_t limit, const String& place) {
    if (size <= limit) return;
    fail(FLG_ERROR_LIMIT, place, "has %llu bytes, more than the limit of %s", static_cast<unsigned long long>(size),
         size_text(limit).c_str());
}

// Fails with what the host's function `name` returned, unless that is FLG_OK.
void check_host(FlgResult result, const String& place, const char* can_not, const char* name) {
    if (result == FLG_OK) return;
    fail(result < 0 ? result : FLG_ERROR_FILE, place, "can't be %s: the host's %s returned %d", can_not, name,
         static_cast<int>(result));
}

// A file that the host's functions open; discarded, unless it is closed before.
class HostHandle {
public:
    explicit HostHandle(const Path& path) : files_(*path.host()), name_(path.name().c_str()) {}
    ~HostHandle() {
        if (is_open_) files_.close(files_.user_data, handle_, 0);
    }
    HostHandle(const HostHandle&) = delete;
    HostHandle& operator=(const HostHandle&) = delete;

    FlgResult open(FlgFileAccess access) {
        const FlgResult result = files_.open(files_.user_data, name_, access, &handle_);
        is_open_ = result == FLG_OK;
        return result;
    }
    uint64_t size(const String& place) const {
        uint64_t size = 0;
        check_host(files_.size(files_.user_data, handle_, &size), place, "read", "size");
        return size;
    }
    // As many as come before the end.
    size_t read(uint8_t* out, size_t size, const String& place) const {
        size_t come = 0;
        while (come < size) {
            size_t more = 0;
            check_host(files_.read(files_.user_data, handle_, out + come, size - come, &more), place, "read", "read");
            if (more > size - come) {
                fail(FLG_ERROR_FILE, place, "can't be read: the host's read gave %zu of %zu bytes", more, size - come);
            }
            if (more == 0) break;
            come += more;
        }
        return come;
    }
    void write(std::string_view content) const {
        check_host(files_.write(files_.user_data, handle_, content.data(), content.size()), "", "written", "write");
    }
    void close() {
        is_open_ = false;
        check_host(files_.close(files_.user_data, handle_, 1), "", "written", "close");
    }

private:
    const FlgFileSystem& files_;
    const char* name_;
    void* handle_ = nullptr;
    bool is_open_ = false;
};

ByteBlock read_from_host(const Path& path, const String& place, uint64_t limit) {
    HostHandle file(path);
    check_host(file.open(FLG_FILE_ACCESS_READ), place, "opened", "open");
    const uint64_t size = file.size(place);
    check_size(size, limit, place);
    ByteBlock block(size);
    if (const size_t come = file.read(block.data(), size, place); come != size) {
        fail(FLG_ERROR_FILE, place, "can't be read: %zu of %llu bytes came", come,
             static_cast<unsigned long long>(size));
    }
    uint8_t beyond;
    if (file.read(&beyond, 1, place) != 0) {
        fail(FLG_ERROR_FILE, place, "can't be read: more than its %llu bytes came",
             static_cast<unsigned long long>(size));
    }
    return block;
}

}  // namespace

ByteBlock read_file(const Path& path, const String& place, uint64_t limit) {
    if (path.host()) return read_from_host(path, place, limit);
    const std::filesystem::path name = os_path(path);
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(name, error);
    if (!std::filesystem::exists(status)) {
        fail(FLG_ERROR_FILE, place, "can't be opened: %s", error ? error.message().c_str() : "No such file");
    }
    // Pipes and devices have no size to check before reading, and may never end.
    if (!std::filesystem::is_regular_file(status)) fail(FLG_ERROR_FILE, place, "is not a regular file");
    const uint64_t size = std::filesystem::file_size(name, error);
    if (error) fail(FLG_ERROR_FILE, place, "can't be read: %s", error.message().c_str());
    check_size(size, limit, place);
    errno = 0;
    std::ifstream file(name, std::ios::binary);
    if (!file) {
        fail(FLG_ERROR_FILE, place, "can't be opened: %s", std::generic_category().message(errno).c_str());
    }
    ByteBlock block(size);
    file.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(size));
    if (static_cast<uint64_t>(file.gcount()) != size) {
        fail(FLG_ERROR_FILE, place, "can't be read: %lld of %llu bytes came", static_cast<long long>(file.gcount()),
             static_cast<unsigned long long>(size));
    }
    return block;
}

namespace {

// Calls `work`; where the operating system fails it, fails with its words.
template <class Work>
void writing(Work work) {
    try {
        work();
    } catch (const std::system_error& error) {
        fail(FLG_ERROR_FILE, "", "can't be written: %s", error.code().message().c_str());
    }
}

}  // namespace

// The host's file, or the operating system's.
class FileWriter::Target {
public:
    explicit Target(const Path& path) {
        if (path.host()) {
            host_.emplace(path);
            check_host(host_->open(FLG_FILE_ACCESS_WRITE), "", "opened", "open");
        } else {
            writing([&] { file_.emplace(os_path(path)); });
        }
    }

    void write(std::string_view content) {
        if (host_) return host_->write(content);
        writing([&] { file_->write(content); });
    }
    void finish() {
        if (host_) return host_->close();
        writing([&] { file_->save(); });
    }

private:
    std::optional<HostHandle> host_;
    std::optional<SavedFile> file_;
};

FileWriter::FileWriter(const Path& path) : target_(make_owned<Target>(path)) {}
FileWriter::~FileWriter() = default;

void FileWriter::write_out() {
    target_->write(text);
    text.clear();
}

void FileWriter::append(std::string_view content) {
    write_out();
    target_->write(content);
}

void FileWriter::finish() {
    write_out();
    target_->finish();
}

void write_file(const Path& path, std::string_view content) {
    if (content.size() > max_bytes) {
        fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", content.size());
    }
    FileWriter file(path);
    file.append(content);
    file.finish();
}

bool file_exists(const Path& path) {
    if (path.host()) return HostHandle(path).open(FLG_FILE_ACCESS_READ) == FLG_OK;
    return std::filesystem::exists(os_path(path));
}

bool is_folder(const Path& path, std::string_view file) {
    if (path.host()) return !file_exists(path) && file_exists(path.within(file));
    return std::filesystem::is_directory(os_path(path));
}

Path resolved(const Path& path) {
    return path.host() ? path : with_name(path, std::filesystem::weakly_canonical(os_path(path)));
}

bool stays_beside(const Path& path, const Path& document) {
    if (path.host()) return true;
    const std::filesystem::path folder = os_path(document).parent_path();
    const auto base = std::filesystem::weakly_canonical(folder.empty() ? "." : folder);
    const auto target = std::filesystem::weakly_canonical(os_path(path));
    return std::mismatch(base.begin(), base.end(), target.begin(), target.end()).first == base.end();
}

Vector<String> older_companions(const Path& path) {
    Vector<String> names;
    if (path.host()) return names;
    const std::filesystem::path file = os_path(path);
    std::error_code error;
    const std::filesystem::file_time_type saved = std::filesystem::last_write_time(file, error);
    if (error) return names;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    visit_names(folder, [&](const std::filesystem::path& found) {
        const std::u8string name = found.u8string();
        std::error_code unknown;
        if (!name.starts_with(file.filename().u8string())) return;
        const auto written = std::filesystem::last_write_time(folder / found, unknown);
        if (unknown || written >= saved - std::chrono::minutes(10)) return;
        names.emplace_back(reinterpret_cast<const char*>(name.data()), name.size());
    });
    return names;
}

void remove_file(const Path& path) {
    if (path.host()) {
        if (path.host()->remove) path.host()->remove(path.host()->user_data, path.name().c_str());
        return;
    }
    std::error_code ignored;
    std::filesystem::remove(os_path(path), ignored);
}

}  // namespace flg::io
