#include "program/screenshots/gather_options.h"

#include <CLI/CLI.hpp>

namespace demos {

namespace {

constexpr const char* gatherFooter =
    R"(Of reports in folders of FOLDER it makes FOLDER/index.html, which shows all of their pictures, worst first. The tests of
seaglass_add_screenshot_test() do so after each of them.

Example:
  seaglass compare approved/menu out/menu --tolerant --report pages/menu
  seaglass compare approved/game out/game --tolerant --report pages/game
  seaglass report pages

Exit codes: 0 the page is written, whatever it shows; 2 bad input.)";

} // namespace

void describeGather(CLI::App& command, RawGather& raw) {
    command.footer(gatherFooter);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    command.add_option("FOLDER", raw.folder, "What holds the folders that compare --report wrote");
    command.allow_extras();
}

std::optional<GatherOptions> checkGather(const RawGather& raw, Error& error) {
    std::error_code code;
    if (std::filesystem::is_directory(raw.folder, code)) return GatherOptions{raw.folder};
    error.text = raw.folder.empty() ? "no folder, expected seaglass report FOLDER"
                                    : raw.folder + ": is no folder, expected one that holds reports";
    return std::nullopt;
}

} // namespace demos
