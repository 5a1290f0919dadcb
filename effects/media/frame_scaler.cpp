#include "media/frame_scaler.h"

#include <utility>

#include "lapfx/error.h"

extern "C" {
#include <libavutil/opt.h>
}

namespace lapfx::media {

void FrameScaler::prepare(const Source& source) {
    if (scaler_ && source == source_) return;
    libav::Scaler scaler(libav::made(sws_alloc_context()));
    SwsContext* s = scaler.get();
    // Interpolates chroma as the graphics card does, so that both layouts show the same picture.
    const int flags = SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP;
    const std::pair<const char*, int> options[] = {
        {"srcw", source.width},           {"srch", source.height},          {"src_format", source.format},
        {"dstw", source.size.x},          {"dsth", source.size.y},          {"dst_format", format_},
        {"src_range", source.full_range}, {"dst_range", color_.full_range}, {"sws_flags", flags}};
    for (const auto& [name, value] : options) av_opt_set_int(s, name, value, 0);
    if (sws_init_context(s, nullptr, nullptr) < 0)
        throw Error(Failure::bad_input, Fault{"", "", "has a pixel format that cannot be converted"});
    sws_setColorspaceDetails(s, sws_getCoefficients(source.space), source.full_range, sws_getCoefficients(color_.space),
                             color_.full_range, 0, 1 << 16, 1 << 16);
    if (!scaled_ || scaled_->width != source.size.x || scaled_->height != source.size.y)
        scaled_ = libav::frame_of(source.size.x, source.size.y, format_);
    scaler_ = std::move(scaler);  // nothing throws from here on
    source_ = source;
}

const AVFrame& FrameScaler::convert(const AVFrame& frame, const ClipColor& from, glm::ivec2 size) {
    prepare({frame.width, frame.height, frame.format, from.space, from.full_range, size});
    sws_scale(scaler_.get(), frame.data, frame.linesize, 0, frame.height, scaled_->data, scaled_->linesize);
    return *scaled_;
}

}  // namespace lapfx::media
