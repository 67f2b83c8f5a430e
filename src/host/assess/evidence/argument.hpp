// SPDX-License-Identifier: Apache-2.0
// The argument of the evidence pack. reports/argument.toml has the claims, the evidence that each claim expects, and
// the tools; reports/techniques has the techniques that the standards demand.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct Claim {
    std::string id;
    std::string parent;  ///< id of the claim above; empty: this is the top claim
    std::string text;
    std::vector<std::string> evidence;  ///< keys of the exhibits (results of tools) that support the claim
    std::string limits;                 ///< limits of the claim: what the evidence does not show
};

/// A result (exhibit) that a complete evidence pack contains. It may be absent.
struct ExpectedEvidence {
    std::string key;
    std::string title;
    std::string made_by;  ///< the command that creates the result, as shown to a person
    /// the command that `evidence --full` runs in the project's folder to create the result; empty: it cannot create it
    std::string run{};
    std::int64_t minutes{0};  ///< approximate duration on two cores
};

struct Technique {
    std::string table;  ///< the table of the standard: `IEC 61508-3 A.1`
    std::string title;  ///< title of the standard's table
    std::string number;
    std::string name;
    std::string level;
    std::string state;  ///< whether the project applies the technique: shown, partly, missing or not applicable
    std::string how;
    std::vector<std::string> exhibits{};  ///< keys of the exhibits (results of tools) on which the state rests
};

struct Tool {
    std::string name;
    std::string package;  ///< Debian package; empty: part of this project
    std::string hides;
    std::string noticed;
    std::string tool_class;  ///< T1, T2 or T3 of IEC 61508-4; empty: not classified
    std::string defects;     ///< known defects of the tool
};

struct Argument {
    std::vector<Claim> claims;  ///< each parent is before its children
    std::vector<ExpectedEvidence> evidence;
    std::vector<Technique> techniques;
    std::vector<Tool> tools;
};

/// Reads reports/argument.toml; leaves `techniques` empty. For invalid content, throws InputError with file, line and
/// fix.
Argument read_argument(const std::filesystem::path& file);

/// Reads all `.toml` files of a folder, in the order of their names. Returns the rows of their tables of techniques
/// (IEC 61508, ISO 26262); none when the folder does not exist. For invalid content, throws InputError with file, line
/// and fix.
std::vector<Technique> read_techniques(const std::filesystem::path& folder);

}  // namespace canproof::host
