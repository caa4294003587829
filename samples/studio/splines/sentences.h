// SPDX-License-Identifier: MIT
// The SDK's sentences about points, keys and obstacles, by the numbers and names that the user sees.
#pragma once

#include <string>
#include <vector>

#include "splines/model.h"

namespace flg::studio::splines {

// The SDK counts from 0, pictures from 1; its arguments have names of their own.
std::string in_words(const std::string& sentence, const std::vector<Obstacle>& obstacles);

}  // namespace flg::studio::splines
