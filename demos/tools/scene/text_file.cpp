#include "scene/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include <unistd.h>

#include "scene/reading/input_file.h"

namespace demos {

namespace fs = std::filesystem;

bool writeText(const fs::path& file, const std::string& text, Error& error) {
    // Renamed to, whatever is no file would be gone.
    if (const std::string problem = noFile(file); !problem.empty()) {
        error.text = file.string() + ": " + problem + ", expected a file, or none yet";
        return false;
    }
    const fs::path partial = file.string() + ".partial" + std::to_string(getpid());
    errno = 0;
    std::ofstream stream(partial, std::ios::binary);
    const std::string why = stream ? "is the disk full?" : std::strerror(errno);
    stream << text;
    stream.close();
    std::error_code code;
    if (stream) fs::rename(partial, file, code);
    if (stream && !code) return true;
    error.text = file.string() + ": cannot be written" + (code ? ": " + code.message() : ", " + why);
    fs::remove(partial, code);
    return false;
}

} // namespace demos
