// The operating field of laparoscopic adjustable gastric banding.
#include "models.h"

#include "canvas.h"
#include "field.h"
#include "glb.h"
#include "tissue.h"
#include "vessels.h"

namespace organs {
namespace {

struct Field {
    Patch stomach = stomach_shape();
    Patch liver = liver_edge_shape();
    Patch omentum = lesser_omentum_shape();
    Patch wall = wall_shape();
    Patch apron;
    Patch cardia_fat;
};

Field make_field() {
    Field field;
    HeightMap seen(field_view(), 440.0, 440);
    for (const Patch* patch : {&field.stomach, &field.omentum, &field.wall}) seen.add(*patch, true);
    HeightMap bed = seen;
    bed.add(bed_shape());
    const auto bridged = [](const HeightMap& bare, double radius) {
        HeightMap cloth = bare;
        cloth.drape(radius);
        return Ground{bare, cloth};
    };
    field.apron = apron_shape(bridged(bed, 18.0));
    field.cardia_fat = cardia_fat_shape(bridged(seen, 11.0));
    const std::vector<Patch*> organs = {&field.stomach, &field.liver, &field.omentum, &field.apron,
                                        &field.cardia_fat};
    std::vector<Patch*> lit = organs;
    lit.push_back(&field.wall);
    find_light(lit, {organs.begin(), organs.end()}, 48, 45.0);
    return field;
}

Surface surface(const std::string& name, const Patch& patch, double roughness) {
    Surface made;
    made.name = name;
    made.roughness = roughness;
    append(made.mesh, patch);
    return made;
}

void texture(Surface& made, const Canvas& canvas, int normal_size) {
    made.color_jpeg = canvas.color_jpeg(86);
    made.normal_jpeg = canvas.normal_jpeg(normal_size, 86);
}

Surface stomach(const Patch& patch, int size) {
    Surface made = surface("stomach", patch, 0.34);
    Canvas canvas(size);
    Growth growth;
    growth.stems = {{{0.20, 0.14}, {0.22, 0.3}, {0.2, 0.5}, {0.22, 0.7}, {0.18, 0.98}},
                    {{0.86, 0.10}, {0.83, 0.3}, {0.85, 0.5}, {0.82, 0.75}, {0.84, 0.98}}};
    growth.seed = 11;
    const VesselTree tree = grow(patch, growth);
    canvas.draw(patch, tree, {.vein = true, .aside = 1.9, .thinnest = 0.22, .width = 1.15, .raised = 0.35});
    canvas.draw(patch, tree, {.raised = 0.5});
    canvas.paint(patch, stomach_tissue);
    texture(made, canvas, size / 2);
    return made;
}

Surface painted(const std::string& name, const Patch& patch, double roughness, const Tissue& tissue,
                const Growth& growth, int size) {
    Surface made = surface(name, patch, roughness);
    Canvas canvas(size);
    const VesselTree tree = grow(patch, growth);
    canvas.draw(patch, tree, {.vein = true, .aside = 2.0, .thinnest = 0.2, .width = 1.1, .raised = 0.35});
    canvas.draw(patch, tree, {});
    canvas.paint(patch, tissue);
    texture(made, canvas, size / 2);
    return made;
}

}  // namespace

void make_lagb(const std::filesystem::path& folder, int size) {
    const Field field = make_field();
    std::vector<Surface> surfaces;
    surfaces.push_back(stomach(field.stomach, size));
    Growth growth;
    growth.thickest = 0.6;
    growth.winding = 2.4;
    growth.stems = {{{0.95, 0.35}, {0.80, 0.45}, {0.78, 0.6}, {0.8, 0.8}}};
    growth.seed = 21;
    surfaces.push_back(painted("lesser omentum", field.omentum, 0.36, membrane_tissue, growth, size / 2));
    growth.thickest = 0.55;
    growth.capillary = 0.08;
    growth.demands = 9;
    growth.demand = [](const SurfacePoint& at) { return at.vertex.mask; };
    growth.stems = {{{0.9, 0.3}, {0.7, 0.5}, {0.55, 0.62}, {0.4, 0.75}, {0.1, 0.9}}};
    growth.seed = 31;
    surfaces.push_back(painted("greater omentum", field.apron, 0.30, fat_tissue, growth, size));
    growth.stems = {{{0.68, 0.2}, {0.60, 0.4}, {0.57, 0.6}, {0.45, 0.75}, {0.3, 0.85}}};
    growth.seed = 41;
    surfaces.push_back(painted("cardia fat", field.cardia_fat, 0.30, fat_tissue, growth, size / 2));
    growth.demand = nullptr;
    growth.demands = 14;
    growth.thickest = 0.35;
    growth.stems = {{{0.3, 0.02}, {0.35, 0.2}}, {{0.75, 0.02}, {0.7, 0.2}}};
    growth.seed = 51;
    surfaces.push_back(painted("liver", field.liver, 0.30, liver_tissue, growth, size / 2));
    growth.stems = {{{0.5, 0.02}, {0.5, 0.3}}, {{0.02, 0.5}, {0.3, 0.5}}, {{0.98, 0.5}, {0.7, 0.5}}};
    growth.seed = 61;
    surfaces.push_back(painted("wall", field.wall, 0.5, wall_tissue, growth, size / 2));
    write_glb(folder / "lagb.glb", "gastric banding field", surfaces);
}

}  // namespace organs
