#include "measure/tradeoff.h"

#include <algorithm>

namespace demos::measure {

std::optional<double> Tradeoff::floorMs() const {
    if (sheets.empty()) return std::nullopt;
    std::vector<double> ms;
    for (const Sheet& sheet : sheets) ms.push_back(of(sheet).front().cost.floor.ms);
    std::sort(ms.begin(), ms.end());
    return (ms[(ms.size() - 1) / 2] + ms[ms.size() / 2]) / 2;
}

std::span<const Entry> Tradeoff::of(const Sheet& sheet) const {
    return std::span(entries).subspan(sheet.firstEntry, sheet.entries);
}

} // namespace demos::measure
