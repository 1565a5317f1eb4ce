#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Starts `TOOLCOMP view PROGRAM --serve` and behaves toward it as browsers, other sites and bad clients do; JSON."""

import http.client
import json
import re
import signal
import socket
import subprocess
import sys
import time

toolcomp, program, stop = sys.argv[1:4]
result = {}
server = subprocess.Popen([toolcomp, "view", program, "--serve", "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
address = server.stdout.readline().strip()
port = int(re.fullmatch(r"http://127\.0\.0\.1:(\d+)/", address).group(1))


def ask(method="GET", path="/", host=None, body=None):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    connection.request(method, path, body=body, headers={"Host": host or f"127.0.0.1:{port}"})
    answer = connection.getresponse()
    return answer.status, answer.read().decode()


def raw(text):
    """What comes back for these bytes, as far as the server says anything."""
    with socket.create_connection(("127.0.0.1", port), timeout=20) as s:
        s.sendall(text)
        try:
            return s.recv(100).decode(errors="replace").split("\r\n")[0]
        except OSError:
            return "closed"


try:
    deadline = time.monotonic() + 60
    while "data-program" not in ask()[1] and time.monotonic() < deadline:
        time.sleep(0.1)
    result["page"] = ask()[0]
    result["localhost"] = ask(host=f"localhost:{port}")[0]
    result["other_host"] = ask(host="example.org")[0]
    result["other_port"] = ask(host="127.0.0.1:1")[0]
    result["post"] = ask("POST", body="x" * 100000)[0]
    result["head"] = ask("HEAD")[0]
    result["elsewhere"] = ask(path="/../../etc/passwd")[0]
    result["no_host"] = raw(b"GET / HTTP/1.1\r\n\r\n")
    result["no_http"] = raw(b"\x16\x03\x01 hello\r\n\r\n")
    result["long_header"] = raw(b"GET / HTTP/1.1\r\nX: " + b"a" * 100000 + b"\r\n\r\n")[:12]
    # More clients than it takes that say nothing, half a request, or never read their answer.
    idle = [socket.create_connection(("127.0.0.1", port)) for _ in range(100)]
    for s in idle[:40]:
        s.sendall(b"GET / HT")
    for s in idle[40:80]:
        s.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
    begun = time.monotonic()
    result["beside_idle"] = ask()[0]
    result["beside_idle_quick"] = time.monotonic() - begun < 8
    listeners = [socket.create_connection(("127.0.0.1", port)) for _ in range(50)]
    for s in listeners:
        s.sendall(f"GET /events HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
    result["beside_listeners"] = ask()[0]
    other = subprocess.run([toolcomp, "view", program, "--serve", "--port", str(port)], capture_output=True, text=True, timeout=60)
    result["taken"] = [other.returncode, other.stdout, other.stderr.count("\n"), str(port) in other.stderr]
    with open(f"/proc/net/tcp") as table:
        heard = [line.split()[1] for line in table if line.split()[3] == "0A"]
    result["heard_on"] = sorted({a.split(":")[0] for a in heard if int(a.split(":")[1], 16) == port} if heard else [])
finally:
    server.send_signal(getattr(signal, stop))
    begun = time.monotonic()
    result["status"] = server.wait(timeout=60)
    result["ends_quickly"] = time.monotonic() - begun < 10
    result["stderr"] = server.stderr.read()
print(json.dumps(result))
