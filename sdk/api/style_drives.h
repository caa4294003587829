// SPDX-License-Identifier: MIT
// What steers a style along its targets, as the host says it.
#pragma once

#include "stylization/steering.h"

namespace flg {

// desc.drives, checked but for the columns.
StyleDrives read_drives(const FlgStyleDrive* drives, uint32_t count);

}  // namespace flg
