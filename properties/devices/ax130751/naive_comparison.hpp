// SPDX-License-Identifier: Apache-2.0
// Compares an AX130751 with its naive model. Calls `check(holds, what, index)` for each compared value.
#pragma once

#include <map>
#include <vector>

#include "devices/ax130751/firmware/ax130751.hpp"
#include "properties/devices/ax130751/naive_device.hpp"

namespace canproof::naive_ax130751 {

template <typename Check>
class Comparison {
  public:
    Comparison(const ax130751::Device& device, const Device& model, const Check& check)
        : device_{device}, model_{model}, check_{check} {}

    void outputs() const {
        const auto& outputs = device_.outputs();
        for (std::size_t n = 0; n < 2; ++n) {
            const Terminals& terminals = model_.terminals.at(n);
            expect("voltage", outputs.out_voltage.at(n), static_cast<float>(terminals.volts));
            expect("current", outputs.out_current.at(n), static_cast<float>(terminals.milliamperes));
            expect("duty cycle", outputs.out_duty.at(n), static_cast<float>(terminals.duty));
            expect("frequency", outputs.out_frequency.at(n), static_cast<float>(terminals.hertz));
            expect("level", outputs.out_level.at(n), static_cast<float>(terminals.level));
            expect("state", outputs.out_on.at(n), terminals.on);
        }
        expect("relay on NC", outputs.relay_nc, model_.relay_on_nc);
        expect("relay on NO", outputs.relay_no, !model_.relay_on_nc);
    }
    void values() const {
        const Shown& shown = model_.shown;
        for (int n = 1; n <= 10; ++n) {
            entry(table_index(n) + 8, 0, shown.tables.at(static_cast<std::size_t>(n - 1)).output, 2);
        }
        for (int n = 1; n <= 3; ++n) {
            const auto& logic = shown.logic.at(static_cast<std::size_t>(n - 1));
            entry(0x3310, n, logic.selected, 1);
            entry(0x3320, n, logic.output, 2);
        }
        for (int n = 1; n <= 4; ++n) {
            entry(0x4030, n, shown.math.at(static_cast<std::size_t>(n - 1)), 2);
        }
        for (int n = 1; n <= 2; ++n) {
            entry(0x7330, n, shown.target.at(static_cast<std::size_t>(n - 1)), 2);
            entry(0x2370, n, shown.feedback.at(static_cast<std::size_t>(n - 1)), 2);
        }
        expect("state of the node", device_.state() == NmtState::operational, model_.state == Nmt::operational);
    }
    /// Compares 1001h (error register) and 1003h (error list).
    void errors() const {
        const auto& list = model_.errors.list();
        entry(0x1001, 0, model_.errors.reg(), 1);
        entry(0x1003, 0, static_cast<int>(list.size()), 1);
        for (std::size_t i = 0; i < list.size(); ++i) {
            entry(0x1003, static_cast<int>(i + 1), static_cast<int>(list.at(i)), 4);
        }
    }
    void parameters() const {
        for (const auto& [address, one] : model_.entries()) {
            entry(address.first, address.second, *one.value, static_cast<unsigned>(one.bytes));
        }
    }
    /// Compares frames. Frames with the same identifier must be in the same order; frames with different identifiers
    /// may be in another order.
    void frames(const std::vector<Said>& said) const {
        const auto by_identifier = [](const std::vector<Said>& of) {
            std::multimap<unsigned, Said> all;
            for (const auto& frame : of) {
                all.emplace(frame.id, frame);
            }
            return all;
        };
        check_(by_identifier(said) == by_identifier(model_.said), "the frames of the model", 0U);
    }

  private:
    template <typename Real, typename Expected>
    void expect(const char* what, const Real& is, const Expected& expected) const {
        const auto a = static_cast<double>(is);
        const auto b = static_cast<double>(expected);
        check_(!(a < b || a > b), what, 0U);
    }
    void entry(int index, int sub, int expected, unsigned bytes) const {
        const std::uint64_t raw =
            device_.objects().read(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
        const std::uint64_t mask = (std::uint64_t{1} << (8U * bytes)) - 1U;
        check_((raw & mask) == (static_cast<std::uint64_t>(expected) & mask), "entry",
               static_cast<unsigned>(index * 0x100 + sub));
    }

    const ax130751::Device& device_;
    const Device& model_;
    const Check& check_;
};

}  // namespace canproof::naive_ax130751
