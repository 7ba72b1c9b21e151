#include "program/compare/junit.h"

#include <algorithm>

#include "host/one_line.h"
#include "measure/page/html.h"

namespace demos {

namespace {

std::string attribute(const std::string& text) {
    return escaped(oneLine(text));
}

std::string count(const std::vector<Judged>& all, ExitCode code) {
    return std::to_string(
        std::count_if(all.begin(), all.end(), [code](const Judged& one) { return gating(one) == code; }));
}

} // namespace

std::string junitXml(const std::vector<Judged>& all) {
    const std::string counts = " tests=\"" + std::to_string(all.size()) + "\" failures=\"" +
                               count(all, different) + "\" errors=\"" + count(all, badInput) + "\"";
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts +
                      ">\n<testsuite name=\"seaglass compare\"" + counts + ">\n";
    for (const Judged& one : all) {
        xml += "<testcase classname=\"seaglass.compare\" name=\"" + attribute(one.name) + "\"";
        if (gating(one) == ok) {
            xml += one.why.empty()
                       ? "/>\n"
                       : "><system-out>advice: " + attribute(one.why) + "</system-out></testcase>\n";
            continue;
        }
        const std::string kind = one.code == different ? "failure" : "error";
        xml += "><" + kind + " message=\"" + attribute(one.why) + "\"/></testcase>\n";
    }
    return xml + "</testsuite>\n</testsuites>\n";
}

} // namespace demos
