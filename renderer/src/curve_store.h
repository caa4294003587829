// SPDX-License-Identifier: MIT
// Everything uploaded, on the device; and drawing it.
#pragma once

#include <memory>

#include "chunk_select.h"
#include "device_store.h"
#include "frame.h"
#include "growing_curve.h"
#include "upload_ring.h"

namespace flg::render {

// The index lists of all numbers of columns, for the longest chunk; a shorter one uses the beginning of its list.
class IndexPatterns {
public:
    IndexPatterns(UploadRing& ring);
    VkBuffer buffer() const { return buffer_.handle(); }
    uint32_t first_index(uint32_t columns) const { return first_[columns]; }
    static uint32_t index_count(uint32_t columns, uint32_t segments) {
        return 6 * segments * (columns == 2 ? 1 : columns);
    }

private:
    Buffer buffer_;
    uint32_t first_[33] = {};
};

// As many curves as buffers of the device can hold, and what the host keeps to choose from them.
struct DevicePart {
    DevicePart(CurveData curve_data, VkDevice of_device) : data(std::move(curve_data)), device(of_device) {}
    DevicePart(DevicePart&& other) noexcept;
    ~DevicePart();

    CurveData data;  // without its points, but for a growing curve
    VkDevice device;
    Buffer centers, looks, chunks, displacements;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;

    void bind(const Pipelines& pipelines);
};

// One upload.
struct DeviceCurves {
    // `max_points`: of a part; 0: as many as the device's buffers hold.
    DeviceCurves(DeviceMemory& memory, UploadRing& ring, const Pipelines& pipelines, const FlgCurveSetView& view,
                 const CurveLook& look, uint32_t max_points);
    // For a curve that grows.
    DeviceCurves(DeviceMemory& memory, const Pipelines& pipelines, const CurveLook& look, uint32_t capacity);
    DeviceCurves(const DeviceCurves&) = delete;
    DeviceCurves& operator=(const DeviceCurves&) = delete;

    CurveLook look;
    std::vector<DevicePart> parts;          // of a growing curve one; none if there are no points
    std::unique_ptr<GrowingCurve> growing;  // its data is the part's
    float magnitude_offset = 0.0f;
    bool visible = true;

    void add_targets(UploadTargets& targets) const;
    bool has_displacements() const { return !parts.empty() && parts.front().data.has_displacements; }
    Box box() const;
};

// Of all curves, what one view draws.
struct DrawList {
    struct Item {
        const DeviceCurves* curves;
        VkDescriptorSet set;  // of a part
        uint32_t first_bin;
        uint32_t bin_count;
    };
    std::vector<Item> items;
    std::vector<DrawBin> bins;
    void clear() {
        items.clear();
        bins.clear();
    }
};

class CurveStore : public DeviceStore<DeviceCurves> {
public:
    explicit CurveStore(UploadRing& ring) : DeviceStore("curves", ring) {}

    void set_magnitude_offset(CurvesId id, float offset);
    // Throws Error for curves that don't grow.
    GrowingCurve& growing(CurvesId id);
    // What has been appended since the last frame, to go with the next. On error it stays to be uploaded.
    void upload_growth();
    Box bounds() const;
    void select(std::span<const ViewUniforms> views, bool shadow, DrawList& list,
                std::vector<uint32_t>& instances) const;
};

// What a list is drawn into.
struct CurvePass {
    const VkViewport* viewport = nullptr;  // the main pass's, which stays as it is; null: the shadow map's
    Eyes eyes = Eyes::one;
};

// Records a list into a render pass; returns the triangles drawn.
uint64_t record_curves(VkCommandBuffer commands, const Pipelines& pipelines, const IndexPatterns& patterns,
                       const DrawList& list, VkBuffer instances, const CurvePass& pass);

}  // namespace flg::render
