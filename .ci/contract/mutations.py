"""Sends damaged requests, and checks how the server bears them.

Every answer has to be a 2xx or a problem document of a 4xx, whole and in time, while /healthz goes on answering. The request
number N of a seed is always the same: SEED=… FIRST=N COUNT=1 sends it alone.
"""

import http.client
import json
import os
import sys
import threading
import time
from pathlib import Path
from random import Random
from urllib.parse import urlsplit

from damaged import Sources

ANSWER_WITHIN = 20.0
HEALTH_WITHIN = 5.0
# The server closes on a longer head without reading what follows, which a client that still writes may see as a reset.
LARGEST_HEAD = 16 << 10
MOST_FAILURES = 20
KEPT = Path(".ci/.cache/mutations")


def fault_of(status, headers, body):
    """What is wrong with an answer."""
    kind = headers.get("Content-Type", "")
    if status in (414, 431):
        return None  # hyper's own answer to a line or a head beyond its bound
    if not headers.get("X-Request-Id"):
        return "no request id"
    if 400 <= status < 500:
        if kind != "application/problem+json":
            return f"a {status} of {kind}"
        problem = json.loads(body)
        if problem["status"] != status or not problem["detail"] or len(body) > 20_000:
            return f"a {status} whose document says {problem['status']} in {len(body)} bytes"
        return None
    if not 200 <= status < 300:
        return f"status {status}"
    if kind.startswith("application/json"):
        json.loads(body, parse_constant=not_json)
    return None


def not_json(word):
    raise ValueError(f"{word} in an answer")


class Watch(threading.Thread):
    """Asks all the time whether the server is alive."""

    def __init__(self, address):
        super().__init__(daemon=True)
        self.address, self.slowest, self.failures, self.ends = address, 0.0, [], threading.Event()

    def run(self):
        while not self.ends.wait(0.2):
            start = time.monotonic()
            try:
                status, _, _ = answer(self.address, "GET", "/healthz", {}, None)
            except OSError as error:
                status = error
            took = time.monotonic() - start
            self.slowest = max(self.slowest, took)
            if status != 200 or took > HEALTH_WITHIN:
                self.failures.append(f"/healthz: {status} after {took:.1f} s")


def answer(address, method, path, headers, body):
    connection = http.client.HTTPConnection(address, timeout=ANSWER_WITHIN)
    try:
        connection.request(method, path, body, headers)
        response = connection.getresponse()
        return response.status, response.headers, response.read()
    finally:
        connection.close()


def main():
    address = urlsplit(os.environ["BASE_URL"]).netloc
    seed, first = int(os.environ["SEED"]), int(os.environ.get("FIRST", 0))
    count = int(os.environ.get("COUNT", 40_000))

    def asked(path):
        return json.loads(answer(address, "GET", path, {}, None)[2])

    sets = [of["id"] for of in asked("/v1/validation")["sets"]]
    sources = Sources(asked("/openapi.json"), [asked(f"/v1/validation/{name}") for name in sets])
    watch = Watch(address)
    watch.start()
    statuses, slowest, failures = {}, (0.0, 0), []
    for number in range(first, first + count):
        request = sources.request(Random(f"{seed} {number}"))
        start = time.monotonic()
        try:
            status, headers, body = answer(address, *request)
            fault = fault_of(status, headers, body)
            statuses[status] = statuses.get(status, 0) + 1
        except (BrokenPipeError, ConnectionResetError) as error:
            head = len(request[1]) + sum(len(f"{name}{value}") for name, value in request[2].items())
            fault = None if head > LARGEST_HEAD - 1024 else f"{type(error).__name__}: {error}"
        except (OSError, http.client.HTTPException, ValueError, KeyError) as error:
            fault = f"{type(error).__name__}: {error}"
        took = time.monotonic() - start
        slowest = max(slowest, (took, number))
        if fault or took > ANSWER_WITHIN:
            KEPT.mkdir(parents=True, exist_ok=True)
            (KEPT / str(number)).write_bytes(f"{request[:3]}\n\n".encode() + (request[3] or b""))
            failures.append(f"request {number}, {request[0]} {request[1][:80]}, after {took:.1f} s: {fault}")
            print(failures[-1], file=sys.stderr, flush=True)
        if len(failures) == MOST_FAILURES:
            break
    watch.ends.set()
    watch.join()
    failures += watch.failures
    print(f"{sum(statuses.values())} answers by status: {dict(sorted(statuses.items()))}")
    print(f"the slowest took {slowest[0]:.1f} s (request {slowest[1]}), /healthz {watch.slowest:.2f} s at most")
    if failures:
        sys.exit("\n".join([*failures, f"the requests are in {KEPT}; repeat one with SEED={seed} FIRST=… COUNT=1"]))


main()
