// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "generated/version.hpp"
#include "host/app/cli/assess_commands.hpp"
#include "host/app/cli/catalogue_commands.hpp"
#include "host/app/cli/command.hpp"
#include "host/app/cli/command_tree.hpp"
#include "host/app/cli/conform_command.hpp"
#include "host/app/cli/demo_command.hpp"
#include "host/app/cli/eds_check_command.hpp"
#include "host/app/cli/figures_command.hpp"
#include "host/app/cli/new_command.hpp"
#include "host/app/cli/option_rules.hpp"
#include "host/app/cli/panel_command.hpp"
#include "host/app/cli/plot_command.hpp"
#include "host/app/cli/replay_command.hpp"
#include "host/app/cli/review_command.hpp"
#include "host/app/cli/run_arguments.hpp"
#include "host/app/cli/run_command.hpp"
#include "host/app/cli/shell_completion.hpp"
#include "host/app/cli/spec_command.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/standard_streams.hpp"

namespace canproof::host {

namespace {

constexpr int wrong_use = 2;

class CatalogueCommands : Command {
  public:
    CatalogueCommands(CLI::App& app, Chosen& chosen) {
        app.add_subcommand("devices", "list the devices: part numbers, node-ID and bit rate as shipped")
            ->callback([&chosen] { chosen = list_devices; });
        auto* signals =
            app.add_subcommand("signals", "list physical inputs and outputs of a device, and its factory data");
        signals->add_option("DEVICE", shown_)->required();
        signals->callback([this, &chosen] { chosen = [this] { return list_signals(shown_); }; });

        add_eds(app, chosen);
    }

  private:
    void add_eds(CLI::App& app, Chosen& chosen) {
        auto* eds = app.add_subcommand("eds", "print the electronic data sheet of a device, or its frames as DBC");
        eds->add_option("DEVICE", printed_.device, "device; with --format dbc also an EDS, DCF or XDD file");
        eds->add_option("--format", printed_.format,
                        "eds, eds-lely (reals as bits, for Lely's tools), xdd, json, md, or dbc (its frames, "
                        "for tools that decode logs)")
            ->check(CLI::IsMember({"eds", "eds-lely", "xdd", "json", "md", "dbc"}));
        eds->add_option("--node", printed_.node, "node-ID of the frames in a DBC; default: as shipped")
            ->check(CLI::Range(1, 127));
        auto* check = eds->add_subcommand("check", "list the faults of an EDS or DCF file, with line, fix and source");
        check->add_option("FILE", checked_.file);
        check->add_option("--fix", checked_.fix, "file to write with all safe fixes; may be FILE itself");
        check->add_flag("--json", checked_.json, "findings as JSON");
        check->add_flag("--strict", checked_.strict, "exit status 1 for warnings, as for errors");
        auto* rules =
            check->add_flag("--rules", checked_.rules, "list every rule with its fix and source; needs no file");
        stands_alone(*check, rules, {"--json"});
        leaves_out_options(*eds, *check, {});
        check->callback([this, &chosen] {
            if (checked_.file.empty() && !checked_.rules) {
                throw CLI::RequiredError{"FILE"};
            }
            chosen = [this] { return check_eds_file(checked_); };
        });
        eds->callback([this, check, &chosen] {
            if (check->parsed()) {
                return;  // the subcommand has set `chosen` already
            }
            if (printed_.device.empty()) {
                throw CLI::RequiredError{"DEVICE"};
            }
            chosen = [this] { return print_eds(printed_); };
        });
    }

