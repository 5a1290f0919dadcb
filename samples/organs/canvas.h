// The textures of one material: vessels are drawn first, then the tissue is painted texel by texel at its 3D position,
// so that no seam shows. Finally the heights become a normal map.
#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <vector>

#include "patch.h"
#include "vessels.h"

namespace organs {

/// How much of a texel is vessel, 0..1, and how far it rises above the tissue, mm.
struct VesselCover {
    double artery = 0.0;
    double vein = 0.0;
    double height = 0.0;
};

/// One texel of tissue: sRGB 0..1, relief in mm.
struct Texel {
    dvec3 color{1.0};
    double height = 0.0;
};
using Tissue = std::function<Texel(const SurfacePoint&, const VesselCover&)>;

struct VesselStyle {
    bool vein = false;
    double aside = 0.0;     ///< drawn this many radii next to the tree's line
    double thinnest = 0.0;  ///< thinner radii are left out, mm
    double width = 1.0;     ///< times the radius
    double strength = 1.0;  ///< how opaque, 0..1; thin vessels are fainter
    double raised = 0.5;    ///< height in radii
};

class Canvas {
  public:
    explicit Canvas(int size);
    void draw(const Patch& patch, const VesselTree& tree, const VesselStyle& style);
    void paint(const Patch& patch, const Tissue& tissue);
    std::vector<std::uint8_t> color_jpeg(int quality) const;
    std::vector<std::uint8_t> normal_jpeg(int size, int quality) const;

  private:
    void find_normals(const Patch& patch, const cv::Rect& box);
    void segment(const Patch& patch, const VesselNode& from, const VesselNode& to, const VesselStyle& style);
    cv::Rect texels(const Patch& patch, int margin) const;
    dvec2 patch_uv(const Patch& patch, int x, int y) const;

    int size_;
    cv::Mat vessels_;  // CV_32FC3: artery, vein, height
    cv::Mat color_;    // CV_32FC3, BGR, sRGB 0..1
    cv::Mat height_;   // CV_32F, mm
    cv::Mat normal_;   // CV_32FC3, BGR, -1..1
};

}  // namespace organs
