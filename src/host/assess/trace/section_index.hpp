// SPDX-License-Identifier: Apache-2.0
// Finds the items whose source is a section, table, figure or object of a manual.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

class SectionIndex {
  public:
    explicit SectionIndex(const Register& content);

    /// Returns the ids of the items whose source is the section or an object that the section describes, in the order
    /// of the register.
    std::vector<std::string> items_of(const std::string& manual, const Section& section) const;

  private:
    struct Hit {
        std::size_t order;
        std::string id;
    };
    /// the items that name a source, by this source, such as "AX130751:1.3"
    std::map<std::string, std::vector<Hit>> hits_;
};

}  // namespace canproof::host
