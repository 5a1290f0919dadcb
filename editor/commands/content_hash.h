// One number for what went into a piece of work: the same contents give the same, wherever the files lie.
//
//     ContentHash hash;
//     hash.add("--seed 1");
//     hash.add_file("operation.mp4");
//     if (hash.text() == known) skip();
//
// XXH3, 128 bits: equal contents are told from different ones, not from ones that somebody made to look equal. One
// thread at a time.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace lapfx::commands {

class ContentHash {
  public:
    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;

    /// One after the other, so "ab" and "c" are not "a" and "bc".
    void add(std::string_view text);
    /// The bytes of a plain file; of the pattern of numbered images ("frame_%04d.png") those of each. One that cannot
    /// be read is told from all that can.
    void add_file(const std::filesystem::path& file);
    /// 32 hexadecimal digits.
    std::string text() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::commands
