// SPDX-License-Identifier: MIT
#include "shell/pen.h"

#include <algorithm>
#include <cmath>

#ifdef FLG_STUDIO_XINPUT
#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <map>

// Of GLFW/glfw3native.h, which wants headers of more of X than is used here.
extern "C" Window glfwGetX11Window(GLFWwindow* window);
#endif

namespace flg::studio {

float pressure_of(double value, double low, double high) {
    if (!(high > low) || !std::isfinite(value)) return 1.0f;
    return static_cast<float>(std::clamp((value - low) / (high - low), 0.0, 1.0));
}

#ifdef FLG_STUDIO_XINPUT

namespace {

// Where a device tells its pressure.
struct Axis {
    int number = 0;
    double low = 0.0, high = 0.0;
};

// Of all devices that have one, by their number.
std::map<int, Axis> pressure_axes(Display* display) {
    std::map<int, Axis> axes;
    const Atom label = XInternAtom(display, "Abs Pressure", True);  // None: no driver has named it yet
    int count = 0;
    XIDeviceInfo* const devices = XIQueryDevice(display, XIAllDevices, &count);
    for (int d = 0; devices != nullptr && d < count; ++d) {
        if (devices[d].use == XIMasterPointer || devices[d].use == XIMasterKeyboard) continue;
        for (int c = 0; c < devices[d].num_classes; ++c) {
            if (devices[d].classes[c]->type != XIValuatorClass) continue;
            const auto& axis = reinterpret_cast<const XIValuatorClassInfo&>(*devices[d].classes[c]);
            if (label != None && axis.label == label) axes[devices[d].deviceid] = {axis.number, axis.min, axis.max};
        }
    }
    if (devices != nullptr) XIFreeDeviceInfo(devices);
    return axes;
}

}  // namespace

struct Pen::State {
    Display* display = nullptr;
    int opcode = 0;
    std::map<int, Axis> axes;
    float pressure = 1.0f;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (display != nullptr) XCloseDisplay(display);
    }

    bool open() {
        int event = 0, error = 0, major = 2, minor = 1;
        display = XOpenDisplay(nullptr);
        if (display == nullptr || !XQueryExtension(display, "XInputExtension", &opcode, &event, &error) ||
            XIQueryVersion(display, &major, &minor) != Success)
            return false;
        look_for_pens();
        return true;
    }

    // Raw events: others of XInput would keep the window's motion from GLFW. Of mice alone they are not asked for.
    void look_for_pens() {
        axes = pressure_axes(display);
        unsigned char all[XIMaskLen(XI_LASTEVENT)] = {}, masters[XIMaskLen(XI_LASTEVENT)] = {};
        XISetMask(all, XI_HierarchyChanged);
        if (!axes.empty()) XISetMask(masters, XI_RawMotion);
        XIEventMask masks[] = {{XIAllDevices, sizeof all, all}, {XIAllMasterDevices, sizeof masters, masters}};
        XISelectEvents(display, DefaultRootWindow(display), masks, 2);
    }

    void take(const XGenericEventCookie& cookie) {
        if (cookie.evtype == XI_HierarchyChanged) {
            look_for_pens();
            return;
        }
        const auto& moved = *static_cast<const XIRawEvent*>(cookie.data);
        const auto found = axes.find(moved.sourceid);
        if (found == axes.end()) {
            pressure = 1.0f;
            return;
        }
        const Axis& axis = found->second;
        if (axis.number >= 8 * moved.valuators.mask_len || !XIMaskIsSet(moved.valuators.mask, axis.number)) return;
        // Values are there for set bits only.
        const double* value = moved.valuators.values;
        for (int n = 0; n < axis.number; ++n)
            if (XIMaskIsSet(moved.valuators.mask, n)) ++value;
        pressure = pressure_of(*value, axis.low, axis.high);
    }
};

Pen::Pen(GLFWwindow* window) {
    if (window == nullptr || glfwGetX11Window(window) == None) return;
    state_ = std::make_unique<State>();
    if (!state_->open()) state_.reset();
}

float Pen::pressure() {
    if (state_ == nullptr) return 1.0f;
    while (XPending(state_->display) > 0) {
        XEvent event;
        XNextEvent(state_->display, &event);
        if (event.xcookie.extension != state_->opcode || !XGetEventData(state_->display, &event.xcookie)) continue;
        state_->take(event.xcookie);
        XFreeEventData(state_->display, &event.xcookie);
    }
    return state_->pressure;
}

#else

struct Pen::State {};

Pen::Pen(GLFWwindow*) {}

float Pen::pressure() {
    return 1.0f;
}

#endif

Pen::~Pen() = default;

}  // namespace flg::studio
