#include "lapfx/error.h"

namespace lapfx {

namespace {

/// Control characters would break "one line per fault", and could drive a terminal.
std::string printable(const std::string& text) {
    std::string out;
    for (const unsigned char c : text) {
        if (c >= 0x20 && c != 0x7f) {
            out += static_cast<char>(c);
        } else {
            constexpr char digits[] = "0123456789abcdef";
            out += {'\\', 'x', digits[c >> 4], digits[c & 15]};
        }
    }
    return out;
}

std::string join(const std::vector<Fault>& faults) {
    std::string text;
    for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + fault.text();
    return text;
}

}  // namespace

std::string Fault::text() const {
    std::string out;
    for (const std::string* part : {&file, &place, &reason})
        if (!part->empty()) out += (out.empty() ? "" : ": ") + printable(*part);
    return out;
}

Error::Error(Failure failure, std::vector<Fault> faults)
    : std::runtime_error(join(faults)), failure_(failure), faults_(std::move(faults)) {}

}  // namespace lapfx
