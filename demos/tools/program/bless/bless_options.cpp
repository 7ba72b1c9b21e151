#include "program/bless/bless_options.h"

#include <CLI/CLI.hpp>

namespace demos {

namespace {

constexpr const char* footer =
    R"(Of two files, or of all pictures of two folders, it lists what is new and what differs, with both paths and the
figures of their difference. It copies those that are named, or all with --yes. Look at them first: what is wrong in
a reference is wrong for good. References keep in driver.txt which driver made them.

Examples:
  seaglass bless screenshots out --report page        # lists, and shows in page/index.html
  seaglass bless screenshots out harbour/color.png    # renews one
  seaglass bless screenshots out --yes                # renews all

Exit codes: 0 nothing is left to renew, 1 something is, 2 bad input (nothing was renewed).)";

} // namespace

void describeBless(CLI::App& command, RawBless& raw) {
    command.footer(footer);
    command.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    command.add_option("REFERENCE", raw.reference, "The reference, or a folder of them; made if need be");
    command.add_option("TEST", raw.test, "The picture to become it, or a folder of them");
    command.add_option("NAME", raw.names, "Pictures to renew, by their paths within the folders")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--report", raw.report,
                    "Write a page that shows what is new and what differs, old and new: DIR/index.html")
        ->type_name("DIR");
    command.add_flag("--yes", raw.yes, "Renew all that differ or are new");
    command
        .add_option("--driver", raw.driver,
                    "What made the pictures, for programs that do not use this machine's first Vulkan device")
        ->type_name("TEXT");
    command.add_flag("--other-driver", raw.otherDriver,
                     "Renew references of another driver, and note this one as theirs");
    command.add_flag("--advice", raw.advice,
                     "On another driver than the references', keep its own beside them, in REFERENCE@DRIVER: "
                     "compare --driver takes those, and they advise");
    command.allow_extras();
}

std::optional<BlessOptions> checkBless(const RawBless& raw, Error& error) {
    if (raw.reference.empty() || raw.test.empty()) {
        error.text = "no reference and picture, expected seaglass bless REFERENCE TEST";
        return std::nullopt;
    }
    if (raw.yes && !raw.names.empty()) {
        error.text = "--yes is given beside names, expected one of them";
        return std::nullopt;
    }
    if (raw.advice && raw.otherDriver) {
        error.text = "--advice is given beside --other-driver, expected one of them";
        return std::nullopt;
    }
    BlessOptions options{raw.reference, raw.test,        {},         raw.yes,
                         raw.driver,    raw.otherDriver, raw.advice, raw.report};
    for (const std::string& name : raw.names)
        options.names.insert(std::filesystem::path(name).lexically_normal());
    return options;
}

} // namespace demos
