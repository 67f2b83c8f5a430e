// SPDX-License-Identifier: Apache-2.0
// ReqIF 1.2 (OMG): the requirements register for requirements tools.
#include "host/assess/evidence/reqif.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "host/assess/documents/item_words.hpp"
#include "host/assess/evidence/review_notes.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

namespace {

constexpr const char* text_type = "_datatype-text";
constexpr const char* item_type = "_type-item";
constexpr const char* part_type = "_type-part";
constexpr const char* link_type = "_type-affects";
constexpr const char* section_type = "_type-section";
constexpr const char* cover_type = "_type-covers";

struct Attribute {
    const char* id;
    const char* name;
};

constexpr Attribute id_of{"_attribute-id", "ReqIF.ForeignID"};
constexpr Attribute text_of{"_attribute-text", "ReqIF.Text"};
constexpr Attribute kind_of{"_attribute-kind", "Kind"};
constexpr Attribute source_of{"_attribute-source", "Source"};
constexpr Attribute state_of{"_attribute-state", "State"};
constexpr Attribute facts_of{"_attribute-facts", "Facts"};
constexpr Attribute code_at{"_attribute-code", "Code"};
constexpr Attribute tests_of{"_attribute-tests", "Tests"};
constexpr Attribute review_of{"_attribute-review", "Review"};
constexpr Attribute severity_of{"_attribute-severity", "Severity"};
constexpr Attribute section_id{"_attribute-section", "ReqIF.ForeignID"};
constexpr Attribute section_title{"_attribute-title", "ReqIF.Text"};

/// The properties that a requirements tool shows of an item or a decision.
struct Written {
    std::string id;
    std::string text;
    std::string kind;
    std::string source;
    std::string state;
    std::string facts{};
    std::string code{};
    std::string tests{};
    std::string review{};
    std::string severity{};
};

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Returns the review of `id` in words: `2026-11-21, NAME, author`, then whether there is an independent review, too.
/// Returns an empty text when there is no review.
std::string review_words(const Part& part, const std::string& id, const ReviewNotes& notes) {
    const auto found = part.reviews.find(id);
    if (found == part.reviews.end()) {
        return "";
    }
    const Review& one = found->second;
    return fmt::format("{}, {}, {}{}{}", one.date, one.by, one.role.empty() ? "role not stated" : one.role,
                       one.marked.empty() ? "" : fmt::format("; code and tests marked {}, not read", one.marked),
                       notes.beside(part, id));
}

std::string test_words(const std::string& id, const Evidence& evidence) {
    std::vector<std::string> words;
    if (const auto found = evidence.verdicts.find(id); found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            words.push_back(
                fmt::format("{} ({}, {})", verdict.test, verdict.kind, verdict.passed ? "passed" : "failed"));
        }
    }
    return joined(words);
}

/// Returns an id as an XML identifier, which must begin with a letter or an underscore.
std::string name_of(const std::string& id) {
    return "_" + id;
}

