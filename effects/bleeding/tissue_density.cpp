#include "bleeding/tissue_density.h"

#include <numbers>
#include <utility>

#include "bleeding/point_blur.h"
#include "bleeding/tissue_color.h"
#include "lapfx/authoring/srgb.h"
#include "lapfx/authoring/tissue_report.h"
#include "organ/refine.h"

namespace lapfx::bleeding {

namespace {

constexpr int disc_points = 48;
constexpr double strongest = 4.0;

/// Points evenly over the unit disc (Vogel 1979).
std::array<glm::dvec2, disc_points> sunflower() {
    std::array<glm::dvec2, disc_points> points;
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < disc_points; ++i) {
        const double radius = std::sqrt((i + 0.5) / disc_points);
        points[static_cast<std::size_t>(i)] = radius * glm::dvec2(std::cos(golden * i), std::sin(golden * i));
    }
    return points;
}

/// Two unit vectors across the triangle's normal, the same for the same triangle.
void tangents(const Surface& surface, std::uint32_t triangle, glm::dvec3& a, glm::dvec3& b) {
    const auto& corners = surface.triangles[triangle];
    const glm::dvec3 origin = surface.positions[corners[0]];
    const glm::dvec3 side = surface.positions[corners[1]] - origin;
    const glm::dvec3 normal = glm::cross(side, surface.positions[corners[2]] - origin);
    a = glm::normalize(side);
    b = glm::normalize(glm::cross(normal, side));
}

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The linear colour of a vertex that no texture covers. `image` multiplies it and has a single colour here, or is
/// null.
glm::dvec3 color_of(const Organ& organ, const Material& material, const Image* image, std::uint32_t vertex) {
    glm::dvec3 color = glm::dvec3(organ.colors[vertex]) * glm::dvec3(material.base_color);
    if (image != nullptr && image->pixels.size() >= 4) {
        for (int c = 0; c < 3; ++c) {
            color[c] *= linear_of_srgb(image->pixels[static_cast<std::size_t>(c)] / 255.0);
        }
    }
    return finite(color) ? glm::clamp(color, 0.0, 1.0) : glm::dvec3(1.0);
}

}  // namespace

TissueDensity::TissueDensity(const Organ& organ, const Surface& surface, const VesselParameters& parameters,
                             const work::Stages& stages, organ::PixelList pixels)
    : surface_(surface), parameters_(parameters) {
    if (pixels.empty()) pixels = organ::copied_pixels(organ);
    maps_.resize(organ.images.size());
    for (const Material& material : organ.materials) {
        if (material.base_color_image < 0) continue;
        const auto image = static_cast<std::size_t>(material.base_color_image);
        stages.reach(0.0);
        if (!maps_[image]) maps_[image].emplace(organ, material.base_color_image, pixels[image]);
    }
    for (std::optional<DensityMap>& map : maps_)
        if (map && !map->tells()) map.reset();
    stages.reach(0.2);
    auto mesh = std::make_shared<Mesh>();
    mesh->uvs = organ.uvs;
    find_sources(organ, *mesh);
    take_colors(organ, pixels, *mesh);
    mesh_ = std::move(mesh);
    make(parameters, stages.part(0.3, 1.0));
}

void TissueDensity::find_sources(const Organ& organ, Mesh& mesh) const {
    mesh.corners.reserve(organ.triangle_count());
    for (std::size_t i = 0; i + 2 < organ.indices.size(); i += 3)
        mesh.corners.emplace_back(organ.indices[i], organ.indices[i + 1], organ.indices[i + 2]);
    mesh.source.assign(mesh.corners.size(), by_vertex);
    for (const Part& part : organ.parts) {
        const int image = organ.materials[static_cast<std::size_t>(part.material)].base_color_image;
        if (map(image) == nullptr) continue;
        for (std::size_t t = part.first_index / 3; t < (part.first_index + part.index_count) / 3; ++t)
            mesh.source[t] = image;
    }
}

