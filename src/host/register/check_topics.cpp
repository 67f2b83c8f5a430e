// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_topics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace canproof::host {

namespace {

/// An item and its answer to a topic. A topic is a question that several items answer.
struct Given {
    const Item* item;
    const Answer* answer;
};

/// The answer of one device, or of the shared rules (spec/canopen), to a topic.
struct Stand {
    const Part* part;
    std::vector<Given> items;  ///< items of the device that answer the topic; at least one

    const std::string& choice() const { return items.front().answer->choice; }
    const Item& first() const { return *items.front().item; }
    bool differs() const {
        return says([](const Answer& answer) { return !answer.differs.empty(); });
    }
    bool overrides() const {
        return says([](const Answer& answer) { return !answer.overrides.empty(); });
    }
    template <typename Test>
    bool says(const Test& test) const {
        return std::any_of(items.begin(), items.end(), [&](const Given& given) { return test(*given.answer); });
    }
};

using Stands = std::vector<Stand>;

bool same_maker(const Stand& one, const Stand& other) {
    return one.part != other.part && one.part->is_device() && other.part->is_device() &&
           one.part->info.vendor == other.part->info.vendor;
}

/// Returns the answer in words: `CO-HB-002 (spec/canopen/error_control.toml:30) chooses first-message`.
std::string choice_of(const Stand& stand) {
    const Place& place = stand.items.front().answer->place;
    return fmt::format("{} ({}:{}) chooses {}", stand.first().id, place.file, place.line, stand.choice());
}

/// Returns the value in [services] of device.toml that also answers the topic; nothing for a topic without such a
/// value.
std::optional<std::string> service_of(const DeviceInfo& info, const std::string& topic) {
    const std::map<std::string, std::string> services{{"services.lss", info.lss ? "true" : "false"},
                                                      {"services.block_sdo", info.block_sdo ? "true" : "false"},
                                                      {"services.limit_abort", info.limit_abort},
                                                      {"services.error_list", info.error_list}};
    const auto found = services.find(topic);
    return found == services.end() ? std::nullopt : std::optional{found->second};
}

class TopicCheck {
  public:
    TopicCheck(const Register& content, Faults& faults) : faults_{faults} {
        for (const Part& part : content.parts) {
            whole_ = whole_ || (part.is_device() && !part.decisions.empty());
            inherits_ = inherits_ || part.inherited;
            for (const Requirement& requirement : part.requirements) {
                if (requirement.retired.empty()) {
                    take(part, requirement, requirement.answer);
                }
            }
            for (const Decision& decision : part.decisions) {
                take(part, decision, decision.answer);
            }
        }
    }

    void run() {
        for (const auto& [topic, stands] : topics_) {
            const bool service = topic.rfind("services.", 0) == 0;
            for (const Stand& stand : stands) {
                check_within(topic, stand);
                if (service) {
                    check_service(topic, stand);
                }
            }
            if (whole_ && !inherits_ && !service && stands.size() == 1 && stands.front().items.size() == 1) {
                fault(stands.front(), fmt::format("no other item answers topic {}", topic),
                      "spell the topic as other items do, or remove `topic` and `choice`");
            }
            compare(topic, stands);
            if (whole_) {
                for (const Stand& stand : stands) {
                    check_needed(stand, stands);
                }
            }
        }
    }

  private:
    void take(const Part& part, const Item& item, const Answer& answer) {
        if (answer.topic.empty() || answer.choice.empty()) {
            return;  // the item answers no topic, or the reader has reported its missing choice
        }
        Stands& stands = topics_[answer.topic];
        if (stands.empty() || stands.back().part != &part) {
            stands.push_back({&part, {}});
        }
        stands.back().items.push_back({&item, &answer});
    }

    void fault(const Stand& stand, const std::string& what, const std::string& fix) {
        faults_.push_back({stand.items.front().answer->place, what, fix});
    }

