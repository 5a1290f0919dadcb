// Bytes of a valid document are changed at random, always the same way: reading it either throws Error or
// gives a document that is written, read and written to the same text.
#include <gtest/gtest.h>

#include <random>

#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

std::string mutate(std::string text, std::mt19937& random) {
    static const std::string pieces[] = {"\"",
                                         "{",
                                         "}",
                                         "[",
                                         "]",
                                         ":",
                                         ",",
                                         "-",
                                         "1e308",
                                         "null",
                                         "true",
                                         "\\u0000",
                                         "\xff",
                                         "0",
                                         "#ffffff",
                                         "../",
                                         "\"speed\": 1, ",
                                         "[0,0,0]",
                                         std::string(1, '\0')};
    const auto below = [&](std::size_t bound) { return random() % bound; };
    for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, 1 + below(8));
                break;
            case 2:
                text.insert(at, pieces[below(std::size(pieces))]);
                break;
            case 3:  // another number, so that enough of the documents stay valid
                if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
                    text[digit] = static_cast<char>('0' + below(10));
                break;
            case 4:
                text.insert(at, text.substr(below(text.size()), below(60)));
                break;
        }
    }
    return text;
}

struct Outcome {
    int read = 0;
    int refused = 0;
};

template <class Parse, class Write>
Outcome fuzz(const std::string& seed_text, const Parse& parse, const Write& write) {
    std::mt19937 random(20100927);
    Outcome outcome;
    for (int i = 0; i < 20'000; ++i) {
        const std::string text = mutate(seed_text, random);
        try {
            const std::string once = write(parse(text));
            EXPECT_EQ(write(parse(once)), once) << text;
            ++outcome.read;
        } catch (const Error& error) {
            EXPECT_FALSE(error.faults().empty());
            EXPECT_EQ(std::string(error.what()).find('\xff'), std::string::npos);
            ++outcome.refused;
        }
    }
    return outcome;
}

TEST(Fuzz, PresetIsRefusedOrStable) {
    Preset start;  // short, so that more of the changes hit something
    start.smoke.clips = {{.file = "a.mp4"}};
    const Outcome outcome = fuzz(
        write_preset(start), [](const std::string& text) { return parse_preset(text, "fuzz"); }, write_preset);
    EXPECT_GT(outcome.read, 500);
    EXPECT_GT(outcome.refused, 5000);
}

TEST(Fuzz, SceneIsRefusedOrStable) {
    const Outcome outcome = fuzz(
        write_scene(test::full_scene()), [](const std::string& text) { return parse_scene(text, "fuzz"); },
        write_scene);
    EXPECT_GT(outcome.read, 500);
    EXPECT_GT(outcome.refused, 5000);
}

}  // namespace

}  // namespace lapfx
