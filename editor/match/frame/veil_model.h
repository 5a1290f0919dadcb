// The mean veil of a frame from its statistics (veil_statistics.h) and the mean of its map (veil.h): what is to be
// added to the map's, by a ridge regression with squares and products (Hoerl and Kennard 1970). Where the baseline lies
// over the frame and the light of smoke is known the map is nearly exact; the ridge draws to it. Where the tissue does
// not lie so, what differs from the baseline is taken for veil: there the map is too high, and a second regression, of
// the statistics alone, is the most that is told.
//
// Both were learned from renders of ours, whose veil is known exactly, by `lapfx bench measure --learn`; the file that
// it wrote, veil_model.json, is part of the library and says from how many renders of which seed, and how far it was
// off on those that were left out.
//
// Any thread; no OpenGL.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/frame/veil_statistics.h"

namespace lapfx::match {

struct VeilFigures {
    VeilStatistics statistics{};
    double map = 0.0;  ///< mean of the veil's map over the same part, 0..1
    /// How much of the baseline's texture is where the camera's motion lays it, 0..1: there the map is right, however
    /// much more of it is found by tissue's own motion.
    double likeness = 1.0;
};

/// A picture whose veil is known.
struct VeilExample {
    VeilFigures figures;
    double veil = 0.0;  ///< the true one, mean over the view, 0..1
    int view = 0;       ///< pictures of one view are left out together
};

/// What the error of a model is on views that it was not learned from.
struct VeilModelError {
    double mean_absolute = 0.0, bias = 0.0, correlation = 0.0;
};

class VeilModel {
  public:
    /// Learns from at least 100 examples of at least five views. `origin`: said in the file, for people. The error is
    /// that of five models, each learned without a fifth of the views. Throws Error (bad_input) for fewer.
    static VeilModel learn(std::span<const VeilExample> examples, const std::string& origin);
    /// What json() wrote. Throws Error (bad_input), naming `name` and the place.
    static VeilModel read(std::string_view json, const std::string& name);
    /// The one of veil_model.json.
    static const VeilModel& shipped();

    /// 0..1.
    double veil_of(const VeilFigures& figures) const;
    const VeilModelError& error() const { return error_; }
    const std::string& origin() const { return origin_; }
    std::string json() const;

  private:
    /// Of each term, in the order of terms_of(): root mean square, and factor.
    struct Ridge {
        std::vector<double> size, weights;
        double of(std::span<const double> terms) const;
    };
    static Ridge learned(std::span<const VeilExample> examples, bool with_map, double penalty);
    static VeilModel fitted(std::span<const VeilExample> examples);

    std::string origin_;
    int examples_ = 0, views_ = 0;
    VeilModelError error_;
    Ridge with_map_, without_map_;  // what is to be added to the map; the veil
};

}  // namespace lapfx::match
