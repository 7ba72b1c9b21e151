#include "program/render/output.h"

#include <algorithm>
#include <system_error>

#include <unistd.h>

#include "host/ascii.h"

namespace demos {

namespace fs = std::filesystem;

namespace {

std::string pad(uint32_t frame, size_t digits) {
    const std::string number = std::to_string(frame);
    return std::string(digits - std::min(digits, number.size()), '0') + number;
}

} // namespace

bool checkOutput(const std::string& option, const fs::path& file, const std::vector<std::string>& extensions,
                 Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = option + " " + file.string() + ": " + what;
        return false;
    };
    if (std::find(extensions.begin(), extensions.end(), lowerCase(file.extension().string())) ==
        extensions.end()) {
        std::string known;
        for (const std::string& extension : extensions) known += (known.empty() ? "" : " or ") + extension;
        return fail("'" + file.extension().string() + "' is no known extension, expected " + known);
    }
    // It is written under a longer one first, and file systems take 255 bytes.
    if (file.filename().string().size() > 200) return fail("has over 200 bytes in its name, expected fewer");
    std::error_code code;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::exists(folder, code))
        return fail("folder " + folder.string() + " is not there, expected one that is");
    if (!fs::is_directory(folder, code)) return fail(folder.string() + " is not a folder, expected one");
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        return fail("folder " + folder.string() + " cannot be written to, expected one that can");
    }
    const fs::file_status status = fs::status(file, code);
    if (fs::is_directory(status)) return fail("is a folder, expected a file's name");
    if (fs::exists(status) && !fs::is_regular_file(status)) return fail("is no regular file, expected one");
    if (fs::exists(status) && access(file.c_str(), W_OK) != 0)
        return fail("is write-protected, expected a file to write");
    return true;
}

bool checkFolder(const std::string& option, const fs::path& folder, Error& error) {
    const auto fail = [&](const std::string& what) {
        error.text = option + " " + folder.string() + ": " + what;
        return false;
    };
    std::error_code code;
    fs::path there = fs::absolute(folder).lexically_normal();
    while (!fs::exists(there, code) && there.has_relative_path()) there = there.parent_path();
    if (!fs::is_directory(there, code)) return fail(there.string() + " is a file, expected a folder");
    if (access(there.c_str(), W_OK | X_OK) != 0)
        return fail("folder " + there.string() + " cannot be written to, expected one that can");
    return true;
}

bool checkApart(const std::string& option, const fs::path& output, const std::vector<fs::path>& inputs,
                Error& error) {
    for (const fs::path& input : inputs) {
        std::error_code code;
        if (!fs::equivalent(output, input, code) || code) continue;
        error.text = option + " " + output.string() + ": is what is read as well, expected another file";
        return false;
    }
    return true;
}

bool isPng(const fs::path& file) {
    const std::string extension = file.extension().string();
    return extension.size() == 4 && (extension[1] == 'p' || extension[1] == 'P');
}

fs::path numbered(const fs::path& file, uint32_t frame) {
    const std::string name = file.filename().string();
    for (size_t start = name.find('%'); start != name.npos; start = name.find('%', start + 1)) {
        size_t end = start + 1;
        while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end]))) ++end;
        if (end == name.size() || name[end] != 'd' || end - start > 3) continue;
        const std::string digits = name.substr(start + 1, end - start - 1);
        const size_t width = digits.empty() ? 1 : std::stoul(digits);
        return file.parent_path() / (name.substr(0, start) + pad(frame, width) + name.substr(end + 1));
    }
    return file.parent_path() / (file.stem().string() + "_" + pad(frame, 4) + file.extension().string());
}

} // namespace demos
