// What seaglass measure leaves in its folder, brought up to date view by view, so that what is finished can
// be read whatever comes after.
#pragma once

#include <filesystem>

#include "measure/tradeoff.h"

namespace demos {

/// Whether all of it can be written there, before anything is measured.
bool checkTradeoffFiles(const std::filesystem::path& folder, Error& error);

class TradeoffFiles {
  public:
    TradeoffFiles(std::filesystem::path folder, measure::Tradeoff tradeoff)
        : folder_(std::move(folder)), tradeoff_(std::move(tradeoff)) {}

    /// Makes the folder if need be and finds out whether it takes files.
    bool makeFolder(Error& error) const;
    /// Writes the view's pictures and plot, then tables and page anew. The view's pictures are not kept.
    bool add(measure::ViewResult view, Error& error);

    /// Why there are no plots; empty when there are.
    const std::string& whyNoPlots() const { return whyNoPlots_; }
    const measure::Tradeoff& tradeoff() const { return tradeoff_; }
    std::filesystem::path page() const { return folder_ / "index.html"; }

  private:
    bool plot(const measure::Sheet& sheet, Error& error);
    bool writeTables(Error& error) const;

    std::filesystem::path folder_;
    measure::Tradeoff tradeoff_;
    std::string whyNoPlots_;
};

} // namespace demos
