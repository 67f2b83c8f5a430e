// SPDX-License-Identifier: Apache-2.0
// One exhibit of the evidence pack: the result of one tool or of one kind of test, and the files that support it.
//
// A tool with results for the pack writes a folder with `exhibit.json`:
//   {"title": "…", "state": "holds" | "open", "says": "one sentence with figures",
//    "page": "index.html",                     without it, the pack makes a page from figures, CSV tables and SVG
//    plots;
//                                              its <main> goes into the frame of the pack's pages, without its heading
//    "figures": {"cells altered": "21,136"},   text or numbers, in this order
//    "open": ["an open point"],                one sentence each
//    "data": ["misra.sarif"]}                  files for import by other tools; also copied into the pack's data/
// Only `title`, `state` and `says` are mandatory. The name of the folder is the key of the exhibit. All other files of
// the folder are copied into the pack unchanged.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

struct Exhibit {
    /// `stale`: a source on which the measurement depends has changed after the measurement.
    enum class State { holds, open, stale, absent };

    std::string key;
    std::string title;
    State state{State::absent};
    std::string says;
    std::string page;                            ///< path within the pack; empty: no page
    std::map<std::string, std::string> files{};  ///< bytes by path within the pack
    std::vector<std::pair<std::string, std::string>> figures{};
    std::vector<std::string> open{};  ///< open points, one sentence each
    std::vector<std::string> data{};  ///< paths within the pack of the files that other tools import
};

/// Returns the word for a state: `holds`, `open`, `stale` or `not measured` (absent).
std::string word_of(Exhibit::State state);

/// Returns the content of a file. Throws InputError when the file cannot be read.
std::string bytes_of(const std::filesystem::path& file);
/// Reads the exhibit in this folder. Throws InputError for an invalid exhibit.json.
Exhibit read_exhibit(const std::filesystem::path& folder);
/// Returns the folders below this one that contain an exhibit, sorted by name; none when the folder does not exist.
std::vector<std::filesystem::path> exhibit_folders(const std::filesystem::path& folder);

/// Marks the exhibit as stale because the source `newer` changed after the measurement. Does nothing when `newer` is
/// empty.
void mark_stale(Exhibit& exhibit, const std::string& newer);

}  // namespace canproof::host
