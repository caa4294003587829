// SPDX-License-Identifier: MIT
// Documents survive a save during which the power goes. The system calls of a save are recorded; then each beginning of
// them is played onto a model of a disk that owes nothing to anybody who did not ask: a write lasts for certain once
// its file was flushed, a name once its folder was, and of all else any part may be there, in any order. What is found
// then is the old document or the new one; once the save has returned, the new one.
#ifdef FLG_WITH_IO
#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "filigree/filigree_io.h"
#include "hardening/folder.h"
#include "hardening/saved_documents.h"

namespace flg::test {
namespace {

using Files = std::map<std::string, std::string>;  // what is in a folder, by name

constexpr int the_folder = -1;  // in place of a file's number

struct Operation {
    enum Kind { create, write, flush, rename, remove } kind;
    int file = the_folder;
    std::string name{}, to{};
    size_t offset = 0;
    std::string bytes{};
};

// The operations of a process on the files of one folder.
class Recorder {
public:
    explicit Recorder(std::string folder, const Files& there) : folder_(std::move(folder)) {
        for (const auto& [name, content] : there) file_of_[name] = count_++;
    }

    // One system call that succeeded.
    void take(pid_t process, uint64_t call, const uint64_t* a, int64_t result) {
        switch (call) {
            case SYS_openat: return open(text(process, a[1]), static_cast<int>(a[2]), static_cast<int>(result));
            case SYS_close: opened_.erase(static_cast<int>(a[0])); return;
            case SYS_write: return write(static_cast<int>(a[0]), bytes(process, a[1], static_cast<size_t>(result)));
            case SYS_fsync:
            case SYS_fdatasync:
                if (const auto file = opened(a[0])) operations.push_back({Operation::flush, file->number});
                return;
#ifdef SYS_rename
            case SYS_rename: return rename(text(process, a[0]), text(process, a[1]));
            case SYS_unlink: return remove(text(process, a[0]));
#endif
            case SYS_renameat:
            case SYS_renameat2: return rename(text(process, a[1]), text(process, a[3]));
            case SYS_unlinkat: return remove(text(process, a[1]));
            default: return;
        }
    }

    std::vector<Operation> operations;

private:
    struct Opened {
        int number;
        size_t offset;
    };

    std::string bytes(pid_t process, uint64_t from, size_t size) const {
        std::string all(size, '\0');
        const iovec here = {all.data(), size}, there = {reinterpret_cast<void*>(from), size};
        EXPECT_EQ(process_vm_readv(process, &here, 1, &there, 1, 0), static_cast<ssize_t>(size));
        return all;
    }
    std::string text(pid_t process, uint64_t from) const {
        std::string all;
        for (std::string one; one != std::string(1, '\0'); all += one) one = bytes(process, from + all.size(), 1);
        all.pop_back();
        return all;
    }
    // The name within the folder, if it is there.
    std::optional<std::string> within(const std::string& path) const {
        if (!path.starts_with(folder_ + "/")) return std::nullopt;
        return path.substr(folder_.size() + 1);
    }
    std::optional<Opened> opened(uint64_t descriptor) const {
        const auto found = opened_.find(static_cast<int>(descriptor));
        return found == opened_.end() ? std::nullopt : std::optional(found->second);
    }

    void open(const std::string& path, int flags, int descriptor) {
        if (path == folder_ || path == folder_ + "/") opened_[descriptor] = {the_folder, 0};
        const std::optional<std::string> name = within(path);
        if (!name || name->empty()) return;
        if (!file_of_.contains(*name)) {
            ASSERT_NE(flags & O_CREAT, 0) << path;
            file_of_[*name] = count_++;
            operations.push_back({Operation::create, file_of_[*name], *name});
        }
        EXPECT_EQ(flags & (O_TRUNC | O_APPEND), 0) << "what the model does not know";
        opened_[descriptor] = {file_of_[*name], 0};
    }
    void write(int descriptor, std::string what) {
        const auto found = opened_.find(descriptor);
        if (found == opened_.end()) return;
        const size_t offset = std::exchange(found->second.offset, found->second.offset + what.size());
        operations.push_back({Operation::write, found->second.number, "", "", offset, std::move(what)});
    }
    void rename(const std::string& from, const std::string& to) {
        if (!within(from)) return;
        const std::string old_name = *within(from), new_name = within(to).value();
        operations.push_back({Operation::rename, file_of_.at(old_name), old_name, new_name});
        file_of_[new_name] = file_of_.at(old_name);
        file_of_.erase(old_name);
    }
    void remove(const std::string& path) {
        if (!within(path)) return;
        operations.push_back({Operation::remove, file_of_.at(*within(path)), *within(path)});
        file_of_.erase(*within(path));
    }

