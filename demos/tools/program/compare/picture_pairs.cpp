#include "program/compare/picture_pairs.h"

#include <algorithm>
#include <system_error>

#include "host/ascii.h"
#include "program/screenshots/regions.h"

namespace demos {

namespace {

namespace fs = std::filesystem;

/// Notes what is in one of the two folders.
class Lister {
  public:
    Lister(const fs::path& root, bool PairOfFiles::*side, PicturePairs& pairs)
        : root_(root), side_(side), pairs_(pairs) {}

    void list(const fs::path& folder) {
        std::error_code code;
        fs::directory_iterator entries(root_ / folder, code);
        for (const fs::directory_iterator end; !code && entries != end; entries.increment(code))
            note(folder / entries->path().filename());
        if (code) object(folder, code.message() + ", expected a folder that can be read");
    }

  private:
    void note(const fs::path& name) {
        std::error_code code;
        const bool isLink = fs::is_symlink(root_ / name, code),
                   isFolder = fs::is_directory(root_ / name, code);
        if (isLink && isFolder) return object(name, "is a link to a folder, expected a folder itself");
        if (isMaskName(name)) return;
        if (isPictureName(name)) return notePicture(name, isLink, isFolder);
        if (isFolder) list(name);
    }

    void notePicture(const fs::path& name, bool isLink, bool isFolder) {
        std::error_code code;
        pairs_[name].*side_ = true;
        if (isFolder) return object(name, "is a folder, expected a picture");
        if (isLink && !fs::exists(root_ / name, code))
            return object(name, "is a link to nowhere, expected a picture");
        if (!fs::is_regular_file(root_ / name, code)) object(name, "is no regular file, expected a picture");
    }

    void object(const fs::path& name, const std::string& what) {
        PairOfFiles& pair = pairs_[name.empty() ? "." : name];
        pair.*side_ = true;
        if (pair.problem.empty()) pair.problem = (name.empty() ? root_ : root_ / name).string() + ": " + what;
    }

    const fs::path& root_;
    bool PairOfFiles::*side_;
    PicturePairs& pairs_;
};

} // namespace

PicturePairs picturePairs(const fs::path& reference, const fs::path& test) {
    PicturePairs pairs;
    std::error_code code;
    if (fs::exists(reference, code)) Lister(reference, &PairOfFiles::inReference, pairs).list({});
    Lister(test, &PairOfFiles::inTest, pairs).list({});
    return pairs;
}

bool isPictureName(const fs::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    return extension == ".png" || extension == ".exr" || extension == ".hdr";
}

} // namespace demos
