// SPDX-License-Identifier: Apache-2.0
// Texts that several documents use.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the words separated by commas: `A-1, A-2`. Returns `otherwise` for an empty list.
std::string joined_or(const std::vector<std::string>& words, const std::string& otherwise = "");
/// Returns the range of a signal with its unit: `-40 … 85 °C`. Returns an empty text for a signal without a minimum or
/// without a maximum.
std::string range_of(const Signal& signal);
/// Returns the device's requirements of this kind that are in force, as rows of id, text and sources.
std::vector<std::vector<std::string>> requirement_rows(const Part& part, const std::string& kind);
/// Returns the bit rates of the device in bit/s: those of its data sheet and those of its tables with
/// an output `bit_rate`, such as the table of a coding switch.
std::set<std::int64_t> bit_rates_of(const Part& part);
/// Returns title, publisher, revision and date of the device's manual; only its name when the register does not
/// describe the manual.
std::string manual_words(const Register& content, const Part& part);

}  // namespace canproof::host
