#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>

#include "host/app/cli/commands.hpp"
#include "host/app/cli/run_arguments.hpp"
#include "host/app/cli/standard_streams.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host {

namespace {

constexpr int wrong_use = 2;

/// Beyond it a double no longer holds microseconds.
constexpr double most_seconds = 4.0e9;

const CLI::Validator seconds{[](std::string& text) -> std::string {
                                 char* end = nullptr;
                                 const double value = std::strtod(text.c_str(), &end);
                                 const bool fits =
                                     !text.empty() && *end == '\0' && value >= 0.0 && value <= most_seconds;
                                 return fits ? "" : text + " is no time from 0 to 4000000000 seconds";
                             },
                             "SECONDS"};

void add_catalogue(CLI::App& app, std::function<int()>& chosen) {
    app.add_subcommand("devices", "the catalogue: part numbers, node-ID and bit rate as shipped")->callback([&chosen] {
        chosen = list_devices;
    });
    static std::string device;
    auto* signals = app.add_subcommand("signals", "physical inputs and outputs of a device, and its factory data");
    signals->add_option("DEVICE", device)->required();
    signals->callback([&chosen] { chosen = [] { return list_signals(device); }; });

    static std::string format = "eds";
    auto* eds = app.add_subcommand("eds", "electronic data sheet of a device");
    eds->add_option("DEVICE", device)->required();
    eds->add_option("--format", format, "eds, eds-lely (reals as bits, for Lely's tools), xdd, json or md")
        ->check(CLI::IsMember({"eds", "eds-lely", "xdd", "json", "md"}));
    eds->callback([&chosen] { chosen = [] { return print_eds(device, format); }; });

    static std::string folder = "spec";
    auto* spec = app.add_subcommand("spec", "the register");
    spec->require_subcommand(1);
    auto* check = spec->add_subcommand("check", "every fault of a register, with file, line and fix");
    check->add_option("--spec", folder, "folder of the register")->capture_default_str();
    check->callback([&chosen] { chosen = [] { return check_spec(folder); }; });
    static ReviewOptions reviewing;
    auto* review = spec->add_subcommand("review", "records that items were read with their code and tests");
    review->add_option("ID", reviewing.subjects, "ids or devices");
    review->add_flag("--all", reviewing.all, "every item that has changed since its review");
    review->add_option("--by", reviewing.by, "who has read them")->required();
    review->add_option("--date", reviewing.date, "YYYY-MM-DD; today without it");
    review->add_option("--spec", reviewing.spec, "folder of the register")->capture_default_str();
    review->callback([&chosen] { chosen = [] { return review_spec(reviewing); }; });
}

void add_new(CLI::App& app, std::function<int()>& chosen) {
    static NewOptions options;
    auto* command = app.add_subcommand("new", "a folder with a device of your own, which builds and tests at once");
    command->add_option("NAME", options.name, "of folder and device: small letters, digits, single dashes")->required();
    command->add_option("--eds", options.eds, "EDS, DCF or XDD file: identity and objects come from there");
    command->add_option("--manual", options.manual, "title of the device's manual");
    command->add_option("--prefix", options.prefix, "of ids, in capital letters; from the name without it");
    command->callback([&chosen] { chosen = [] { return write_new_project(options); }; });
}

void add_run(CLI::App& app, std::function<int()>& chosen) {
    static RunOptions running;
    auto* run = app.add_subcommand("run", "run devices in real time on a bus; without a device the whole catalogue");
    add_run_options(*run, running);
    run->add_option("--seconds", running.seconds, "end after so long")->check(seconds);
    run->add_flag("--plain", running.plain, "every frame as a line, on a terminal as well");
    run->callback([&chosen] { chosen = [] { return run_devices(running); }; });

    static PanelOptions showing;
    auto* panel = app.add_subcommand("panel", "run devices as `run` does, and show them on a local page");
    add_run_options(*panel, showing.run);
    panel->add_option("--port", showing.port, "port of the loopback; 0: any that is free")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    panel->callback([&chosen] { chosen = [] { return run_panel(showing); }; });
}

void add_running(CLI::App& app, std::function<int()>& chosen) {
    static ReplayOptions options;
    auto* replay = app.add_subcommand("replay", "play a candump log to one device in virtual time");
    // Two words: DEVICE LOG; with --eds one: LOG.
    static std::vector<std::string> words;
    replay->add_option("DEVICE LOG", words, "device (not with --eds), then a candump log, or - for standard input")
        ->required()
        ->expected(1, 2);
    replay->add_option("--eds", options.eds, "EDS, DCF or XDD file that describes the device");
    replay->add_option("--node", options.node, node_help);
    replay->add_option("--factory", options.factory, factory_help)->allow_extra_args(false);
    replay->add_option("--nvm", options.nvm, "file that keeps the stored parameters");
    replay->add_option("--stimulus", options.stimulus, "CSV seconds,signal,value");
    replay->add_option("--outputs", options.outputs, "CSV file to write changes of outputs to");
    replay->add_option("--until", options.until, "end, in seconds of the log's time")->check(seconds);
    replay
        ->add_option(
            "--start", options.start,
            "power-on, in seconds of the log's time; the first frame of a log that counts by the clock, else 0")
        ->check(seconds);
    replay->callback([&chosen] {
        if (words.size() != (options.eds.empty() ? 2U : 1U)) {
            throw CLI::ValidationError{"replay", "write DEVICE LOG, or --eds FILE LOG"};
        }
        options.device = options.eds.empty() ? words.front() : "";
        options.log = words.back();
        chosen = [] { return replay_log(options); };
    });

    add_run(app, chosen);
    app.add_subcommand("demo", "the manuals' worked examples, answered by the devices")->callback([&chosen] {
        chosen = play_examples;
    });

    static PlotOptions plotted;
    auto* plot = app.add_subcommand("plot", "what --outputs wrote, drawn");
    plot->add_option("CSV", plotted.csv)->required();
    plot->add_option("SVG", plotted.svg)->required();
    plot->add_option("--signals", plotted.signals, "aout1,aout2: which; all that change without it")->delimiter(',');
    plot->callback([&chosen] { chosen = [] { return plot_outputs(plotted); }; });

    static std::string figures;
    auto* draw = app.add_subcommand("figures", "what the devices do, drawn: SVG files into a folder");
    draw->add_option("FOLDER", figures)->required();
    draw->callback([&chosen] { chosen = [] { return draw_figures(figures); }; });
}

void add_audit(CLI::App& app, std::function<int()>& chosen) {
    static AuditOptions options;
    auto* command = app.add_subcommand("audit", "manual section to requirement to code to test to verdict");
    command->add_option("SUBJECT", options.subject,
                        "a device, id, section (AX130751:1.3), source file or test; all without it");
    command->add_option("--section", options.filter.section, "list items from there: AX130751:1 takes 1.3 as well");
    command->add_option("--kind", options.filter.kind,
                        "list items of a kind: timing, storage, table, constant …; condition-of-use: what the manuals "
                        "ask of installers");
    command->add_option("--status", options.filter.status, "list items that are failed, open, suspect or shown")
        ->check(CLI::IsMember({"failed", "open", "suspect", "shown"}));
    command->add_option("--root", options.root, "the project's folder")->capture_default_str();
    command->add_option("--verdicts", options.verdicts,
                        "folder of test results; the newest of build/*/verdicts without it");
    command->callback([&chosen] { chosen = [] { return audit(options); }; });
}

void add_coverage(CLI::App& app, std::function<int()>& chosen) {
    static CoverageOptions options;
    auto* command =
        app.add_subcommand("coverage", "what no test reached in the firmware, each with its reason or open");
    command->add_option("FILE", options.measured, "what tests/coverage measured")->capture_default_str();
    command->add_option("--root", options.root, "the project's folder")->capture_default_str();
    command->add_option("--cobertura", options.cobertura, "XML file to write");
    command->add_flag("--records", options.records_only,
                      "nothing measured: does each record name something in the sources?");
    command->callback([&chosen] { chosen = [] { return check_coverage(options); }; });
}

void add_fuzz(CLI::App& app, std::function<int()>& chosen) {
    static CampaignOptions options;
    static double hours = 0.0;
    auto* command = app.add_subcommand("fuzz", "all fuzz targets for a given time, then findings, coverage, report");
    auto* minutes = command->add_option("--minutes", options.minutes, "of fuzzing; the passes after it come on top")
                        ->check(CLI::Range(0.01, 100000.0))
                        ->capture_default_str();
    command->add_option("--hours", hours, "the same in hours")->check(CLI::Range(0.01, 1000.0))->excludes(minutes);
    command->add_option("--targets", options.targets, "a,b: these only")->delimiter(',');
    command->add_option("--corpus", options.corpus, "folder that keeps inputs, findings and history")
        ->capture_default_str();
    command->add_option("--out", options.out, "folder of the report")->capture_default_str();
    command->add_option("--jobs", options.jobs, "processes beside each other; all cores without it");
    command->add_option("--seed", options.seed, "of the random numbers; from the clock without it");
    command->add_option("--build", options.build, "build with libFuzzer and sanitizers")->capture_default_str();
    command->add_option("--replay-build", options.replay_build, "build without either, for valgrind and frame logs")
        ->capture_default_str();
    command->add_option("--coverage-build", options.coverage_build, "build that counts lines")->capture_default_str();
    command->add_option("--land", options.land,
                        "findings become regression tests in TARGET below this folder; in the target's own corpus "
                        "without it; '' for nowhere");
    command->add_flag("!--no-second-pass", options.second_pass, "no valgrind over the corpus");
    command->add_flag("!--no-coverage", options.coverage, "no lines measured");
    command->add_flag("--plain", options.plain, "lines instead of a table, on a terminal as well");
    command->add_flag("--restart", options.restart, "forget an unfinished campaign");
    command->callback([&chosen] {
        options.minutes = hours > 0.0 ? hours * 60.0 : options.minutes;
        chosen = [] { return fuzz_targets(options); };
    });
}

void add_misra(CLI::App& app, std::function<int()>& chosen) {
    static MisraOptions options;
    auto* command =
        app.add_subcommand("misra", "MISRA C++:2023 over the firmware, by checkers that are themselves tested");
    command->add_option("--root", options.root, "the project's folder")->capture_default_str();
    command->add_option("--build", options.build, "folder with a built firmware; build/release without it");
    command->add_option("--html", options.out,
                        "folder for misra.html, misra.sarif, compliance.md; BUILD/misra without it");
    auto* review = command->add_subcommand("review", "record that a person judged a file for a guideline");
    review->add_option("FILE", options.review_file, "as the finding names it")->required();
    review->add_option("RULE", options.review_rule)->required();
    review->add_option("--by", options.reviewer, "who judged")->required();
    review->add_option("--judgement", options.judgement, "what was looked at, and why it holds")->required();
    command->callback([&chosen] { chosen = [] { return check_misra(options); }; });
}

void add_evidence(CLI::App& app, std::function<int()>& chosen) {
    static EvidenceOptions options;
    auto* command = app.add_subcommand("evidence", "write the pack: what is claimed, what shows it, what is open");
    command->add_option("--out", options.out, "folder to write")->capture_default_str();
    command->add_option("--root", options.root, "the project's folder")->capture_default_str();
    command->add_option("--verdicts", options.verdicts,
                        "folder of test results; the newest of build/*/verdicts without it");
    command->add_option("--coverage", options.coverage,
                        "what tests/coverage measured; build/coverage/coverage.json without it");
    command->add_option("--exhibits", options.exhibits, "folder of results of other tools; build/exhibits without it");
    command->callback([&chosen] { chosen = [] { return write_evidence(options); }; });
}

void add_mutate(CLI::App& app, std::function<int()>& chosen) {
    static MutateOptions options;
    auto* command = app.add_subcommand("mutate", "alters each generated cell and asks whether a test notices");
    command->add_option("SUBJECT", options.subject,
                        "a device or an id, with --code part of a file's path; everything without");
    command->add_flag("--code", options.code, "the firmware's operators and conditions instead of generated cells");
    command->add_option("--root", options.root, "the project's folder")->capture_default_str();
    command->add_option("--programs", options.programs, "folder of the test programs; build/mutation without it");
    command->add_option("--sample", options.sample, "only so many cells, drawn by --seed");
    command->add_option("--seed", options.seed, "of the sample")->capture_default_str();
    command->add_option("--jobs", options.jobs, "processes at a time")->capture_default_str()->check(CLI::Range(1, 64));
    command->callback([&chosen] { chosen = [] { return mutate(options); }; });
}

void add_diff(CLI::App& app, std::function<int()>& chosen) {
    static DiffOptions options;
    auto* command = app.add_subcommand("diff", "what the changes since a revision touch: items, code, tests, verdicts");
    command->add_option("REVISION", options.revision, "a commit, branch or tag of git")->required();
    command->add_option("--root", options.root, "the project's folder")->capture_default_str();
    command->add_option("--verdicts", options.verdicts,
                        "folder of test results; the newest of build/*/verdicts without it");
    command->add_option("--old-verdicts", options.old_verdicts, "results of the revision: tells whose verdict differs");
    command->callback([&chosen] { chosen = [] { return diff(options); }; });
}

/// Whatever failed because standard output did has that for a reason.
std::string why(const std::exception& error) {
    try {
        finish_standard_output();
    } catch (const InputError& output) {
        return output.what();
    }
    return error.what();
}

int run_chosen(CLI::App& app, const std::function<int()>& chosen, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : wrong_use;
    }
    return chosen();
}

}  // namespace

int run_command_line(int argc, char** argv) {
    keep_standard_descriptors();
    CLI::App app{"canproof: four CANopen devices, generated from their requirements"};
    app.require_subcommand(1);
    std::function<int()> chosen;
    add_catalogue(app, chosen);
    add_new(app, chosen);
    add_running(app, chosen);
    add_fuzz(app, chosen);
    add_audit(app, chosen);
    add_coverage(app, chosen);
    add_misra(app, chosen);
    add_evidence(app, chosen);
    add_mutate(app, chosen);
    add_diff(app, chosen);
    try {
        const int status = run_chosen(app, chosen, argc, argv);
        finish_standard_output();
        return status;
    } catch (const std::exception& error) {
        std::cerr << "canproof: " << why(error) << '\n';
        return wrong_use;
    }
}

}  // namespace canproof::host
