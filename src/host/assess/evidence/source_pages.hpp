// SPDX-License-Identifier: Apache-2.0
// Pages with the sources that implement items or test them. Each line has an address, to which the audit links.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

/// Returns the texts, by path relative to `root`, of the sources that the evidence names: those that implement or use
/// items, and those of tests that verify items. Leaves out a source that does not exist. Throws InputError for a source
/// that cannot be read.
std::map<std::string, std::string> sources_named_by(const Evidence& evidence, const std::filesystem::path& root);

/// Returns the address of a line of a source, such as `source/src/x.cpp.html#L12`; when `line` is 0, returns the
/// address of the source's page. Returns an empty text when the pack does not contain the source.
std::string source_link(const PackInput& input, const std::string& file, unsigned line);

/// Returns the page of each source of `input` by its name in the pack. A line that implements or tests items links to
/// them.
std::map<std::string, std::string> source_pages(const PackInput& input, const PageFrame& frame);

}  // namespace canproof::host
