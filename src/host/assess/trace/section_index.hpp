// SPDX-License-Identifier: Apache-2.0
// The items that have a section, table, figure or object of a manual as their source.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

class SectionIndex {
  public:
    explicit SectionIndex(const Register& content);

    /// Returns the ids, in the register's order, of items that name the section or an object that it describes.
    std::vector<std::string> items_of(const std::string& manual, const Section& section) const;

  private:
    struct Hit {
        std::size_t order;
        std::string id;
    };
    std::map<std::string, std::vector<Hit>> hits_;  ///< "AX130751:1.3" → items
};

}  // namespace canproof::host
