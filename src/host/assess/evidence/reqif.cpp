// ReqIF 1.2 (OMG): the register as requirements tools read it.
#include "host/assess/evidence/reqif.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <pugixml.hpp>
#include <sstream>

#include "host/assess/trace/audit.hpp"

namespace canproof::host {

namespace {

constexpr const char* text_type = "_datatype-text";
constexpr const char* item_type = "_type-item";
constexpr const char* part_type = "_type-part";
constexpr const char* link_type = "_type-affects";

struct Attribute {
    const char* id;
    const char* name;
};

constexpr Attribute id_of{"_attribute-id", "ReqIF.ForeignID"};
constexpr Attribute text_of{"_attribute-text", "ReqIF.Text"};
constexpr Attribute kind_of{"_attribute-kind", "Kind"};
constexpr Attribute source_of{"_attribute-source", "Source"};
constexpr Attribute state_of{"_attribute-state", "State"};

/// Identifiers of XML begin with a letter or an underscore.
std::string name_of(const std::string& id) {
    return "_" + id;
}

class ReqifWriter {
  public:
    ReqifWriter(const Register& content, const std::vector<PartAudit>& audits) : content_{content}, audits_{audits} {}

    std::string write() {
        auto declaration = document_.append_child(pugi::node_declaration);
        declaration.append_attribute("version") = "1.0";
        declaration.append_attribute("encoding") = "UTF-8";
        auto root = document_.append_child("REQ-IF");
        root.append_attribute("xmlns") = "http://www.omg.org/spec/ReqIF/20110401/reqif.xsd";
        write_header(root.append_child("THE-HEADER").append_child("REQ-IF-HEADER"));
        auto body = root.append_child("CORE-CONTENT").append_child("REQ-IF-CONTENT");
        write_types(body);
        auto objects = body.append_child("SPEC-OBJECTS");
        auto relations = body.append_child("SPEC-RELATIONS");
        auto specifications = body.append_child("SPECIFICATIONS");
        for (const auto& audit : audits_) {
            write_objects(objects, audit);
            write_relations(relations, audit);
            write_specification(specifications, audit);
        }
        std::ostringstream out;
        document_.save(out, "  ");
        return out.str();
    }

  private:
    static pugi::xml_node identified(pugi::xml_node parent, const char* element, const std::string& id,
                                     const std::string& long_name) {
        auto node = parent.append_child(element);
        node.append_attribute("IDENTIFIER") = id.c_str();
        node.append_attribute("LAST-CHANGE") = "1970-01-01T00:00:00Z";  // the same bytes from the same register
        if (!long_name.empty()) {
            node.append_attribute("LONG-NAME") = long_name.c_str();
        }
        return node;
    }

    static void write_header(pugi::xml_node header) {
        header.append_attribute("IDENTIFIER") = "_canproof";
        header.append_child("CREATION-TIME").text() = "1970-01-01T00:00:00Z";
        header.append_child("REQ-IF-TOOL-ID").text() = "canproof";
        header.append_child("REQ-IF-VERSION").text() = "1.0";
        header.append_child("SOURCE-TOOL-ID").text() = "canproof";
        header.append_child("TITLE").text() = "canproof: the register";
    }

    static void write_types(pugi::xml_node body) {
        auto string = identified(body.append_child("DATATYPES"), "DATATYPE-DEFINITION-STRING", text_type, "text");
        string.append_attribute("MAX-LENGTH") = 100000;
        auto types = body.append_child("SPEC-TYPES");
        auto attributes = identified(types, "SPEC-OBJECT-TYPE", item_type, "item").append_child("SPEC-ATTRIBUTES");
        for (const Attribute& one : {id_of, text_of, kind_of, source_of, state_of}) {
            auto definition = identified(attributes, "ATTRIBUTE-DEFINITION-STRING", one.id, one.name);
            definition.append_child("TYPE").append_child("DATATYPE-DEFINITION-STRING-REF").text() = text_type;
        }
        identified(types, "SPECIFICATION-TYPE", part_type, "part");
        identified(types, "SPEC-RELATION-TYPE", link_type, "affects");
    }

    static void add_value(pugi::xml_node values, const Attribute& attribute, const std::string& value) {
        auto node = values.append_child("ATTRIBUTE-VALUE-STRING");
        node.append_attribute("THE-VALUE") = value.c_str();
        node.append_child("DEFINITION").append_child("ATTRIBUTE-DEFINITION-STRING-REF").text() = attribute.id;
    }

    static void add_object(pugi::xml_node objects, const Item& item, const std::string& kind,
                           const std::string& state) {
        auto node = identified(objects, "SPEC-OBJECT", name_of(item.id), item.id);
        node.append_child("TYPE").append_child("SPEC-OBJECT-TYPE-REF").text() = item_type;
        auto values = node.append_child("VALUES");
        add_value(values, id_of, item.id);
        add_value(values, text_of, item.text);
        add_value(values, kind_of, kind);
        add_value(values, source_of, fmt::format("{}", fmt::join(origins(item), ", ")));
        add_value(values, state_of, state);
    }

    static void write_objects(pugi::xml_node objects, const PartAudit& audit) {
        for (const auto& one : audit.items) {
            add_object(objects, *one.item, one.word, one.failed || !one.missing.empty() ? "open" : "shown");
        }
        for (const auto& decision : audit.part->decisions) {
            Item item = decision;
            item.text = fmt::format("{} Chosen: {} Because: {}", decision.text, decision.chosen, decision.because);
            add_object(objects, item, "decision", "");
        }
    }

    /// From a decision to what it affects, where that is in the same file.
    void write_relations(pugi::xml_node relations, const PartAudit& audit) const {
        for (const auto& decision : audit.part->decisions) {
            for (const auto& affected : decision.affects) {
                if (!is_written(affected)) {
                    continue;
                }
                auto node = identified(relations, "SPEC-RELATION", name_of(decision.id + "." + affected), "");
                node.append_child("TYPE").append_child("SPEC-RELATION-TYPE-REF").text() = link_type;
                node.append_child("SOURCE").append_child("SPEC-OBJECT-REF").text() = name_of(decision.id).c_str();
                node.append_child("TARGET").append_child("SPEC-OBJECT-REF").text() = name_of(affected).c_str();
            }
        }
    }

    bool is_written(const std::string& id) const {
        for (const auto& audit : audits_) {
            for (const auto& one : audit.items) {
                if (one.item->id == id) {
                    return true;
                }
            }
        }
        return false;
    }

    void write_specification(pugi::xml_node specifications, const PartAudit& audit) const {
        const Manual* manual = content_.manual(audit.part->info.manual);
        auto node = identified(specifications, "SPECIFICATION", name_of("part-" + audit.part->name),
                               manual == nullptr ? audit.part->name : audit.part->name + ": " + manual->title);
        node.append_child("TYPE").append_child("SPECIFICATION-TYPE-REF").text() = part_type;
        auto children = node.append_child("CHILDREN");
        const auto add = [&children](const std::string& id) {
            auto child = identified(children, "SPEC-HIERARCHY", name_of("in-" + id), "");
            child.append_child("OBJECT").append_child("SPEC-OBJECT-REF").text() = name_of(id).c_str();
        };
        for (const auto& one : audit.items) {
            add(one.item->id);
        }
        for (const auto& decision : audit.part->decisions) {
            add(decision.id);
        }
    }

    const Register& content_;
    const std::vector<PartAudit>& audits_;
    pugi::xml_document document_;
};

}  // namespace

std::string write_reqif(const Register& content, const std::vector<PartAudit>& audits) {
    return ReqifWriter{content, audits}.write();
}

}  // namespace canproof::host
