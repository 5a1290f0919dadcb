// The text of an OBJ is read to its end, and not beyond.
#include "organ/obj_text.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

namespace lapfx::organ {
namespace {

/// A text behind which no byte may be read.
class AtTheEnd {
  public:
    explicit AtTheEnd(const std::string& text)
        : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
          pages_(mmap(nullptr, 2 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
        if (pages_ == MAP_FAILED || text.size() > page_) throw std::bad_alloc();
        char* const start = static_cast<char*>(pages_) + page_ - text.size();
        std::memcpy(start, text.data(), text.size());
        mprotect(static_cast<char*>(pages_) + page_, page_, PROT_NONE);
        text_ = {start, text.size()};
    }
    ~AtTheEnd() { munmap(pages_, 2 * page_); }
    AtTheEnd(const AtTheEnd&) = delete;
    AtTheEnd& operator=(const AtTheEnd&) = delete;
    std::string_view text() const { return text_; }

  private:
    std::size_t page_;
    void* pages_;
    std::string_view text_;
};

TEST(ObjText, ANumberThatEndsWithinItsExponentEndsThere) {
    for (const char* end : {"e", "E", "e-", "e+", ""}) {
        const AtTheEnd file("v 0 0 0 " + std::string(40, '1') + end);
        const ObjText read = read_obj_text(file.text());
        ASSERT_EQ(read.soup.positions.size(), 1U) << end;
        EXPECT_EQ(read.soup.positions[0], glm::vec3(0.0F)) << end;
    }
}

TEST(ObjText, LinesEndInLfCrLfOrCrAlone) {
    const std::string text = "mtllib a.mtl\nv 0 0 0\nv 9 0 \\\n0\nv 0 9 0\nusemtl a\nf 1 2 3\n";
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string changed;
        for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
        const ObjText read = read_obj_text(changed);
        ASSERT_EQ(read.soup.positions.size(), 3U) << testing::PrintToString(end);
        EXPECT_EQ(read.soup.positions[1], glm::vec3(9, 0, 0));
        EXPECT_EQ(read.soup.faces(), 1U);
        ASSERT_EQ(read.runs.size(), 1U);
        EXPECT_EQ(read.runs[0].material, "a");
        EXPECT_EQ(read.libraries, std::vector<std::string>{"a.mtl"});
    }
}

TEST(ObjText, NumbersBeyondFloatsAreNothingOrInfinite) {
    const ObjText read = read_obj_text("v 1e-60 -2E-60 3\nv 1e60 0 0\nv 0 1E60 0\n");
    ASSERT_EQ(read.soup.positions.size(), 3U);
    EXPECT_EQ(read.soup.positions[0], glm::vec3(0.0F, 0.0F, 3.0F));
    EXPECT_EQ(read.soup.positions[1].x, 1e30F);
    EXPECT_EQ(read.soup.positions[2].y, 1e30F);
}

}  // namespace
}  // namespace lapfx::organ
