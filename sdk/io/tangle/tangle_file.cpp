// SPDX-License-Identifier: MIT
// The C ABI of tangles' documents, translated onto this room; and how the two files of a document are saved as one.
//
// The side file's name has the checksum of its bytes in it, and the JSON, which names it, is renamed into its place
// last: a save that is cut short anywhere leaves the document as it was, at most with a side file too many. A later
// save removes it, once it is ten minutes older than the document: what is younger may be of a save that goes on.
#include <new>
#include <optional>

#include "filigree/filigree_io.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/tangle/tangle_document.h"

struct FlgTangleFileT : flg::io::HostFile {
    FlgTangleFileT(const flg::io::JsonValue& json, flg::io::Bytes arrays) : document(json, arrays) {}
    flg::io::TangleDocument document;
};

namespace flg::io {

namespace {

constexpr uint32_t max_levels = 16;

// The side file of the document that is there now; empty if there is none that can be read.
String present_side_file(const Path& path) {
    try {
        const ByteBlock text = read_file(path, "", max_tangle_json);
        const JsonDocument json(text.bytes(), max_levels);
        return read_side_file(JsonValue(json.root(), "")).name;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return {};
    }
}

// The side file of this name, if it was written with this document.
std::optional<Path> removable(const Path& path, const String& name) {
    const size_t first = path.filename().size() + 1, last = first + 16;  // of the checksum's digits
    if (!name.starts_with(String(path.filename()) + ".") || name.size() <= last || name.substr(last) != ".bin")
        return {};
    if (name.find_first_not_of("0123456789abcdef", first) != last) return {};
    return path.beside(name);
}

void save(const Path& path, const TangleText& text) {
    const String before = present_side_file(path);
    // All memory is taken before the first file is written.
    const std::optional<Path> side = removable(path, text.side.name);
    Vector<Path> obsolete;
    const auto add_obsolete = [&](const String& name) {
        if (name == text.side.name) return;
        if (const std::optional<Path> file = removable(path, name)) obsolete.push_back(*file);
    };
    add_obsolete(before);
    for (const String& name : older_companions(path)) add_obsolete(name);
    if (side) write_file(*side, text.arrays);
    try {
        write_file(path, text.json);
    } catch (...) {
        if (side && text.side.name != before) remove_file(*side);
        throw;
    }
    for (const Path& file : obsolete) remove_file(file);
}

ByteBlock read_arrays(const Path& path, const SideFile& side) {
    if (side.name.empty()) return {};
    ByteBlock block = read_file(path.beside(side.name), "arrays.file");
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
using flg::sized;

extern "C" {

const char* flgTangleOperatorGetName(uint32_t number) {
    return number < std::size(operator_words) ? operator_words[number] : nullptr;
}

const char* flgTangleMacroGetName(uint32_t number) {
    return number < std::size(macro_words) ? macro_words[number] : nullptr;
}

FlgResult flgTangleFileReadDescInit(FlgTangleFileReadDesc* desc, uint32_t struct_size) {
    return init("flgTangleFileReadDescInit", desc, struct_size, sized<FlgTangleFileReadDesc>());
}

FlgResult flgTangleFileWriteDescInit(FlgTangleFileWriteDesc* desc, uint32_t struct_size) {
    return init("flgTangleFileWriteDescInit", desc, struct_size, sized<FlgTangleFileWriteDesc>());
}

FlgResult flgTangleFileWrite(const char* path, const FlgTangleHistory* history, const FlgTangleFileWriteDesc* desc) {
    return write_to("flgTangleFileWrite", path, desc, [&](const Path& target) {
        if (desc) read_given(desc, "desc");
        const FlgTangleHistory given = read_given(history, "history");
        // The side file is beside the JSON, also where that is reached by a link.
        const Path place = resolved(target);
        save(place, write_tangle(given, String(place.filename())));
    });
}

FlgResult flgTangleFileRead(const char* path, const FlgTangleFileReadDesc* desc, FlgTangleFile* out_file) {
    return read_into(out_file, "flgTangleFileRead", path, desc, [](const Path& source) {
        const Path place = resolved(source);
        const ByteBlock text = read_file(place, "", max_tangle_json);
        const JsonDocument json(text.bytes(), max_levels);
        const JsonValue document(json.root(), "");
        const ByteBlock arrays = read_arrays(place, read_side_file(document));
        return make_owned<FlgTangleFileT>(document, arrays.bytes());
    });
}

FlgResult flgTangleFileGetHistory(FlgTangleFile file, FlgTangleHistory* out_history) {
    return show("flgTangleFileGetHistory", file, out_history, "out_history",
                [](const FlgTangleFileT& shown) { return shown.document.history(); });
}

void flgTangleFileRelease(FlgTangleFile file) {
    release(file);
}

}  // extern "C"
