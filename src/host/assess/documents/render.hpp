// A document as HTML, as Markdown and as JSON.
#pragma once

#include <map>
#include <string>

#include "host/assess/documents/document.hpp"

namespace canproof::host {

/// Where each item and decision stands in the pack, by id: `audit.html#AO4-AOUT-002`.
using ItemLinks = std::map<std::string, std::string>;

/// The body of a page. Each id that `links` has becomes a link.
std::string document_html(const Document& document, const ItemLinks& links);
std::string document_markdown(const Document& document);
/// Title, chapters, tables with rows as objects by the words of their head.
std::string document_json(const Document& document);

}  // namespace canproof::host
