#include "app/base/notices.h"

namespace lapfx::app {

void Notices::tell(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) add({.kind = ui::ToastKind::error, .text = fault.text()});
    ++faults_;
}

}  // namespace lapfx::app
