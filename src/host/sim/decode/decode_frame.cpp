// SPDX-License-Identifier: Apache-2.0
#include "host/sim/decode/decode_frame.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "firmware/canopen/cob_id.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"
#include "host/sim/decode/object_words.hpp"

namespace canproof::host {

namespace {

namespace co = generated::canopen;

constexpr std::uint32_t time_cob_id = 0x100U;  // default of TIME (CiA 301, 7.3.3); 1012h (COB-ID TIME) is not read
constexpr std::uint16_t first_rpdo = co::index::rpdo_communication;
constexpr std::uint16_t first_tpdo = co::index::tpdo_communication;
constexpr std::uint16_t most_pdos = 0x200U;
constexpr std::uint16_t to_mapping = co::index::rpdo_mapping - co::index::rpdo_communication;
constexpr std::uint32_t highest_node_id = 127U;

/// Returns the node-ID that the identifier `id` contains, which is `id` - `base`; 0 when the difference is no node-ID.
std::uint8_t node_above(std::uint32_t base, std::uint32_t id) {
    return id > base && id <= base + highest_node_id ? static_cast<std::uint8_t>(id - base) : std::uint8_t{0};
}

const KnownNode* node_with(std::uint8_t node_id, const std::vector<KnownNode>& nodes) {
    const auto found =
        std::find_if(nodes.begin(), nodes.end(), [&](const KnownNode& one) { return one.node_id == node_id; });
    return found == nodes.end() ? nullptr : &*found;
}

std::string name_of(std::uint8_t node_id, const std::vector<KnownNode>& nodes) {
    const KnownNode* const node = node_with(node_id, nodes);
    return node == nullptr ? fmt::format("node {}", node_id) : node->name;
}

/// Returns the number of the valid PDO with this identifier; 0 when there is none. `first` is the index of the first
/// communication parameter object, 1400h or 1800h.
int pdo_number(const KnownNode& node, std::uint16_t first, std::uint32_t id) {
    for (std::uint16_t i = 0; i < most_pdos && node.objects->has(static_cast<std::uint16_t>(first + i), 1U); ++i) {
        const std::uint32_t entry = node.objects->read(static_cast<std::uint16_t>(first + i), 1U);
        if (cob_id::is_valid(entry) && cob_id::identifier(entry) == id) {
            return i + 1;
        }
    }
    return 0;
}

bool decode_pdo(const Frame& frame, const std::vector<KnownNode>& nodes, FrameWords& words) {
    std::string text;
    for (const auto& [first, kind] : {std::pair{first_tpdo, "TPDO"}, std::pair{first_rpdo, "RPDO"}}) {
        for (const KnownNode& node : nodes) {
            const int number = node.objects == nullptr ? 0 : pdo_number(node, first, frame.id);
            if (number == 0) {
                continue;
            }
            // One frame can be the TPDO of one node and the RPDO of several nodes.
            words.node += (words.node.empty() ? "" : ", ") + node.name;
            const auto mapping = static_cast<std::uint16_t>(first + to_mapping + number - 1);
            const std::string values = frame.remote ? "asked for" : mapped_words(node, mapping, frame.payload());
            text += fmt::format("{}{} {}: {}", text.empty() ? "" : "; ", kind, number, values);
        }
    }
    if (text.empty()) {
        return false;
    }
    words.service = FrameService::pdo;
    words.text = text;
    return true;
}

bool is_emcy_of(const KnownNode& node, std::uint32_t id) {
    return node.objects != nullptr && node.objects->has(co::index::emcy_cob_id, 0U) &&
           cob_id::identifier(node.objects->read(co::index::emcy_cob_id, 0U)) == id;
}

bool is_sync(std::uint32_t id, const std::vector<KnownNode>& nodes) {
    return id == co::emcy_cob_id_base || std::any_of(nodes.begin(), nodes.end(), [&](const KnownNode& one) {
               return one.objects != nullptr && one.objects->has(co::index::sync_cob_id, 0U) &&
                      cob_id::identifier(one.objects->read(co::index::sync_cob_id, 0U)) == id;
           });
}

std::string bytes_of(ByteView data) {
    return value_words(nullptr, data);
}

/// Returns the name of the class of an emergency code (CiA 301, 7.2.7.1, Table 26). If several classes contain the
/// code, the class with the fewest codes counts.
std::string emcy_class(std::uint32_t code) {
    struct Class {
        std::uint32_t mask;
        std::uint32_t code;
        const char* words;
    };
    constexpr Class classes[]{
        {0xFFFFU, 0x0000U, "no error"},
        {0xFFFFU, 0x8110U, "CAN overrun"},
        {0xFFFFU, 0x8120U, "CAN error passive"},
        {0xFFFFU, 0x8130U, "life guard or heartbeat error"},
        {0xFFFFU, 0x8140U, "recovered from bus-off"},
        {0xFFFFU, 0x8150U, "CAN-ID collision"},
        {0xFFFFU, 0x8210U, "PDO too short"},
        {0xFFFFU, 0x8220U, "PDO too long"},
        {0xFFFFU, 0x8240U, "unexpected SYNC length"},
        {0xFFFFU, 0x8250U, "RPDO timeout"},
        {0xFF00U, 0x1000U, "generic error"},
        {0xFF00U, 0x2000U, "current"},
        {0xFF00U, 0x2100U, "current, input side"},
        {0xFF00U, 0x2200U, "current inside the device"},
        {0xFF00U, 0x2300U, "current, output side"},
        {0xFF00U, 0x3000U, "voltage"},
        {0xFF00U, 0x3100U, "mains voltage"},
        {0xFF00U, 0x3200U, "voltage inside the device"},
        {0xFF00U, 0x3300U, "output voltage"},
        {0xFF00U, 0x4000U, "temperature"},
        {0xFF00U, 0x4100U, "ambient temperature"},
        {0xFF00U, 0x4200U, "device temperature"},
        {0xFF00U, 0x5000U, "device hardware"},
        {0xFF00U, 0x6000U, "device software"},
        {0xFF00U, 0x6100U, "internal software"},
        {0xFF00U, 0x6200U, "user software"},
        {0xFF00U, 0x6300U, "data set"},
        {0xFF00U, 0x7000U, "additional modules"},
        {0xFF00U, 0x8100U, "communication"},
        {0xFF00U, 0x8200U, "protocol error"},
        {0xF000U, 0x8000U, "monitoring"},
        {0xF000U, 0x9000U, "external error"},
        {0xFF00U, 0xF000U, "additional functions"},
        {0xFF00U, 0xFF00U, "device specific"},
    };
    for (const Class& one : classes) {
        if ((code & one.mask) == one.code) {
            return one.words;
        }
    }
    return "reserved code";
}

std::string spoken(std::string snake) {
    std::replace(snake.begin(), snake.end(), '_', ' ');
    return snake;
}

}  // namespace

const char* service_word(FrameService service) {
    switch (service) {
        case FrameService::nmt:
            return "NMT";
        case FrameService::sync:
            return "SYNC";
        case FrameService::time:
            return "TIME";
        case FrameService::emcy:
            return "EMCY";
        case FrameService::pdo:
            return "PDO";
        case FrameService::sdo:
            return "SDO";
        case FrameService::error_control:
            return "guard";
        case FrameService::lss:
            return "LSS";
        case FrameService::other:
        default:
            return "other";
    }
}

std::string mapped_words(const KnownNode& node, std::uint16_t index, ByteView data) {
    std::string text;
    const std::uint32_t count = node.objects->read(index, 0U);
    std::size_t bit = 0;
    for (std::uint32_t line = 1; line <= count && bit < 8U * data.size(); ++line) {
        const std::uint32_t entry = node.objects->read(index, static_cast<std::uint8_t>(line));
        const std::size_t bits = entry & 0xFFU;
        const auto object = static_cast<std::uint16_t>(entry >> 16U);
        const auto subindex = static_cast<std::uint8_t>((entry >> 8U) & 0xFFU);
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bits && i < 64U; ++i) {
            const std::size_t at = bit + i;
            value |= std::uint64_t{(data[at / 8U] >> (at % 8U)) & 1U} << i;
        }
        std::array<std::uint8_t, 8> bytes{};
        write_le(MutableBytes{bytes}, 0U, 8U, value);
        const Entry* const known = entry_at(node.part, object, subindex);
        const std::size_t size = std::min<std::size_t>((bits + 7U) / 8U, 8U);
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ",
                            known == nullptr ? entry_words(node.part, object, subindex) : known->name,
                            value_words(known, ByteView{bytes}.part(0U, size)));
        bit += bits;
    }
    return text.empty() ? bytes_of(data) : text;
}

