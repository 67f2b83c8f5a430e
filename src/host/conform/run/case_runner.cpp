// SPDX-License-Identifier: Apache-2.0
#include "host/conform/run/case_runner.hpp"

#include <fmt/format.h>

#include "host/base/cia301.hpp"
#include "host/base/input_error.hpp"
#include "host/conform/language/data_pattern.hpp"
#include "host/sim/devices/advance_device.hpp"

namespace canproof::host::conform {

namespace {

constexpr Duration settling = milliseconds(50);
// after the last step of a case, the tester waits this time for unexpected frames of the slave
constexpr Duration afterthought = milliseconds(20);
// if the tester itself was late by more than this, the message of a failed case states the delay
constexpr Duration tolerated_delay = milliseconds(20);
constexpr Duration power_off_time = milliseconds(200);
// longest wait for the boot-up message of a slave that sent none after an earlier reset
constexpr Duration silent_boot_limit = milliseconds(500);
constexpr std::uint8_t highest_node = 127;
const char* const return_outside = "a `return` stands outside of a procedure; remove it";

std::set<std::uint32_t> listened_to(const ConformSheet& sheet) {
    std::set<std::uint32_t> ids;
    for (const Object& object : sheet.part.objects) {
        for (const Entry& entry : object.entries) {
            const auto* number = std::get_if<std::int64_t>(&entry.value);
            if (object.index >= cia301::first_object && object.index < cia301::rpdo_mapping && number != nullptr) {
                ids.insert(static_cast<std::uint32_t>(*number + (entry.node_id ? sheet.node_id : 0)) & 0x7FFU);
            }
        }
    }
    return ids;
}

}  // namespace

CaseRunner::CaseRunner(const CaseBook& book, const ConformSheet& sheet, Target& target, const ConformOptions& options)
    : book_{book},
      sheet_{sheet},
      target_{target},
      options_{options},
      link_{target},
      sdo_{link_, journal_, sheet.node_id, options.sdo_timeout} {
    link_.on_send([this](const Frame& frame) { note_sent(frame); });
    link_.reserve(listened_to(sheet));
}

/// Records the object that an SDO download of the tester may change. Sets sent_other_ for each other frame of the
/// tester except SDO and NMT frames.
void CaseRunner::note_sent(const Frame& frame) {
    const std::uint32_t function = frame.id & 0x780U;
    const unsigned command = frame.data[0] >> 5U;
    if (frame.id == 0x600U + sheet_.node_id && !frame.extended && !frame.remote) {
        if (command == 1U || (command == 6U && (frame.data[0] & 1U) == 0U)) {
            const Bytes bytes = data_of(frame);
            const auto index = static_cast<std::uint16_t>(from_little_endian(bytes, 1, 2));
            written_.insert({index, frame.data[3]});
            store_changed_ = store_changed_ ||
                             (may_store_ && (index == cia301::store_parameters || index == cia301::restore_parameters));
        }
    } else if (frame.id != 0U && function != 0x600U) {
        sent_other_ = true;
    }
    fresh_ = Fresh::no;
}

bool CaseRunner::reset(NmtCommand command) {
    link_.begin_case();
    send_nmt(link_, command, sheet_.node_id);
    bool booted = take_boot_up(link_, sheet_.node_id, boots_silently_ ? silent_boot_limit : boot_limit).has_value();
    if (!booted && answers()) {
        boots_silently_ = true;
        booted = true;
    }
    if (!booted && target_.power_switch() != PowerSwitch::nobody) {
        target_.power(false);
        link_.wait(power_off_time);
        link_.forget();
        target_.power(true);
        if (!take_boot_up(link_, sheet_.node_id)) {
            return false;
        }
        alive_ = true;
        booted = true;
    }
    if (booted) {
        send_nmt(link_, NmtCommand::pre_operational, sheet_.node_id);
        link_.wait(settling);
        link_.forget();
        fresh_ = command == NmtCommand::reset_node ? Fresh::node : Fresh::communication;
    }
    return booted;
}

/// Returns whether the SDO server answers at all. A wrong answer counts as an answer.
bool CaseRunner::answers() {
    constexpr ObjectPlace device_type{cia301::device_type, 0};
    link_.forget();
    sdo_.allow_unasked(true);
    try {
        sdo_.read(device_type);
    } catch (const NoAnswer&) {
        return false;
    } catch (const SlaveFailed&) {
        return true;
    }
    return true;
}

void CaseRunner::prepare(Preparation how) {
    const bool node = how == Preparation::reset_node;
    const bool fresh = fresh_ == Fresh::node || (fresh_ == Fresh::communication && !node);
    if (how != Preparation::none && !fresh) {
        if (!reset(node ? NmtCommand::reset_node : NmtCommand::reset_communication)) {
            alive_ = false;
            throw NoAnswer{fmt::format("no boot-up message came within {} s after a reset", boot_limit.us / 1000000U)};
        }
    }
    link_.begin_case();
    written_.clear();
    sent_other_ = false;
    journal_ = {};
    if (boots_silently_) {
        journal_.notes.emplace_back("the slave sends no boot-up message after a reset, or not after every reset");
    }
    if (options_.traffic > 0.0) {
        link_.set_traffic(options_.traffic, false);
    }
}

void CaseRunner::begin(ConformReport& report) {
    if (!reset(NmtCommand::reset_node)) {
        throw InputError{fmt::format(
            "node {} on {} does not answer (no boot-up message); check the node-ID, the bit rate and the cable",
            sheet_.node_id, target_.name())};
    }
    sdo_.allow_unasked(true);
    if (boots_silently_) {
        report.troubles.emplace_back("the slave sent no boot-up message after reset node");
    }
    for (const auto& [subindex, name] :
         std::map<std::uint8_t, const char*>{{1, "vendor"}, {2, "product"}, {3, "revision"}, {4, "serial"}}) {
        identity_[name] = from_little_endian(read_at_start({cia301::identity, subindex}, report), 0, 4);
        report.identity[name] = fmt::format("{:08X}h", identity_[name]);
    }
    for (const auto& [index, name] :
         std::map<std::uint16_t, const char*>{{cia301::device_name, "name"},
                                              {cia301::hardware_version, "hardware version"},
                                              {cia301::software_version, "software version"}}) {
        const Bytes text = read_at_start({index, 0}, report);
        if (!text.empty()) {
            report.identity[name] = std::string(text.begin(), text.end());
        }
    }
    for (const std::string& trouble : snapshot_.take(sdo_, sheet_)) {
        report.troubles.push_back(trouble);
    }
    fresh_ = Fresh::no;
}

/// Reads an entry at the start of a run and returns its value. Returns no bytes after an abort or a wrong answer. Adds
/// a wrong answer to `report.troubles`.
Bytes CaseRunner::read_at_start(const ObjectPlace& place, ConformReport& report) {
    try {
        return sdo_.read(place).data;
    } catch (const SlaveFailed& failed) {
        report.troubles.push_back(
            fmt::format("{:04X}h:{:02X} cannot be read: {}", place.index, place.subindex, failed.what()));
        return {};
    }
}

void CaseRunner::set_variables(Scope& scope) const {
    scope.set("N", Value{std::int64_t{sheet_.node_id}});
    scope.set("other", Value{std::int64_t{sheet_.node_id % highest_node + 1}});
    for (const auto& [name, number] : identity_) {
        scope.set(name, Value{number});
    }
}

std::string CaseRunner::not_allowed(const Case& one) const {
    if (one.risk == Risk::output && !options_.allow_outputs) {
        return "the case may move an output; allow this with --allow-outputs";
    }
    if (one.risk == Risk::store && !options_.allow_store) {
        return "the case stores parameters; allow this with --allow-store";
    }
    if (one.risk == Risk::lss && !options_.allow_lss) {
        return "the case changes node-ID or bit rate by LSS; allow this with --allow-lss";
    }
    return {};
}

CaseResult CaseRunner::run(const Case& one) {
    CaseResult result = result_of(one);
    result.verdict = Verdict::skipped;
    result.why = not_allowed(one);
    if (!result.why.empty()) {
        return result;
    }
    const Instant start = link_.now();
    run_once(one, result);
    const CaseResult first = result;
    while (result.verdict == Verdict::failed && !target_.is_repeatable() && result.runs < most_runs) {
        run_once(one, result);
    }
    if (first.verdict == Verdict::failed && result.verdict == Verdict::passed) {
        const unsigned runs = result.runs;
        result = first;
        result.runs = runs;
        result.verdict = Verdict::unstable;
        result.why += fmt::format("; passed at run {}", runs);
    }
    result.time = elapsed(start, link_.now());
    return result;
}

void CaseRunner::run_once(const Case& one, CaseResult& result) {
    ++result.runs;
    may_store_ = one.risk == Risk::store;
    result.verdict = Verdict::passed;
    result.why.clear();
    result.step.clear();
    judge(one, result);
    if (result.verdict == Verdict::failed && link_.worst_delay().us > tolerated_delay.us) {
        result.why += fmt::format("; the tester itself was up to {} ms late", link_.worst_delay().us / 1000U);
    }
    result.times = journal_.times;
    result.notes = journal_.notes;
    if (result.verdict != Verdict::passed && result.verdict != Verdict::skipped) {
        result.frames = link_.log();
    }
    const auto tell = [&](const std::string& why) {
        result.left.push_back(why);
        if (result.verdict == Verdict::passed || result.verdict == Verdict::failed) {
            result.why += (result.why.empty() ? "" : "; ") + std::string{"afterwards: "} + why;
            result.verdict = alive_ ? Verdict::failed : Verdict::no_answer;
        }
    };
    try {
        try {
            clean_up(one, result);
        } catch (const SlaveFailed& failed) {
            alive_ = reset(NmtCommand::reset_node);
            tell(failed.what());
        }
    } catch (const StuckDevice& stuck) {
        alive_ = false;
        tell(stuck.what());
    }
    if (!result.left.empty() && result.verdict == Verdict::passed) {
        result.verdict = Verdict::failed;
        result.why = "the slave could not be restored after the case: " + result.left.front();
    }
}

void CaseRunner::judge(const Case& one, CaseResult& result) {
    Context context{link_, sdo_, sheet_, book_.procedures, journal_};
    set_variables(context.root);
    context.block_upload = block_upload_;
    context.block_download = block_download_;
    const auto end = [&](Verdict verdict, const std::string& why) {
        result.verdict = verdict;
        result.why = why;
        for (const std::string& turn : context.turns) {
            result.why += fmt::format(" ({})", turn);
        }
        if (context.at != nullptr && verdict != Verdict::skipped) {
            result.step = fmt::format("{}:{}: {}", one.place.file, context.at->line, context.at->text);
        }
    };
    try {
        prepare(one.preparation);
        sdo_.allow_unasked(one.allows_sdo);
        for (const Need& need : one.needs) {
            const std::string unmet = need.unmet(context);
            if (!unmet.empty()) {
                throw CaseSkipped{unmet};
            }
        }
        block_upload_ = context.block_upload;
        block_download_ = context.block_download;
        journal_.judged = 0;
        run_steps(one.steps, context);
        context.at = nullptr;
        check_unasked(one);
        if (journal_.judged == 0) {
            throw BrokenCase{"the case ran no step that checks the slave; add a step such as `expect` or `answer`"};
        }
    } catch (const CaseSkipped& skipped) {
        end(Verdict::skipped, skipped.what());
    } catch (const NextTurn& turn) {
        end(Verdict::skipped, turn.reason);
    } catch (const NoAnswer& failed) {
        end(alive_ ? Verdict::failed : Verdict::no_answer, failed.what());
    } catch (const SlaveFailed& failed) {
        end(Verdict::failed, failed.what());
    } catch (const StuckDevice& stuck) {
        end(Verdict::failed, stuck.what());
    } catch (const BrokenCase& broken) {
        end(Verdict::broken, broken.what());
    } catch (const Returned&) {
        end(Verdict::broken, return_outside);
    }
}

/// Fails the case if the slave has sent an emergency message, a boot-up message or an SDO frame that no step received
/// and that the case does not allow.
void CaseRunner::check_unasked(const Case& one) {
    link_.wait(afterthought);
    const std::uint32_t node = sheet_.node_id;
    const FrameRecord* const found = link_.peek([&](const FrameRecord& record) {
        const Frame& frame = record.frame;
        const bool emcy = frame.id == 0x80U + node && (frame.data[0] != 0 || frame.data[1] != 0);
        const bool boot_up = frame.id == 0x700U + node && frame.length == 1 && frame.data[0] == 0;
        const bool sdo = frame.id == 0x580U + node;
        return !frame.extended && !frame.remote && !record.own &&
               ((emcy && !one.allows_emcy) || (boot_up && !one.allows_boot_up) || (sdo && !one.allows_sdo));
    });
    if (found != nullptr) {
        const char* const what = found->frame.id == 0x80U + node    ? "EMCY"
                                 : found->frame.id == 0x580U + node ? "SDO frame"
                                                                    : "boot-up message";
        throw SlaveFailed{fmt::format("the slave sent an unsolicited {}: {}", what, hex_words(data_of(found->frame)))};
    }
}

void CaseRunner::save_parameters() {
    const std::string signature = "save";
    sdo_.write({cia301::store_parameters, 1}, Bytes(signature.begin(), signature.end()), Transfer::automatic);
    store_changed_ = false;
    fresh_ = Fresh::no;
}

void CaseRunner::clean_up(const Case& one, CaseResult& result) {
    link_.stop_producing();
    link_.set_traffic(0.0, false);
    link_.end_watches();  // a running watch would receive frames that the restore steps wait for
    sdo_.allow_unasked(true);
    if (result.verdict != Verdict::skipped && !one.restore.empty()) {
        Context context{link_, sdo_, sheet_, book_.procedures, journal_};
        set_variables(context.root);
        const auto tell = [&](const std::string& why) {
            result.left.push_back(fmt::format("the restore step `{}` failed: {}", context.at->text, why));
        };
        try {
            run_steps(one.restore, context);
        } catch (const std::runtime_error& failed) {
            tell(failed.what());
        } catch (const NextTurn& turn) {
            tell(turn.reason);
        } catch (const Returned&) {
            tell(return_outside);
        }
    }
    const std::set<ObjectPlace> written = written_;
    const bool application =
        sent_other_ || (!written.empty() && written.rbegin()->index >= cia301::first_manufacturer_object);
    if (written.empty() && !application) {
        return;
    }
    if (!reset(application ? NmtCommand::reset_node : NmtCommand::reset_communication)) {
        alive_ = false;
        throw NoAnswer{"no boot-up message came after the reset that follows the case"};
    }
    const Fresh fresh = fresh_;
    const std::vector<std::string> left = snapshot_.put_back(sdo_, written);
    result.left.insert(result.left.end(), left.begin(), left.end());
    fresh_ = snapshot_.has_written() ? Fresh::no : fresh;
    if (store_changed_) {
        const auto all = snapshot_.put_back(sdo_, snapshot_.places());
        result.left.insert(result.left.end(), all.begin(), all.end());
        save_parameters();
    }
}

std::vector<std::string> CaseRunner::put_everything_back() {
    target_.go_on();
    sdo_.allow_unasked(true);
    try {
        if (!reset(NmtCommand::reset_node)) {
            return {"the slave does not answer; its parameters could not be put back"};
        }
        const std::vector<std::string> left = snapshot_.put_back(sdo_, snapshot_.places());
        if (store_changed_) {
            save_parameters();
        }
        return left;
    } catch (const SlaveFailed& failed) {
        return {fmt::format("the parameters of the slave could not be put back: {}", failed.what())};
    } catch (const Interrupted&) {
        return {"interrupted again before the parameters of the slave were put back"};
    }
}

}  // namespace canproof::host::conform
