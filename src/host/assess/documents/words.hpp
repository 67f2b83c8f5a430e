// Small pieces that the documents share.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// `A-1, A-2`; `otherwise` for an empty list.
std::string joined_or(const std::vector<std::string>& words, const std::string& otherwise = "");
/// `-40 … 85 °C`; empty without limits.
std::string range_of(const Signal& signal);
/// Requirements in force of the part, of this kind, as rows of id, text and sources.
std::vector<std::vector<std::string>> requirement_rows(const Part& part, const std::string& kind);
/// The device's manual as a reader looks for it: title, revision, date.
std::string manual_words(const Register& content, const Part& part);

}  // namespace canproof::host
