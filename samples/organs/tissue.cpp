#include "tissue.h"

#include <cmath>

namespace organs {
namespace {

dvec3 rgb(double r, double g, double b) {
    return dvec3(r, g, b) / 255.0;
}

/// Vessels over tissue: arteries bright red, veins darker and bluish.
dvec3 with_vessels(dvec3 color, const VesselCover& vessels, double strength) {
    color = glm::mix(color, rgb(112, 34, 58), strength * vessels.vein);
    return glm::mix(color, rgb(168, 28, 30), strength * vessels.artery);
}

}  // namespace

Lobules lobules(const dvec3& p, double size, std::uint32_t seed) {
    const dvec3 q = p / size + 0.38 * perlin3(p / size * 0.8, seed + 3u) + 0.10 * perlin3(p / size * 2.6, seed + 9u);
    const Cell cell = worley(q, seed);
    Lobules found;
    found.id = cell.id;
    found.height = clamp01(1.0 - cell.nearest * cell.nearest * 1.25);
    found.crease = 1.0 - ramp(0.0, 0.22, cell.second - cell.nearest);
    return found;
}

Texel stomach_tissue(const SurfacePoint& at, const VesselCover& vessels) {
    const dvec3& p = at.vertex.rest;
    Texel texel;
    const double blush = fbm(p * 0.022, 4, 301u);
    const double mottle = fbm(p * 0.16, 4, 302u);
    const double grain = fbm(p * 0.9, 3, 303u);
    dvec3 color = glm::mix(rgb(226, 171, 147), rgb(217, 136, 123), ramp(-0.5, 0.5, blush + 0.5 * mottle));
    color = glm::mix(color, rgb(232, 196, 160), 0.45 * ramp(0.0, 0.7, fbm(p * 0.05, 3, 304u)));
    // Capillaries: thin crests, in patches, reddening the serosa.
    const dvec3 bent = p + 1.2 * perlin3(p * 0.3, 305u);
    const double web = ramp(0.80, 0.98, ridges(bent * 0.28, 2, 306u)) * ramp(-0.2, 0.5, fbm(p * 0.05, 3, 307u));
    color = glm::mix(color, rgb(196, 92, 84), 0.32 * web);
    // Fat shows through the serosa where the omentum begins.
    const double yellow = at.vertex.mask * ramp(0.25, 0.95, at.vertex.mask + 0.6 * fbm(p * 0.12, 4, 311u));
    color = glm::mix(color, rgb(232, 184, 124), 0.75 * yellow);
    color *= 1.0 + 0.05 * mottle + 0.05 * grain;
    texel.color = with_vessels(color, vessels, 0.82);
    // Wrinkles of the serosa run around the organ; fine bumps break up the shine.
    const dvec3 folds = dvec3(p.x * 0.12, p.y * 0.26, p.z * 0.12) + 0.8 * perlin3(p * 0.08, 308u);
    texel.height = 0.16 * fbm(folds, 3, 309u) + 0.10 * fbm(p * 0.45, 3, 310u) + 0.030 * grain + vessels.height;
    return texel;
}

Texel fat_tissue(const SurfacePoint& at, const VesselCover& vessels) {
    const dvec3& p = at.vertex.rest;
    const Lobules large = lobules(p, 11.5, 401u);
    const Lobules small = lobules(p, 5.5, 402u);
    const double patchy = ramp(-0.45, 0.3, fbm(p * 0.04, 3, 403u));
    Texel texel;
    const double shade =
        0.5 + 0.7 * fbm(p * 0.05, 4, 404u) + 0.22 * (unit(large.id) - 0.5) + 0.12 * patchy * (unit(small.id) - 0.5);
    dvec3 color = glm::mix(rgb(236, 148, 72), rgb(253, 200, 122), clamp01(shade));
    color = glm::mix(color, rgb(226, 136, 88), 0.55 * ramp(0.0, 0.7, fbm(p * 0.03, 3, 405u)));
    const double crease =
        clamp01(0.8 * large.crease * ramp(-0.5, 0.3, fbm(p * 0.05, 2, 412u)) + 0.35 * patchy * small.crease);
    color = glm::mix(color, rgb(186, 84, 44), 0.50 * crease);
    color = glm::mix(color, rgb(255, 218, 140),
                     0.30 * ramp(0.55, 0.95, large.height) + 0.15 * patchy * ramp(0.6, 1.0, small.height));
    color *= 1.0 + 0.07 * fbm(p * 0.5, 4, 406u);
    // Capillaries keep to the creases and redden them.
    const dvec3 bent = p + 1.4 * perlin3(p * 0.25, 407u);
    const double web = ramp(0.88, 0.99, ridges(bent * 0.20, 2, 408u)) * ramp(0.0, 0.5, fbm(p * 0.045, 3, 409u));
    color = glm::mix(color, rgb(190, 64, 44), 0.30 * web);
    color = glm::mix(rgb(228, 154, 108), color, ramp(0.0, 0.9, at.vertex.mask + 0.3 * fbm(p * 0.2, 3, 413u)));
    texel.color = with_vessels(color, vessels, 0.75);
    texel.height = 1.0 * patchy * small.height + 0.16 * fbm(p * 0.5, 3, 410u) + 0.03 * fbm(p * 1.5, 2, 411u) +
                   0.7 * vessels.height;
    return texel;
}

Texel liver_tissue(const SurfacePoint& at, const VesselCover& vessels) {
    const dvec3& p = at.vertex.rest;
    Texel texel;
    const double broad = fbm(p * 0.03, 4, 501u);
    const Cell lobule = worley(p / 1.7 + 0.3 * perlin3(p * 0.5, 502u), 503u);
    const double rim = 1.0 - ramp(0.03, 0.25, lobule.second - lobule.nearest);
    dvec3 color = glm::mix(rgb(93, 30, 32), rgb(119, 44, 44), ramp(-0.6, 0.6, broad));
    color = glm::mix(color, rgb(104, 36, 44), 0.5 * ramp(0.0, 0.6, fbm(p * 0.09, 4, 504u)));
    color = glm::mix(color, rgb(172, 92, 86), 0.22 * rim * ramp(-0.3, 0.4, fbm(p * 0.07, 3, 505u)));
    color *= 1.0 + 0.10 * fbm(p * 0.7, 3, 506u) + 0.08 * (unit(lobule.id) - 0.5);
    color = glm::mix(color, rgb(170, 92, 84), 0.35 * at.vertex.mask);  // the edge is thin and fibrous
    // Under the capsule vessels shine through paler than the parenchyma.
    color = glm::mix(color, rgb(168, 90, 82), 0.30 * vessels.vein);
    texel.color = glm::mix(color, rgb(92, 18, 26), 0.7 * vessels.artery);
    texel.height = 0.09 * fbm(p * 0.25, 3, 507u) + 0.07 * fbm(p * 0.7, 3, 508u) - 0.02 * rim + 0.2 * vessels.height;
    return texel;
}

Texel membrane_tissue(const SurfacePoint& at, const VesselCover& vessels) {
    const dvec3& p = at.vertex.rest;
    const double fat = at.vertex.mask;
    const Lobules small = lobules(p, 5.5, 601u);
    Texel texel;
    const double veil = fbm(p * 0.05, 4, 602u);
    dvec3 thin = glm::mix(rgb(176, 96, 84), rgb(214, 150, 118), ramp(-0.5, 0.6, veil));
    thin = glm::mix(thin, rgb(140, 58, 58), 0.5 * ramp(0.1, 0.7, fbm(p * 0.07, 3, 603u)));
    const dvec3 fibres = dvec3(p.x * 0.10, p.y * 0.55, p.z * 0.2) + 0.7 * perlin3(p * 0.07, 604u);
    thin = glm::mix(thin, rgb(232, 190, 160), 0.30 * ramp(0.72, 0.97, ridges(fibres, 2, 605u)));
    dvec3 yellow = glm::mix(rgb(230, 156, 78), rgb(248, 200, 122), ramp(-0.5, 0.5, fbm(p * 0.1, 3, 606u)));
    yellow = glm::mix(yellow, rgb(200, 112, 66), 0.35 * small.crease * ramp(-0.4, 0.4, fbm(p * 0.08, 2, 611u)));
    const double fatty = ramp(0.30, 0.75, fat + 0.5 * fbm(p * 0.09, 5, 607u) + 0.15 * (small.height - 0.5));
    dvec3 color = glm::mix(thin, yellow, fatty);
    color *= 1.0 + 0.07 * fbm(p * 0.6, 3, 608u);
    texel.color = with_vessels(color, vessels, 0.82);
    texel.height = fatty * (0.9 * small.height + 0.5) + (1.0 - fatty) * (0.22 * fbm(fibres, 3, 609u)) +
                   0.12 * fbm(p * 0.5, 3, 610u) + vessels.height;
    return texel;
}

Texel ligament_tissue(const SurfacePoint& at, const VesselCover& vessels) {
    const dvec3& p = at.vertex.rest;
    Texel texel;
    // The band's direction in the field.
    const dvec3 along_band = glm::normalize(dvec3(0.87, -0.47, 0.0));
    const dvec3 across_band(along_band.y, -along_band.x, 0.0);
    const dvec3 fibre =
        dvec3(glm::dot(p, along_band) * 0.07, glm::dot(p, across_band) * 0.75, 0.0) + 0.5 * perlin3(p * 0.08, 651u);
    const double strand = ridges(fibre, 3, 652u);
    dvec3 color = glm::mix(rgb(206, 136, 122), rgb(224, 172, 156), ramp(-0.5, 0.5, fbm(p * 0.07, 4, 653u)));
    color = glm::mix(color, rgb(236, 200, 186), 0.42 * ramp(0.55, 0.95, strand));
    color = glm::mix(rgb(186, 106, 92), color, ramp(0.0, 0.8, at.vertex.mask + 0.25 * fbm(p * 0.15, 3, 654u)));
    color *= 1.0 + 0.05 * fbm(p * 0.6, 3, 655u);
    texel.color = with_vessels(color, vessels, 0.85);
    texel.height = 0.30 * strand + 0.10 * fbm(p * 0.5, 3, 656u) + vessels.height;
    return texel;
}

Texel wall_tissue(const SurfacePoint& at, const VesselCover& vessels) {
    const dvec3& p = at.vertex.rest;
    Texel texel;
    const double angle = std::atan2(p.x, p.y + 30.0) * 14.0;
    const dvec3 fibre(angle + 1.2 * fbm(p * 0.03, 3, 701u), glm::length(p) * 0.02, 0.0);
    const double strand = fbm(fibre * 1.3, 3, 702u);
    dvec3 color = glm::mix(rgb(120, 42, 40), rgb(158, 72, 60), ramp(-0.6, 0.7, fbm(p * 0.02, 4, 703u) + 0.5 * strand));
    color = glm::mix(color, rgb(206, 150, 118), 0.5 * at.vertex.mask * ramp(-0.3, 0.6, fbm(p * 0.03, 3, 704u)));
    color = glm::mix(color, rgb(214, 150, 84), 0.5 * ramp(0.25, 0.7, fbm(p * 0.025, 4, 705u)));
    color *= 1.0 + 0.08 * fbm(p * 0.25, 4, 706u);
    texel.color = with_vessels(color, vessels, 0.55);
    texel.height = 0.5 * strand + 0.25 * fbm(p * 0.2, 4, 707u) + vessels.height;
    return texel;
}

}  // namespace organs
