#include "program/compare/folders.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <new>
#include <thread>

#include <nlohmann/json.hpp>

#include "host/files/quiet.h"
#include "host/one_line.h"
#include "program/compare/blessing.h"
#include "program/compare/junit.h"
#include "program/compare/pair.h"
#include "program/compare/picture_pairs.h"
#include "program/measure/measures.h"
#include "program/measure/report.h"
#include "program/measure/report_section.h"
#include "program/render/output.h"
#include "program/screenshots/sequence.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Each holds two pictures and their measures.
constexpr unsigned mostThreads = 4;
constexpr size_t mostNamed = 8;

bool checkBoth(const CompareOptions& options, Error& error) {
    std::error_code code;
    const bool reference = fs::is_directory(options.reference, code),
               test = fs::is_directory(options.test, code);
    if (reference && test) return true;
    if (test && fs::symlink_status(options.reference, code).type() == fs::file_type::not_found)
        return true; // no picture has a reference yet
    if (fs::is_symlink(options.reference, code) && !fs::exists(options.reference, code)) {
        error.text = options.reference.string() + ": is a link to nowhere, expected a folder";
        return false;
    }
    const fs::path& other = reference ? options.test : options.reference;
    const fs::path& folder = reference ? options.reference : options.test;
    error.text = other.string() + (fs::exists(other, code) ? " is a file and " : " is not there and ") +
                 folder.string() + " a folder, expected two of a kind";
    return false;
}

/// The options for a pair of the folders'.
CompareOptions optionsOf(CompareOptions options, const fs::path& name) {
    options.reference /= name;
    options.test /= name;
    return options;
}

/// `folder` is the pair's in the report.
Judged measured(const CompareOptions& one, const fs::path& name, const std::string& folder,
                SpentPixels& spent) {
    Error error;
    std::optional<Pair> pair = measurePair(one, error, std::move(spent));
    if (!pair) return {name.string(), badInput, error.text, {}};
    Judged judged = judgedPair(one, *pair);
    judged.name = name.string();
    if (!one.report.empty() && !addSection(one, *pair, folder, judged, error))
        return {name.string(), badInput, error.text, {}};
    spent = {std::move(pair->reference.picture.rgba), std::move(pair->test.picture.rgba)};
    return judged;
}

Judged judgedPairOfFiles(const CompareOptions& options, const fs::path& name, const PairOfFiles& files,
                         const std::string& folder, SpentPixels& spent) {
    const std::string reference = (options.reference / name).string(), test = (options.test / name).string();
    if (!files.problem.empty()) return {name.string(), badInput, files.problem, {}};
    if (!files.inReference) {
        return {name.string(),
                different,
                "no reference " + reference + ", expected one: " +
                    blessing(options.reference, options.test, name.string()) + " makes it",
                {}};
    }
    if (!files.inTest)
        return {name.string(), different, "no picture " + test + ", expected one as " + reference, {}};
    return measured(optionsOf(options, name), name, folder, spent);
}

/// `number` is the pair's among all, of which its folder in the report has its name.
Judged judgedFiles(const CompareOptions& options, const fs::path& name, const PairOfFiles& files,
                   size_t number, SpentPixels& spent) {
    const std::string folder = "pictures/" + std::to_string(number) + "/",
                      test = (options.test / name).string();
    try {
        Judged judged = judgedPairOfFiles(options, name, files, folder, spent);
        Error error;
        const bool unpaired = judged.section.empty() && !options.report.empty() && files.problem.empty();
        if (unpaired && !addUnpaired(optionsOf(options, name), folder, judged, error))
            return {name.string(), badInput, error.text, {}};
        return judged;
    } catch (const std::bad_alloc&) {
        return {name.string(), badInput, test + ": out of memory, expected a smaller picture", {}};
    } catch (const std::exception& problem) {
        return {name.string(), badInput, test + ": " + problem.what(), {}};
    }
}

