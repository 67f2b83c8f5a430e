// SPDX-License-Identifier: Apache-2.0
// Fingerprints (hashes) of items and of manual sections. When a fingerprint changes, the item or section is suspect
// until a new review.
#pragma once

#include <map>
#include <string>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns eight hexadecimal digits that depend on the content of a requirement. Its kind, verification, `retired`,
/// `by`, sources, places and the spacing of its text have no influence. The functions below do the same for other
/// items, whose sources and places have no influence either. Nor have title, name and `errors` of a table, the text of
/// an enumeration or a constant, and severity and `ref` of a decision.
std::string fingerprint(const Requirement& requirement);
std::string fingerprint(const Object& object);
std::string fingerprint(const Table& table);
std::string fingerprint(const Enumeration& enumeration);
std::string fingerprint(const Constant& constant);
std::string fingerprint(const Signal& signal);
std::string fingerprint(const Decision& decision);
std::string fingerprint(const Hazard& hazard);
/// Returns eight hexadecimal digits that depend on the classification of a manual's section: whether it is normative,
/// the reason, the objects that it describes, and the conditions of use. Its title and its statements have no
/// influence.
std::string fingerprint(const Section& section);

/// Returns the fingerprint of each item, decision and hazard of a device (or of the shared rules) by id, as
/// reviews.toml contains it.
std::map<std::string, std::string> fingerprints(const Part& part);
/// Returns the fingerprint of each section of the manual by id: the manual's key, a colon and the section, as in
/// `AX188001:3.2.8`.
std::map<std::string, std::string> fingerprints(const Manual& manual);

}  // namespace canproof::host