    std::string shown_;
    EdsOptions printed_;
    EdsCheckOptions checked_;
};

class SpecCommands : Command {
  public:
    SpecCommands(CLI::App& app, Chosen& chosen) {
        auto* spec = app.add_subcommand("spec", "check, list and review the requirements register");
        spec->require_subcommand(1);
        auto* check =
            spec->add_subcommand("check", "list every fault and warning of a register, with file, line and fix");
        check->add_option("--spec", checked_.spec, "folder of the requirements register")->capture_default_str();
        check->add_flag("--strict", checked_.strict, "exit status 1 for warnings, as for faults");
        check->add_flag("--json", checked_.json, "faults and warnings as JSON");
        check->callback([this, &chosen] { chosen = [this] { return check_spec(checked_); }; });
        auto* statements = spec->add_subcommand(
            "statements", "list a manual's normative statements by section, and the items that cover them");
        statements->add_option("KEY", statements_.key, "key of the manual: AX130751")->required();
        statements->add_option(
            "--text", statements_.text,
            "text version of the manual: check that it has all passages, and list text without a statement");
        statements->add_option("--spec", statements_.spec, "folder of the requirements register")
            ->capture_default_str();
        statements->callback([this, &chosen] { chosen = [this] { return list_statements(statements_); }; });
        auto* review = spec->add_subcommand("review",
                                            "record that somebody has read items with their code and tests, or "
                                            "sections of a manual with their disposition");
        review->add_option("ID", review_.subjects, "ids of items, ids of sections such as AX188001:3.2.8, or devices");
        review->add_flag("--all", review_.all, "every item and section that has no review of its present form");
        review->add_option("--by", review_.by, "name of the reader")->check(utf8_text());
        review->add_flag(
            "--mark", review_.mark,
            "record hashes of the present code and tests of reviewed items; does not claim that someone has read them");
        review->add_flag(
            "--wording", review_.wording,
            "record that only the texts of the items were read; their code and tests are recorded as by --mark");
        review->add_option("--role", review_.role, "role of the reader: author of the change, or independent of it")
            ->check(CLI::IsMember({"author", "independent"}));
        review->add_option("--verdicts", review_.verdicts,
                           "folder of test results; default: the newest of build/{release,debug,coverage}/verdicts");
        review->add_option("--date", review_.date, "YYYY-MM-DD; default: today");
        review->add_option("--spec", review_.spec, "folder of the requirements register")->capture_default_str();
        review->callback([this, &chosen] { chosen = [this] { return review_spec(review_); }; });
    }

  private:
    SpecCheckOptions checked_;
    StatementsOptions statements_;
    ReviewOptions review_;
};

class NewCommand : Command {
  public:
    NewCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand(
            "new", "create a project for a device of your own; the project builds and passes its tests");
        command->add_option("NAME", options_.name, "name of folder and device: small letters, digits, single dashes")
            ->required();
        command->add_option("--eds", options_.eds, "EDS, DCF or XDD file with identity and objects");
        command->add_option("--manual", options_.manual, "title of the device's manual")->check(utf8_text());
        command->add_option(
            "--prefix", options_.prefix,
            "prefix of the ids of requirements and decisions, in capital letters; default: from the name");
        command->callback([this, &chosen] { chosen = [this] { return write_new_project(options_); }; });
    }

  private:
    NewOptions options_;
};

class RunCommands : Command {
  public:
    RunCommands(CLI::App& app, Chosen& chosen) {
        auto* run =
            app.add_subcommand("run", "run devices in real time on a bus; without a device the whole catalogue");
        add_run_options(*run, run_);
        run->add_option("--seconds", run_.seconds, "end the run after this time")->check(seconds_check());
        run->add_flag("--plain", run_.plain, "print every frame as a line, even on a terminal");
        run->callback([this, &chosen] { chosen = [this] { return run_devices(run_); }; });

        auto* panel = app.add_subcommand("panel", "run devices as `run` does, and show them on a local page");
        add_run_options(*panel, panel_.run);
        panel->add_option("--port", panel_.port, "port on the loopback address; 0: any free port")
            ->check(CLI::Range(0, 65535))
            ->capture_default_str();
        panel->callback([this, &chosen] { chosen = [this] { return run_panel(panel_); }; });
    }

