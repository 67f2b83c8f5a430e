// One piece of evidence of a pack: what it shows, and the files that it brings.
//
// A tool that has results for the pack leaves a folder with `exhibit.json` in it:
//   {"title": "…", "state": "holds" | "open", "says": "one sentence with figures", "page": "index.html"}
// The name of the folder is the key of the exhibit; all other files in it go into the pack as they are.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace canproof::host {

struct Exhibit {
    enum class State { holds, open, absent };

    std::string key;
    std::string title;
    State state{State::absent};
    std::string says;
    std::string page;                          ///< within the pack; empty: it has none
    std::map<std::string, std::string> files;  ///< bytes by path within the pack
};

/// `holds`, `open` or `not measured`.
std::string word_of(Exhibit::State state);

/// The exhibits below `folder`, by name; none when the folder is not there. Throws InputError for a file that is no
/// exhibit.
std::vector<Exhibit> read_exhibits(const std::filesystem::path& folder);

}  // namespace canproof::host
