#include "scene/reading/input_file.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Open for reading; closed with its owner.
class OpenFile {
  public:
    /// Without O_NONBLOCK a pipe, should one have come between, would be waited for.
    explicit OpenFile(const fs::path& file)
        : handle_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~OpenFile() {
        if (isOpen()) ::close(handle_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    bool isOpen() const { return handle_ >= 0; }
    /// Bytes of a regular file; none of anything else.
    std::optional<uint64_t> size() const {
        struct stat status {};
        if (fstat(handle_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
        return static_cast<uint64_t>(status.st_size);
    }
    /// False at an error. A file that has been cut since is as short as it is.
    template<typename Bytes>
    bool readInto(Bytes& bytes) const {
        size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count = ::read(handle_, bytes.data() + done, bytes.size() - done);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) return false;
            if (count == 0) break;
            done += static_cast<size_t>(count);
        }
        bytes.resize(done);
        return true;
    }

  private:
    int handle_;
};

std::string cannotBeRead() {
    return std::string("cannot be read: ") + std::strerror(errno);
}

template<typename Bytes>
bool readAll(const fs::path& file, uint64_t most, Bytes& out, std::string& problem) {
    problem = unreadable(file);
    if (!problem.empty()) return false;
    const OpenFile opened(file);
    const std::optional<uint64_t> size = opened.isOpen() ? opened.size() : std::nullopt;
    if (!size) {
        problem = "is no regular file";
    } else if (*size > most) {
        problem = "has " + std::to_string(*size) + " bytes, expected at most " + std::to_string(most);
    } else {
        out.resize(*size);
        if (!opened.readInto(out)) problem = cannotBeRead();
    }
    return problem.empty();
}

} // namespace

std::string noFile(const fs::path& file) {
    std::error_code code;
    switch (fs::status(file, code).type()) {
    case fs::file_type::directory:
        return "is a folder";
    case fs::file_type::fifo:
        return "is a pipe";
    case fs::file_type::socket:
        return "is a socket";
    case fs::file_type::block:
    case fs::file_type::character:
        return "is a device";
    default:
        return {};
    }
}

std::string unreadable(const fs::path& file) {
    if (std::string kind = noFile(file); !kind.empty()) return kind;
    std::error_code code;
    if (OpenFile(file).isOpen()) return {};
    const int why = errno;
    if (why == ENOENT || why == ENOTDIR)
        return fs::is_symlink(file, code) ? "is a link to nowhere" : "no such file";
    errno = why;
    return cannotBeRead();
}

bool readWhole(const fs::path& file, uint64_t most, std::string& out, std::string& problem) {
    return readAll(file, most, out, problem);
}

bool readWhole(const fs::path& file, uint64_t most, std::vector<uint8_t>& out, std::string& problem) {
    return readAll(file, most, out, problem);
}

} // namespace demos
