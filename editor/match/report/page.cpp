#include "match/report/page.h"

#include "match/report/markup.h"
#include "match/report/report_style.h"

namespace lapfx::match {

namespace {

/// Whatever a browser could be talked into loading is forbidden.
constexpr const char* policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

}  // namespace

std::string page_head(const std::string& title, std::string_view more_style) {
    return "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
           "<meta charset=\"utf-8\"/>\n<meta http-equiv=\"Content-Security-Policy\" content=\"" +
           std::string(policy) +
           "\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta name=\"color-scheme\" content=\"light dark\"/>\n<title>" +
           escaped(title) + "</title>\n<style>" + std::string(report_style) + std::string(more_style) +
           "</style>\n</head>\n";
}

std::string name_element(const std::string& name) {
    return "<bdi>" + escaped(name) + "</bdi>";
}

}  // namespace lapfx::match