void TissueDensity::take_colors(const Organ& organ, const organ::PixelList& pixels, Mesh& mesh) {
    const std::size_t count = organ.positions.size();
    mesh.areas.assign(count, 0.0f);
    mesh.redness.assign(count, 0.0f);
    mesh.lab.assign(count, glm::vec3(0.0f));
    glm::dvec3 low(1.0), high(0.0);
    for (const Part& part : organ.parts) {
        const Material& material = organ.materials[static_cast<std::size_t>(part.material)];
        if (part.index_count < 3 || mesh.source[part.first_index / 3] != by_vertex) continue;
        const std::shared_ptr<const Image> image =
            material.base_color_image < 0 ? nullptr
                                          : pixels[static_cast<std::size_t>(material.base_color_image)]->get();
        for (std::size_t t = part.first_index / 3; t < (part.first_index + part.index_count) / 3; ++t) {
            const glm::dvec3 a(organ.positions[mesh.corners[t].x]), b(organ.positions[mesh.corners[t].y]),
                c(organ.positions[mesh.corners[t].z]);
            const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t vertex = mesh.corners[t][corner];
                const glm::dvec3 color = color_of(organ, material, image.get(), vertex);
                mesh.areas[vertex] += static_cast<float>(area / 3);
                mesh.redness[vertex] = static_cast<float>(redness(color.r, color.g));
                mesh.lab[vertex] = glm::vec3(lab_of(color));
                low = glm::min(low, color);
                high = glm::max(high, color);
            }
        }
    }
    const glm::dvec3 spread = high - low;
    if (std::max({spread.x, spread.y, spread.z}) > 1.0 / 255) {
        mesh.points = organ.positions;
        return;
    }
    for (int& source : mesh.source)
        if (source == by_vertex) source = unknown;
}

void TissueDensity::set(const VesselParameters& p) {
    if (!same_maps(p, parameters_))
        make(p, {});
    else if (rests_)
        maps_ = made_maps(p, {});
    rests_ = false;
    parameters_ = p;
}

void TissueDensity::rest() {
    rests_ = true;
    for (std::optional<DensityMap>& map : maps_)
        if (map) map->rest();
}

/// All or nothing, whatever throws on the way.
void TissueDensity::make(const VesselParameters& p, const work::Stages& stages) {
    std::vector<std::optional<DensityMap>> maps = made_maps(p, stages.part(0.0, 0.8));
    stages.reach(0.8);
    set_vertices(p);
    maps_ = std::move(maps);
    ++version_;
}

