#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Judges the library on several OpenGL drivers.

Results lie in BUILD/drivers/DRIVER: a folder for each platform and API of glark-conformance, faults.txt, clients.json and
piglit.txt. A step that has run replaces its results; the table is made of all that lies there.
"""
import argparse
import contextlib
import dataclasses
import fnmatch
import glob
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import table

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
PLATFORMS = {"egl": ("gl-compat", "gl-core", "gles"), "glx": ("gl-compat", "gl-core", "gles"), "osmesa": ("gl-compat", "gl-core")}
STEPS = ("faults", "conformance", "clients", "piglit")
CASES_A_PROCESS = "40"
CASE_SECONDS = "300"
ANGLE = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "glark/angle"
SOCKET = pathlib.Path("/tmp/.virgl_test")  # Mesa 22 loses the connection at any other path
# Client -> options of tests/clients/run_client.py, program. "@" stands for the folder of our clients.
CLIENTS = {
    "egl_surfaceless": ("--mode", "@client_egl_surfaceless"),
    "egl_impostors": ("--mode", "@client_egl_impostors"),
    "gles2": ("--mode", "@client_gles2"),
    "immediate": ("--display --mode", "@client_immediate"),
    "glxdemo": ("--screen --mode", "glxdemo"),
    "osgshape": ("--screen --mode", "osgshape"),
}
# Mode of run_client.py -> its name in the table. Curved triangles change the pictures of all clients but the first.
MODES = {"passthrough": "off", "refined": "outputs", "curved": "pn"}
WITHOUT_SURFACE = ("egl_impostors",)


@dataclasses.dataclass
class Driver:
    name: str                # of its folder
    says: str                # a word of GL_RENDERER
    environment: dict
    platforms: tuple = ("egl", "glx")
    needs: str = ""          # a file, as a pattern, or a program
    package: str = ""        # which has it
    server: str = ""         # a program that runs beside
    passes_through: bool = False
    clients: tuple = tuple(CLIENTS)
    told: str = "client_immediate"  # the program that the log is about, if nothing is refined
    avoids: str = ""         # words of GL_RENDERER, as a pattern: another row has this driver


def gallium(name: str) -> dict:
    return {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": name}


DRIVERS = [
    Driver("llvmpipe", "llvmpipe", gallium("llvmpipe"), platforms=("egl", "glx", "osmesa")),
    Driver("zink", "zink", gallium("zink"), needs="/usr/share/vulkan/icd.d/lvp_icd*.json", package="mesa-vulkan-drivers"),
    Driver("virpipe", "virgl", gallium("virpipe"), needs="virgl_test_server", package="virgl-server", server="virgl_test_server"),
    Driver("softpipe", "softpipe", gallium("softpipe"), passes_through=True),
    Driver("angle", "ANGLE", {"LD_LIBRARY_PATH": str(ANGLE), "ANGLE_DEFAULT_PLATFORM": "swiftshader"}, platforms=("egl",),
           needs=str(ANGLE / "libEGL.so.1"), package="@sparticuz/chromium of npm", passes_through=True, clients=("gles2",),
           told="client_gles2"),
    # The driver of the graphics card. GLX runs on the user's display, because Xvfb would draw with Mesa.
    Driver(table.SYSTEM, "", {"LIBGL_ALWAYS_SOFTWARE": "0"}, platforms=("egl", "glx") if "DISPLAY" in os.environ else ("egl",),
           clients=("egl_surfaceless", "egl_impostors", "gles2"), avoids="llvmpipe|softpipe|swrast|zink|virgl"),
]


class Judge:
    def __init__(self, options: argparse.Namespace, driver: Driver) -> None:
        self.options_, self.driver_ = options, driver
        self.build_ = options.build.resolve()
        self.folder_ = self.build_ / "drivers" / driver.name
        self.folder_.mkdir(parents=True, exist_ok=True)
        self.environment_ = {name: value for name, value in os.environ.items() if not name.startswith("GLARK_")}
        self.environment_ |= driver.environment

    def obstacle(self) -> str:
        """Says why the driver cannot run here; empty if it can."""
        needs = self.driver_.needs
        if needs and not glob.glob(needs) and not shutil.which(needs):
            return f"the package {self.driver_.package} is not installed"
        with self.server():
            done = self.run([self.build_ / "bin/driver_faults"])
        renderer = done.stdout.split("\n")[0]
        if self.driver_.avoids and re.search(self.driver_.avoids, renderer):
            return "the system has only Mesa's software renderers"
        return "" if self.driver_.says in renderer else f"Mesa runs another driver ({renderer or done.stderr.strip()[-80:]})"

    @contextlib.contextmanager
    def server(self):
        """Runs the program beside which the driver needs."""
        if not self.driver_.server:
            yield
            return
        SOCKET.unlink(missing_ok=True)
        environment = {name: value for name, value in os.environ.items() if name != "GALLIUM_DRIVER"}
        program = subprocess.Popen([self.driver_.server, "--use-egl-surfaceless"], env=environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            while not SOCKET.exists() and program.poll() is None:
                time.sleep(0.05)
            yield
        finally:
            program.terminate()
            program.wait()

    def run(self, command: list, seconds: float = 3600) -> subprocess.CompletedProcess:
        return subprocess.run([str(word) for word in command], env=self.environment_, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=seconds)

    def faults(self) -> None:
        (self.folder_ / "faults.txt").write_text(self.run([self.build_ / "bin/driver_faults"]).stdout)

    def conformance(self) -> None:
        for platform in () if self.driver_.passes_through else self.driver_.platforms:
            for api in PLATFORMS[platform]:
                if not fnmatch.fnmatchcase(f"{platform}-{api}", self.options_.platform):
                    continue
                of_its_own = platform == "glx" and self.driver_.name != table.SYSTEM
                display = [ROOT / "scripts/parts/with_display", "--"] if of_its_own else []
                report = self.folder_ / f"{platform}-{api}"
                (report / "results.json").unlink(missing_ok=True)
                done = self.run([*display, self.build_ / "bin/glark-conformance", "--implementation", self.library(), "--platform",
                                 platform, "--api", api, "--report", report, "--batch", CASES_A_PROCESS, "--timeout", CASE_SECONDS,
                                 "--shard", self.options_.part])
                last = (done.stdout.strip() or done.stderr.strip()).split("\n")[-1]
                print(f"{self.driver_.name:<9} {platform}-{api}: {last}", flush=True)

    def clients(self) -> None:
        verdicts = {}
        for name in self.driver_.clients:
            options, program = CLIENTS[name]
            for mode, short in MODES.items():
                if mode == "curved" and name not in WITHOUT_SURFACE:
                    continue
                if mode != "passthrough" and self.driver_.passes_through:
                    continue
                program = program.replace("@", str(self.build_ / "bin") + "/")
                done = self.run([sys.executable, ROOT / "tests/clients/run_client.py", "--library", self.library(), *options.split(),
                                 mode, "--", program])
                said = done.stderr.strip().split("\n")[-1].removeprefix("run_client: ")
                verdicts[f"{name} {short}"] = "" if done.returncode == 0 else said[:160]
                print(f"{self.driver_.name:<9} {name} {short}: {verdicts[f'{name} {short}'] or 'good'}", flush=True)
        if self.driver_.passes_through:
            verdicts["one line says why nothing is refined"] = self.log_complaint()
        (self.folder_ / "clients.json").write_text(json.dumps(verdicts, indent=1))

    def log_complaint(self) -> str:
        """Runs a program refined. A driver that lacks features passes through, and one line of the log says so."""
        with tempfile.TemporaryDirectory() as folder:
            settings = [f"LD_PRELOAD={self.library()}", "GLARK_ENABLE=1", "GLARK_WAIT=1", "GLARK_CONFIG=/dev/null"]
            done = self.run([ROOT / "scripts/parts/with_display", "--", "env", *settings, self.build_ / "bin" / self.driver_.told, "3", f"{folder}/picture.ppm"])
        lines = [line for line in done.stderr.split("\n") if line.startswith("glark:")]
        return "" if done.returncode == 0 and len(lines) == 1 else f"status {done.returncode}, {len(lines)} lines: {done.stderr[:100]}"

    def piglit(self) -> None:
        if self.driver_.passes_through:
            return
        done = self.run([sys.executable, ROOT / "tests/piglit/run.py", "--build", self.build_, "--results", self.folder_ / "piglit",
                         "--part", self.options_.piglit, "--modes", "off,outputs-2"])
        (self.folder_ / "piglit.txt").write_text(done.stdout + done.stderr)
        print(f"{self.driver_.name:<9} piglit: status {done.returncode}", flush=True)

    def library(self) -> pathlib.Path:
        return self.build_ / "lib/libGLARK.so"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build folder, with lib/libGLARK.so")
    parser.add_argument("--only", default="*", metavar="GLOB", help="only drivers such as " + ", ".join(d.name for d in DRIVERS))
    parser.add_argument("--platform", default="*", metavar="GLOB", help="conformance only on platforms and APIs such as egl-gles")
    parser.add_argument("--steps", default=",".join(STEPS), help="comma separated, of: " + ", ".join(STEPS))
    parser.add_argument("--part", default="1/1", metavar="I/N", help="the I-th of N parts of the conformance cases")
    parser.add_argument("--piglit", default="1/20", metavar="I/N", help="the I-th of N parts of piglit")
    parser.add_argument("--table", action="append", type=pathlib.Path, default=[], metavar="BUILD", help="runs nothing; prints the table "
                        "of the results in these build folders")
    parser.add_argument("--write", action="store_true", help="with --table: writes it into docs/reference/drivers.md")
    options = parser.parse_args()
    if options.table:
        return table.make([folder / "drivers" for folder in options.table], ROOT / "docs/reference/drivers.md", options.write)
    for driver in DRIVERS:
        if not fnmatch.fnmatchcase(driver.name, options.only):
            continue
        judge = Judge(options, driver)
        obstacle = judge.obstacle()
        if obstacle:
            print(f"{driver.name:<9} cannot run: {obstacle}", flush=True)
            if driver.name == table.SYSTEM:  # no row: it is a driver of its own only where there is a graphics card
                with contextlib.suppress(OSError):
                    judge.folder_.rmdir()
            else:
                (judge.folder_ / "faults.txt").write_text(f"cannot run: {obstacle}\n")
            continue
        with judge.server():
            for step in options.steps.split(","):
                getattr(judge, step)()
    return 0


sys.exit(main())
