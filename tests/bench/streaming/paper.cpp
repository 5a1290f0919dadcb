#include <cstdio>

#include "bench/streaming/streaming.h"

namespace lapfx::bench {

namespace {

StreamingRow printed(const char* scheme, int streams, double open, double retrieve, double copy, double upload,
                     double shading, double total, double fps) {
    return {.scheme = scheme,
            .streams = streams,
            .open = open,
            .retrieve = retrieve,
            .copy = copy,
            .upload = upload,
            .shading = shading,
            .total = total,
            .fps = fps};
}

}  // namespace

std::span<const StreamingRow> paper_table_2() {
    static const StreamingRow rows[] = {
        printed("paper pipeline", 1, 100.258, 2.17665, 0.235747, 1.54582, 0.384965, 1.64677, 59.4923),
        printed("paper pipeline", 2, 151.904, 4.17174, 0.5333594, 3.1579, 0.447961, 3.25741, 59.468),
        printed("paper pipeline", 3, 195.64, 6.41025, 0.870259, 4.68073, 0.564852, 4.78104, 59.4719),
        printed("paper pipeline", 5, 293.509, 12.5976, 2.19474, 8.27805, 1.03806, 8.40228, 59.4575),
        printed("paper pipeline", 8, 430.997, 22.4896, 4.28879, 16.5888, 2.17362, 16.7192, 47.4496),
        printed("paper pipeline", 10, 548.292, 28.281, 5.67987, 22.1224, 4.3373, 22.2582, 37.7391),
        printed("paper pipeline", 15, 776.62, 43.3006, 8.65272, 32.4184, 10.183, 32.5438, 26.9911),
        printed("paper buffered", 1, 102.164, 2.17056, 0.341065, 0.775565, 0.377916, 0.873131, 59.4874),
        printed("paper buffered", 2, 151.258, 4.44614, 0.671104, 1.555, 0.441045, 1.65732, 59.487),
        printed("paper buffered", 3, 200.999, 6.5289, 0.99612, 2.46336, 0.556842, 2.56828, 59.4847),
        printed("paper buffered", 5, 299.193, 11.0834, 1.70013, 3.84415, 1.02658, 3.94769, 59.4551),
        printed("paper buffered", 8, 445.926, 19.49, 3.40009, 6.87388, 2.15974, 7.00681, 59.3467),
        printed("paper buffered", 10, 548.132, 27.1295, 5.28326, 10.8744, 4.33791, 11.0062, 52.8614),
        printed("paper buffered", 15, 783.42, 41.0246, 8.04662, 16.1795, 10.1966, 16.3174, 36.5566),
    };
    return rows;
}

std::string streaming_table(std::span<const StreamingRow> rows) {
    std::string text =
        "scheme            streams   open  retrieve    copy    wait  to GPU  shading   total   frame   +-      fps  "
        "resident   sent\n"
        "                              ms        ms      ms      ms      ms       ms      ms      ms   ms              "
        "   %  frames\n";
    char line[200];
    for (const StreamingRow& r : rows) {
        std::snprintf(line, sizeof line,
                      "%-17s %7d %6.0f %9.2f %7.2f %7.2f %7.3f %8.2f %7.2f %7.2f %4.1f %8.1f %9.0f %7.1f\n",
                      r.scheme.c_str(), r.streams, r.open, r.retrieve, r.copy, r.wait, r.upload, r.shading, r.total,
                      r.frame, r.spread, r.fps, 100.0 * r.resident, r.sent);
        text += line;
    }
    text +=
        "\nLate: the display is half as fast as the clips; buffering then skips consecutive frames, as the paper's "
        "does, and shows\neach frame that it sends for two cycles. The frames sent are those of all streams in a "
        "cycle, on average.\n";
    text +=
        "\nAs the paper's table 2 prints it (GeForce 9800 GX2, quad core 2.83 GHz, at most 60 frames per second):\n";
    for (const StreamingRow& r : paper_table_2()) {
        std::snprintf(line, sizeof line, "%-17s %7d %6.0f %9.2f %7.2f %7s %7.3f %8.2f %7.2f %7s %4s %8.1f\n",
                      r.scheme.c_str(), r.streams, r.open, r.retrieve, r.copy, "", r.upload, r.shading, r.total, "", "",
                      r.fps);
        text += line;
    }
    return text;
}

}  // namespace lapfx::bench
