// SPDX-License-Identifier: Apache-2.0
// Reads the reviews in reviews.toml.
#pragma once

#include <map>
#include <string>

#include "host/register/register.hpp"
#include "host/register/toml_item.hpp"

namespace canproof::host {

/// Reads one [[review]] and adds a review for each of its items, by id.
void read_review(TomlItem& item, std::map<std::string, Review>& reviews);

}  // namespace canproof::host