    std::string folder_;
    int count_ = 0;
    std::map<std::string, int> file_of_;
    std::map<int, Opened> opened_;
};

Files files_in(const std::string& folder) {
    Files all;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        all[entry.path().filename().string()] = std::string(std::istreambuf_iterator<char>(file), {});
    }
    return all;
}

// Saves version 1 in a process of its own.
std::vector<Operation> recorded(const Document& document, const std::string& folder, const std::string& path) {
    Recorder recorder(folder, files_in(folder));
    const pid_t child = fork();
    if (child == 0) {
        ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        raise(SIGSTOP);
        _exit(document.save(path, 1) == FLG_OK ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD), 0);
    __ptrace_syscall_info call{}, entered{};
    while (WIFSTOPPED(status)) {
        if (ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof call, &call) > 0) {
            if (call.op == PTRACE_SYSCALL_INFO_ENTRY) entered = call;
            if (call.op == PTRACE_SYSCALL_INFO_EXIT && !call.exit.is_error) {
                recorder.take(child, entered.entry.nr, reinterpret_cast<const uint64_t*>(entered.entry.args),
                              call.exit.rval);
            }
        }
        EXPECT_EQ(ptrace(PTRACE_SYSCALL, child, nullptr, nullptr), 0);
        waitpid(child, &status, 0);
    }
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return std::move(recorder.operations);
}

// Plays those of some operations that last: all that were flushed since, and of the others those in `luck`, a bit each.
class Disk {
public:
    Disk(const Files& there, std::span<const Operation> operations) : there_(there), operations_(operations) {}

    size_t unsure() const {
        size_t count = 0;
        for (size_t i = 0; i < operations_.size(); ++i) count += is_unsure(i);
        return count;
    }
    Files after(uint64_t luck) const {
        std::map<int, std::string> contents;
        std::map<std::string, int> names;
        for (const auto& [name, content] : there_) {
            const int file = static_cast<int>(names.size());
            names[name] = file;
            contents[file] = content;
        }
        for (size_t i = 0; i < operations_.size(); ++i) {
            if (is_unsure(i)) {
                const bool lasts = (luck & 1) != 0;
                luck >>= 1;
                if (!lasts) continue;
            }
            const Operation& o = operations_[i];
            std::string& content = contents[o.file];
            switch (o.kind) {
                case Operation::create: names[o.name] = o.file; break;
                case Operation::write:
                    content.resize(std::max(content.size(), o.offset + o.bytes.size()));
                    content.replace(o.offset, o.bytes.size(), o.bytes);
                    break;
                case Operation::flush: break;
                case Operation::rename:
                    names.erase(o.name);
                    names[o.to] = o.file;
                    break;
                case Operation::remove: names.erase(o.name); break;
            }
        }
        Files files;
        for (const auto& [name, file] : names) files[name] = contents[file];
        return files;
    }

private:
    bool is_unsure(size_t i) const {
        const Operation& o = operations_[i];
        if (o.kind == Operation::flush) return false;
        const int flushed = o.kind == Operation::write ? o.file : the_folder;
        return std::none_of(
            operations_.begin() + static_cast<std::ptrdiff_t>(i), operations_.end(),
            [&](const Operation& later) { return later.kind == Operation::flush && later.file == flushed; });
    }

    const Files& there_;
    std::span<const Operation> operations_;
};

class PowerLoss : public testing::TestWithParam<Document> {};

TEST_P(PowerLoss, LeavesOldOrNew) {
    const Document& document = GetParam();
    const Folder folder, found;
    const std::string path = folder.at(document.name);
    ASSERT_EQ(document.save(path, 1), FLG_OK);
    const std::string after = document.load(path);
    ASSERT_EQ(document.save(path, 0), FLG_OK);
    const std::string before = document.load(path);
    const Files there = files_in(folder.path());
    const std::vector<Operation> operations = recorded(document, folder.path(), path);
    const Disk all(there, operations);
    EXPECT_EQ(all.after(~uint64_t{0}), files_in(folder.path())) << "the model is the file system";

    bool is_old = false, is_new = false;
    std::map<Files, std::string> seen;
    for (size_t count = 0; count <= operations.size(); ++count) {
        const Disk disk(there, std::span(operations).first(count));
        ASSERT_LE(disk.unsure(), 12u);
        for (uint64_t luck = 0; luck < uint64_t{1} << disk.unsure(); ++luck) {
            const Files files = disk.after(luck);
            const auto [entry, is_first] = seen.try_emplace(files);
            std::string& now = entry->second;
            if (is_first) {
                for (const auto& left : std::filesystem::directory_iterator(found.path())) remove(left.path());
                for (const auto& [name, content] : files) {
                    std::ofstream(found.path() + "/" + name, std::ios::binary) << content;
                }
                now = document.load(found.at(document.name));
            }
            ASSERT_TRUE(now == before || now == after) << "after " << count << " operations: " << now;
            if (count == operations.size()) {
                ASSERT_EQ(now, after) << "what was saved may be lost";
            }
            is_old = is_old || now == before;
            is_new = is_new || now == after;
        }
    }
    EXPECT_TRUE(is_old && is_new);
}

INSTANTIATE_TEST_SUITE_P(Of, PowerLoss, testing::ValuesIn(documents()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace flg::test
#endif
