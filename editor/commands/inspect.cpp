// lapfx inspect FILE...: what a mesh, clip, preset or image holds.
#include <iostream>

#include "commands/command.h"
#include "lapfx/organ.h"

namespace lapfx::commands {
namespace {
void print_organ(const std::string& file) {
    const Organ organ = load_organ(file);
    const OrganReport r = report(organ);
    const glm::dvec3 size = r.maximum - r.minimum;
    std::cout << file << "\n  vertices " << r.vertices << " triangles " << r.triangles << " components " << r.components
              << " boundary " << r.boundary_edges << " nonmanifold " << r.non_manifold_edges << " size " << size.x << ' '
              << size.y << ' ' << size.z << " uv " << organ.has_uvs << " color " << organ.has_colors << '\n';
    for (const Image& image : organ.images) std::cout << "  image " << image.name << ' ' << image.width << 'x' << image.height << '\n';
    for (const std::string& warning : r.warnings) std::cout << "  warning: " << warning << '\n';
}
}  // namespace
void add_inspect(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("inspect", "What a mesh, clip, preset or image holds");
    auto files = std::make_shared<std::vector<std::string>>();
    verb->add_option("FILE", *files, "files")->required();
    verb->callback([files] {
        for (const std::string& file : *files) print_organ(file);
    });
}
}  // namespace lapfx::commands
