#include "program/compare/compare.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <new>

#include "host/files/image_file.h"
#include "host/files/image_source.h"
#include "program/compare/compare_notes.h"
#include "program/measure/measures.h"
#include "program/measure/report.h"
#include "program/render/output.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

bool checkExtension(const fs::path& file, Error& error) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png" || extension == ".exr" || extension == ".hdr") return true;
    error.text = file.string() + ": '" + file.extension().string() +
                 "' is no known extension, expected .png, .exr or .hdr";
    return false;
}

/// By what the files hold, whatever their names. Null as well when the pictures are of two kinds.
std::optional<PictureKind> commonKind(const CompareOptions& options, const ImageHeader& reference,
                                      const ImageHeader& test, Error& error) {
    if (reference.integer != test.integer) {
        error.text = options.reference.string() + " and " + options.test.string() +
                     ": a PNG is display-encoded, an EXR or HDR linear, expected two of a kind";
        return std::nullopt;
    }
    if (options.exposureEv && reference.integer) {
        error.text = "--exposure is given for PNG, which needs none, expected EXR or HDR";
        return std::nullopt;
    }
    return reference.integer ? PictureKind::display : PictureKind::linear;
}

bool checkOutputs(const CompareOptions& options, Error& error) {
    if (!options.json.empty() && !checkOutput("--json", options.json, {".json"}, error)) return false;
    return options.report.empty() || checkReport(options, error);
}

std::optional<PictureFile> read(const fs::path& file, const std::string& layer, bool large, Error& error) {
    const limits::Allowance pixels = large ? limits::largePixels : limits::comparedPixels;
    std::optional<PictureFile> picture = readPictureFile(file, {layer, "--layer"}, pixels, error);
    // Most errors say what was expected; the libraries' own do not.
    if (!picture && error.text.find(", expected ") == std::string::npos)
        error.text += ", expected a PNG, EXR or HDR picture";
    if (!picture && !large && error.text.ends_with(unpacksFar)) error.text += ", or --large";
    return picture;
}

std::string sizeOf(const Picture& picture) {
    return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

Image view(const Picture& picture) {
    return {picture.width, picture.height, picture.rgba};
}

ExitCode judge(const CompareOptions& options, Error& error) {
    if (!checkExtension(options.reference, error) || !checkExtension(options.test, error) ||
        !checkOutputs(options, error))
        return badInput;
    const std::optional<PictureFile> first =
        read(options.reference, options.referenceLayer, options.large, error);
    if (!first) return badInput;
    const std::optional<PictureFile> second = read(options.test, options.testLayer, options.large, error);
    if (!second) return badInput;
    const std::optional<PictureKind> kind = commonKind(options, first->header, second->header, error);
    if (!kind) return badInput;
    const Picture &reference = first->picture, &test = second->picture;
    if (reference.width != test.width || reference.height != test.height) {
        error.text = options.reference.string() + " is " + sizeOf(reference) + " and " +
                     options.test.string() + " is " + sizeOf(test) + ", expected one size";
        return badInput;
    }

    const Comparison comparison = compare(view(reference), view(test), *kind, options.limits);
    std::fputs(compareNotes(first->header, second->header).c_str(), stdout);
    std::fputs(measuresTable(measures(comparison, *kind, options.limits)).c_str(), stdout);
    if (!options.json.empty() &&
        !writeText(options.json, measuresJson(comparison, *kind, options, view(reference)), error)) {
        return badInput;
    }
    if (!options.report.empty()) {
        if (!writeReport(options, *kind, reference, test, comparison, error)) return badInput;
        std::printf("report: %s\n", fs::absolute(options.report / "index.html").c_str());
    }
    const std::vector<std::string> found = objections(comparison, options.limits);
    if (found.empty()) {
        std::puts("same");
        return ok;
    }
    for (const std::string& objection : found) error.text += (error.text.empty() ? "" : "; ") + objection;
    error.text = "different: " + error.text;
    return different;
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
