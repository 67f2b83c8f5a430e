// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_hazards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace canproof::host {

namespace {

class HazardCheck {
  public:
    HazardCheck(const Register& content, Faults& faults) : faults_{faults} {
        for (const auto& part : content.parts) {
            for (const auto& requirement : part.requirements) {
                if (requirement.retired.empty()) {
                    requirements_.insert(requirement.id);
                }
            }
            for (const auto& object : part.objects) {
                places_.insert(object.id);
            }
            for (const auto& signal : part.signals) {
                places_.insert(signal.id);
            }
            for (const auto& decision : part.decisions) {
                decisions_.insert(decision.id);
            }
        }
    }

    void run(const Part& part) {
        std::set<std::string> named;
        for (const auto& hazard : part.hazards) {
            check(hazard);
            named.insert(hazard.at.begin(), hazard.at.end());
        }
        for (const auto& signal : part.signals) {
            if (!part.hazards.empty() && !signal.input && named.count(signal.id) == 0) {
                faults_.push_back({signal.place, fmt::format("no hazard names the output {}", signal.id),
                                   "write a [[hazard]] that names the output in `at`, or add the output to the `at` of "
                                   "another hazard"});
            }
        }
    }

  private:
    void check(const Hazard& hazard) {
        for (const auto& id : hazard.at) {
            require(places_, id, hazard.at_place, "neither a signal nor an object", "name an output or a message");
        }
        for (const auto& id : hazard.decisions) {
            require(decisions_, id, hazard.decisions_place, "no decision", "name a decision of the register");
        }
        for (const auto& failure : hazard.failures) {
            for (const auto& id : failure.prevented_by) {
                require(requirements_, id, failure.place, "no requirement or is retired",
                        "name a requirement that prevents the failure");
            }
        }
    }

    void require(const std::set<std::string>& known, const std::string& id, const Place& place, const char* what,
                 const char* fix) {
        if (known.count(id) == 0) {
            faults_.push_back({place, fmt::format("{} is {}", id, what), fix});
        }
    }

    Faults& faults_;
    std::set<std::string> requirements_;
    std::set<std::string> places_;
    std::set<std::string> decisions_;
};

}  // namespace

void check_hazards(const Register& content, Faults& faults) {
    HazardCheck check{content, faults};
    for (const auto& part : content.parts) {
        check.run(part);
    }
}

}  // namespace canproof::host
