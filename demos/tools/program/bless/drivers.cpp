#include "program/bless/drivers.h"

#include <cctype>
#include <string_view>
#include <system_error>

#include "host/host.h"
#include "scene/reading/input_file.h"
#include "scene/text_file.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

constexpr const char* fileName = "driver.txt";
constexpr uint64_t mostBytes = 1 << 16;
/// How many folders above a reference may speak for it.
constexpr int levels = 4;

} // namespace

std::string thisDriver(const std::string& named) {
    Error none;
    for (const DeviceInfo& device : listDevices(none))
        if (device.supported && device.name.find(named) != std::string::npos) return device.driver;
    return {};
}

std::string statedDriver(const std::string& text) {
    constexpr std::string_view ofName = "auto:";
    if (text == "auto") return thisDriver();
    return text.starts_with(ofName) ? thisDriver(text.substr(ofName.size())) : text;
}

fs::path advisoryFolder(fs::path references, const std::string& driver) {
    if (!references.has_filename()) references = references.parent_path();
    std::string slug;
    for (const char c : driver) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
        if (plain)
            slug += c;
        else if (!slug.empty() && slug.back() != '-')
            slug += '-';
    }
    while (slug.ends_with('-')) slug.pop_back();
    return references += "@" + slug;
}

fs::path advisoryReference(const fs::path& reference, const std::string& driver) {
    std::error_code code;
    fs::path folder = fs::absolute(reference, code).lexically_normal(), within;
    if (!folder.has_filename()) folder = folder.parent_path();
    for (int level = 0; level <= levels && folder.has_filename(); ++level) {
        const fs::path base = advisoryFolder(folder, driver), found = within.empty() ? base : base / within;
        if (fs::exists(found, code)) return reference.is_absolute() ? found : fs::proximate(found, code);
        within = within.empty() ? folder.filename() : folder.filename() / within;
        folder = folder.parent_path();
    }
    return {};
}

std::string driverOf(const fs::path& reference) {
    std::error_code code;
    fs::path folder = fs::absolute(reference, code).parent_path();
    for (int level = 0; level < levels; ++level, folder = folder.parent_path()) {
        std::string text, ignored;
        if (readWhole(folder / fileName, mostBytes, text, ignored) && !text.empty())
            return text.substr(0, text.find('\n'));
    }
    return {};
}

std::string driverOfAny(const fs::path& references) {
    std::error_code code;
    if (!fs::is_directory(references, code)) return driverOf(references);
    const std::string above = driverOf(references / fileName);
    if (!above.empty()) return above;
    fs::recursive_directory_iterator entries(references, code);
    for (const fs::recursive_directory_iterator end; !code && entries != end; entries.increment(code))
        if (entries->path().filename() == fileName) return driverOf(entries->path());
    return {};
}

bool noteDriver(const fs::path& reference, const std::string& driver, Error& error) {
    return driver.empty() || driver == driverOf(reference) ||
           writeText(reference.parent_path() / fileName, driver + "\n", error);
}

} // namespace demos
