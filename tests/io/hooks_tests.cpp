// SPDX-License-Identifier: MIT
// The host's memory and files: everything comes from them, in whatever way they fail.
#include <cstdlib>
#include <cstring>
#include <functional>
#include <set>

#include "io/gltf_files.h"
#include "io/mesh_files.h"
#include "io/skin_files.h"
#include "io/tilt_files.h"

namespace flg::test {
namespace {

// Counts, fails when asked to, and knows each block's size and alignment.
class CountedMemory {
public:
    const FlgAllocator hook{sizeof(FlgAllocator), this,
                            [](void* self, size_t size, size_t alignment) {
                                return static_cast<CountedMemory*>(self)->take(size, alignment);
                            },
                            [](void* self, void* memory, size_t size, size_t alignment) {
                                static_cast<CountedMemory*>(self)->give_back(memory, size, alignment);
                            }};
    int64_t calls = 0, failing = -1, live = 0, wrong = 0, largest = 0;
    bool fails_on = false;

    void fail(int64_t at, bool from_then_on) {
        calls = 0;
        failing = at;
        fails_on = from_then_on;
    }

private:
    struct Note {
        size_t size, alignment;
    };
    void* take(size_t size, size_t alignment) {
        const int64_t number = calls++;
        if (failing >= 0 && (number == failing || (fails_on && number > failing))) return nullptr;
        auto* const block = static_cast<char*>(std::malloc(2 * sizeof(Note) + size));
        *reinterpret_cast<Note*>(block) = {size, alignment};
        live += static_cast<int64_t>(size);
        largest = std::max(largest, static_cast<int64_t>(size));
        return block + 2 * sizeof(Note);
    }
    void give_back(void* memory, size_t size, size_t alignment) {
        char* const block = static_cast<char*>(memory) - 2 * sizeof(Note);
        const Note& note = *reinterpret_cast<Note*>(block);
        if (note.size != size || note.alignment != alignment) ++wrong;
        live -= static_cast<int64_t>(size);
        std::free(block);
    }
};

// Files in memory.
struct MemoryFiles {
    struct File {
        std::string path, content;
        size_t at = 0;
        bool is_written = false;
    };
    std::map<std::string, std::string> files;
    std::set<std::string> asked;
    int open = 0;
    std::function<uint64_t(uint64_t)> size_said = [](uint64_t size) { return size; };
    std::function<size_t(size_t)> bytes_read = [](size_t size) { return size; };
    FlgResult size_result = FLG_OK, read_result = FLG_OK, write_result = FLG_OK, close_result = FLG_OK;

    const FlgFileSystem hook{sizeof(FlgFileSystem),
                             0,
                             this,
                             [](void* self, const char* path, FlgFileAccess access, void** out_file) {
                                 *out_file = static_cast<MemoryFiles*>(self)->opened(path, access);
                                 return *out_file ? FLG_OK : FLG_ERROR_FILE;
                             },
                             [](void* self, void* file, uint64_t* out_size) {
                                 auto& host = *static_cast<MemoryFiles*>(self);
                                 *out_size = host.size_said(static_cast<File*>(file)->content.size());
                                 return host.size_result;
                             },
                             [](void* self, void* file, void* out, size_t size, size_t* out_count) {
                                 auto& from = *static_cast<File*>(file);
                                 auto& host = *static_cast<MemoryFiles*>(self);
                                 // In pieces, as hosts may.
                                 const size_t count = std::min({size, from.content.size() - from.at, size_t{1000}});
                                 std::memcpy(out, from.content.data() + from.at, count);
                                 from.at += count;
                                 *out_count = host.bytes_read(count);
                                 return host.read_result;
                             },
                             [](void* self, void* file, const void* bytes, size_t size) {
                                 static_cast<File*>(file)->content.append(static_cast<const char*>(bytes), size);
                                 return static_cast<MemoryFiles*>(self)->write_result;
                             },
                             [](void* self, void* file, uint32_t complete) {
                                 return static_cast<MemoryFiles*>(self)->closed(static_cast<File*>(file), complete);
                             },
                             [](void* self, const char* path) {
                                 return static_cast<MemoryFiles*>(self)->files.erase(path) == 1 ? FLG_OK
                                                                                                : FLG_ERROR_FILE;
                             }};

