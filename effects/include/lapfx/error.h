// Errors of the effects core: what was wrong, in which file, at which place.
//
//     try { auto preset = lapfx::load_preset("ooze.json"); }
//     catch (const lapfx::Error& error) {
//         for (const auto& fault : error.faults()) std::cerr << "lapfx: " << fault.text() << '\n';
//     }
//
// Loading and setting up throw; per-frame calls are noexcept. Anything that comes from outside (files, presets,
// videos, the driver) is reported this way; a caller's mistake is an assert.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "lapfx/api.h"

namespace lapfx {

/// One thing that is wrong.
struct LAPFX_API Fault {
    std::string file;    ///< path as the caller gave it, or empty
    std::string place;   ///< where in the file: a JSON pointer, a line, an accessor; or empty
    std::string reason;  ///< the value found and what is allowed, one line

    /// "FILE: PLACE: REASON" without the parts that are empty; always a single line of printable text.
    std::string text() const;
};

/// What kind of failure it is.
enum class Failure {
    runtime,    ///< a failure while running: disk full, driver lost
    bad_input,  ///< wrong usage or input: the file has to change
    no_gl,      ///< no usable OpenGL on this machine
};

/// The one exception type of lapfx. what() contains all faults, one per line.
class LAPFX_API Error : public std::runtime_error {
  public:
    Error(Failure failure, std::vector<Fault> faults);
    Error(Failure failure, Fault fault) : Error(failure, std::vector<Fault>{std::move(fault)}) {}

    Failure failure() const noexcept { return failure_; }
    const std::vector<Fault>& faults() const noexcept { return faults_; }

  private:
    Failure failure_;
    std::vector<Fault> faults_;
};

}  // namespace lapfx
