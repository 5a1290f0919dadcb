// Frames that show no tissue: a bag or a cloth that fills the view, and the inside of a trocar, through which the
// endoscope comes and goes. Measured against a baseline they would be smoke.
//
//     if (match::trap_of(code, match::view_of(code)) != match::InView::tissue) skip();
//
// Pure, any thread; needs no baseline.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace lapfx::match {

/// What fills the view.
enum class InView : std::uint8_t {
    tissue,
    bag,     ///< nothing is as red as tissue is, even behind dense smoke: a bag, a cloth, a title card
    trocar,  ///< a white ring lies close around a darker middle, in which tissue may be seen
    dark     ///< the picture is black
};

/// How red the reddest tenth of a view is: ln(green / red) of code values, below which a tenth of the lit pixels lie. A
/// veil is pale, so this grows towards 0 behind it, however pale or dark the rest of the tissue is: below -0.75 in
/// clear frames of four operations, -0.6 to -0.25 behind dense smoke, 0 for what is grey. 0 where nothing is lit.
double reddest_tenth(const cv::Mat& code, const cv::Mat& view);

/// `code`: CV_8UC3 BGR, 128 to 512 px on its longer side; `view`: CV_8U 255 inside (view_of), of the whole picture: a
/// part that was chosen has another rim. What is neither bag nor trocar is tissue here, a black picture, too.
InView trap_of(const cv::Mat& code, const cv::Mat& view);

}  // namespace lapfx::match
