// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/register/refs.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

namespace {

/// Returns whether the text has the form of an id: two or more words of capital letters and digits with dashes between
/// them, such as AO4-AOUT-002.
bool is_id(const std::string& text) {
    const auto known = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'; };
    return std::all_of(text.begin(), text.end(), known) && text.find('-') != std::string::npos && text.front() != '-' &&
           text.back() != '-' && text.find("--") == std::string::npos;
}

class ReferenceCheck {
  public:
    ReferenceCheck(const Register& content, Faults& faults) : content_{content}, faults_{faults} {
        for (const auto& manual : content.manuals) {
            refs_[manual.key] = refs_of(manual);
        }
    }

    void run() {
        check_manuals();
        for (const auto& part : content_.parts) {
            check_part_info(part);
            content_.for_each_item(part, [&](const Item& item, const char*) {
                take_id(part, item.id, item.id_place);
                check_sources(item.sources, item.source_place);
                check_origin(part, item);
            });
            for (const auto& decision : part.decisions) {
                take_id(part, decision.id, decision.id_place);
            }
            for (const auto& hazard : part.hazards) {
                take_id(part, hazard.id, hazard.id_place);
            }
        }
        for (const auto& part : content_.parts) {
            for (const auto& requirement : part.requirements) {
                check_by(part, requirement);
            }
            for (const auto& decision : part.decisions) {
                check_decision(decision);
            }
            check_reviews(part);
        }
    }

  private:
    void fault(const Place& place, const std::string& what, const std::string& fix) {
        faults_.push_back({place, what, fix});
    }

    void check_manuals() {
        std::map<std::string, Place> keys;
        for (const auto& manual : content_.manuals) {
            if (const auto [at, fresh] = keys.emplace(manual.key, manual.place); !fresh) {
                fault(manual.place, fmt::format("manual key {} is already used by {}", manual.key, at->second.file),
                      "use another key");
            }
            std::map<std::string, unsigned> seen;
            for (const auto& section : manual.sections) {
                if (const auto [at, fresh] = seen.emplace(section.ref, section.place.line); !fresh) {
                    fault(section.place, fmt::format("section {} is already in line {}", section.ref, at->second),
                          "register each section once");
                }
            }
        }
    }

    void check_part_info(const Part& part) {
        if (!part.is_device()) {
            return;
        }
        if (!part.has_device_file) {
            fault({"spec/devices/" + part.name + "/device.toml", 1}, "the device has no device.toml",
                  "write one; spec/README.md describes the file");
        } else {
            if (!part.info.manual.empty() && content_.manual(part.info.manual) == nullptr) {
                fault(part.info.manual_place, fmt::format("manual {} is not registered", part.info.manual),
                      "add spec/manuals/NAME.toml with this key");
            }
            check_sources(part.info.sources, part.info.source_place);
        }
    }

    void take_id(const Part& part, const std::string& id, const Place& place) {
        if (id.empty()) {
            return;  // the reader reports a missing id
        }
        if (part.prefix.empty() && id.front() == '-') {
            return;  // an object of a device without a prefix: the check of device.toml reports the missing prefix
        }
        if (!is_id(id)) {
            fault(place, fmt::format("id {} is malformed", id),
                  "use capitals, digits and dashes, such as AO4-AOUT-002");
        } else if (!part.prefix.empty() && id.rfind(part.prefix + "-", 0) != 0) {
            fault(place, fmt::format("id {} does not begin with {}-", id, part.prefix),
                  "begin the id with the prefix of its folder");
        }
        const auto [at, fresh] = ids_.emplace(id, place);
        if (!fresh) {
            fault(place, fmt::format("id {} is a duplicate of {}:{}", id, at->second.file, at->second.line),
                  "give one of the two another number (an object's id follows from its index)");
        }
    }

    void check_sources(const std::vector<std::string>& sources, const Place& place) {
        for (const auto& source : sources) {
            check_source(source, place);
        }
    }

