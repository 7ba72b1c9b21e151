#include "host/files/spectrum_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

#include "scene/input_limits.h"
#include "scene/reading/input_file.h"

namespace demos {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const size_t from = text.find_first_not_of(blank);
    if (from == text.npos) return {};
    return text.substr(from, text.find_last_not_of(blank) - from + 1);
}

std::string_view unquoted(std::string_view text) {
    text = trimmed(text);
    const bool quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quoted ? trimmed(text.substr(1, text.size() - 2)) : text;
}

/// Models of waves end in numbers that no float holds: those become zero.
std::optional<float> number(std::string_view text) {
    text = unquoted(text);
    if (text.size() > 1 && text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty()) return std::nullopt;
    const bool tiny = text.find("e-") != text.npos || text.find("E-") != text.npos;
    if (code == std::errc::result_out_of_range && tiny) return 0.0f;
    if (code != std::errc{}) return std::nullopt;
    constexpr double greatest = std::numeric_limits<float>::max();
    return std::isfinite(value) && std::abs(value) > greatest ? std::nullopt
                                                              : std::optional(static_cast<float>(value));
}

/// As NDBC marks a density that was not measured, and others after it: by nines alone.
bool standsForMissing(std::string_view text) {
    text = unquoted(text);
    const std::optional<float> value = number(text);
    if (!value) return text == "MM";
    for (const double above : {1e3, 1e4, 1e5})
        for (const double step : {1.0, 0.1, 0.01})
            if (std::abs(*value) == static_cast<float>(above - step)) return true;
    return false;
}

bool isHeading(std::string_view line) {
    const std::string_view first = unquoted(line.substr(0, line.find(',')));
    return !first.empty() && std::isalpha(static_cast<unsigned char>(first.front())) && !number(first) &&
           first != "MM";
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Runs of letters, in lower case; what is not ASCII counts as letters.
std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    bool within = false;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool letter = std::isalpha(byte) != 0 || byte >= 0x80;
        if (letter && !within) words.emplace_back();
        if (letter) words.back() += static_cast<char>(std::tolower(byte));
        within = letter;
    }
    return words;
}

bool isForeign(const std::string& word) {
    return word.starts_with("rad") || word.starts_with("deg") ||
           isOneOf(word, {"mhz", "khz", "omega", "\xCF\x89", "period", "wavenumber", "rpm", "cm", "mm", "ft",
                          "feet", "db"});
}

/// What stands in a cell's last brackets, empty without.
std::string_view unitOf(std::string_view cell) {
    const size_t to = cell.find_last_of(")]");
    if (to == cell.npos) return "";
    const char closes = cell[to], opens = closes == ')' ? '(' : '[';
    size_t depth = 0;
    for (size_t from = to + 1; from-- > 0;) {
        if (cell[from] == closes) ++depth;
        if (cell[from] == opens && --depth == 0) return cell.substr(from + 1, to - from - 1);
    }
    return "";
}

bool isHertz(std::string_view unit) {
    const std::vector<std::string> words = wordsOf(unit);
    const auto named = [](const std::string& word) { return isOneOf(word, {"hz", "hertz", "cps"}); };
    const auto second = [](const std::string& word) { return isOneOf(word, {"s", "sec", "second"}); };
    return std::all_of(words.begin(), words.end(), named) ||
           (words.size() == 1 && second(words[0]) && unit.find('1') != unit.npos);
}

bool isDensity(std::string_view unit) {
    const std::vector<std::string> words = wordsOf(unit);
    if (words.empty()) return true;
    const bool squared = unit.find('2') != unit.npos || unit.find("\xC2\xB2") != unit.npos;
    return squared && words[0].starts_with("m") &&
           std::all_of(words.begin(), words.end(), [](const std::string& word) {
               return isOneOf(word, {"m", "m\xC2\xB2", "hz", "hertz", "s", "sec", "per"});
           });
}

/// The cell of a heading that says another unit than is read, empty where none does.
std::string_view foreignCell(std::string_view heading) {
    const size_t comma = std::min(heading.find(','), heading.size());
    const std::string_view cells[] = {unquoted(heading.substr(0, comma)),
                                      unquoted(heading.substr(std::min(comma + 1, heading.size())))};
    for (size_t i = 0; i < 2; ++i) {
        const std::vector<std::string> words = wordsOf(cells[i]);
        const std::string_view unit = unitOf(cells[i]);
        if (std::any_of(words.begin(), words.end(), isForeign) || !(i == 0 ? isHertz(unit) : isDensity(unit)))
            return cells[i];
    }
    return "";
}

/// Whether a comment is a heading of two cells with their units.
bool isHeadingInComment(std::string_view line) {
    const size_t comma = line.find(',');
    if (comma == line.npos || line.find(',', comma + 1) != line.npos) return false;
    const auto endsInBracket = [](std::string_view cell) {
        cell = unquoted(cell);
        return !cell.empty() && (cell.back() == ')' || cell.back() == ']');
    };
    return endsInBracket(line.substr(0, comma)) && endsInBracket(line.substr(comma + 1));
}

