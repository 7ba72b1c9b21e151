#include "program/measure/report_gathered.h"

#include <cctype>
#include <cmath>
#include <iterator>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "program/measure/report_section.h"
#include "scene/input_limits.h"
#include "scene/reading/input_file.h"

namespace demos {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A folder's name as part of an address.
std::string inUrl(const std::string& name) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string url;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || std::string_view("-_.+").find(c) != std::string_view::npos)
            url += c;
        else
            url += {'%', digits[byte >> 4u], digits[byte & 15u]};
    }
    return url;
}

Judged judgedOf(const Json& json, const std::string& folder) {
    Judged one;
    const auto name = json.at("name").get<std::string>();
    one.name = folder + (name.empty() ? "" : "/" + name);
    const auto code = json.at("code").get<int>();
    one.code = code == ok ? ok : code == different ? different : badInput;
    one.why = json.at("why").get<std::string>();
    one.section =
        filled(json.at("section").get<std::string>(), {{"FOLDER", "@FOLDER@" + inUrl(folder) + "/"}});
    // JSON knows no infinity: that is null.
    one.badness = json.at("badness").is_null() ? HUGE_VAL : json.at("badness").get<double>();
    one.advice = json.at("advice").get<bool>();
    return one;
}

} // namespace

std::string gatherable(const std::vector<Judged>& all) {
    Json json = Json::array();
    for (const Judged& one : all) {
        json.push_back({{"name", one.name},
                        {"code", static_cast<int>(one.code)},
                        {"why", one.why},
                        {"badness", one.badness},
                        {"advice", one.advice},
                        {"section", one.section}});
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<Judged> gathered(const fs::path& folder) {
    std::error_code code;
    std::set<fs::path> names;
    fs::directory_iterator entries(folder, code);
    for (const fs::directory_iterator end; !code && entries != end; entries.increment(code))
        if (fs::exists(entries->path() / gatheredName, code)) names.insert(entries->path().filename());
    std::vector<Judged> all;
    for (const fs::path& name : names) {
        const fs::path path = folder / name / gatheredName;
        try {
            std::string text, ignored;
            readWhole(path, limits::reportBytes, text, ignored);
            for (const Json& one : Json::parse(text)) all.push_back(judgedOf(one, name.string()));
        } catch (const Json::exception&) {
            all.push_back({name.string(),
                           badInput,
                           path.string() + ": is not what seaglass compare --report writes",
                           {}});
        }
    }
    return all;
}

} // namespace demos
