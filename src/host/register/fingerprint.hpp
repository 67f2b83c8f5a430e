// SPDX-License-Identifier: Apache-2.0
// Fingerprints of items. When a fingerprint changes, the item's tests are suspect until a new review.
#pragma once

#include <map>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Each function returns eight hexadecimal digits over the content of an item. Titles, sources, places and the spacing
/// of the text have no effect.
std::string fingerprint(const Requirement& requirement);
std::string fingerprint(const Object& object);
std::string fingerprint(const Table& table);
std::string fingerprint(const Enumeration& enumeration);
std::string fingerprint(const Constant& constant);
std::string fingerprint(const Signal& signal);
std::string fingerprint(const Decision& decision);

/// Returns every id of the part with its fingerprint, as in reviews.toml.
std::map<std::string, std::string> fingerprints(const Part& part);

}  // namespace canproof::host
