// The argument of reports/argument.toml: claims, the techniques of the standards, the tools and what would notice their
// errors.
#pragma once

#include <cstdint>
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
    std::string made_by;      ///< the command that leaves it
    std::string run{};        ///< the same for a shell in the project's folder; empty: `evidence --full` cannot make it
    std::int64_t minutes{0};  ///< about what it takes on two cores
};

struct Technique {
    std::string table;  ///< `IEC 61508-3 A.1`
    std::string title;  ///< of the table
    std::string number;
    std::string name;
    std::string level;
    std::string state;  ///< shown, partly, missing or not applicable
    std::string how;
};

struct Tool {
    std::string name;
    std::string package;  ///< of Debian; empty: our own
    std::string hides;
    std::string noticed;
    std::string tool_class;  ///< T1, T2 or T3 of IEC 61508-4; empty: nobody has said
    std::string defects;     ///< known ones
};

struct Argument {
    std::vector<Claim> claims;  ///< a parent before its children
    std::vector<ExpectedEvidence> evidence;
    std::vector<Technique> techniques;
    std::vector<Tool> tools;
};

/// Throws InputError with file, line and fix.
Argument read_argument(const std::filesystem::path& file);

/// The rows of the standards' tables in all TOML files of a folder, by name of the file; none without the folder.
/// Throws InputError with file, line and fix.
std::vector<Technique> read_techniques(const std::filesystem::path& folder);

}  // namespace canproof::host
