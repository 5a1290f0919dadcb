// drop_files WINDOW X Y FILE...: drops files on a window as a file manager does, by X11's drag and drop protocol (XDND
// 5), which xdotool does not speak. X, Y: in the window, px. Exit code 0 when the window has taken them.
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

constexpr int version = 5, longest_wait = 600'000;  // ms: only what hangs takes so long

std::string uri_list(int count, char** files) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += "file://";
        for (const char c : std::filesystem::absolute(files[i]).string()) {
            char coded[4];
            std::snprintf(coded, sizeof coded, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
            text += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '.' || c == '_' || c == '-'
                        ? std::string(1, c)
                        : std::string(coded);
        }
        text += "\r\n";
    }
    return text;
}

class Source {
  public:
    Source(Display* display, Window target, std::string text)
        : display_(display), target_(target), text_(std::move(text)) {
        source_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
    }

    /// Gives whether the window took what was dropped.
    bool drop(int x, int y) {
        int root_x = 0, root_y = 0;
        Window child = 0;
        XTranslateCoordinates(display_, target_, DefaultRootWindow(display_), x, y, &root_x, &root_y, &child);
        send("XdndEnter", {0, version << 24, static_cast<long>(atom("text/uri-list")), 0, 0});
        send("XdndPosition", {0, 0, root_x << 16 | root_y, CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
        XEvent event;
        if (!wait_for("XdndStatus", event) || (event.xclient.data.l[1] & 1) == 0) return false;
        send("XdndDrop", {0, 0, CurrentTime, 0, 0});
        // Bit 0 means taken; GLFW gives the number of bytes that it has got.
        return wait_for("XdndFinished", event) && event.xclient.data.l[1] != 0;
    }

  private:
    struct Data {
        long l[5];
    };
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    void send(const char* type, const Data& data) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display_;
        event.xclient.window = target_;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data.l[i];
        event.xclient.data.l[0] = static_cast<long>(source_);
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// The window asks for the names.
    void answer(const XSelectionRequestEvent& request) {
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.time = request.time;
        if (request.target == atom("text/uri-list")) {
            event.xselection.property = request.property;
            XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(text_.data()), static_cast<int>(text_.size()));
        }
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    bool wait_for(const char* type, XEvent& event) {
        using Clock = std::chrono::steady_clock;
        const auto end = Clock::now() + std::chrono::milliseconds(longest_wait);
        while (Clock::now() < end) {
            if (XPending(display_) == 0) {
                pollfd connection{.fd = ConnectionNumber(display_), .events = POLLIN, .revents = 0};
                ::poll(&connection, 1, 100);
                continue;
            }
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) answer(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(type)) return true;
        }
        std::fprintf(stderr, "drop_files: the window sends no %s\n", type);
        return false;
    }

    Display* display_;
    Window target_, source_ = 0;
    std::string text_;
};

}  // namespace

int main(int count, char** words) {
    if (count < 5) {
        std::fprintf(stderr, "usage: drop_files WINDOW X Y FILE...\n");
        return 2;
    }
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) {
        std::fprintf(stderr, "drop_files: no display\n");
        return 1;
    }
    Source source(display, std::strtoul(words[1], nullptr, 0), uri_list(count - 4, words + 4));
    const bool taken = source.drop(std::atoi(words[2]), std::atoi(words[3]));
    XCloseDisplay(display);
    return taken ? 0 : 1;
}
