// What the editor uses memory for; the status bar tells it.
//
//     for (const MemoryPart& part : memory_parts(preview, reference, images, document))
//         std::printf("%s: %.0f MB\n", part.name, part.bytes / 1e6);
#pragma once

#include <array>
#include <cstddef>

namespace lapfx::ui {
class ImageStore;
}
namespace lapfx::document {
class Document;
}

namespace lapfx::app {

class Measuring;
class PreviewHost;
class PreviewMeasuring;
class Reference;

struct MemoryPart {
    const char* name;
    std::size_t bytes;
    bool gpu;  ///< it lies on the GPU where there is one
};

/// Bytes of this process that are in main memory; all 0 where that is not known.
struct ProcessMemory {
    std::size_t all = 0;
    std::size_t files = 0;  ///< of them, those that are read from files: programs and libraries

    static ProcessMemory now();
};

/// All parts that the editor knows of; the ones that depend most on the document come first. UI thread, context
/// current.
std::array<MemoryPart, 9> memory_parts(const PreviewHost& preview, const Reference& reference,
                                       const Measuring& measuring, const PreviewMeasuring& measured,
                                       const ui::ImageStore& images, const document::Document& document);

}  // namespace lapfx::app
