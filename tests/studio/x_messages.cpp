// SPDX-License-Identifier: MIT
#include "studio/x_messages.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

namespace flg::test {
namespace {

using Connection = std::unique_ptr<Display, decltype(&XCloseDisplay)>;

Connection connect(const std::string& display) {
    Connection connection(XOpenDisplay(display.c_str()), XCloseDisplay);
    if (!connection) throw std::runtime_error("can't reach the display " + display);
    return connection;
}

// The one that can be closed: others are toolkits' own.
Window program_window(Display* display) {
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    Window found = 0;
    for (unsigned i = 0; i < count; ++i) {
        Atom* protocols = nullptr;
        int protocol_count = 0;
        if (XGetWMProtocols(display, children[i], &protocols, &protocol_count) == 0) continue;
        XFree(protocols);
        XWindowAttributes attributes;
        XGetWindowAttributes(display, children[i], &attributes);
        if (attributes.map_state == IsViewable) found = children[i];
    }
    if (children != nullptr) XFree(children);
    if (found == 0) throw std::runtime_error("there is no program's window");
    return found;
}

}  // namespace

void send_close(const std::string& display) {
    const Connection connection = connect(display);
    const Window window = program_window(connection.get());
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(connection.get(), "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(connection.get(), "WM_DELETE_WINDOW", False));
    XSendEvent(connection.get(), window, False, NoEventMask, &event);
    XFlush(connection.get());
}

void drop_files(const std::string& display, int x, int y, const std::vector<std::string>& paths) {
    const Connection connection = connect(display);
    Display* const d = connection.get();
    const auto atom = [&](const char* name) { return XInternAtom(d, name, False); };
    const Window target = program_window(d);
    const Window source = XCreateSimpleWindow(d, DefaultRootWindow(d), 0, 0, 1, 1, 0, 0, 0);
    std::string list;
    for (const std::string& path : paths) list += "file://" + path + "\r\n";
    XSetSelectionOwner(d, atom("XdndSelection"), source, CurrentTime);
    const auto tell = [&](const char* what, long second, long third, long fourth, long fifth) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = atom(what);
        event.xclient.format = 32;
        const long data[5] = {static_cast<long>(source), second, third, fourth, fifth};
        std::copy(std::begin(data), std::end(data), event.xclient.data.l);
        XSendEvent(d, target, False, NoEventMask, &event);
        XFlush(d);
    };
    tell("XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    tell("XdndPosition", 0, static_cast<long>(x) << 16 | y, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
        if (XPending(d) == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
            continue;
        }
        XEvent event;
        XNextEvent(d, &event);
        if (event.type == ClientMessage && event.xclient.message_type == atom("XdndStatus")) {
            if ((event.xclient.data.l[1] & 1) == 0) throw std::runtime_error("the window takes no files");
            tell("XdndDrop", 0, CurrentTime, 0, 0);
        } else if (event.type == ClientMessage && event.xclient.message_type == atom("XdndFinished")) {
            return;
        } else if (event.type == SelectionRequest) {
            const XSelectionRequestEvent& asked = event.xselectionrequest;
            XChangeProperty(d, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(list.data()), static_cast<int>(list.size()));
            XEvent answer{};
            answer.xselection = {SelectionNotify, 0,         True, d, asked.requestor, asked.selection, asked.target,
                                 asked.property,  asked.time};
            XSendEvent(d, asked.requestor, False, NoEventMask, &answer);
            XFlush(d);
        }
    }
    throw std::runtime_error("the window did not take the files");
}

}  // namespace flg::test
