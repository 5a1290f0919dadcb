// Notices of the editor: toasts, and one for each fault.
//
//     try { ... } catch (const Error& error) { notices.tell(error); }
#pragma once

#include "lapfx/error.h"
#include "ui/shell/toast.h"

namespace lapfx::app {

class Notices : public ui::Toasts {
  public:
    void tell(const std::vector<Fault>& faults);
    void tell(const Error& error) { tell(error.faults()); }
    /// Grows with every tell(): work that is not saved is kept aside when it has grown.
    std::uint64_t faults() const { return faults_; }

  private:
    std::uint64_t faults_ = 0;
};

}  // namespace lapfx::app
