// SPDX-License-Identifier: Apache-2.0
// Runs two AX130751s. The second device has the outputs, lookup tables, logic blocks, math blocks and extra received
// values of the first in another order. It gets its parameters and inputs in this other order, and its results must be
// in this order too.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "properties/devices/ax130751/driven_device.hpp"
#include "properties/devices/ax130751/model_steps.hpp"

namespace canproof::test {

/// For each kind of element: the numbers that elements 1, 2, … of the first device have in the second device.
struct Order {
    std::vector<int> outputs{2, 1};
    std::vector<int> extras;
    std::vector<int> tables;
    std::vector<int> logic;
    std::vector<int> math;

    static int of(const std::vector<int>& kind, int number) {
        const bool is_one = number >= 1 && number <= static_cast<int>(kind.size());
        return is_one ? kind.at(static_cast<std::size_t>(number - 1)) : number;
    }

    Address address(int index, int sub) const {
        switch (group_of(index)) {
            case Group::output:
                return {index, of(outputs, sub)};
            case Group::extra:
                return {index, of(extras, sub)};
            case Group::table:
                return {naive_ax130751::table_index(of(tables, naive_ax130751::table_of(index))) + index % 0x10, sub};
            case Group::logic:
                return index < 0x3400
                           ? Address{index, of(logic, sub)}
                           : Address{0x3300 + 0x100 * of(logic, (index - 0x3300) / 0x100) + index % 0x100, sub};
            case Group::math:
                return index < 0x4100
                           ? Address{index, of(math, sub)}
                           : Address{0x4000 + 0x100 * of(math, (index - 0x4000) / 0x100) + index % 0x100, sub};
            default:
                return {index, sub};
        }
    }
    /// Returns the number (Table 4B) that a source of the first device has in the second device.
    int number(int source, int number) const {
        switch (source) {
            case 1:
                return number >= 4 ? 3 + of(extras, number - 3) : of(outputs, number);
            case 3:
                return of(tables, number);
            case 4:
                return of(math, number);
            case 5:
                return of(logic, number);
            case 6:
            case 7:
                return of(outputs, number);
            default:
                return number;
        }
    }
};

class Mirrored {
  public:
    explicit Mirrored(Order order) : order_{std::move(order)} {}

    void write(int index, int sub, int value) { write(index, sub, value, value); }
    /// Writes a control source: its kind `source` and its `number`. These are two adjacent objects, or in a condition
    /// of a logic block two adjacent sub-indices.
    void choose(int index, int sub, int source, int number) {
        const bool in_condition = group_of(index) == Group::logic;
        write(index, sub, source);
        write(in_condition ? index : index + 1, in_condition ? sub + 1 : sub, number, order_.number(source, number));
    }
    /// Writes which lookup table function `place` (1 to 3) of a logic block selects.
    void choose_table(int block, int place, int table) {
        write(0x3301 + 0x100 * block, place, table, Order::of(order_.tables, table));
    }
    void set_up(int index, int sub, std::uint32_t value, std::uint32_t other, int bytes) {
        expect(index, sub, one_.write(index, sub, value, bytes), other_.write(index, sub, other, bytes));
    }
    /// Sends an RPDO. RPDO1 has two process values of outputs and the state of the relay, RPDO4 the states of two
    /// outputs. RPDO2 and RPDO3 have three extra received values each.
    void rpdo(int number, const std::vector<int>& values) {
        std::vector<int> others{values};
        for (std::size_t i = 0; i < values.size(); ++i) {
            const int at = static_cast<int>(i) + 1;
            const int to = number == 1 || number == 4 ? Order::of(order_.outputs, at)
                           : number == 2              ? Order::of(order_.extras, at)
                                                      : Order::of(order_.extras, at + 3) - 3;
            others.at(static_cast<std::size_t>(to - 1)) = values.at(i);
        }
        receive(one_, number, values);
        receive(other_, number, others);
    }
    void command(int specifier) {
        one_.receive(0, {specifier, static_cast<int>(DrivenDevice::node)});
        other_.receive(0, {specifier, static_cast<int>(DrivenDevice::node)});
    }
    void inputs(float supply, float temperature, float load_1, float load_2) {
        one_.inputs({supply, temperature, {load_1, load_2}});
        other_.inputs({supply, temperature, {load_2, load_1}});
    }
    void pass(int ms) {
        one_.pass(ms);
        other_.pass(ms);
        compare();
    }
    void compare_parameters() {
        for (const auto& [address, entry] : entries_) {
            const auto [index, sub] = address;
            const bool is_number = numbers_.count(address) != 0;
            if (!is_number) {
                expect_same(index, sub);
            }
        }
    }
    const std::string& difference() const { return difference_; }
    const std::string& story() const { return story_; }

