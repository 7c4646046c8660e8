"""Rows a second through /v1/batch on loopback, from 10^3 to 10^7 rows: time, processor time of the server, its memory at the most.

    cargo build --release && python benches/batch.py [LARGEST]

Needs numpy and pyarrow. The server runs as it does by default; the client sends rows that it made before, so that it takes little
processor time. Time is linear in the rows and memory does not grow with them.
"""

import http.client
import io
import os
import re
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy
import pyarrow
import pyarrow.ipc

PROGRAM = Path(__file__).resolve().parent.parent / "target/release/terramechanics"
ARROW = "application/vnd.apache.arrow.stream"
BLOCK = 10_000
TICK = os.sysconf("SC_CLK_TCK")


def block():
    random = numpy.random.default_rng(1)
    return pyarrow.record_batch({
        "soil.cohesion_pa": random.uniform(0, 500, BLOCK),
        "soil.friction_angle_rad": random.uniform(0.4, 0.6, BLOCK),
        "wheel.radius_m": random.uniform(0.2, 0.3, BLOCK),
        "slip": random.uniform(0.05, 0.6, BLOCK),
        "normal_load_n": random.uniform(50, 150, BLOCK),
        "sinkage_m": random.uniform(0.01, 0.03, BLOCK),
    })


def bodies(rows, form, columns):
    """The pieces of a body of so many rows, and whether they are chunks of one form."""
    batch = block().select(columns)
    if form == ARROW:
        sink = io.BytesIO()
        writer = pyarrow.ipc.new_stream(sink, batch.schema)
        writer.write_batch(batch.slice(0, 0))  # the schema goes out with the first batch
        head = sink.tell()
        writer.write_batch(batch)
        first, one = sink.getvalue()[:head], sink.getvalue()[head:]
        sink.seek(0)
        sink.truncate()
        writer.write_batch(batch.slice(0, rows % BLOCK))
        return first, one, rows // BLOCK, sink.getvalue() if rows % BLOCK else b"", b"\xff\xff\xff\xff\0\0\0\0"
    lines = [",".join(f"{value:.6g}" for value in row) + "\n" for row in zip(*(column.to_pylist() for column in batch.columns))]
    head = ",".join(columns) + "\n"
    return head.encode(), "".join(lines).encode(), rows // BLOCK, "".join(lines[: rows % BLOCK]).encode(), b""


def chunk(text):
    return f"{len(text):x}\r\n".encode() + text + b"\r\n" if text else b""


def ask(port, path, form, body):
    """Sends a body and takes the answer; the bytes of it, and its end."""
    head, one, times, rest, end = body
    connection = http.client.HTTPConnection("127.0.0.1", port)
    connection.connect()
    socket = connection.sock

    def send():
        socket.sendall(f"POST {path} HTTP/1.1\r\nHost: a\r\nContent-Type: {form}\r\nTransfer-Encoding: chunked\r\n\r\n".encode())
        socket.sendall(chunk(head))
        for _ in range(times):
            socket.sendall(chunk(one))
        socket.sendall(chunk(rest) + chunk(end) + b"0\r\n\r\n")

    sender = threading.Thread(target=send)
    sender.start()
    response = http.client.HTTPResponse(socket, method="POST")
    response.begin()
    taken, last = 0, b""
    while piece := response.read1(1 << 20):
        taken += len(piece)
        last = (last + piece)[-200:]
    sender.join()
    assert response.status == 200, last
    connection.close()
    return taken, last


def figure(pid, name):
    return int(re.search(rf"{name}:\s+(\d+)", Path(f"/proc/{pid}/status").read_text())[1])


def processor(pid):
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICK


def main():
    largest = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10_000_000
    server = subprocess.Popen([PROGRAM, "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        port = int(re.search(r"127\.0\.0\.1:(\d+)", server.stdout.readline())[1])
        fields = ["soil.cohesion_pa", "soil.friction_angle_rad", "wheel.radius_m", "slip"]
        runs = [
            ("explicit, Arrow", ARROW, fields + ["sinkage_m"], "method=explicit"),
            ("quadrature under a load, Arrow", ARROW, fields + ["normal_load_n"], ""),
            ("explicit, CSV", "text/csv", fields + ["sinkage_m"], "method=explicit"),
        ]
        print(f"{'':32}{'rows':>10} {'rows/s':>9} {'us/row':>7} {'server us/row':>14} {'most memory, MB':>16}")
        for label, form, columns, settings in runs:
            path = f"/v1/batch?wheel.width_m=0.1&soil.preset=letter-sand&{settings}"
            ask(port, path, form, bodies(50_000, form, columns))
            rows = 1000
            while rows <= largest:
                body = bodies(rows, form, columns)
                before, start = processor(server.pid), time.monotonic()
                _, last = ask(port, path, form, body)
                taken, spent = time.monotonic() - start, processor(server.pid) - before
                assert form == ARROW or last.endswith(f"#end,{rows}\n".encode()), last
                memory = figure(server.pid, "VmHWM") / 1000
                print(f"{label:32}{rows:>10} {rows / taken:>9.0f} {1e6 * taken / rows:>7.2f} {1e6 * spent / rows:>14.2f} {memory:>16.1f}")
                rows *= 10
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
