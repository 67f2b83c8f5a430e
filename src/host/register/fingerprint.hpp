// A short mark of what an item demands: when it changes, its tests are suspect until someone has reviewed them.
#pragma once

#include <map>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Eight hexadecimal digits over what the item says; titles, sources, places and the spacing of its text do not count.
std::string fingerprint(const Requirement& requirement);
std::string fingerprint(const Object& object);
std::string fingerprint(const Table& table);
std::string fingerprint(const Enumeration& enumeration);
std::string fingerprint(const Constant& constant);
std::string fingerprint(const Signal& signal);
std::string fingerprint(const Decision& decision);

/// Every id of the part with its fingerprint, as reviews.toml holds them.
std::map<std::string, std::string> fingerprints(const Part& part);

}  // namespace canproof::host
