#!/usr/bin/python3
"""stop.py PROGRAM: a run that is behind its bus says so, and still obeys Ctrl-C with status 0.

Twenty devices are told to send a SYNC each microsecond: 1006h (communication cycle period) 1, 1005h with bit 30 (producer). What the
end takes is counted in processor time, so that the load of the machine does not matter.
"""
import os
import signal
import subprocess
import sys

MOST_SECONDS = 0.5  # of processor time, from the signal to the end


def processor_seconds(pid):
    with open(f"/proc/{pid}/stat") as stat:
        fields = stat.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    nodes = range(1, 21)
    run = subprocess.Popen([sys.argv[1], "run", "--plain", *(f"cbx-ao412@{node}" for node in nodes)], stdin=subprocess.PIPE,
                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    try:
        for node in nodes:
            run.stdin.write(f"6{node:02X}#2306100001000000\n6{node:02X}#2305100080000040\n")
        run.stdin.flush()
        said = run.stderr.readline()
        assert "behind the bus" in said, f"said {said!r}"
        before = processor_seconds(run.pid)
        run.send_signal(signal.SIGINT)
        said = run.stderr.read()
        _, status, used = os.wait4(run.pid, 0)
        assert os.waitstatus_to_exitcode(status) == 0, f"ended with {status}: {said}"
        took = used.ru_utime + used.ru_stime - before
        assert took < MOST_SECONDS, f"the end took {took} s of processor time"
        assert "was up to" in said, f"said at the end {said!r}"
    finally:
        run.kill()
    print("a run that is behind says so and ends when it is told")


main()