std::vector<std::optional<DensityMap>> TissueDensity::made_maps(const VesselParameters& p,
                                                                const work::Stages& stages) const {
    std::vector<std::optional<DensityMap>> maps = maps_;
    const auto count = static_cast<double>(maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i)
        if (maps[i]) maps[i]->set(p, stages.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    return maps;
}

std::size_t TissueDensity::shared_memory() const {
    const Mesh& m = *mesh_;
    std::size_t bytes = m.source.size() * sizeof(int) + m.corners.size() * sizeof(glm::uvec3) +
                        m.points.size() * sizeof(glm::vec3) + (m.areas.size() + m.redness.size()) * sizeof(float) +
                        m.lab.size() * sizeof(glm::vec3) + m.uvs.size() * sizeof(glm::vec2);
    for (const std::optional<DensityMap>& map : maps_)
        if (map) bytes += map->shared_memory();
    return bytes;
}

std::size_t TissueDensity::own_memory() const {
    std::size_t bytes = vertex_values_.size() * sizeof(glm::vec2);
    for (const std::optional<DensityMap>& map : maps_)
        if (map) bytes += map->own_memory();
    return bytes;
}

void TissueDensity::set_vertices(const VesselParameters& p) {
    const Mesh& mesh = *mesh_;
    std::vector<glm::vec2> values(mesh.redness.size(), glm::vec2(1.0f, 0.0f));
    for (std::size_t t = 0; t < mesh.corners.size(); ++t)
        for (int corner = 0; corner < 3; ++corner)
            if (mesh.source[t] >= 0) values[mesh.corners[t][corner]] = glm::vec2(1.0f);
    if (mesh.points.empty()) {
        vertex_values_ = std::move(values);
        return;
    }
    const PointBlur narrow(mesh.points, mesh.areas, std::max(p.smoothing, 1e-3));
    const PointBlur wide(mesh.points, mesh.areas, std::max(around_share * p.vessel_width, 1e-3));
    const std::vector<float> around = wide(mesh.redness);
    const ColorBand band(p.vessel_color, p.vessel_tolerance);
    std::vector<float> colored(mesh.points.size(), 0.0f), colored_around = colored;
    if (band.any()) {
        for (std::size_t v = 0; v < colored.size(); ++v) colored[v] = static_cast<float>(band(glm::dvec3(mesh.lab[v])));
        colored_around = wide(colored);
    }
    double area = 0.0, shown = 0.0;
    std::vector<float> vessels(mesh.points.size()), fat(mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const double contrast = double(mesh.redness[v]) - double(around[v]);
        const glm::dvec3 lab(mesh.lab[v]);
        const double redder = ramp(p.vessel_low, p.vessel_high, contrast) * bloodiness(lab.y, lab.z);
        const double of_color = ColorBand::standing_out(double(colored[v]), double(colored_around[v]));
        vessels[v] = static_cast<float>(std::max(redder, of_color));
        fat[v] = static_cast<float>(fattiness(lab.y, lab.z, p.fat_low, p.fat_high));
        area += double(mesh.areas[v]);
        shown += double(mesh.areas[v]) * double(vessels[v]);
    }
    vessels = narrow(vessels);
    fat = narrow(fat);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
        if (mesh.areas[v] > 0.0f) values[v] = {vessels[v], fat[v]};
    vertex_values_ = std::move(values);
    vertices_show_vessels_ = shown >= least_vessels * area;
}

const DensityMap* TissueDensity::map(int image) const {
    if (image < 0) return nullptr;
    const std::optional<DensityMap>& found = maps_[static_cast<std::size_t>(image)];
    return found ? &*found : nullptr;
}

/// Whether the source of a triangle's colours shows vessels.
bool TissueDensity::tells(int source) const noexcept {
    if (source == unknown) return false;
    return source == by_vertex ? vertices_show_vessels_ : maps_[static_cast<std::size_t>(source)]->shows_vessels();
}

TissueDensity::Tissue TissueDensity::at(std::uint32_t triangle, const glm::dvec3& weights) const noexcept {
    const int source = mesh_->source[triangle];
    const glm::uvec3& corners = mesh_->corners[triangle];
    if (source == unknown) return {glm::vec2(1.0f, 0.0f), false, false};
    const auto mixed = [&](const std::vector<glm::vec2>& values) {
        return glm::dvec2(values[corners.x]) * weights.x + glm::dvec2(values[corners.y]) * weights.y +
               glm::dvec2(values[corners.z]) * weights.z;
    };
    const glm::vec2 density = source == by_vertex
                                  ? glm::vec2(mixed(vertex_values_))
                                  : maps_[static_cast<std::size_t>(source)]->sample(glm::vec2(mixed(mesh_->uvs)));
    return {density, true, tells(source)};
}

TissueDensity::Tissue TissueDensity::mean(const glm::dvec3& position) const noexcept {
    static const std::array<glm::dvec2, disc_points> pattern = sunflower();
    if (surface_.triangles.empty()) return {glm::vec2(1.0f, 0.0f), false, false};
    const SurfacePoint middle = surface_.closest_point(position);
    const double radius = parameters_.region;
    glm::dvec3 a, b;
    tangents(surface_, middle.triangle, a, b);
    glm::dvec2 sum(0.0);
    int count = 0;
    for (const glm::dvec2& p : pattern) {
        const glm::dvec3 over = middle.position + radius * (p.x * a + p.y * b);
        const SurfacePoint place = surface_.closest_point(over);
        // The surface may be below its tangent plane, but not beside it: beyond an open edge there is no tissue.
        const glm::dvec3 off = place.position - over;
        if (glm::length(glm::dvec2(glm::dot(off, a), glm::dot(off, b))) > 0.1 * radius) continue;
        const Tissue here = at(place.triangle, place.weights);
        if (!here.known) continue;
        sum += glm::dvec2(here.density);
        ++count;
    }
    Tissue under = at(middle.triangle, middle.weights);
    if (count > 0) under = {glm::vec2(sum / double(count)), true, under.tells};
    return under;
}

TissueSample TissueDensity::sample(const glm::dvec3& position) const noexcept {
    if (!finite(position)) return {};
    const Tissue here = mean(position);
    return {.vessels = double(here.density.x),
            .fat = double(here.density.y),
            .bleeds = strength_of(here),
            .known = here.known};
}

double TissueDensity::strength_of(const Tissue& here) const noexcept {
    const VesselParameters& p = parameters_;
    if (!here.tells || (p.vessel_threshold <= 0.0 && p.vessel_strength <= 0.0)) return 1.0;
    const double density = double(here.density.x);
    if (density < p.vessel_threshold) return 0.0;
    return glm::clamp(1.0 + p.vessel_strength * (density / p.vessel_reference - 1.0), 0.0, strongest);
}

double TissueDensity::wound_strength(const glm::dvec3& position) const noexcept {
    if (!finite(position)) return 0.0;
    if (parameters_.vessel_threshold <= 0.0 && parameters_.vessel_strength <= 0.0) return 1.0;
    return strength_of(mean(position));
}

TissueHistogram TissueDensity::histogram(const VesselParameters& parameters) const {
    TissueHistogram histogram;
    for (const std::optional<DensityMap>& map : maps_)
        if (map) map->count(parameters, histogram);
    if (mesh_->points.empty()) return histogram;
    const std::vector<float> around =
        PointBlur(mesh_->points, mesh_->areas, std::max(around_share * parameters.vessel_width, 1e-3))(mesh_->redness);
    for (std::size_t v = 0; v < mesh_->points.size(); ++v) {
        if (!(mesh_->areas[v] > 0.0f)) continue;
        const double a = double(mesh_->lab[v].y), b = double(mesh_->lab[v].z);
        if (bloodiness(a, b) > 0.5) histogram.add_contrast(double(mesh_->redness[v]) - double(around[v]));
        if (std::hypot(a, b) > least_chroma) histogram.add_hue(hue_of(a, b));
    }
    return histogram;
}

TissueReport TissueDensity::report() const {
    TissueReport report;
    double area = 0.0, known = 0.0, told = 0.0;
    glm::dvec2 sum(0.0);
    for (const auto& triangle : surface_.triangles)
        area += 0.5 * glm::length(glm::cross(surface_.positions[triangle[1]] - surface_.positions[triangle[0]],
                                             surface_.positions[triangle[2]] - surface_.positions[triangle[0]]));
    if (!(area > 0.0) || !std::isfinite(area)) return report;
    for (std::uint32_t t = 0; t < mesh_->corners.size(); ++t) {
        const auto& triangle = surface_.triangles[t];
        const double piece =
            0.5 * glm::length(glm::cross(surface_.positions[triangle[1]] - surface_.positions[triangle[0]],
                                         surface_.positions[triangle[2]] - surface_.positions[triangle[0]]));
        if (mesh_->source[t] == unknown) continue;
        known += piece;
        if (tells(mesh_->source[t])) told += piece;
        // Large triangles are sampled at more places: 20000 over the organ. Roberts' R2 sequence, folded.
        const int heres = 1 + static_cast<int>(20000.0 * piece / area);
        for (int i = 0; i < heres; ++i) {
            glm::dvec2 p = glm::fract(0.5 + (i + 1.0) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
            if (p.x + p.y > 1.0) p = 1.0 - p;
            sum += glm::dvec2(at(t, {1.0 - p.x - p.y, p.x, p.y}).density) * piece / double(heres);
        }
    }
    report.known = known / area;
    report.alike = std::max(0.0, 1.0 - told / area);
    if (known > 0.0) {
        report.vessels = sum.x / known;
        report.fat = sum.y / known;
    }
    for (const std::optional<DensityMap>& map : maps_)
        if (map)
            report.texels_per_mm = std::max(report.texels_per_mm,
                                            std::sqrt(map->layout().texels_per_mm.x * map->layout().texels_per_mm.y));
    return report;
}

}  // namespace lapfx::bleeding

namespace lapfx {

TissueReport report_tissue(const Organ& organ, const VesselParameters& parameters) {
    const organ::FineOrgan fine(organ);
    const Surface surface(fine.organ());
    return bleeding::TissueDensity(fine.organ(), surface, parameters, {}, organ::borrowed_pixels(fine.organ()))
        .report();
}

TissueHistogram tissue_histogram(const Organ& organ, const VesselParameters& parameters) {
    const organ::FineOrgan fine(organ);
    const Surface surface(fine.organ());
    return bleeding::TissueDensity(fine.organ(), surface, parameters, {}, organ::borrowed_pixels(fine.organ()))
        .histogram(parameters);
}

}  // namespace lapfx
