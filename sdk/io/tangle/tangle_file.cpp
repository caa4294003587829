// SPDX-License-Identifier: MIT
// The C ABI of tangles' documents, translated onto this room; and how the two files of a document are saved as one.
//
// The side file's name has the checksum of its bytes in it, and the JSON, which names it, is renamed into its place
// last: a save that is cut short anywhere leaves the document as it was, at most with a side file too many.
#include <memory>

#include "filigree/filigree_io.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/tangle/tangle_document.h"

struct FlgTangleFileT {
    FlgTangleFileT(const flg::io::JsonValue& json, flg::io::Bytes arrays) : document(json, arrays) {}
    flg::io::TangleDocument document;
};

namespace flg::io {

namespace {

constexpr int most_levels = 16;

// Where the JSON is: its side file is beside it, also when it is reached by a link.
std::filesystem::path place_of(const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(path);
}

// The side file of the document that is there now; empty if there is none that can be read.
std::string present_side_file(const std::filesystem::path& path) {
    try {
        const ByteBlock text = read_file(path, "", max_tangle_json);
        const JsonValue::Json json = JsonValue::parse(text.bytes(), most_levels);
        return read_side_file(JsonValue(json, "")).name;
    } catch (const std::exception&) {
        return {};
    }
}

void remove_side_file(const std::filesystem::path& path, const std::string& name) {
    // Only such as were written with this document.
    const std::string file = path.filename().string();
    if (!name.starts_with(file + ".") || !name.ends_with(".bin")) return;
    std::error_code ignored;
    std::filesystem::remove(path.parent_path() / name, ignored);
}

void save(const std::filesystem::path& path, const TangleText& text) {
    const std::string before = present_side_file(path);
    if (!text.side.name.empty()) write_file(path.parent_path() / text.side.name, text.arrays);
    try {
        write_file(path, text.json);
    } catch (...) {
        if (text.side.name != before) remove_side_file(path, text.side.name);
        throw;
    }
    if (before != text.side.name) remove_side_file(path, before);
}

ByteBlock read_arrays(const std::filesystem::path& path, const SideFile& side) {
    if (side.name.empty()) return {};
    ByteBlock block = read_file(path.parent_path() / side.name, "arrays.file");
    if (block.size() != side.bytes) {
        fail(FLG_ERROR_FORMAT, "arrays.bytes", "is %llu, but %s has %zu bytes",
             static_cast<unsigned long long>(side.bytes), cited(side.name).c_str(), block.size());
    }
    if (checksum_of(block.bytes()) != side.checksum) {
        fail(FLG_ERROR_FORMAT, "arrays.checksum", "is not that of %s", cited(side.name).c_str());
    }
    return block;
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;

extern "C" {

const char* flgTangleOperatorGetName(uint32_t number) {
    return number < std::size(operator_words) ? operator_words[number] : nullptr;
}

const char* flgTangleMacroGetName(uint32_t number) {
    return number < std::size(macro_words) ? macro_words[number] : nullptr;
}

FlgResult flgTangleFileWrite(const char* path, const FlgTangleHistory* history) {
    return guarded_path("flgTangleFileWrite", path, [&](const std::filesystem::path& target) {
        const FlgTangleHistory given = read_given(history, "history");
        const std::filesystem::path place = place_of(target);
        save(place, write_tangle(given, place.filename().string()));
    });
}

FlgResult flgTangleFileRead(const char* path, FlgTangleFile* out_file) {
    return read_into(out_file, "flgTangleFileRead", path, [](const std::filesystem::path& source) {
        const std::filesystem::path place = place_of(source);
        const ByteBlock text = read_file(place, "", max_tangle_json);
        const JsonValue::Json json = JsonValue::parse(text.bytes(), most_levels);
        const JsonValue document(json, "");
        const ByteBlock arrays = read_arrays(place, read_side_file(document));
        return std::make_unique<FlgTangleFileT>(document, arrays.bytes());
    });
}

FlgResult flgTangleFileGetHistory(FlgTangleFile file, FlgTangleHistory* out_history) {
    return show("flgTangleFileGetHistory", file, out_history, "out_history",
                [](const FlgTangleFileT& shown) { return shown.document.history(); });
}

void flgTangleFileRelease(FlgTangleFile file) {
    delete file;
}

}  // extern "C"
