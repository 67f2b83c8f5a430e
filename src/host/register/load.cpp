// SPDX-License-Identifier: Apache-2.0
#include "host/register/load.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "host/register/check_hazards.hpp"
#include "host/register/check_literals.hpp"
#include "host/register/check_mappings.hpp"
#include "host/register/check_names.hpp"
#include "host/register/check_objects.hpp"
#include "host/register/check_references.hpp"
#include "host/register/check_statements.hpp"
#include "host/register/check_tables.hpp"
#include "host/register/check_topics.hpp"
#include "host/register/parse_file.hpp"
#include "host/register/reader.hpp"
#include "host/register/resolve_lengths.hpp"
#include "host/register/resolve_ranges.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

LoadResult load_register(const SpecFiles& files) {
    LoadResult result;
    result.content = read_register(files, result.faults);
    if (!result.faults.empty()) {
        Faults syntax = syntax_faults(files);
        if (!syntax.empty()) {
            result.faults = std::move(syntax);
            return result;
        }
    }
    check_references(result.content, result.faults);
    check_topics(result.content, result.faults);
    check_hazards(result.content, result.faults);
    check_statements(result.content, result.faults);
    for (Part& part : result.content.parts) {
        check_tables(result.content, part, result.faults);
        check_literals(part, result.faults);
        check_names(part, result.faults);
        resolve_ranges(result.content, part, result.faults);
        resolve_lengths(part);
        check_objects(part, result.faults);
        check_mappings(part, result.faults);
    }
    std::sort(result.faults.begin(), result.faults.end(), [](const Fault& a, const Fault& b) {
        return std::tie(a.place.file, a.place.line, a.what, a.fix) <
               std::tie(b.place.file, b.place.line, b.what, b.fix);
    });
    // The elements of an array have the same place in the file, so a fault that several elements have in common is
    // reported once.
    const auto same = [](const Fault& a, const Fault& b) {
        return a.place.file == b.place.file && a.place.line == b.place.line && a.what == b.what;
    };
    result.faults.erase(std::unique(result.faults.begin(), result.faults.end(), same), result.faults.end());
    return result;
}

std::optional<Register> read_sound_register(const SpecFiles& files) {
    Faults faults;
    Register content = read_register(files, faults);
    for (Part& part : content.parts) {
        resolve_ranges(content, part, faults);
        resolve_lengths(part);
    }
    return faults.empty() ? std::optional{std::move(content)} : std::nullopt;
}

LoadResult load_register(const std::filesystem::path& spec) {
    return load_register(read_spec_files(spec));
}

}  // namespace canproof::host
