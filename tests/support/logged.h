// The tool's log for tests, which write lists of contacts.
#pragma once

#include <span>

#include "lapfx/authoring/compare.h"
#include "lapfx/preset.h"
#include "tool/log.h"

namespace lapfx::test {

inline tool::Log log_of(std::span<const ToolContact> contacts) {
    tool::Log log;
    log.update(contacts);
    return log;
}

/// A reader of a log, together with its log. It finds itself what has changed in its parameters.
template <class Reader>
class Logged : public Reader {
  public:
    using Reader::Reader;

    tool::Log log;

    template <class Parameters>
    auto set(std::span<const ToolContact> contacts, const Parameters& parameters) {
        Preset wanted = known_;
        put(wanted, parameters);
        Reader::set_parameters(parameters, difference(preset_table(), &known_, &wanted));
        known_ = wanted;
        log.update(contacts);
        return Reader::set(log);
    }

  private:
    static void put(Preset& preset, const BleedingParameters& parameters) { preset.bleeding = parameters; }
    static void put(Preset& preset, const CauteryParameters& parameters) { preset.cautery = parameters; }

    Preset known_;
};

}  // namespace lapfx::test
