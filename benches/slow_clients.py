#!/usr/bin/env python3
"""What slow clients cost: memory of the server, the wait of other clients, and when each kind is closed.

    cargo build --release && target/release/terramechanics & benches/slow_clients.py 127.0.0.1:8080 --pid $!

Opens --clients connections of one kind after the other, watches each kind for --seconds and asks /v1/forces and /healthz all
the while, each time on a new connection. Linux only. Everything comes from one address, so a server whose limit for one peer
is below its limit of connections shows the former. More than 20 s between the last byte sent and the close of a connection
can only be seen with more --seconds.
"""

import argparse
import heapq
import multiprocessing
import resource
import select
import socket
import time

WHEEL = b'"wheel":{"preset":"letter"},"soil":{"preset":"letter-sand"},"method":"explicit"'
FORCES = b"{" + WHEEL + b',"slip":0.2,"sinkage_m":0.02}'
SWEEP = b"{" + WHEEL + b',"sinkage_m":0.02,"slip":{"from":0,"to":1,"points":10001}}'
TRACK = "/v1/track?wheel.preset=letter&soil.preset=letter-sand&static_sinkage_m=0.02&method=explicit"


def get(path):
    return f"GET {path} HTTP/1.1\r\nHost: test\r\n\r\n".encode()


def post(path, body, length=None, media_type="application/json"):
    length = len(body) if length is None else length
    head = f"POST {path} HTTP/1.1\r\nHost: test\r\nContent-Type: {media_type}\r\nContent-Length: {length}\r\n\r\n"
    return head.encode() + body


# What is sent at once; seconds between two clients; seconds between two bytes sent after it; seconds between two bytes read.
SHAPES = {
    "silent": (b"", 0, None, None),
    "partial head": (b"GET /healthz HTTP/1.1\r\nHost: te", 0, None, None),
    "dripping head": (b"GET /healthz HTTP/1.1\r\nHost: te", 0, 1, None),
    "silent body": (post("/v1/forces", b"", 100_000), 0, None, None),
    "dripping body": (post("/v1/forces", b" ", 100_000), 0, 1, None),
    "most of a body": (post("/v1/forces", b" " * 1_000_000, 1_000_001), 0, None, None),
    "reads nothing of 3 MB": (post("/v1/slip-sweep", SWEEP), 0.01, None, None),
    "reads a byte in 5 s": (post("/v1/slip-sweep", SWEEP), 0.01, None, 5),
    "pipelines, reads nothing": (get("/v1/wheels/letter") * 2000, 0, None, None),
    "stream of a byte in 25 s": (post(TRACK, b"time_s,slip\n0,0.1\n", 1_000_000, "text/csv"), 0, 25, None),
}


def memory(pid):
    with open(f"/proc/{pid}/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS"))


def probe(address, until, results):
    """Asks both paths in turn and hands over the seconds that each answer took, and what failed."""
    taken, failed, turn = {"/healthz": [], "/v1/forces": []}, [], 0
    while time.monotonic() < until:
        path, message = [("/healthz", get("/healthz")), ("/v1/forces", post("/v1/forces", FORCES))][turn % 2]
        turn += 1
        start = time.monotonic()
        try:
            with socket.create_connection(address, timeout=10) as connection:
                connection.sendall(message)
                answer = connection.recv(4096)
            if not answer.startswith(b"HTTP/1.1 200"):
                failed.append(f"{path}: {answer[:30]!r}")
        except OSError as error:
            failed.append(f"{path}: {error}")
        taken[path].append(time.monotonic() - start)
        time.sleep(0.02)
    results.put((taken, failed))


