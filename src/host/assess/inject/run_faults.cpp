// SPDX-License-Identifier: Apache-2.0
#include "host/assess/inject/run_faults.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "host/base/input_error.hpp"
#include "host/sim/devices/advance_device.hpp"

namespace canproof::host {

namespace {

// Exit status of a process that ran with a fault and could not determine the fault's effect. A smaller exit status is
// the number of the effect (FaultEffect).
constexpr int not_judged = 100;

struct Texts {
    std::string frames;
    std::string outputs;
};

Texts play(SimulatedDevice& device, const ReplayInput& input) {
    std::ostringstream frames;
    std::ostringstream outputs;
    replay(device, input, frames, &outputs);
    return {frames.str(), outputs.str()};
}

/// Redirects standard error to /dev/null, because the libraries print messages when a damaged object ends the process.
void be_quiet() {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere < 0 || dup2(nowhere, STDERR_FILENO) < 0) {
        _exit(not_judged);
    }
}

/// Limits the processor time of this process to the next whole second above `seconds`, and forbids core files. At the
/// limit, the kernel ends the process with SIGXCPU.
void limit_time(double seconds) {
    const auto whole = static_cast<rlim_t>(seconds + 1.0);
    const rlimit limit{whole, whole + 1};
    if (setrlimit(RLIMIT_CPU, &limit) != 0) {
        _exit(not_judged);
    }
    const rlimit no_core{0, 0};
    if (setrlimit(RLIMIT_CORE, &no_core) != 0) {
        _exit(not_judged);
    }
}

/// Converts the exit status of the process that ran with a fault into the effect of this fault. Throws InputError when
/// the process could not determine the effect.
FaultEffect effect_of_status(int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) < static_cast<int>(fault_effects)) {
        return static_cast<FaultEffect>(WEXITSTATUS(status));
    }
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU || signal == SIGKILL) {
            return FaultEffect::watchdog;
        }
        return FaultEffect::processor_fault;
    }
    throw InputError{
        "the effect of a fault cannot be determined: the process with the fault could not open /dev/null or limit its "
        "processor time; check /dev/null and `ulimit -t`"};
}

/// Plays the workload once. Before the call at which a fault of the shard is due, starts the process that runs with
/// this fault. A damaged index or pointer may read memory outside the device. The heap therefore has the same content
/// in each shard: this class keeps the faults of all shards, and allocates nothing for a fault.
class Injector {
  public:
    Injector(SimulatedDevice& device, const std::vector<InjectedFault>& faults, const DeviceRun& faultless,
             std::size_t calls, const InjectionOptions& options, const std::function<void(std::size_t)>& progress)
        : device_{device},
          faults_{faults},
          faultless_{faultless},
          calls_{calls},
          options_{options},
          progress_{progress} {
        effects_.resize(faults.size());
        running_.reserve(options.jobs);
    }

    std::vector<FaultEffect> run(ReplayInput input) {
        input.before_call = [this] { inject(); };
        try {
            const Texts texts = play(device_, input);
            if (is_child_) {
                end(effect_of(faultless_, read_run(texts.frames, texts.outputs)));
            }
        } catch (const StuckDevice&) {
            if (!is_child_) {
                throw;
            }
            end(FaultEffect::watchdog);
        } catch (const std::exception&) {
            if (!is_child_) {
                throw;
            }
            end(FaultEffect::processor_fault);  // the exception means that a standard function refused a value that the
                                                // fault had damaged
        }
        while (!running_.empty()) {
            wait_for_one();
        }
        return effects_;
    }

