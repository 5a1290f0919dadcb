#include "lapfx/error.h"

#include "lapfx/authoring/printable.h"

namespace lapfx {

namespace {

std::string join(const std::vector<Fault>& faults) {
    std::string text;
    for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + fault.text();
    return text;
}

}  // namespace

std::string Fault::text() const {
    // Control characters would break "one line per fault", and could drive a terminal.
    std::string out;
    for (const std::string* part : {&file, &place, &reason})
        if (!part->empty()) out += (out.empty() ? "" : ": ") + printable(*part);
    return out;
}

Error::Error(Failure failure, std::vector<Fault> faults)
    : std::runtime_error(join(faults)), failure_(failure), faults_(std::move(faults)) {}

}  // namespace lapfx
