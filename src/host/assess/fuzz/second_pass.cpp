// SPDX-License-Identifier: Apache-2.0
// Runs the corpus again under valgrind's memcheck, with programs that have no sanitizers. Memcheck detects the use of
// uninitialised bytes, which ASan and UBSan do not detect. (MSan needs an instrumented C++ library, which Debian does
// not have.)
#include "host/assess/fuzz/second_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/assess/fuzz/campaign_files.hpp"
#include "host/assess/fuzz/finding_store.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t chunk_size = 10;
constexpr double chunk_limit = 600.0;  ///< time limit of a valgrind process in seconds
/// greatest number of findings that are stored for a chunk; each needs a separate run
constexpr std::size_t most_findings = 5;
constexpr int valgrind_found = 99;
constexpr double share_of_fuzzing = 0.25;

using Inputs = std::vector<std::filesystem::path>;

/// The inputs of one target that one valgrind process runs.
struct Chunk {
    const FuzzTarget* target{nullptr};
    Inputs inputs;
    int status{0};
    bool done{false};
    bool first{false};  ///< whether it is the first chunk of its target
};

Task under_valgrind(const CampaignContext& context, Chunk& chunk, const std::filesystem::path& log) {
    const auto program = std::filesystem::path{context.options.replay_build} / (chunk.target->name + "_fuzz");
    Task task;
    task.command = {"valgrind", "-q", fmt::format("--error-exitcode={}", valgrind_found), "--track-origins=yes",
                    std::filesystem::absolute(program).string()};
    for (const auto& input : chunk.inputs) {
        task.command.push_back(input.string());
    }
    task.log = log;
    task.limit_seconds = chunk_limit;
    task.ended = [&chunk](const TaskEnd& end) {
        chunk.done = !end.interrupted && !end.timed_out;
        chunk.status = end.status;
    };
    return task;
}

/// Divides the corpora into chunks. The first chunks of all targets come before any second chunk, because the time can
/// end before all chunks have run.
std::vector<Chunk> chunks_of(const CampaignContext& context) {
    std::vector<Chunk> chunks;
    bool more = true;
    for (std::size_t from = 0; more; from += chunk_size) {
        more = false;
        for (const FuzzTarget& target : context.targets) {
            const Inputs all = files_in(context.files.inputs(target.name));
            if (from < all.size()) {
                const auto begin = all.begin() + static_cast<std::ptrdiff_t>(from);
                const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), from + chunk_size));
                chunks.push_back({&target, Inputs(begin, end), 0, false, from == 0});
                more = true;
            }
        }
    }
    return chunks;
}

/// Runs each input of this chunk alone, because valgrind found errors in the chunk and the inputs that cause them are
/// not known. Stops when `most_findings` inputs have caused an error. Returns false when interrupted.
bool name_inputs(const CampaignContext& context, const Chunk& chunk) {
    std::size_t found = 0;
    for (const auto& input : chunk.inputs) {
        const auto log = context.files.log("valgrind-" + chunk.target->name + "-" + input.filename().string());
        Chunk one{chunk.target, {input}, 0, false, false};
        if (!run_tasks({under_valgrind(context, one, log)}, 1, context.interrupted, [] {})) {
            return false;
        }
        if (one.status != 0) {
            store_finding(context, {chunk.target, input, log, parse_failure(read_text(log)), true, "valgrind", 1});
            ++found;
        }
        if (found >= most_findings) {
            break;
        }
    }
    return true;
}

/// Runs the chunks with the numbers from `from` to `to` - 1 until `ends` returns true.
void look_at(const CampaignContext& context, std::vector<Chunk>& chunks, std::size_t from, std::size_t to,
             const std::function<bool()>& ends) {
    std::vector<Task> tasks;
    for (std::size_t i = from; i < to; ++i) {
        const auto log = context.files.log(fmt::format("valgrind-{}-{}", chunks[i].target->name, i));
        tasks.push_back(under_valgrind(context, chunks[i], log));
    }
    run_tasks(std::move(tasks), context.options.jobs, ends, [&] { context.display.draw(context.state); });
}

}  // namespace

bool look_again_with_valgrind(const CampaignContext& context) {
    using Clock = std::chrono::steady_clock;
    const auto limit = std::chrono::duration<double>(context.state.minutes * 60.0 * share_of_fuzzing);
    for (TargetRecord& record : context.state.targets) {
        record.inputs_second_pass = 0;
    }
    std::vector<Chunk> chunks = chunks_of(context);
    // The first chunk of every target always runs; the other chunks run until the time of this pass is over.
    const auto sure = static_cast<std::size_t>(
        std::count_if(chunks.begin(), chunks.end(), [](const Chunk& chunk) { return chunk.first; }));
    const auto start = Clock::now();
    look_at(context, chunks, 0, sure, context.interrupted);
    look_at(context, chunks, sure, chunks.size(),
            [&] { return context.interrupted() || Clock::now() - start > limit; });
    for (const Chunk& chunk : chunks) {
        context.record(chunk.target->name).inputs_second_pass += chunk.done ? chunk.inputs.size() : 0;
        if (context.interrupted() || (chunk.done && chunk.status != 0 && !name_inputs(context, chunk))) {
            return false;
        }
    }
    context.save();
    return true;
}

}  // namespace canproof::host
