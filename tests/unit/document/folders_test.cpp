// The user's folders according to the environment.
#include "document/folders.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "unit/preset/support.h"

namespace lapfx::document {
namespace {

namespace fs = std::filesystem;

/// Restores the variables.
class FoldersTest : public testing::Test {
  protected:
    void SetUp() override {
        set("HOME", home.path().string());
        set("XDG_CONFIG_HOME", "");
    }
    void TearDown() override {
        for (const auto& [name, value] : before_)
            value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
    }
    void set(const std::string& name, const std::string& value) {
        const char* now = std::getenv(name.c_str());
        before_.try_emplace(name, now == nullptr ? std::nullopt : std::optional<std::string>(now));
        ::setenv(name.c_str(), value.c_str(), 1);
    }
    void say(const std::string& documents) {
        fs::create_directories(home / ".config");
        std::ofstream(home / ".config" / "user-dirs.dirs")
            << "# comment\nXDG_MUSIC_DIR=\"$HOME/Music\"\nXDG_DOCUMENTS_DIR=\"" << documents << "\"\n";
    }
    static fs::path documents() { return Folders::of_user().documents; }
    test::Folder home;

  private:
    std::map<std::string, std::optional<std::string>> before_;
};

TEST_F(FoldersTest, DocumentsAreWhereTheUserHasThem) {
    EXPECT_EQ(documents(), home.path()) << "nothing else is there";
    fs::create_directory(home / "Documents");
    EXPECT_EQ(documents(), home / "Documents");
    fs::create_directory(home / "Papiers");
    say("$HOME/Papiers");
    EXPECT_EQ(documents(), home / "Papiers");
    say((home / "Papiers").string());
    EXPECT_EQ(documents(), home / "Papiers");
    say("$HOME/gone");
    EXPECT_EQ(documents(), home / "Documents") << "what is not there is passed over";
    set("XDG_CONFIG_HOME", (home / "elsewhere").string());
    say("$HOME/Papiers");
    EXPECT_EQ(documents(), home / "Documents") << "it is read where the configuration is";
}

TEST_F(FoldersTest, WithoutAHomeThereAreNone) {
    set("HOME", "");
    EXPECT_EQ(documents(), fs::path());
}

TEST_F(FoldersTest, OnlyAFolderThatIsThereCanBeWrittenTo) {
    EXPECT_TRUE(is_writable_folder(home.path()));
    EXPECT_FALSE(is_writable_folder(home / "none"));
    EXPECT_FALSE(is_writable_folder(home.write("file", "x")));
    EXPECT_FALSE(is_writable_folder({}));
}

}  // namespace
}  // namespace lapfx::document
