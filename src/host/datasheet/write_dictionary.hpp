// SPDX-License-Identifier: Apache-2.0
// The dictionary of a device as JSON for tools and as Markdown for readers.
#pragma once

#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns a JSON object with name, title and vendor of the device, and an array with one element for each object.
std::string write_object_json(const Part& part);
/// Returns a Markdown table with one row for each entry.
std::string write_object_markdown(const Part& part);

}  // namespace canproof::host