/// Returns the word for a value of an enumeration in `part` or in the rules that all devices share; empty when there is
/// none.
std::string FrameDecoder::word(const Part* part, const char* enumeration, std::uint64_t value) const {
    for (const Part* one : {part, register_.part("canopen")}) {
        if (one == nullptr) {
            continue;
        }
        for (const Enumeration& candidate : one->enumerations) {
            if (candidate.name != enumeration) {
                continue;
            }
            for (const auto& [name, number] : candidate.values) {
                if (static_cast<std::uint64_t>(number) == value) {
                    return spoken(name);
                }
            }
        }
    }
    return "";
}

std::string FrameDecoder::nmt(ByteView data, const std::vector<KnownNode>& nodes) const {
    if (data.size() != 2U) {
        return "no command: two bytes are needed";
    }
    const std::string command = word(nullptr, "NmtCommand", data[0]);
    return fmt::format("{}: {}", data[1] == 0U ? "all nodes" : name_of(data[1], nodes),
                       command.empty() ? fmt::format("unknown command {}", data[0]) : command);
}

std::string FrameDecoder::emcy(ByteView data, const KnownNode* node) const {
    const auto code = static_cast<std::uint32_t>(read_le(data, 0U, 2U));
    const std::string own = word(node == nullptr ? nullptr : node->part, "EmergencyCode", code);
    const std::string named = fmt::format("{:04X}h {}", code, own.empty() ? emcy_class(code) : own);
    const std::string state = fmt::format(", error register {:02X}h", data[2]);
    const std::string description = word(node == nullptr ? nullptr : node->part, "ErrorDescription", data[4]);
    if (!description.empty()) {
        // If the requirements register describes the errors of a device, byte 3 contains the channel and byte 4 the
        // description.
        return named + (code == 0U ? "" : fmt::format(", channel {}, {}", data[3], description)) + state;
    }
    const ByteView details = data.part(3U, 5U);
    const bool has_details =
        std::any_of(details.data(), details.data() + details.size(), [](auto b) { return b != 0U; });
    return named + state + (has_details ? ", details " + bytes_of(details) : "");
}

