// SPDX-License-Identifier: MIT
// One function a group, each in a file of its own.
#pragma once

#include "bench/bench.h"

namespace flg::bench {

std::vector<Row> run_thomas();
std::vector<Row> run_prepare();
std::vector<Row> run_ticks();
std::vector<Row> run_growth();

}  // namespace flg::bench
