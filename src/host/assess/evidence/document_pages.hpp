// SPDX-License-Identifier: Apache-2.0
// The generated documents as files of the evidence pack.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/assess/evidence/pack_input.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

/// Returns the documents of each device and the document for all devices as pages, and as Markdown and JSON in
/// documents/. The page documents.html lists the documents. The result maps the path within the pack to the bytes.
std::map<std::string, std::string> document_files(const PackInput& input, const PageFrame& frame);

}  // namespace canproof::host