std::string FrameDecoder::error_control(const Frame& frame) const {
    if (frame.remote) {
        return "guarding request";
    }
    if (frame.length != 1U) {
        return "malformed: one byte is needed";
    }
    constexpr std::uint8_t toggle = 0x80U;
    const std::uint8_t state = frame.data[0] & static_cast<std::uint8_t>(~toggle);
    if (frame.data[0] == 0U) {
        return "boot-up";
    }
    const std::string known = word(nullptr, "NmtState", state);
    return fmt::format("{}{}", known.empty() ? fmt::format("unknown state {}", state) : known,
                       (frame.data[0] & toggle) != 0U ? ", toggle 1" : "");
}

std::string FrameDecoder::lss(ByteView data, bool request) const {
    std::string name = word(nullptr, "LssCommand", data[0]);
    if (!request) {
        const std::string answer = word(nullptr, "LssAnswer", data[0]);
        name = answer.empty() ? name : answer;
    }
    const ByteView rest = data.part(1U, 7U);
    const bool says_more = std::any_of(rest.data(), rest.data() + rest.size(), [](auto b) { return b != 0U; });
    return (name.empty() ? fmt::format("unknown command {}", data[0]) : name) + (request ? "" : " (answer)") +
           (says_more ? ": " + bytes_of(rest) : "");
}

FrameWords FrameDecoder::decode(const Frame& frame, const std::vector<KnownNode>& nodes) const {
    FrameWords words;
    const ByteView data = frame.payload();
    const auto as = [&](FrameService service, std::uint8_t node_id, std::string text) {
        words.service = service;
        words.node = node_id == 0U ? "" : name_of(node_id, nodes);
        words.text = std::move(text);
    };
    if (frame.extended) {
        as(FrameService::other, 0U, "29-bit identifier; " + bytes_of(data));
    } else if (frame.id == co::nmt_command_cob_id) {
        as(FrameService::nmt, 0U, nmt(data, nodes));
    } else if (is_sync(frame.id, nodes)) {
        as(FrameService::sync, 0U, data.empty() ? "SYNC" : fmt::format("SYNC, counter {}", data[0]));
    } else if (const auto emcy_node =
                   std::find_if(nodes.begin(), nodes.end(), [&](const auto& one) { return is_emcy_of(one, frame.id); });
               emcy_node != nodes.end()) {
        as(FrameService::emcy, emcy_node->node_id, emcy(data, &*emcy_node));
    } else if (const std::uint8_t server = node_above(co::sdo_response_cob_id_base, frame.id); server != 0U) {
        const KnownNode* const node = node_with(server, nodes);
        as(FrameService::sdo, server, sdo_answer(data, node == nullptr ? nullptr : node->part));
    } else if (const std::uint8_t asked = node_above(co::sdo_request_cob_id_base, frame.id); asked != 0U) {
        const KnownNode* const node = node_with(asked, nodes);
        as(FrameService::sdo, asked, sdo_request(data, node == nullptr ? nullptr : node->part));
    } else if (const std::uint8_t guarded = node_above(co::guarding_cob_id_base, frame.id); guarded != 0U) {
        as(FrameService::error_control, guarded, error_control(frame));
    } else if (frame.id == co::lss_request_cob_id || frame.id == co::lss_response_cob_id) {
        as(FrameService::lss, 0U, lss(data, frame.id == co::lss_request_cob_id));
    } else if (decode_pdo(frame, nodes, words)) {
        return words;
    } else if (const std::uint8_t emitter = node_above(co::emcy_cob_id_base, frame.id); emitter != 0U) {
        as(FrameService::emcy, emitter, emcy(data, node_with(emitter, nodes)));
    } else if (frame.id == time_cob_id) {
        as(FrameService::time, 0U, "time of day: " + bytes_of(data));
    } else {
        as(FrameService::other, 0U, bytes_of(data));
    }
    return words;
}

}  // namespace canproof::host
