// SPDX-License-Identifier: MIT
// How columns are named in files, as properties of PLY vertices and behind `# columns` in .xyz; filigree_io.h lists
// them.
#pragma once

#include <span>
#include <string_view>

#include "filigree/filigree.h"
#include "io/base/memory.h"

namespace flg::io {

struct VertexColumn {
    FlgAttribute attribute;
    uint32_t components;
    Vector<float> values;
};

String column_name(FlgAttribute attribute, uint32_t components, uint32_t component);

// The columns besides positions that these names make up, at most 15, still without values. Names that make up none are
// passed over.
Vector<VertexColumn> columns_of_names(std::span<const std::string_view> names);

// What an attribute's value breaks, such as "must be >= 0"; null: nothing.
const char* rule_broken_by(FlgAttribute attribute, uint32_t component, float value);

}  // namespace flg::io
