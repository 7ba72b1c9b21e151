#include "host/spectrum_file.h"

#include <fstream>
#include <optional>

#include "scene/parse_all.h"

namespace demos {

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const size_t from = text.find_first_not_of(blank);
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(blank) - from + 1);
}

std::optional<float> number(std::string_view text) {
    return parseAll<float>(trimmed(text));
}

} // namespace

bool readSpectrum(const std::filesystem::path& file, std::vector<seaglass::SpectrumSample>& out,
                  Error& error) {
    out.clear();
    std::ifstream stream(file);
    std::string line;
    for (size_t lineNumber = 1; std::getline(stream, line); ++lineNumber) {
        const std::string_view text = trimmed(line);
        if (text.empty() || text.front() == '#') continue;
        const std::string where = file.string() + ":" + std::to_string(lineNumber);
        const size_t comma = text.find(',');
        const std::optional<float> frequency = number(text.substr(0, comma));
        const std::optional<float> density =
            comma == text.npos ? std::nullopt : number(text.substr(comma + 1));
        if (!frequency || !density) {
            error.text =
                where + ": '" + std::string(text.substr(0, 40)) + "', expected two numbers: Hz,m^2/Hz";
            return false;
        }
        if (out.size() == seaglass::maxSpectrumSamples) {
            error.text = where + ": one line too many, expected at most " +
                         std::to_string(seaglass::maxSpectrumSamples);
            return false;
        }
        out.push_back({*frequency, *density});
    }
    if (!out.empty()) return true;
    error.text = file.string() + ": no spectrum, expected lines of Hz,m^2/Hz";
    return false;
}

} // namespace demos
