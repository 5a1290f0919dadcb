#include "app/files/organ_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "app/base/jobs.h"
#include "app/base/paths.h"
#include "app/base/settings.h"
#include "app/files/organ_picture.h"
#include "app/preview/looking.h"
#include "app/preview/orbit.h"
#include "lapfx/authoring/organ_report.h"

namespace lapfx::app {

namespace {

constexpr double size_of_liver = 200.0;  // mm
constexpr double small_organ = 25.0;     // mm: few are shorter, an ovary for one; the unit may be another

bool close(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// The same rotation as in load_organ(): about x, then y, then z.
glm::dmat3 rotation_matrix(const glm::dvec3& degrees) {
    const glm::dvec3 angle = glm::radians(degrees);
    const glm::dmat4 x = glm::rotate(glm::dmat4(1.0), angle.x, glm::dvec3(1, 0, 0));
    const glm::dmat4 y = glm::rotate(glm::dmat4(1.0), angle.y, glm::dvec3(0, 1, 0));
    const glm::dmat4 z = glm::rotate(glm::dmat4(1.0), angle.z, glm::dvec3(0, 0, 1));
    return glm::dmat3(z * y * x);
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error) && !error;
}

double longest_side(const OrganReport& report) {
    const glm::dvec3 size = report.maximum - report.minimum;
    return std::max({size.x, size.y, size.z});
}

}  // namespace

int unit_of(double scale) {
    for (std::size_t i = 0; i < length_units.size(); ++i)
        if (close(length_units[i].millimetres, scale)) return static_cast<int>(i);
    return -1;
}

std::optional<double> likely_scale(double longest, double scale) {
    const auto possible = [&](double s) { return longest * s >= shortest_organ && longest * s <= longest_organ; };
    if (!(longest > 0)) return std::nullopt;
    const auto off = [&](double s) { return std::abs(std::log(longest * s / size_of_liver)); };
    if (possible(scale) && off(scale) <= std::log(size_of_liver / small_organ) + 1e-9) return std::nullopt;
    std::optional<double> best;
    // Inches only where nothing else will do.
    const auto distance = [&](const LengthUnit& unit) {
        return off(unit.millimetres) + (unit.name == "inch" ? 10.0 : 0.0);
    };
    double nearest = possible(scale) ? off(scale) : 1e300;
    for (const LengthUnit& unit : length_units) {
        if (!possible(unit.millimetres) || distance(unit) >= nearest) continue;
        nearest = distance(unit);
        best = unit.millimetres;
    }
    return best;
}

std::string reason_for(double longest, double scale, double better) {
    const auto mm = [](double length) {
        char text[32];
        std::snprintf(text, sizeof text, length < 1000 ? "%.4g mm" : "%.0f mm", length);
        return std::string(text);
    };
    const double now = longest * scale;
    const std::string off = now > longest_organ    ? " is larger than any organ"
                            : now < shortest_organ ? " is smaller than any organ"
                                                   : " is small for an organ";
    return mm(now) + off + " (" + std::to_string(static_cast<int>(shortest_organ)) + " to " + mm(longest_organ) +
           " are possible). If the unit is " +
           std::string(length_units[static_cast<std::size_t>(unit_of(better))].name) + ", its longest side is " +
           mm(longest * better) + ", nearest to a liver's " + mm(size_of_liver) + ".";
}

int up_axis_of(const glm::dvec3& rotation) {
    for (std::size_t i = 0; i < up_axes.size(); ++i)
        if (glm::distance(up_axes[i].rotation, rotation) < 1e-9) return static_cast<int>(i);
    return -1;
}

void OrganChoice::open(const std::filesystem::path& file) {
    give_up();
    file_ = file;
    asked_ = true;
    other_unit = false;
    const SceneOrgan& now = document_.scene().organ;
    const bool again = same_file(file, path_from(document_.scene().folder, now.file));
    scale_ = again ? now.scale : 0;  // 0: the format's
    rotation_ = again ? now.rotation : glm::dvec3(0);
    texture_ = again ? path_from(document_.scene().folder, now.texture) : std::filesystem::path();
    job_ = jobs_.start(
        "Reading " + file.filename().string(),
        [this, file](Job& job) -> Jobs::Apply {
            auto organ = std::make_shared<Organ>(load_organ(file));
            if (job.cancelled()) return {};
            // The default scale of the format is taken out again: what is chosen is to begin from the file's own
            // numbers.
            const double standard = organ->scale;
            for (glm::vec3& position : organ->positions) position = glm::vec3(glm::dvec3(position) / standard);
            OrganReport report = lapfx::report(*organ);
            std::optional<MissingTexture> missing = app::missing_texture(*organ, file);
            return [this, organ, report = std::move(report), missing = std::move(missing), standard] {
                standard_scale_ = standard;
                take(organ, report, missing);
            };
        },
        [this, file](const std::vector<Fault>& faults) {
            job_.reset();
            faults_ = faults;
            settings_.forget_missing({file.string()});
        });
}

void OrganChoice::give_up() {
    if (job_) job_->cancel();
    job_.reset();
    organ_.reset();
    faults_.clear();
    report_ = {};
    missing_.reset();
    pictured_for_ = glm::dvec3(1e9);
    measured_for_ = glm::dvec3(1e9);
}

OrganChoice::~OrganChoice() {
    if (image_ != 0) images_.remove(image_);
}

ui::ImageHandle OrganChoice::picture() {
    if (!organ_) return 0;
    if (pictured_for_ != rotation_) {
        pictured_for_ = rotation_;
        const OrganPicture made = organ_picture(*organ_, rotation_matrix(rotation_), picture_size);
        units_per_pixel_ = made.units_per_pixel;
        if (made.image.pixels.empty()) return 0;
        if (image_ == 0)
            image_ = images_.add(picture_size, made.image.pixels);
        else
            images_.update(image_, picture_size, made.image.pixels);
    }
    return image_;
}

void OrganChoice::take(const std::shared_ptr<const Organ>& organ, OrganReport report,
                       std::optional<MissingTexture> missing) {
    missing_ = std::move(missing);
    job_.reset();
    organ_ = organ;
    report_ = std::move(report);
    read_ = true;
    if (scale_ == 0) scale_ = standard_scale_;
}

std::vector<std::string> OrganChoice::warnings() const {
    if (!organ_) return {};
    std::vector<std::string> all = organ_->warnings;
    // Its own pictures are not wanted where the scene gives it another one; a missing one is told apart.
    std::erase_if(all, [&](const std::string& one) {
        if (!one.starts_with("texture ")) return false;
        return !texture_.empty() || (missing_ && one.find(missing_->missing.filename().string()) != std::string::npos);
    });
    return all;
}

OrganReport OrganChoice::turned() const {
    if (organ_ && measured_for_ != rotation_) {
        measured_for_ = rotation_;
        const glm::dmat3 matrix = rotation_matrix(rotation_);
        low_ = glm::dvec3(1e300), high_ = glm::dvec3(-1e300);
        for (const glm::vec3& position : organ_->positions) {
            const glm::dvec3 place = matrix * glm::dvec3(position);
            low_ = glm::min(low_, place), high_ = glm::max(high_, place);
        }
    }
    OrganReport report = report_;
    report.minimum = low_ * scale_, report.maximum = high_ * scale_;
    return report;
}

glm::dvec3 OrganChoice::size() const {
    const OrganReport report = turned();
    return report.maximum - report.minimum;
}

bool OrganChoice::possible() const {
    const double longest = longest_side(turned());
    return organ_ && longest >= shortest_organ && longest <= longest_organ;
}

std::optional<double> OrganChoice::likely() const {
    return organ_ ? likely_scale(longest_side(report_), scale_) : std::nullopt;
}

std::string OrganChoice::reason() const {
    const std::optional<double> better = likely();
    return better ? reason_for(longest_side(report_), scale_, *better) : std::string{};
}

bool OrganChoice::replaces() const {
    const Scene& scene = document_.scene();
    return scene.organ.file.empty() || !same_file(file_, path_from(scene.folder, scene.organ.file));
}

void OrganChoice::load() {
    if (!organ_) return;
    const OrganReport organ = turned();
    document_.change("Load organ", [&](document::Content& c) {
        Scene& scene = c.scene;
        if (replaces()) {
            scene.name = file_.stem().string();
            scene.events.clear();
            scene.organ = {};
        }
        scene.organ.file = path_for(file_, scene.folder);
        scene.organ.scale = scale_;
        scene.organ.rotation = rotation_;
        if (!texture_.empty()) scene.organ.texture = path_for(texture_, scene.folder);
        see_whole(scene, organ);
    });
    settings_.note_recent(file_.string());
    selected_.clear();
    looking_.camera = document_.scene().camera;
    give_up();
}

}  // namespace lapfx::app
