// SPDX-License-Identifier: MIT
// What a window manager and a file manager tell a program's window: messages of X that no key and no button make.
#pragma once

#include <string>
#include <vector>

namespace flg::test {

// The close button of the only window on this display was pressed. Throws if there is none.
void send_close(const std::string& display);

// Files were dropped on it (Xdnd, version 5), at a place of the screen. Returns once it has them.
void drop_files(const std::string& display, int x, int y, const std::vector<std::string>& paths);

}  // namespace flg::test
