# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""What tests share that drive a window by xdotool."""
import subprocess
import time

LONGEST_WAIT = 60  # seconds, for a machine that is busy


class Failed(Exception):
    pass


def check(condition: bool, what: str) -> None:
    if not condition:
        raise Failed(what)


def wait_for(answer, what: str):
    """Returns the first true answer."""
    deadline = time.monotonic() + LONGEST_WAIT
    while time.monotonic() < deadline:
        if value := answer():
            return value
        time.sleep(0.05)
    raise Failed(f"{what}: not within {LONGEST_WAIT} s")


def send(*words) -> None:
    subprocess.run(["xdotool", *map(str, words)], check=True, stdout=subprocess.DEVNULL)
