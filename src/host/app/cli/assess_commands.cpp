// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/assess_commands.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "host/app/cli/audit_command.hpp"
#include "host/app/cli/coverage_command.hpp"
#include "host/app/cli/diff_command.hpp"
#include "host/app/cli/evidence_command.hpp"
#include "host/app/cli/fuzz_command.hpp"
#include "host/app/cli/inject_command.hpp"
#include "host/app/cli/misra_command.hpp"
#include "host/app/cli/mutate_command.hpp"
#include "host/app/cli/prove_command.hpp"
#include "host/assess/fuzz/campaign.hpp"
#include "host/base/prove_options.hpp"

namespace canproof::host {

namespace {

class FuzzCommand : Command {
  public:
    FuzzCommand(CLI::App& app, Chosen& chosen) {
        auto* command =
            app.add_subcommand("fuzz", "run all fuzz targets for a given time, then report findings and coverage");
        auto* minutes = command
                            ->add_option("--minutes", options_.minutes,
                                         "minutes of fuzzing; valgrind and coverage take additional time")
                            ->check(CLI::Range(0.01, 100000.0))
                            ->capture_default_str();
        command->add_option("--hours", hours_, "hours of fuzzing")->check(CLI::Range(0.01, 1000.0))->excludes(minutes);
        command->add_option("--targets", options_.targets, "a,b: only these targets")
            ->delimiter(',')
            ->allow_extra_args(false);
        command->add_option("--root", options_.root, "the project's folder; the default folders are below it")
            ->capture_default_str();
        add_folder(command->add_option("--corpus", options_.corpus, "folder that keeps inputs, findings and history"),
                   options_.corpus);
        add_folder(command->add_option("--out", options_.out, "folder of the report"), options_.out);
        command->add_option("--jobs", options_.jobs, "parallel processes; default: all cores");
        command->add_option("--seed", options_.seed, "seed of the random numbers; default: from the clock");
        add_folder(command->add_option("--build", options_.build, "folder of the build with libFuzzer and sanitizers"),
                   options_.build);
        add_folder(
            command->add_option("--replay-build", options_.replay_build,
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
        command->add_flag("--restart", options_.restart, "discard an unfinished campaign");
        auto* shard = command->add_option("--shard", shard_,
                                          "I/N: fuzz part I of N of the targets; other machines fuzz the other parts");
        command
            ->add_option("--merge", options_.merge,
                         "folder with the corpus folders of all shards: sort findings, measure coverage, report")
            ->excludes(shard);
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

  private:
    /// An option that names a folder. Its default is a path below the project's folder (--root).
    struct Folder {
        const CLI::Option* option;
        std::string* path;
    };

    void add_folder(CLI::Option* option, std::string& path) {
        folders_.push_back({option->capture_default_str(), &path});
    }
    void put_folders_below_root() const {
        for (const Folder& folder : folders_) {
            if (folder.option->count() == 0) {
                *folder.path = (std::filesystem::path{options_.root} / *folder.path).lexically_normal().string();
            }
        }
    }

    CampaignOptions options_;
    std::vector<Folder> folders_;
    std::string shard_;
    double hours_{0.0};  ///< duration of the campaign in hours; 0: --minutes sets the duration
};

class AuditCommand : Command {
  public:
    AuditCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand("audit", "trace manual sections to requirements, code, tests and verdicts");
        command->add_option("SUBJECT", options_.subject,
                            "a device, id of an item, section (AX130751:1.3), statement (AX130751:1.3/2), source file "
                            "or test; default: all");
        command->add_option("--section", options_.filter.section,
                            "list items and statements of a section: AX130751:1 includes 1.3; 3.2.8 suffices if only "
                            "one manual has it");
        command->add_option(
            "--kind", options_.filter.kind,
            "list items of a kind: timing, storage, table, constant …; statement: the manuals' statements; "
            "condition-of-use: conditions for installers and operators");
        command
            ->add_option("--status", options_.filter.status,
                         "list items and statements that are failed, open, suspect or shown, or statements that are "
                         "explained by a reason")
            ->check(CLI::IsMember({"failed", "open", "suspect", "shown", "explained"}));
        command->add_flag_callback(
            "--untested", [this] { options_.filter.status = "open"; }, "the same as --status open");
        command->add_flag("--json", options_.json, "print JSON instead of lines");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--verdicts", options_.verdicts,
                            "folder of test results; default: the newest of build/{release,debug,coverage}/verdicts");
        command->callback([this, &chosen] { chosen = [this] { return audit(options_); }; });
    }

  private:
    AuditOptions options_;
};

class CoverageCommand : Command {
  public:
    CoverageCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand(
            "coverage", "list places in the firmware that no test reaches and that have no recorded reason");
        command->add_option("FILE", options_.measured, "coverage that tests/coverage measured")->capture_default_str();
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--cobertura", options_.cobertura, "Cobertura XML file to write");
        command->add_flag("--json", options_.json,
                          "print as JSON the MC/DC of each file and all places that no test reaches");
        command->add_flag("--records", options_.records_only,
                          "check only that each recorded reason matches a place in the sources; needs no measurement");
        command->callback([this, &chosen] { chosen = [this] { return check_coverage(options_); }; });
    }

