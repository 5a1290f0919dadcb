#include "bench/streaming/decoding_rate.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "media/clip_stream.h"

namespace lapfx::bench {

double decoding_rate(std::span<const std::filesystem::path> clips, int loops, int threads) {
    constexpr int buffers = 4;  // each of 15 clips has as many while they play
    media::DecodePool pool(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<std::unique_ptr<media::ClipStream>> streams;
    std::vector<int> counts;
    int longest = 0;
    for (const std::filesystem::path& clip : clips) {
        media::Decoder decoder(clip, media::Layout::planar);
        counts.push_back(decoder.info().frame_count());
        longest = std::max(longest, counts.back());
        streams.push_back(
            std::make_unique<media::ClipStream>(pool, std::move(decoder), media::Loop{0, counts.back() - 1}, buffers));
    }
    double waited = 0.0;
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < loops * longest; ++frame)
        for (std::size_t i = 0; i < streams.size(); ++i)
            streams[i]->frame(frame % counts[i], media::Policy::wait, waited);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return seconds > 0.0 ? static_cast<double>(loops) * longest * static_cast<double>(streams.size()) / seconds : 0.0;
}

}  // namespace lapfx::bench
