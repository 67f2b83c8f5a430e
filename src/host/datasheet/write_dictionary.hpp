// The dictionary of a device as JSON for tools and as Markdown for readers.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// One object an element.
std::string write_object_json(const Part& part);
/// A table, an entry a row.
std::string write_object_markdown(const Part& part);

}  // namespace canproof::host