class Clients:
    """Connections of one kind, by their file descriptors."""

    def __init__(self, address, shape, count, end, look):
        self.first, pause, self.every_send, self.every_read = shape
        self.epoll = select.epoll()
        self.open, self.closed, self.due, self.rest, self.most = {}, [], [], {}, 0
        for _ in range(count):
            if time.monotonic() > end:
                break
            try:
                client = socket.create_connection(address, timeout=1)
            except OSError:
                continue
            client.setblocking(False)
            self.open[client.fileno()] = client, time.monotonic()
            # Without EPOLLIN: a close is seen although nothing is read.
            self.epoll.register(client.fileno(), select.EPOLLRDHUP)
            self.rest[client.fileno()] = self.first
            heapq.heappush(self.due, (time.monotonic(), client.fileno(), "first"))
            if self.every_send:
                heapq.heappush(self.due, (time.monotonic() + self.every_send, client.fileno(), "send"))
            if self.every_read:
                heapq.heappush(self.due, (time.monotonic() + self.every_read, client.fileno(), "read"))
            self.turn(pause)
            self.most = max(self.most, len(self.open))
            look()

    def turn(self, patience):
        """Sends and reads what is due, and notes what was closed."""
        while self.due and self.due[0][0] <= time.monotonic():
            at, number, what = heapq.heappop(self.due)
            if number not in self.open:
                continue
            client, _ = self.open[number]
            try:
                if what == "first":
                    self.rest[number] = self.rest[number][client.send(self.rest[number]) :] if self.rest[number] else b""
                    if self.rest[number]:
                        heapq.heappush(self.due, (time.monotonic() + 0.2, number, "first"))
                elif what == "send":
                    client.send(b" ")
                    heapq.heappush(self.due, (at + self.every_send, number, "send"))
                else:
                    client.recv(1)
                    heapq.heappush(self.due, (at + self.every_read, number, "read"))
            except BlockingIOError:
                heapq.heappush(self.due, (time.monotonic() + 0.5, number, what))
            except OSError:
                self.close(number)
        for number, _ in self.epoll.poll(patience):
            self.close(number)

    def close(self, number):
        if number in self.open:
            client, opened = self.open.pop(number)
            self.closed.append(time.monotonic() - opened)
            client.close()

    def end(self):
        for client, _ in self.open.values():
            client.close()
        self.epoll.close()


def ranked(seconds, share):
    """The value below which this share of the values lies (ms)."""
    return sorted(seconds)[min(int(share * len(seconds)), len(seconds) - 1)] * 1e3


def run(name, address, pid, count, seconds):
    results = multiprocessing.Queue()
    prober = multiprocessing.Process(target=probe, args=(address, time.monotonic() + seconds, results))
    prober.start()
    end, before, peak = time.monotonic() + seconds, memory(pid), 0

    def look():
        nonlocal peak
        peak = max(peak, memory(pid))

    clients = Clients(address, SHAPES[name], count, end, look)
    while time.monotonic() < end:
        clients.turn(0.05)
        look()
    taken, failed = results.get(timeout=30)
    prober.join()
    left, closed = len(clients.open), sorted(clients.closed)
    clients.end()
    waits = "  ".join(f"{path} {ranked(times, 0.99):.1f} ms, {ranked(times, 1):.0f} ms" for path, times in taken.items() if times)
    when = f"{len(closed)} closed after {closed[0]:.1f} to {closed[-1]:.1f} s, median {ranked(closed, 0.5) / 1e3:.1f} s" if closed else "none closed"
    print(
        f"{name}: memory {before / 1024:.0f} -> {peak / 1024:.0f} MB; p99 and longest of {sum(map(len, taken.values()))} others, "
        f"{len(failed)} failed: {waits}; at most {clients.most} open, {when}, {left} left",
        flush=True,
    )
    for line in sorted(set(failed))[:3]:
        print("    ", line)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("address", help="IP:PORT of a running server")
    parser.add_argument("--pid", type=int, required=True, help="its process, for its memory")
    parser.add_argument("--clients", type=int, default=2000)
    parser.add_argument("--seconds", type=float, default=20, help="for which each kind is watched")
    parser.add_argument("--only", help="kinds whose name contains this")
    asked = parser.parse_args()
    host, port = asked.address.rsplit(":", 1)
    _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
    count = min(asked.clients, hard - 100)
    print(f"{count} clients of each kind")
    for name in SHAPES:
        if asked.only is None or asked.only in name:
            run(name, (host, int(port)), asked.pid, count, asked.seconds)
            time.sleep(1)


if __name__ == "__main__":
    main()
