// SPDX-License-Identifier: MIT
// What libFuzzer's targets share: bytes as a file, and demands that end the process, so that what broke them is kept.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "filigree/filigree.h"

namespace flg::fuzz {

inline void demand(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "not so: %s\n", what);
    std::abort();
}
#define FLG_DEMAND(...) flg::fuzz::demand(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__)

// A file of this process's own, with other bytes each time; extension with its point.
class InputFile {
public:
    explicit InputFile(const std::string& extension)
        : path_((std::filesystem::temp_directory_path() / ("filigree_fuzz_" + std::to_string(getpid()) + extension))
                    .string()) {}
    ~InputFile() { std::remove(path_.c_str()); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const char* holding(const uint8_t* data, size_t size) const {
        std::FILE* file = std::fopen(path_.c_str(), "wb");
        FLG_DEMAND(file != nullptr && std::fwrite(data, 1, size, file) == size);
        std::fclose(file);
        return path_.c_str();
    }

private:
    std::string path_;
};

// A reader refuses for one of these reasons, in words.
inline void demand_refusal(FlgResult result, const char* sentence) {
    FLG_DEMAND(result == FLG_ERROR_FORMAT || result == FLG_ERROR_LIMIT || result == FLG_ERROR_FILE);
    FLG_DEMAND(sentence[0] != '\0');
}

}  // namespace flg::fuzz
