// SPDX-License-Identifier: MIT
// Documents survive a save that is cut short: by a disk that is full after any number of bytes, by a process that is
// killed at any byte it writes, or at any of its system calls. What was there is there, whole, or what was to be; and
// the next save works.
#ifdef FLG_WITH_IO
#include <csignal>
#include <functional>

#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "filigree/filigree_io.h"
#include "hardening/folder.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

// Sanitizers make forks slow.
#ifdef FLG_SANITIZED
constexpr rlim_t stride = 29;
#else
constexpr rlim_t stride = 1;
#endif

// Saves one of two versions of a document, and reads whatever is there now: its bits, or why it can't be read.
struct Document {
    const char* name;
    std::function<FlgResult(const std::string& path, uint32_t version)> save;
    std::function<std::string(const std::string& path)> load;
};

void PrintTo(const Document& document, std::ostream* out) {
    *out << document.name;
}

FlgResult save_tangle(const std::string& path, uint32_t version) {
    // As many regions as take a side file, which is smaller than the document.
    std::vector<uint32_t> regions;
    for (uint32_t i = 0; i < 20; ++i) regions.push_back(i + version);
    FlgTangleStep step{};
    step.struct_size = sizeof step;
    step.kind = FLG_TANGLE_STEP_KIND_GROUP;
    step.regions = regions.data();
    step.region_count = static_cast<uint32_t>(regions.size());
    const FlgTangleStep* const steps[] = {&step};
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    history.step_count = history.made_count = 1;
    history.steps = steps;
    history.box_max[0] = 1;
    return flgTangleFileWrite(path.c_str(), &history, nullptr);
}

std::string load_tangle(const std::string& path) {
    FlgTangleFile file = nullptr;
    if (flgTangleFileRead(path.c_str(), nullptr, &file) != FLG_OK) return flgIoErrorGetMessage();
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    EXPECT_EQ(flgTangleFileGetHistory(file, &history), FLG_OK);
    std::string all;
    append(all, history.steps[0]->regions, history.steps[0]->region_count);
    flgTangleFileRelease(file);
    return all;
}

FlgResult save_curves(const std::string& path, uint32_t version) {
    Curves curves = arcs(1, 4 + version, 3);
    const FlgCurveSetView view = curves.view();
    return flgCurveFileWrite(path.c_str(), &view, nullptr);
}

std::string load_curves(const std::string& path) {
    FlgCurveFile file = nullptr;
    if (flgCurveFileRead(path.c_str(), nullptr, &file) != FLG_OK) return flgIoErrorGetMessage();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    EXPECT_EQ(flgCurveFileGetView(file, &view), FLG_OK);
    std::string all = bits(view);
    flgCurveFileRelease(file);
    return all;
}

FlgResult save_mesh(const std::string& path, uint32_t version) {
    MeshArrays mesh = plane(1 + version);
    const FlgMeshView view = mesh.view();
    return flgMeshFileWrite(path.c_str(), &view, nullptr);
}

std::string load_mesh(const std::string& path) {
    FlgMeshFile file = nullptr;
    if (flgMeshFileRead(path.c_str(), nullptr, &file) != FLG_OK) return flgIoErrorGetMessage();
    FlgMeshView view = flgMeshViewDefaults();
    EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
    std::string all;
    append(all, view.triangles, size_t{3} * view.triangle_count);
    append(all, view.columns[0].data, size_t{3} * view.vertex_count);
    flgMeshFileRelease(file);
    return all;
}

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
        ASSERT_NE(before, after);
    }
    void start_again() { ASSERT_EQ(document.save(path, 0), FLG_OK) << flgIoErrorGetMessage(); }
    // Old or new, and what was left behind is in nobody's way.
    void expect_whole() {
        const std::string now = document.load(path);
        EXPECT_TRUE(now == before || now == after) << now;
        start_again();
        EXPECT_EQ(document.load(path), before);
        if (++saves_ % 64 == 0) remove_leftovers();
    }
    void remove_leftovers() {
        for (const auto& left : std::filesystem::directory_iterator(folder.path())) {
            if (left.path().string().find(".tmp") != std::string::npos) std::filesystem::remove(left.path());
        }
    }

private:
    int saves_ = 0;
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
        remove_leftovers();  // each is a system call more
    }
    EXPECT_GT(at, 4);
    EXPECT_TRUE(is_old && is_new) << "kills came before and after the document was replaced";
}

const Document documents[] = {
    {"tangle.json", save_tangle, load_tangle},
    {"curves.xyz", save_curves, load_curves},
    {"curves.glb", save_curves, load_curves},
    {"mesh.ply", save_mesh, load_mesh},
};

INSTANTIATE_TEST_SUITE_P(Of, Saves, testing::ValuesIn(documents), [](const auto& test) {
    std::string name = test.param.name;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

}  // namespace
}  // namespace flg::test
#endif