  private:
    CoverageOptions options_;
};

class MisraCommand : Command {
  public:
    MisraCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand("misra", "check the firmware against MISRA C++:2023, with tested checkers");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--build", options_.build,
                            "folder with a built firmware; default: build/release, else build/debug");
        command->add_option("--html", options_.out,
                            "folder for misra.html, misra.sarif, compliance.md; default: BUILD/misra");
        command->add_flag("--json", options_.json,
                          "findings, faults and figures as JSON; the progress goes to standard error");
        auto* review = command->add_subcommand("review", "record that a person judged a file for a guideline");
        review->add_option("FILE", options_.review_file, "file, as named in the finding")->required();
        review->add_option("RULE", options_.review_rule)->required();
        review->add_option("--by", options_.reviewer, "who judged")->required();
        review->add_option("--judgement", options_.judgement, "what was examined, and why the file complies")
            ->required();
        command->callback([this, &chosen] { chosen = [this] { return check_misra(options_); }; });
    }

  private:
    MisraOptions options_;
};

class EvidenceCommand : Command {
  public:
    EvidenceCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand("evidence", "write the evidence pack: claims, evidence and open points");
        command->add_option("--out", options_.out, "folder to write the pack to")->capture_default_str();
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--verdicts", options_.verdicts,
                            "folder of test results; default: the newest of build/{release,debug,coverage}/verdicts");
        command->add_option("--coverage", options_.coverage,
                            "coverage that tests/coverage measured; default: build/coverage/coverage.json");
        command->add_option("--exhibits", options_.exhibits,
                            "folder of results of other tools; default: build/exhibits");
        command->add_option("--sign", options_.key, "PEM file of a private key: signs the manifest")
            ->check(CLI::ExistingFile);
        command->add_flag(
            "--full", options_.full,
            "first make all absent or stale evidence; takes hours; a repeated call continues where it stopped");
        command->add_flag("--json", options_.json, "claims and their evidence as JSON instead of a line");
        auto* verify =
            command->add_subcommand("verify", "verify a pack against its manifest and a signature; exit status 0 or 1");
        verify->add_option("FOLDER", verified_.pack, "the pack")->capture_default_str();
        verify->add_option("--key", verified_.key, "PEM file of the public key")->check(CLI::ExistingFile);
        verify->add_flag("--json", verified_.json, "the faults as JSON instead of lines");
        verify->callback([this, &chosen] { chosen = [this] { return verify_evidence(verified_); }; });
        command->callback([this, verify, &chosen] {
            if (!verify->parsed()) {
                chosen = [this] { return write_evidence(options_); };
            }
        });
    }

  private:
    EvidenceOptions options_;
    VerifyOptions verified_;
};

class MutateCommand : Command {
  public:
    MutateCommand(CLI::App& app, Chosen& chosen) {
        auto* command =
            app.add_subcommand("mutate", "alter each cell of the generated tables and check whether a test notices it");
        command->add_option("SUBJECT", options_.subject,
                            "a device or the id of an item; with --code a part of a file's path; default: everything");
        auto* code = command->add_flag(
            "--code", options_.code,
            "alter the code of the firmware and of the host's buses and replay, instead of generated cells");
        auto* kills = command->add_flag("--kills", options_.kills,
                                        "record in reports/kills.csv, for each test, the items of which it notices a "
                                        "mutant; run only the tests that are new or changed, or whose items have "
                                        "changed code");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--programs", options_.programs, "folder of the test programs; default: build/mutation");
        command->add_option("--sample", options_.sample, "number of alterations to test, drawn at random with --seed");
        command->add_option("--seed", options_.seed, "seed of the sample")->capture_default_str();
        command->add_option("--jobs", options_.jobs, "processes at a time")
            ->capture_default_str()
            ->check(CLI::Range(1, 64));
        auto* shard =
            command->add_option("--shard", shard_, "I/N: test part I of N; other machines test the other parts")
                ->excludes(kills);
        command->add_option("--merge", options_.merge, "folder with the files of all shards: merge them into one run")
            ->excludes(shard)
            ->excludes(kills);
        auto* json =
            command->add_flag("--json", options_.json, "counts, unnoticed mutants and faults of the records as JSON");
        command
            ->add_flag("--table", options_.table,
                       "with --code: run no test, print reports/code_figures.csv by layer, in Markdown")
            ->needs(code)
            ->excludes(kills)
            ->excludes(shard)
            ->excludes(json);
        command->callback([this, shard, &chosen] {
            chosen = [this, shard] {
                if (shard->count() != 0) {
                    options_.shard = parse_shard(shard_);
                }
                return mutate(options_);
            };
        });
    }