    File* opened(const char* path, FlgFileAccess access) {
        asked.insert(path);
        const auto found = files.find(path);
        if (access == FLG_FILE_ACCESS_READ && found == files.end()) return nullptr;
        ++open;
        return new File{path, access == FLG_FILE_ACCESS_READ ? found->second : "", 0, access == FLG_FILE_ACCESS_WRITE};
    }
    FlgResult closed(File* file, uint32_t complete) {
        --open;
        if (file->is_written && complete && close_result == FLG_OK) files[file->path] = file->content;
        delete file;
        return close_result;
    }
};

std::string bytes_of(const FlgCurveSetView& view) {
    std::string bytes;
    for (uint32_t i = 0; i < view.column_count; ++i) {
        bytes.append(reinterpret_cast<const char*>(view.columns[i].data),
                     view.curve_offsets[view.curve_count] * view.columns[i].components * sizeof(float));
    }
    return bytes;
}

// What is read of a file, as bytes; the result.
FlgResult read_curves(const char* path, const FlgFileHooks* hooks, std::string& bytes) {
    FlgCurveFile file = nullptr;
    FlgCurveFileReadDesc desc = flgCurveFileReadDefaults();
    desc.hooks = hooks;
    const FlgResult result = flgCurveFileRead(path, &desc, &file);
    if (result != FLG_OK) return result;
    FlgCurveSetView view{};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgCurveFileGetView(file, &view), FLG_OK);
    bytes += bytes_of(view);
    flgCurveFileRelease(file);
    return FLG_OK;
}

FlgResult read_mesh_file(const char* path, const FlgFileHooks* hooks, std::string& bytes) {
    FlgMeshFile file = nullptr;
    FlgMeshFileReadDesc desc = flgMeshFileReadDefaults();
    desc.hooks = hooks;
    const FlgResult result = flgMeshFileRead(path, &desc, &file);
    if (result != FLG_OK) return result;
    FlgMeshView view{};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
    bytes.append(reinterpret_cast<const char*>(view.triangles), 3 * sizeof(uint32_t) * view.triangle_count);
    bytes.append(reinterpret_cast<const char*>(view.columns[0].data), 3 * sizeof(float) * view.vertex_count);
    flgMeshFileRelease(file);
    return FLG_OK;
}

FlgResult read_skin_file(const char* path, const FlgFileHooks* hooks, std::string& bytes) {
    FlgSkinFile file = nullptr;
    FlgSkinFileReadDesc desc = flgSkinFileReadDefaults();
    desc.hooks = hooks;
    const FlgResult result = flgSkinFileRead(path, &desc, &file);
    if (result != FLG_OK) return result;
    FlgSkinView view{};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgSkinFileGetView(file, &view), FLG_OK);
    bytes.append(reinterpret_cast<const char*>(view.positions), 3 * sizeof(float) * view.vertex_count);
    FlgSkinAnimation missing{};
    missing.struct_size = sizeof missing;
    EXPECT_EQ(flgSkinFileGetAnimation(file, 99, &missing), FLG_ERROR_INVALID_ARGUMENT);
    flgSkinFileRelease(file);
    return FLG_OK;
}

FlgResult read_tangle_file(const char* path, const FlgFileHooks* hooks, std::string& bytes) {
    FlgTangleFile file = nullptr;
    FlgTangleFileReadDesc desc = flgTangleFileReadDefaults();
    desc.hooks = hooks;
    const FlgResult result = flgTangleFileRead(path, &desc, &file);
    if (result != FLG_OK) return result;
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    EXPECT_EQ(flgTangleFileGetHistory(file, &history), FLG_OK);
    bytes.append(reinterpret_cast<const char*>(history.steps[0]->regions),
                 sizeof(uint32_t) * history.steps[0]->region_count);
    flgTangleFileRelease(file);
    return FLG_OK;
}