  private:
    RunOptions run_;
    PanelOptions panel_;
};

class ReplayCommand : Command {
  public:
    ReplayCommand(CLI::App& app, Chosen& chosen) {
        auto* replay = app.add_subcommand("replay", "play a candump log to one device in virtual time");
        replay->add_option("DEVICE LOG", words_, "device (not with --eds), then a candump log, or - for standard input")
            ->required()
            ->expected(1, 2);
        replay->add_option("--eds", options_.eds, "EDS, DCF or XDD file that describes the device");
        replay->add_option("--node", options_.node, node_help);
        replay->add_option("--factory", options_.factory, factory_help)->allow_extra_args(false);
        replay->add_option("--nvm", options_.nvm, "file that keeps the stored parameters");
        replay->add_option("--stimulus", options_.stimulus,
                           "CSV file with lines seconds,signal,value: changes of inputs");
        replay->add_option("--outputs", options_.outputs, "CSV file to write changes of outputs to");
        replay->add_option("--until", options_.until, "end of the replay, in seconds of the log's time")
            ->check(seconds_check());
        replay
            ->add_option(
                "--start", options_.start,
                "power-on, in seconds of the log's time; default: 0, or the first frame of a log with clock times")
            ->check(seconds_check());
        replay->callback([this, &chosen] {
            take_words();
            chosen = [this] { return replay_log(options_); };
        });
    }

  private:
    void take_words() {
        if (words_.size() != (options_.eds.empty() ? 2U : 1U)) {
            throw CLI::ValidationError{"replay", "write DEVICE LOG, or --eds FILE LOG"};
        }
        options_.device = options_.eds.empty() ? words_.front() : "";
        options_.log = words_.back();
    }

    ReplayOptions options_;
    std::vector<std::string> words_;  ///< the positional arguments: DEVICE and LOG; with --eds only LOG
};

class ConformCommand : Command {
  public:
    ConformCommand(CLI::App& app, Chosen& chosen) {
        auto* command = app.add_subcommand(
            "conform", "test whether a CANopen slave conforms to CiA 301 and CiA 305; exit status 0 or 1");
        command->add_option("DEVICE", options_.device,
                            "device of the catalogue; it runs in virtual time without --bus");
        command->add_option("--eds", options_.eds, "EDS, DCF or XDD file of the slave");
        command->add_option(
            "--arm", options_.arm,
            "build/target/bridged_NAME.elf: run this image of the slave on an STM32F405 in QEMU, in virtual time");
        command->add_option("--node", options_.node, "node-ID of the slave; default: that of the data sheet");
        command->add_option("--bus", options_.bus,
                            "socketcan:can0 or socketcand-client:127.0.0.1:29536; default: no bus, in virtual time");
        auto* list = command->add_flag("--list", options_.list, "list all cases");
        command->add_option("--only", options_.only, "only the cases of these services: sdo,lss")
            ->delimiter(',')
            ->allow_extra_args(false);
        command->add_option("--skip", options_.skip, "cases or services to leave out")
            ->delimiter(',')
            ->allow_extra_args(false);
        command
            ->add_option("--case", options_.cases,
                         "only these cases, by their id or by their number in the public transcript (see --list)")
            ->delimiter(',')
            ->allow_extra_args(false);
        command->add_option("--cases", options_.folder, "folder with cases that replace those of the program");
        command->add_option("--report", options_.report, "folder for the report as HTML, JUnit, JSON and text");
        command->add_flag("--json", options_.json, "the report as JSON instead of lines");
        command->add_flag("--allow-outputs", options_.allow_outputs, "allow cases that may move an output");
        command->add_flag("--allow-store", options_.allow_store, "allow cases that store parameters");
        command->add_flag("--allow-lss", options_.allow_lss, "allow cases that change node-ID or bit rate");
        command->add_flag("--by-hand", options_.by_hand, "you switch the slave off and on when the program asks");
        command->add_flag("--no-remote-frames", options_.no_remote_frames,
                          "the adapter carries no remote frames: cases that need them are skipped");
        command->add_option("--traffic", options_.traffic, "load that background traffic adds to the bus, in per cent")
            ->check(number_from(0.0, 95.0));
        stands_alone(*command, list, {"--cases", "--json"});
        command->callback([this, &chosen] { chosen = [this] { return run_conform(options_); }; });
    }

