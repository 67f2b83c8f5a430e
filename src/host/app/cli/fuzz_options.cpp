// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/fuzz_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "host/app/cli/fuzz_command.hpp"
#include "host/app/cli/option_rules.hpp"

namespace canproof::host {

FuzzCommand::FuzzCommand(CLI::App& app, Chosen& chosen) {
    auto* command =
        app.add_subcommand("fuzz", "run all fuzz targets for a given time, then report findings and coverage");
    auto* minutes = command
                        ->add_option("--minutes", options_.minutes,
                                     "minutes of fuzzing; valgrind and coverage take additional time")
                        ->check(number_from(0.01, 100000.0))
                        ->capture_default_str();
    auto* hours =
        command->add_option("--hours", hours_, "hours of fuzzing")->check(number_from(0.01, 1000.0))->excludes(minutes);
    command->add_option("--targets", options_.targets, "a,b: only these targets")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--root", options_.root, "the project's folder; the default folders are below it")
        ->capture_default_str();
    add_folder(command->add_option("--corpus", options_.corpus, "folder that keeps inputs, findings and history"),
               options_.corpus);
    add_folder(command->add_option("--out", options_.out, "folder of the report"), options_.out);
    command->add_option("--jobs", options_.jobs, "parallel processes; default: all cores");
    auto* seed = command->add_option("--seed", options_.seed, "seed of the random numbers; default: from the clock");
    add_folder(command->add_option("--build", options_.build, "folder of the build with libFuzzer and sanitizers"),
               options_.build);
    add_folder(command->add_option("--replay-build", options_.replay_build,
                                   "folder of the build without libFuzzer and sanitizers, for valgrind and frame logs"),
               options_.replay_build);
    add_folder(command->add_option("--coverage-build", options_.coverage_build, "folder of the build for coverage"),
               options_.coverage_build);
    command->add_option(
        "--land", options_.land,
        "copy findings as regression tests to FOLDER/TARGET; default: the corpus of each target; '': do not copy");
    command->add_flag("!--no-second-pass", options_.second_pass, "do not run the corpus under valgrind");
    command->add_flag("!--no-coverage", options_.coverage, "do not measure coverage");
    command->add_flag("--plain", options_.plain, "lines instead of a table, even on a terminal");
    auto* restart = command->add_flag("--restart", options_.restart, "discard an unfinished campaign");
    auto* shard = command->add_option("--shard", shard_,
                                      "I/N: fuzz part I of N of the targets; other machines fuzz the other parts");
    command
        ->add_option("--merge", options_.merge,
                     "folder with the corpus folders of all shards: sort findings, measure coverage, report")
        ->excludes(shard, minutes, hours, seed, restart);
    command->callback([this, shard, &chosen] {
        options_.minutes = hours_ > 0.0 ? hours_ * 60.0 : options_.minutes;
        chosen = [this, shard] {
            if (shard->count() != 0) {
                options_.shard = parse_shard(shard_);
            }
            put_folders_below_root();
            return fuzz_targets(options_);
        };
    });
}

void FuzzCommand::add_folder(CLI::Option* option, std::string& path) {
    folders_.push_back({option->capture_default_str(), &path});
}

void FuzzCommand::put_folders_below_root() const {
    for (const Folder& folder : folders_) {
        if (folder.option->count() == 0) {
            *folder.path = (std::filesystem::path{options_.root} / *folder.path).lexically_normal().string();
        }
    }
}

}  // namespace canproof::host
