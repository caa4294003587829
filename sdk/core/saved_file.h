// SPDX-License-Identifier: MIT
// A file that is written whole or not at all, whatever happens on the way: the process is killed, the disk is full, the
// power goes. The SDK's libraries and the renderer, the command line and the studio write what is to last through it.
//
// The bytes go to a temporary file beside the one that is saved, or beside what it links to. They reach the disk before
// its name does: write, flush the file, rename, flush the folder. A file that was there keeps its mode, and its owner
// where the process may give files away.
//
// Each temporary file is locked while somebody writes it; the system unlocks it when that process ends, however that
// happens. A save removes those beside its file that nobody has locked. Where nothing can be locked none are removed.
// Pipes and devices are written as they are.
#pragma once

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#ifdef _WIN32
#include <io.h>
#else
#include <dirent.h>
#include <sys/file.h>
#endif
#include <unistd.h>

namespace flg {

// Calls visit(name) for what is in a folder; for nothing if it can't be read. (The system's functions: GCC 12's
// directory_iterator ends the process where memory runs out.)
template <class Visit>
void visit_names(const std::filesystem::path& folder, Visit visit) {
#ifdef _WIN32
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        visit(entry->path().filename());
#else
    const std::unique_ptr<DIR, int (*)(DIR*)> directory(::opendir(folder.c_str()), ::closedir);
    if (!directory) return;
    while (const dirent* entry = ::readdir(directory.get())) visit(std::filesystem::path(entry->d_name));
#endif
}

// All functions throw std::system_error; nothing has changed then.
class SavedFile {
public:
    explicit SavedFile(const std::filesystem::path& path) {
        std::error_code error;
        const std::filesystem::file_status there = std::filesystem::status(path, error);
        if (std::filesystem::is_directory(there)) fail(EISDIR);
        const bool is_replaced = !std::filesystem::exists(there) || std::filesystem::is_regular_file(there);
        try {
            if (is_replaced) {
                path_ = followed(path);
                remove_abandoned();
                open_beside();
                keep_mode_and_owner();
            } else {
                file_ = open_file(path, O_WRONLY);
                if (file_ < 0) fail(errno);
            }
        } catch (...) {
            discard();
            throw;
        }
    }
    ~SavedFile() { discard(); }
    SavedFile(const SavedFile&) = delete;
    SavedFile& operator=(const SavedFile&) = delete;

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const auto count = ::write(file_, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), max_write)));
            if (count < 0 && errno != EINTR) fail(errno);
            if (count > 0) bytes.remove_prefix(static_cast<size_t>(count));
        }
    }

    // Once, after the last write.
    void save() {
        // Pipes can't be flushed.
        if (!temporary_.empty() && flush(file_) != 0) fail(errno);
#ifdef _WIN32
        close();  // open files can't be renamed there
#endif
        if (!temporary_.empty()) {
            std::filesystem::rename(temporary_, path_);
            temporary_.clear();
            flush_folder();
        }
        close();
    }

private:
    static constexpr int max_tries = 1000;
    static constexpr size_t max_write = size_t{1} << 30;
    static constexpr const char* suffix = ".flg-saving";

    [[noreturn]] static void fail(int error) {
        throw std::system_error(error, std::generic_category());
    }

    // Where a file of this name is: renaming over a symbolic link would replace the link.
    static std::filesystem::path followed(std::filesystem::path path) {
        constexpr int max_links = 40;  // as the kernel has it
        for (int i = 0; i < max_links; ++i) {
            std::error_code error;
            if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) return path;
            path = path.parent_path() / std::filesystem::read_symlink(path);
        }
        fail(ELOOP);
    }
    std::filesystem::path folder() const {
        return path_.has_parent_path() ? path_.parent_path() : ".";
    }