struct Format {
    const char* name;
    // Null: the file is put there by `files`.
    FlgResult (*write)(const char* path, const FlgFileHooks* hooks);
    // Null: it cannot be read.
    FlgResult (*read)(const char* path, const FlgFileHooks* hooks, std::string& bytes);
    std::map<std::string, std::string> (*files)() = nullptr;
};

FlgResult write_curves(const char* path, const FlgFileHooks* hooks) {
    Curves curves;
    curves.add({0, 0, 0, 1, 0.1f, 0, 2, 0, 1e-7f});
    curves.add({0, 1, 0, 1, 1, 0, 0, 2, 1, 4, 4, 4}, true);
    const FlgCurveSetView view = curves.view();
    FlgCurveFileWriteDesc desc = flgCurveFileWriteDefaults();
    desc.geometry = FLG_CURVE_GEOMETRY_LINES;
    desc.hooks = hooks;
    return flgCurveFileWrite(path, &view, &desc);
}

FlgResult write_tubes(const char* path, const FlgFileHooks* hooks) {
    Curves curves;
    curves.add({0, 0, 0, 1, 0.1f, 0, 2, 0, 1});
    const FlgCurveSetView view = curves.view();
    FlgCurveFileWriteDesc desc = flgCurveFileWriteDefaults();
    desc.geometry = FLG_CURVE_GEOMETRY_TUBE;
    desc.tolerance = 0.001f;
    desc.quantize = 1;
    desc.hooks = hooks;
    return flgCurveFileWrite(path, &view, &desc);
}

FlgResult write_meshes(const char* path, const FlgFileHooks* hooks) {
    MeshInput mesh;
    mesh.regions = {0, 1, 1, 0};
    mesh.split_regions = true;
    const FlgMeshView view = mesh.view();
    FlgMeshFileWriteDesc desc = mesh.desc();
    desc.hooks = hooks;
    return flgMeshFileWrite(path, &view, &desc);
}

FlgResult write_skins(const char* path, const FlgFileHooks* hooks) {
    TestSkin skin = cross(5, 4);
    const TestAnimation animation = swaying_cross(skin);
    const FlgSkinView view = skin.view();
    const FlgSkinAnimation shown = animation.view();
    FlgSkinFileWriteDesc desc = flgSkinFileWriteDefaults();
    desc.skin = &view;
    desc.animations = &shown;
    desc.animation_count = 1;
    desc.hooks = hooks;
    return flgSkinFileWrite(path, &desc);
}

FlgResult write_motions(const char* path, const FlgFileHooks* hooks) {
    const double times[] = {0, 1}, poses[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0};
    FlgMotionFileWriteDesc desc = flgMotionFileWriteDefaults();
    desc.position_count = 2;
    desc.times = times;
    desc.poses = poses;
    desc.hooks = hooks;
    return flgMotionFileWrite(path, &desc);
}

FlgResult write_tangles(const char* path, const FlgFileHooks* hooks) {
    std::vector<uint32_t> regions;
    for (uint32_t i = 0; i < 40; ++i) regions.push_back(i);
    FlgTangleStep step{};
    step.struct_size = sizeof step;
    step.kind = FLG_TANGLE_STEP_KIND_GROUP;
    step.regions = regions.data();
    step.region_count = 40;
    const FlgTangleStep* const steps[] = {&step};
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    history.step_count = history.made_count = 1;
    history.steps = steps;
    history.box_max[0] = 1;
    FlgTangleFileWriteDesc desc = flgTangleFileWriteDefaults();
    desc.hooks = hooks;
    return flgTangleFileWrite(path, &history, &desc);
}

std::map<std::string, std::string> svg_files() {
    return {
        {"a.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><path d='M0 0C1 2 3 4 5 6Z'/></svg>"}};
}

