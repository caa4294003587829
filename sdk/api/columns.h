// SPDX-License-Identifier: MIT
// Columns of a host's arrays, of curve sets and meshes alike: checked, and copied.
#pragma once

#include <cstdint>

#include "filigree/filigree.h"

namespace flg {

constexpr uint32_t max_columns = 16;
constexpr uint32_t max_user_components = 16;

// Numbers a row that an attribute has; 0 for user attributes, which choose, and -1 for numbers that mean nothing.
int components_of(int32_t attribute);

// Whose columns: those of points have positions, and nothing that only results have.
enum class ColumnsOf { points, any };

// Refuses what is no set of columns; sentences name `owner`.columns.
void check_columns(const FlgColumn* columns, uint32_t count, const char* owner, ColumnsOf whose = ColumnsOf::points);

// A value that can't be; its rule is null if there is none.
struct BadValue {
    uint32_t row = 0;
    float value = 0;
    const char* rule = nullptr;
};

// Copies rows first to end - 1 of a column that was checked to `out`, tightly packed from its beginning on; stops at a
// value that can't be.
BadValue copy_column(const FlgColumn& column, uint32_t first, uint32_t end, float* out);

// Null if there is none.
const FlgColumn* find_column(const FlgColumn* columns, uint32_t count, FlgAttribute attribute);

}  // namespace flg
