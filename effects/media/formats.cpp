// FFmpeg opens far more than this; these are the names that lapfx knows a video or a picture by. A file of another name
// is a clip if FFmpeg can read it.
#include "media/formats.h"

namespace lapfx::media {

namespace {

constexpr std::string_view mp4[] = {".mp4"}, mov[] = {".mov"}, mkv[] = {".mkv"}, avi[] = {".avi"}, m4v[] = {".m4v"},
                           webm[] = {".webm"}, mpeg[] = {".mpg", ".mpeg"}, ts[] = {".ts"}, wmv[] = {".wmv"},
                           ogv[] = {".ogv"}, gif[] = {".gif"};
constexpr FileFormat videos[] = {
    {.name = "MP4", .content = Content::video, .extensions = mp4, .holds = "a video", .written = true},
    {.name = "QuickTime", .content = Content::video, .extensions = mov, .holds = "a video", .written = true},
    {.name = "Matroska", .content = Content::video, .extensions = mkv, .holds = "a video", .written = true},
    {.name = "AVI", .content = Content::video, .extensions = avi, .holds = "a video", .written = true},
    {.name = "M4V", .content = Content::video, .extensions = m4v, .holds = "a video"},
    {.name = "WebM", .content = Content::video, .extensions = webm, .holds = "a video, perhaps with alpha"},
    {.name = "MPEG", .content = Content::video, .extensions = mpeg, .holds = "a video"},
    {.name = "MPEG transport stream", .content = Content::video, .extensions = ts, .holds = "a video"},
    {.name = "Windows Media", .content = Content::video, .extensions = wmv, .holds = "a video"},
    {.name = "Ogg", .content = Content::video, .extensions = ogv, .holds = "a video"},
    {.name = "GIF", .content = Content::video, .extensions = gif, .holds = "an animation or a picture"},
};

constexpr std::string_view png[] = {".png"}, jpeg[] = {".jpg", ".jpeg"}, webp[] = {".webp"}, bmp[] = {".bmp"},
                           tiff[] = {".tif", ".tiff"}, exr[] = {".exr"};
constexpr Signature png_begins[] = {{"\x89PNG"}}, jpeg_begins[] = {{"\xff\xd8\xff"}}, webp_begins[] = {{"WEBP", 8}};
constexpr FileFormat pictures[] = {
    {.name = "PNG",
     .content = Content::picture,
     .extensions = png,
     .signatures = png_begins,
     .holds = "a picture, perhaps with alpha, or an animation",
     .texture = true,
     .written = true},
    {.name = "JPEG",
     .content = Content::picture,
     .extensions = jpeg,
     .signatures = jpeg_begins,
     .holds = "a picture",
     .texture = true},
    {.name = "WebP",
     .content = Content::picture,
     .extensions = webp,
     .signatures = webp_begins,
     .holds = "a still picture, perhaps with alpha",
     .texture = true},
    {.name = "BMP", .content = Content::picture, .extensions = bmp, .holds = "a picture", .texture = true},
    {.name = "TIFF", .content = Content::picture, .extensions = tiff, .holds = "a picture, as a clip or a reference"},
    {.name = "OpenEXR", .content = Content::picture, .extensions = exr, .holds = "a picture, as a clip or a reference"},
};

}  // namespace

std::span<const FileFormat> video_formats() {
    return videos;
}

std::span<const FileFormat> picture_formats() {
    return pictures;
}

}  // namespace lapfx::media
