// SPDX-License-Identifier: Apache-2.0
// Properties of PDOs. Compares the data of PDOs with a model that treats them as rows of bits (CiA 301, 7.4.7,
// 7.5.2.36, 7.5.2.38), and the transmission times with those of a model that counts milliseconds.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include "generated/canopen/requirements.hpp"
#include "properties/support/naive_pdo.hpp"
#include "tests/support/sdo_text.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using naive_pdo::is_gap;
using naive_pdo::Mappable;
using naive_pdo::Mapping;
using naive_pdo::total_bits;
using naive_pdo::Values;

/// Returns the objects that an RPDO can map (2000h, 2002h, 2100h and the dummy entries), or that a TPDO can map (2001h,
/// 2003h, 2101h). Both lists contain 2200h, 2206h and 2207h, which RPDO and TPDO can map.
std::vector<Mappable> catalogue(bool receives) {
    const unsigned odd = receives ? 0U : 1U;
    std::vector<Mappable> all;
    for (unsigned sub = 1; sub <= 8; ++sub) {
        all.push_back({0x2000 + odd, sub, 8});
        all.push_back({0x2002 + odd, sub, 1});
    }
    for (unsigned sub = 1; sub <= 4; ++sub) {
        all.push_back({0x2100 + odd, sub, 16});
    }
    all.push_back({0x2200, 0, 16});
    all.push_back({0x2206, 0, 64});
    all.push_back({0x2207, 0, 32});
    if (receives) {
        for (const Mappable& dummy : {Mappable{1, 0, 1}, Mappable{2, 0, 8}, Mappable{3, 0, 16}, Mappable{4, 0, 32},
                                      Mappable{5, 0, 8}, Mappable{6, 0, 16}, Mappable{7, 0, 32}}) {
            all.push_back(dummy);
        }
    }
    return all;
}

/// Generates mappings of zero to eight entries that together have at most 64 bits.
rc::Gen<Mapping> mappings(bool receives) {
    return rc::gen::map(rc::gen::container<Mapping>(rc::gen::elementOf(catalogue(receives))), [](Mapping lines) {
        lines.resize(std::min<std::size_t>(lines.size(), 8));
        while (total_bits(lines) > 64) {
            lines.pop_back();
        }
        return lines;
    });
}

Frames answers_to_mapping(SlaveBench& bench, const std::string& number, bool receives, const Mapping& mapping) {
    const std::string parameters = (receives ? "14" : "18");
    const std::string lines = (receives ? "16" : "1A");
    const std::string id = receives ? "05040080" : "85030080";  // COB-IDs 405h and 385h with bit 31: not valid
    Frames answers = bench.send("605#23" + number + parameters + "01" + id);
    bench.send("605#2F" + number + lines + "0000000000");
    unsigned sub = 0;
    for (const Mappable& line : mapping) {
        const std::string entry = hex_le(line.index << 16U | line.subindex << 8U | line.bits, 4);
        answers.push_back(bench.send("605#23" + number + lines + hex_le(++sub, 1) + entry).at(0));
    }
    answers.push_back(bench.send("605#2F" + number + lines + "00" + hex_le(sub, 1) + "000000").at(0));
    answers.push_back(bench.send("605#23" + number + parameters + "01" + id.substr(0, 6) + "00").at(0));
    return answers;
}

void map_pdo3(SlaveBench& bench, bool receives, const Mapping& mapping) {
    for (const auto& answer : answers_to_mapping(bench, "02", receives, mapping)) {
        RC_ASSERT(answer.substr(0, 6) == "585#60");
    }
}

std::string frame_text(const std::string& id, const Bytes& bytes) {
    return id + "#" + hex_bytes(bytes, 0, bytes.size(), bytes.size());
}

/// Returns whether a value is allowed: 2200h accepts -100 … 100 (tests/support/slave), all other objects accept every
/// value.
bool fits(const Mappable& line, std::uint64_t value) {
    const auto number = static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
    return line.index != 0x2200 || (number >= -100 && number <= 100);
}