std::vector<Judged> judgedAll(const CompareOptions& options, const PicturePairs& pairs) {
    const std::vector<std::pair<fs::path, PairOfFiles>> list(pairs.begin(), pairs.end());
    const std::vector<Sequence> sequences = options.flicker ? sequencesOf(pairs) : std::vector<Sequence>();
    std::vector<Judged> all(list.size() + sequences.size());
    std::atomic<size_t> next = 0;
    const auto judged = [&](size_t i, SpentPixels& spent) {
        return i < list.size() ? judgedFiles(options, list[i].first, list[i].second, i, spent)
                               : judgedSequence(options, sequences[i - list.size()]);
    };
    const auto work = [&] {
        SpentPixels spent;
        for (size_t i = next++; i < all.size(); i = next++) all[i] = judged(i, spent);
    };
    // Around all of them: each picture that is read has one of its own, which threads would mix up.
    const QuietStderr quiet;
    std::vector<std::jthread> others;
    const unsigned cores = std::max(std::thread::hardware_concurrency(), 1u);
    const unsigned wanted = options.large ? 1 : std::min(cores, mostThreads);
    for (unsigned i = 1; i < wanted && i < all.size(); ++i) others.emplace_back(work);
    work();
    others.clear();
    return all;
}

std::string jsonOf(const std::vector<Judged>& all, ExitCode code) {
    using Json = nlohmann::ordered_json;
    Json json;
    json["same"] = code == ok;
    json["pictures"] = Json::array();
    for (const Judged& one : all) {
        Json picture;
        picture["name"] = one.name;
        picture["verdict"] = verdict(one);
        picture["why"] = one.why;
        picture["measures"] = one.json.empty() ? Json(nullptr) : Json::parse(one.json);
        json["pictures"].push_back(picture);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The first of several reasons; all of them stand in the picture's own line.
std::string firstReason(const std::string& why) {
    const size_t end = why.find("; ");
    const size_t stage = why.rfind("; the first stage");
    if (end == std::string::npos) return why;
    return why.substr(0, end) + (stage == std::string::npos ? "" : why.substr(stage + 1));
}

std::string namesOf(const std::vector<Judged>& all, ExitCode code) {
    std::string names;
    size_t count = 0;
    const bool several =
        std::count_if(all.begin(), all.end(), [code](const Judged& one) { return gating(one) == code; }) > 1;
    for (const Judged& one : all) {
        if (gating(one) != code || ++count > mostNamed) continue;
        names += (names.empty() ? "" : "; ") + one.name + ": " + (several ? firstReason(one.why) : one.why);
    }
    return count > mostNamed ? names + "; and " + std::to_string(count - mostNamed) + " more" : names;
}

ExitCode worst(const std::vector<Judged>& all) {
    ExitCode code = ok;
    for (const Judged& one : all) code = std::max(code, gating(one));
    return code;
}

void say(const std::vector<Judged>& all, Error& error) {
    for (const Judged& one : all) {
        const std::string line = one.name + (one.why.empty() ? "" : ": ") + one.why;
        std::printf("%s: %s\n", verdict(one), oneLine(line).c_str());
    }
    const std::string bad = namesOf(all, badInput), other = namesOf(all, different);
    if (!bad.empty()) error.text = "not compared: " + bad;
    if (!other.empty()) error.text += (bad.empty() ? "different: " : "; different: ") + other;
}

bool writeOutputs(const CompareOptions& options, const std::vector<Judged>& all, ExitCode code,
                  Error& error) {
    return (options.json.empty() || writeText(options.json, jsonOf(all, code), error)) &&
           (options.junit.empty() || writeText(options.junit, junitXml(all), error)) &&
           (options.report.empty() || writeReport(options.report, all, error));
}

} // namespace

bool areFolders(const CompareOptions& options) {
    std::error_code code;
    return fs::is_directory(options.reference, code) || fs::is_directory(options.test, code);
}

ExitCode compareFolders(const CompareOptions& options, Error& error) {
    if (!checkBoth(options, error)) return badInput;
    const PicturePairs pairs = picturePairs(options.reference, options.test);
    if (pairs.empty()) {
        error.text = options.reference.string() + " and " + options.test.string() +
                     ": no pictures, expected PNG, EXR or HDR";
        return badInput;
    }
    std::vector<Judged> all = judgedAll(options, pairs);
    options.stages.nameFirst(all);
    for (Judged& one : all) one.advice = options.advice;
    const ExitCode code = worst(all);
    Error unwritten;
    const bool written = writeOutputs(options, all, code, unwritten);
    say(all, error);
    if (written) return code;
    error.text = unwritten.text + (error.text.empty() ? "" : "; ") + error.text;
    return badInput;
}

} // namespace demos