std::string sketch() {
    TiltStroke stroke;
    stroke.points.resize(3);
    stroke.points[1].position[0] = 1;
    stroke.points[2].position[1] = 2;
    return tilt_sketch({stroke});
}

std::map<std::string, std::string> tilt_files() {
    return {{"a.tilt",
             tilt_header() + zip({{"metadata.json", tilt_metadata, true, 0}, {"data.sketch", sketch(), true, 0}})}};
}

std::map<std::string, std::string> tilt_folder_files() {
    return {{"a.tilt/metadata.json", tilt_metadata}, {"a.tilt/data.sketch", sketch()}};
}

std::map<std::string, std::string> gltf_files() {
    Document document;
    document.uri = "parts/a%20b.bin";
    return {{"a.gltf", document.text()}, {"parts/a b.bin", test::bytes_of(document.points)}};
}

const Format formats[] = {
    {"a.xyz", write_curves, read_curves},
    {"a.obj", write_curves, read_curves},
    {"a.glb", write_curves, read_curves},
    {"tubes.glb", write_tubes, read_mesh_file},
    {"mesh.ply", write_meshes, read_mesh_file},
    {"mesh.obj", write_meshes, read_mesh_file},
    {"mesh.off", write_meshes, read_mesh_file},
    {"mesh.glb", write_meshes, read_mesh_file},
    {"skin.glb", write_skins, read_skin_file},
    {"motion.glb", write_motions, nullptr},
    {"tangle.json", write_tangles, read_tangle_file},
    {"a.svg", nullptr, read_curves, svg_files},
    {"a.tilt", nullptr, read_curves, tilt_files},
    {"a.tilt", nullptr, read_curves, tilt_folder_files},
    {"a.gltf", nullptr, read_curves, gltf_files},
};

struct Host {
    CountedMemory memory;
    MemoryFiles files;
    const FlgFileHooks hooks{sizeof(FlgFileHooks), 0, &memory.hook, &files.hook};

    ~Host() {
        EXPECT_EQ(memory.live, 0);
        EXPECT_EQ(memory.wrong, 0);
        EXPECT_EQ(files.open, 0);
    }
    void put_files(const Format& format) {
        if (format.files) files.files = format.files();
    }
    FlgResult run(const Format& format, std::string& bytes) {
        FlgResult result = format.write ? format.write(format.name, &hooks) : FLG_OK;
        if (result == FLG_OK && format.read) result = format.read(format.name, &hooks, bytes);
        return result;
    }
};

TEST(FileHooks, MemoryAndFilesOfTheHostGiveTheSameBytes) {
    for (const Format& format : formats) {
        SCOPED_TRACE(format.name);
        const Folder folder;
        Host host;
        host.put_files(format);
        for (const auto& [name, content] : host.files.files) folder.put(name, content);
        std::string ours, bytes;
        ASSERT_EQ(host.run(format, ours), FLG_OK) << flgIoErrorGetMessage();
        EXPECT_GT(host.memory.calls, 0);
        const std::string path = folder.at(format.name);
        if (format.write) {
            ASSERT_EQ(format.write(path.c_str(), nullptr), FLG_OK) << flgIoErrorGetMessage();
        }
        if (format.read) {
            ASSERT_EQ(format.read(path.c_str(), nullptr, bytes), FLG_OK) << flgIoErrorGetMessage();
        }
        EXPECT_TRUE(ours == bytes);
        for (const auto& [name, content] : host.files.files) EXPECT_TRUE(slurp(folder.at(name)) == content) << name;
        EXPECT_FALSE(std::filesystem::exists(format.name));
    }
}