std::uint64_t value_in(SlaveBench& bench, unsigned index, unsigned subindex) {
    auto& objects = bench.device->objects();
    const auto entry = objects.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(subindex));
    const ByteView bytes = objects.value(entry.value());
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        value |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
    }
    return value;
}

Values all_values(SlaveBench& bench) {
    Values values;
    for (const Mappable& line : catalogue(true)) {
        if (!is_gap(line)) {
            values[{line.index, line.subindex}] = value_in(bench, line.index, line.subindex);
        }
    }
    return values;
}

/// Sets the mapped object `line` to a random value within its limits, directly in the dictionary. Returns the value.
std::uint64_t put_random(SlaveBench& bench, const Mappable& line) {
    const std::uint64_t mask = line.bits == 64 ? UINT64_MAX : (std::uint64_t{1} << line.bits) - 1;
    std::uint64_t value = *rc::gen::arbitrary<std::uint64_t>() & mask;
    if (line.index == 0x2200) {
        value = static_cast<std::uint16_t>(*rc::gen::inRange(-100, 101));
    }
    Bytes bytes;
    for (unsigned i = 0; i < (line.bits + 7) / 8; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
    auto& objects = bench.device->objects();
    const auto entry = objects.find(static_cast<std::uint16_t>(line.index), static_cast<std::uint8_t>(line.subindex));
    objects.put(entry.value(), ByteView{bytes.data(), bytes.size()});
    return value;
}

}  // namespace

// For any mapping and frames of any length, an RPDO sets all of its mapped objects or none of them, and no other object
// changes.
RC_GTEST_PROP(PdoLaw, RpdoWritesAllOfItsMappedObjectsOrNone, ()) {
    verifies<req::CO_PDO_001, req::CO_PDO_004, req::CO_PDO_037, req::CO_PDO_005, req::CO_PDO_012>("property");
    SlaveBench bench;
    const auto mapping = *mappings(true);
    map_pdo3(bench, true, mapping);
    bench.send("000#0105");
    Values model = all_values(bench);
    const auto frames = *rc::gen::container<std::vector<Bytes>>(rc::gen::arbitrary<Bytes>());
    for (Bytes frame : frames) {
        frame.resize(std::min<std::size_t>(frame.size(), 8));
        model = naive_pdo::received(model, mapping, frame, fits);
        bench.send(frame_text("405", frame));
        RC_ASSERT(all_values(bench) == model);
    }
}

RC_GTEST_PROP(PdoLaw, TpdoCarriesEachBitOfItsMappedValues, ()) {
    verifies<req::CO_PDO_028, req::CO_PDO_053>("property");
    SlaveBench bench;
    const auto mapping = *mappings(false);
    map_pdo3(bench, false, mapping);
    bench.send("605#2300180185010080");  // 1800h:1 COB-ID of TPDO1: not valid
    Values values;
    for (const Mappable& line : mapping) {
        values[{line.index, line.subindex}] = put_random(bench, line);
    }
    const std::string frame = frame_text("385", naive_pdo::packed(mapping, values));
    const Frames sent = mapping.empty() ? Frames{} : Frames{frame};
    RC_ASSERT(bench.send("000#0105") == sent);
}

