// SPDX-License-Identifier: MIT
// Pictures compared as an eye would: a few pixels at edges may differ, what is seen may not.
#pragma once

#include <filesystem>
#include <string>

namespace flg::test {

struct Difference {
    double mean;   // of all channels of all pixels, 0 to 255
    double block;  // of the mean colours of 16 x 16 pixels: the largest, 0 to 255
};

// Of two PNG files of the same size; throws std::runtime_error for others. Each is averaged down by its factor first.
Difference compare_pictures(const std::filesystem::path& a, const std::filesystem::path& b, int down_a = 1,
                            int down_b = 1);

}  // namespace flg::test
