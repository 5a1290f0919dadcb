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
    Patch ligament;
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
    field.ligament = ligament_shape(bridged(seen, 14.0));
    const std::vector<Patch*> organs = {&field.stomach, &field.liver,      &field.omentum,
                                        &field.apron,   &field.cardia_fat, &field.ligament};
    std::vector<Patch*> lit = organs;
    lit.push_back(&field.wall);
    find_light(lit, {organs.begin(), organs.end()}, 48, 45.0);
    return field;
}

/// An artery with a vein beside it, except where it is thin.
void draw_pairs(Canvas& canvas, const Patch& patch, const VesselTree& tree) {
    canvas.draw(patch, tree, {.vein = true, .aside = 2.0, .thinnest = 0.2, .width = 1.1, .raised = 0.35});
    canvas.draw(patch, tree, {});
}

/// Under the liver's capsule single vessels shine through.
void draw_single(Canvas& canvas, const Patch& patch, const VesselTree& tree) {
    canvas.draw(patch, tree, {.vein = true, .raised = 0.2});
}

Surface textured(const std::string& name, const Patch& patch, double roughness, const Tissue& tissue,
                 const Growth& growth, int size, void (*draw)(Canvas&, const Patch&, const VesselTree&) = draw_pairs) {
    Surface made;
    made.name = name;
    made.roughness = roughness;
    append(made.mesh, patch);
    Canvas canvas(size);
    draw(canvas, patch, grow(patch, growth));
    canvas.paint(patch, tissue);
    made.color_jpeg = canvas.color_jpeg(84);
    made.normal_jpeg = canvas.normal_jpeg(size / 2, 86);
    return made;
}

Surface stomach(const Patch& patch, int size) {
    Growth growth;
    growth.stems = {{{0.20, 0.14}, {0.22, 0.3}, {0.2, 0.5}, {0.22, 0.7}, {0.18, 0.98}},
                    {{0.86, 0.10}, {0.83, 0.3}, {0.85, 0.5}, {0.82, 0.75}, {0.84, 0.98}}};
    growth.waves = 5;
    growth.demands = 12;
    growth.satisfied = 1.9;
    growth.capillary = 0.085;
    growth.seed = 11;
    return textured("stomach", patch, 0.28, stomach_tissue, growth, size);
}

Surface lesser_omentum(const Patch& patch, int size) {
    Growth growth;
    growth.stems = {{{0.95, 0.35}, {0.80, 0.45}, {0.78, 0.6}, {0.8, 0.8}}};
    growth.thickest = 0.48;
    growth.winding = 3.0;
    growth.seed = 21;
    return textured("lesser omentum", patch, 0.30, membrane_tissue, growth, size);
}

Growth fat_growth(std::uint32_t seed) {
    Growth growth;
    growth.thickest = 0.42;
    growth.capillary = 0.08;
    growth.demands = 9;
    growth.winding = 3.0;
    growth.demand = [](const SurfacePoint& at) { return at.vertex.mask; };
    growth.seed = seed;
    return growth;
}

Surface greater_omentum(const Patch& patch, int size) {
    Growth growth = fat_growth(31);
    growth.stems = {{{0.9, 0.3}, {0.7, 0.5}, {0.55, 0.62}, {0.4, 0.75}, {0.1, 0.9}}};
    return textured("greater omentum", patch, 0.23, fat_tissue, growth, size);
}

Surface cardia_fat(const Patch& patch, int size) {
    Growth growth = fat_growth(41);
    growth.stems = {{{0.68, 0.2}, {0.60, 0.4}, {0.57, 0.6}, {0.45, 0.75}, {0.3, 0.85}}};
    return textured("cardia fat", patch, 0.23, fat_tissue, growth, size);
}

Surface ligament(const Patch& patch, int size) {
    Growth growth;
    growth.stems = {{{0.98, 0.56}, {0.8, 0.48}, {0.62, 0.55}, {0.42, 0.42}, {0.2, 0.5}, {0.03, 0.42}}};
    growth.thickest = 0.5;
    growth.demands = 8;
    growth.winding = 2.0;
    growth.demand = [](const SurfacePoint& at) { return at.vertex.mask; };
    growth.seed = 71;
    return textured("gastrohepatic ligament", patch, 0.26, ligament_tissue, growth, size);
}

Surface liver(const Patch& patch, int size) {
    Growth growth;
    growth.stems = {{{0.3, 0.02}, {0.35, 0.2}}, {{0.75, 0.02}, {0.7, 0.2}}};
    growth.thickest = 0.25;
    growth.seed = 51;
    return textured("liver", patch, 0.25, liver_tissue, growth, size, draw_single);
}

Surface wall(const Patch& patch, int size) {
    Growth growth;
    growth.stems = {{{0.5, 0.02}, {0.5, 0.3}}, {{0.02, 0.5}, {0.3, 0.5}}, {{0.98, 0.5}, {0.7, 0.5}}};
    growth.thickest = 0.7;
    growth.satisfied = 6.0;
    growth.seed = 61;
    return textured("wall", patch, 0.5, wall_tissue, growth, size);
}

}  // namespace

void make_lagb(const std::filesystem::path& folder, int size) {
    const Field field = make_field();
    const std::vector<Surface> surfaces = {stomach(field.stomach, size),       lesser_omentum(field.omentum, size / 2),
                                           greater_omentum(field.apron, size), cardia_fat(field.cardia_fat, size / 2),
                                           liver(field.liver, size / 2),       wall(field.wall, size / 2),
                                           ligament(field.ligament, size / 4)};
    write_glb(folder / "lagb.glb", "gastric banding field", surfaces);
}

}  // namespace organs
