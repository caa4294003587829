// SPDX-License-Identifier: MIT
#include "tangles/history_text.h"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "tangle.json";
constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// A folder of its own that goes with this.
class Folder {
public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "filigree-studio-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr)
            throw StudioError("Cannot create a temporary folder: " + pattern + ".");
        path_ = pattern;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    fs::path file(const std::string& name) const { return path_ / name; }
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string encode(const std::string& bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t word = 0;
        for (size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

std::string decode(const std::string& text) {
    std::array<int, 256> value;
    value.fill(-1);
    for (int d = 0; d < 64; ++d) value[static_cast<uint8_t>(kDigits[d])] = d;
    std::string bytes;
    uint32_t word = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        const int digit = value[static_cast<uint8_t>(c)];
        if (digit < 0) throw StudioError("The ornament in the document is damaged.");
        word = word << 6 | static_cast<uint32_t>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(word >> bits & 0xffu);
    }
    return bytes;
}

void check_io(FlgResult result) {
    if (result != FLG_OK) throw StudioError(flgIoErrorGetMessage());
}

}  // namespace

nlohmann::json history_to_json(const FlgTangleHistory& history) {
    const Folder folder;
    check_io(flgTangleFileWrite(folder.file(kName).c_str(), &history, nullptr));
    nlohmann::json json = {{"document", nlohmann::json::parse(contents(folder.file(kName)))}};
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path()))
        if (entry.path().filename() != kName) json["arrays"] = encode(contents(entry.path()));
    return json;
}

HistoryFile history_from_json(const nlohmann::json& json) {
    const Folder folder;
    const nlohmann::json& document = json.at("document");
    if (json.contains("arrays")) {
        // Beside the document, and nowhere else.
        const std::string name = document.at("arrays").at("file").get<std::string>();
        if (name.find('/') != std::string::npos || !name.starts_with(kName))
            throw StudioError("The ornament in the document refers to another file, " + name + ".");
        std::ofstream(folder.file(name), std::ios::binary) << decode(json.at("arrays").get<std::string>());
    }
    std::ofstream(folder.file(kName)) << document.dump();
    return read_history(folder.file(kName).string());
}

HistoryFile read_history(const std::string& path) {
    FlgTangleFile read = nullptr;
    check_io(flgTangleFileRead(path.c_str(), nullptr, &read));
    return {read, flgTangleFileRelease};
}

FlgTangleHistory history_of(const HistoryFile& file) {
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    check_io(flgTangleFileGetHistory(file.get(), &history));
    return history;
}

}  // namespace flg::studio