  private:
    ConformCommandOptions options_;
};

class DrawingCommands : Command {
  public:
    DrawingCommands(CLI::App& app, Chosen& chosen) {
        app.add_subcommand("demo", "show the devices' answers to the worked examples of their manuals")
            ->callback([&chosen] { chosen = play_examples; });
        auto* plot = app.add_subcommand("plot", "draw the CSV file that --outputs of `run`, `panel` or `replay` wrote");
        plot->add_option("CSV", plot_.csv)->required();
        plot->add_option("SVG", plot_.svg)->required();
        plot->add_option("--signals", plot_.signals, "aout1,aout2: signals to draw; default: all that change")
            ->delimiter(',')
            ->allow_extra_args(false);
        plot->callback([this, &chosen] { chosen = [this] { return plot_outputs(plot_); }; });

        auto* draw = app.add_subcommand("figures", "draw the behaviour of the devices: SVG files in a folder");
        draw->add_option("FOLDER", figures_)->required();
        draw->callback([this, &chosen] { chosen = [this] { return draw_figures(figures_); }; });
    }

  private:
    PlotOptions plot_;
    std::string figures_;
};

class WordsCommands : Command {
  public:
    WordsCommands(CLI::App& app, Chosen& chosen) {
        auto* completion =
            app.add_subcommand("completion", "print the completion of a shell, for its `source` command");
        completion->add_option("SHELL", shell_, "bash, zsh or fish")
            ->required()
            ->check(CLI::IsMember({"bash", "zsh", "fish"}));
        completion->callback([this, &app, &chosen] {
            chosen = [this, &app] {
                std::cout << shell_completion(command_tree(app), shell_);
                return 0;
            };
        });
        auto* manual = app.add_subcommand("manual", "print a manual page: `canproof manual eds | man -l -`");
        manual->add_option("COMMAND", manual_of_,
                           "command, for example `eds check`; default: the page of the whole program");
        auto* const folder =
            manual->add_option("--out", manual_folder_, "folder to write: the page of the program and of each command");
        manual->get_option("COMMAND")->excludes(folder);
        manual->callback([this, &app, &chosen] { chosen = [this, &app] { return write_manual(command_tree(app)); }; });
    }

  private:
    int write_manual(const std::vector<CommandWords>& commands) const {
        if (manual_folder_.empty()) {
            std::cout << manual_page(commands, manual_of_, generated::canproof_version);
            return 0;
        }
        for (const auto& [name, page] : manual_pages(commands, generated::canproof_version)) {
            write_file(std::filesystem::path{manual_folder_} / name, page);
        }
        return 0;
    }

    std::string shell_;
    std::vector<std::string> manual_of_;
    std::string manual_folder_;
};

/// Returns the message of an error. For a file system error, builds a message with the path and the reason.
std::string message_of(const std::exception& error) {
    const auto* const path = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    return path == nullptr ? error.what()
                           : fmt::format("cannot use {}: {}; correct this or name another path", path->path1().string(),
                                         path->code().message());
}

/// Returns the text of `error`. If standard output has failed, returns the text of that failure instead, because that
/// failure is the cause.
std::string why(const std::exception& error) {
    try {
        finish_standard_output();
    } catch (const InputError& output) {
        return output.what();
    }
    return message_of(error);
}

int run_chosen(CLI::App& app, const Chosen& chosen, int argc, char** argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // --help or --version
            return app.exit(error);
        }
        const std::string no_command = CLI::RequiredError::Subcommand(1).what();
        const std::vector<std::string> words{argv + 1, argv + argc};
        throw InputError{error.what() == no_command ? no_command_words(app, words)
                                                    : usage_error_words(app, words, error.what())};
    }
    return chosen();
}

}  // namespace

int run_command_line(int argc, char** argv) {
    keep_standard_descriptors();
    CLI::App app{"canproof: four CANopen devices, generated from their requirements"};
    app.set_version_flag("--version", std::string{"canproof "} + generated::canproof_version,
                         "print the version and exit");
    app.require_subcommand(1);
    Chosen chosen;
    CatalogueCommands catalogue_command{app, chosen};
    SpecCommands spec_command{app, chosen};
    NewCommand new_command{app, chosen};
    ReplayCommand replay_command{app, chosen};
    RunCommands run_command{app, chosen};
    ConformCommand conform_command{app, chosen};
    DrawingCommands drawing_command{app, chosen};
    WordsCommands words_commands{app, chosen};
    const std::shared_ptr<void> assess_commands = add_assess_commands(app, chosen);
    check_values(app);
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
