// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace flg::studio {

// What can't be done, in a sentence for the user; the shell makes a notice of it. Thrown by scene and workspaces from
// any of their functions; they stay as they were.
class StudioError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace flg::studio
