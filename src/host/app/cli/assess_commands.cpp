#include "host/app/cli/assess_commands.hpp"

#include <CLI/CLI.hpp>

#include "host/app/cli/audit_command.hpp"
#include "host/app/cli/coverage_command.hpp"
#include "host/app/cli/diff_command.hpp"
#include "host/app/cli/evidence_command.hpp"
#include "host/app/cli/fuzz_command.hpp"
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
            app.add_subcommand("fuzz", "all fuzz targets for a given time, then findings, coverage, report");
        auto* minutes =
            command->add_option("--minutes", options_.minutes, "of fuzzing; the passes after it come on top")
                ->check(CLI::Range(0.01, 100000.0))
                ->capture_default_str();
        command->add_option("--hours", hours_, "the same in hours")->check(CLI::Range(0.01, 1000.0))->excludes(minutes);
        command->add_option("--targets", options_.targets, "a,b: these only")->delimiter(',');
        command->add_option("--corpus", options_.corpus, "folder that keeps inputs, findings and history")
            ->capture_default_str();
        command->add_option("--out", options_.out, "folder of the report")->capture_default_str();
        command->add_option("--jobs", options_.jobs, "processes beside each other; all cores without it");
        command->add_option("--seed", options_.seed, "of the random numbers; from the clock without it");
        command->add_option("--build", options_.build, "build with libFuzzer and sanitizers")->capture_default_str();
        command
            ->add_option("--replay-build", options_.replay_build, "build without either, for valgrind and frame logs")
            ->capture_default_str();
        command->add_option("--coverage-build", options_.coverage_build, "build that counts lines")
            ->capture_default_str();
        command->add_option("--land", options_.land,
                            "findings become regression tests in TARGET below this folder; in the target's own corpus "
                            "without it; '' for nowhere");
        command->add_flag("!--no-second-pass", options_.second_pass, "no valgrind over the corpus");
        command->add_flag("!--no-coverage", options_.coverage, "no lines measured");
        command->add_flag("--plain", options_.plain, "lines instead of a table, on a terminal as well");
        command->add_flag("--restart", options_.restart, "forget an unfinished campaign");
        command->callback([this, &chosen] {
            options_.minutes = hours_ > 0.0 ? hours_ * 60.0 : options_.minutes;
            chosen = [this] { return fuzz_targets(options_); };
        });
    }

  private:
    CampaignOptions options_;
    double hours_{0.0};  ///< 0: --minutes counts
};

class AuditCommand : Command {
  public:
    AuditCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand("audit", "manual section to requirement to code to test to verdict");
        command->add_option(
            "SUBJECT", options_.subject,
            "a device, id, section (AX130751:1.3), statement (AX130751:1.3/2), source file or test; all without "
            "it");
        command->add_option(
            "--section", options_.filter.section,
            "list items and statements from there: AX130751:1 takes 1.3 as well; 3.2.8 alone where one manual "
            "has it");
        command->add_option(
            "--kind", options_.filter.kind,
            "list items of a kind: timing, storage, table, constant …; statement: the manuals' statements; "
            "condition-of-use: what the manuals ask of installers");
        command
            ->add_option("--status", options_.filter.status,
                         "list items and statements that are failed, open, suspect or shown, or statements that are "
                         "explained by a reason")
            ->check(CLI::IsMember({"failed", "open", "suspect", "shown", "explained"}));
        command->add_flag_callback(
            "--untested", [this] { options_.filter.status = "open"; }, "the same as --status open");
        command->add_flag("--json", options_.json, "the audit or the list as JSON");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--verdicts", options_.verdicts,
                            "folder of test results; the newest of build/*/verdicts without it");
        command->callback([this, &chosen] { chosen = [this] { return audit(options_); }; });
    }

  private:
    AuditOptions options_;
};

class CoverageCommand : Command {
  public:
    CoverageCommand(CLI::App& app, Chosen& chosen) {
        auto* command =
            app.add_subcommand("coverage", "what no test reached in the firmware, each with its reason or open");
        command->add_option("FILE", options_.measured, "what tests/coverage measured")->capture_default_str();
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--cobertura", options_.cobertura, "XML file to write");
        command->add_flag("--json", options_.json, "MC/DC of each file and all places that are not reached as JSON");
        command->add_flag("--records", options_.records_only,
                          "nothing measured: does each record name something in the sources?");
        command->callback([this, &chosen] { chosen = [this] { return check_coverage(options_); }; });
    }

  private:
    CoverageOptions options_;
};

