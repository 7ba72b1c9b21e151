#include "scene/nearest.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "scene/scene.h"

namespace demos {

namespace {

constexpr size_t longest = 64;

bool same(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

} // namespace

size_t editDistance(std::string_view a, std::string_view b) {
    a = a.substr(0, longest);
    b = b.substr(0, longest);
    using Row = std::array<size_t, longest + 1>;
    Row twoBefore{}, before{}, row{};
    for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        twoBefore = before;
        before = row;
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t replaced = before[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({before[j] + 1, row[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
            if (swapped) row[j] = std::min(row[j], twoBefore[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& known) {
    const auto nearer = [word](std::string_view a, std::string_view b) {
        return editDistance(word, a) < editDistance(word, b);
    };
    const auto found = std::min_element(known.begin(), known.end(), nearer);
    return found == known.end() ? std::string_view{} : *found;
}

std::string oneOf(std::span<const std::string_view> choices) {
    std::string words;
    for (const std::string_view& choice : choices) {
        const bool last = &choice == &choices.back();
        words.append(words.empty() ? "" : last ? " or " : ", ").append(choice);
    }
    return words;
}

bool isOneOf(const std::string& option, const std::string& word, std::span<const std::string_view> known,
             Error& error) {
    if (std::ranges::find(known, word) != known.end()) return true;
    const std::string_view meant = nearest(word, {known.begin(), known.end()});
    error.text = option + " is '" + word + "', expected " + oneOf(known) + "; the nearest is ";
    error.text += meant;
    return false;
}

} // namespace demos
