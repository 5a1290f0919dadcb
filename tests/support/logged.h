// The tool's log for tests, which write lists of contacts.
#pragma once

#include <span>

#include "tool/log.h"

namespace lapfx::test {

inline tool::Log log_of(std::span<const ToolContact> contacts) {
    tool::Log log;
    log.update(contacts);
    return log;
}

/// A reader of a log, together with its log.
template <class Reader>
class Logged : public Reader {
  public:
    using Reader::Reader;

    tool::Log log;

    template <class Parameters>
    auto set(std::span<const ToolContact> contacts, const Parameters& parameters) {
        log.update(contacts);
        return Reader::set(log, parameters);
    }
};

}  // namespace lapfx::test
