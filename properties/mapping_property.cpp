// SPDX-License-Identifier: Apache-2.0
// Remaps a PDO by writes in any order, right or wrong. Compares it with a naive PDO, a second and simple implementation
// (CiA 301, 7.5.2.35 to 7.5.2.38). Compares every abort code, the resulting entries, and the length of the frame that
// is sent.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include "generated/canopen/requirements.hpp"
#include "properties/support/logged_slave.hpp"
#include "properties/support/naive_mapping.hpp"
#include "tests/support/sdo_text.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using naive_mapping::Mappable;
using naive_mapping::Pdo;

struct Event {
    unsigned kind{0};      ///< 0, 1: write of the COB-ID; 2, 3: of a mapping entry; 4, 5: of the number of entries; 6:
                           ///< visits operational
    unsigned number{0};    ///< sub-index, number of entries, or bits of the COB-ID, depending on `kind`
    Mappable line{};       ///< the entry to map
    bool receives{false};  ///< whether the PDO is RPDO3; otherwise it is TPDO3
};

class Happens : public rc::state::Command<Pdo, LoggedSlave> {
  public:
    explicit Happens(const Event& event) : event_{event} {}

    void apply(Pdo& pdo) const override { static_cast<void>(write(pdo)); }
    void run(const Pdo& before, LoggedSlave& slave) const override {
        Pdo pdo = before;
        slave.heard.clear();
        if (event_.kind == 6) {
            return visit_operational(pdo, slave);
        }
        const std::uint32_t code = write(pdo);
        slave.play(text());
        const std::string answer = slave.heard.empty() ? "" : slave.heard.front().second;
        const std::string expected =
            code == 0 ? "585#60" + object() + "00000000" : "585#80" + object() + hex_le(code, 4);
        slave.demand(answer == expected, "the answer to " + text() + ", " + answer + ",");
        compare(pdo, slave);
    }
    void show(std::ostream& out) const override { out << "can0 " << text(); }

  private:
    unsigned identifier() const { return (event_.receives ? 0x405U : 0x385U) + (event_.number & 1U) * 0x10U; }
    bool makes_valid() const { return (event_.number & 2U) != 0; }
    std::uint32_t write(Pdo& pdo) const {
        switch (event_.kind) {
            case 0:
            case 1:
                return pdo.write_cob_id(identifier(), makes_valid());
            case 2:
            case 3:
                return pdo.write_line(1 + event_.number % 9, event_.line);
            case 4:
            case 5:
                return pdo.write_count(event_.number % 11);
            default:
                return naive_mapping::done;
        }
    }
    std::string object() const {
        const unsigned base = event_.receives ? 0x1402U : 0x1802U;
        if (event_.kind < 2) {
            return hex_le(base, 2) + "01";
        }
        return hex_le(base + 0x200U, 2) + (event_.kind < 4 ? hex_le(1 + event_.number % 9, 1) : "00");
    }
    std::string text() const {
        switch (event_.kind) {
            case 0:
            case 1:
                return "605#23" + object() + hex_le(identifier() | (makes_valid() ? 0U : 0x80000000U), 4);
            case 2:
            case 3:
                return "605#23" + object() +
                       hex_le(event_.line.index << 16U | event_.line.subindex << 8U | event_.line.bits, 4);
            case 4:
            case 5:
                return "605#2F" + object() + hex_le(event_.number % 11, 1) + "000000";
            default:
                return "000#0105";
        }
    }
    /// Enters operational for a moment. A valid TPDO with transmission type 254 is then sent once (CiA 301, 7.2.2.3).
    void visit_operational(const Pdo& pdo, LoggedSlave& slave) const {
        slave.play("000#0105");
        std::vector<std::size_t> lengths;
        for (const auto& [ms, frame] : slave.heard) {
            if (frame.substr(0, 4) == "385#" || frame.substr(0, 4) == "395#") {
                lengths.push_back((frame.size() - 4) / 2);
            }
        }
        const bool sent = !event_.receives && pdo.is_valid() && pdo.count() != 0;
        slave.play("000#8005");
        slave.demand(lengths == (sent ? std::vector<std::size_t>{pdo.length()} : std::vector<std::size_t>{}), "length");
    }
    void compare(const Pdo& pdo, const LoggedSlave& slave) const {
        const ObjectDictionary& objects = std::as_const(*slave.device).objects();
        const auto index = static_cast<std::uint16_t>(event_.receives ? 0x1602 : 0x1A02);
        slave.demand(objects.read(index, 0) == pdo.count(), "the count");
        for (std::uint8_t sub = 1; sub <= 8; ++sub) {
            const Mappable& line = pdo.lines()[sub - 1U];
            slave.demand(objects.read(index, sub) == (line.index << 16U | line.subindex << 8U | line.bits), "a line");
        }
    }
    Event event_;
};

/// Generates mapping entries for RPDOs or TPDOs: valid entries, and invalid ones. The object of an invalid entry is
/// missing, not mappable or mappable only in the other direction, or the length is wrong.
rc::Gen<Mappable> lines(bool receives) {
    const unsigned odd = receives ? 0U : 1U;
    return rc::gen::elementOf(std::vector<Mappable>{{0x2000 + odd, 1, 8},
                                                    {0x2000 + odd, 8, 8},
                                                    {0x2002 + odd, 1, 1},
                                                    {0x2100 + odd, 4, 16},
                                                    {0x2206, 0, 64},
                                                    {0x2207, 0, 32},
                                                    {0x2207, 0, 32},
                                                    {0, 0, 0},
                                                    {0x2001 - odd, 1, 8},
                                                    {0x2000 + odd, 9, 8},
                                                    {0x2000 + odd, 1, 16},
                                                    {0x2000 + odd, 1, 0},
                                                    {0x2000 + odd, 1, 7},
                                                    {0x2002 + odd, 1, 8},
                                                    {0x2207, 0, 64},
                                                    {0x2207, 1, 32},
                                                    {0x1234, 0, 8},
                                                    {0x1017, 0, 16},
                                                    {5, 0, 8},
                                                    {1, 0, 1},
                                                    {7, 0, 32},
                                                    {5, 0, 16},
                                                    {5, 1, 8},
                                                    {8, 0, 32}});
}

}  // namespace

RC_GTEST_PROP(MappingLaw, PdoMappingWritesInAnyOrderAreAnsweredAsByTheNaiveModel, ()) {
    verifies<req::CO_PDO_007, req::CO_PDO_009, req::CO_PDO_056, req::CO_PDO_010, req::CO_PDO_011, req::CO_PDO_057>(
        "property");
    const bool receives = *rc::gen::arbitrary<bool>();
    LoggedSlave slave;
    Pdo pdo{receives};
    static_cast<void>(pdo.write_cob_id(receives ? 0x405 : 0x385, false));
    rc::state::check(pdo, slave, [receives](const Pdo&) {
        const auto event = rc::gen::build<Event>(
            rc::gen::set(&Event::kind, rc::gen::weightedElement<unsigned>({{3, 0U}, {6, 2U}, {4, 4U}, {2, 6U}})),
            rc::gen::set(&Event::number, rc::gen::inRange(0U, 99U)), rc::gen::set(&Event::line, lines(receives)),
            rc::gen::set(&Event::receives, rc::gen::just(receives)));
        return rc::gen::map(event, [](const Event& one) -> std::shared_ptr<const Happens::CommandType> {
            return std::make_shared<const Happens>(one);
        });
    });
}

}  // namespace canproof::test