  private:
    void write(int index, int sub, int value, int other) {
        const int bytes = entries_.at({index, sub}).bytes;
        const auto [index_there, sub_there] = order_.address(index, sub);
        story_ += fmt::format("{:04X}h:{} := {}, {:04X}h:{} := {}\n", index, sub, value, index_there, sub_there, other);
        const bool depends = value != other || index % 0x10 == 1 || group_of(index) == Group::logic;
        if (depends) {
            numbers_[{index, sub}] = true;
        }
        expect(index, sub, one_.write(index, sub, static_cast<std::uint32_t>(value), bytes),
               other_.write(index_there, sub_there, static_cast<std::uint32_t>(other), bytes));
    }
    static void receive(DrivenDevice& device, int number, const std::vector<int>& values) {
        std::vector<int> bytes;
        for (std::size_t i = 0; i < values.size(); ++i) {
            bytes.push_back(values.at(i) & 0xFF);
            const bool is_word = number == 2 || number == 3 || (number == 1 && i < 2);
            if (is_word) {
                bytes.push_back(values.at(i) >> 8 & 0xFF);
            }
        }
        device.receive(0x100 + 0x100 * static_cast<unsigned>(number) + DrivenDevice::node, bytes);
    }
    void expect(int index, int sub, std::uint64_t one, std::uint64_t other) {
        if (difference_.empty() && one != other) {
            difference_ = fmt::format("{:04X}h:{} is {} here, {} there", index, sub, one, other);
        }
    }
    void expect_same(int index, int sub) {
        const auto [index_there, sub_there] = order_.address(index, sub);
        expect(index, sub, one_.read(index, sub), other_.read(index_there, sub_there));
    }
    void compare() {
        for (int n = 1; n <= 10; ++n) {
            expect_same(naive_ax130751::table_index(n) + 8, 0);
        }
        for (int n = 1; n <= 4; ++n) {
            expect_same(0x4030, n);
        }
        for (int n = 1; n <= 3; ++n) {
            const std::uint64_t selected = one_.read(0x3310, n);
            expect(0x3310, n, static_cast<std::uint64_t>(Order::of(order_.tables, static_cast<int>(selected))),
                   other_.read(0x3310, Order::of(order_.logic, n)));
            expect_same(0x3320, n);
            expect(0x1003, n, one_.read(0x1003, n), other_.read(0x1003, n));
        }
        for (int n = 1; n <= 2; ++n) {
            expect_same(0x7330, n);
            expect_same(0x2370, n);
        }
        compare_outputs();
        compare_frames();
    }
    void compare_outputs() {
        const auto list = [](const DrivenDevice& device, std::size_t n) {
            const auto& outputs = device.device().outputs();
            return std::vector<float>{outputs.out_voltage.at(n),     outputs.out_current.at(n),
                                      outputs.out_duty.at(n),        outputs.out_frequency.at(n),
                                      outputs.out_level.at(n),       outputs.out_on.at(n) ? 1.0F : 0.0F,
                                      outputs.relay_nc ? 1.0F : 0.0F};
        };
        if (difference_.empty() && (list(one_, 0) != list(other_, 1) || list(one_, 1) != list(other_, 0))) {
            difference_ = fmt::format("outputs {} and {} here, {} and {} there", fmt::join(list(one_, 0), " "),
                                      fmt::join(list(one_, 1), " "), fmt::join(list(other_, 0), " "),
                                      fmt::join(list(other_, 1), " "));
        }
    }
    /// Compares the frames of both devices. TPDO1 and TPDO2 have one 16-bit value for each output, in the order of the
    /// device. All other frames must be equal.
    void compare_frames() {
        for (auto& frame : other_.said) {
            if (frame.id == 0x1FF || frame.id == 0x2FF) {
                std::rotate(frame.data.begin(), frame.data.begin() + 2, frame.data.end());
            }
        }
        if (difference_.empty() && !(one_.said == other_.said)) {
            difference_ = "other frames here than there";
        }
        one_.said.clear();
        other_.said.clear();
    }

    Order order_;
    naive_ax130751::Parameters parameters_;
    naive_ax130751::Entries entries_{naive_ax130751::entries_of(parameters_)};
    std::map<Address, bool> numbers_;
    DrivenDevice one_;
    DrivenDevice other_;
    std::string story_;
    std::string difference_;
};

}  // namespace canproof::test