// A node gets exactly the values that another node sends if both PDOs have the same mapping.
RC_GTEST_PROP(PdoLaw, ValuesSentByOneNodeArriveAtTheOther, ()) {
    verifies<req::CO_PDO_001, req::CO_PDO_028>("property");
    const auto words = *rc::gen::container<std::array<std::int16_t, 4>>(rc::gen::arbitrary<std::int16_t>());
    SlaveBench sender;
    SlaveBench receiver;
    for (unsigned i = 0; i < 4; ++i) {
        sender.send("605#2B0121" + hex_le(i + 1, 1) + hex_le(static_cast<std::uint16_t>(words[i]), 2) + "0000");
    }
    sender.send("000#0105");
    receiver.send("000#0105");
    const Frames sent = sender.send("080#");  // TPDO2, type 1: 2101h:1…4
    RC_ASSERT(sent.size() == 1U);
    receiver.send("305" + sent[0].substr(3));  // RPDO2: 2100h:1…4
    for (unsigned i = 0; i < 4; ++i) {
        RC_ASSERT(value_in(receiver, 0x2100, i + 1) == static_cast<std::uint16_t>(words[i]));
    }
}

// A mapping of more than 64 bits is never accepted, whatever entries it has. When the write of sub-index 0 is refused,
// sub-index 0 stays 0.
RC_GTEST_PROP(PdoLaw, MappingOfMoreThan64BitsIsAlwaysRefused, ()) {
    verifies<req::CO_PDO_011>("property");
    SlaveBench bench;
    Mapping mapping = *rc::gen::container<Mapping>(rc::gen::elementOf(catalogue(true)));
    mapping.resize(std::min<std::size_t>(mapping.size(), 8));
    const Frames answers = answers_to_mapping(bench, "02", true, mapping);
    const std::string counted = answers.at(answers.size() - 2);
    RC_ASSERT(counted == (total_bits(mapping) > 64 ? "585#8002160042000406" : "585#6002160000000000"));
    RC_ASSERT(value_in(bench, 0x1602, 0) == (total_bits(mapping) > 64 ? 0U : mapping.size()));
}

// For any changes at any times, two transmissions are at least the inhibit time apart, and at most the time of the
// event timer (or the inhibit time, if that is longer). A changed value is sent as soon as the inhibit time allows.
RC_GTEST_PROP(PdoLaw, TransmissionsObeyInhibitTimeAndEventTimer, ()) {
    verifies<req::CO_PDO_015, req::CO_PDO_017, req::CO_PDO_047, req::CO_PDO_048, req::CO_PDO_018>("property");
    SlaveBench bench;
    const auto inhibit = static_cast<std::uint64_t>(*rc::gen::inRange(0, 20));  // ms
    const auto event = static_cast<std::uint64_t>(*rc::gen::inRange(0, 30));    // ms
    bench.send("605#2300180185010080");
    bench.send("605#2B001803" + hex_le(inhibit * 10, 2) + "0000");
    bench.send("605#2B001805" + hex_le(event, 2) + "0000");
    bench.send("605#2300180185010000");
    bench.send("605#2301180185020080");  // 1801h:1 COB-ID of TPDO2: not valid
    const auto changes =
        *rc::gen::container<std::vector<bool>>(200, rc::gen::weightedElement<bool>({{4, false}, {1, true}}));
    std::uint8_t value = 0;
    std::uint64_t last = 0;
    bool pending = false;
    RC_ASSERT(bench.send("000#0105") == (Frames{"185#0000"}));
    for (std::uint64_t tick = 1; tick <= changes.size(); ++tick) {
        const auto frame = [&value] { return "185#" + hex_le(value, 1) + "00"; };
        const bool by_timer = event != 0 && tick - last >= event;
        Frames expected;
        if ((pending || by_timer) && tick - last >= inhibit) {
            expected = {"1:" + frame()};
            last = tick;
            pending = false;
        }
        RC_ASSERT(bench.pass(1) == expected);
        if (!changes[tick - 1]) {
            continue;
        }
        ++value;
        const bool at_once = tick - last >= inhibit;
        expected = Frames{};
        if (at_once) {
            expected.push_back(frame());
            last = tick;
        }
        pending = !at_once;
        expected.push_back("585#6001200100000000");
        RC_ASSERT(bench.send("605#2F012001" + hex_le(value, 1) + "000000") == expected);
    }
}

}  // namespace canproof::test
