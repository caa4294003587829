// SPDX-License-Identifier: MIT
// The library that this room is compiled into: each has symbols of its own, so that a host may link both statically.
#pragma once

#if defined(FLG_IO)
#define FLG_BRUSH_LIBRARY of_io
#else
#define FLG_BRUSH_LIBRARY of_core
#endif
