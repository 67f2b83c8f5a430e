// The argument of reports/argument.toml: claims, the techniques of the standards, the tools and what would notice their
// errors.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct Claim {
    std::string id;
    std::string parent;  ///< empty: the claim of the whole
    std::string text;
    std::vector<std::string> evidence;  ///< keys of exhibits
    std::string limits;                 ///< what the evidence does not show
};

/// A part of a whole pack, there or not.
struct ExpectedEvidence {
    std::string key;
    std::string title;
    std::string made_by;  ///< the command that leaves it
};

struct Technique {
    std::string table;
    std::string name;
    std::string level;
    std::string state;  ///< shown, partly or not
    std::string how;
};

struct Tool {
    std::string name;
    std::string package;  ///< of Debian; empty: our own
    std::string hides;
    std::string noticed;
};

struct Argument {
    std::vector<Claim> claims;  ///< a parent before its children
    std::vector<ExpectedEvidence> evidence;
    std::vector<Technique> techniques;
    std::vector<Tool> tools;
};

/// Throws InputError with file, line and fix.
Argument read_argument(const std::filesystem::path& file);

}  // namespace canproof::host
