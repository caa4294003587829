// SPDX-License-Identifier: MIT
// What the tests of io share: a folder of their own, files with given bytes, and read curves.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "filigree/filigree_io.h"

namespace flg::test {

// A folder that only this test uses; gone with it.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "filigree-io-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string at(std::string_view name) const { return (path_ / name).string(); }
    std::string put(std::string_view name, std::string_view content) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        // Removed first: some file systems write to the disk when a file is written over.
        std::filesystem::remove(path_ / name);
        std::ofstream(path_ / name, std::ios::binary)
            .write(content.data(), static_cast<std::streamsize>(content.size()));
        return at(name);
    }
    size_t entries() const {
        return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

// A struct of the ABI that knows its size.
template <class T>
T sized() {
    T made = {};
    made.struct_size = sizeof made;
    return made;
}

inline std::string slurp(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A file read, with its arrays copied out.
struct Read {
    FlgResult result = FLG_OK;
    std::string error;
    std::vector<uint32_t> offsets;
    std::vector<uint8_t> flags;
    std::map<FlgAttribute, std::vector<float>> columns;
    std::vector<float> none;
    std::vector<FlgStroke> strokes;
    std::string warnings, format, units;

    const std::vector<float>& column(FlgAttribute attribute) const {
        const auto found = columns.find(attribute);
        return found == columns.end() ? none : found->second;
    }
    const std::vector<float>& positions() const { return column(FLG_ATTRIBUTE_POSITION); }
};

inline Read read(const std::string& path) {
    Read read;
    FlgCurveFile file = nullptr;
    read.result = flgCurveFileRead(path.c_str(), nullptr, &file);
    if (read.result != FLG_OK) {
        EXPECT_EQ(file, nullptr);
        read.error = flgIoErrorGetMessage();
        EXPECT_EQ(read.error.rfind(path, 0), 0u) << read.error;
        return read;
    }
    FlgCurveSetView view = {};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgCurveFileGetView(file, &view), FLG_OK);
    read.offsets.assign(view.curve_offsets, view.curve_offsets + view.curve_count + 1);
    read.flags.assign(view.curve_flags, view.curve_flags + view.curve_count);
    for (uint32_t i = 0; i < view.column_count; ++i) {
        const FlgColumn& column = view.columns[i];
        read.columns[column.attribute].assign(column.data, column.data + read.offsets.back() * column.components);
    }
    FlgCurveFileInfo info = {};
    info.struct_size = sizeof info;
    EXPECT_EQ(flgCurveFileGetInfo(file, &info), FLG_OK);
    read.format = info.format;
    read.units = info.units;
    for (uint32_t i = 0; i < info.warning_count; ++i) read.warnings += std::string(info.warnings[i]) + "\n";
    read.strokes.resize(info.stroke_count, flgStrokeDefaults());
    for (uint32_t i = 0; i < info.stroke_count; ++i) {
        EXPECT_EQ(flgCurveFileGetStroke(file, i, &read.strokes[i]), FLG_OK);
    }
    flgCurveFileRelease(file);
    return read;
}

// Curves to be written.
struct Curves {
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> flags;
    std::vector<float> positions, radii, colors, tangents, normals;
    std::vector<FlgColumn> columns;

    void add(std::initializer_list<float> points, bool closed = false) {
        positions.insert(positions.end(), points);
        end(closed);
    }
    void end(bool closed = false) {
        offsets.push_back(static_cast<uint32_t>(positions.size() / 3));
        flags.push_back(closed ? FLG_CURVE_CLOSED : 0);
    }
    FlgCurveSetView view() {
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
        if (!radii.empty()) columns.push_back({FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0});
        if (!colors.empty()) columns.push_back({FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0});
        if (!tangents.empty()) columns.push_back({FLG_ATTRIBUTE_TANGENT, 3, tangents.data(), 0, 0});
        if (!normals.empty()) columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0});
        FlgCurveSetView view = {};
        view.struct_size = sizeof view;
        view.curve_count = static_cast<uint32_t>(flags.size());
        view.curve_offsets = offsets.data();
        view.curve_flags = flags.data();
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        return view;
    }
};

inline FlgResult write(const std::string& path, Curves& curves, const FlgCurveFileWriteDesc* desc = nullptr) {
    const FlgCurveSetView view = curves.view();
    return flgCurveFileWrite(path.c_str(), &view, desc);
}

// Refused with this result and a sentence that starts with FILE:place and holds `reason`.
inline void expect_refused(const std::string& path, FlgResult result, const std::string& place,
                           const std::string& reason) {
    const Read refused = read(path);
    EXPECT_EQ(refused.result, result) << refused.error;
    EXPECT_EQ(refused.error.rfind(path + (place.empty() ? "" : ":" + place) + ": ", 0), 0u) << refused.error;
    EXPECT_NE(refused.error.find(reason), std::string::npos) << refused.error;
}

}  // namespace flg::test
