// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/assess_commands.hpp"

#include <CLI/CLI.hpp>

#include "host/app/cli/audit_command.hpp"
#include "host/app/cli/coverage_command.hpp"
#include "host/app/cli/diff_command.hpp"
#include "host/app/cli/evidence_command.hpp"
#include "host/app/cli/fuzz_options.hpp"
#include "host/app/cli/inject_command.hpp"
#include "host/app/cli/misra_command.hpp"
#include "host/app/cli/mutate_command.hpp"
#include "host/app/cli/option_rules.hpp"
#include "host/app/cli/prove_command.hpp"
#include "host/base/prove_options.hpp"

namespace canproof::host {

namespace {

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
        auto* status =
            command
                ->add_option("--status", options_.filter.status,
                             "list items and statements that are failed, open, suspect or shown, or statements that "
                             "are explained by a reason")
                ->check(CLI::IsMember({"failed", "open", "suspect", "shown", "explained"}));
        command
            ->add_flag_callback(
                "--untested", [this] { options_.filter.status = "open"; }, "the same as --status open")
            ->excludes(status);
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
        auto* records = command->add_flag(
            "--records", options_.records_only,
            "check only that each recorded reason matches a place in the sources; needs no measurement");
        stands_alone(*command, records, {"--root", "--json"});
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
        review->add_option("--by", options_.reviewer, "who judged")->required()->check(utf8_text());
        review->add_option("--judgement", options_.judgement, "what was examined, and why the file complies")
            ->required()
            ->check(utf8_text());
        leaves_out_options(*command, *review, {"--root", "--build"});
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
        leaves_out_options(*command, *verify, {});
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
        auto* sample = command->add_option("--sample", options_.sample,
                                           "number of alterations to test, drawn at random with --seed");
        command->add_option("--seed", options_.seed, "seed of the sample")->capture_default_str()->needs(sample);
        command->add_option("--jobs", options_.jobs, "processes at a time")
            ->capture_default_str()
            ->check(CLI::Range(1, 64));
        auto* shard =
            command->add_option("--shard", shard_, "I/N: test part I of N; other machines test the other parts");
        command->add_option("--merge", options_.merge, "folder with the files of all shards: merge them into one run")
            ->excludes(shard);
        command->add_flag("--json", options_.json, "counts, unnoticed mutants and faults of the records as JSON");
        auto* table =
            command->add_flag("--table", options_.table,
                              "with --code: run no test, print reports/code_figures.csv by layer, in Markdown");
        stands_alone(*command, table->needs(code), {"--code", "--root", "--programs"});
        stands_alone(*command, kills, {"--root", "--programs", "--jobs", "--json"});
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
        auto* json = command->add_flag("--json", options_.json, "counts and silent faults as JSON");
        auto* shard = command
                          ->add_option("--shard", shard_,
                                       "I/N: inject part I of N of the faults; other machines inject the other parts")
                          ->excludes(json);
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
