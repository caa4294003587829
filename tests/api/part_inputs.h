// SPDX-License-Identifier: MIT
// A host that draws parts.
#pragma once

#include "api/host.h"
#include "filigree/filigree_model.h"

namespace flg::test {

class PartHost : public Host {
public:
    using Host::Host;

    FlgPart part(const std::vector<double>& contour) const {
        FlgPartDesc desc = flgPartDefaults();
        FlgContourView drawn = flgContourViewDefaults();
        drawn.points = contour.data();
        drawn.point_count = static_cast<uint32_t>(contour.size() / 2);
        desc.contour = &drawn;
        FlgPart part{};
        EXPECT_EQ(flgPartCreate(context, &desc, &part, nullptr), FLG_OK) << flgErrorGetMessage();
        return part;
    }
};

}  // namespace flg::test
