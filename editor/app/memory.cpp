#include "app/memory.h"

#include <unistd.h>

#include <cstdio>

#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "app/preview/preview_host.h"
#include "app/reference/reference.h"

namespace lapfx::app {

ProcessMemory ProcessMemory::now() {
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return {};
    std::size_t all = 0, resident = 0, shared = 0;
    const int read = std::fscanf(file, "%zu %zu %zu", &all, &resident, &shared);
    std::fclose(file);
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    return read == 3 ? ProcessMemory{.all = resident * page, .files = shared * page} : ProcessMemory{};
}

std::array<MemoryPart, 9> memory_parts(const PreviewHost& preview, const Reference& reference,
                                       const Measuring& measuring, const PreviewMeasuring& measured,
                                       const ui::ImageStore& images, const document::Document& document) {
    const MemoryUse use = preview.memory_use();
    std::size_t pictures = 0;
    for (const ui::StoredImage& image : images.all()) pictures += image.pixels.size();
    return {{{"Smoke clips", use.clips, true},
             {"Organ's textures", use.textures, true},
             {"Their pixels, to be sent", use.pixels, false},
             {"Maps of vessels and fat", use.densities, false},
             {"Organ's surface", use.surface + use.geometry, false},
             {"Pictures of the scene", use.targets + reference.comparison().memory() + measured.memory(), true},
             {"Keying, reference, thumbnails", 2 * pictures, false},  // here and as textures
             {"What was counted in the reference", measuring.memory(), false},
             {"Undo", document.step_memory(), false}}};
}

}  // namespace lapfx::app
