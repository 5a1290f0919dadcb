#include <cstdio>
#include <iostream>

#include "commands/inspect.h"
#include "lapfx/authoring/organ_report.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/authoring/tissue_report.h"
#include "lapfx/refine.h"
#include "lapfx/tissue.h"

namespace lapfx::commands {

namespace {

void row(const char* name, const std::string& value) {
    char text[64];
    std::snprintf(text, sizeof text, "  %-20s", name);
    std::cout << text << printable(value) << '\n';
}

std::string text_of(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string named(const std::string& name) {
    return name.empty() ? "(unnamed)" : name;
}

/// "16 triangles, 4 left out: 1 without area, 3 there before".
std::string counts_text(const TriangleCounts& counts) {
    const std::pair<std::size_t, const char*> reasons[] = {
        {counts.unreadable, " without 3 readable corners"},
        {counts.out_of_range, " with vertices not in the file"},
        {counts.not_finite, " whose coordinates are missing, not finite or beyond 1e9 mm"},
        {counts.without_area, " without area"},
        {counts.repeated, " repeated"}};
    std::string text = std::to_string(counts.read) + (counts.read == 1 ? " triangle, " : " triangles, ");
    if (counts.dropped() == 0) return text + "none left out";
    text += std::to_string(counts.dropped()) + " left out";
    const char* separator = ": ";
    for (const auto& [count, reason] : reasons) {
        if (count == 0) continue;
        text += separator + std::to_string(count) + reason;
        separator = ", ";
    }
    return text;
}

void print_parts(const Organ& organ) {
    row("parts", std::to_string(organ.parts.size()));
    for (const Part& part : organ.parts) {
        const std::uint32_t count = part.index_count / 3;
        row("", named(part.name) + ": " + std::to_string(count) + (count == 1 ? " triangle" : " triangles") +
                    ", material " + named(organ.materials[static_cast<std::size_t>(part.material)].name));
    }
}

std::string image_text(const Organ& organ, int image) {
    return image < 0 ? "none" : organ.images[static_cast<std::size_t>(image)].name;
}

/// Nothing where it repeats both ways, as most do.
std::string wrap_text(const Image& image) {
    const auto word = [](Wrap wrap) {
        return std::string(wrap == Wrap::clamp ? "clamped" : wrap == Wrap::mirror ? "mirrored" : "repeated");
    };
    if (image.wrap_u == Wrap::repeat && image.wrap_v == Wrap::repeat) return "";
    return ", " + word(image.wrap_u) +
           (image.wrap_u == image.wrap_v ? "" : " along u and " + word(image.wrap_v) + " along v");
}

void print_materials(const Organ& organ) {
    row("materials", std::to_string(organ.materials.size()));
    for (const Material& material : organ.materials)
        row("", named(material.name) + ": base colour texture " + image_text(organ, material.base_color_image) +
                    ", normal map " + image_text(organ, material.normal_image) + ", roughness " +
                    text_of("%.2f", material.roughness) + (material.double_sided ? ", double sided" : ""));
    row("textures", std::to_string(organ.images.size()));
    for (const Image& image : organ.images)
        row("",
            image.name + ": " + std::to_string(image.width) + "x" + std::to_string(image.height) + wrap_text(image));
}

/// What the colours show about the tissue, with default parameters.
void print_tissue(const Organ& organ) {
    const TissueReport tissue = report_tissue(organ);
    if (tissue.known == 0.0) {
        row("warning", "it has only one colour: density of vessels and fat is not known, and every cut bleeds equally");
        return;
    }
    row("tissue",
        text_of("%.1f", 100.0 * tissue.vessels) + " % vessels, " + text_of("%.1f", 100.0 * tissue.fat) +
            " % fat by colour" +
            (tissue.known < 0.9995 ? " of the " + text_of("%.1f", 100.0 * tissue.known) + " % that have colours"
                                   : std::string()));
    if (tissue.alike > 0.9995)
        row("vessels", "none found: every cut bleeds equally");
    else if (tissue.alike > 0.0005)
        row("vessels", "none found on " + text_of("%.1f", 100.0 * tissue.alike) +
                           " % of the surface: there every cut bleeds equally");
    if (tissue.texels_per_mm > 0.0) row("texture pixels/mm", text_of("%.2f", tissue.texels_per_mm));
}

}  // namespace

void inspect_organ(const std::filesystem::path& file) {
    const Organ organ = load_organ(file);
    const OrganReport report = lapfx::report(organ);
    const glm::dvec3 size = report.maximum - report.minimum;
    std::cout << printable(file.string()) << ": mesh\n";
    row("vertices", std::to_string(report.vertices));
    row("triangles", std::to_string(report.triangles));
    row("in the file", counts_text(organ.counts));
    if (organ.counts.sewn > 0)
        row("mended", std::to_string(organ.counts.sewn) + " vertices moved to close gaps along seams");
    if (const RefineReport split = report_refine(organ); split.longest_edge > 0.0)
        row("split for blood", "into " + std::to_string(split.triangles) + " triangles, no edge longer than " +
                                   text_of("%.3g", split.longest_edge) + " mm");
    row("components", std::to_string(report.components));
    row("boundary edges", std::to_string(report.boundary_edges));
    row("non-manifold edges", std::to_string(report.non_manifold_edges));
    row("size", text_of("%.1f", size.x) + " x " + text_of("%.1f", size.y) + " x " + text_of("%.1f", size.z) + " mm");
    row("scale", text_of("%g", organ.scale) + " mm per unit of the file");
    row("texture coordinates", organ.has_uvs ? "from the file" : "made");
    row("vertex colours", organ.has_colors ? "from the file" : "none");
    print_parts(organ);
    print_materials(organ);
    print_tissue(organ);
    for (const std::string& warning : report.warnings) row("warning", warning);
}

}  // namespace lapfx::commands
