// The documents that are generated from the register, as files of the pack.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/evidence/pack_input.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

/// For each device its documents as pages and, in documents/, as Markdown and JSON; the list of them is documents.html.
/// Bytes by path within the pack.
std::map<std::string, std::string> document_files(const PackInput& input, const PageFrame& frame);

}  // namespace canproof::host
