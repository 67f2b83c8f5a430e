// SPDX-License-Identifier: Apache-2.0
// The parameters of an application process (CiA 311, 1.1). The objects of the device refer to them.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>

namespace canproof::host {

/// Returns the name of an element without its prefix: `parameter` for `q1:parameter`.
std::string local_name(const pugi::xml_node& node);
/// Returns the first child with this local name; an empty node when there is none.
pugi::xml_node child_named(const pugi::xml_node& node, const char* name);

/// The data of one parameter in the words of CiA 306. Missing data are empty texts.
struct XddParameter {
    std::string name;
    std::string data_type;
    std::string access;
    std::string value;
    std::string configured_value;
    std::string low_limit;
    std::string high_limit;
};

class XddParameters {
  public:
    /// Collects every element of the document that has the attribute uniqueID.
    explicit XddParameters(const pugi::xml_document& document);

    XddParameter find(const std::string& id) const;

  private:
    pugi::xml_node node_of(const std::string& id) const;
    std::string type_of(const pugi::xml_node& parameter) const;

    std::map<std::string, pugi::xml_node> nodes_;
};

}  // namespace canproof::host
