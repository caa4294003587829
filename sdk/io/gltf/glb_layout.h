// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification, 4.4: the numbers at the head of a .glb file and of its chunks.
#pragma once

#include <cstdint>

namespace flg::io {

constexpr uint32_t glb_magic = 0x46546c67;   // "glTF"
constexpr uint32_t glb_json = 0x4e4f534a;    // "JSON"
constexpr uint32_t glb_binary = 0x004e4942;  // "BIN\0"
constexpr uint32_t glb_version = 2;

}  // namespace flg::io
