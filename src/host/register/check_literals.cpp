// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_literals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

class LiteralCheck {
  public:
    LiteralCheck(const Part& part, Faults& faults) : part_{part}, faults_{faults} {}

    void run() {
        std::map<std::string, std::string> constants;
        for (const Constant& constant : part_.constants) {
            check_name(constant, constant.name, constants);
            check_constant(constant);
        }
        std::map<std::string, std::string> enumerations;
        for (const Enumeration& enumeration : part_.enumerations) {
            check_name(enumeration, enumeration.name, enumerations);
            check_words(enumeration);
        }
        std::map<std::string, std::string> signals;
        for (const Signal& signal : part_.signals) {
            std::string member = signal.name;
            if (const auto at = member.find("{n}"); at != std::string::npos) {
                member.erase(at, 3);
            }
            check_name(signal, member, signals);
            check_signal(signal);
        }
    }

  private:
    void fault(const Place& place, const std::string& what, const std::string& fix) {
        faults_.push_back({place, what, fix});
    }

    void check_name(const Item& item, const std::string& name, std::map<std::string, std::string>& taken) {
        if (name.empty()) {
            return;  // the reader reports a missing name
        }
        if (!is_cpp_name(name)) {
            fault(item.place, fmt::format("{} name {} is no C++ name", item.id, name),
                  "use letters, digits and underscores, begin with a letter, and use no C++ keyword");
        }
        const std::string place = fmt::format("{}:{}", item.place.file, item.place.line);
        if (const auto [at, fresh] = taken.emplace(name, place); !fresh) {
            fault(item.place, fmt::format("{} name {} is already used in {}", item.id, name, at->second),
                  "give each item its own name");
        }
    }

    void check_constant(const Constant& constant) {
        if (!is_known_type(constant.type) || type_size(constant.type) == 0 || constant.type == "BOOLEAN") {
            if (!constant.type.empty()) {
                fault(constant.place, fmt::format("{} type {} is unknown", constant.id, constant.type),
                      "use REAL32, REAL64 or an integer type");
            }
        } else if (!fits_type(constant.value, constant.type)) {
            fault(constant.value_place,
                  fmt::format("{} value {} is no {}", constant.id, to_text(constant.value), constant.type),
                  fmt::format("use {}", type_words(constant.type)));
        }
    }

    void check_words(const Enumeration& enumeration) {
        std::set<std::int64_t> numbers;
        std::set<std::string> words;
        for (const auto& [word, number] : enumeration.values) {
            if (!numbers.insert(number).second) {
                fault(enumeration.place, fmt::format("{} gives the number {} to two words", enumeration.id, number),
                      "give each word its own number");
            }
            if (snake_case(word).empty() || !words.insert(snake_case(word)).second) {
                fault(enumeration.place,
                      fmt::format("{} has no C++ name of its own for the word \"{}\"", enumeration.id, word),
                      "use words that differ in their letters and digits");
            }
            if (number < INT32_MIN || number > std::int64_t{UINT32_MAX}) {
                fault(enumeration.place,
                      fmt::format("{} gives the number {} to the word {}", enumeration.id, number, word),
                      "use numbers of at most 32 bits");
            }
        }
    }

    void check_signal(const Signal& signal) {
        const bool known = is_known_type(signal.type) && type_size(signal.type) > 0;
        if (!known) {
            if (!signal.type.empty()) {
                fault(signal.place, fmt::format("{} type {} is unknown", signal.id, signal.type),
                      "use BOOLEAN, an integer type or REAL32");
            }
            return;
        }
        if (!fits_type(signal.value, signal.type)) {
            fault(signal.default_place,
                  fmt::format("{} default {} is no {}", signal.id, to_text(signal.value), signal.type),
                  fmt::format("use {}", type_words(signal.type)));
            return;
        }
        if (signal.type != "BOOLEAN" && (!signal.minimum || !signal.maximum)) {
            fault(signal.place, fmt::format("{} has no range", signal.id), "give the signal `min` and `max`");
            return;
        }
        if (signal.minimum && signal.maximum && *signal.minimum > *signal.maximum) {
            fault(signal.place,
                  fmt::format("{} minimum {} exceeds its maximum {}", signal.id, *signal.minimum, *signal.maximum),
                  "exchange the minimum and the maximum");
            return;
        }
        const double value = number_of(signal.value).value_or(0.0);
        if ((signal.minimum && value < *signal.minimum) || (signal.maximum && value > *signal.maximum)) {
            fault(signal.default_place,
                  fmt::format("{} default {} is outside {} to {}", signal.id, to_text(signal.value),
                              signal.minimum.value_or(-INFINITY), signal.maximum.value_or(INFINITY)),
                  "correct the default or the range");
        }
    }

    const Part& part_;
    Faults& faults_;
};

}  // namespace

void check_literals(const Part& part, Faults& faults) {
    LiteralCheck{part, faults}.run();
}

}  // namespace canproof::host
