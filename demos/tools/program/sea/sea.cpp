#include "program/sea/sea.h"

#include <cstdio>

#include "host/water/waves.h"
#include "program/measure/gnuplot.h"
#include "program/render/output.h"
#include "program/render/progress.h"
#include "program/sea/lost_waves.h"
#include "program/sea/sea_report.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

bool plot(const fs::path& svg, const SeaFigures& figures, const std::string& title, Error& error) {
    fs::path script = fs::absolute(svg);
    script.replace_extension(".gp");
    return writeText(script, seaPlotScript(figures, title, svg.filename().string()), error) &&
           runGnuplot(script, error) == Plotted::yes;
}

} // namespace

ExitCode describeTheSea(const SeaOptions& options, Error& error) {
    const seaglass::WavesBackend* const backend = wavesBackend();
    if (!backend) {
        error.text = "this program was built without a wave backend for the CPU (SEAGLASS_FFTW)";
        return badInput;
    }
    SceneSea sea;
    if (!seaOf(options.waves, sea, error)) return badInput;
    Progress progress;
    progress.say("simulating the sea");
    SeaFigures figures;
    if (!measureSea(sea.desc, *backend, figures, error)) return badInput;
    progress.clear();
    if (!options.plot.empty() && figures.bins.empty()) {
        error.text = "-o " + options.plot.string() + ": a flat sea has no spectrum to plot, expected waves";
        return badInput;
    }
    warnOfLostWaves(figures.resolvedShare, seaglass::leastResolvedShare, "", "--patch",
                    "--samples and --cascades");
    const PublishedSea published = publishedFor(sea.desc, options.waves);
    const std::string text = options.json ? seaJson(options.waves, sea.desc, figures, published)
                                          : seaTable(options.waves, sea.desc, figures, published);
    std::fputs(text.c_str(), stdout);
    if (options.plot.empty()) return ok;
    return plot(options.plot, figures, seaTitle(options.waves, sea.desc), error) ? ok : runFailed;
}

} // namespace demos
