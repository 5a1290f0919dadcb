#include "bench/scratch_folder.h"

#include <cstdlib>

#include "output/files.h"

namespace lapfx::bench {

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "lapfx-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw output::cannot_write(name, "the folder cannot be made");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

}  // namespace lapfx::bench