/// What keeps a line from being two numbers.
std::string problemOf(std::string_view line) {
    const std::string quoted = "'" + std::string(line.substr(0, 40)) + "'";
    if (line.find('\0') != line.npos) return "a zero byte, expected a text of UTF-8";
    if (line.find(';') != line.npos)
        return quoted + " has a semicolon, expected two numbers and a comma: Hz,m^2/Hz";
    if (line.find(',') == line.npos && line.find('\t') != line.npos)
        return quoted + " has a tab, expected two numbers and a comma: Hz,m^2/Hz";
    if (std::count(line.begin(), line.end(), ',') > 1)
        return quoted + " has more than one comma, expected two numbers with decimal points: Hz,m^2/Hz";
    return quoted + ", expected two numbers: Hz,m^2/Hz";
}

/// Which of a sample's numbers the sea does not take, and what it expects; empty where it takes both.
std::string rangeProblem(const seaglass::SpectrumSample& sample) {
    for (const seaglass::Field& field : fieldsOf(sample)) {
        const double value = field.get(&sample, 0);
        if (isInRange(field, value)) continue;
        std::array<char, 160> text{};
        std::snprintf(text.data(), text.size(), "%s is %.6g, expected %g to %g %s", field.name, value,
                      field.low, field.high, field.unit);
        return text.data();
    }
    return "";
}

std::optional<std::string> readText(const std::filesystem::path& file, Error& error) {
    std::error_code code;
    if (const uintmax_t size = std::filesystem::file_size(file, code);
        !code && size > limits::spectrumBytes) {
        error.text = file.string() + ": is over 1 MiB, expected at most " +
                     std::to_string(seaglass::maxSpectrumSamples) + " lines of Hz,m^2/Hz";
        return std::nullopt;
    }
    std::string text, problem;
    if (!readWhole(file, limits::spectrumBytes, text, problem)) {
        error.text = file.string() + ": " + problem + ", expected lines of Hz,m^2/Hz";
        return std::nullopt;
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        error.text = file.string() + ": is UTF-16, expected a text of UTF-8";
        return std::nullopt;
    }
    if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());
    return text;
}

/// Ends lines as Unix, Windows and old Macintoshes do.
std::string_view takeLine(std::string_view& rest) {
    const size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, end);
    const size_t next = end + (rest.substr(end).starts_with("\r\n") ? 2 : 1);
    rest.remove_prefix(std::min(next, rest.size()));
    return line;
}

} // namespace

bool readSpectrum(const std::filesystem::path& file, std::vector<seaglass::SpectrumSample>& out,
                  Error& error) {
    out.clear();
    const std::optional<std::string> text = readText(file, error);
    if (!text) return false;
    bool begun = false;
    std::string_view rest = *text;
    for (size_t lineNumber = 1; !rest.empty(); ++lineNumber) {
        const std::string_view line = trimmed(takeLine(rest));
        const bool comment = line.starts_with('#');
        if (line.empty() || (comment && (begun || !isHeadingInComment(line)))) continue;
        const auto fail = [&](const std::string& problem) {
            error.text = file.string() + ":" + std::to_string(lineNumber) + ": " + problem;
            return false;
        };
        const bool heading = !begun && (comment || isHeading(line));
        begun = begun || !comment;
        if (const std::string_view foreign = heading ? foreignCell(line) : ""; !foreign.empty())
            return fail("its heading says '" + std::string(foreign.substr(0, 40)) +
                        "', expected Hz and m^2/Hz");
        if (heading) continue;
        const size_t comma = line.find(',');
        if (comma == line.npos) return fail(problemOf(line));
        const std::string_view second = line.substr(comma + 1);
        if (standsForMissing(second))
            return fail("density is " + std::string(unquoted(second)) +
                        ", which stands for one that is missing; expected such lines to be left out");
        const std::optional<float> frequency = number(line.substr(0, comma)), density = number(second);
        if (!frequency || !density) return fail(problemOf(line));
        const seaglass::SpectrumSample sample = {*frequency, *density};
        if (const std::string problem = rangeProblem(sample); !problem.empty()) return fail(problem);
        if (!out.empty() && !(*frequency > out.back().frequency))
            return fail("frequency is " + std::string(unquoted(line.substr(0, comma))) +
                        ", expected more than in the line before");
        if (out.size() == seaglass::maxSpectrumSamples)
            return fail("one line too many, expected at most " +
                        std::to_string(seaglass::maxSpectrumSamples));
        out.push_back(sample);
    }
    if (out.size() > 1) return true;
    error.text = file.string() + ": " + (out.empty() ? "no spectrum" : "one sample alone") +
                 ", expected lines of Hz,m^2/Hz";
    return false;
}

} // namespace demos
