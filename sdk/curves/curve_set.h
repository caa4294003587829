// SPDX-License-Identifier: MIT
// Curves in flat arrays, as jobs make and read them and as the host sees them.
#pragma once

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "core/memory.h"
#include "core/origin.h"
#include "filigree/filigree.h"
#include "runtime/product.h"

namespace flg {

struct Column {
    FlgAttribute attribute;
    uint32_t components;
    Buffer<float> values;
};

// A set never changes once it is complete; until then only the job that makes it touches its data, and curve by curve
// it says what is complete. What the host sees of it (view) changes on the host's thread only.
class CurveSet final : public Product {
public:
    explicit CurveSet(Memory* memory) : memory_(memory), columns_(memory), view_columns_(memory) {}

    Origin origin{};  // of the positions; set before anything else sees the set

    // ---- making one ----

    // Takes memory for the curves' structure; offsets (curve_count + 1) are to be filled in, and every curve to be
    // begun before there are columns.
    void allocate_curves(uint32_t curve_count);
    // Curve `curve` has these flags, and is not complete.
    void begin_curve(uint32_t curve, uint8_t flags) {
        flags_[curve] = flags;
        std::construct_at(&complete_[curve], false);
    }
    // Takes memory for columns of offsets[curve_count] points, the first one POSITION. The values are not initialized.
    struct ColumnLayout {
        FlgAttribute attribute;
        uint32_t components;
    };
    void allocate_columns(const std::pmr::vector<ColumnLayout>& layout);
    // Takes memory for one scale a curve, which are to be filled in.
    Buffer<float>& allocate_scales();
    // Curve `curve` will not change any more. Any thread.
    void complete_curve(uint32_t curve) { complete_[curve].store(true, std::memory_order_release); }

    // ---- reading ----

    uint32_t curve_count() const { return curve_count_; }
    uint32_t point_count() const { return curve_count_ == 0 ? 0 : offsets_[curve_count_]; }
    Buffer<uint32_t>& offsets() { return offsets_; }
    const Buffer<uint32_t>& offsets() const { return offsets_; }
    const Buffer<uint8_t>& flags() const { return flags_; }
    bool closed(uint32_t curve) const { return (flags_[curve] & FLG_CURVE_CLOSED) != 0; }
    std::pmr::vector<Column>& columns() { return columns_; }
    const std::pmr::vector<Column>& columns() const { return columns_; }
    // Null if there is none.
    const Column* find(FlgAttribute attribute) const;
    Column* find(FlgAttribute attribute) { return const_cast<Column*>(std::as_const(*this).find(attribute)); }
    // In which size a style was drawn on each curve; none in other sets.
    FlgCurveSetScales scales() const;
    const float* positions() const { return columns_.front().values.data(); }

    // ---- what the host sees ----

    void publish_partial() noexcept override;
    const FlgCurveSetView& view() const { return view_; }

private:
    void show() noexcept override { show_curves(curve_count_); }
    void show_curves(uint32_t curves) noexcept;

    Memory* memory_;
    uint32_t curve_count_ = 0;
    Buffer<uint32_t> offsets_;
    Buffer<uint8_t> flags_;
    Buffer<float> scales_;
    std::pmr::vector<Column> columns_;
    Buffer<std::atomic<bool>> complete_;
    std::atomic<bool> laid_out_{false};  // all arrays are there, though not their values

    uint32_t visible_curves_ = 0;
    std::pmr::vector<FlgColumn> view_columns_;
    FlgCurveSetView view_{};
};

}  // namespace flg
