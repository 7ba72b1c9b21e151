#include "program/bless/bless.h"

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "metrics/finite.h"
#include "program/bless/drivers.h"
#include "program/compare/pair.h"
#include "program/compare/picture_pairs.h"
#include "program/measure/report.h"
#include "program/measure/report_section.h"
#include "program/screenshots/stages.h"
#include "scene/reading/input_file.h"
#include "scene/text_file.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// A picture that may become a reference.
struct Candidate {
    fs::path name, reference, test;
    std::string news; ///< how it differs; empty where it does not
    Judged judged;    ///< the same, for a page
};

std::optional<std::vector<Candidate>> candidates(const BlessOptions& options, Error& error) {
    std::error_code code;
    if (!fs::exists(options.test, code)) {
        const std::string why =
            fs::is_symlink(options.test, code) ? unreadable(options.test) : "no such file or folder";
        error.text = options.test.string() + ": " + why + ", expected pictures";
        return std::nullopt;
    }
    const bool folder = fs::is_directory(options.test, code);
    if (!folder && fs::is_directory(options.reference, code)) {
        error.text =
            options.reference.string() + ": is a folder, expected a file as " + options.test.string() + " is";
        return std::nullopt;
    }
    if (!folder) return {{{options.test.filename(), options.reference, options.test, {}, {}}}};
    if (fs::exists(options.reference, code) && !fs::is_directory(options.reference, code)) {
        error.text =
            options.reference.string() + ": is a file, expected a folder as " + options.test.string() + " is";
        return std::nullopt;
    }
    std::vector<Candidate> all;
    for (const auto& [name, files] : picturePairs(options.test, options.test)) {
        if (!files.problem.empty()) {
            error.text = files.problem;
            return std::nullopt;
        }
        all.push_back({name, options.reference / name, options.test / name, {}, {}});
    }
    if (!all.empty()) return all;
    error.text = options.test.string() + ": no pictures, expected PNG, EXR or HDR";
    return std::nullopt;
}

/// False with `error` set where something stands in a reference's place that is none, and would be gone.
bool checkPlace(const fs::path& reference, Error& error) {
    std::error_code code;
    std::string problem = noFile(reference);
    if (problem.empty() && fs::is_symlink(reference, code)) problem = unreadable(reference);
    if (problem.empty()) return true;
    error.text = reference.string() + ": " + problem + ", expected a picture, or none yet";
    return false;
}

/// False with `error` set when the picture is not fit for a reference.
bool checkTest(const fs::path& file, Error& error) {
    if (!isPictureName(file)) {
        error.text = file.string() + ": is no picture by its name, expected .png, .exr or .hdr";
        return false;
    }
    const std::optional<PictureFile> read =
        readPictureFile(file, {{}, "a file", true}, limits::comparedPixels, error);
    if (!read) {
        // Most errors say what was expected; the libraries' own do not.
        if (error.text.find(", expected ") == std::string::npos) error.text += ", expected a picture";
        return false;
    }
    const Picture& picture = read->picture;
    const Infinity infinity = Stages().of(file.filename()) == "depth" ? Infinity::far : Infinity::broken;
    const uint64_t broken = countNotFinite({picture.width, picture.height, picture.rgba}, infinity);
    if (broken == 0) return true;
    error.text = file.string() + ": NaN or infinity in " + std::to_string(broken) + " pixels, expected none";
    return false;
}

std::string figuresOf(const Comparison& found) {
    char text[200];
    std::snprintf(
        text, sizeof(text),
        "FLIP mean %.4f, 99th percentile %.4f, greatest %.4f; %.4g of pixels differ, by at most %.4g",
        found.flipMean, found.flipP99, found.flipMax, found.shares.front(), found.difference.max);
    return text;
}

/// Any difference is news.
CompareOptions optionsOf(const Candidate& one, const fs::path& report) {
    CompareOptions options;
    options.reference = one.reference;
    options.test = one.test;
    options.limits.shares = {{0, 0}};
    options.report = report;
    return options;
}

/// Sets the news of a candidate; in a report it has the folder. False with `error` set when that cannot be
/// written.
bool findNews(Candidate& one, const fs::path& report, const std::string& folder, Error& error) {
    std::error_code code;
    const CompareOptions options = optionsOf(one, report);
    std::optional<Pair> pair;
    Error why;
    if (!fs::exists(one.reference, code))
        one.news = "new";
    else if (pair = measurePair(options, why); !pair)
        one.news = "cannot be compared: " + why.text;
    else if (!pair->objections.empty())
        one.news = figuresOf(pair->comparison);
    one.judged = {one.name.string(), different, one.news, {}};
    if (report.empty() || one.news.empty()) return true;
    if (!pair) return addUnpaired(options, folder, one.judged, error);
    one.judged.badness = pair->comparison.flipMean;
    return addSection(options, *pair, folder, one.judged, error);
}

