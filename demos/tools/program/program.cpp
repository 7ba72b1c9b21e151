#include "program/program.h"

#include <cstdio>
#include <exception>

#include "host/one_line.h"
#include "program/bless/bless.h"
#include "program/compare/compare.h"
#include "program/device/no_device.h"
#include "program/exit_code.h"
#include "program/measure/measure.h"
#include "program/measure/report.h"
#include "program/options.h"
#include "program/render/reference.h"
#include "program/render/render.h"
#include "program/sea/sea.h"
#include "program/view.h"

namespace demos {

namespace {

ExitCode listAll(Error& error) {
    const std::vector<DeviceInfo> devices = listDevices(error);
    if (devices.empty()) {
        explainNoDevice(error);
        return badInput;
    }
    for (const DeviceInfo& device : devices) {
        const std::string verdict = device.supported ? "supported" : "not supported: " + device.whyNot;
        std::printf("%s (%s, %s): %s\n", device.name.c_str(), device.type.c_str(), device.driver.c_str(),
                    verdict.c_str());
    }
    return ok;
}

ExitCode runCommand(const Options& options, Error& error) {
    switch (options.command) {
    case Options::Command::render:
        return renderScene(options.render, error);
    case Options::Command::view:
        return viewScene(options.view, error);
    case Options::Command::reference:
        return renderReference(options.reference, error);
    case Options::Command::compare:
        return comparePictures(options.compare, error);
    case Options::Command::bless:
        return blessPictures(options.bless, error);
    case Options::Command::report:
        return gatherReports(options.report.folder, error);
    case Options::Command::measure:
        return measureTechniques(options.measure, error);
    case Options::Command::sea:
        return describeTheSea(options.sea, error);
    case Options::Command::devices:
        return listAll(error);
    case Options::Command::printed:
        break;
    }
    return ok;
}

ExitCode guarded(int argc, char** argv, Error& error) {
    try {
        const std::optional<Options> options = parseOptions(argc, argv, error);
        return options ? runCommand(*options, error) : badInput;
    } catch (const std::bad_alloc&) {
        error.text = "out of memory, expected a smaller --size or scene";
    } catch (const std::exception& problem) {
        error.text = problem.what();
    }
    return runFailed;
}

} // namespace

int runProgram(int argc, char** argv) {
    Error error;
    ExitCode code = guarded(argc, argv, error);
    const bool printed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (!printed && code == ok) {
        error.text = "standard output: cannot be written to, expected room for what is printed";
        code = badInput;
    }
    // What names and values are too long to read is cut amid them: what was expected comes last.
    constexpr size_t most = 2000;
    if (error.text.size() > most) error.text.replace(most / 2, error.text.size() - most, "...");
    // Whatever a file's name, a value or a library's message holds.
    if (code != ok) std::fprintf(stderr, "%s\n", oneLine(error.text).c_str());
    return code;
}

} // namespace demos