class MisraCommand : Command {
  public:
    MisraCommand(CLI::App& app, Chosen& chosen) {
        auto* command =
            app.add_subcommand("misra", "MISRA C++:2023 over the firmware, by checkers that are themselves tested");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--build", options_.build, "folder with a built firmware; build/release without it");
        command->add_option("--html", options_.out,
                            "folder for misra.html, misra.sarif, compliance.md; BUILD/misra without it");
        auto* review = command->add_subcommand("review", "record that a person judged a file for a guideline");
        review->add_option("FILE", options_.review_file, "as the finding names it")->required();
        review->add_option("RULE", options_.review_rule)->required();
        review->add_option("--by", options_.reviewer, "who judged")->required();
        review->add_option("--judgement", options_.judgement, "what was looked at, and why it holds")->required();
        command->callback([this, &chosen] { chosen = [this] { return check_misra(options_); }; });
    }

  private:
    MisraOptions options_;
};

class EvidenceCommand : Command {
  public:
    EvidenceCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand("evidence", "write the pack: what is claimed, what shows it, what is open");
        command->add_option("--out", options_.out, "folder to write")->capture_default_str();
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--verdicts", options_.verdicts,
                            "folder of test results; the newest of build/*/verdicts without it");
        command->add_option("--coverage", options_.coverage,
                            "what tests/coverage measured; build/coverage/coverage.json without it");
        command->add_option("--exhibits", options_.exhibits,
                            "folder of results of other tools; build/exhibits without it");
        command->add_option("--sign", options_.key, "PEM file of a private key: signs the manifest")
            ->check(CLI::ExistingFile);
        command->add_flag("--full", options_.full,
                          "make all that is absent or stale first, for hours; begun again it goes on where it stopped");
        command->add_flag("--json", options_.json, "claims and their evidence as JSON instead of a line");
        auto* verify = command->add_subcommand(
            "verify", "is a pack as its manifest says, and signed by a key? exit status 0 or 1");
        verify->add_option("FOLDER", verified_.pack, "the pack")->capture_default_str();
        verify->add_option("--key", verified_.key, "PEM file of the public key")->check(CLI::ExistingFile);
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
        auto* command = app.add_subcommand("mutate", "alters each generated cell and asks whether a test notices");
        command->add_option("SUBJECT", options_.subject,
                            "a device or an id, with --code part of a file's path; everything without");
        command->add_flag("--code", options_.code,
                          "the firmware's code instead of generated cells: conditions, statements, variables …");
        command->add_flag(
            "--kills", options_.kills,
            "judges each test that is new or changed: of which of its items it notices a mutant (reports/kills.csv)");
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--programs", options_.programs, "folder of the test programs; build/mutation without it");
        command->add_option("--sample", options_.sample, "only so many cells, drawn by --seed");
        command->add_option("--seed", options_.seed, "of the sample")->capture_default_str();
        command->add_option("--jobs", options_.jobs, "processes at a time")
            ->capture_default_str()
            ->check(CLI::Range(1, 64));
        command->callback([this, &chosen] { chosen = [this] { return mutate(options_); }; });
    }

  private:
    MutateOptions options_;
};

class DiffCommand : Command {
  public:
    DiffCommand(CLI::App& app, Chosen& chosen) {
        auto* command =
            app.add_subcommand("diff", "what the changes since a revision touch: items, code, tests, verdicts");
        command->add_option("REVISION", options_.revision, "a commit, branch or tag of git")->required();
        command->add_option("--root", options_.root, "the project's folder")->capture_default_str();
        command->add_option("--verdicts", options_.verdicts,
                            "folder of test results; the newest of build/*/verdicts without it");
        command->add_option("--old-verdicts", options_.old_verdicts,
                            "results of the revision: tells whose verdict differs");
        command->add_flag("--json", options_.json, "changed items, files and verdicts as JSON");
        command->callback([this, &chosen] { chosen = [this] { return diff(options_); }; });
    }

  private:
    DiffOptions options_;
};

class ProveCommand : Command {
  public:
    ProveCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand(
            "prove", "theorems about the firmware, shown for all values: proven, refuted or unknown");
        add_options(*command);
        command->callback([this, command, &chosen] {
            words_ = words_of(*command);
            chosen = [this] { return prove(words_); };
        });
    }

  private:
    /// Those of canproof-prove, which checks their values and has the defaults.
    void add_options(CLI::App& command) {
        for (const ProveOption& one : prove_options) {
            if (one.takes_value) {
                command.add_option(one.name, value_, one.help);
            } else {
                command.add_flag(one.name, one.help);
            }
        }
    }
    /// Returns the options as they were given.
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

    std::string value_;  ///< of whichever option; words_of() reads them
    std::vector<std::string> words_;
};

struct AssessCommands {
    FuzzCommand fuzz;
    AuditCommand audit;
    CoverageCommand coverage;
    MisraCommand misra;
    EvidenceCommand evidence;
    MutateCommand mutate;
    DiffCommand diff;
    ProveCommand prove;
};

}  // namespace

std::shared_ptr<void> add_assess_commands(CLI::App& app, Chosen& chosen) {
    // Each is made where it stays: its callbacks point to it.
    return std::shared_ptr<AssessCommands>{new AssessCommands{{app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen},
                                                              {app, chosen}}};
}

}  // namespace canproof::host