class ReqifWriter {
  public:
    ReqifWriter(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence)
        : content_{content}, audits_{audits}, evidence_{evidence}, notes_{content, evidence.work} {}

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
            for (const auto& one : audit.items) {
                written_.insert(one.item->id);
            }
        }
        for (const auto& audit : audits_) {
            write_objects(objects, audit);
            write_sections(objects, audit);
            write_relations(relations, audit);
            write_coverage(relations, audit);
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
        // constant, so that the same register gives the same bytes
        node.append_attribute("LAST-CHANGE") = "1970-01-01T00:00:00Z";
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
        for (const Attribute& one :
             {id_of, text_of, kind_of, source_of, state_of, facts_of, code_at, tests_of, review_of, severity_of}) {
            define(attributes, one);
        }
        auto section = identified(types, "SPEC-OBJECT-TYPE", section_type, "section").append_child("SPEC-ATTRIBUTES");
        define(section, section_id);
        define(section, section_title);
        identified(types, "SPECIFICATION-TYPE", part_type, "part");
        identified(types, "SPEC-RELATION-TYPE", link_type, "affects");
        identified(types, "SPEC-RELATION-TYPE", cover_type, "covers");
    }

    static void define(pugi::xml_node attributes, const Attribute& one) {
        auto definition = identified(attributes, "ATTRIBUTE-DEFINITION-STRING", one.id, one.name);
        definition.append_child("TYPE").append_child("DATATYPE-DEFINITION-STRING-REF").text() = text_type;
    }

    static void add_value(pugi::xml_node values, const Attribute& attribute, const std::string& value) {
        auto node = values.append_child("ATTRIBUTE-VALUE-STRING");
        node.append_attribute("THE-VALUE") = value.c_str();
        node.append_child("DEFINITION").append_child("ATTRIBUTE-DEFINITION-STRING-REF").text() = attribute.id;
    }

    static void add_object(pugi::xml_node objects, const Written& one) {
        auto node = identified(objects, "SPEC-OBJECT", name_of(one.id), one.id);
        node.append_child("TYPE").append_child("SPEC-OBJECT-TYPE-REF").text() = item_type;
        auto values = node.append_child("VALUES");
        add_value(values, id_of, one.id);
        add_value(values, text_of, one.text);
        add_value(values, kind_of, one.kind);
        add_value(values, source_of, one.source);
        add_value(values, state_of, one.state);
        for (const auto& [attribute, text] :
             {std::pair{facts_of, one.facts}, std::pair{code_at, one.code}, std::pair{tests_of, one.tests},
              std::pair{review_of, one.review}, std::pair{severity_of, one.severity}}) {
            if (!text.empty()) {
                add_value(values, attribute, text);
            }
        }
    }

    void write_objects(pugi::xml_node objects, const PartAudit& audit) const {
        const Part& part = *audit.part;
        for (const auto& one : audit.items) {
            const std::string& id = one.item->id;
            add_object(objects,
                       {id, one.item->text, one.word, joined(origins(*one.item)), one.status(), item_words(part, id),
                        joined(code_of(id, evidence_)), test_words(id, evidence_), review_words(part, id, notes_), ""});
        }
        for (const auto& one : part.decisions) {
            add_object(objects,
                       {one.id, fmt::format("{} Chosen: {} Because: {}", one.text, one.chosen, one.because), "decision",
                        joined(origins(one)), "", "", "", "", review_words(part, one.id, notes_), one.severity});
        }
    }

    /// Returns an XML identifier for the section, without spaces and colons.
    static std::string section_name(const PartAudit& audit, const Section& section) {
        std::string name = "_section-" + audit.part->name + "-";
        for (const char c : section.ref) {
            name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
        }
        return name;
    }

    /// Writes the normative sections of the device's manual.
    static void write_sections(pugi::xml_node objects, const PartAudit& audit) {
        for (const auto& one : audit.sections) {
            auto node = identified(objects, "SPEC-OBJECT", section_name(audit, *one.section), one.section->ref);
            node.append_child("TYPE").append_child("SPEC-OBJECT-TYPE-REF").text() = section_type;
            auto values = node.append_child("VALUES");
            add_value(values, section_id, audit.part->info.manual + ":" + one.section->ref);
            add_value(values, section_title, one.section->title);
        }
    }

    static void add_relation(pugi::xml_node relations, const std::string& id, const char* type, const std::string& from,
                             const std::string& to) {
        auto node = identified(relations, "SPEC-RELATION", id, "");
        node.append_child("TYPE").append_child("SPEC-RELATION-TYPE-REF").text() = type;
        node.append_child("SOURCE").append_child("SPEC-OBJECT-REF").text() = from.c_str();
        node.append_child("TARGET").append_child("SPEC-OBJECT-REF").text() = to.c_str();
    }

    /// Writes the relations from each decision to the items that it affects. Leaves out items that this file does not
    /// contain.
    void write_relations(pugi::xml_node relations, const PartAudit& audit) const {
        for (const auto& decision : audit.part->decisions) {
            for (const auto& affected : decision.affects) {
                if (is_written(affected)) {
                    add_relation(relations, name_of(decision.id + "." + affected), link_type, name_of(decision.id),
                                 name_of(affected));
                }
            }
        }
    }

    /// Writes the relations from an item to each normative section that it covers.
    void write_coverage(pugi::xml_node relations, const PartAudit& audit) const {
        for (const auto& section : audit.sections) {
            const std::string to = section_name(audit, *section.section);
            for (const auto& id : section.covered_by) {
                if (is_written(id)) {
                    add_relation(relations, name_of(id) + "." + to.substr(1), cover_type, name_of(id), to);
                }
            }
        }
    }

    bool is_written(const std::string& id) const { return written_.count(id) != 0; }

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
    const Evidence& evidence_;
    ReviewNotes notes_;
    std::set<std::string> written_;
    pugi::xml_document document_;
};

}  // namespace

std::string write_reqif(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence) {
    return ReqifWriter{content, audits, evidence}.write();
}

}  // namespace canproof::host