  private:
    std::size_t most_calls() const { return 4 * calls_ + 10'000; }
    [[noreturn]] static void end(FaultEffect effect) { _exit(static_cast<int>(effect)); }

    /// Starts the process of each fault whose call is next. In that process, limits the number of calls: far too many
    /// calls count as the effect `watchdog`.
    void inject() {
        if (is_child_) {
            if (++call_ > most_calls()) {
                end(FaultEffect::watchdog);
            }
            return;
        }
        for (; next_ < faults_.size() && faults_[next_].call == call_; ++next_) {
            if (!options_.shard.holds(next_)) {
                continue;
            }
            while (running_.size() >= options_.jobs) {
                wait_for_one();
            }
            const pid_t process = fork();
            if (process < 0) {
                throw InputError{fmt::format("cannot start a process: {}; close other programs", std::strerror(errno))};
            }
            if (process == 0) {
                is_child_ = true;
                be_quiet();
                limit_time(options_.most_seconds);
                turn(faults_[next_]);
                return;
            }
            running_.emplace_back(process, next_);
        }
        ++call_;
    }

    void turn(const InjectedFault& fault) {
        const MemoryRegion region = device_.regions().at(fault.region);
        region.data[fault.byte] = static_cast<std::uint8_t>(region.data[fault.byte] ^ (1U << fault.bit));
    }

    void wait_for_one() {
        int status = 0;
        const pid_t process = waitpid(-1, &status, 0);
        if (process < 0) {
            if (errno == EINTR) {
                return;
            }
            throw InputError{
                fmt::format("cannot wait for the end of a run: {}; start this program with SIGCHLD not ignored",
                            std::strerror(errno))};
        }
        const auto found =
            std::find_if(running_.begin(), running_.end(), [process](const auto& one) { return one.first == process; });
        if (found != running_.end()) {
            effects_[found->second] = effect_of_status(status);
            running_.erase(found);
            progress_(++ended_);
        }
    }

    SimulatedDevice& device_;
    const std::vector<InjectedFault>& faults_;
    const DeviceRun& faultless_;
    std::size_t calls_;  ///< number of calls in the run without a fault
    const InjectionOptions& options_;
    const std::function<void(std::size_t)>& progress_;
    std::vector<FaultEffect> effects_;
    /// running processes, each with the number of its fault in `faults_`
    std::vector<std::pair<pid_t, std::size_t>> running_;
    std::size_t next_{0};  ///< number of the next fault in `faults_`
    std::size_t call_{0};
    std::size_t ended_{0};
    bool is_child_{false};
};

InjectionCampaign run_in_this_thread(const MakeDevice& make, const ReplayInput& input, const InjectionOptions& options,
                                     const std::function<void(std::size_t)>& progress) {
    InjectionCampaign campaign;
    auto device = make();
    for (const MemoryRegion& region : device->regions()) {
        campaign.regions.push_back({region.name, region.size});
    }
    if (campaign.regions.empty()) {
        throw InputError{"the memory layout of this device is not known; name a device that `canproof devices` lists"};
    }
    ReplayInput counted = input;
    counted.before_call = [&campaign] { ++campaign.calls; };
    const Texts texts = play(*device, counted);
    const DeviceRun faultless = read_run(texts.frames, texts.outputs);
    const auto faults = plan_faults(options.seed, options.faults, campaign.calls, campaign.regions);
    device = make();
    const auto effects = Injector{*device, faults, faultless, campaign.calls, options, progress}.run(input);
    for (std::size_t i = 0; i < faults.size(); ++i) {
        if (options.shard.holds(i)) {
            campaign.runs.push_back({faults[i], effects[i]});
        }
    }
    return campaign;
}

}  // namespace

InjectionCampaign run_faults(const MakeDevice& make, const ReplayInput& input, const InjectionOptions& options,
                             const std::function<void(std::size_t)>& progress) {
    InjectionCampaign campaign;
    std::exception_ptr failure;
    // glibc gives a new thread a heap of its own. Earlier allocations of the program do not change the device's
    // addresses in this heap.
    std::thread run{[&] {
        try {
            campaign = run_in_this_thread(make, input, options, progress);
        } catch (...) {
            failure = std::current_exception();
        }
    }};
    run.join();
    if (failure) {
        std::rethrow_exception(failure);
    }
    return campaign;
}

}  // namespace canproof::host