#ifdef _WIN32
    static int open_file(const std::filesystem::path& path, int flags, bool = false) {
        return ::_wopen(path.c_str(), flags | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
    }
    static int flush(int file) {
        return ::_commit(file);
    }
    void flush_folder() const {}
    void keep_mode_and_owner() const {}
    static bool lock(int) {
        return true;
    }
    static void remove_if_abandoned(const std::filesystem::path& temporary) {
        // What is open can't be removed there, but a save closes its file before it renames it.
        std::error_code error;
        const auto written = std::filesystem::last_write_time(temporary, error);
        if (error || written > std::filesystem::file_time_type::clock::now() - std::chrono::hours(1)) return;
        std::filesystem::remove(temporary, error);
    }
#else
    // `is_private`: a file that is made is for this process's user alone.
    static int open_file(const std::filesystem::path& path, int flags, bool is_private = false) {
        return ::open(path.c_str(), flags | O_CLOEXEC, is_private ? 0600 : 0666);
    }
    static int flush(int file) {
        return ::fsync(file);
    }
    // Where folders can't be flushed the file system keeps its own order.
    void flush_folder() const {
        const int directory = ::open(folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (directory < 0) return;
        ::fsync(directory);
        ::close(directory);
    }
    void keep_mode_and_owner() const {
        struct stat there {};
        if (::stat(path_.c_str(), &there) != 0) return;
        // What was allowed to the owner's programs, or to the group, is not for those of this process.
        if (::fchown(file_, there.st_uid, there.st_gid) != 0) {
            there.st_mode &= ~static_cast<mode_t>(S_ISUID);
            if (::fchown(file_, static_cast<uid_t>(-1), there.st_gid) != 0) {
                there.st_mode &= ~static_cast<mode_t>(S_ISGID | S_IRWXG);
            }
        }
        if (::fchmod(file_, there.st_mode & 07777) != 0 && errno != EPERM) fail(errno);  // some systems have no modes
    }
    // Whether a new file stays this save's: another one may have taken it for abandoned before it was locked. Where
    // nothing can be locked nothing is taken for abandoned.
    static bool lock(int file) {
        if (::flock(file, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
        struct stat status {};
        return ::fstat(file, &status) == 0 && status.st_nlink > 0;
    }
    static void remove_if_abandoned(const std::filesystem::path& temporary) {
        const int file = ::open(temporary.c_str(), O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
        if (file < 0) return;
        // Since it was opened it may have been renamed, and its name be another's.
        struct stat own {
        }, named{};
        if (::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &own) == 0 && S_ISREG(own.st_mode) &&
            ::lstat(temporary.c_str(), &named) == 0 && own.st_ino == named.st_ino && own.st_dev == named.st_dev) {
            ::unlink(temporary.c_str());
        }
        ::close(file);
    }
#endif

    void remove_abandoned() const {
        // In the system's letters: not every name is a text. Those of its side files, too.
        const auto start = std::filesystem::path(path_.filename()).concat(".").native();
        const auto mark = std::filesystem::path(suffix).native();
        visit_names(folder(), [&](const std::filesystem::path& name) {
            const bool is_ours = name.native().starts_with(start) && name.native().find(mark) != start.npos;
            if (is_ours) remove_if_abandoned(folder() / name);
        });
    }
    void open_beside() {
        // Until it has the mode of what it replaces.
        const bool is_private = std::filesystem::exists(path_);
        for (int i = 0; i < max_tries; ++i) {
            temporary_ = path_;
            temporary_ += suffix + std::to_string(i);
            file_ = open_file(temporary_, O_WRONLY | O_CREAT | O_EXCL, is_private);
            if (file_ >= 0 && lock(file_)) return;
            const int error = file_ < 0 ? errno : EEXIST;
            temporary_.clear();
            close();
            if (error != EEXIST) fail(error);
        }
        fail(EEXIST);
    }
    void close() noexcept {
        if (file_ >= 0) ::close(file_);
        file_ = -1;
    }
    void discard() noexcept {
        std::error_code ignored;
#ifdef _WIN32
        close();
#endif
        if (!temporary_.empty()) std::filesystem::remove(temporary_, ignored);
        close();
    }

    std::filesystem::path path_, temporary_;
    int file_ = -1;
};

}  // namespace flg
