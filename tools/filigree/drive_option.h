// SPDX-License-Identifier: MIT
// What --drive says: NAME[:FROM:TO]=WHAT:A:B, a column of the curves and what it does to the style along them.
#pragma once

#include <string>

#include "filigree/filigree.h"

namespace flg::cli {

// Throws CLI::ValidationError.
FlgStyleDrive parse_drive(const std::string& text);

}  // namespace flg::cli
