// SPDX-License-Identifier: Apache-2.0
// Renders a document as HTML, Markdown and JSON.
#pragma once

#include <map>
#include <string>

#include "host/assess/documents/document.hpp"

namespace canproof::host {

/// The place of each item, decision and hazard in the evidence pack, by id: `audit-cbx-ao412.html#AO4-AOUT-002`.
using ItemLinks = std::map<std::string, std::string>;

/// Returns the body of a page. Each id that `links` contains becomes a link.
std::string document_html(const Document& document, const ItemLinks& links);
std::string document_markdown(const Document& document);
/// Returns name, title, description and chapters with their tables. A row of a table is an object whose keys are the
/// table's column headings.
std::string document_json(const Document& document);

}  // namespace canproof::host
