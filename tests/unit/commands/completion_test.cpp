// What a value may be; tests/e2e/man_test.py has bash complete with the script.
#include "commands/completion.h"

#include <gmock/gmock.h>

namespace lapfx::commands {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Completion, WordsAreThoseInSmallLetters) {
    EXPECT_THAT(values_of("egl|osmesa|auto").words, ElementsAre("egl", "osmesa", "auto"));
    EXPECT_THAT(values_of("Tune|Key|NAME").words, ElementsAre("Tune", "Key"));
    EXPECT_THAT(values_of("bash").words, ElementsAre("bash"));
    for (const char* takes : {"WxH", "S", "N", "KEY=VALUE", "x,y,r", "SMOKY CLEAR", "KEY,...", ""}) {
        EXPECT_THAT(values_of(takes).words, IsEmpty()) << takes;
        EXPECT_THAT(values_of(takes).endings, IsEmpty()) << takes;
    }
}

TEST(Completion, FilesAreOfTheKindsThatAreTaken) {
    EXPECT_THAT(values_of("FILE").endings, ElementsAre(""));
    EXPECT_THAT(values_of("FILE.scene.json").endings, ElementsAre(".scene.json"));
    EXPECT_THAT(values_of("POLYGON|FILE.json").endings, ElementsAre(".json"));
    EXPECT_THAT(values_of("SCENE").endings, ElementsAre(".scene.json"));
    EXPECT_THAT(values_of("DIR").endings, ElementsAre("/"));
    const std::vector<std::string> shown = values_of("SCENE|VIDEO").endings;
    for (const char* ending : {".scene.json", ".mp4", ".mov", ".png"}) EXPECT_THAT(shown, Contains(ending));
}

}  // namespace
}  // namespace lapfx::commands
