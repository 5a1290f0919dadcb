// What the tool does to the organ: heat, the wounds that it opens and closes, and the marks that it leaves. CPU only.
// It is a function of the log and the time: any order of times and of set() gives the same result. One thread at a
// time.
//
// Parts of a tip's path that are farther than 5 mm from the surface are left out, because the tip touches nothing
// there. An empty surface has no wounds and no marks. Suction and irrigation do nothing here; clips (clips.h) seal
// wounds.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cautery/bioheat.h"
#include "cautery/burnt_area.h"
#include "cautery/clips.h"
#include "cautery/radial.h"
#include "cautery/track.h"
#include "organ/changed_vertices.h"
#include "organ/point_set.h"

namespace lapfx::cautery {

class Cautery {
  public:
    /// Keeps a reference to the surface. `strength_at` may be empty: 1 everywhere. It is asked when a wound may open.
    Cautery(const Surface& surface, StrengthAt strength_at);
    Cautery(const Cautery&) = delete;
    Cautery& operator=(const Cautery&) = delete;

    /// `changed`: the redo bits (lapfx/parameter.h) of what differs from the parameters before, at first those of
    /// CauteryParameters{}; and redo::heat where strength_at gives other answers than before. The next set() computes
    /// everything again that they say.
    void set_parameters(const CauteryParameters& parameters, unsigned changed);
    /// Takes what the tool has done and will do. The cost depends on what was written to the log since the last call. A
    /// change before its last piece computes the marks again. It must always be the same log.
    void set(const tool::Log& log);
    /// Heat, wounds and marks at `time`. Times that are not finite are ignored.
    void update(double time) noexcept;

    /// All wounds that start at or before the updated time, and perhaps later ones, with their stops as far as known.
    /// Within 1 mm only the first wound counts, of several at one time the strongest, while it is open and at least as
    /// strong. The first WoundList::most (4096) are kept; later ones are left out. Valid until the next set() or
    /// update().
    std::span<const Wound> wounds() const { return list().wounds(); }
    /// Changes when the wounds do.
    std::uint64_t wounds_version() const { return heat_version() + clips_.version(); }
    /// Changes when the clips do.
    std::uint64_t clips_version() const { return clips_.version(); }
    /// Wounds that were left out because there were too many.
    std::size_t left_out() const { return list().left_out(); }

    /// All present and future clips, in the order of their times.
    std::span<const Clip> clips() const { return clips_.clips(); }

    /// Per organ vertex: x char 0..1, y divided 0..1.
    std::span<const glm::vec2> marks() const { return marks_; }
    /// Burnt surface at rest, mm2: its char is as brown as at the char temperature, or darker.
    double burnt_area() const { return burnt_.area(); }
    /// Which marks have changed.
    ChangedVertices& changed() { return changed_; }

    /// Degrees Celsius of the surface at `place`; 37 far from it. In the model bioheat this costs a seek.
    double temperature(const glm::dvec3& place, double time);

    /// What set() and update() have cost so far in the model radial, as a count: pieces of the log, places, heatings
    /// and points of the surface that were worked on.
    std::uint64_t work() const { return track_.work() + radial_.work() + work_; }

  private:
    /// Per point of the surface the highest rise in degrees and how far it is divided, and the points where there is
    /// any.
    struct Layer {
        std::vector<glm::vec2> values;
        std::vector<std::uint32_t> points;
    };

    const WoundList& list() const { return bioheat_ ? bioheat_->wounds() : radial_.wounds(); }
    std::uint64_t heat_version() const { return list().version() + versions_; }
    void choose_model();
    SealedAt sealed_at();
    void clear(Layer& layer);
    void contribute(std::uint32_t contact, double time, Layer& layer);
    void raise(Layer& layer, std::uint32_t point, glm::vec2 value);
    void divide_around(const glm::dvec3& place, ToolAction action, Layer& layer);
    void publish();

    const Surface& surface_;
    StrengthAt strength_at_;
    CauteryParameters parameters_;
    unsigned due_ = ~0U;  // redo bits: what the next set() has to do again
    Track track_;
    Radial radial_;
    std::unique_ptr<Bioheat> bioheat_;  // while the model is bioheat
    std::uint64_t versions_ = 0;        // added to the model's own, so that versions grow when the model changes
    ClipList clips_;

    // The last contact grows while its button is held, so its marks are a layer over those of all others.
    Layer settled_, last_;
    bool all_stale_ = true, last_stale_ = true;
    double updated_ = 0.0;
    organ::PointSet dirty_;  // points whose marks may have changed
    std::vector<glm::vec2> marks_;
    ChangedVertices changed_;

    std::vector<float> peaks_;  // per point: the highest rise, degrees
    BurntArea burnt_;
    bool remeasure_ = true;  // all of them count as changed

    std::vector<Bell> bells_;
    std::vector<std::uint32_t> near_;
    std::uint64_t work_ = 0;
};

}  // namespace lapfx::cautery