bool checkNames(const BlessOptions& options, const std::vector<Candidate>& all, Error& error) {
    for (const fs::path& name : options.names) {
        const auto has = [&name](const Candidate& one) { return one.name == name; };
        if (std::any_of(all.begin(), all.end(), has)) continue;
        error.text =
            name.string() + ": no such picture in " + options.test.string() + ", expected one that is there";
        return false;
    }
    return true;
}

bool checkDrivers(const BlessOptions& options, const std::vector<Candidate>& chosen,
                  const std::string& driver, Error& error) {
    for (const Candidate& one : chosen) {
        const std::string theirs = driverOf(one.reference);
        if (options.otherDriver || theirs.empty() || theirs == driver) continue;
        error.text = one.reference.string() + ": references here are of the driver '" + theirs +
                     "' and this is '" + driver + "', expected that one, --advice or --other-driver";
        return false;
    }
    return true;
}

bool renew(const Candidate& one, const std::string& driver, Error& error) {
    std::error_code code;
    const fs::path folder = one.reference.parent_path();
    if (!folder.empty()) fs::create_directories(folder, code);
    if (code) {
        error.text = one.reference.string() + ": cannot be made: " + code.message();
        return false;
    }
    std::string bytes, problem;
    if (!readWhole(one.test, limits::pictureFileBytes, bytes, problem)) {
        error.text = one.test.string() + ": " + problem;
        return false;
    }
    return writeText(one.reference, bytes, error) && noteDriver(one.reference, driver, error);
}

/// Finds out what is new, and shows it on a page if that is asked for.
bool look(const BlessOptions& options, std::vector<Candidate>& all, Error& error) {
    if (!options.report.empty() &&
        !checkReport(optionsOf({{}, options.reference, options.test, {}, {}}, options.report), error))
        return false;
    std::vector<Judged> news;
    for (size_t i = 0; i < all.size(); ++i) {
        if (!findNews(all[i], options.report, "pictures/" + std::to_string(i) + "/", error)) return false;
        if (!all[i].news.empty()) news.push_back(all[i].judged);
    }
    return options.report.empty() ||
           writeReport(options.report, news, error, std::to_string(news.size()) + " new or different");
}

/// Those that differ and are chosen go to `chosen`; of the rest that differ the number.
size_t list(const BlessOptions& options, const std::vector<Candidate>& all, std::vector<Candidate>& chosen) {
    size_t left = 0;
    for (const Candidate& one : all) {
        if (one.news.empty()) continue;
        std::printf("%s: %s\n  old: %s\n  new: %s\n", one.name.c_str(), one.news.c_str(),
                    one.reference.c_str(), one.test.c_str());
        if (options.yes || options.names.contains(one.name))
            chosen.push_back(one);
        else
            ++left;
    }
    return left;
}

} // namespace

/// With --advice those of another driver go beside.
BlessOptions besideOthers(BlessOptions options) {
    if (!options.advice) return options;
    options.driver = statedDriver(options.driver.empty() ? "auto" : options.driver);
    const std::string theirs = driverOfAny(options.reference);
    if (!theirs.empty() && theirs != options.driver)
        options.reference = advisoryFolder(options.reference, options.driver);
    return options;
}

ExitCode blessPictures(const BlessOptions& given, Error& error) {
    const BlessOptions options = besideOthers(given);
    std::optional<std::vector<Candidate>> all = candidates(options, error);
    if (!all || !checkNames(options, *all, error)) return badInput;
    for (const Candidate& one : *all)
        if (!checkPlace(one.reference, error) || !checkTest(one.test, error)) return badInput;
    if (!look(options, *all, error)) return badInput;
    std::vector<Candidate> chosen;
    const size_t left = list(options, *all, chosen);
    const std::string driver =
        options.driver.empty() && !chosen.empty() ? thisDriver() : statedDriver(options.driver);
    if (!checkDrivers(options, chosen, driver, error)) return badInput;
    for (const Candidate& one : chosen) {
        if (!renew(one, driver, error)) return badInput;
        std::printf("renewed: %s\n", one.reference.c_str());
    }
    if (left == 0) return ok;
    error.text = std::to_string(left) + " left as they were, expected their names, or --yes for all";
    return different;
}

} // namespace demos
