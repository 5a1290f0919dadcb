#include "match/picture/overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr int largest_side = 1280;
constexpr int least_side = 160;  // px of the longer side: in smaller pictures a letter is no more than a fold
constexpr int least_frames = 4;
constexpr double still = 20.0;          // code values by which compression changes a pixel of the text
constexpr double moving = 0.3;          // share of the pixels around it that change by more
constexpr double moving_ring = 0.85;    // the same of those next to it
constexpr double stands_out = 45.0;     // code values between the text and the mean around it
constexpr double edge_contrast = 20.0;  // code values between the text and what is next to it
constexpr double edge_share = 0.6;      // of what is next to it that has this contrast
constexpr double outline_share = 0.6;   // of its outline that has an edge of this contrast in each of the frames
constexpr double lit = 60.0;            // black hollows stay as they are, too
constexpr double reach = 0.08;          // of the longer side: what lies around a pixel
constexpr double gap = 0.008;           // of the longer side, between strokes of a letter
constexpr double least_share = 2e-5;    // of the picture: less is noise
constexpr double most_share = 0.1;      // of the picture: more is a view that hardly changes

cv::Mat strongest_channel(const cv::Mat& picture) {
    cv::Mat channels[3], most;
    cv::split(picture, channels);
    cv::max(channels[0], channels[1], most);
    cv::max(most, channels[2], most);
    return most;
}

int odd(double length) {
    return 2 * std::max(1, static_cast<int>(std::lround(length / 2.0))) + 1;
}

/// Whether most of `ring` has another colour than a shape in the darkest or brightest picture of a video.
bool has_edge(const cv::Mat& picture, const cv::Mat& shape, const cv::Mat& ring) {
    cv::Mat off;
    cv::absdiff(picture, cv::mean(picture, shape), off);
    return cv::countNonZero(ring & (strongest_channel(off) >= edge_contrast)) >= edge_share * cv::countNonZero(ring);
}

/// The largest difference between a pixel and those next to it.
cv::Mat edges_of(const cv::Mat& code) {
    cv::Mat edges;
    cv::morphologyEx(code, edges, cv::MORPH_GRADIENT, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
    return strongest_channel(edges);
}

struct Extremes {
    cv::Mat moves, least, most, edges;
    Extremes operator()(const cv::Rect& part) const { return {moves(part), least(part), most(part), edges(part)}; }
};

/// Whether the outline of a shape is seen in each frame. Of few frames much tissue that moves keeps its value by
/// chance, and its outline with that; but what is next to it is as bright in one of them.
bool has_outline(const cv::Mat& shape, const cv::Mat& edges) {
    cv::Mat outline;
    cv::morphologyEx(shape, outline, cv::MORPH_GRADIENT, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
    return cv::countNonZero(outline & (edges >= edge_contrast)) >= outline_share * cv::countNonZero(outline);
}

/// Whether what lies closely around a shape moves, and never becomes as the shape: then the shape is no part of it.
/// Tissue that is as bright as the smoke, or lies between two places of an instrument, keeps its value as well; but at
/// their brightest it and what is next to it are one.
bool lies_over(const cv::Mat& shape, const cv::Mat& strokes, const Extremes& seen) {
    cv::Mat edge, wide;
    cv::dilate(shape, edge, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    cv::dilate(shape, wide, cv::getStructuringElement(cv::MORPH_ELLIPSE, {11, 11}));
    const cv::Mat ring = wide & ~edge, drawn = shape & strokes;
    return has_outline(shape, seen.edges) &&
           cv::countNonZero(ring & seen.moves) >= moving_ring * cv::countNonZero(ring) &&
           has_edge(seen.least, drawn, ring) && has_edge(seen.most, drawn, ring);
}

/// Text and logos keep away from the edge of the picture, where a recorder may leave a line.
bool touches_edge(const cv::Rect& part, cv::Size whole) {
    return part.x == 0 || part.y == 0 || part.br().x == whole.width || part.br().y == whole.height;
}

/// Whole letters and logos: what is between strokes belongs to them.
cv::Mat filled(const cv::Mat& strokes, const Extremes& seen, int across) {
    cv::Mat closed, all = cv::Mat::zeros(strokes.size(), CV_8U);
    cv::morphologyEx(strokes, closed, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_ELLIPSE, {across, across}));
    std::vector<std::vector<cv::Point>> shapes;
    cv::findContours(closed, shapes, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    const cv::Rect whole({}, strokes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (cv::contourArea(shapes[i]) < least_share * static_cast<double>(strokes.total())) continue;
        const cv::Rect around = cv::boundingRect(shapes[i]);
        if (touches_edge(around, whole.size())) continue;
        const cv::Rect near = cv::Rect(around.x - 8, around.y - 8, around.width + 16, around.height + 16) & whole;
        cv::Mat shape = cv::Mat::zeros(near.size(), CV_8U);
        cv::drawContours(shape, shapes, static_cast<int>(i), 255, cv::FILLED, cv::LINE_8, cv::noArray(), 0, -near.tl());
        if (lies_over(shape, strokes(near), seen(near))) all(near) |= shape;
    }
    cv::dilate(all, all, cv::Mat());  // compression blurs their edges
    return all;
}

}  // namespace

void OverlaySurvey::add(const Image& frame) {
    const double scale = std::min(1.0, static_cast<double>(largest_side) / std::max(frame.width, frame.height));
    // Pictures of a folder may differ by a pixel; all are laid over the first.
    const cv::Size own(std::max(1, static_cast<int>(std::lround(frame.width * scale))),
                       std::max(1, static_cast<int>(std::lround(frame.height * scale)))),
        size = frames_ == 0 ? own : least_.size();
    cv::Mat code;
    shrink(frame, size, code);
    const cv::Mat edges = edges_of(code);
    if (frames_++ == 0) {
        code.copyTo(least_);
        code.copyTo(most_);
        edges.copyTo(edges_);
        return;
    }
    cv::min(edges_, edges, edges_);
    cv::min(least_, code, least_);
    cv::max(most_, code, most_);
}

cv::Mat OverlaySurvey::found(cv::Size size) const {
    cv::Mat marks = cv::Mat::zeros(size, CV_8U);
    if (frames_ < least_frames) return marks;
    const int side = std::max(least_.cols, least_.rows), around = odd(reach * side);
    if (side < least_side) return marks;
    const cv::Mat change = strongest_channel(most_ - least_), brightest = strongest_channel(least_);
    const cv::Mat moves = change > still;
    cv::Mat moved, around_code, off;
    cv::blur(moves, moved, {around, around});
    cv::blur(brightest, around_code, {around, around});
    cv::absdiff(brightest, around_code, off);
    const cv::Mat strokes = (change <= still) & (moved >= 255.0 * moving) & (off >= stands_out) & (brightest >= lit);
    const cv::Mat whole = filled(strokes, {moves, least_, most_, edges_}, odd(gap * side));
    if (cv::countNonZero(whole) > most_share * static_cast<double>(whole.total())) return marks;
    cv::resize(whole, marks, size, 0, 0, cv::INTER_AREA);
    return marks > 0;
}

}  // namespace lapfx::match
