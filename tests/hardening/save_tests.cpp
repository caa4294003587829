// SPDX-License-Identifier: MIT
// Documents survive a save that is cut short: by a disk that is full after any number of bytes, by a process that is
// killed at any byte it writes, or at any of its system calls. What was there is there, whole, or what was to be; and
// the next save works.
#ifdef FLG_WITH_IO
#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "filigree/filigree_io.h"
#include "hardening/folder.h"
#include "hardening/saved_documents.h"

namespace flg::test {
namespace {

// Sanitizers make forks slow.
#ifdef FLG_SANITIZED
constexpr rlim_t stride = 29;
#else
constexpr rlim_t stride = 1;
#endif

void limit_files(rlim_t bytes) {
    const rlimit limit = {bytes, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
}

// Saves version 1 in a process of its own; returns how it ended.
int save_apart(const Document& document, const std::string& path, const std::function<void()>& before) {
    const pid_t child = fork();
    if (child == 0) {
        before();
        _exit(document.save(path, 1) == FLG_OK ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

// Likewise, killed as it enters or leaves a system call for the time number `at`, counted from 0; false: it was done
// before.
bool killed_at_call(const Document& document, const std::string& path, int at) {
    const pid_t child = fork();
    if (child == 0) {
        ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        raise(SIGSTOP);
        _exit(document.save(path, 1) == FLG_OK ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    for (int stops = 0; WIFSTOPPED(status); ++stops) {
        if (stops == at + 1) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return true;
        }
        EXPECT_EQ(ptrace(PTRACE_SYSCALL, child, nullptr, nullptr), 0);
        waitpid(child, &status, 0);
    }
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return false;
}

size_t entries(const Folder& folder) {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

class Saves : public testing::TestWithParam<Document> {
protected:
    const Document& document = GetParam();
    const Folder folder;
    const std::string path = folder.at(document.name);
    std::string before, after;

    void SetUp() override {
        ASSERT_EQ(document.save(path, 1), FLG_OK) << flgIoErrorGetMessage();
        after = document.load(path);
        start_again();
        before = document.load(path);
        files_ = entries(folder);
        ASSERT_NE(before, after);
    }
    void start_again() { ASSERT_EQ(document.save(path, 0), FLG_OK) << flgIoErrorGetMessage(); }
    // Old or new, and what was left behind is gone after the next save.
    void expect_whole() {
        const std::string now = document.load(path);
        EXPECT_TRUE(now == before || now == after) << now;
        // Long ago: a save that may still go on keeps what it has written.
        using namespace std::chrono_literals;
        for (const auto& left : std::filesystem::directory_iterator(folder.path())) {
            if (left.path() != path) last_write_time(left.path(), left.last_write_time() - 1h);
        }
        start_again();
        EXPECT_EQ(document.load(path), before);
        EXPECT_EQ(entries(folder), files_) << "the next save cleans up";
    }

private:
    size_t files_ = 0;
};

TEST_P(Saves, ThatFailForWantOfSpaceChangeNothing) {
    const size_t files = entries(folder);
    int status = -1;
    for (rlim_t bytes = 0; !HasFailure(); bytes += stride) {
        SCOPED_TRACE(std::to_string(bytes) + " bytes");
        status = save_apart(document, path, [&] {
            signal(SIGXFSZ, SIG_IGN);
            limit_files(bytes);
        });
        ASSERT_TRUE(WIFEXITED(status));
        if (WEXITSTATUS(status) == 0) break;
        EXPECT_EQ(document.load(path), before);
        EXPECT_EQ(entries(folder), files) << "something was left behind";
    }
    EXPECT_EQ(document.load(path), after);
}

TEST_P(Saves, ThatAreKilledAtAnyByteLeaveOldOrNew) {
    int kills = 0;
    for (rlim_t bytes = 0; !HasFailure(); bytes += stride) {
        SCOPED_TRACE(std::to_string(bytes) + " bytes");
        const int status = save_apart(document, path, [&] {
            signal(SIGXFSZ, SIG_DFL);
            limit_files(bytes);
        });
        if (WIFEXITED(status)) break;
        ASSERT_EQ(WTERMSIG(status), SIGXFSZ);
        ++kills;
        expect_whole();
    }
    EXPECT_GT(kills, 4);
    EXPECT_EQ(document.load(path), after);
}

TEST_P(Saves, ThatAreKilledAtAnySystemCallLeaveOldOrNew) {
    bool is_old = false, is_new = false;
    int at = 0;
    for (; killed_at_call(document, path, at) && !HasFailure(); ++at) {
        SCOPED_TRACE("stop " + std::to_string(at));
        const std::string now = document.load(path);
        is_old = is_old || now == before;
        is_new = is_new || now == after;
        expect_whole();
    }
    EXPECT_GT(at, 4);
    EXPECT_TRUE(is_old && is_new) << "kills came before and after the document was replaced";
}

TEST_P(Saves, KeepModeAndOwner) {
    struct stat made {};
    ASSERT_EQ(stat(path.c_str(), &made), 0);
    const mode_t masked = umask(0);
    umask(masked);
    EXPECT_EQ(made.st_mode & 07777, 0666 & ~masked) << "a new file's is the process's";
    // Only root gives files away.
    const bool is_root = geteuid() == 0;
    const uid_t owner = is_root ? 12345 : geteuid();
    const gid_t group = is_root ? 54321 : getegid();
    ASSERT_EQ(chown(path.c_str(), owner, group), 0) << "in a container that knows no such user run this as a user";
    for (const mode_t mode : {0600, 0640, 0664}) {
        ASSERT_EQ(chmod(path.c_str(), mode), 0);
        ASSERT_EQ(document.save(path, 1), FLG_OK) << flgIoErrorGetMessage();
        struct stat now {};
        ASSERT_EQ(stat(path.c_str(), &now), 0);
        EXPECT_EQ(now.st_mode & 07777, mode);
        EXPECT_EQ(now.st_uid, owner);
        EXPECT_EQ(now.st_gid, group);
    }
    EXPECT_EQ(document.load(path), after);
}

TEST_P(Saves, LeaveWhatAnotherSaveIsWriting) {
    const std::string busy = path + ".flg-saving0", abandoned = path + ".flg-saving1";
    const int file = open(busy.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_GE(file, 0);
    ASSERT_EQ(flock(file, LOCK_EX), 0);
    close(open(abandoned.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    start_again();
    EXPECT_TRUE(std::filesystem::exists(busy));
    EXPECT_FALSE(std::filesystem::exists(abandoned));
    close(file);
    start_again();
    EXPECT_FALSE(std::filesystem::exists(busy));
}

TEST_P(Saves, IntoAPipeLeaveItThere) {
    const Folder other;
    const std::string pipe = other.at(document.name);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    // Opened before, so that a save that opens nothing is not waited for.
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    const pid_t child = fork();
    if (child == 0) _exit(document.save(pipe, 1) == FLG_OK ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);  // what is written is less than a pipe holds
    std::string come(size_t{1} << 16, '\0');
    const ssize_t count = read(reader, come.data(), come.size());
    close(reader);
    come.resize(static_cast<size_t>(std::max(count, ssize_t{0})));
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    ASSERT_EQ(document.save(path, 1), FLG_OK);
    std::ifstream file(path, std::ios::binary);
    const std::string expected((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(come, expected);
}

INSTANTIATE_TEST_SUITE_P(Of, Saves, testing::ValuesIn(documents()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace flg::test
#endif
