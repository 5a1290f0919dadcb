// An organ that is about to be loaded: what its file holds, and the unit and orientation that make it right.
//
//     choice.open("liver.stl");                 // reads it beside the UI; the organ dialog shows this
//     if (auto scale = choice.likely_scale()) choice.set_scale(*scale);
//     choice.load();                            // into the scene: one undo step
//
// UI thread.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/jobs.h"
#include "app/files/likely_texture.h"
#include "document/document.h"
#include "lapfx/authoring/organ_report.h"
#include "lapfx/organ.h"
#include "lapfx/scene.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class Settings;
struct Looking;

/// What one unit of a mesh can be.
struct LengthUnit {
    std::string_view name;
    double millimetres;
};
inline constexpr std::array<LengthUnit, 4> length_units = {{{"mm", 1}, {"cm", 10}, {"m", 1000}, {"inch", 25.4}}};
/// The index in length_units of this scale; -1: none.
int unit_of(double scale);

/// mm per unit with which a mesh that is `longest` units long has the usual size of an organ, nearest to that of a
/// liver; nothing where no unit gives that, or `scale` already does.
std::optional<double> likely_scale(double longest, double scale);
/// Why `better` is, of likely_scale(): "9.6 mm is small for an organ (5 to 600 mm are possible). If the unit is cm,
/// ...".
std::string reason_for(double longest, double scale, double better);

/// The ways up, and the rotations (degrees about x, then y, then z) that bring each to y.
struct UpAxis {
    std::string_view name;
    glm::dvec3 rotation;
};
inline const std::array<UpAxis, 6> up_axes = {{{"Y up, as it is", {0, 0, 0}},
                                               {"Z up", {-90, 0, 0}},
                                               {"X up", {0, 0, 90}},
                                               {"Y down", {0, 0, 180}},
                                               {"Z down", {90, 0, 0}},
                                               {"X down", {0, 0, -90}}}};
int up_axis_of(const glm::dvec3& rotation);

class OrganChoice {
  public:
    /// All must outlive it. An organ that is loaded is `looking` at whole, and no event is `selected`.
    OrganChoice(document::Document& document, Jobs& jobs, Settings& settings, Looking& looking,
                std::vector<std::size_t>& selected, ui::ImageStore& images)
        : document_(document),
          jobs_(jobs),
          settings_(settings),
          looking_(looking),
          selected_(selected),
          images_(images) {}
    ~OrganChoice();
    OrganChoice(const OrganChoice&) = delete;
    OrganChoice& operator=(const OrganChoice&) = delete;

    bool other_unit = false;  ///< the dialog has a field in which a length is typed

    /// Reads the file; with the scale and rotation of the scene's organ where it is the same file.
    void open(const std::filesystem::path& file);
    /// Once, after open(): the dialog is to be opened.
    bool take_asked() { return std::exchange(asked_, false); }
    /// Once, when the file has been read: what has to be decided first gets the keyboard.
    bool take_read() { return std::exchange(read_, false); }
    bool reading() const { return job_ != nullptr; }
    void give_up();

    const std::filesystem::path& file() const { return file_; }
    const std::vector<Fault>& faults() const { return faults_; }  ///< why it cannot be read
    bool ready() const { return organ_ != nullptr; }
    const OrganReport& report() const { return report_; }  ///< in units of the file, unturned
    std::vector<std::string> warnings() const;             ///< of the mesh, without those on its size
    /// The picture that the scene gives this organ in place of its own; empty: none.
    const std::filesystem::path& texture() const { return texture_; }
    void use_texture(const std::filesystem::path& picture) { texture_ = picture; }
    /// One that the file names and that cannot be read, unless the scene gives it another.
    const MissingTexture* missing_texture() const { return missing_ && texture_.empty() ? &*missing_ : nullptr; }

    double scale() const { return scale_; }  ///< mm per unit of the file
    void set_scale(double scale) { scale_ = scale; }
    const glm::dvec3& rotation() const { return rotation_; }
    void set_rotation(const glm::dvec3& degrees) { rotation_ = degrees; }
    glm::dvec3 size() const;  ///< mm, as chosen
    /// A picture of it as it is turned, made when it is asked for; 0: none.
    ui::ImageHandle picture();
    static constexpr glm::ivec2 picture_size{320, 160};
    double picture_pixel() const { return scale_ * units_per_pixel_; }  ///< mm of one px of it
    std::optional<double> likely() const;
    std::string reason() const;  ///< why likely() is
    /// Whether an organ can be as large as this one is with scale().
    bool possible() const;

    /// Another organ than the scene has: its events go.
    bool replaces() const;
    bool takes_events() const { return replaces() && !document_.scene().events.empty(); }  ///< there are some to go
    /// Puts it into the scene, with a camera that sees it whole. What belonged to another organ is removed: events, and
    /// the place where the tool entered.
    void load();

  private:
    void take(const std::shared_ptr<const Organ>& organ, OrganReport report, std::optional<MissingTexture> missing);
    OrganReport turned() const;

    document::Document& document_;
    Jobs& jobs_;
    Settings& settings_;
    Looking& looking_;
    std::vector<std::size_t>& selected_;
    ui::ImageStore& images_;
    ui::ImageHandle image_ = 0;     ///< of the images
    glm::dvec3 pictured_for_{1e9};  ///< rotation of that
    double units_per_pixel_ = 0;
    std::filesystem::path file_, texture_;
    std::shared_ptr<Job> job_;
    std::shared_ptr<const Organ> organ_;  ///< in units of the file
    OrganReport report_;
    std::optional<MissingTexture> missing_;
    std::vector<Fault> faults_;
    double scale_ = 1, standard_scale_ = 1;
    glm::dvec3 rotation_{0.0};
    bool asked_ = false, read_ = false;
    mutable glm::dvec3 measured_for_{1e9};  ///< rotation of the bounds below
    mutable glm::dvec3 low_{0.0}, high_{0.0};
};

}  // namespace lapfx::app
