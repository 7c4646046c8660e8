"""cluster.py PROGRAM ARGUMENT...: runs a program with Dask in threads of one process, then on a cluster of two processes, of which one
is killed on the way. The line of sums that the program prints has to be the same.
"""

import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from distributed import Client

BIN = Path(sys.executable).parent
LONGEST = 120  # s


def sums(program):
    """The line of sums of a program that has ended well."""
    output, _ = program.communicate(timeout=LONGEST)
    if program.returncode != 0:
        sys.exit(f"the program ended with status {program.returncode}")
    return next(line for line in output.splitlines() if line.startswith("sums "))


def start(*command, **settings):
    return subprocess.Popen(command, env={**os.environ, **settings}, stdout=subprocess.PIPE, text=True)


def half_done(dask_scheduler):
    """Processes of workers that hold results and have more to do, by their names."""
    workers = dask_scheduler.workers.values()
    return [worker.name for worker in workers if worker.has_what and worker.processing]


def kill_on_the_way(address, workers, program):
    """Kills the first worker that holds results and has more to do; which one that was."""
    with Client(address) as client:
        end = time.monotonic() + LONGEST
        while program.poll() is None and time.monotonic() < end:
            if names := client.run_on_scheduler(half_done):
                workers[names[0]].send_signal(signal.SIGKILL)
                workers[names[0]].wait()
                if program.poll() is None:
                    return names[0]
                break
            time.sleep(0.005)
    sys.exit("the program had ended before a worker was killed")


def main(command):
    expected = sums(start(sys.executable, *command))
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scheduler.json"
        scheduler = start(
            BIN / "dask", "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", file
        )
        workers = {
            name: start(
                BIN / "dask", "worker", "--scheduler-file", file, "--name", name, "--nthreads", "1", "--no-nanny",
                "--no-dashboard", "--local-directory", folder,
            )
            for name in ("one", "two")
        }  # fmt: skip
        try:
            while not file.exists():
                time.sleep(0.1)
            with Client(scheduler_file=file) as client:
                client.wait_for_workers(2, timeout=LONGEST)
                address = client.scheduler.address
            program = start(sys.executable, *command, DASK_SCHEDULER_ADDRESS=address)
            killed = kill_on_the_way(address, workers, program)
            found = sums(program)
        finally:
            for process in (*workers.values(), scheduler):
                process.kill()
                process.wait()
    if found != expected:
        sys.exit(f"in one process: {expected}\non the cluster:  {found}")
    print(f"{command[0]}: the same {expected} in one process and on two, of which `{killed}` was killed on the way")


if __name__ == "__main__":
    main(sys.argv[1:])
