// One piece of evidence of a pack: what it shows, and the files that it brings.
//
// A tool that has results for the pack leaves a folder with `exhibit.json` in it:
//   {"title": "…", "state": "holds" | "open", "says": "one sentence with figures",
//    "page": "index.html",                     without it the pack makes one from the figures, CSV tables and SVG plots
//    "figures": {"cells altered": "21,136"},   text or numbers, in this order
//    "open": ["what it leaves open"],          a sentence each
//    "data": ["misra.sarif"]}                  files that other tools import: in the pack's data/ as well
// Only title, state and says are needed. The name of the folder is the key of the exhibit; all other files in it go
// into the pack as they are.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

struct Exhibit {
    /// stale: measured before a source that it speaks of was written.
    enum class State { holds, open, stale, absent };

    std::string key;
    std::string title;
    State state{State::absent};
    std::string says;
    std::string page;                            ///< within the pack; empty: it has none
    std::map<std::string, std::string> files{};  ///< bytes by path within the pack
    std::vector<std::pair<std::string, std::string>> figures{};
    std::vector<std::string> open{};  ///< what it leaves open, each a sentence
    std::vector<std::string> data{};  ///< those of the files, by their path in the pack, that other tools import
};

/// `holds`, `open`, `stale` or `not measured`.
std::string word_of(Exhibit::State state);

/// All of a file. Throws InputError when it cannot be read.
std::string bytes_of(const std::filesystem::path& file);
/// The exhibit in this folder. Throws InputError when its description cannot be understood.
Exhibit read_exhibit(const std::filesystem::path& folder);
/// The folders below this one that hold an exhibit, by name; none when it is not there.
std::vector<std::filesystem::path> exhibit_folders(const std::filesystem::path& folder);

/// `newer`: a source that was written after the measurement. Without one the exhibit stays as it is.
void mark_stale(Exhibit& exhibit, const std::string& newer);

}  // namespace canproof::host
