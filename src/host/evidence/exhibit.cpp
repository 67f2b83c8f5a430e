#include "host/evidence/exhibit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/bus/candump.hpp"

namespace canproof::host {

namespace {

constexpr const char* description = "exhibit.json";

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) {
        throw InputError{fmt::format("cannot read {}", file.string())};
    }
    return text.str();
}

Exhibit read_exhibit(const std::filesystem::path& folder) {
    Exhibit exhibit;
    exhibit.key = folder.filename().string();
    const auto file = folder / description;
    try {
        const auto json = nlohmann::json::parse(bytes_of(file));
        exhibit.title = json.at("title");
        exhibit.says = json.at("says");
        const std::string state = json.at("state");
        if (state != "holds" && state != "open") {
            throw InputError{fmt::format("{}: state `{}` is neither holds nor open", file.string(), state)};
        }
        exhibit.state = state == "holds" ? Exhibit::State::holds : Exhibit::State::open;
        if (const std::string page = json.value("page", ""); !page.empty()) {
            exhibit.page = exhibit.key + "/" + page;
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError{fmt::format("{}: {}; it needs title, state and says", file.string(), error.what())};
    }
    for (const auto& one : std::filesystem::recursive_directory_iterator{folder}) {
        if (one.is_regular_file() && one.path() != file) {
            const auto path = exhibit.key + "/" + one.path().lexically_relative(folder).generic_string();
            exhibit.files[path] = bytes_of(one.path());
        }
    }
    return exhibit;
}

}  // namespace

std::string word_of(const Exhibit::State state) {
    switch (state) {
        case Exhibit::State::holds:
            return "holds";
        case Exhibit::State::open:
            return "open";
        default:
            return "not measured";
    }
}

std::vector<Exhibit> read_exhibits(const std::filesystem::path& folder) {
    std::vector<Exhibit> all;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& one : std::filesystem::directory_iterator{folder}) {
            if (std::filesystem::exists(one.path() / description)) {
                all.push_back(read_exhibit(one.path()));
            }
        }
    }
    std::sort(all.begin(), all.end(), [](const Exhibit& a, const Exhibit& b) { return a.key < b.key; });
    return all;
}

}  // namespace canproof::host
