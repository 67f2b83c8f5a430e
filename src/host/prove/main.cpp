// SPDX-License-Identifier: Apache-2.0
// canproof-prove, the program that `canproof prove` starts. It is a separate program, so that `canproof` does not load
// a compiler library and a solver.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/prove_options.hpp"
#include "host/base/replace_folder.hpp"
#include "host/base/source_hash.hpp"
#include "host/prove/faults.hpp"
#include "host/prove/proofs_exhibit.hpp"
#include "host/prove/prove_all.hpp"
#include "host/prove/prove_shards.hpp"
#include "host/prove/results.hpp"
#include "host/prove/scratch_folder.hpp"
#include "host/prove/verdict_xml.hpp"

namespace canproof::host::prove {

namespace {

constexpr int wrong_use = 2;

struct Arguments {
    std::filesystem::path root{"."};
    std::filesystem::path build{};
    std::string json{};
    std::string out{};
    std::string xml{};
    std::string shard{};
    std::string merge{};
    std::string faults{};
    std::string seeds{};
    std::string kept{};
    unsigned every{1};
};

/// The options of prove_options.hpp, each with the variable that stores its value.
class Options {
  public:
    explicit Options(CLI::App& app) : app_{app} {}

    template <typename Target>
    CLI::Option* operator()(const char* name, Target& target) {
        ++count_;
        return app_.add_option(name, target, help_of_prove_option(name));
    }
    void on(const char* name, bool& target) {
        ++count_;
        app_.add_flag(name, target, help_of_prove_option(name));
    }
    void off(const char* name, bool& target) {
        ++count_;
        app_.add_flag(std::string{"!"} + name, target, help_of_prove_option(name));
    }
    std::size_t count() const { return count_; }

  private:
    CLI::App& app_;
    std::size_t count_{0};
};

void add_options(CLI::App& app, Arguments& arguments, ProveOptions& options) {
    Options add{app};
    add("--only", options.area);
    add("--proofs", options.proofs)->capture_default_str();
    add.on("--long", options.takes_long);
    add("--theorem", options.theorem);
    add("--timeout", options.seconds)->check(CLI::Range(1, 86400))->capture_default_str();
    add("--jobs", options.jobs)->check(CLI::Range(1, 64))->capture_default_str();
    add("--json", arguments.json);
    CLI::Option* const out = add("--out", arguments.out);
    CLI::Option* const xml = add("--xml", arguments.xml);
    CLI::Option* const shard = add("--shard", arguments.shard);
    add("--merge", arguments.merge)->excludes(shard);
    add("--faults", arguments.faults);
    add("--every", arguments.every)->check(CLI::Range(1, 1000));
    add("--seeds", arguments.seeds);
    add("--kept", arguments.kept)->excludes(out)->excludes(xml);  // evidence rests on no earlier run
    add.off("--no-replay", options.replays);
    add("--root", arguments.root)->capture_default_str();
    add("--build", arguments.build);
    if (add.count() != prove_options.size()) {
        throw std::logic_error{"prove_options.hpp lists other options than this program reads"};
    }
}

std::filesystem::path absolute_or_empty(const std::string& path) {
    return path.empty() ? std::filesystem::path{} : std::filesystem::absolute(path);
}

int prove(const Arguments& arguments, ProveOptions& options) {
    const ScratchFolder scratch;
    options.scratch = scratch.path();
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    options.generated = std::filesystem::absolute(arguments.build.empty() ? own : arguments.build) / "generated";
    options.seeds.folder = absolute_or_empty(arguments.seeds);
    options.kept = absolute_or_empty(arguments.kept);
    const std::filesystem::path json = absolute_or_empty(arguments.json);
    const std::filesystem::path out = absolute_or_empty(arguments.out);
    const std::filesystem::path xml = absolute_or_empty(arguments.xml);
    const std::filesystem::path merge = absolute_or_empty(arguments.merge);
    if (!arguments.shard.empty()) {
        options.shard = parse_shard(arguments.shard);
    }
    std::filesystem::current_path(arguments.root);
    if (!arguments.faults.empty()) {
        return try_faults(arguments.faults, arguments.every, options);
    }
    const std::string sources = options.shard ? source_hash(".") + (options.takes_long ? " --long" : "") : "";
    const std::vector<TheoremResult> results = merge.empty() ? prove_all(options) : merge_shards(merge);
    const std::vector<std::string> left_out = merge.empty() ? long_files_left_out(options) : std::vector<std::string>{};
    std::cout << table_of(results);
    if (!left_out.empty()) {
        std::cout << fmt::format("not run, because their proofs take long (--long): {}\n", fmt::join(left_out, ", "));
    }
    if (!json.empty()) {
        write_file(json, options.shard ? shard_text(*options.shard, sources, results) : json_text(results));
    }
    if (!xml.empty()) {
        write_file(xml, verdict_xml(results));
    }
    if (!out.empty()) {
        replace_folder(out, exhibit_of(results, left_out));
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
    try {
        prove::add_options(app, arguments, options);
        app.parse(argc, argv);
        return prove::prove(arguments, options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : prove::wrong_use;
    } catch (const std::exception& error) {
        std::cerr << "canproof prove: " << error.what() << '\n';
        return prove::wrong_use;
    }
}
