#include "program/bless/drivers.h"

#include <fstream>
#include <system_error>

#include "host/host.h"
#include "scene/text_file.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

constexpr const char* fileName = "driver.txt";
/// How many folders above a reference may speak for it.
constexpr int levels = 4;

} // namespace

std::string thisDriver() {
    Error none;
    for (const DeviceInfo& device : listDevices(none))
        if (device.supported) return device.driver;
    return {};
}

std::string driverOf(const fs::path& reference) {
    std::error_code code;
    fs::path folder = fs::absolute(reference, code).parent_path();
    for (int level = 0; level < levels; ++level, folder = folder.parent_path()) {
        std::ifstream file(folder / fileName);
        std::string line;
        if (std::getline(file, line)) return line;
    }
    return {};
}

bool noteDriver(const fs::path& reference, const std::string& driver, Error& error) {
    return driver.empty() || driver == driverOf(reference) ||
           writeText(reference.parent_path() / fileName, driver + "\n", error);
}

} // namespace demos
