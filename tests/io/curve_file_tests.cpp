// SPDX-License-Identifier: MIT
// The functions themselves: arguments, struct sizes, files that are not there or can't be written.
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <limits>

#include "io/files.h"

namespace flg::test {
namespace {

std::string last_error() {
    return flgIoErrorGetMessage();
}

TEST(CurveFile, MissingFilesAndUnknownFormats) {
    const Folder folder;
    expect_refused(folder.at("missing.xyz"), FLG_ERROR_FILE, "", "can't be opened");
    expect_refused(folder.at("missing.tilt"), FLG_ERROR_FILE, "", "can't be opened");
    expect_refused(folder.at("missing.glb"), FLG_ERROR_FILE, "", "can't be opened");
    expect_refused(folder.put("a.doc", "1 2 3"), FLG_ERROR_FORMAT, "", "'.doc' is none of");
    std::filesystem::create_directory(folder.at("b.xyz"));
    expect_refused(folder.at("b.xyz"), FLG_ERROR_FILE, "", "not a regular file");
    EXPECT_EQ(read(folder.put("UPPER.XYZ", "1 2 3")).result, FLG_OK);
}

TEST(CurveFile, NullsAreRefusedAndOutputsCleared) {
    FlgCurveFile file = reinterpret_cast<FlgCurveFile>(1);
    EXPECT_EQ(flgCurveFileRead(nullptr, nullptr, &file), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(file, nullptr);
    EXPECT_EQ(last_error(), "flgCurveFileRead:path: is null");
    EXPECT_EQ(flgCurveFileRead("a.xyz", nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    FlgCurveSetView view = {};
    view.struct_size = sizeof view;
    view.curve_count = 3;
    EXPECT_EQ(flgCurveFileGetView(nullptr, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(view.curve_count, 0u);
    FlgCurveFileInfo info = {};
    info.struct_size = sizeof info;
    info.point_count = 3;
    EXPECT_EQ(flgCurveFileGetInfo(nullptr, &info), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(info.point_count, 0u);
    FlgStroke stroke = flgStrokeDefaults();
    stroke.group = 3;
    EXPECT_EQ(flgCurveFileGetStroke(nullptr, 0, &stroke), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(stroke.group, 0u);
    EXPECT_EQ(flgCurveFileGetStroke(nullptr, 0, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgCurveFileWriteDescInit(nullptr, sizeof(FlgCurveFileWriteDesc)), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgCurveFileWrite("a.xyz", nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(last_error(), "a.xyz:view: is null");
    flgCurveFileRelease(nullptr);
}

TEST(CurveFile, StructSizesAreHonoured) {
    const Folder folder;
    FlgCurveFile file = nullptr;
    ASSERT_EQ(flgCurveFileRead(folder.put("a.xyz", "0 0 0\n0 3 4\n").c_str(), nullptr, &file), FLG_OK);
    // A host of a later version, with a longer struct: what is beyond ours stays.
    struct {
        FlgCurveFileInfo info = {};
        uint64_t beyond = 42;
    } later;
    later.info.struct_size = sizeof later;
    ASSERT_EQ(flgCurveFileGetInfo(file, &later.info), FLG_OK);
    EXPECT_EQ(later.info.struct_size, sizeof later);
    EXPECT_EQ(later.beyond, 42u);
    EXPECT_EQ(later.info.total_length, 5.0f);
    EXPECT_EQ(later.info.box_max[2], 4.0f);
    EXPECT_EQ(later.info.point_count, 2u);
    FlgCurveSetView view = {};
    FlgCurveFileInfo info = {};
    for (const uint32_t size : {0u, 8u}) {
        view.struct_size = info.struct_size = size;
        EXPECT_EQ(flgCurveFileGetView(file, &view), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(last_error().find("struct_size is " + std::to_string(size)), std::string::npos) << last_error();
        EXPECT_EQ(flgCurveFileGetInfo(file, &info), FLG_ERROR_INVALID_ARGUMENT);
        FlgCurveFileWriteDesc desc;
        EXPECT_EQ(flgCurveFileWriteDescInit(&desc, size), FLG_ERROR_INVALID_ARGUMENT);
    }
    flgCurveFileRelease(file);
}

TEST(CurveFile, ViewsThatCannotBeWrittenAreRefused) {
    const Folder folder;
    const std::string path = folder.at("a.xyz");
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0});
    curves.radii = {1, 1};
    const FlgCurveSetView good = curves.view();
    const auto refuse = [&](const FlgCurveSetView& view, const char* place) {
        EXPECT_EQ(flgCurveFileWrite(path.c_str(), &view, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(last_error().rfind(path + ":" + place, 0), 0u) << last_error();
    };
    FlgCurveSetView view = good;
    view.struct_size = 4;
    refuse(view, " view: struct_size is 4");
    view = good;
    view.curve_count = 0;
    refuse(view, "view.curve_count: is 0");
    view = good;
    view.curve_offsets = nullptr;
    refuse(view, "view.curve_offsets: is null");
    const uint32_t falling[] = {0, 0};
    view.curve_offsets = falling;
    refuse(view, "view.curve_offsets[1]: is 0");
    const uint32_t late[] = {1, 2};
    view.curve_offsets = late;
    refuse(view, "view.curve_offsets[0]: is 1");
    view = good;
    view.column_count = 0;
    refuse(view, "view.column_count: is 0");
    view = good;
    view.columns = nullptr;
    refuse(view, "view.columns: is null");
    view = good;
    view.columns = good.columns + 1;
    view.column_count = 1;
    refuse(view, "view.columns: has no FLG_ATTRIBUTE_POSITION");
    const auto refuse_column = [&](FlgColumn column, const char* place) {
        const FlgColumn columns[] = {good.columns[0], column};
        FlgCurveSetView changed = good;
        changed.columns = columns;
        refuse(changed, place);
    };
    refuse_column(good.columns[0], "view.columns[1]: has the same attribute (0)");
    refuse_column({FLG_ATTRIBUTE_COLOR, 3, curves.positions.data(), 0, 0}, "view.columns[1].components: is 3");
    refuse_column({FLG_ATTRIBUTE_RADIUS, 1, nullptr, 0, 0}, "view.columns[1].data: is null");
    refuse_column({FLG_ATTRIBUTE_RADIUS, 1, curves.radii.data(), 2, 0}, "view.columns[1].stride: is 2");
    refuse_column({static_cast<FlgAttribute>(20), 1, curves.radii.data(), 0, 0}, "view.columns[1].attribute: is 20");
    curves.radii[1] = -1;
    refuse(good, "view.columns[1].data: has the radius -1 at point 1");
    curves.radii[1] = 1;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e30f}) {
        curves.positions[4] = bad;
        refuse(good, "view.columns[0].data: has ");
    }
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(CurveFile, DescriptorsAreChecked) {
    const Folder folder;
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0});
    FlgCurveFileWriteDesc good;
    ASSERT_EQ(flgCurveFileWriteDescInit(&good, sizeof good), FLG_OK);
    EXPECT_EQ(good.geometry, FLG_CURVE_GEOMETRY_LINES);
    EXPECT_EQ(good.default_radius, 0.005f);
    EXPECT_EQ(good.tube_sides, 8u);
    const auto refuse = [&](const FlgCurveFileWriteDesc& desc, const char* what) {
        EXPECT_EQ(write(folder.at("a.glb"), curves, &desc), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(last_error().find(what), std::string::npos) << last_error();
    };
    FlgCurveFileWriteDesc desc = good;
    desc.geometry = static_cast<FlgCurveGeometry>(3);
    refuse(desc, "desc.geometry: is 3");
    desc = good;
    desc.tube_sides = 2;
    refuse(desc, "desc.tube_sides: is 2");
    desc.tube_sides = 65;
    refuse(desc, "desc.tube_sides: is 65");
    desc = good;
    desc.default_radius = 0;
    refuse(desc, "desc.default_radius: is 0");
    desc.default_radius = std::numeric_limits<float>::quiet_NaN();
    refuse(desc, "desc.default_radius: is nan");
    desc = good;
    desc.struct_size = 0;
    refuse(desc, "struct_size is 0");
}

TEST(CurveFile, StridedColumnsAreFollowed) {
    const Folder folder;
    const float points[] = {0, 0, 0, 0.5f, 1, 2, 3, 0.25f};
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, points, 16, 0},
                                 {FLG_ATTRIBUTE_RADIUS, 1, points + 3, 16, 0}};
    const uint32_t offsets[] = {0, 2};
    FlgCurveSetView view = {};
    view.struct_size = sizeof view;
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = columns;
    view.column_count = 2;
    ASSERT_EQ(flgCurveFileWrite(folder.at("a.xyz").c_str(), &view, nullptr), FLG_OK) << last_error();
    EXPECT_EQ(slurp(folder.at("a.xyz")), "0 0 0 0.5\n1 2 3 0.25\n");
}

TEST(CurveFile, OutputThatCannotBeWrittenLeavesNothingBehind) {
    const Folder folder;
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0});
    const auto refuse = [&](const std::string& path, FlgResult result, const char* reason) {
        EXPECT_EQ(write(path, curves), result);
        EXPECT_EQ(last_error().rfind(path + ": can't be written", 0), 0u) << last_error();
        EXPECT_NE(last_error().find(reason), std::string::npos) << last_error();
    };
    refuse(folder.at("missing/a.xyz"), FLG_ERROR_FILE, "No such file");
    std::filesystem::create_directory(folder.at("b.xyz"));
    refuse(folder.at("b.xyz"), FLG_ERROR_FILE, "directory");
    folder.put("file", "x");
    refuse(folder.at("file/a.obj"), FLG_ERROR_FILE, "directory");
    refuse(folder.at("a.tilt"), FLG_ERROR_FORMAT, "'.tilt'");
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(CurveFile, FullDiskKeepsTheOldFile) {
    const Folder folder;
    const std::string path = folder.put("a.xyz", "the old one");
    Curves curves;
    curves.positions.assign(30000, 0.123456789f);
    curves.end();
    // As good as a full disk: no file of this process may grow beyond 4 KiB.
    rlimit before = {};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 4096;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const FlgResult result = write(path, curves);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(result, FLG_ERROR_FILE);
    EXPECT_NE(last_error().find("can't be written: File too large"), std::string::npos) << last_error();
    EXPECT_EQ(slurp(path), "the old one");
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_EQ(write(path, curves), FLG_OK);
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_EQ(read(path).positions(), curves.positions);
}

TEST(CurveFile, WritingThroughALinkKeepsTheLink) {
    const Folder folder;
    folder.put("real/old.xyz", "0 0 0\n");
    std::filesystem::create_symlink("real/old.xyz", folder.at("link.xyz"));
    std::filesystem::create_symlink("link.xyz", folder.at("second.xyz"));
    std::filesystem::create_symlink("real/new.xyz", folder.at("dangling.xyz"));
    std::filesystem::create_symlink("round.xyz", folder.at("round.xyz"));
    Curves curves;
    curves.add({1, 2, 3, 4, 5, 6});
    for (const char* name : {"second.xyz", "dangling.xyz"}) {
        ASSERT_EQ(write(folder.at(name), curves), FLG_OK) << flgIoErrorGetMessage();
        EXPECT_TRUE(std::filesystem::is_symlink(folder.at(name)));
    }
    EXPECT_TRUE(std::filesystem::is_symlink(folder.at("link.xyz")));
    for (const char* name : {"real/old.xyz", "real/new.xyz"}) EXPECT_EQ(slurp(folder.at(name)), "1 2 3\n4 5 6\n");
    EXPECT_EQ(write(folder.at("round.xyz"), curves), FLG_ERROR_FILE);
}

TEST(CurveFile, FilesWithoutLinesHaveNoLineToName) {
    const Folder folder;
    expect_refused(folder.put("empty.xyz", ""), FLG_ERROR_FORMAT, "", "the file holds no points");
    expect_refused(folder.put("empty.obj", ""), FLG_ERROR_FORMAT, "", "the file holds no lines");
}

}  // namespace
}  // namespace flg::test
