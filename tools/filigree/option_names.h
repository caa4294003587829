// SPDX-License-Identifier: MIT
// The SDK's sentences name what its functions take; who uses a command knows its options.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flg::cli {

// With the names of `stylize` and `replay` in the place of descriptors' fields. `drives`: as --drive was given.
std::string in_option_names(const std::string& sentence, const std::vector<std::string>& drives);

// Runs it, and passes InputErrors on in these names.
void with_option_names(const std::vector<std::string>& drives, const std::function<void()>& run);

}  // namespace flg::cli
