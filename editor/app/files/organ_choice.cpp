#include "app/files/organ_choice.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "app/base/jobs.h"
#include "app/base/paths.h"
#include "app/base/settings.h"
#include "app/preview/looking.h"
#include "app/preview/orbit.h"
#include "lapfx/authoring/organ_report.h"

namespace lapfx::app {

namespace {

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
    if (!(longest > 0) || possible(scale)) return std::nullopt;
    std::optional<double> best;
    // Nearest to a liver; inches only where nothing else will do.
    const auto distance = [&](const LengthUnit& unit) {
        return std::abs(std::log(longest * unit.millimetres / 200)) + (unit.name == "inch" ? 10.0 : 0.0);
    };
    double nearest = 1e300;
    for (const LengthUnit& unit : length_units) {
        if (!possible(unit.millimetres) || distance(unit) >= nearest) continue;
        nearest = distance(unit);
        best = unit.millimetres;
    }
    return best;
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
            return [this, organ, report = std::move(report), standard] {
                standard_scale_ = standard;
                take(organ, report);
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
    measured_for_ = glm::dvec3(1e9);
}

void OrganChoice::take(const std::shared_ptr<const Organ>& organ, OrganReport report) {
    job_.reset();
    organ_ = organ;
    report_ = std::move(report);
    if (scale_ == 0) scale_ = standard_scale_;
}

std::vector<std::string> OrganChoice::warnings() const {
    return organ_ ? organ_->warnings : std::vector<std::string>{};
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

bool OrganChoice::replaces() const {
    const Scene& scene = document_.scene();
    return scene.organ.file.empty() || !same_file(file_, path_from(scene.folder, scene.organ.file));
}

void OrganChoice::load() {
    if (!organ_) return;
    SceneCamera seen = frame(turned());
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
        seen.exposure = scene.camera.exposure;
        seen.vignette = scene.camera.vignette;
        scene.camera = seen;
        scene.tool.port = port_for(seen);
        scene.light.focus_distance = std::clamp(glm::distance(seen.eye, seen.target), 1.0, 2000.0);
    });
    settings_.note_recent(file_.string());
    selected_.clear();
    looking_.camera = seen;
    give_up();
}

}  // namespace lapfx::app