  private:
    MutateOptions options_;
    std::string shard_;
};

class InjectCommand : Command {
  public:
    InjectCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand(
            "inject", "invert single bits in the memory of a running device, and report the effects");
        command->add_option("DEVICE", options_.device, "a device of the catalogue")->required();
        auto* log = command->add_option("LOG", options_.log,
                                        "candump log of frames to the device; default: tests/devices/DEVICE/workload");
        command->add_option("--stimulus", options_.stimulus, "CSV file of seconds,signal,value: changes of inputs")
            ->needs(log);
        command->add_option("--node", options_.node, "node-ID, or position of the coding switches");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        auto& campaign = options_.campaign;
        command->add_option("--faults", campaign.faults, "number of faults")
            ->capture_default_str()
            ->check(CLI::Range(1, 10'000'000));
        command->add_option("--seed", campaign.seed, "seed of each fault's time, place and bit")->capture_default_str();
        command->add_option("--jobs", campaign.jobs, "processes at a time")
            ->capture_default_str()
            ->check(CLI::Range(1, 64));
        command->add_flag("--json", options_.json, "counts and silent faults as JSON");
        auto* shard = command->add_option(
            "--shard", shard_, "I/N: inject part I of N of the faults; other machines inject the other parts");
        command->add_option("--out", options_.out, "folder of the shard's file")->capture_default_str()->needs(shard);
        command->add_option("--merge", options_.merge, "folder with the files of all shards: merge these files")
            ->excludes(shard);
        command->callback([this, shard, &chosen] {
            chosen = [this, shard] {
                options_.is_shard = shard->count() != 0;
                if (options_.is_shard) {
                    options_.campaign.shard = parse_shard(shard_);
                }
                return inject(options_);
            };
        });
    }

  private:
    InjectOptions options_;
    std::string shard_;
};

class DiffCommand : Command {
  public:
    DiffCommand(CLI::App& app, Chosen& chosen) {
        auto* command =
            app.add_subcommand("diff", "list items, code, tests and verdicts that the changes since a revision affect");
        command->add_option("REVISION", options_.revision, "a commit, branch or tag of git")->required();
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--verdicts", options_.verdicts,
                            "folder of test results; default: the newest of build/{release,debug,coverage}/verdicts");
        command->add_option("--old-verdicts", options_.old_verdicts,
                            "folder of the revision's test results: lists the verdicts that changed");
        command->add_flag("--json", options_.json, "changed items, files, verdicts and stale evidence as JSON");
        command->add_flag("--exit-code", options_.exit_code, "exit status 1 when anything changed");
        command->callback([this, &chosen] { chosen = [this] { return diff(options_); }; });
    }

  private:
    DiffOptions options_;
};

class ProveCommand : Command {
  public:
    ProveCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand(
            "prove", "prove theorems about the firmware for all values; each one is proven, refuted or unknown");
        add_options(*command);
        command->callback([this, command, &chosen] {
            words_ = words_of(*command);
            chosen = [this] { return prove(words_); };
        });
    }

  private:
    /// Adds the options of the program canproof-prove under the same names. canproof-prove itself checks the values and
    /// sets the defaults.
    void add_options(CLI::App& command) {
        for (const ProveOption& one : prove_options) {
            if (one.takes_value) {
                command.add_option(one.name, value_, one.help);
            } else {
                command.add_flag(one.name, one.help);
            }
        }
    }
    /// Returns the options that the user gave, and their values, as arguments for canproof-prove.
    static std::vector<std::string> words_of(const CLI::App& command) {
        std::vector<std::string> words;
        for (const CLI::Option* option : command.get_options()) {
            if (option->count() == 0) {
                continue;
            }
            words.push_back(option->get_name());
            if (option->get_items_expected_max() != 0) {
                words.push_back(option->results().back());
            }
        }
        return words;
    }

    std::string value_;  ///< CLI11 writes every option's value here; words_of() reads the options themselves
    std::vector<std::string> words_;
};

struct AssessCommands {
    FuzzCommand fuzz;
    AuditCommand audit;
    CoverageCommand coverage;
    MisraCommand misra;
    EvidenceCommand evidence;
    MutateCommand mutate;
    InjectCommand inject;
    DiffCommand diff;
    ProveCommand prove;
};

}  // namespace

std::shared_ptr<void> add_assess_commands(CLI::App& app, Chosen& chosen) {
    // Each command is constructed at its final address, because its callbacks point to it.
    return std::shared_ptr<AssessCommands>{new AssessCommands{{app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen}}};
}

}  // namespace canproof::host
