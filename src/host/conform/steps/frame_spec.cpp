// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/frame_spec.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canproof::host::conform {

namespace {

constexpr std::int64_t highest_id = 0x7FF;
constexpr std::int64_t highest_extended_id = 0x1FFFFFFF;

}  // namespace

FrameKey FrameSpec::key(const Scope& scope) const {
    const std::int64_t number = number_of(id(scope));
    const std::int64_t highest = extended ? highest_extended_id : highest_id;
    if (number < 0 || number > highest) {
        throw BrokenCase{fmt::format("{:X}h is no identifier; write 0 to {:X}h", number, highest)};
    }
    return {static_cast<std::uint32_t>(number), extended, remote};
}

Frame FrameSpec::frame(const Scope& scope) const {
    const FrameKey wanted = key(scope);
    Frame frame{};
    frame.id = wanted.id;
    frame.extended = extended;
    frame.remote = remote;
    if (remote) {
        const std::int64_t length = remote_length ? number_of(remote_length(scope)) : 0;
        frame.length = static_cast<std::uint8_t>(std::clamp<std::int64_t>(length, 0, max_frame_length));
        return frame;
    }
    if (any_data) {
        throw BrokenCase{"the frame has no data; write a colon and the bytes after the identifier"};
    }
    const Bytes bytes = data.to_send(scope);
    frame.length = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

FrameSpec parse_frame_id(Scanner& line) {
    FrameSpec spec;
    for (bool more = true; more;) {
        const bool remote = line.take_word("rtr");
        const bool extended = line.take_word("ext");
        spec.remote = spec.remote || remote;
        spec.extended = spec.extended || extended;
        more = remote || extended;
    }
    spec.id = parse_expression(line, Radix::hexadecimal);
    return spec;
}

FrameSpec parse_frame_spec(Scanner& line) {
    FrameSpec spec = parse_frame_id(line);
    if (line.take(":")) {
        spec.any_data = false;
        spec.data = DataPattern::parse(line);
    } else if (spec.remote && line.take_word("dlc")) {
        spec.remote_length = parse_operand(line, Radix::decimal);
    }
    return spec;
}

std::string words_of(const FrameKey& key) {
    return key.extended ? fmt::format("{:08X}h (29 bits)", key.id)
                        : fmt::format("{:03X}h{}", key.id, key.remote ? " remote" : "");
}

void keep(Context& context, const FrameRecord& record, const Captures& captures, const std::string& name) {
    for (const auto& [variable, value] : captures) {
        context.scope->set(variable, value);
    }
    if (!name.empty()) {
        Value whole{data_of(record.frame)};
        whole.fields = [record](const std::string& field) -> std::optional<Value> {
            return field == "time"   ? std::optional{Value{static_cast<std::int64_t>(record.time.us)}}
                   : field == "size" ? std::optional{Value{std::int64_t{record.frame.length}}}
                                     : std::nullopt;
        };
        context.scope->set(name, whole);
    }
    const Instant sent = context.link.last_sent();
    context.root.set("elapsed", Value{static_cast<std::int64_t>(elapsed(sent, record.time).us)});
}

}  // namespace canproof::host::conform
