// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/sacm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "host/assess/evidence/argument_page.hpp"
#include "host/assess/evidence/exhibit.hpp"

namespace canproof::host {

namespace {

void set(pugi::xml_node node, const char* name, const std::string& text) {
    node.append_attribute(name) = text.c_str();
}

/// Adds a text with its language: the value of a MultiLangString, or a LangString.
void add_text(pugi::xml_node node, const char* element, const std::string& text) {
    auto added = node.append_child(element);
    set(added, "lang", "en");
    set(added, "content", text);
}

/// Adds an element whose content is a text: a note, a description or a tagged value.
pugi::xml_node add_utility(pugi::xml_node node, const char* element, const std::string& text) {
    auto added = node.append_child(element);
    add_text(added.append_child("content"), "value", text);
    return added;
}

void add_tag(pugi::xml_node node, const std::string& key, const std::string& text) {
    add_text(add_utility(node, "taggedValue", text).append_child("key"), "value", key);
}

void identify(pugi::xml_node node, const std::string& id) {
    set(node, "xmi:id", id);
    set(node, "gid", id);
}

pugi::xml_node add_typed(pugi::xml_node package, const char* element, const char* type, const std::string& id) {
    auto added = package.append_child(element);
    set(added, "xsi:type", type);
    identify(added, id);
    return added;
}

const char* declaration_of(const Exhibit::State state) {
    return state == Exhibit::State::holds ? "asserted" : "needsSupport";
}

Exhibit::State state_with(const std::string& key, const Exhibits& exhibits) {
    const auto found = exhibits.find(key);
    return found == exhibits.end() ? Exhibit::State::absent : found->second.state;
}

/// Writes one assurance case.
class CaseWriter {
  public:
    CaseWriter(const Argument& argument, const Exhibits& exhibits, std::string version)
        : argument_{argument}, exhibits_{exhibits}, version_{std::move(version)} {
        for (const auto& claim : argument_.claims) {
            keys_.insert(claim.evidence.begin(), claim.evidence.end());
        }
    }

    std::string write() {
        auto head = document_.append_child(pugi::node_declaration);
        set(head, "version", "1.0");
        set(head, "encoding", "UTF-8");
        auto root = document_.append_child("assuranceCase_:AssuranceCasePackage");
        set(root, "xmi:version", "2.0");
        set(root, "xmlns:xmi", "http://www.omg.org/XMI");
        set(root, "xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
        set(root, "xmlns:assuranceCase_", "http://omg.sacm/2.0/assurancecase");
        set(root, "xmlns:argumentation_", "http://omg.sacm/2.0/argumentation");
        set(root, "xmlns:artifact_", "http://omg.sacm/2.0/artifact");
        identify(root, "case");
        add_text(root, "name", "canproof");
        add_artifacts(root);
        add_arguments(root);
        std::ostringstream out;
        document_.save(out, "  ");
        return out.str();
    }

  private:
    void add_artifacts(pugi::xml_node root) {
        auto package = root.append_child("artifactPackage");
        identify(package, "artifacts");
        for (const auto& key : keys_) {
            auto artifact = add_typed(package, "artifactElement", "artifact_:Artifact", "artifact." + key);
            set(artifact, "version", version_);
            const auto found = exhibits_.find(key);
            add_text(artifact, "name", found == exhibits_.end() ? key : found->second.title);
            if (found != exhibits_.end() && !found->second.says.empty()) {
                add_utility(artifact, "description", found->second.says);
            }
            add_tag(artifact, "state", word_of(state_with(key, exhibits_)));
            if (found != exhibits_.end() && !found->second.page.empty()) {
                add_tag(artifact, "page", found->second.page);
            }
        }
    }

    void add_arguments(pugi::xml_node root) {
        auto package = root.append_child("argumentPackage");
        identify(package, "argument");
        for (const auto& claim : argument_.claims) {
            add_claim(package, claim);
        }
        for (const auto& key : keys_) {
            set(add_typed(package, "argumentationElement", "argumentation_:ArtifactReference", "reference." + key),
                "referencedArtifactElement", "artifact." + key);
        }
        for (const auto& claim : argument_.claims) {
            add_support(package, claim);
        }
    }

    void add_claim(pugi::xml_node package, const Claim& claim) const {
        const auto state = state_of_claim(claim, argument_, exhibits_);
        auto added = add_typed(package, "argumentationElement", "argumentation_:Claim", claim.id);
        set(added, "assertionDeclaration", declaration_of(state));
        add_text(added, "name", claim.id);
        if (!claim.limits.empty()) {
            add_utility(added, "note", "Limits: " + claim.limits);
        }
        add_tag(added, "state", word_of(state));
        add_text(added.append_child("content"), "value", claim.text);
    }

    /// Adds what supports a claim: one inference from all claims directly below it, and one relation for each piece of
    /// its evidence.
    void add_support(pugi::xml_node package, const Claim& claim) const {
        std::vector<std::string> below;
        for (const auto& other : argument_.claims) {
            if (other.parent == claim.id) {
                below.push_back(other.id);
            }
        }
        if (!below.empty()) {
            auto inference =
                add_typed(package, "argumentationElement", "argumentation_:AssertedInference", "inference." + claim.id);
            set(inference, "source", fmt::format("{}", fmt::join(below, " ")));
            set(inference, "target", claim.id);
        }
        for (const auto& key : claim.evidence) {
            auto evidence = add_typed(package, "argumentationElement", "argumentation_:AssertedEvidence",
                                      "evidence." + claim.id + "." + key);
            set(evidence, "assertionDeclaration", declaration_of(state_with(key, exhibits_)));
            set(evidence, "source", "reference." + key);
            set(evidence, "target", claim.id);
        }
    }

    const Argument& argument_;
    const Exhibits& exhibits_;
    std::string version_;
    std::set<std::string> keys_;  ///< keys of all evidence that a claim names
    pugi::xml_document document_;
};

}  // namespace

std::string write_sacm(const Argument& argument, const Exhibits& exhibits, const std::string& version) {
    return CaseWriter{argument, exhibits, version}.write();
}

}  // namespace canproof::host
