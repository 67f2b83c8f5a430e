// SPDX-License-Identifier: Apache-2.0
// Checks the names of tables and objects in the generated C++, and the tables to which [services] refers.
#include "host/register/check_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "host/register/literals.hpp"

namespace canproof::host {

namespace {

class NameCheck {
  public:
    NameCheck(const Part& part, Faults& faults) : part_{part}, faults_{faults} {}

    void run() {
        check_tables();
        check_standard_objects();
        check_services();
    }

  private:
    void fault(const Place& place, const std::string& what, const std::string& fix) {
        faults_.push_back({place, what, fix});
    }

    void check_tables() {
        std::map<std::string, std::string> taken{
            {"tables", "the generated code"},     {"field", "the generated code"},   {"index", "the generated code"},
            {"error", "the generated code"},      {"profile", "the generated code"}, {"compiled", "the generated code"},
            {"error_table", "the generated code"}};
        for (const Constant& constant : part_.constants) {
            taken.emplace(constant.name, constant.id);
        }
        for (const Table& table : part_.tables) {
            if (!is_cpp_name(table.name)) {
                fault(table.place, fmt::format("{} name {} is no C++ name", table.id, table.name),
                      "add `name = …` of letters, digits and underscores that is no keyword");
            } else if (const auto [at, fresh] = taken.emplace(table.name, table.id); !fresh) {
                fault(table.place, fmt::format("{} name {} is already used by {}", table.id, table.name, at->second),
                      "add `name = …` that no table or constant of this folder has");
            }
            check_error_column(table);
        }
    }

    void check_error_column(const Table& table) {
        const auto is_it = [&](const Column& column) { return column.name == table.errors; };
        const auto found = std::find_if(table.inputs.begin(), table.inputs.end(), is_it);
        if (!table.errors.empty() &&
            (found == table.inputs.end() || found->kind != Column::Kind::words || !found->enumeration.empty())) {
            fault(table.place,
                  fmt::format("{}: `errors` names {}, which is no input column of words", table.id, table.errors),
                  "name an input column that has its own words");
        }
        if (!table.errors.empty()) {
            check_error_outputs(table);
        }
    }

    /// Checks the output columns of a table of errors, from which the ErrorTable of the firmware is generated.
    void check_error_outputs(const Table& table) {
        static const std::set<std::string> known{"code",   "register_bits", "sent",   "listed",
                                                 "detail", "description",   "channel"};
        std::set<std::string> names;
        for (const Column& column : table.outputs) {
            names.insert(column.name);
            if (known.count(column.name) == 0) {
                fault(table.place, fmt::format("{} column {} is no property of an error", table.id, column.name),
                      fmt::format("use the columns {}", fmt::join(known, ", ")));
            }
        }
        if (names.count("code") == 0) {
            fault(table.place, fmt::format("{} is a table of errors but has no output column `code`", table.id),
                  "add the column `code` with the emergency codes");
        }
        if (names.count("description") != names.count("channel") ||
            names.count("detail") + names.count("description") > 1) {
            fault(
                table.place,
                fmt::format("{} must define the upper half of an entry in 1003h (error field) exactly once", table.id),
                "use the columns description and channel, or the column detail alone");
        }
    }

    void check_standard_objects() {
        std::set<std::uint16_t> indices;
        std::set<std::string> names;
        for (const StandardObject& object : part_.standard_objects) {
            if (part_.is_device()) {
                fault(object.place, fmt::format("standard object {:04X}h is in the files of a device", object.index),
                      "move the object to spec/canopen, or write [[object]]");
            } else if (!is_cpp_name(snake_case(object.name))) {
                fault(object.place, fmt::format("the name \"{}\" of a standard object gives no C++ name", object.name),
                      "begin the name with a letter, and use no C++ keyword");
            } else if (!indices.insert(object.index).second || !names.insert(snake_case(object.name)).second) {
                fault(object.place, fmt::format("standard object {:04X}h or its name is listed twice", object.index),
                      "keep one of the two");
            }
        }
    }

    void check_services() {
        const DeviceInfo& info = part_.info;
        const bool found = std::any_of(part_.tables.begin(), part_.tables.end(),
                                       [&](const Table& table) { return table.id == info.lss_bit_rates; });
        if (!info.lss_bit_rates.empty() && !found) {
            fault(info.services_place, fmt::format("lss_bit_rates {} is no table of the device", info.lss_bit_rates),
                  "name a table with the columns index and bit_rate");
        }
        for (const std::int64_t number : info.rpdos_answering_remote) {
            if (number < 1 || number > 8) {
                fault(info.services_place, fmt::format("rpdos_answering_remote names RPDO {}", number),
                      "use numbers from 1 to 8");
            }
        }
    }

    const Part& part_;
    Faults& faults_;
};

}  // namespace

void check_names(const Part& part, Faults& faults) {
    NameCheck{part, faults}.run();
}

}  // namespace canproof::host
