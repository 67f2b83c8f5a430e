// SPDX-License-Identifier: Apache-2.0
#include "host/prove/faults.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <iostream>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/prove/replay.hpp"
#include "host/prove/results.hpp"

namespace canproof::host::prove {

namespace {

std::string text_of(const toml::table& fault, const char* key, const std::filesystem::path& file) {
    const auto text = fault[key].value<std::string>();
    if (!text) {
        throw InputError{fmt::format("{}: a fault has no text `{}`; a fault needs name, file, from, to and theorem",
                                     file.string(), key)};
    }
    return *text;
}

Verdict verdict_of(const toml::table& fault, const std::filesystem::path& file) {
    const auto name = fault["verdict"].value<std::string>().value_or("refuted");
    for (const Verdict one : {Verdict::refuted, Verdict::unknown}) {
        if (name_of(one) == name) {
            return one;
        }
    }
    throw InputError{fmt::format("{}: `verdict` is `{}`; write refuted or unknown", file.string(), name)};
}

/// Returns the text of the source with the replacement of the fault.
std::string changed_source(const Fault& fault) {
    std::string text = read_file(fault.file, longest_toml_file);
    const std::size_t at = text.find(fault.from);
    if (at == std::string::npos || text.find(fault.from, at + 1) != std::string::npos) {
        throw InputError{
            fmt::format("fault {}: the text `{}` must be in {} exactly once", fault.name, fault.from, fault.file)};
    }
    return text.replace(at, fault.from.size(), fault.to);
}

/// Returns the result of the fault's theorem with the changed source.
TheoremResult with_fault(const Fault& fault, ProveOptions options) {
    options.scratch /= fault.name;
    options.overlay = options.scratch / "overlay";
    options.theorem = fault.theorem;
    options.seeds.name = "prove_" + fault.name;
    std::filesystem::create_directories(options.scratch);
    write_file(options.overlay / fault.file, changed_source(fault));
    const std::vector<TheoremResult> results = prove_all(options);
    return results.front();
}

}  // namespace

std::vector<Fault> read_faults(const std::filesystem::path& table) {
    std::vector<Fault> all;
    try {
        const toml::table content = toml::parse(read_file(table, longest_toml_file), table.string());
        const toml::array* faults = content["fault"].as_array();
        for (std::size_t i = 0; faults != nullptr && i < faults->size(); ++i) {
            const toml::table* one = faults->get(i)->as_table();
            if (one == nullptr) {
                throw InputError{table.string() + ": `fault` is no array of tables; write each fault as [[fault]]"};
            }
            all.push_back({text_of(*one, "name", table), text_of(*one, "file", table), text_of(*one, "from", table),
                           text_of(*one, "to", table), text_of(*one, "theorem", table), verdict_of(*one, table)});
        }
    } catch (const toml::parse_error& error) {
        throw InputError{
            fmt::format("{}:{}: {}", table.string(), error.source().begin.line, std::string{error.description()})};
    }
    if (all.empty()) {
        throw InputError{table.string() + " contains no fault; write each fault as [[fault]]"};
    }
    return all;
}

int try_faults(const std::filesystem::path& table, unsigned every, const ProveOptions& options) {
    const std::vector<Fault> faults = read_faults(table);
    std::size_t tried = 0;
    std::size_t as_named = 0;
    std::size_t refuted = 0;
    std::size_t reproduced = 0;
    for (std::size_t i = 0; i < faults.size(); i += every) {
        const TheoremResult result = with_fault(faults[i], options);
        ++tried;
        as_named += result.verdict == faults[i].verdict ? 1 : 0;
        refuted += result.verdict == Verdict::refuted ? 1 : 0;
        reproduced += is_reproduced(result) ? 1 : 0;
        std::cout << fmt::format("{:<8} {:<50} {}: {}\n         {}\n", name_of(result.verdict), faults[i].name,
                                 faults[i].theorem, result.reason, result.replay)
                  << std::flush;
    }
    std::cout << fmt::format("{} fault(s), {} with the named verdict, {} refuted, {} reproduced natively\n", tried,
                             as_named, refuted, reproduced);
    return as_named == tried && (!options.replays || reproduced == refuted) ? 0 : 1;
}

}  // namespace canproof::host::prove
