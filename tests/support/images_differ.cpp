// images_differ A B MAX: exit 0 when no channel of any pixel differs by more than MAX code values, else 1 and where.
#include <cstdlib>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "support/image_compare.h"

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: images_differ A B MAX\n";
        return 2;
    }
    const cv::Mat a = cv::imread(argv[1], cv::IMREAD_COLOR), b = cv::imread(argv[2], cv::IMREAD_COLOR);
    const auto result = lapfx::tests::compare(a, b, {.max_difference = std::atoi(argv[3])});
    std::cout << result.reason << '\n';
    return result.passed ? 0 : 1;
}