    /// Checks the origin of an item. An item of a device must name a section of a manual as its source, or be derived
    /// with a reason. No item may do both. The documents of CiA do not count as manuals.
    void check_origin(const Part& part, const Item& item) {
        const bool cites_manual = std::any_of(item.sources.begin(), item.sources.end(),
                                              [](const std::string& one) { return one.rfind("CiA", 0) != 0; });
        if (!item.derived.empty() && cites_manual) {
            fault(item.source_place, fmt::format("{} is derived and cites a manual", item.id),
                  "remove the source if the section does not contain the item, otherwise remove `derived`");
        }
        if (part.is_device() && item.derived.empty() && !item.sources.empty() && !cites_manual) {
            fault(item.source_place, fmt::format("{} cites no section of a manual", item.id),
                  "add the section that contains the item, or write `derived = true` with `reason = …`");
        }
    }

    void check_source(const std::string& source, const Place& place) {
        const auto colon = source.find(':');
        const std::string key = source.substr(0, colon);
        if (colon == std::string::npos || colon + 1 == source.size()) {
            fault(place, fmt::format("source \"{}\" names no section", source),
                  "write KEY:section, such as CBX-AO412:7.10.2");
            return;
        }
        if (key.rfind("CiA", 0) == 0 || place.file.rfind(from_package, 0) == 0) {
            return;  // the manuals of the shared rules are not part of a project that uses an installed canproof
        }
        const auto manual = refs_.find(key);
        if (manual == refs_.end()) {
            fault(place, fmt::format("source \"{}\" names an unknown manual", source),
                  "use a key from spec/manuals, or CiA…");
            return;
        }
        for (const auto& ref : split_refs(source.substr(colon + 1))) {
            if (manual->second.count(ref) == 0) {
                fault(place, fmt::format("{} has no section {}", key, ref),
                      fmt::format("correct the source, or add {} to the manual's file in spec/manuals", ref));
            }
        }
    }

    /// Checks that the requirement that `by` names is a shared requirement (spec/canopen) and not retired. Checks that
    /// only a device's requirement has `by`.
    void check_by(const Part& part, const Requirement& requirement) {
        if (requirement.by.empty()) {
            return;
        }
        const auto is_meant = [&](const Requirement& other) {
            return other.id == requirement.by && other.retired.empty();
        };
        const bool found = std::any_of(content_.parts.begin(), content_.parts.end(), [&](const Part& other) {
            return !other.is_device() && std::any_of(other.requirements.begin(), other.requirements.end(), is_meant);
        });
        if (!part.is_device() || !found) {
            fault(requirement.by_place,
                  fmt::format("{} is implemented by {}, which is no shared requirement or is retired", requirement.id,
                              requirement.by),
                  "name a requirement of spec/canopen; write `by` in requirements of devices only");
        }
    }

    void check_decision(const Decision& decision) {
        for (const auto& reading : decision.readings) {
            check_source(reading.source, reading.place);
        }
        if (decision.affects.empty() && decision.none.empty()) {
            fault(decision.place, fmt::format("{} affects nothing", decision.id),
                  "name the affected ids, or give the reason in `none = …`");
        }
        for (const auto& id : decision.affects) {
            if (ids_.count(id) == 0) {
                fault(decision.affects_place, fmt::format("{} affects {}, which does not exist", decision.id, id),
                      "correct the id or remove it");
            }
        }
    }

    void check_reviews(const Part& part) {
        const Manual* manual = content_.manual(part.info.manual);
        for (const auto* reviews : {&part.reviews, &part.independent_reviews}) {
            for (const auto& [id, review] : *reviews) {
                const bool is_section =
                    manual != nullptr &&
                    std::any_of(manual->sections.begin(), manual->sections.end(),
                                [&, &wanted = id](const Section& one) { return one.id(manual->key) == wanted; });
                if (!is_section && ids_.count(id) == 0) {
                    fault(review.place, fmt::format("the reviewed item or section {} does not exist", id),
                          "remove the line");
                }
            }
        }
    }

    const Register& content_;
    Faults& faults_;
    std::map<std::string, std::set<std::string>> refs_;
    std::map<std::string, Place> ids_;
};

}  // namespace

void check_references(const Register& content, Faults& faults) {
    ReferenceCheck{content, faults}.run();
}

}  // namespace canproof::host