    /// Checks that all items of one folder give the same answer. A difference within a folder is always a fault.
    void check_within(const std::string& topic, const Stand& stand) {
        for (const Given& given : stand.items) {
            if (given.answer->choice != stand.choice()) {
                faults_.push_back({given.answer->place,
                                   fmt::format("{} chooses {} for topic {}, but {}", given.item->id,
                                               given.answer->choice, topic, choice_of(stand)),
                                   "choose one answer, and correct the other item"});
            }
        }
    }

    void check_service(const std::string& topic, const Stand& stand) {
        if (!stand.part->is_device()) {
            fault(stand, fmt::format("{} is a shared item and cannot answer topic {}", stand.first().id, topic),
                  "leave this topic to the devices");
            return;
        }
        const auto service = service_of(stand.part->info, topic);
        if (!service) {
            fault(stand, fmt::format("device.toml has no {}", topic),
                  "use services.lss, services.block_sdo, services.limit_abort or services.error_list");
        } else if (*service != stand.choice()) {
            fault(stand,
                  fmt::format("{} chooses {} for topic {}, but device.toml has {}", stand.first().id, stand.choice(),
                              topic, *service),
                  "correct the item or device.toml");
        }
    }

    void compare(const std::string& topic, const Stands& stands) {
        for (const Stand& stand : stands) {
            const std::string own =
                fmt::format("{} chooses {} for topic {}, but", stand.first().id, stand.choice(), topic);
            for (const Stand& other : stands) {
                if (&other == &stand) {
                    break;  // each pair is reported once, with its later item
                }
                if (other.choice() == stand.choice()) {
                    continue;
                }
                if (!other.part->is_device() && !stand.overrides()) {
                    fault(stand, fmt::format("{} the shared {}", own, choice_of(other)),
                          "give the same answer, or give the reason in `overrides = …`");
                } else if (same_maker(stand, other) && !explained(stand, other, stands)) {
                    fault(stand, fmt::format("{} {} for the same manufacturer", own, choice_of(other)),
                          "give the same answer, or give the reason in `differs = …` of one of the two items");
                }
            }
        }
    }

    /// Returns whether the difference between two answers is explained. One of the two must give a reason to differ
    /// (`differs`). Or one agrees with the shared item and the other gives a reason to override the shared item
    /// (`overrides`).
    static bool explained(const Stand& one, const Stand& other, const Stands& stands) {
        const Stand& shared = stands.front();
        const bool has_shared = !shared.part->is_device();
        return one.differs() || other.differs() ||
               (has_shared && one.choice() == shared.choice() && other.overrides()) ||
               (has_shared && other.choice() == shared.choice() && one.overrides());
    }

    /// Reports each reason (`differs`, `overrides`) for a difference that does not exist.
    void check_needed(const Stand& stand, const Stands& stands) {
        const auto against = [&](const auto& matters) {
            return std::any_of(stands.begin(), stands.end(),
                               [&](const Stand& other) { return other.choice() != stand.choice() && matters(other); });
        };
        const bool maker = against([&](const Stand& other) { return same_maker(stand, other); });
        const bool shared = against([](const Stand& other) { return !other.part->is_device(); });
        for (const Given& given : stand.items) {
            if (!given.answer->differs.empty() && !maker) {
                faults_.push_back(
                    {given.answer->place,
                     fmt::format(
                         "{} gives a reason to differ, but no device of the same manufacturer chooses differently",
                         given.item->id),
                     "remove `differs`"});
            }
            if (!given.answer->overrides.empty() && !shared) {
                faults_.push_back({given.answer->place,
                                   fmt::format("{} gives a reason to override, but no shared item chooses differently",
                                               given.item->id),
                                   "remove `overrides`"});
            }
        }
    }

    Faults& faults_;
    std::map<std::string, Stands> topics_;
    /// Whether the register contains the decisions of devices. The register embedded in the program does not contain
    /// them, so missing answers are no faults there.
    bool whole_{false};
    /// whether the shared rules come with an installed canproof; the project then need not answer the topics of these
    /// rules
    bool inherits_{false};
};

}  // namespace

void check_topics(const Register& content, Faults& faults) {
    TopicCheck{content, faults}.run();
}

}  // namespace canproof::host