// Text leaves while it is made: a file may be larger than the memory.
TEST(FileHooks, TextIsWrittenInParts) {
    constexpr uint32_t count = 200'000;
    std::vector<float> positions(size_t{3} * count);
    for (size_t i = 0; i < positions.size(); ++i) positions[i] = 0.001f * static_cast<float>(i);
    const uint32_t offsets[] = {0, count};
    const std::vector<uint32_t> triangles(size_t{3} * count, 0);
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    FlgCurveSetView curves{};
    curves.struct_size = sizeof curves;
    curves.curve_count = 1;
    curves.curve_offsets = offsets;
    curves.columns = &column;
    curves.column_count = 1;
    FlgMeshView mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.columns = &column;
    mesh.column_count = 1;
    mesh.vertex_count = mesh.triangle_count = count;
    mesh.triangles = triangles.data();
    for (const char* name : {"lines.xyz", "lines.obj", "mesh.obj", "mesh.off"}) {
        CountedMemory memory;
        MemoryFiles files;
        FlgFileHooks hooks = flgFileHooksDefaults();
        hooks.allocator = &memory.hook;
        hooks.files = &files.hook;
        FlgCurveFileWriteDesc curve_desc = flgCurveFileWriteDefaults();
        FlgMeshFileWriteDesc mesh_desc = flgMeshFileWriteDefaults();
        curve_desc.hooks = mesh_desc.hooks = &hooks;
        const bool of_curves = name[0] == 'l';
        ASSERT_EQ(of_curves ? flgCurveFileWrite(name, &curves, &curve_desc) : flgMeshFileWrite(name, &mesh, &mesh_desc),
                  FLG_OK)
            << flgIoErrorGetMessage();
        EXPECT_GT(files.files.at(name).size(), 2'000'000u) << name;
        EXPECT_LT(memory.largest, 200'000) << name;
        EXPECT_EQ(memory.live, 0) << name;
    }
}

TEST(FileHooks, EachAllocationMayFail) {
    for (const Format& format : formats) {
        SCOPED_TRACE(format.name);
        Host host;
        host.put_files(format);
        std::string whole;
        ASSERT_EQ(host.run(format, whole), FLG_OK) << flgIoErrorGetMessage();
        const int64_t count = host.memory.calls;
        for (const bool from_then_on : {false, true}) {
            const int64_t stride = from_then_on ? 1 + count / 50 : 1 + count / 2000;
            for (int64_t n = 0; n < count && !HasFailure(); n += stride) {
                SCOPED_TRACE("allocation " + std::to_string(n));
                std::string bytes;
                host.memory.fail(n, from_then_on);
                const FlgResult result = host.run(format, bytes);
                host.memory.fail(-1, false);
                EXPECT_EQ(result, FLG_ERROR_OUT_OF_MEMORY) << flgIoErrorGetMessage();
                EXPECT_STREQ(flgIoErrorGetMessage(), (std::string(format.name) + ": no memory is left").c_str());
                EXPECT_EQ(host.memory.live, 0);
                EXPECT_EQ(host.files.open, 0);
            }
        }
        std::string again;
        EXPECT_EQ(host.run(format, again), FLG_OK) << flgIoErrorGetMessage();
        EXPECT_TRUE(again == whole);
    }
}

// 10 MB of lists that nest as deeply as they may.
TEST(FileHooks, ALargeNestedDocumentRunsOutOfMemoryAnywhere) {
    std::string nested;
    while (nested.size() < 10'000'000) {
        nested += (nested.empty() ? "" : ",") + std::string(100, '[') + R"({"a\n":"\u00e4","b":[1,2.5]})" +
                  std::string(100, ']');
    }
    Document document;
    std::string text = document.text();
    text.insert(1, "\"extras\": [" + nested + "], ");
    Host host;
    host.files.files["a.gltf"] = text;
    std::string bytes;
    ASSERT_EQ(read_curves("a.gltf", &host.hooks, bytes), FLG_OK) << flgIoErrorGetMessage();
    const int64_t count = host.memory.calls;
    for (int64_t n = 0; n < count && !HasFailure(); n += 1 + count / 40) {
        host.memory.fail(n, true);
        EXPECT_EQ(read_curves("a.gltf", &host.hooks, bytes), FLG_ERROR_OUT_OF_MEMORY) << n;
        EXPECT_EQ(host.memory.live, 0);
    }
}

TEST(FileHooks, AHostThatFailsOrLiesIsRefused) {
    Host host;
    MemoryFiles& files = host.files;
    ASSERT_EQ(write_curves("a.xyz", &host.hooks), FLG_OK);
    const std::string before = files.files["a.xyz"];
    const auto expect_read = [&](FlgResult result, const char* reason) {
        std::string bytes;
        EXPECT_EQ(read_curves("a.xyz", &host.hooks, bytes), result) << reason;
        EXPECT_NE(std::string(flgIoErrorGetMessage()).find(reason), std::string::npos) << flgIoErrorGetMessage();
        files.size_said = [](uint64_t size) { return size; };
        files.bytes_read = [](size_t size) { return size; };
        files.size_result = files.read_result = FLG_OK;
    };
    files.size_said = [](uint64_t size) { return size + 1; };
    expect_read(FLG_ERROR_FILE, "bytes came");
    files.size_said = [](uint64_t size) { return size - 1; };
    expect_read(FLG_ERROR_FILE, "more than its");
    files.size_said = [](uint64_t) { return UINT64_MAX; };
    expect_read(FLG_ERROR_LIMIT, "more than the limit of 2 GiB");
    files.bytes_read = [](size_t) { return size_t{0}; };
    expect_read(FLG_ERROR_FILE, "0 of ");
    files.bytes_read = [](size_t size) { return size + 5000; };
    expect_read(FLG_ERROR_FILE, "the host's read gave");
    // What the host's functions return is the call's result: an error is not the end of the file.
    files.size_result = FLG_ERROR_CANCELLED;
    expect_read(FLG_ERROR_CANCELLED, "can't be read: the host's size returned -5");
    files.read_result = FLG_ERROR_OUT_OF_MEMORY;
    expect_read(FLG_ERROR_OUT_OF_MEMORY, "can't be read: the host's read returned");
    files.read_result = FLG_NOT_READY;
    expect_read(FLG_ERROR_FILE, "can't be read: the host's read returned 1");
    std::string bytes;
    EXPECT_EQ(read_curves("none.xyz", &host.hooks, bytes), FLG_ERROR_FILE);
    EXPECT_STREQ(flgIoErrorGetMessage(), "none.xyz: can't be opened: the host's open returned -7");

    files.write_result = FLG_ERROR_FILE;
    EXPECT_EQ(write_curves("a.xyz", &host.hooks), FLG_ERROR_FILE);
    EXPECT_STREQ(flgIoErrorGetMessage(), "a.xyz: can't be written: the host's write returned -7");
    files.write_result = FLG_OK;
    files.close_result = FLG_ERROR_FILE;
    EXPECT_EQ(write_curves("a.xyz", &host.hooks), FLG_ERROR_FILE);
    EXPECT_STREQ(flgIoErrorGetMessage(), "a.xyz: can't be written: the host's close returned -7");
    files.close_result = FLG_OK;
    EXPECT_TRUE(files.files["a.xyz"] == before);
}

TEST(FileHooks, NoPathLeadsOutOfTheDocumentsFolder) {
    for (const char* uri : {"../a.bin", "/a.bin", "b/../../a.bin", "%2e%2e/a.bin", "c:a.bin", "b\\a.bin"}) {
        Host host;
        Document document;
        document.uri = uri;
        host.files.files["in/a.gltf"] = document.text();
        std::string bytes;
        EXPECT_EQ(read_curves("in/a.gltf", &host.hooks, bytes), FLG_ERROR_FORMAT) << uri;
        EXPECT_EQ(host.files.asked.size(), 1u) << *host.files.asked.rbegin();
    }
}

TEST(FileHooks, TheSideFileOfADocumentBeforeIsRemoved) {
    Host host;
    ASSERT_EQ(write_tangles("t/a.json", &host.hooks), FLG_OK);
    ASSERT_EQ(host.files.files.size(), 2u);
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    FlgTangleFileWriteDesc desc = flgTangleFileWriteDefaults();
    desc.hooks = &host.hooks;
    ASSERT_EQ(flgTangleFileWrite("t/a.json", &history, &desc), FLG_OK);
    EXPECT_EQ(host.files.files.size(), 1u);
}

TEST(FileHooks, WrongHooksAreNamed) {
    Host host;
    std::string bytes;
    const auto expect_refused = [&](const FlgFileHooks& hooks, const char* sentence) {
        EXPECT_EQ(write_curves("a.xyz", &hooks), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_STREQ(flgIoErrorGetMessage(), sentence);
    };
    const auto with_files = [&](auto change, const char* sentence) {
        FlgFileSystem files = host.files.hook;
        change(files);
        FlgFileHooks hooks = host.hooks;
        hooks.files = &files;
        expect_refused(hooks, sentence);
    };
    with_files([](FlgFileSystem& f) { f.open = nullptr; }, "a.xyz:hooks.files.open: is null");
    with_files([](FlgFileSystem& f) { f.size = nullptr; }, "a.xyz:hooks.files.size: is null");
    with_files([](FlgFileSystem& f) { f.read = nullptr; }, "a.xyz:hooks.files.read: is null");
    with_files([](FlgFileSystem& f) { f.write = nullptr; }, "a.xyz:hooks.files.write: is null");
    with_files([](FlgFileSystem& f) { f.close = nullptr; }, "a.xyz:hooks.files.close: is null");
    with_files([](FlgFileSystem& f) { f.reserved = 1; }, "a.xyz: hooks.files.reserved is 1, must be 0");
    FlgFileHooks hooks = host.hooks;
    hooks.reserved = 7;
    expect_refused(hooks, "a.xyz: hooks.reserved is 7, must be 0");
    hooks = host.hooks;
    FlgAllocator half = host.memory.hook;
    half.free = nullptr;
    hooks.allocator = &half;
    expect_refused(hooks, "a.xyz:hooks.allocator.free: is null, but the other function is not");
    half = host.memory.hook;
    half.allocate = nullptr;
    expect_refused(hooks, "a.xyz:hooks.allocator.allocate: is null, but the other function is not");
    hooks = host.hooks;
    hooks.struct_size = 3;
    EXPECT_EQ(write_curves("a.xyz", &hooks), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(host.files.asked.size(), 0u);
    EXPECT_EQ(host.memory.calls, 0);

    const FlgFileSystem none = flgFileSystemDefaults();
    const FlgFileHooks defaults = flgFileHooksDefaults();
    EXPECT_EQ(none.struct_size, sizeof none);
    EXPECT_EQ(none.open, nullptr);
    EXPECT_EQ(defaults.allocator, nullptr);
    EXPECT_EQ(defaults.files, nullptr);
    EXPECT_EQ(flgFileHooksInit(nullptr, sizeof hooks), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgFileSystemInit(nullptr, sizeof none), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(read_curves("a.xyz", &host.hooks, bytes), FLG_ERROR_FILE);

    // A file keeps its allocator.
    ASSERT_EQ(write_curves("a.xyz", &host.hooks), FLG_OK);
    FlgCurveFile file = nullptr;
    {
        const FlgAllocator allocator = host.memory.hook;
        hooks = {sizeof hooks, 0, &allocator, &host.files.hook};
        FlgCurveFileReadDesc desc = flgCurveFileReadDefaults();
        desc.hooks = &hooks;
        ASSERT_EQ(flgCurveFileRead("a.xyz", &desc, &file), FLG_OK);
    }
    hooks = {};
    EXPECT_GT(host.memory.live, 0);
    flgCurveFileRelease(file);
    EXPECT_EQ(host.memory.live, 0);
}

}  // namespace
}  // namespace flg::test
