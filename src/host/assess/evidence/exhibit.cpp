// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/exhibit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

constexpr const char* description = "exhibit.json";

using Json = nlohmann::ordered_json;

Exhibit::State state_in(const Json& json) {
    const std::string state = json.at("state");
    if (state != "holds" && state != "open") {
        throw InputError{fmt::format("state `{}` is neither `holds` nor `open`; write one of the two", state)};
    }
    return state == "holds" ? Exhibit::State::holds : Exhibit::State::open;
}

void read_description(const Json& json, Exhibit& exhibit) {
    exhibit.title = json.at("title");
    exhibit.says = json.at("says");
    exhibit.state = state_in(json);
    if (const std::string page = json.value("page", ""); !page.empty()) {
        exhibit.page = exhibit.key + "/" + page;
    }
    // The JSON object needs a variable of its own, because items() keeps a reference to it.
    const Json figures = json.value("figures", Json::object());
    for (const auto& [name, value] : figures.items()) {
        exhibit.figures.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    }
    for (const auto& sentence : json.value("open", Json::array())) {
        exhibit.open.push_back(sentence);
    }
    for (const auto& file : json.value("data", Json::array())) {
        exhibit.data.push_back(exhibit.key + "/" + file.get<std::string>());
    }
}

/// Throws InputError when exhibit.json names a file that its folder does not contain.
void check_files(const Exhibit& exhibit) {
    auto promised = exhibit.data;
    if (!exhibit.page.empty()) {
        promised.push_back(exhibit.page);
    }
    for (const auto& file : promised) {
        if (exhibit.files.count(file) == 0) {
            throw InputError{fmt::format("there is no {}; add the file to the exhibit, or remove its name", file)};
        }
    }
}

}  // namespace

std::string word_of(const Exhibit::State state) {
    switch (state) {
        case Exhibit::State::holds:
            return "holds";
        case Exhibit::State::open:
            return "open";
        case Exhibit::State::stale:
            return "stale";
        default:
            return "not measured";
    }
}

std::string bytes_of(const std::filesystem::path& file) {
    return read_file(file);
}

Exhibit read_exhibit(const std::filesystem::path& folder) {
    Exhibit exhibit;
    exhibit.key = folder.filename().string();
    const auto file = folder / description;
    for (const auto& one : std::filesystem::recursive_directory_iterator{folder}) {
        if (one.is_regular_file() && one.path() != file) {
            const auto path = exhibit.key + "/" + one.path().lexically_relative(folder).generic_string();
            exhibit.files[path] = bytes_of(one.path());
        }
    }
    try {
        read_description(Json::parse(bytes_of(file)), exhibit);
        check_files(exhibit);
    } catch (const nlohmann::json::exception& error) {
        throw InputError{fmt::format("{}: {}; an exhibit needs title, state and says", file.string(), error.what())};
    } catch (const InputError& error) {
        throw InputError{fmt::format("{}: {}", file.string(), error.what())};
    }
    return exhibit;
}

std::vector<std::filesystem::path> exhibit_folders(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> all;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& one : std::filesystem::directory_iterator{folder}) {
            if (std::filesystem::exists(one.path() / description)) {
                all.push_back(one.path());
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

void mark_stale(Exhibit& exhibit, const std::string& newer) {
    if (!newer.empty()) {
        exhibit.state = Exhibit::State::stale;
        exhibit.open.push_back(fmt::format("{} has changed since this measurement", newer));
    }
}

}  // namespace canproof::host
