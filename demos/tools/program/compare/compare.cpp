#include "program/compare/compare.h"

#include <cstdio>
#include <exception>
#include <new>

#include "program/bless/drivers.h"
#include "program/compare/compare_notes.h"
#include "program/compare/folders.h"
#include "program/compare/junit.h"
#include "program/compare/pair.h"
#include "program/measure/measures.h"
#include "program/measure/report.h"
#include "program/measure/report_section.h"
#include "program/render/output.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

bool checkOutputs(const CompareOptions& options, Error& error) {
    if (!options.json.empty() && !checkOutput("--json", options.json, {".json"}, error)) return false;
    if (!options.junit.empty() && !checkOutput("--junit", options.junit, {".xml"}, error)) return false;
    return options.report.empty() || checkReport(options, error);
}

bool writePair(const CompareOptions& options, const Pair& pair, Error& error) {
    Judged judged = judgedPair(options, pair);
    if (!options.json.empty() && !writeText(options.json, judged.json, error)) return false;
    return options.report.empty() ||
           (addSection(options, pair, {}, judged, error) && writeReport(options.report, {judged}, error));
}

ExitCode judgePair(const CompareOptions& options, Error& error) {
    const std::optional<Pair> pair = measurePair(options, error);
    if (!pair) return badInput;
    std::fputs(compareNotes(pair->reference.header, pair->test.header).c_str(), stdout);
    std::fputs(measuresTable(measures(pair->comparison, pair->kind, pair->limits)).c_str(), stdout);
    if (!writePair(options, *pair, error)) return badInput;
    if (pair->objections.empty()) {
        std::puts("same");
        return ok;
    }
    if (options.advice) {
        std::printf("advice: %s\n", joined(pair->objections).c_str());
        return ok;
    }
    error.text = "different: " + joined(pair->objections);
    return different;
}

ExitCode judgeFiles(const CompareOptions& options, Error& error) {
    const ExitCode code = judgePair(options, error);
    if (options.junit.empty()) return code;
    Error unwritten;
    if (writeText(options.junit, junitXml({{options.test.string(), code, error.text, {}}}), unwritten))
        return code;
    error = unwritten;
    return badInput;
}

/// References of the driver that made the test's pictures gate. Else they advise: those that are kept for it,
/// if there are some.
CompareOptions byDriver(CompareOptions options) {
    const std::string driver = statedDriver(options.driver), gating = driverOfAny(options.reference);
    if (driver.empty() || gating.empty() || driver == gating) return options;
    options.advice = true;
    const fs::path kept = advisoryReference(options.reference, driver);
    if (!kept.empty()) options.reference = kept;
    std::printf("advice alone: pictures are of '%s', references %s of '%s'\n", driver.c_str(),
                options.reference.c_str(), kept.empty() ? gating.c_str() : driver.c_str());
    return options;
}

ExitCode judge(const CompareOptions& given, Error& error) {
    const CompareOptions options = byDriver(given);
    if (!checkOutputs(options, error)) return badInput;
    return areFolders(options) ? compareFolders(options, error) : judgeFiles(options, error);
}

} // namespace

ExitCode comparePictures(const CompareOptions& options, Error& error) {
    try {
        return judge(options, error);
    } catch (const std::bad_alloc&) {
        error.text = "out of memory, expected smaller pictures";
    } catch (const std::exception& problem) {
        error.text = problem.what();
    }
    return badInput; // never the exit code of a difference
}

} // namespace demos
