// The command line: one function a command. Exit status 0 done, 1 the thing checked does not hold, 2 wrong use or
// unreadable input.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/assess/fuzz/campaign.hpp"
#include "host/assess/trace/audit.hpp"

namespace canproof::host {

struct ReplayOptions {
    std::string device;
    std::string eds;                  ///< file; instead of `device`
    std::string log;                  ///< file, or - for standard input
    std::optional<std::string> node;  ///< as shipped without it
    std::vector<std::string> factory;
    std::string nvm;
    std::string stimulus;
    std::string outputs;
    std::optional<double> start;
    std::optional<double> until;
};

struct RunOptions {
    std::vector<std::string> devices;  ///< NAME or NAME@NODE; none here and in `eds`: the whole catalogue
    std::vector<std::string> eds;      ///< FILE or FILE@NODE
    std::vector<std::string> factory;  ///< KEY=VALUE or DEVICE.KEY=VALUE
    std::string bus{"inproc"};         ///< inproc, socketcan:INTERFACE, socketcand[:HOST:PORT],
                                       ///< socketcand-client:HOST:PORT[/BUS]
    std::string bus_faults;            ///< of the in-process bus, see parse_bus_faults()
    bool control_interface{false};     ///< the run may set an interface's bit rate and restart its controller
    bool plain{false};                 ///< no table, even on a terminal
    std::string log;                   ///< log of all frames; .pcapng for that format
    bool log_marks{false};             ///< T and R behind the frames of a candump log
    std::string nvm;                   ///< folder with one memory image a device
    std::string stimulus;
    std::string outputs;
    std::optional<double> seconds;
};

struct PanelOptions {
    RunOptions run;            ///< `plain` and `seconds` mean nothing here
    std::uint16_t port{8404};  ///< 0: any that is free
};

struct AuditOptions {
    std::string root{"."};
    std::string subject;  ///< device, id, section, source file, test or nothing
    std::string verdicts;
    AuditFilter filter;
};

struct NewOptions {
    std::string name;    ///< of folder and device
    std::string eds;     ///< file: EDS, DCF or XDD; empty: the template's objects
    std::string manual;  ///< title; empty: from the device
    std::string prefix;  ///< of its ids; empty: from the name
};

struct ReviewOptions {
    std::string spec{"spec"};
    std::vector<std::string> subjects;  ///< ids or devices
    bool all{false};
    std::string by;
    std::string date;  ///< 2026-11-21; empty: today
};

struct MutateOptions {
    std::string root{"."};
    std::string programs;  ///< folder; empty: build/mutation below the root
    std::string subject;   ///< device, id or nothing; of code: part of a file's path
    bool code{false};      ///< mutants of the firmware's code instead of generated cells
    std::size_t sample{0};
    std::uint64_t seed{1};
    unsigned jobs{2};
};

struct DiffOptions {
    std::string root{"."};
    std::string revision;
    std::string verdicts;
    std::string old_verdicts;
};

struct EvidenceOptions {
    std::string root{"."};
    std::string out{"reports/out"};
    std::string verdicts;  ///< folders and files; where the builds leave them when empty
    std::string coverage;
    std::string exhibits;
};

struct CoverageOptions {
    std::string root{"."};
    std::string measured{"build/coverage/coverage.json"};  ///< what `llvm-cov export` wrote
    std::string cobertura;                                 ///< file to write, none when empty
    bool records_only{false};                              ///< nothing measured: records against the sources
};

struct PlotOptions {
    std::string csv;  ///< what --outputs wrote
    std::string svg;  ///< file to write
    std::vector<std::string> signals;
};

struct MisraOptions {
    std::string root{"."};
    std::string build;        ///< folder with a built firmware; build/release or build/debug without it
    std::string out;          ///< folder for misra.sarif, compliance.md and misra.html; BUILD/misra without it
    std::string review_file;  ///< instead of a check: record that `reviewer` judged this file for `review_rule`
    std::string review_rule;
    std::string reviewer;
    std::string judgement;
};

int write_new_project(const NewOptions& options);
int list_devices();
int list_signals(const std::string& device);
int print_eds(const std::string& device, const std::string& format);
int check_spec(const std::string& spec);
int replay_log(const ReplayOptions& options);
int run_devices(const RunOptions& options);
int run_panel(const PanelOptions& options);
int play_examples();
int plot_outputs(const PlotOptions& options);
int draw_figures(const std::string& folder);
int fuzz_targets(const CampaignOptions& options);
int audit(const AuditOptions& options);
int write_evidence(const EvidenceOptions& options);
int check_coverage(const CoverageOptions& options);
int check_misra(const MisraOptions& options);
int review_spec(const ReviewOptions& options);
int mutate(const MutateOptions& options);
int diff(const DiffOptions& options);

int run_command_line(int argc, char** argv);

}  // namespace canproof::host
