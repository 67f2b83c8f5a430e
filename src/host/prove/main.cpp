// canproof-prove, the program that `canproof prove` starts. It is separate, so that `canproof` itself does not load a
// compiler library and a solver.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/prove/faults.hpp"
#include "host/prove/prove_all.hpp"
#include "host/prove/prove_shards.hpp"
#include "host/prove/results.hpp"
#include "host/prove/scratch_folder.hpp"

namespace canproof::host::prove {

namespace {

constexpr int wrong_use = 2;

struct Arguments {
    std::filesystem::path root{"."};
    std::filesystem::path build{};
    std::string json{};
    std::string shard{};
    std::string merge{};
    std::string faults{};
    unsigned every{1};
};

void add_options(CLI::App& app, Arguments& arguments, ProveOptions& options) {
    app.add_option("--only", options.area, "proofs of this folder below properties/proofs: base");
    app.add_option("--proofs", options.proofs, "folder of harnesses")->capture_default_str();
    app.add_option("--theorem", options.theorem, "this one alone");
    app.add_option("--timeout", options.seconds, "seconds of processor time for one theorem; unknown after that")
        ->check(CLI::Range(1, 86400))
        ->capture_default_str();
    app.add_option("--jobs", options.jobs, "processes at once")->check(CLI::Range(1, 64))->capture_default_str();
    app.add_option("--json", arguments.json, "file to write the results to");
    app.add_option("--shard", arguments.shard, "I/N: only the Ith of N parts of the theorems; --json for --merge");
    app.add_option("--merge", arguments.merge, "folder of the JSON files of all shards, in place of proving")
        ->excludes("--shard");
    app.add_option("--faults", arguments.faults, "table of seeded faults: each must be refuted");
    app.add_option("--every", arguments.every, "with --faults: only every Nth of the table")
        ->check(CLI::Range(1, 1000));
    app.add_flag("!--no-replay", options.replays, "do not run counterexamples natively");
    app.add_option("--root", arguments.root, "the project's folder")->capture_default_str();
    app.add_option("--build", arguments.build, "a build of the project; where this program lies without it");
}

int prove(const Arguments& arguments, ProveOptions& options) {
    const ScratchFolder scratch;
    options.scratch = scratch.path();
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    options.generated = std::filesystem::absolute(arguments.build.empty() ? own : arguments.build) / "generated";
    const std::filesystem::path json = arguments.json.empty() ? "" : std::filesystem::absolute(arguments.json);
    const std::filesystem::path merge = arguments.merge.empty() ? "" : std::filesystem::absolute(arguments.merge);
    if (!arguments.shard.empty()) {
        options.shard = parse_shard(arguments.shard);
    }
    std::filesystem::current_path(arguments.root);
    if (!arguments.faults.empty()) {
        return try_faults(arguments.faults, arguments.every, options);
    }
    const std::vector<TheoremResult> results = merge.empty() ? prove_all(options) : merge_shards(merge);
    std::cout << table_of(results);
    if (!json.empty()) {
        write_file(json, options.shard ? shard_text(*options.shard, results) : json_text(results));
    }
    bool all_proven = true;
    for (const TheoremResult& one : results) {
        all_proven = all_proven && one.verdict == Verdict::proven;
    }
    return all_proven ? 0 : 1;
}

}  // namespace

}  // namespace canproof::host::prove

int main(int argc, char** argv) {
    namespace prove = canproof::host::prove;
    CLI::App app{"canproof prove: theorems about the firmware, shown for all values"};
    prove::Arguments arguments;
    prove::ProveOptions options;
    prove::add_options(app, arguments, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : prove::wrong_use;
    }
    try {
        return prove::prove(arguments, options);
    } catch (const std::exception& error) {
        std::cerr << "canproof prove: " << error.what() << '\n';
        return prove::wrong_use;
    }
}
