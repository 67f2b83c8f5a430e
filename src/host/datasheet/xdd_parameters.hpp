// CiA 311, 1.1: the parameters of an application process, to which its objects refer.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>

namespace canproof::host {

/// `q1:parameter` is a parameter, whatever the prefix.
std::string local_name(const pugi::xml_node& node);
/// The first child of this local name; empty when there is none.
pugi::xml_node child_named(const pugi::xml_node& node, const char* name);

/// What one parameter says, in the words of CiA 306; what it does not say is empty.
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
    /// Takes every element of the document that has a uniqueID.
    explicit XddParameters(const pugi::xml_document& document);

    XddParameter find(const std::string& id) const;

  private:
    pugi::xml_node node_of(const std::string& id) const;
    std::string type_of(const pugi::xml_node& parameter) const;

    std::map<std::string, pugi::xml_node> nodes_;
};

}  // namespace canproof::host
