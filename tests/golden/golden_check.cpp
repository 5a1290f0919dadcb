// One golden image: golden_check NAME MAX_DIFFERENCE FAILING_FRACTION GOLDEN_DIR
//
// Compares GOLDEN_DIR/failed/NAME.new.png, which was just rendered, with GOLDEN_DIR/NAME.png. When they differ, failed/
// keeps it with NAME.diff.png, NAME.txt and a page that shows all failures; otherwise it keeps nothing.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>

#include "support/image_compare.h"

namespace {

namespace fs = std::filesystem;

/// Golden tests run in parallel and share the page, so one at a time writes it.
class Lock {
  public:
    explicit Lock(const fs::path& file) : descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (descriptor_ < 0 || flock(descriptor_, LOCK_EX) != 0) {
            throw std::runtime_error("cannot lock " + file.string());
        }
    }
    ~Lock() { close(descriptor_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int descriptor_;
};

std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text) {
        if (c == '<')
            html += "&lt;";
        else if (c == '&')
            html += "&amp;";
        else
            html += c;
    }
    return html;
}

/// index.html of the contents of `failed`; without failures there is no page.
void write_page(const fs::path& failed) {
    const Lock lock(failed / ".lock");
    const std::string ending = ".new.png";
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(failed)) {
        const std::string file = entry.path().filename().string();
        // Another test renders or compares a picture that has no text yet.
        if (file.ends_with(ending)) {
            const std::string name = file.substr(0, file.size() - ending.size());
            if (fs::exists(failed / (name + ".txt"))) names.insert(name);
        }
    }
    if (names.empty()) {
        fs::remove(failed / "index.html");
        return;
    }
    std::ofstream page(failed / "index.html");
    page << R"(<!DOCTYPE html><meta charset="utf-8"><title>lapfx: golden images that differ</title>
<style>
body { background: #222; color: #ddd; font: 14px sans-serif } pre { color: #aaa } code { color: #fd8 }
td { vertical-align: top; padding-right: 1em } img { image-rendering: pixelated; display: block }
.flip img + img { display: none } .flip:hover img { display: none } .flip:hover img + img { display: block }
</style>
<p>Accept all: <code>tests/accept</code>. Hover over New to see the reference in its place.
)";
    for (const std::string& name : names) {
        page << "<h2>" << name << "</h2><p>Accept: <code>tests/accept " << name << "</code>\n<table><tr>"
             << "<td>New<div class=flip><img src=\"" << name << ".new.png\"><img src=\"../" << name
             << ".png\"></div><td>Reference<img src=\"../" << name << ".png\" alt=\"none\"><td>Diff x16<img src=\""
             << name << ".diff.png\" alt=\"none\"></table>\n<pre>" << escaped(read(failed / (name + ".txt")))
             << "</pre>\n";
    }
}

double number(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw std::runtime_error("'" + text + "' is not a number");
    }
    return value;
}

int check(const std::string& name, const lapfx::tests::Tolerance& tolerance, const fs::path& golden) {
    const fs::path failed = golden / "failed";
    const fs::path candidate_file = failed / (name + ".new.png");
    const fs::path diff_file = failed / (name + ".diff.png");
    const fs::path text_file = failed / (name + ".txt");

    const cv::Mat candidate = cv::imread(candidate_file.string(), cv::IMREAD_UNCHANGED);
    if (candidate.empty()) throw std::runtime_error("not an image: " + candidate_file.string());
    const fs::path reference_file = golden / (name + ".png");
    const cv::Mat reference = cv::imread(reference_file.string(), cv::IMREAD_UNCHANGED);

    const lapfx::tests::Comparison result = lapfx::tests::compare(reference, candidate, tolerance);
    if (result.passed) {
        for (const fs::path& file : {candidate_file, diff_file, text_file}) fs::remove(file);
        write_page(failed);
        std::cout << name << ": " << result.reason << '\n';
        return 0;
    }

    const cv::Mat difference = lapfx::tests::difference_image(reference, candidate);
    if (difference.empty())
        fs::remove(diff_file);
    else
        cv::imwrite(diff_file.string(), difference);
    std::ostringstream text;
    text << result.reason << '\n' << lapfx::tests::threshold_sweep(reference, candidate);
    std::ofstream(text_file) << text.str();
    write_page(failed);
    std::cout << name << ": " << text.str() << "See " << (failed / "index.html").string()
              << "\nWhere the new picture is right: tests/accept " << name << '\n';
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 5) throw std::runtime_error("usage: golden_check NAME MAX_DIFFERENCE FAILING_FRACTION GOLDEN_DIR");
        return check(argv[1], {static_cast<int>(number(argv[2])), number(argv[3])}, argv[4]);
    } catch (const std::exception& error) {
        std::cerr << "golden_check: " << error.what() << '\n';
        return 2;
    }
}
