// SPDX-License-Identifier: Apache-2.0
// Fingerprints of items. When the fingerprint of an item changes, its tests are suspect until a new review.
#pragma once

#include <map>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns eight hexadecimal digits that depend on the content of an item. Titles, sources, places and the spacing of
/// the text have no influence. The following functions do the same for other items.
std::string fingerprint(const Requirement& requirement);
std::string fingerprint(const Object& object);
std::string fingerprint(const Table& table);
std::string fingerprint(const Enumeration& enumeration);
std::string fingerprint(const Constant& constant);
std::string fingerprint(const Signal& signal);
std::string fingerprint(const Decision& decision);

/// Returns the fingerprint of each item and decision of the part by id, as reviews.toml contains it.
std::map<std::string, std::string> fingerprints(const Part& part);

}  // namespace canproof::host
