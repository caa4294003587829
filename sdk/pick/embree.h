// SPDX-License-Identifier: MIT
// Embree's objects, released when they go out of scope, and its errors as ours.
#pragma once

#include <embree3/rtcore.h>

#include <memory>

#include "core/failure.h"

namespace flg::pick {

struct Releases {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, Releases>;
using Scene = std::unique_ptr<RTCSceneTy, Releases>;
using Geometry = std::unique_ptr<RTCGeometryTy, Releases>;

inline void check(RTCDevice device, const char* action) {
    switch (const RTCError error = rtcGetDeviceError(device)) {
        case RTC_ERROR_NONE: return;
        case RTC_ERROR_OUT_OF_MEMORY: throw Failure(FLG_ERROR_OUT_OF_MEMORY, "no memory is left to %s", action);
        default: throw Failure(FLG_ERROR_INTERNAL, "Embree can't %s: error %d", action, static_cast<int>(error));
    }
}

// A buffer of `geometry` to be filled in; Embree owns it.
template <class T>
T* make_buffer(RTCDevice device, const Geometry& geometry, RTCBufferType type, RTCFormat format, size_t count) {
    void* buffer = rtcSetNewGeometryBuffer(geometry.get(), type, 0, format, sizeof(T), count);
    check(device, "take memory for a geometry");
    if (!buffer) throw Failure(FLG_ERROR_OUT_OF_MEMORY, "no memory is left for a geometry of %zu elements", count);
    return static_cast<T*>(buffer);
}

}  // namespace flg::pick
