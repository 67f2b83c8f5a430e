# SPDX-License-Identifier: Apache-2.0
"""Runs scripts with python-can fast. The import of python-can takes seconds in the guest, so one process imports it and forks for each
script."""
import os
import sys
import traceback

ASK, ANSWER, OUTPUT = "/tmp/python.ask", "/tmp/python.answer", "/tmp/python.output"

# A replacement for `python3`, which supports only `python3 -c SCRIPT`.
COMMAND = f"""#!/bin/sh
[ "$1" = -c ] || exit 2
printf %s "$2" >{ASK}
read -r status <{ANSWER}
cat {OUTPUT}
exit "$status"
"""


def start():
    for path in (ASK, ANSWER):
        os.mkfifo(path)
    if os.fork() == 0:
        import can  # before the forks, so that each script has the module already
        while True:
            serve()


def serve():
    with open(ASK) as ask:
        script = ask.read()
    child = os.fork()
    if child == 0:
        run(script)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    with open(ANSWER, "w") as answer:
        answer.write(f"{status}\n")


def run(script):
    output = os.open(OUTPUT, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(output, 1)
    os.dup2(output, 2)
    status = 1
    try:
        exec(compile(script, "-c", "exec"), {"__name__": "__main__"})
        status = 0
    except BaseException:  # as the interpreter does
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


def ask(script):
    """Returns (exit status, output) of a script."""
    with open(ASK, "w") as to:
        to.write(script)
    with open(ANSWER) as answer:
        status = int(answer.read())
    with open(OUTPUT) as output:
        return status, output.read()
