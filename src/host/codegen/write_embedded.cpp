// SPDX-License-Identifier: Apache-2.0
#include "host/codegen/write_embedded.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

/// Greatest length of one string literal in bytes; compilers limit it. The program joins the pieces of a longer text
/// when it runs.
constexpr std::size_t longest_piece = 8000;

/// Returns the position after the piece that begins at `at`. A piece ends with a line break or with a complete UTF-8
/// character.
std::size_t piece_end(const std::string& body, std::size_t at) {
    if (body.size() - at <= longest_piece) {
        return body.size();
    }
    const auto line_end = body.rfind('\n', at + longest_piece - 1);
    if (line_end != std::string::npos && line_end >= at) {
        return line_end + 1;
    }
    std::size_t end = at + longest_piece;
    while (end > at && (static_cast<unsigned char>(body[end]) & 0xC0U) == 0x80U) {
        --end;  // the position is in the middle of a UTF-8 character
    }
    return end;
}

/// Returns whether a file contains only statements, decisions, hazards and reviews. The program does not embed such
/// files, because the audit and its pages read them from spec/. These files are more than half of the register.
bool is_background(const std::string& path, const std::string& body) {
    const toml::table root = toml::parse(body, path);
    return !root.empty() && std::all_of(root.begin(), root.end(), [](const auto& item) {
        return item.first == "statement" || item.first == "decision" || item.first == "hazard" ||
               item.first == "review";
    });
}

}  // namespace

std::string write_embedded(const SpecFiles& files) {
    std::string text =
        "// Written by canproof's speccompiler: the register's files, embedded in the program. Statements, decisions, "
        "hazards and reviews are left out.\n"
        "#include \"host/register/embedded_spec.hpp\"\n\nnamespace canproof::host {\n\n"
        "const SpecFiles& embedded_spec() {\n    static const SpecFiles files{\n";
    for (const auto& [path, body] : files) {
        if (is_background(path, body)) {
            continue;
        }
        text += fmt::format("        {{\"{}\", std::string{{}}", path);
        for (std::size_t at = 0; at < body.size();) {
            const std::size_t end = piece_end(body, at);
            text += fmt::format(" +\n            std::string{{R\"~~~~({})~~~~\"}}", body.substr(at, end - at));
            at = end;
        }
        text += "},\n";
    }
    return text + "    };\n    return files;\n}\n\n}  // namespace canproof::host\n";
}

}  // namespace canproof::host
